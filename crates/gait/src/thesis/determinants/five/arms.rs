//! Coordination of the arms with the legs.

use super::super::posture::ArmAngles;
use super::closed::FiveAngles;
use super::sides::angles;
use crate::condition::Condition;

/// Parts of the legs' angles that the arms take over, one for each phase (k₁…k₄, from 0 to 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmCoefficients {
    /// k₁, k₂, k₃ and k₄.
    pub k: [f64; 4],
}

/// Part of its upper bound that an automatic coefficient takes.
const PART: f64 = 0.9;

impl ArmCoefficients {
    /// The arms' targets α₁…α₁₂ (rad):
    ///
    /// ```text
    /// α₁ = k₁α   α₂ = k₁β    α₃ = k₁β
    /// α₄ = k₂ξ   α₅ = k₂φ    α₆ = k₂ω
    /// α₇ = k₃κ   α₈ = k₃μ    α₉ = k₃ψ
    /// α₁₀ = k₄χ  α₁₁ = k₄χ   α₁₂ = k₄θ
    /// ```
    ///
    /// # Source
    ///
    /// Vasilonikolidakis (1991), (8.28).
    pub fn targets(&self, angles: &FiveAngles) -> [f64; 12] {
        let [k1, k2, k3, k4] = self.k;
        let (a, q) = (angles, &angles.parameters);
        [
            k1 * a.alpha,
            k1 * a.beta,
            k1 * a.beta,
            k2 * a.xi,
            k2 * q.thigh_lift_off,
            k2 * a.omega,
            k3 * q.thigh_swing,
            k3 * a.mu,
            k3 * a.psi,
            k4 * a.chi,
            k4 * a.chi,
            k4 * q.heel_strike_angle,
        ]
    }

    /// Coefficients that keep all nine conditions of the arms, see [`arm_remarks`]; none where there are none.
    ///
    /// ```text
    /// k₄ = 1
    /// k₁ between k₄χ/β and min(1, k₄θ/α): in the middle
    /// k₂ = 0.9·k₁·min(α/ξ, β/φ, β/ω)
    /// k₃ = 0.9·k₂·min(ξ/κ, φ/μ, ω/ψ)
    /// ```
    ///
    /// There are such coefficients where αχ < βθ and φ > 0, and only there.
    pub fn automatic(angles: &FiveAngles) -> Option<Self> {
        let q = &angles.parameters;
        let k1 = middle(angles);
        let k2 = bounded(
            k1,
            [(angles.alpha, angles.xi), (angles.beta, q.thigh_lift_off), (angles.beta, angles.omega)],
        );
        let k3 = bounded(
            k2,
            [(angles.xi, q.thigh_swing), (q.thigh_lift_off, angles.mu), (angles.omega, angles.psi)],
        );
        let found = Self { k: [k1, k2, k3, 1.0] };
        let within = found.k.iter().all(|k| (0.0..=1.0).contains(k));
        (within && arm_remarks(angles, &found).iter().all(super::super::Condition::holds)).then_some(found)
    }

    /// [`ArmCoefficients::automatic`], or where there are none, k₁ and k₂ as there and k₃ = k₂/3: the arms then swing
    /// forward with a thigh that does not go back (φ ≤ 0), against the second condition of phase 3.
    pub fn nearest(angles: &FiveAngles) -> Self {
        Self::automatic(angles).unwrap_or_else(|| {
            let k1 = middle(angles).clamp(0.0, 1.0);
            let k2 = bounded(k1, [(angles.alpha, angles.xi), (angles.beta, angles.omega), (1.0, 0.0)])
                .clamp(0.0, 1.0);
            Self { k: [k1, k2, k2 / 3.0, 1.0] }
        })
    }

    /// The arms at the end of phases 0 (which is 4 of the step before, the legs' parts exchanged) to 4: those of the stance
    /// and of the swing leg's side. An arm goes against the leg of its side, and forward with a flexed elbow.
    pub(super) fn at(&self, angles: &FiveAngles, phase: usize) -> [ArmAngles; 2] {
        let [a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12] = self.targets(angles);
        let [stance, swing] = match phase {
            0 => [[-a12, 0.0], [a10, a11]],
            1 => [[-a1, 0.0], [a2, a3]],
            2 => [[-a4, 0.0], [a5, a6]],
            3 => [[-a7, 0.0], [a8, a9]],
            _ => [[a10, a11], [-a12, 0.0]],
        };
        [stance, swing].map(|[shoulder, elbow]| ArmAngles { shoulder, elbow })
    }
}

fn middle(angles: &FiveAngles) -> f64 {
    let least = angles.chi / angles.beta;
    let most = angles.parameters.heel_strike_angle / angles.alpha;
    0.5 * (least + if most < 1.0 { most } else { 1.0 })
}

/// A part of k that keeps `next·of < k·from` for pairs of `from` and `of`.
fn bounded(k: f64, pairs: [(f64, f64); 3]) -> f64 {
    // An angle that is not positive asks nothing of it.
    let bounds = pairs.map(|(from, of)| if of > 0.0 { from / of } else { f64::INFINITY });
    (PART * k * bounds.iter().copied().fold(f64::INFINITY, f64::min)).min(PART)
}

/// The nine conditions of the arms (§8.7), in numbers. The thesis asks for k's between 0 and 1 besides.
///
/// The first of phase 2 is printed α₁₁ − α₄ > 0; the arm that it is about comes from α₁.
pub fn arm_remarks(angles_: &FiveAngles, k: &ArmCoefficients) -> Vec<Condition> {
    let [a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12] = k.targets(angles_);
    vec![
        angles("phase 1, 1", "α₁₂ > α₁", a1, a12),
        angles("phase 1, 2", "α₂ > α₁₀", a10, a2),
        angles("phase 1, 3", "α₃ > α₁₁", a11, a3),
        angles("phase 2, 1", "α₁ > α₄", a4, a1),
        angles("phase 2, 2", "α₂ > α₅", a5, a2),
        angles("phase 2, 3", "α₃ > α₆", a6, a3),
        angles("phase 3, 1", "α₄ > α₇", a7, a4),
        angles("phase 3, 2", "α₅ > α₈", a8, a5),
        angles("phase 3, 3", "α₆ > α₉", a9, a6),
    ]
}
