//! The thesis's curves as they are printed there, with signs and factors corrected (docs/sources.md), programmed as somebody
//! would who reads its appendix A: to measure what the forms of the library are worth.

mod acceleration;
mod displacement;
mod fade;
mod solve;
mod velocity;

pub(super) use acceleration::{QuarterEllipse, Sine};
pub(super) use displacement::{
    Exponential, ExponentialVelocities, HyperbolicVelocities, Trigonometric, TrigonometricVelocities,
};
pub(super) use fade::{ExponentialFade, SinhFade};
pub(super) use velocity::Circle;

use num_traits::{Float, FloatConst};

/// A number of the machine.
pub(super) trait Number: Float + FloatConst {
    /// The number next to `x`.
    fn number(x: f64) -> Self;
}

impl Number for f64 {
    fn number(x: f64) -> Self {
        x
    }
}

impl Number for f32 {
    fn number(x: f64) -> Self {
        x as f32
    }
}

/// A curve with its constants worked out.
pub(super) trait Printed<F> {
    /// Position, velocity and acceleration.
    fn at(&self, t: F) -> [F; 3];
}

/// The share of a span that has passed, by absolute time: `t` and `start` have the precision of all the rest.
pub(super) struct Share<F> {
    pub(super) start: F,
    pub(super) duration: F,
}

impl<F: Number> Printed<F> for Share<F> {
    fn at(&self, t: F) -> [F; 3] {
        [(t - self.start) / self.duration, F::one() / self.duration, F::zero()]
    }
}
