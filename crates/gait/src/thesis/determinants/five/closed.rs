//! The closed model: from eight parameters to all angles.

use super::super::proportions::Proportions;
use super::parameters::{FiveParameters, parameters_of};
use super::sides::{angles, cosine};
use crate::condition::{Condition, Infeasible};
use crate::error::{GaitError, PostureError};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// All angles (rad) of the four postures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveAngles {
    /// What they come from.
    pub parameters: FiveParameters,
    /// Forward pitch of the straight leg whose heel has struck (α).
    pub alpha: f64,
    /// Pitch of the straight rear leg then (β).
    pub beta: f64,
    /// Forward pitch of the thigh before the heel strikes, the shank vertical (χ).
    pub chi: f64,
    /// Pitch of shank, foot and toes that lift off (ω).
    pub omega: f64,
    /// Forward pitch of the other thigh then, the shank vertical (ξ).
    pub xi: f64,
    /// Backward pitch of the shank that swings past: ω − κ − φ (ε).
    pub epsilon: f64,
    /// Backward pitch of the standing shank then (ψ).
    pub psi: f64,
    /// Forward pitch of the standing thigh then (μ).
    pub mu: f64,
}

/// A point `(c1 − A sin x + B cos x, c2 + A cos x + B sin x)` on the circle of radius R about the origin.
struct Circle {
    c1: f64,
    c2: f64,
    a: f64,
    b: f64,
    radius: f64,
}

impl Circle {
    /// The cosine that has to be one, and the angle from which it counts.
    ///
    /// ```text
    /// P cos x + Q sin x = W,  P = 2(c1·B + c2·A),  Q = 2(c2·B − c1·A),  W = R² − c1² − c2² − A² − B²
    /// ```
    fn cosine(&self) -> (f64, f64) {
        let Self { c1, c2, a, b, radius } = *self;
        let (p, q) = (2.0 * (c1 * b + c2 * a), 2.0 * (c2 * b - c1 * a));
        let w = radius * radius - c1 * c1 - c2 * c2 - a * a - b * b;
        (w / p.hypot(q), q.atan2(p))
    }

    /// x = atan2(Q, P) + acos(W/√(P² + Q²)), between −π and π; the other root puts the leg over the head.
    fn angle(&self, cosine: f64) -> f64 {
        let (_, from) = self.cosine();
        let x = from + cosine.acos();
        x - TAU * ((x + PI) / TAU).floor()
    }

    fn point(&self, x: f64) -> [f64; 2] {
        let (sin, cos) = x.sin_cos();
        [self.c1 - self.a * sin + self.b * cos, self.c2 + self.a * cos + self.b * sin]
    }
}

/// Height of the hip over a straight leg of pitch x on its ball, by which (8.2) is meant for real feet:
///
/// ```text
/// (L₁ + L₂ + ty) cos x + tz sin x + s
/// ```
pub(super) fn hip_over_ball(p: &Proportions, x: f64) -> f64 {
    (p.leg() + p.ball_below) * x.cos() + p.ball_ahead * x.sin() + p.ball_height
}

/// Phase 1: heel strike of one straight leg, the other straight on its ball, (8.4) and (8.5).
fn heel_strike(p: &Proportions, q: &FiveParameters) -> Circle {
    let (sin, cos) = q.tilt.sin_cos();
    let rotation = 3.0 * q.rotation / 5.0;
    Circle {
        c1: q.step_length - p.heel_behind - p.ball_ahead - p.hips * cos * rotation.sin(),
        c2: p.ball_height + p.hips * sin,
        a: p.leg() + p.ball_below,
        b: p.ball_ahead,
        radius: (p.leg() + p.ankle_height).hypot(p.heel_behind),
    }
}

/// Forward pitch of the straight leg on its heel, whose hip is at `point` from it.
fn pitch_on_heel(p: &Proportions, point: [f64; 2]) -> f64 {
    point[0].atan2(point[1]) + p.heel_behind.atan2(p.leg() + p.ankle_height)
}

/// α and β of phase 1; none where the step is out of reach.
pub(super) fn strike_angles(p: &Proportions, q: &FiveParameters) -> Option<(f64, f64)> {
    let circle = heel_strike(p, q);
    let (cosine, _) = circle.cosine();
    (cosine.abs() < 1.0).then(|| {
        let beta = circle.angle(cosine);
        (pitch_on_heel(p, circle.point(beta)), beta)
    })
}

/// Phase 2: lift-off on the tip, the other foot flat under a vertical shank: (8.8), and that the tip has stayed:
///
/// ```text
/// L₁ sin ξ + L₁ sin φ + (L₂ + h) sin ω + F(1 − cos ω) = S,  F = tz + toe
/// ```
///
/// The pelvis is square to the path here.
fn lift_off(p: &Proportions, q: &FiveParameters) -> Circle {
    let shank = p.shank + p.ankle_height;
    let (sin, cos) = q.thigh_lift_off.sin_cos();
    Circle {
        c1: q.step_length - p.forefoot() - p.thigh * sin,
        c2: -shank + p.thigh * cos + p.hips * (0.4 * q.tilt).sin(),
        a: shank,
        b: p.forefoot(),
        radius: p.thigh,
    }
}

/// Phase 3: height of the hip over the swinging leg, by (8.9), whose lowest point, tip or heel, is at the clearance:
///
/// ```text
/// L₁ cos κ + (L₂ + h) cos ε + max(0, F sin ε, −hz sin ε) + d
/// ```
pub(super) fn hip_over_swing(p: &Proportions, q: &FiveParameters, epsilon: f64) -> f64 {
    let (sin, cos) = epsilon.sin_cos();
    let lowest = (p.forefoot() * sin).max(-p.heel_behind * sin).max(0.0);
    p.thigh * q.thigh_swing.cos() + (p.shank + p.ankle_height) * cos + lowest + q.clearance
}

/// Conditions as they are met.
#[derive(Default)]
struct List(Vec<Condition>);

impl List {
    /// Whether it holds.
    fn meet(&mut self, condition: Condition) -> bool {
        let holds = condition.holds();
        self.0.push(condition);
        holds
    }

    /// Whether an angle is above 0° and below 90°.
    fn acute(&mut self, name: &'static str, [above, below]: [&'static str; 2], angle: f64) -> bool {
        self.meet(angles(name, above, 0.0, angle)) & self.meet(angles(name, below, angle, FRAC_PI_2))
    }

    /// χ: (8.14), both hips level.
    fn landing(&mut self, p: &Proportions, q: &FiveParameters) -> Option<f64> {
        let sole = p.shank + p.ankle_height + q.landing_height;
        let cos = (hip_over_ball(p, q.heel_strike_angle) - sole) / p.thigh;
        let text = "|cos χ| < 1: the leg that lands reaches its height";
        self.meet(cosine("χ (8.14)", text, cos)).then(|| cos.acos())
    }

    /// α and β: (8.4) and (8.5).
    fn strike(&mut self, p: &Proportions, q: &FiveParameters) -> Option<(f64, f64)> {
        let (cos, _) = heel_strike(p, q).cosine();
        self.meet(cosine("β (8.4, 8.5)", "|cos| < 1: both straight legs reach the ground", cos));
        strike_angles(p, q)
    }

    /// ω and ξ: (8.8) and the tip that stays.
    fn leave(&mut self, p: &Proportions, q: &FiveParameters) -> Option<(f64, f64)> {
        let (cos, _) = lift_off(p, q).cosine();
        self.meet(cosine("ω (8.8)", "|cos| < 1: the foot that leaves reaches its tip", cos));
        lift_off_pitch(p, q).map(|omega| {
            let [x, z] = lift_off(p, q).point(omega);
            (omega, x.atan2(z))
        })
    }

    /// ψ and μ, the standing knee of phase 3: (8.11), as an equation.
    fn pass(&mut self, p: &Proportions, q: &FiveParameters, epsilon: f64) -> Option<(f64, f64)> {
        let m = hip_over_swing(p, q, epsilon) - p.ankle_height;
        let cos = (m * m + p.shank * p.shank - p.thigh * p.thigh) / (2.0 * m * p.shank);
        let text = "|cos ψ| < 1: the standing leg is as high as the swinging one needs it";
        let above =
            Condition {
                name: "ψ (8.11)", text: "the hip is above the ankle", sides: [0.0, m], symbol: " m"
            };
        (self.meet(above) & self.meet(cosine("ψ (8.11)", text, cos))).then(|| {
            let psi = cos.acos();
            (psi, (p.shank * psi.sin()).atan2(m - p.shank * psi.cos()))
        })
    }
}

/// The angles, as far as they exist, and all conditions that have numbers.
pub(super) fn build(p: &Proportions, q: &FiveParameters) -> (Option<FiveAngles>, Vec<Condition>) {
    let mut list = List::default();
    let chi = list.landing(p, q);
    let strike = list.strike(p, q);
    let leave = list.leave(p, q);
    let mut pass = None;
    if let Some((omega, xi)) = leave
        && list.acute("lift-off", ["ω > 0°", "ω < 90°"], omega)
            & list.acute("lift-off", ["ξ > 0°", "ξ < 90°"], xi)
    {
        let epsilon = omega - q.thigh_swing - q.thigh_lift_off;
        pass = list.pass(p, q, epsilon).map(|(psi, mu)| (epsilon, psi, mu));
    }
    if let Some((alpha, beta)) = strike {
        if let Some(chi) = chi {
            list.meet(angles("(i)", "α > χ", chi, alpha));
        }
        list.meet(angles("(ii′)", "β > θ", q.heel_strike_angle, beta));
        list.meet(angles("heel strike", "α < 90°", alpha, FRAC_PI_2));
        list.meet(angles("heel strike", "β < 90°", beta, FRAC_PI_2));
        if let Some((_, xi)) = leave {
            list.meet(angles("(iii)", "ξ > α", alpha, xi));
        }
    }
    if let Some((omega, _)) = leave {
        list.meet(angles("(v)", "ω > φ", q.thigh_lift_off, omega));
    }
    let all = (|| {
        let ((alpha, beta), (omega, xi), (epsilon, psi, mu)) = (strike?, leave?, pass?);
        Some(FiveAngles { parameters: *q, alpha, beta, chi: chi?, omega, xi, epsilon, psi, mu })
    })();
    (all, list.0)
}

/// The angles of a set of parameters, or the conditions that fail, the first first.
///
/// This is [`solve`] without looking for feasible values: a microsecond.
///
/// # Errors
///
/// The failing conditions; of numbers that are none, too.
pub fn close(p: &Proportions, parameters: &FiveParameters) -> Result<FiveAngles, Vec<Condition>> {
    let (all, mut list) = build(p, parameters);
    list.retain(|condition| !condition.holds());
    match all {
        Some(angles) if list.is_empty() => Ok(angles),
        _ => Err(list),
    }
}

/// The angles of a set of parameters.
///
/// ```text
/// χ:    (a+ty) cos θ + tz sin θ + s = L₁ cos χ + L₂ + h + p
/// α, β: (a+h) cos α + hz sin α = (a+ty) cos β + tz sin β + s + L sin δ
///       (a+h) sin α − hz cos α + (a+ty) sin β − tz cos β + hz + tz + L cos δ sin 3τ/5 = S
/// ω, ξ: L₁ cos ξ + L₂ + h = L₁ cos φ + (L₂+h) cos ω + F sin ω + L sin 2δ/5
///       L₁ sin ξ + L₁ sin φ + (L₂+h) sin ω + F(1 − cos ω) = S
/// ψ, μ: L₁ cos μ + L₂ cos ψ + h = L₁ cos κ + (L₂+h) cos ε + max(0, F sin ε, −hz sin ε) + d
///       L₁ sin μ = L₂ sin ψ,  ε = ω − κ − φ
/// ```
///
/// with a = L₁ + L₂, F = tz + toe, and of the foot h the ankle's height, hz the heel behind it, tz and ty the ball ahead of
/// it and below, s the ball's height.
///
/// # Source
///
/// Vasilonikolidakis (1991), (8.1)–(8.14). For a foot without height and heel these are its equations with `L sin(2δ/5)` in
/// (8.8), where `cos` is printed; `L₃(1 − cos β)` and 3τ/5 in (8.5), where `L₃ tan β sin β` and 2τ/5 are; and the second of
/// ω and ξ, which is missing: without it the toes slide by half a metre. Tables 8.4 and 8.5 are not needed.
///
/// # Errors
///
/// A value out of its range, and parameters that have no postures.
pub fn solve(p: &Proportions, parameters: &FiveParameters) -> Result<FiveAngles, GaitError> {
    parameters.check(p)?;
    close(p, parameters).map_err(|fails| {
        let values = parameters.values();
        let feasible = |values: &[f64]| {
            let values = values.try_into().expect("eight parameters");
            close(p, &FiveParameters::from_values(values)).is_ok()
        };
        infeasible(Infeasible::new(fails, &parameters_of(p), &values, feasible))
    })
}

pub(super) fn infeasible(why: Infeasible) -> GaitError {
    PostureError::Infeasible { determinants: "five", why: Box::new(why) }.into()
}

/// ω of phase 2; none where the tip is out of reach.
pub(super) fn lift_off_pitch(p: &Proportions, q: &FiveParameters) -> Option<f64> {
    let circle = lift_off(p, q);
    let (cosine, _) = circle.cosine();
    (cosine.abs() < 1.0).then(|| circle.angle(cosine))
}
