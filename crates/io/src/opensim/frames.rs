//! Frames of a model of version 4: ground, bodies, and what stands at an offset to them.

use super::axes::product;
use super::component::{path_of, resolved};
use super::element::{child_vector, child_words, placement, words_at};
use crate::xml::{Node, Reader, element, tag};
use solaris_model::Placement;
use std::collections::HashMap;

/// Where a frame stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    /// The body that it is fixed to, by its number; ground without.
    pub(super) body: Option<usize>,
    /// Where it stands in that body's frame.
    pub(super) within: Placement,
}

/// All frames, by their paths.
pub(super) struct Frames<'a> {
    list: Vec<Frame<'a>>,
    paths: HashMap<String, usize>,
    /// By the last name of their paths; nothing where several have it.
    names: HashMap<String, Option<usize>>,
}

struct Frame<'a> {
    node: Node<'a>,
    path: String,
    state: State,
}

/// What is known of where a frame stands.
#[derive(Clone, Copy)]
enum State {
    Unknown,
    /// Being found: who comes here again stands on itself.
    Open,
    Lost,
    At(Anchor),
}

impl<'a> Frames<'a> {
    /// The frames of a model whose bodies are these elements.
    pub(super) fn of(model: Node<'a>, bodies: &[Node<'a>]) -> Self {
        let mut frames = Self { list: Vec::new(), paths: HashMap::new(), names: HashMap::new() };
        let at = |body| State::At(Anchor { body, within: Placement::identity() });
        let body_at: HashMap<_, usize> = bodies.iter().enumerate().map(|(i, node)| (node.id(), i)).collect();
        for node in model.descendants() {
            let state = match node.tag_name().name() {
                "Ground" if node.parent() == Some(model) => at(None),
                "Body" => body_at.get(&node.id()).map_or(State::Lost, |&i| at(Some(i))),
                "PhysicalOffsetFrame" => State::Unknown,
                _ => continue,
            };
            frames.add(Frame { node, path: path_of(node, model), state });
        }
        if !frames.paths.contains_key("/ground") {
            frames.add(Frame { node: model, path: "/ground".to_owned(), state: at(None) });
        }
        frames
    }

    fn add(&mut self, frame: Frame<'a>) {
        let index = self.list.len();
        self.paths.entry(frame.path.clone()).or_insert(index);
        let name = frame.path.rsplit('/').next().unwrap_or_default().to_owned();
        self.names.entry(name).and_modify(|found| *found = None).or_insert(Some(index));
        self.list.push(frame);
    }

    /// Where the frame stands that the socket `socket` of `holder` (with the path `path`) names; `owner` is what messages
    /// call the holder. Nothing where there is none, which is a fault.
    pub(super) fn socket(
        &mut self,
        reader: &mut Reader,
        holder: Node,
        path: &str,
        socket: &str,
        owner: &str,
    ) -> Option<Anchor> {
        let index = self.connected(reader, holder, path, socket, owner)?;
        self.place(reader, index)
    }

    /// The frame that a socket names.
    fn connected(
        &self,
        reader: &mut Reader,
        holder: Node,
        path: &str,
        socket: &str,
        owner: &str,
    ) -> Option<usize> {
        let Some(told) = child_words(holder, socket) else {
            let place = element(holder, socket).map_or_else(|| tag(holder), tag);
            reader.fault(
                place,
                format!("{owner} has no <{socket}>; give it the path of a frame, such as /bodyset/NAME"),
            );
            return None;
        };
        let wanted = resolved(path, told);
        if let Some(&index) = self.paths.get(&wanted) {
            return Some(index);
        }
        // A path of another time, of which the name alone is right.
        let name = wanted.rsplit('/').next().unwrap_or_default();
        if let Some(Some(index)) = self.names.get(name) {
            return Some(*index);
        }
        let local = format!("{path}/");
        let near =
            self.list.iter().map(|frame| frame.path.as_str()).filter(|path| {
                path.starts_with("/bodyset/") || path.starts_with(&local) || *path == "/ground"
            });
        let hint = reader.hint(name, near.filter_map(|path| path.rsplit('/').next()));
        let span = element(holder, socket).map_or_else(|| tag(holder), |node| words_at(node));
        reader
            .fault(span, format!("{owner}: <{socket}> names '{told}', which is no body and no frame{hint}"));
        None
    }

    /// Where a frame stands, found over all that it stands on.
    fn place(&mut self, reader: &mut Reader, index: usize) -> Option<Anchor> {
        let mut open = Vec::new();
        let mut next = index;
        let mut anchor = loop {
            match self.list[next].state {
                State::At(anchor) => break Some(anchor),
                State::Lost => break None,
                State::Open => {
                    let frame = &self.list[next];
                    reader.fault(
                        tag(frame.node),
                        format!("frame '{}' stands on itself by its <socket_parent>", frame.path),
                    );
                    break None;
                }
                State::Unknown => {}
            }
            self.list[next].state = State::Open;
            open.push(next);
            let frame = &self.list[next];
            let owner = format!("frame '{}'", frame.path);
            let (node, path) = (frame.node, frame.path.clone());
            match self.connected(reader, node, &path, "socket_parent", &owner) {
                Some(parent) => next = parent,
                None => break None,
            }
        };
        for index in open.into_iter().rev() {
            let node = self.list[index].node;
            let (translation, orientation) =
                (child_vector(reader, node, "translation"), child_vector(reader, node, "orientation"));
            anchor = anchor.map(|below| Anchor {
                body: below.body,
                within: product(&below.within, &placement(translation, orientation)),
            });
            self.list[index].state = anchor.map_or(State::Lost, State::At);
        }
        anchor
    }
}
