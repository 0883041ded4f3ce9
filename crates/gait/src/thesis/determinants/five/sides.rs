//! Conditions of angles and of cosines, in the units that people read.

use crate::condition::Condition;

/// `lesser < greater`, of angles in rad.
pub(super) fn angles(name: &'static str, text: &'static str, lesser: f64, greater: f64) -> Condition {
    Condition { name, text, sides: [lesser.to_degrees(), greater.to_degrees()], symbol: "°" }
}

/// `|cosine| < 1`.
pub(super) fn cosine(name: &'static str, text: &'static str, cosine: f64) -> Condition {
    Condition { name, text, sides: [cosine.abs(), 1.0], symbol: "" }
}
