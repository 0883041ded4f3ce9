//! Bounds of what is feasible, as intervals.

use super::chain::{
    LiftingLeg, alpha, flexion_for, foot_rise, largest_flexion, lift_off_height, stance_height,
};
use crate::thesis::determinants::Proportions;
use std::f64::consts::FRAC_PI_2;

/// The tilts of the pelvis (δ, rad) that leave any flexion feasible at this step length; `None` where there are none.
///
/// ```text
/// M(α) + h − D_max < L sin δ < L₁ + L₂ + h − D_min        h = h_a − h_ball
/// D_min = L₃ + L₁ cos α        D_max = L₁ cos α + g(max(α, γ))
/// ```
///
/// The ends themselves are not feasible, but for 0.
pub fn tilt_range(p: &Proportions, step_length: f64) -> Option<[f64; 2]> {
    let alpha = alpha(p, step_length);
    if !(alpha > 0.0 && alpha < FRAC_PI_2) {
        return None;
    }
    let leg = LiftingLeg::of(p);
    let deepest = stance_height(p, alpha.min(largest_flexion(p)));
    let least = deepest + foot_rise(p) - leg.highest(alpha);
    let most = p.leg() + foot_rise(p) - leg.lowest(alpha);
    // Hips so near to each other, or so wanting, that no tilt is enough.
    if !(least < p.hips && (least < 0.0 || p.hips > 0.0) && most > 0.0) {
        return None;
    }
    let lower = if least < 0.0 { 0.0 } else { (least / p.hips).asin() };
    let upper = if most >= p.hips { FRAC_PI_2 } else { (most / p.hips).asin() };
    (lower < upper).then_some([lower, upper])
}

/// The flexions of the stance knee (χ, rad) that are feasible at this step length and tilt (rad), of some θ₃ and φ.
///
/// ```text
/// D_min < D(χ) < D_max,  0 ≤ χ < α        D_min = L₃ + L₁ cos α,  D_max = L₁ cos α + g(max(α, γ))
/// cos χ = (K² + L₂² − L₁²) / 2 K L₂       K = D_max (or D_min) + L sin δ − h_a + h_ball
/// ```
///
/// `None` where there are none. The ends themselves are not feasible, but for 0. It is exact: it replaces table 7.4, which
/// finds 1315 of the 2679 feasible points of the thesis's grid.
pub fn chi_range(p: &Proportions, step_length: f64, tilt: f64) -> Option<[f64; 2]> {
    let alpha = alpha(p, step_length);
    if !(alpha > 0.0 && alpha < FRAC_PI_2 && (0.0..FRAC_PI_2).contains(&tilt)) {
        return None;
    }
    let leg = LiftingLeg::of(p);
    let lost = p.hips * tilt.sin() - foot_rise(p);
    let (highest, lowest) = (leg.highest(alpha) + lost, leg.lowest(alpha) + lost);
    if p.leg() <= lowest || stance_height(p, largest_flexion(p)) >= highest {
        return None;
    }
    let lower = flexion_for(p, highest);
    let upper = alpha.min(flexion_for(p, lowest));
    (lower < upper).then_some([lower, upper])
}

/// What is left to choose when step length, tilt and flexion are (rad).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiftOffRanges {
    /// Thigh ahead of the vertical at the lift-off of the starting cycle (θ₁).
    pub theta1: [f64; 2],
    /// Shank behind it (θ₃), past γ; it falls as θ₁ grows.
    pub theta3: [f64; 2],
    /// Thigh behind the vertical at lift-off (ω); α, its lower end, is not feasible.
    pub omega: [f64; 2],
    /// Shank behind it (φ), past γ; it falls as ω grows.
    pub phi: [f64; 2],
}

/// The ranges of the angles at lift-off.
///
/// ```text
/// θ₁ from acos((D − L₃)/L₁) (or 0) to min(α, acos((D − R)/L₁))        ω from α to ω_max
/// θ₃ = γ + acos((D − L₁ cos θ₁)/R)        φ = γ + acos((D − L₁ cos ω)/R)
/// ```
///
/// `None` where the flexion is outside [`chi_range()`]. Where a shank in front of γ reaches the ground too, that is a second
/// range, which is left out here: in it the foot hardly leaves the ground.
pub fn lift_off_ranges(p: &Proportions, step_length: f64, tilt: f64, flexion: f64) -> Option<LiftOffRanges> {
    let [least, most] = chi_range(p, step_length, tilt)?;
    if !(flexion >= least && flexion < most) {
        return None;
    }
    let leg = LiftingLeg::of(p);
    let alpha = alpha(p, step_length);
    let height = lift_off_height(p, tilt, flexion);
    let theta1 = [leg.thigh_at(height, leg.foot), alpha.min(leg.thigh_at(height, leg.radius()))];
    let omega = [alpha, leg.largest_omega(height)];
    let shanks = |[low, high]: [f64; 2]| [leg.shank_for(height, high), leg.shank_for(height, low)];
    let ordered = |[low, high]: [f64; 2]| low < high;
    (ordered(theta1) && ordered(omega)).then(|| LiftOffRanges {
        theta1,
        theta3: shanks(theta1),
        omega,
        phi: shanks(omega),
    })
}
