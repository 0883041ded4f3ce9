//! Conditions that postures of five determinants have to obey, and those that are only remarked on.

use super::super::proportions::Proportions;
use super::closed::{FiveAngles, build};
use super::parameters::FiveParameters;
use super::sides::angles;
use crate::condition::Condition;

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
