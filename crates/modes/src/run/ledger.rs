//! Where the energy goes.

use crate::report::{Energy, EnergyReport};
use crate::simulation::Simulation;
use nalgebra::Vector3;

/// Accounts of energy over a pass (J).
#[derive(Clone, Debug, Default)]
pub(crate) struct Ledger {
    pub(crate) report: EnergyReport,
    begun: bool,
    /// Of the stretches that are over.
    error: f64,
    /// What the present stretch began with: energy, work, heat.
    from: (f64, f64, f64),
    /// Work and heat at the beginning.
    paid: (f64, f64),
    /// The potential energy that heights are counted from.
    level: f64,
    /// What impacts took before anything was computed.
    early: f64,
    /// What counts as at play at the least: at the beginning hardly anything moves.
    least: f64,
}

impl Ledger {
    /// Accounts in which errors are weighed against this energy (J) at the least.
    pub(crate) fn new(least: f64) -> Self {
        Self { least, ..Self::default() }
    }

    /// A stretch begins with this energy, work and heat.
    pub(crate) fn begin(&mut self, energy: Energy, work: f64, heat: f64) {
        if self.begun {
            // Besides what impacts have taken, what is computed is another part of the figure now.
            self.report.moved += energy.total() - self.report.end.total();
            self.level += energy.potential - self.report.end.potential;
        } else {
            (self.report.start, self.begun, self.level) = (energy, true, energy.potential);
            self.report.start.kinetic += self.early;
            self.paid = (work, heat);
        }
        self.from = (energy.total(), work, heat);
        self.report.end = energy;
        self.weigh(energy);
    }

    /// On the way: how much energy has come from nowhere by now, as a part of what is at play.
    ///
    /// ```text
    /// E − E₀ = work − heat
    /// ```
    pub(crate) fn check(&mut self, energy: Energy, work: f64, heat: f64) -> f64 {
        let found = self.found(energy, work, heat);
        self.weigh(energy);
        let exchanged = (work - self.paid.0).abs().max(heat - self.paid.1);
        self.report.scale = self.report.scale.max(exchanged);
        self.report.imbalance = self.report.imbalance.max(found.abs());
        // What is left of large numbers that are taken from each other is rounding.
        let rounding = 1e-9 * (energy.kinetic + energy.potential.abs() + energy.elastic);
        if found.abs() <= rounding { 0.0 } else { found.abs() / self.report.scale.max(self.least) }
    }

    /// The stretch is over.
    pub(crate) fn end(&mut self, energy: Energy, work: f64, heat: f64) {
        self.error = self.found(energy, work, heat);
        (self.report.end, self.report.work, self.report.heat) = (energy, work, heat);
    }

    /// An impact took this energy (J), between two stretches.
    pub(crate) fn lose(&mut self, loss: f64) {
        self.report.impacts += loss;
        if self.begun {
            self.report.end.kinetic -= loss;
        } else {
            self.early += loss;
        }
    }

    fn found(&self, energy: Energy, work: f64, heat: f64) -> f64 {
        self.error + (energy.total() - self.from.0) - ((work - self.from.1) - (heat - self.from.2))
    }

    fn weigh(&mut self, energy: Energy) {
        let at_play = energy.kinetic + energy.elastic + (energy.potential - self.level).abs();
        self.report.scale = self.report.scale.max(at_play);
    }
}

/// An energy (J) that is little for the figure: to lift it by a hundredth of its height, or of how long it is where all of it is on one
/// level, or how large what touches the ground is where it has no length at all.
pub(crate) fn least_energy(simulation: &Simulation) -> f64 {
    let Simulation { figure, gravity, surface, .. } = simulation;
    if gravity.norm() == 0.0 {
        return 0.0;
    }
    let along = |direction: Vector3<f64>| figure.extent(&direction).height;
    let height = match along(-gravity) {
        0.0 => {
            let points = surface.iter().flat_map(|surface| &surface.contact_points);
            let touching = points.map(|point| point.center.norm() + point.radius).fold(0.0, f64::max);
            [Vector3::x(), Vector3::y(), Vector3::z()].map(along).into_iter().fold(touching, f64::max)
        }
        height => height,
    };
    0.01 * figure.mass() * gravity.norm() * height
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_comes_from_nowhere_is_found() {
        let mut ledger = Ledger::default();
        let energy = |kinetic, potential| Energy { kinetic, potential, elastic: 0.0 };
        ledger.begin(energy(0.0, 10.0), 0.0, 0.0);
        assert!(ledger.check(energy(6.0, 5.0), 2.0, 1.0) < 1e-15);
        assert!((ledger.check(energy(6.5, 5.0), 2.0, 1.0) - 0.5 / 11.5).abs() < 1e-15);
        ledger.end(energy(6.5, 5.0), 2.0, 1.0);
        // The next stretch may begin with another energy, after an impact or with another part of the figure.
        ledger.begin(energy(1.0, 5.0), 2.0, 1.0);
        ledger.check(energy(1.0, 5.0), 2.0, 1.0);
        assert!((ledger.report.imbalance - 0.5).abs() < 1e-15);
    }
}
