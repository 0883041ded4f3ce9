//! What a pass looks at between stretches: drives whose forces make steps too long, and what the world has done meanwhile.

use super::guard;
use super::pass::Pass;
use crate::failure::RunError;
use crate::phase::Phase;

impl Pass {
    /// Looks at the equations before the first step.
    pub(crate) fn look_before(&self, phase: &mut Phase) -> Result<(), RunError> {
        let y = phase.pack(&self.q, &self.v, self.work, self.heat);
        guard::look_before(&self.simulation, &self.settings.guard, phase, self.stepping, self.t, &y)
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
