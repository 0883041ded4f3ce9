//! Names of the links, and of the anatomical angles, that a walking figure has.

/// Segments of the middle, parents first.
pub(crate) const MIDDLE: [&str; 5] = ["pelvis", "abdomen", "thorax", "neck", "head"];
/// Segments of an arm, parents first.
pub(crate) const ARM: [&str; 4] = ["clavicle", "upper_arm", "forearm", "hand"];
/// Segments of a leg, parents first.
pub(crate) const LEG: [&str; 4] = ["thigh", "shank", "foot", "toes"];
/// Sides of the body.
pub(crate) const SIDES: [&str; 2] = ["left_", "right_"];
/// Links of the feet, left and right: what touches the ground, with the toes behind it.
pub const FEET: [&str; 2] = ["left_foot", "right_foot"];
/// Link of a cane in a hand.
pub const CANE: &str = "cane";
/// Link on which a seat acts.
pub(crate) const SEATED: &str = MIDDLE[0];
/// Links of the toes, left and right.
pub(crate) const TOES: [&str; 2] = ["left_toes", "right_toes"];

/// The angles of each leg that are measured, after `left_` and `right_`.
pub(crate) const SIDED_ANGLES: [&str; 3] = ["hip.flexion", "knee.flexion", "ankle.dorsiflexion"];
/// The angles of the pelvis that are measured, after `pelvis.`.
pub(crate) const PELVIS_ANGLES: [&str; 3] = ["tilt", "obliquity", "rotation"];
