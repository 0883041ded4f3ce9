//! How long steps are.

use super::pair::Pair;
use crate::time::evaluate::Evaluator;
use crate::time::{System, TimeError};

/// The order of the error that steps are chosen by.
const ORDER: f64 = 8.0;

/// The exponent of the last error but one: how much steps are kept from swinging to and fro where stability holds them.
const STEADY: f64 = 0.04;

/// What is left to chance: the part of the step that would just do.
const SAFE: f64 = 0.9;

/// A step is at least this part of the last one, and at most so many times as long.
const SHRINKS: f64 = 1.0 / 3.0;
const GROWS: f64 = 6.0;

/// Steps of a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Control {
    /// The error of the last step that was taken.
    before: f64,
    /// Whether the last try was rejected, so that the next step does not grow.
    rejected: bool,
}

impl Control {
    pub(super) fn new() -> Self {
        Self { before: 1e-4, rejected: false }
    }

    /// The step after one of length `h` (s) with this error, in units of what is allowed, and whether that is good enough.
    ///
    /// ```text
    /// h⁺ = h·0.9·E^−(1/8 − 0.2·β)·E₋^β
    /// ```
    ///
    /// # Source
    ///
    /// K. Gustafsson: Control theoretic techniques for stepsize selection in explicit Runge–Kutta methods. ACM Transactions on
    /// Mathematical Software 17 (1991), 533–554, with the exponents of Hairer, Nørsett, Wanner (1993), §II.10 and their DOP853.
    pub(super) fn next(&mut self, h: f64, error: f64) -> (f64, bool) {
        let needed = error.powf(1.0 / ORDER - 0.2 * STEADY) / SAFE;
        // NaN, of an error that is none, is no step.
        let is_met = error <= 1.0;
        if !is_met {
            self.rejected = true;
            let part = needed.recip();
            return (h * if part > SHRINKS { part.min(1.0) } else { SHRINKS }, false);
        }
        let part = (self.before.powf(STEADY) / needed).clamp(SHRINKS, GROWS);
        let part = if self.rejected { part.min(1.0) } else { part };
        (self.before, self.rejected) = (error.max(1e-4), false);
        (h * part, true)
    }

    /// A step that had no rate, or no state, at all.
    pub(super) fn fail(&mut self, h: f64) -> f64 {
        self.rejected = true;
        h * SHRINKS
    }
}

/// The first step (s) of a stretch that is `longest` (s), from `y` at `t` (s), where the pair knows the rate: one of order one as long
/// would change the state by a hundredth of what the tolerance is relative to, and one of order eight meets the tolerance.
///
/// # Source
///
/// Hairer, Nørsett, Wanner (1993), §II.4, "Starting step size"; there the hundredth is of the state alone, which may be zero.
pub(super) fn first<S: System + ?Sized>(
    evaluator: &mut Evaluator<'_, S>,
    pair: &mut Pair,
    (t, longest): (f64, f64),
    y: &[f64],
    tolerance: f64,
) -> Result<f64, TimeError> {
    let slope = pair.slope(y, tolerance);
    let h = (0.01 / (tolerance * slope)).min(longest);
    // A state that has no rate is farther than any step should go.
    let curvature = match pair.change(evaluator, (t, h), y, tolerance) {
        Ok(change) => change / h,
        Err(error @ TimeError::Evaluations { .. }) => return Err(error),
        Err(_) => return Ok(0.1 * h),
    };
    let most = slope.max(curvature);
    let found = (0.01 / most).powf(1.0 / ORDER);
    // Both are infinite, or NaN, where nothing changes.
    Ok(found.min(100.0 * h).min(longest))
}
