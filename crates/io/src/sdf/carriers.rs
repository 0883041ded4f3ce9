//! What each frame is attached to.

use super::frames::{Anchor, Frames, Kind};
use crate::xml::Reader;
use std::ops::Range;

/// What a frame is attached to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Carrier {
    World,
    /// The link of this number.
    Link(usize),
}

/// What every entity and every scope's own frame is attached to.
pub(super) struct Carriers {
    /// Entities, then scopes; none for what leads nowhere.
    all: Vec<Option<Carrier>>,
}

/// The next on the way from a frame to what carries it.
#[derive(Clone, Copy)]
enum Step {
    Done(Option<Carrier>),
    /// An entity, or a scope's own frame.
    To(usize),
}

impl Carriers {
    /// Of all frames; those that are attached to each other are a fault. `spans` says where each entity stands in the text.
    pub(super) fn of(reader: &mut Reader, frames: &Frames, spans: &[Range<usize>]) -> Self {
        let entities = frames.entities.len();
        let count = entities + frames.scopes.len();
        let steps: Vec<Step> = (0..count).map(|at| step(reader, frames, at)).collect();
        let mut all: Vec<Option<Carrier>> = vec![None; count];
        // Which walk came by: its number, from 1.
        let mut walks = vec![0; count];
        for start in 0..count {
            let (mut at, mut way) = (start, Vec::<usize>::new());
            let found = loop {
                if walks[at] == start + 1 {
                    let entity = way.iter().copied().find(|at| *at < entities);
                    let message = "the frames that this is attached to are attached to each other (a cycle)";
                    reader.fault(entity.map_or(0..0, |entity| spans[entity].clone()), message);
                    break None;
                }
                if walks[at] > 0 {
                    break all[at];
                }
                walks[at] = start + 1;
                way.push(at);
                match steps[at] {
                    Step::Done(carrier) => break carrier,
                    Step::To(next) => at = next,
                }
            };
            for at in way {
                all[at] = found;
            }
        }
        Self { all }
    }

    /// Of an entity.
    pub(super) fn entity(&self, entity: usize) -> Option<Carrier> {
        self.all[entity]
    }

    /// Of what an anchor of `scope` refers to; a name that is none is a fault.
    pub(super) fn anchor(
        &self,
        reader: &mut Reader,
        frames: &Frames,
        scope: usize,
        anchor: &Anchor,
    ) -> Option<Carrier> {
        match to(reader, frames, scope, anchor) {
            Step::Done(carrier) => carrier,
            Step::To(at) => self.all[at],
        }
    }
}

fn step(reader: &mut Reader, frames: &Frames, at: usize) -> Step {
    let Some(entity) = frames.entities.get(at) else {
        let scope = at - frames.entities.len();
        if scope == 0 || frames.scopes[scope].is_static {
            return Step::Done(Some(Carrier::World));
        }
        let canonical = frames.canonical(scope);
        return canonical.map_or(Step::Done(None), |anchor| to(reader, frames, scope, &anchor));
    };
    match &entity.kind {
        Kind::Link(_) if frames.is_static(entity.scope) => Step::Done(Some(Carrier::World)),
        Kind::Link(link) => Step::Done(Some(Carrier::Link(*link))),
        Kind::Joint { child } => to(reader, frames, entity.scope, child),
        Kind::Frame { attached_to } => to(reader, frames, entity.scope, attached_to),
        Kind::Model { scope, .. } => Step::To(frames.entities.len() + scope),
    }
}

/// The frame that an anchor of `scope` refers to.
fn to(reader: &mut Reader, frames: &Frames, scope: usize, anchor: &Anchor) -> Step {
    if matches!(anchor, Anchor::Named(name, _) if name == "world" && frames.find(scope, name).is_none()) {
        return Step::Done(Some(Carrier::World));
    }
    match frames.path(reader, scope, anchor) {
        None => Step::Done(None),
        Some(path) => Step::To(path.last().copied().unwrap_or(frames.entities.len() + scope)),
    }
}
