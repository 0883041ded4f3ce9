//! The heights that all of chapter 7 hangs on: of the hip on the stance leg, and of the leg that lifts.

use crate::thesis::determinants::Proportions;
use std::f64::consts::FRAC_PI_2;

/// Angle of the straight legs at the end of phase 2 against the vertical: `sin α = S / 2(L₁ + L₂)`, (7.6); NaN where the step
/// is longer than both legs.
pub(super) fn alpha(p: &Proportions, step_length: f64) -> f64 {
    (step_length / (2.0 * p.leg())).asin()
}

/// Angle of the stance thigh at mid-stance: `L₁ sin ξ = L₂ sin χ`, so that the hip is above the ankle.
pub(super) fn xi(p: &Proportions, flexion: f64) -> f64 {
    (p.shank * flexion.sin() / p.thigh).asin()
}

/// Hip above the stance ankle at mid-stance (M):
///
/// ```text
/// M = √(L₁² − L₂² sin²χ) + L₂ cos χ
/// ```
pub(super) fn stance_height(p: &Proportions, flexion: f64) -> f64 {
    let (sin, cos) = flexion.sin_cos();
    (p.thigh * p.thigh - (p.shank * sin).powi(2)).sqrt() + p.shank * cos
}

/// The largest flexion that has a hip above the ankle: 90°, or `asin(L₁/L₂)` of a shank longer than the thigh.
pub(super) fn largest_flexion(p: &Proportions) -> f64 {
    if p.shank > p.thigh { (p.thigh / p.shank).asin() } else { FRAC_PI_2 }
}

/// The flexion that puts the hip this far above the ankle, 0 where it is above a straight leg's and
/// [`largest_flexion()`] where it is too low:
///
/// ```text
/// cos χ = (M² + L₂² − L₁²) / 2 M L₂
/// ```
pub(super) fn flexion_for(p: &Proportions, height: f64) -> f64 {
    let largest = largest_flexion(p);
    if height >= p.leg() {
        0.0
    } else if height <= stance_height(p, largest).max(0.0) {
        largest
    } else {
        let cosine = (height * height + p.shank * p.shank - p.thigh * p.thigh) / (2.0 * height * p.shank);
        cosine.clamp(-1.0, 1.0).acos().min(largest)
    }
}

/// How much higher the swing leg's hip is above its ball than the stance leg's above its ankle, with a level pelvis.
pub(super) fn foot_rise(p: &Proportions) -> f64 {
    p.ankle_height - p.ball_height
}

/// The leg that lifts, from its hip down to its ball: a foot at right angles to its shank makes the shank longer by the ball's
/// depth, and reaches on by L₃.
///
/// ```text
/// D = M + h_a − L sin δ − h_ball        L₁ cos ω + g(φ) = D
/// g(φ) = (L₂ + ball below) cos φ + L₃ sin φ = R cos(φ − γ)
/// ```
///
/// The same holds for θ₁ and θ₃ of the starting cycle: (7.1) to (7.3) and (7.5), corrected (G1 of `docs/sources.md`).
#[derive(Clone, Copy, Debug)]
pub(super) struct LiftingLeg {
    /// L₁.
    pub(super) thigh: f64,
    /// L₂ and the ball below the ankle.
    pub(super) shank: f64,
    /// L₃.
    pub(super) foot: f64,
}

impl LiftingLeg {
    pub(super) fn of(p: &Proportions) -> Self {
        Self { thigh: p.thigh, shank: p.shank + p.ball_below, foot: p.ball_ahead }
    }

    /// `R`.
    pub(super) fn radius(&self) -> f64 {
        self.shank.hypot(self.foot)
    }

    /// `γ = atan(L₃ / L₂)`.
    pub(super) fn gamma(&self) -> f64 {
        self.foot.atan2(self.shank)
    }

    /// `g`: how far the ball is below the knee.
    pub(super) fn below_knee(&self, shank: f64) -> f64 {
        self.shank * shank.cos() + self.foot * shank.sin()
    }

    /// The thigh's angle for the shank's; NaN where the leg is too short.
    pub(super) fn thigh_for(&self, height: f64, shank: f64) -> f64 {
        let cosine = (height - self.below_knee(shank)) / self.thigh;
        cosine.max(-1.0).acos()
    }

    /// The shank's angle for the thigh's, of the two the one past γ: `γ + acos((D − L₁ cos ω) / R)`.
    pub(super) fn shank_for(&self, height: f64, thigh: f64) -> f64 {
        let cosine = (height - self.thigh * thigh.cos()) / self.radius();
        self.gamma() + cosine.clamp(-1.0, 1.0).acos()
    }

    /// The thigh's angle at which the rest is this far below the knee; 0 where none is small enough.
    pub(super) fn thigh_at(&self, height: f64, below_knee: f64) -> f64 {
        ((height - below_knee) / self.thigh).clamp(-1.0, 1.0).acos()
    }

    /// The lowest D that (ii) allows: `L₃ + L₁ cos α`, where the foot stands upright.
    pub(super) fn lowest(&self, alpha: f64) -> f64 {
        self.foot + self.thigh * alpha.cos()
    }

    /// The highest D that (iii) and (iv) allow together: `L₁ cos α + g(max(α, γ))`.
    pub(super) fn highest(&self, alpha: f64) -> f64 {
        self.thigh * alpha.cos() + self.below_knee(alpha.max(self.gamma()))
    }

    /// The largest ω: where thigh and shank are in line, or where the shank is at γ if that is first.
    ///
    /// ```text
    /// ω_max = γ' + acos(D / R')     γ' = atan(L₃ / (L₁ + L₂)),  R' = √((L₁ + L₂)² + L₃²)
    /// ```
    pub(super) fn largest_omega(&self, height: f64) -> f64 {
        let (along, ahead) = (self.thigh + self.shank, self.foot);
        let straight = ahead.atan2(along) + (height / along.hypot(ahead)).clamp(-1.0, 1.0).acos();
        if straight >= self.gamma() { straight } else { self.thigh_at(height, self.radius()) }
    }
}

/// The height D of a posture.
pub(super) fn lift_off_height(p: &Proportions, tilt: f64, flexion: f64) -> f64 {
    stance_height(p, flexion) + foot_rise(p) - p.hips * tilt.sin()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_flexion_and_its_height_are_inverse() {
        let longer_shank = Proportions { thigh: 0.4, shank: 0.5, ..Proportions::FIT };
        for p in [Proportions::FIT, longer_shank] {
            for degrees in [0.0_f64, 3.0, 22.0, 52.0] {
                let flexion = degrees.to_radians();
                assert_relative_eq!(flexion_for(&p, stance_height(&p, flexion)), flexion, epsilon = 1e-7);
            }
        }
        assert_relative_eq!(flexion_for(&longer_shank, 0.1), 0.8_f64.asin(), epsilon = 1e-12);
        assert_relative_eq!(flexion_for(&longer_shank, 2.0), 0.0, epsilon = 1e-12);
    }

    #[test]
    fn the_shank_past_gamma_keeps_the_height() {
        let leg = LiftingLeg::of(&Proportions::FIT);
        assert_relative_eq!(leg.gamma().to_degrees(), 19.399, epsilon = 1e-3);
        for thigh in [0.3, 0.5, 0.7] {
            let shank = leg.shank_for(0.9, thigh);
            assert!(shank > leg.gamma());
            assert_relative_eq!(leg.thigh_for(0.9, shank), thigh, epsilon = 1e-12);
        }
        let omega = leg.largest_omega(0.9);
        assert_relative_eq!(leg.shank_for(0.9, omega), omega, epsilon = 1e-12);
    }
}
