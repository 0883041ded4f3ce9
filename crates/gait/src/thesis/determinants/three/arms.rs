//! The arms, as parts of the legs' angles.

use super::angles::ThreeAngles;
use crate::thesis::determinants::ArmAngles;

/// How much of the legs' angles the arms take over; each from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmCoefficients {
    /// Of the starting cycle's lift-off (k₁).
    pub k1: f64,
    /// Of the stride posture (k₂).
    pub k2: f64,
    /// Of lift-off in the other cycles (k₃).
    pub k3: f64,
}

/// A coefficient that is not from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("arm coefficient {name} is {value}; it must be 0 to 1")]
pub struct ArmRefusal {
    /// Which one.
    pub name: &'static str,
    /// What it is.
    pub value: f64,
}

impl Default for ArmCoefficients {
    /// Half of everything: at 105 steps/min the shoulder swings about 20° either way.
    fn default() -> Self {
        Self { k1: 0.5, k2: 0.5, k3: 0.5 }
    }
}

/// The nine angles of (7.22), rad.
///
/// ```text
/// α₁ = k₁ θ₁          α₂ = k₁ θ₃        α₃ = k₁ χ
/// α₄ = α₁ + k₂ α      α₅ = α₃ + k₂ α
/// α₆ = α₅ − k₃ ω      α₇ = k₃ φ         α₈ = α₅ − k₃ α      α₉ = α₂ − k₃ χ
/// ```
///
/// α₄ and α₈ are printed with β; with 90° − β = α they are the leg's angle against the vertical like all others.
/// An elbow does not bend backwards, so α₉ is 0 at least.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nine([f64; 9]);

impl ArmCoefficients {
    /// Checked.
    ///
    /// # Errors
    ///
    /// A coefficient that is not from 0 to 1.
    pub fn new(k1: f64, k2: f64, k3: f64) -> Result<Self, ArmRefusal> {
        for (name, value) in [("k1", k1), ("k2", k2), ("k3", k3)] {
            if !(0.0..=1.0).contains(&value) {
                return Err(ArmRefusal { name, value });
            }
        }
        Ok(Self { k1, k2, k3 })
    }

    pub(super) fn nine(&self, angles: &ThreeAngles) -> Nine {
        let Self { k1, k2, k3 } = *self;
        let ThreeAngles { alpha, chi, theta1, theta3, omega, phi, .. } = *angles;
        let [a1, a2, a3] = [k1 * theta1, k1 * theta3, k1 * chi];
        let [a4, a5] = [a1 + k2 * alpha, a3 + k2 * alpha];
        Nine([a1, a2, a3, a4, a5, a5 - k3 * omega, k3 * phi, a5 - k3 * alpha, (a2 - k3 * chi).max(0.0)])
    }
}

/// Table 7.6 counts rotations backward; here flexion is forward. Stance and swing side.
impl Nine {
    fn pair(stance: [f64; 2], swing: [f64; 2]) -> [ArmAngles; 2] {
        [stance, swing].map(|[shoulder, elbow]| ArmAngles { shoulder, elbow })
    }

    /// At the lift-off of the starting cycle.
    pub(super) fn first_lift_off(&self) -> [ArmAngles; 2] {
        let [a1, a2, a3, ..] = self.0;
        Self::pair([a1, a2], [-a3, 0.0])
    }

    /// At lift-off in the other cycles.
    pub(super) fn lift_off(&self) -> [ArmAngles; 2] {
        let [.., a6, a7, a8, a9] = self.0;
        Self::pair([-a6, a7], [a8, a9])
    }

    /// When both feet are flat.
    pub(super) fn stride(&self) -> [ArmAngles; 2] {
        let [_, a2, _, a4, a5, ..] = self.0;
        Self::pair([a4, a2], [-a5, 0.0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_from_0_to_1() {
        assert!(ArmCoefficients::new(0.0, 1.0, 0.5).is_ok());
        for bad in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
            let refused = ArmCoefficients::new(0.5, bad, 0.5).expect_err("not from 0 to 1");
            assert_eq!(refused.name, "k2");
        }
        let text = ArmCoefficients::new(0.5, 0.5, 2.0).expect_err("2").to_string();
        assert_eq!(text, "arm coefficient k3 is 2; it must be 0 to 1");
    }
}
