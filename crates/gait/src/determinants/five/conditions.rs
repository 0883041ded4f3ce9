//! What postures of five determinants have to obey, and what is only remarked on.

use super::super::condition::Condition;
use super::super::proportions::Proportions;
use super::arms::ArmCoefficients;
use super::closed::{FiveAngles, build};
use super::parameters::FiveParameters;

/// `lesser < greater`, of angles in rad.
pub(super) fn angles(name: &'static str, text: &'static str, lesser: f64, greater: f64) -> Condition {
    Condition { name, text, sides: [lesser.to_degrees(), greater.to_degrees()], symbol: "°" }
}

/// `|cosine| < 1`.
pub(super) fn cosine(name: &'static str, text: &'static str, cosine: f64) -> Condition {
    Condition { name, text, sides: [cosine.abs(), 1.0], symbol: "" }
}

/// All conditions that can be put in numbers, those that hold too, in the order in which they are met.
///
/// What has no number because an angle before it does not exist is left out.
///
/// | name | condition | source |
/// |---|---|---|
/// | `χ (8.14)`, `β (8.4, 8.5)`, `ω (8.8)`, `ψ (8.11)` | the cosine exists | domains |
/// | `lift-off` | ω and ξ between 0° and 90° | domains |
/// | `heel strike` | α and β below 90° | domains |
/// | `(i)` | α > χ: the leg stretches forward before it lands | §8.5 |
/// | `(ii′)` | β > θ: the heel goes on rising | §8.5 has the contrary, which (i) excludes |
/// | `(iii)` | ξ > α: the knee begins to flex | §8.5 |
/// | `(v)` | ω > φ: the knee that lifts off is flexed | §8.5 |
pub fn conditions(p: &Proportions, parameters: &FiveParameters) -> Vec<Condition> {
    build(p, parameters).1
}

/// The thesis's conditions (iv) φ > β and (vi) χ > κ, in numbers.
///
/// Nothing breaks where they fail. With (iv) the swinging knee can flex by 15° at most, where people's flexes by about 60°;
/// with (vi) the thigh may not swing past its place at landing, as people's does.
pub fn remarks(angles_: &FiveAngles) -> Vec<Condition> {
    let q = &angles_.parameters;
    vec![
        angles("(iv)", "φ > β", angles_.beta, q.thigh_lift_off),
        angles("(vi)", "χ > κ", q.thigh_swing, angles_.chi),
    ]
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
