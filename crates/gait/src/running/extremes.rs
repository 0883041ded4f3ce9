//! What a run asks of soles and legs.

use nalgebra::Vector3;

/// Part of the body's weight from which on a foot counts as loaded.
const LOADED: f64 = 0.05;

/// The greatest and least values that a run must keep within what soles and legs can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunExtremes {
    /// Greatest friction ratio of a foot that bears more than 5 % of the weight.
    pub friction: f64,
    /// Least knee flexion (rad); negative is hyperextended.
    pub least_knee: f64,
    /// Greatest depth of a point of the soles below the ground (m).
    pub sink: f64,
    /// Greatest distance by which a leg is too short for its planted foot (m).
    pub short: f64,
    /// By how much the force that the body needs differs from the law's at most, over the weight.
    pub force_excess: f64,
    /// By how much the rate of the body's angular momentum differs from the law's at most (N m).
    pub momentum_excess: f64,
}

impl RunExtremes {
    /// Nothing asked yet.
    pub(super) fn none() -> Self {
        Self {
            friction: 0.0,
            least_knee: f64::INFINITY,
            sink: f64::NEG_INFINITY,
            short: 0.0,
            force_excess: 0.0,
            momentum_excess: 0.0,
        }
    }

    /// A leg with this knee flexion, this depth of its sole, and so much too short.
    pub(super) fn note_leg(&mut self, knee: f64, sink: f64, short: f64) {
        self.least_knee = -greatest([-self.least_knee, -knee]);
        self.sink = greatest([self.sink, sink]);
        self.short = greatest([self.short, short]);
    }

    /// A foot with this force, of a body with this weight (N).
    pub(super) fn note_force(&mut self, force: &Vector3<f64>, weight: f64) {
        if force.y > LOADED * weight {
            self.friction = greatest([self.friction, force.x.hypot(force.z) / force.y]);
        }
    }
}

/// The greatest value; NaN where there is one, so that it is found.
pub(super) fn greatest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::NEG_INFINITY, |a, b| if a >= b || a.is_nan() { a } else { b })
}
