//! Movements of the trunk.

use super::super::posture::TrunkAngles;

/// Base of the neck over the pelvis, by height: the lower trunk's and the upper trunk's part.
pub const NECK: [f64; 2] = [0.10, 0.188];

/// Amplitudes of the trunk's movements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrunkAmplitudes {
    /// How much higher the neck is at the end of phase 3 than of phase 1 (Vd, m).
    pub rise: f64,
    /// Side bend of the trunk about the pelvis (ν, rad).
    pub pelvis_bend: f64,
    /// Side bend of the upper against the lower trunk (γ, rad).
    pub torso_bend: f64,
    /// Lean forward and backward (ζ, rad).
    pub lean: f64,
}

/// Speed by the thesis's law (m/s), for a height (m) and a step frequency (steps/min): `V_f = 0.004·H·sf²/60`.
///
/// # Source
///
/// Vasilonikolidakis (1991), (8.30), without whose missing 60 it is 8470 cm/s at 110 steps/min.
pub fn thesis_speed(height: f64, step_frequency: f64) -> f64 {
    0.004 * height * step_frequency * step_frequency / 60.0
}

impl TrunkAmplitudes {
    /// The amplitudes at a speed (m/s).
    ///
    /// ```text
    /// Vd = max(0, −0.00012·V² + 0.068·V − 2.8)  cm
    /// ν  = max(0, −0.00005·V² + 0.035·V − 1.0)  °     V in cm/s
    /// γ  = 8°,  ζ = 3°
    /// ```
    ///
    /// # Source
    ///
    /// Vasilonikolidakis (1991), (8.29) and (8.31), fitted to Thorstensson's adults; nothing is said about other sizes. Vd is
    /// from the lowest to the highest, though "±Vd" is printed: twice as much cannot be walked above 80 steps/min. Below
    /// 0.447 and 0.298 m/s the fits are negative, hence the clamps. Vd falls again above 2.83 m/s.
    pub fn at_speed(speed: f64) -> Self {
        let v = 100.0 * speed;
        let rise = (-0.000_12 * v * v + 0.068 * v - 2.8).max(0.0) / 100.0;
        let bend = (-0.000_05 * v * v + 0.035 * v - 1.0).max(0.0);
        Self {
            rise,
            pelvis_bend: bend.to_radians(),
            torso_bend: 8.0_f64.to_radians(),
            lean: 3.0_f64.to_radians(),
        }
    }

    /// Height of the neck over the pelvis for parts of the amplitudes N of ν, G of γ and Z of ζ, in the unit of the height:
    ///
    /// ```text
    /// cos Zζ · (t₁ cos Nν + t₂ cos(Nν + Gγ))
    /// ```
    pub(super) fn neck(&self, height: f64, [n, g, z]: [f64; 3]) -> f64 {
        let bend = n * self.pelvis_bend;
        let upper = bend + g * self.torso_bend;
        height * (z * self.lean).cos() * (NECK[0] * bend.cos() + NECK[1] * upper.cos())
    }

    /// The trunk at the end of phases 0 to 4.
    ///
    /// The parts of table 8.7: ν 3/5, 1/5, −1, −1, −3/5 and γ −1, 1/5, 3/5, 1, 1, half an oscillation a step each, ζ 0, 1, 0,
    /// −1, 0. The text puts ν's positive side at the swing leg and γ's at the stance leg.
    pub(super) fn at(&self, phase: usize) -> TrunkAngles {
        let [n, g, z] = PARTS[phase];
        TrunkAngles {
            pelvis_bend: -n * self.pelvis_bend,
            torso_bend: g * self.torso_bend,
            lean: z * self.lean,
        }
    }
}

/// Parts of ν, γ and ζ at the ends of phases 0 to 4.
pub(super) const PARTS: [[f64; 3]; 5] =
    [[0.6, -1.0, 0.0], [0.2, 0.2, 1.0], [-1.0, 0.6, 0.0], [-1.0, 1.0, -1.0], [-0.6, 1.0, 0.0]];
