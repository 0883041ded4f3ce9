//! All that is asked of links together, at all times of a motion.

use super::beforehand::Beforehand;
use super::layer::{Layer, Placed};
use crate::read::apart::{Nudge, Nudged};
use solaris_model::Figure;

/// The positions of a figure at some times, with all that is asked of it.
pub(super) struct Layers<'a> {
    figure: &'a Figure,
    beforehand: &'a Beforehand,
    times: &'a [f64],
    layers: Vec<Layer<'a>>,
    placed: Placed,
    /// Nothing, where they are to be found anew.
    positions: Vec<Vec<f64>>,
}

impl<'a> Layers<'a> {
    pub(super) fn new(
        figure: &'a Figure,
        beforehand: &'a Beforehand,
        times: &'a [f64],
        layers: Vec<Layer<'a>>,
        placed: Placed,
    ) -> Self {
        Self { figure, beforehand, times, layers, placed, positions: Vec::new() }
    }

    /// The positions that were found last, and what found them.
    pub(super) fn finish(self) -> (Vec<Vec<f64>>, Vec<Layer<'a>>) {
        (self.positions, self.layers)
    }

    /// What is at work at a frame and moves one of these degrees of freedom.
    fn at_work(&self, frame: usize, dofs: &[usize]) -> impl Iterator<Item = usize> {
        let time = self.times[frame];
        (0..self.layers.len()).filter(move |i| {
            let layer = &self.layers[*i];
            layer.share_at(time) > 0.0 && layer.moves().any(|(dof, ..)| dofs.contains(&dof))
        })
    }
}

impl Nudged for Layers<'_> {
    fn positions(&mut self) -> Result<&[Vec<f64>], String> {
        if self.positions.is_empty() {
            self.layers.iter_mut().for_each(Layer::rewind);
            for time in self.times {
                let mut q = self.beforehand.positions(self.figure, *time);
                for layer in &mut self.layers {
                    layer.apply(&mut q, *time, &mut self.placed)?;
                }
                self.positions.push(q);
            }
        }
        Ok(&self.positions)
    }

    fn wanted(&self, frame: usize, dofs: &[usize]) -> f64 {
        self.at_work(frame, dofs).map(|i| self.layers[i].asked.clearance).fold(0.0, f64::max)
    }

    fn otherwise(&self, frame: usize) -> Option<Vec<f64>> {
        Some(self.beforehand.positions(self.figure, self.times[frame]))
    }

    fn span(&self, frame: usize, dofs: &[usize]) -> (Option<f64>, f64) {
        let Some(first) = self.at_work(frame, dofs).next() else { return (None, f64::INFINITY) };
        let asked = self.layers[first].asked;
        ((asked.over > 0.0).then_some(asked.from), asked.until + asked.back)
    }

    fn nudge(
        &mut self,
        frame: usize,
        slopes: &[(usize, f64)],
        by: f64,
        nudge: Nudge,
    ) -> Result<bool, String> {
        let dofs: Vec<usize> = slopes.iter().map(|(dof, _)| *dof).collect();
        let at_work: Vec<usize> = self.at_work(frame, &dofs).collect();
        for i in at_work {
            let at = (&*self.positions[frame], self.times[frame]);
            if self.layers[i].nudge(at, slopes, by, nudge.clone())? {
                self.positions.clear();
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn take_back(&mut self, pair: usize) {
        self.layers.iter_mut().for_each(|layer| layer.take_back(pair));
        self.positions.clear();
    }
}
