//! All that is asked of links together, at all times of a motion.

use super::beforehand::Beforehand;
use super::layer::{Layer, Placed};
use crate::read::apart::{Nudge, Nudged};
use solaris_analysis::REACHED;
use solaris_model::Figure;
use std::ops::Range;

/// The acceleration (rad/s²) that keeping links apart may take of a joint, besides four times what it has without.
const SMOOTH: f64 = 100.0;

/// The positions of a figure at some times, with all that is asked of it.
pub(super) struct Layers<'a> {
    figure: &'a Figure,
    beforehand: &'a Beforehand,
    times: &'a [f64],
    all: Vec<Layer<'a>>,
    /// The coordinates that any of them moves.
    moved: Vec<usize>,
    placed: Placed,
    /// Nothing, where they are to be found anew.
    positions: Vec<Vec<f64>>,
    found: usize,
    /// What could not be found last, by index.
    pub(super) failed: Option<usize>,
    /// Of the motion without what is added, how far points are off (m, rad), and the greatest acceleration.
    plain: Option<(f64, f64)>,
}

impl<'a> Layers<'a> {
    pub(super) fn new(
        figure: &'a Figure,
        beforehand: &'a Beforehand,
        times: &'a [f64],
        all: Vec<Layer<'a>>,
        placed: Placed,
    ) -> Self {
        let mut moved: Vec<usize> =
            all.iter().flat_map(Layer::moves).map(|(_, coordinate, _)| coordinate).collect();
        moved.sort_unstable();
        moved.dedup();
        Self {
            figure,
            beforehand,
            times,
            all,
            moved,
            placed,
            positions: Vec::new(),
            found: 0,
            failed: None,
            plain: None,
        }
    }

    /// Where what is asked stands in the text.
    pub(super) fn place(&self, i: usize) -> Range<usize> {
        self.all[i].asked.place.clone()
    }

    /// The positions that were found last, and what found them.
    pub(super) fn finish(self) -> (Vec<Vec<f64>>, Vec<Layer<'a>>) {
        (self.positions, self.all)
    }

    /// How far points are off at most (m, rad), and the greatest acceleration that differences of positions tell of what is moved (rad/s²,
    /// m/s²).
    fn roughness(&mut self) -> Result<(f64, f64), String> {
        self.positions()?;
        let mut leap = 0.0_f64;
        for (q, t) in self.positions.windows(3).zip(self.times.windows(3)) {
            let (before, after) = (t[1] - t[0], t[2] - t[1]);
            for i in &self.moved {
                let change = ((q[2][*i] - q[1][*i]) / after - (q[1][*i] - q[0][*i]) / before)
                    / (0.5 * (before + after));
                leap = leap.max(change.abs());
            }
        }
        let off = self.all.iter().map(|layer| layer.worst.0).fold(0.0, f64::max);
        Ok((off, leap))
    }

    /// What is at work at a frame and moves one of these degrees of freedom.
    fn at_work(&self, frame: usize, dofs: &[usize]) -> impl Iterator<Item = usize> {
        let time = self.times[frame];
        (0..self.all.len()).filter(move |i| {
            let layer = &self.all[*i];
            layer.share_at(time) > 0.0 && layer.moves().any(|(dof, ..)| dofs.contains(&dof))
        })
    }
}

impl Nudged for Layers<'_> {
    fn positions(&mut self) -> Result<&[Vec<f64>], String> {
        if self.positions.is_empty() {
            self.found += 1;
            self.all.iter_mut().for_each(Layer::rewind);
            for time in self.times {
                let mut q = self.beforehand.positions(self.figure, *time);
                for (i, layer) in self.all.iter_mut().enumerate() {
                    layer.apply(&mut q, *time, &mut self.placed).inspect_err(|_| self.failed = Some(i))?;
                }
                self.positions.push(q);
            }
        }
        Ok(&self.positions)
    }

    fn found(&self) -> usize {
        self.found
    }

    fn widest(&self) -> f64 {
        self.all.iter().map(|layer| layer.asked.clearance).fold(0.0, f64::max)
    }

    fn wanted(&self, frame: usize, dofs: &[usize]) -> f64 {
        let asked = self.at_work(frame, dofs).map(|i| self.all[i].asked.clearance);
        asked.filter(|clearance| *clearance > 0.0).fold(f64::NEG_INFINITY, f64::max)
    }

    fn otherwise(&self, frame: usize) -> Option<Vec<f64>> {
        Some(self.beforehand.positions(self.figure, self.times[frame]))
    }

    fn until(&self, frame: usize, dofs: &[usize]) -> f64 {
        let ends = self.at_work(frame, dofs).map(|i| self.all[i].asked.until + self.all[i].asked.back);
        ends.fold(f64::NEG_INFINITY, f64::max)
    }

    fn nudge(
        &mut self,
        frame: usize,
        slopes: &[(usize, f64)],
        by: f64,
        nudge: Nudge,
        detour: bool,
    ) -> Result<bool, String> {
        let dofs: Vec<usize> = slopes.iter().map(|(dof, _)| *dof).collect();
        let at_work: Vec<usize> = self.at_work(frame, &dofs).collect();
        let before = self.positions()?.to_vec();
        for i in at_work {
            for share in [1.0, 0.5, 0.25, 0.125] {
                let at = (&*before[frame], self.times[frame]);
                if !self.all[i].nudge(at, slopes, share * by, nudge.clone(), detour)? {
                    break;
                }
                self.positions.clear();
                if self.is_sound()? {
                    return Ok(true);
                }
                // Too far for the limb.
                self.all[i].nudges.pop();
                self.positions.clone_from(&before);
            }
        }
        Ok(false)
    }

    fn turn(&mut self, frame: usize, dofs: &[usize], by: f64, nudge: Nudge) -> Result<bool, String> {
        self.positions()?;
        let at_work: Vec<usize> = self.at_work(frame, dofs).collect();
        for i in at_work {
            let at = (&*self.positions[frame], self.times[frame]);
            if self.all[i].turn(at, by, nudge.clone())? {
                self.positions.clear();
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn is_sound(&mut self) -> Result<bool, String> {
        let found = self.roughness()?;
        let (off, leap) = *self.plain.get_or_insert(found);
        Ok(found.0 <= 1.02 * off + REACHED && found.1 <= 4.0 * leap + SMOOTH)
    }

    fn added(&self) -> Vec<Vec<Nudge>> {
        self.all.iter().map(|layer| layer.nudges.clone()).collect()
    }

    fn put_back(&mut self, added: Vec<Vec<Nudge>>) {
        for (layer, nudges) in self.all.iter_mut().zip(added) {
            layer.nudges = nudges;
        }
        self.positions.clear();
    }
}
