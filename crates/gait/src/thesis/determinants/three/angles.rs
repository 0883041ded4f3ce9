//! The angles of the postures, from the parameters, and what has to hold.

use super::chain::{LiftingLeg, alpha, lift_off_height, xi};
use super::parameters::{ThreeParameters, parameters_of};
use crate::thesis::determinants::{Condition, Infeasible, Proportions};
use std::f64::consts::FRAC_PI_2;

/// The angles of the key postures (rad); the pitches of chapter 7 without their signs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThreeAngles {
    /// Both straight legs against the vertical, at the end of phase 2 (α).
    pub alpha: f64,
    /// The same against the ground (β = 90° − α).
    pub beta: f64,
    /// Drop of the pelvis at the end of phase 1 (δ).
    pub tilt: f64,
    /// Stance leg's shank at the end of phase 1, knee ahead of the ankle (χ).
    pub chi: f64,
    /// Stance leg's thigh at the end of phase 1, knee ahead of the hip (ξ).
    pub xi: f64,
    /// Thigh of the leg that lifts in the starting cycle, knee ahead of the hip (θ₁).
    pub theta1: f64,
    /// Its shank and its foot, ankle behind the knee (θ₃; θ₂ is the same).
    pub theta3: f64,
    /// Thigh of the leg that lifts in the other cycles, knee behind the hip (ω).
    pub omega: f64,
    /// Its shank and its foot, ankle behind the knee (φ).
    pub phi: f64,
}

impl ThreeParameters {
    /// All that has to hold, in the order in which it is asked.
    ///
    /// The thesis's four constraints are named `(i)` to `(iv)`. Before them stands what the equations themselves need, named
    /// after them, and what an angle of 0° or more is, where it is not.
    pub fn conditions(&self, p: &Proportions) -> Vec<Condition> {
        conditions(self, p).1
    }

    /// The angles of all postures.
    ///
    /// # Errors
    ///
    /// Parameters that break a condition (what is not finite does), with the nearest feasible value of each.
    pub fn solve(&self, p: &Proportions) -> Result<ThreeAngles, Infeasible> {
        let (angles, all) = conditions(self, p);
        let fails: Vec<Condition> = all.into_iter().filter(|condition| !condition.holds()).collect();
        if fails.is_empty() {
            return Ok(angles);
        }
        let feasible = |values: &[f64]| {
            let trial = values.try_into().map(Self::from_values);
            trial.is_ok_and(|trial| conditions(&trial, p).1.iter().all(Condition::holds))
        };
        Err(Infeasible::new(fails, &parameters_of(p), &self.values(), feasible))
    }
}

/// The angles, and all conditions; where these fail the angles may be NaN.
///
/// ```text
/// sin α = S / 2(L₁ + L₂)      L₁ sin ξ = L₂ sin χ      D = M + h_a − L sin δ − h_ball
/// L₁ cos θ₁ = D − g(θ₃)       L₁ cos ω = D − g(φ)
/// ```
///
/// # Source
///
/// (7.1) to (7.6) and the constraints of §7.4.5, with L₁ cos θ₁ where (7.2) has L₃ cos θ₁, θ₁ where (ii) has θ, and φ against the
/// vertical. Feet have a height here, see [`LiftingLeg`].
fn conditions(parameters: &ThreeParameters, p: &Proportions) -> (ThreeAngles, Vec<Condition>) {
    let ThreeParameters { step_length, tilt, flexion: chi, start_lift_off: theta3, lift_off: phi } =
        *parameters;
    let leg = LiftingLeg::of(p);
    let alpha = alpha(p, step_length);
    let height = lift_off_height(p, tilt, chi);
    let theta1 = leg.thigh_for(height, theta3);
    let omega = leg.thigh_for(height, phi);
    let angles =
        ThreeAngles { alpha, beta: FRAC_PI_2 - alpha, tilt, chi, xi: xi(p, chi), theta1, theta3, omega, phi };

    let mut all = Vec::with_capacity(12);
    lengths(p, &mut all);
    all.push(metres("(7.6)", "S > 0", 0.0, step_length));
    all.push(metres("(7.6)", "S < 2(L₁ + L₂)", step_length, 2.0 * p.leg()));
    for (text, angle) in [("δ ≥ 0", tilt), ("χ ≥ 0", chi), ("θ₃ ≥ 0", theta3), ("φ ≥ 0", phi)] {
        if !(angle >= 0.0 && angle.is_finite()) {
            all.push(degrees("domain", text, 0.0, if angle.is_finite() { angle } else { f64::NAN }));
        }
    }
    all.push(degrees("domain", "δ < 90°", tilt, FRAC_PI_2));
    all.push(metres("(7.1)", "L₂ sin χ < L₁", p.shank * chi.sin(), p.thigh));
    all.push(degrees("(i)", "α > χ", chi, alpha));
    // Without θ₁ or ω there is nothing to say about them.
    all.push(metres("(7.3)", "D − L₂ cos θ₃ − L₃ sin θ₃ < L₁", height - leg.below_knee(theta3), p.thigh));
    if !theta1.is_nan() {
        all.push(degrees("(ii)", "α > θ₁", theta1, alpha));
    }
    all.push(degrees("domain", "θ₃ < 90°", theta3, FRAC_PI_2));
    all.push(metres("(7.5)", "D − L₂ cos φ − L₃ sin φ < L₁", height - leg.below_knee(phi), p.thigh));
    if !omega.is_nan() {
        all.push(degrees("(iii)", "ω > α", alpha, omega));
        all.push(degrees("(iv)", "φ > ω", omega, phi));
    }
    all.push(degrees("domain", "φ < 90°", phi, FRAC_PI_2));
    (angles, all)
}

/// What is amiss with the lengths themselves.
pub(super) fn lengths(p: &Proportions, into: &mut Vec<Condition>) {
    for (text, length) in [("L₁ > 0", p.thigh), ("L₂ > 0", p.shank)] {
        if !(length > 0.0 && length.is_finite()) {
            into.push(metres("lengths", text, 0.0, if length.is_finite() { length } else { f64::NAN }));
        }
    }
    let rest = [p.ankle_height, p.ball_ahead, p.ball_below, p.ball_height, p.hips];
    if let Some(length) = rest.into_iter().find(|length| !(length.is_finite() && *length >= 0.0)) {
        let length = if length.is_finite() { length } else { f64::NAN };
        into.push(metres("lengths", "foot and pelvis ≥ 0", 0.0, length));
    }
}

pub(super) fn metres(name: &'static str, text: &'static str, lesser: f64, greater: f64) -> Condition {
    Condition { name, text, sides: [lesser, greater], symbol: " m" }
}

fn degrees(name: &'static str, text: &'static str, lesser: f64, greater: f64) -> Condition {
    Condition { name, text, sides: [lesser.to_degrees(), greater.to_degrees()], symbol: "°" }
}
