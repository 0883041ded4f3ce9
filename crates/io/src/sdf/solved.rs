//! Where everything stands.

use super::frames::{Anchor, Frames, Kind};
use crate::tree::product;
use crate::xml::Reader;
use solaris_model::Placement;
use std::ops::Range;

/// The places of all entities.
pub(super) struct Solved<'f> {
    frames: &'f Frames,
    /// Of each entity, in its scope's frame.
    places: Vec<Placement>,
    /// Of each entity, what its place is relative to, where that is one entity.
    bases: Vec<Option<usize>>,
    /// Of each scope, in the world.
    scopes: Vec<Placement>,
}

/// How far the place of an entity is known.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Unknown,
    Begun,
    Known,
}

/// What the place of an entity depends on: what it is relative to, and the frame in it that is placed.
struct Needs {
    base: Vec<usize>,
    placed: Vec<usize>,
}

impl<'f> Solved<'f> {
    /// The places; frames that are relative to each other are a fault. `spans` says where each entity stands in the text.
    pub(super) fn of(reader: &mut Reader, frames: &'f Frames, spans: &[Range<usize>]) -> Self {
        let count = frames.entities.len();
        let needs: Vec<Needs> = (0..count).map(|entity| needs(reader, frames, entity)).collect();
        let mut places = vec![Placement::identity(); count];
        let mut states = vec![State::Unknown; count];
        for start in 0..count {
            let mut open = vec![start];
            while let Some(&entity) = open.last() {
                let Needs { base, placed } = &needs[entity];
                let next = base.iter().chain(placed).copied().find(|need| states[*need] != State::Known);
                match next.filter(|_| states[entity] != State::Known) {
                    Some(next) if states[next] == State::Begun || next == entity => {
                        let name = frames.name(next);
                        let message = format!(
                            "the place of '{name}' depends on itself, by way of what it is relative to"
                        );
                        reader.fault(spans[next].clone(), message);
                        // Said once.
                        for entity in open.drain(..) {
                            states[entity] = State::Known;
                        }
                    }
                    Some(next) => {
                        states[entity] = State::Begun;
                        open.push(next);
                    }
                    None => {
                        let all = |path: &[usize]| {
                            path.iter()
                                .fold(Placement::identity(), |at, entity| product(&at, &places[*entity]))
                        };
                        let at = product(&all(base), &frames.entities[entity].place);
                        places[entity] = if placed.is_empty() { at } else { at * all(placed).inverse() };
                        states[entity] = State::Known;
                        open.pop();
                    }
                }
            }
        }
        // A model comes before all that is in it.
        let mut scopes = vec![Placement::identity(); frames.scopes.len()];
        for (scope, own) in frames.scopes.iter().enumerate() {
            if let Some(model) = own.model {
                scopes[scope] = product(&scopes[frames.entities[model].scope], &places[model]);
            }
        }
        let single = |needs: &Needs| match needs.base[..] {
            [base] if needs.placed.is_empty() => Some(base),
            _ => None,
        };
        Self { frames, places, bases: needs.iter().map(single).collect(), scopes }
    }

    /// Where `to` stands in the frame of `from`; to the bit where one is placed in the other.
    pub(super) fn between(&self, from: Option<usize>, to: usize) -> Placement {
        let entity = |index: usize| &self.frames.entities[index];
        let Some(from) = from else { return self.in_world(to) };
        if from == to {
            Placement::identity()
        } else if self.bases[to] == Some(from) {
            entity(to).place
        } else if self.bases[from] == Some(to) {
            inverse(&entity(from).place)
        } else if entity(from).scope == entity(to).scope {
            product(&inverse(&self.places[from]), &self.places[to])
        } else {
            product(&inverse(&self.in_world(from)), &self.in_world(to))
        }
    }

    /// Where an entity stands in the world.
    pub(super) fn in_world(&self, entity: usize) -> Placement {
        product(&self.scopes[self.frames.entities[entity].scope], &self.places[entity])
    }

    /// Where what an anchor of `scope` refers to stands in the world.
    pub(super) fn anchor(&self, reader: &mut Reader, scope: usize, anchor: &Anchor) -> Option<Placement> {
        let path = self.frames.path(reader, scope, anchor)?;
        Some(match path.last() {
            Some(&entity) => self.in_world(entity),
            None => self.scopes[scope],
        })
    }

    /// The frames.
    pub(super) fn frames(&self) -> &'f Frames {
        self.frames
    }
}

fn needs(reader: &mut Reader, frames: &Frames, entity: usize) -> Needs {
    let found = &frames.entities[entity];
    let base = frames.path(reader, found.scope, &found.relative_to).unwrap_or_default();
    let placed = match &found.kind {
        Kind::Model { scope, placed: Some(anchor) } => {
            frames.path(reader, *scope, anchor).unwrap_or_default()
        }
        _ => Vec::new(),
    };
    Needs { base, placed }
}

fn inverse(place: &Placement) -> Placement {
    if *place == Placement::identity() { *place } else { place.inverse() }
}
