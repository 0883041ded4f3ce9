//! The forces of one step of a chain, for some amplitudes of their laws.

use super::basis::{Basis, LIFTS, ROLLS, WAVES};
use crate::body::foot::{FootPlane, mirror};
use crate::running::laws::TWIST;
use crate::walking::G;
use nalgebra::Vector3;

/// What the amplitudes of one step's forces are.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct StepForces {
    /// Of the vertical force.
    pub(super) lifts: [f64; LIFTS],
    /// By how much it makes the body faster (m/s).
    pub(super) gain: f64,
    pub(super) fore_aft: [f64; WAVES],
    pub(super) lateral: [f64; WAVES],
    pub(super) twist: [f64; TWIST],
    pub(super) rolls: [f64; ROLLS],
    pub(super) shift: f64,
    /// Where the print's heel is, and that of the other foot: to the left of the line for a left foot, to the right for a right one, and along (m).
    pub(super) aside: f64,
    pub(super) other_aside: f64,
    pub(super) along: f64,
}

fn sum(laws: &[f64], by: &[f64]) -> f64 {
    laws.iter().zip(by).map(|(law, a)| law * a).sum()
}

impl StepForces {
    /// Vertical force over the weight.
    pub(super) fn vertical(&self, basis: &Basis) -> f64 {
        basis.fixed + sum(&basis.lifts, &self.lifts)
    }

    /// Centre of pressure from the heel over the foot's length.
    pub(super) fn pressure(&self, basis: &Basis) -> f64 {
        basis.pressure + sum(&basis.rolls, &self.rolls)
    }

    /// The part of the force that the other foot has.
    pub(super) fn other(&self, basis: &Basis) -> f64 {
        let vertical = self.vertical(basis);
        if basis.shift == 0.0 { basis.other } else { basis.other + basis.shift * self.shift / vertical }
    }

    /// Force over the weight (but for the gain: N for the mass 1 and gravity 1), and free moment (N m).
    pub(super) fn force(&self, side: usize, basis: &Basis) -> (Vector3<f64>, f64) {
        let sign = sign(side);
        let force = Vector3::new(
            sign * sum(&basis.lateral, &self.lateral),
            self.vertical(basis),
            sum(&basis.fore_aft, &self.fore_aft) + self.gain * basis.faster / G,
        );
        (force + basis.towards * force.y, sign * sum(&basis.twist, &self.twist) + basis.given_twist)
    }
}

pub(super) fn sign(side: usize) -> f64 {
    if side == 0 { 1.0 } else { -1.0 }
}

/// Where the own and the other foot press, which stand as `forces` say.
pub(super) fn pressures(
    plane: &FootPlane,
    foot: f64,
    side: usize,
    forces: &StepForces,
    basis: &Basis,
) -> [Vector3<f64>; 2] {
    let along = Vector3::z() * forces.along;
    let pressed = plane.forward * (forces.pressure(basis) * foot) + plane.left * basis.outward;
    let at = |side: usize, aside: f64| {
        let left = Vector3::x() * aside + pressed;
        along + if side == 0 { left } else { mirror(&left) }
    };
    [at(side, forces.aside), at(1 - side, forces.other_aside)]
}
