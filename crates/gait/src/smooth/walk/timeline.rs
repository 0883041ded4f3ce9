//! The nodes of a walk.

use super::laws::WalkLaws;
use super::numbers::REST;
use crate::grid::{Ends, Grid, SECOND};

/// Nodes that are equally spaced in time.
pub(super) struct Timeline {
    pub(super) grid: Grid,
    /// Nodes a stride of the fastest pace, and the first node's number.
    pub(super) rate: usize,
    first: isize,
    pub(super) moving: (usize, usize),
    /// Clocks of the nodes, and of three more on either side.
    clocks: Vec<f64>,
}

impl Timeline {
    pub(super) fn new(laws: &WalkLaws, rate: usize) -> Self {
        let (n, tempo) = (rate as f64, &laws.gaits.tempo);
        let (begin, end) = (tempo.time(laws.course.begin), tempo.time(laws.course.end));
        let first = ((begin - REST) * n).floor() as isize;
        let last = ((end + REST) * n).ceil() as isize;
        let step = laws.gaits.stride_time / n;
        let grid = Grid { count: (last - first + 1) as usize, step, ends: Ends::Resting };
        let node = |time: f64| ((time * n).round() as isize - first) as usize;
        let clocks = (first - 3..=last + 3).map(|i| tempo.clock(i as f64 / n)).collect();
        Self { grid, rate, first, moving: (node(begin), node(end)), clocks }
    }

    /// Time of the first node, in strides of the fastest pace.
    pub(super) fn start(&self) -> f64 {
        self.first as f64 / self.rate as f64
    }

    /// Clocks of all nodes.
    pub(super) fn clocks(&self) -> &[f64] {
        &self.clocks[3..3 + self.grid.count]
    }

    pub(super) fn clock(&self, node: usize) -> f64 {
        self.clocks[node + 3]
    }

    /// The nodes between two clocks, with their clocks.
    pub(super) fn between(&self, from: f64, to: f64) -> impl Iterator<Item = (usize, f64)> {
        let inner = self.clocks();
        let first = inner.partition_point(|&u| u <= from);
        let end = inner.partition_point(|&u| u <= to - 1e-6 / self.rate as f64);
        (first..end).map(|node| (node, self.clock(node)))
    }

    /// The clock of value `k` of the seven about a node.
    pub(super) fn neighbour(&self, node: usize, k: usize) -> f64 {
        self.clocks[node + k]
    }

    /// A function of the clock at all nodes, and at three more on either side.
    pub(super) fn with_neighbours(&self, f: impl Fn(f64) -> f64) -> Vec<f64> {
        self.clocks.iter().map(|&u| f(u)).collect()
    }

    /// Second derivative in time from the seven values about a node.
    pub(super) fn second(&self, value: impl Fn(usize) -> f64) -> f64 {
        let unit = 1.0 / (180.0 * self.grid.step.powi(2));
        (0..7).map(|k| SECOND[k] * unit * value(k)).sum()
    }
}
