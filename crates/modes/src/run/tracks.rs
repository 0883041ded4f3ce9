//! Forces of degrees of freedom that track a target, found anew each frame.

use super::driven::Mode;
use super::pass::Pass;
use crate::drive::simple::analyse;
use crate::drive::tracking::frame_forces;
use crate::failure::RunError;
use crate::{Drive, Law};

impl Pass {
    /// The forces of the next `frame` (s) of all degrees of freedom that track a target.
    pub(crate) fn find_forces(&mut self, frame: f64) -> Result<(), RunError> {
        let tracks: Vec<usize> =
            (0..self.driven.len()).filter(|&dof| matches!(self.driven[dof].mode, Mode::Track(..))).collect();
        if tracks.is_empty() {
            return Ok(());
        }
        let (prescribed, mut a, mut tau) = self.given();
        let layout = self.simulation.figure.layout();
        for (a, driven) in a.iter_mut().zip(&self.driven) {
            if let Mode::Path(path) = &driven.mode {
                *a = path.at(self.t + 0.5 * frame).acceleration;
            }
        }
        let (mut wanted, mut literal) = (Vec::new(), Vec::new());
        for &dof in &tracks {
            let Some(coordinate) = layout.coordinate(dof) else { continue };
            let step = self.driven[dof].step;
            let Some(Drive::Intensive { target, law, .. }) =
                self.simulation.drives[dof].get(step).map(|step| step.drive.clone())
            else {
                continue;
            };
            if law == Law::Literal {
                literal.push((dof, target));
            } else if let Mode::Track(tracker, _) = &mut self.driven[dof].mode {
                wanted.push((dof, tracker.wanted(self.t, frame, self.q[coordinate], self.v[dof])));
            }
        }
        let failed = |error| RunError::from(super::guard::of_dynamics(self.t, error));
        if !literal.is_empty() {
            let analysis = analyse(&mut self.body, layout, &self.q, &self.v, &prescribed, &a, &tau, &literal);
            for (&(dof, _), force) in literal.iter().zip(analysis.map_err(failed)?.force) {
                tau[dof] = force;
            }
            self.passed.counts.evaluations += 2;
        }
        if !wanted.is_empty() {
            let figure = &self.simulation.figure;
            frame_forces(
                &mut self.body,
                figure,
                &self.q,
                &self.v,
                &prescribed,
                &mut a,
                &mut tau,
                &wanted,
                frame,
            )
            .map_err(failed)?;
            self.passed.counts.evaluations += 1;
        }
        for dof in tracks {
            let step = self.driven[dof].step;
            let limit = match self.simulation.drives[dof].get(step).map(|step| &step.drive) {
                Some(Drive::Intensive { limit: Some(limit), .. }) => *limit,
                _ => f64::INFINITY,
            };
            let driven = &mut self.driven[dof];
            driven.limited |= tau[dof].abs() > limit;
            if let Mode::Track(_, force) = &mut driven.mode {
                *force = tau[dof].clamp(-limit, limit);
            }
        }
        Ok(())
    }
}
