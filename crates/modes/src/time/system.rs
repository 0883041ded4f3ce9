//! The interface of what a stepper steps.

use nalgebra::DMatrix;
use solaris_dynamics::DynamicsError;

/// Something whose state `y` has a rate: `ẏ = f(t, y)`.
///
/// The equations of motion of a figure are one; any ordinary differential equations can be.
pub trait System {
    /// Length of the state.
    fn len(&self) -> usize;

    /// Whether there is no state.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Writes `f(t, y)`; both slices have length [`len`](Self::len).
    ///
    /// # Errors
    ///
    /// [`RateError`] for a state that has no rate.
    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError>;

    /// Writes `∂f/∂y`: row, entry of the rate; column, entry of the state.
    ///
    /// # Errors
    ///
    /// [`RateError`] for a state that has no rate.
    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError>;

    /// How the positions among the state go on with given velocities: writes to `rate` the entries of positions for the
    /// velocities that are in `y`, and leaves the others. `false`, without a change, where the state has no positions.
    fn position_rate(&self, y: &[f64], rate: &mut [f64]) -> bool {
        let _ = (y, rate);
        false
    }

    /// Writes to `next` the state a step of `h` (s) after `y`, found with the impulses that the step needs. `false`, without a
    /// change, for a system that knows of none.
    ///
    /// # Errors
    ///
    /// [`RateError`] for a state that has no rate.
    fn step_by_impulses(&mut self, t: f64, h: f64, y: &[f64], next: &mut [f64]) -> Result<bool, RateError> {
        let _ = (t, h, y, next);
        Ok(false)
    }

    /// Number of event functions.
    fn events(&self) -> usize {
        0
    }

    /// Writes the values of the event functions; an event is where one passes through zero.
    fn event_values(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        let _ = (t, y, values);
    }

    /// On which side of zero an event function belongs that begins a stretch at zero: 1 or −1, so that leaving to the other side
    /// is an event too, as where something at its limit would go through it. 0 where either side will do.
    fn event_side(&self, index: usize) -> f64 {
        let _ = index;
        0.0
    }

    /// The first time (s) after `t` from which on rates go on by another formula, smooth before and after, such as where two pieces
    /// of a curve meet: a method that chooses its steps ends one there. Infinite where there is none.
    fn smooth_until(&self, t: f64) -> f64 {
        let _ = t;
        f64::INFINITY
    }

    /// Is told of each step that a method of its own choice has taken, with what it says of its error: a part of `1 + |y|`.
    fn note_error(&mut self, error: f64) {
        let _ = error;
    }

    /// Puts the state back where it belongs after a step, such as a quaternion to unit length.
    fn settle(&self, y: &mut [f64]) {
        let _ = y;
    }
}

/// Why a state has no rate.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RateError {
    /// The dynamics refuse it.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// Whoever looks on has stopped the run.
    #[error("stopped")]
    Stopped,
    /// The rate, or the state itself, is not finite.
    #[error("entry {index} of the rate is {value}")]
    NotFinite {
        /// Which entry.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// The value of an event function is not finite.
    #[error("event function {index} is {value}")]
    EventNotFinite {
        /// Which function.
        index: usize,
        /// Its value.
        value: f64,
    },
}
