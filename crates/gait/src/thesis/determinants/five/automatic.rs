//! Parameters for a body, a step frequency and a step length, by closed forms.

use super::super::proportions::Proportions;
use super::closed::{close, solve, strike_angles};
use super::parameters::{FiveParameters, HEIGHT, check_proportions, check_range};
use super::rise::swing_for;
use crate::error::GaitError;

/// Step lengths by height that automatic parameters are made for.
pub const AUTOMATIC_STEP: (f64, f64) = (0.18, 0.6);

/// Step frequencies that they are made for (steps/min): those that have a double support by the thesis's law.
const FREQUENCIES: (f64, f64) = (30.0, 181.75);

/// Pelvic tilt (°) over step length by height: people's at usual steps, and none at shorter ones, where a tilt would have the
/// foot land behind the hip.
const TILT: [[f64; 2]; 7] =
    [[0.18, 0.0], [0.24, 2.2], [0.30, 3.0], [0.38, 3.5], [0.44, 4.0], [0.48, 4.5], [0.52, 5.0]];
/// Pelvic rotation (°).
const ROTATION: [[f64; 2]; 6] =
    [[0.18, 2.0], [0.32, 3.0], [0.38, 4.0], [0.44, 5.0], [0.48, 6.0], [0.52, 8.0]];
/// ξ − α (°): what the standing thigh rises by as the foot comes flat, the room of (iii).
const RISE: [[f64; 2]; 7] =
    [[0.18, 0.6], [0.32, 0.9], [0.38, 4.3], [0.44, 8.1], [0.48, 10.7], [0.52, 13.3], [0.6, 19.0]];
/// p by height.
const LANDING: [[f64; 2]; 3] = [[0.18, 0.004], [0.32, 0.0057], [0.52, 0.0157]];
/// Room of (i), α − χ (°), and the greatest part of α that it takes.
const STRETCH: (f64, f64) = (1.2, 0.3);
/// ψ (°): with μ, the standing knee is flexed by twice that in the middle of the stance, at any speed.
const FLEXION: f64 = 6.3;

fn over(table: &[[f64; 2]], x: f64) -> f64 {
    let mut value = table[0][1];
    for pair in table.windows(2) {
        let [[x0, y0], [x1, y1]] = [pair[0], pair[1]];
        if x > x0 {
            value = y0 + (y1 - y0) * ((x - x0) / (x1 - x0)).min(1.0);
        }
    }
    value
}

impl FiveParameters {
    /// Parameters for a body, a step frequency (steps/min) and a step length: a choice inside the bounds of all conditions,
    /// by closed forms.
    ///
    /// 1. δ and τ from the step length by the height, as in [`super::Family::Retracting`]; α and β follow.
    /// 2. (i) by construction: χ = α − min(1.2°, 0.3·α). With p by the height, (8.14) is an equation for θ:
    ///    `θ = atan2(B, A) + acos((L₁ cos χ + L₂ + h + p − s)/√(A² + B²))`, A = L₁ + L₂ + ty, B = tz, which p keeps in reach
    ///    with a tenth to spare.
    /// 3. (iii) by construction: ξ = α + 0.6° to 19°. That puts the hip, and φ and ω are those of the two bones, thigh and
    ///    ankle-to-tip, from there to the tip that stays; the knee that flexes forward is (v).
    /// 4. d = 15 mm for 1.75 m; ψ = 6.3°, μ by it, and κ by (8.11), as in [`FiveParameters::with_trunk_rise`].
    ///
    /// People of 1.2 to 2.0 m, with real feet and with the thesis's, close at all of these step lengths. From 60 to 130
    /// steps/min, at step lengths of 0.0037 and 0.004·H·sf give or take 12 %, there are left at least 0.36° of (i), 3.7° of
    /// (ii′), 0.63° of (iii) and 44° of (v), the least where steps are shortest. Below 0.30 of the height (0.28 with the
    /// thesis's feet) φ is not positive and arms cannot keep their conditions.
    ///
    /// # Errors
    ///
    /// A value out of range: step frequencies of 30 to 181.75 steps/min, step lengths of 0.18 to 0.6 of the height. The step
    /// frequency decides nothing else here. A body whose proportions do not close, as [`solve`] says it.
    pub fn automatic(p: &Proportions, step_frequency: f64, step_length: f64) -> Result<Self, GaitError> {
        check_proportions(p)?;
        check_range("step frequency", step_frequency, " steps/min", FREQUENCIES, "")?;
        let (lower, upper) = AUTOMATIC_STEP;
        let why = "; what is shorter lands behind the hip, and what is longer folds the standing knee";
        check_range("step length", step_length, " m", (lower * p.height, upper * p.height), why)?;
        let chosen = choose(p, step_length);
        if close(p, &chosen).is_err() {
            solve(p, &chosen)?;
        }
        Ok(chosen)
    }
}

/// The choice; where a bound cannot be kept, the nearest to it that is a number, for [`solve`] to say what fails.
fn choose(p: &Proportions, step_length: f64) -> FiveParameters {
    let part = step_length / p.height;
    let mut q = FiveParameters {
        step_length,
        heel_strike_angle: 0.0,
        tilt: over(&TILT, part).to_radians(),
        thigh_lift_off: 0.0,
        thigh_swing: 0.5,
        rotation: over(&ROTATION, part).to_radians(),
        clearance: 0.015 / HEIGHT * p.height,
        landing_height: over(&LANDING, part) * p.height,
    };
    let (alpha, _) = strike_angles(p, &q).unwrap_or((0.0, 0.0));
    // θ and p: (8.14).
    let chi = alpha - STRETCH.0.to_radians().min(STRETCH.1 * alpha.abs());
    let (a, b) = (p.leg() + p.ball_below, p.ball_ahead);
    let sole = p.thigh * chi.cos() + p.shank + p.ankle_height - p.ball_height;
    q.landing_height = q.landing_height.min(0.9 * (a.hypot(b) - sole)).max(0.0);
    q.heel_strike_angle = b.atan2(a) + ((sole + q.landing_height) / a.hypot(b)).min(1.0).acos();
    // φ and ω: from hip to tip by two bones.
    let shank = p.shank + p.ankle_height;
    let xi = alpha + over(&RISE, part).to_radians();
    let ahead = step_length - p.forefoot() - p.thigh * xi.sin();
    let above = p.thigh * xi.cos() + shank - p.hips * (0.4 * q.tilt).sin();
    let (lower, foot) = (shank.hypot(p.forefoot()), p.forefoot().atan2(shank));
    let cos = (ahead * ahead + above * above - p.thigh * p.thigh - lower * lower) / (2.0 * p.thigh * lower);
    let bend = cos.clamp(-1.0, 1.0).acos();
    q.thigh_lift_off = ahead.atan2(above) - (lower * bend.sin()).atan2(p.thigh + lower * bend.cos());
    let omega = q.thigh_lift_off + bend + foot;
    // κ: (8.11), for a chosen flexion of the standing knee.
    let psi = FLEXION.to_radians();
    let mu = (p.shank * psi.sin() / p.thigh).min(1.0).asin();
    let hip = p.thigh * mu.cos() + p.shank * psi.cos() + p.ankle_height;
    swing_for(p, &q, omega, hip).unwrap_or(q)
}
