//! What a pass looks at between stretches: drives whose forces make steps too long, and what the world has done meanwhile.

use super::guard;
use super::pass::{Compiled, Pass};
use crate::failure::RunError;
use crate::phase::Phase;
use crate::settings::Rule;
use crate::time::Stepping;

impl Pass {
    /// Looks at the equations before the first step.
    pub(crate) fn look_before(&self, phase: &mut Phase) -> Result<(), RunError> {
        let y = phase.pack(&self.q, &self.v, self.work, self.heat);
        let rule = Rule::RungeKutta4;
        let stepping = self.shortest.map_or(self.stepping, |step| Stepping::Fixed { rule, step });
        guard::look_before(&self.simulation, &self.settings.guard, phase, stepping, self.t, &y)
    }

    /// A phase whose servos are other ones now may be stiffer than it was.
    pub(super) fn look_again(&self, mut compiled: Compiled) -> Result<Compiled, RunError> {
        let servos = self.servos();
        if servos != compiled.servos {
            if !servos.is_empty() {
                self.load(&mut compiled.phase, self.next_stop())?;
                self.look_before(&mut compiled.phase)?;
            }
            compiled.servos = servos;
        }
        Ok(compiled)
    }

    /// What was compiled is of another figure than there is now.
    pub(crate) fn forget_phase(&mut self) {
        self.compiled = None;
    }

    /// The drives whose forces depend on the state: degree of freedom, and place among its drives.
    pub(crate) fn servos(&self) -> Vec<(usize, usize)> {
        let feeling = self.driven.iter().enumerate().filter(|(_, driven)| driven.feels());
        feeling.map(|(dof, driven)| (dof, driven.step)).collect()
    }

    /// The world has done work (J) between two stretches.
    pub(crate) fn gain(&mut self, work: f64) {
        self.work += work;
        self.passed.pushed += work;
        self.passed.ledger.lose(-work);
        self.passed.ledger.report.impacts += work;
    }
}
