//! A clip that is played over a walk.

use solaris_modes::RecordedMotion;
use std::sync::Arc;

/// A part of a recorded motion: some of its coordinates, once from its beginning to its end.
#[derive(Clone)]
pub(super) struct Playing {
    /// Which it is among all there were.
    pub(super) id: usize,
    motion: Arc<RecordedMotion>,
    /// Of those that it moves: which they are among those that can be told, and coordinate and degree of freedom.
    moves: Vec<(usize, usize, usize)>,
    time: f64,
}

impl Playing {
    pub(super) fn new(id: usize, motion: Arc<RecordedMotion>, moves: Vec<(usize, usize, usize)>) -> Self {
        Self { id, time: motion.span().0, motion, moves }
    }

    /// Goes on by `dt` (s); `false` once it is over.
    pub(super) fn step(&mut self, dt: f64) -> bool {
        self.time += dt;
        self.time <= self.motion.span().1
    }

    /// Where it has its coordinates: which of those that can be told, and the value.
    pub(super) fn values(&self) -> impl Iterator<Item = (usize, f64)> {
        let at = |(which, q, v): &(usize, usize, usize)| (*which, self.motion.at(*v, *q, self.time).position);
        self.moves.iter().map(at)
    }
}
