//! A choice of the parameters that is feasible whenever any is.

use super::angles::{lengths, metres};
use super::bounds::{chi_range, lift_off_ranges, tilt_range};
use super::chain::{LiftingLeg, alpha, foot_rise, largest_flexion, stance_height};
use super::parameters::{ThreeParameters, parameters_of};
use crate::thesis::determinants::{Condition, Infeasible, Proportions};

/// The tilt that is chosen where it can be (°): people's pelvis drops by about as much.
const TILT: f64 = 5.0;

/// How far from the ends of its range the tilt stays (°).
const CLEAR: f64 = 1.0;

/// The part of a range at which a choice lies.
const PART: f64 = 0.5;

fn within([low, high]: [f64; 2]) -> f64 {
    low + PART * (high - low)
}

impl ThreeParameters {
    /// A choice for a step length (in the unit of the proportions), in closed form and without jumps:
    ///
    /// - the tilt δ is 5°, or as much less or more as a feasible flexion needs, 1° (or a quarter of the range) from the ends of
    ///   [`tilt_range()`](super::tilt_range());
    /// - the flexion χ is in the middle of [`chi_range()`](super::chi_range());
    /// - θ₁ and ω are in the middle of [`lift_off_ranges()`](super::lift_off_ranges()), and θ₃ and φ follow.
    ///
    /// # Errors
    ///
    /// A step length at which no parameters are feasible, with the nearest one at which some are.
    pub fn automatic(p: &Proportions, step_length: f64) -> Result<Self, Infeasible> {
        choose(p, step_length).ok_or_else(|| refusal(p, step_length))
    }
}

/// See [`ThreeParameters::automatic()`].
fn choose(p: &Proportions, step_length: f64) -> Option<ThreeParameters> {
    let [least, most] = tilt_range(p, step_length)?;
    let clear = CLEAR.to_radians().min(0.25 * (most - least));
    let tilt = TILT.to_radians().clamp(least + clear, most - clear);
    let flexion = within(chi_range(p, step_length, tilt)?);
    let ranges = lift_off_ranges(p, step_length, tilt, flexion)?;
    let leg = LiftingLeg::of(p);
    let height = super::chain::lift_off_height(p, tilt, flexion);
    let chosen = ThreeParameters {
        step_length,
        tilt,
        flexion,
        start_lift_off: leg.shank_for(height, within(ranges.theta1)),
        lift_off: leg.shank_for(height, within(ranges.omega)),
    };
    // Only rounding, at the very ends, or lengths that are none can make this fail.
    chosen.conditions(p).iter().all(Condition::holds).then_some(chosen)
}

/// Why no parameters are feasible at this step length.
fn refusal(p: &Proportions, step_length: f64) -> Infeasible {
    let leg = LiftingLeg::of(p);
    let alpha = alpha(p, step_length);
    let mut all = Vec::new();
    lengths(p, &mut all);
    all.push(metres("(7.6)", "S > 0", 0.0, step_length));
    all.push(metres("(7.6)", "S < 2(L₁ + L₂)", step_length, 2.0 * p.leg()));
    if !alpha.is_nan() {
        let deepest = stance_height(p, alpha.min(largest_flexion(p))) + foot_rise(p) - p.hips;
        all.push(metres(
            "(ii)",
            "D > L₃ + L₁ cos α for some δ, χ",
            leg.lowest(alpha),
            p.leg() + foot_rise(p),
        ));
        all.push(metres("(iii), (iv)", "D < L₁ cos α + g(α) for some δ, χ < α", deepest, leg.highest(alpha)));
    }
    let fails = all.into_iter().filter(|condition| !condition.holds()).collect();
    let parameters = parameters_of(p);
    Infeasible::new(fails, &parameters[..1], &[step_length], |values| choose(p, values[0]).is_some())
}
