//! Frames of a model of version 4: ground, bodies, and what stands at an offset to them.

use super::axes::product;
use super::component::{path_of, resolved};
use super::element::{child_words, offset, words_at};
use super::station;
use crate::xml::{Node, Reader, element, elements, elements_called, tag};
use roxmltree::NodeId;
use solaris_model::{Placement, Vector3};
use std::collections::HashMap;

/// What frames are called.
pub(super) const OFFSET: &str = "PhysicalOffsetFrame";
pub(super) const THROUGH_POINTS: &str = "StationDefinedFrame";

/// The most frames through points that stand on each other.
const DEEPEST: usize = 50;

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
    /// By their elements.
    nodes: HashMap<NodeId, usize>,
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

/// What a socket is connected to as versions 30501 to 30516 write it: in `connectors`, under its name without `socket_` or
/// with `body` instead of `frame`, or with a longer name.
fn connector<'a>(holder: Node<'a>, socket: &str) -> Option<&'a str> {
    let name = socket.strip_prefix("socket_")?;
    let named = |node: &Node| {
        node.attribute("name").is_some_and(|told| told == name || told.replace("_body", "_frame") == name)
    };
    let longer = |prefix: &str| child_words(holder, &format!("{prefix}_{name}_connectee_name"));
    let listed = || {
        let connectors = elements_called(holder, "connectors").flat_map(elements);
        connectors.filter(named).find_map(|node| child_words(node, "connectee_name"))
    };
    longer("socket").or_else(|| longer("connector")).or_else(listed)
}

impl<'a> Frames<'a> {
    /// The frames of a model whose bodies are these elements.
    pub(super) fn of(model: Node<'a>, bodies: &[Node<'a>]) -> Self {
        let (paths, names, nodes) = (HashMap::new(), HashMap::new(), HashMap::new());
        let mut frames = Self { list: Vec::new(), paths, names, nodes };
        let at = |body| State::At(Anchor { body, within: Placement::identity() });
        let body_at: HashMap<_, usize> = bodies.iter().enumerate().map(|(i, node)| (node.id(), i)).collect();
        for node in model.descendants() {
            let state = match node.tag_name().name() {
                "Ground" if node.parent() == Some(model) => at(None),
                "Body" => body_at.get(&node.id()).map_or(State::Lost, |&i| at(Some(i))),
                OFFSET | THROUGH_POINTS => State::Unknown,
                // Only in full paths: their names are often those of bodies.
                "Station" | "Marker" => {
                    let path = path_of(node, model);
                    frames.paths.entry(path.clone()).or_insert(frames.list.len());
                    frames.list.push(Frame { node, path, state: State::Unknown });
                    continue;
                }
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
        self.nodes.entry(frame.node.id()).or_insert(index);
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
        self.place(reader, index, 0)
    }

    /// Where the frame stands that this element is; nothing where it is none or cannot be found, which is a fault.
    pub(super) fn at(&mut self, reader: &mut Reader, node: Node) -> Option<Anchor> {
        let index = *self.nodes.get(&node.id())?;
        self.place(reader, index, 0)
    }

    /// Whether the element says what its socket `socket` is connected to.
    pub(super) fn is_connected(holder: Node, socket: &str) -> bool {
        child_words(holder, socket).or_else(|| connector(holder, socket)).is_some()
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
        let Some(told) = child_words(holder, socket).or_else(|| connector(holder, socket)) else {
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

    /// Where a frame through points stands, which is the `depth`-th such frame on the way.
    fn through(&mut self, reader: &mut Reader, index: usize, depth: usize) -> Option<Anchor> {
        let (node, path) = (self.list[index].node, self.list[index].path.clone());
        let owner = format!("frame '{path}'");
        if depth > DEEPEST {
            let message = format!("{owner} goes through points of more than {DEEPEST} such frames in a row");
            reader.fault(tag(node), message);
            return None;
        }
        let mut points = Vec::new();
        for socket in station::POINTS {
            let station = self.connected(reader, node, &path, socket, &owner)?;
            points.push(self.place(reader, station, depth)?);
        }
        let body = points[0].body;
        let places: Vec<Vector3<f64>> = points.iter().map(|point| point.within.translation.vector).collect();
        let frame = station::through(node, places.try_into().ok()?);
        let why = match frame {
            Some(within) if points.iter().all(|point| point.body == body) => {
                return Some(Anchor { body, within });
            }
            Some(_) => "its points belong to several bodies; they must be of one",
            None => "its points lie on a line, or its axes are not two of x, y, z",
        };
        reader.fault(tag(node), format!("{owner} cannot be found: {why}"));
        None
    }

    /// Where a frame stands, found over all that it stands on.
    fn place(&mut self, reader: &mut Reader, index: usize, depth: usize) -> Option<Anchor> {
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
            let frame = &self.list[next];
            let kind = frame.node.tag_name().name();
            if kind == THROUGH_POINTS {
                let found = self.through(reader, next, depth + 1);
                self.list[next].state = found.map_or(State::Lost, State::At);
                break found;
            }
            open.push(next);
            let owner = format!("frame '{}'", frame.path);
            let (node, path) = (frame.node, frame.path.clone());
            let socket = if kind == OFFSET { "socket_parent" } else { "socket_parent_frame" };
            match self.connected(reader, node, &path, socket, &owner) {
                Some(parent) => next = parent,
                None => break None,
            }
        };
        for index in open.into_iter().rev() {
            let node = self.list[index].node;
            let by = if node.tag_name().name() == OFFSET { "translation" } else { "location" };
            let offset = offset(reader, node, by, "orientation");
            anchor = anchor.map(|below| Anchor { body: below.body, within: product(&below.within, &offset) });
            self.list[index].state = anchor.map_or(State::Lost, State::At);
        }
        anchor
    }
}
