//! Where a model has its coordinates while nobody says anything else.

use super::DEEPEST;
use super::element::child_words;
use crate::table::CoordinateDefault;
use crate::xml;

/// The coordinates of an OpenSim model of which it says where they are (rad or m), which of them it locks there, and which it
/// keeps within their range; none of a text that is no model.
///
/// # Examples
///
/// ```
/// let text = r#"<OpenSimDocument Version="40000"><Model><JointSet><objects><PinJoint name="mtp"><coordinates>
///   <Coordinate name="mtp_angle"><default_value>0.1</default_value><locked>true</locked></Coordinate>
/// </coordinates></PinJoint></objects></JointSet></Model></OpenSimDocument>"#;
/// let found = solaris_io::opensim::coordinate_defaults(text);
/// assert_eq!((found[0].name.as_str(), found[0].value, found[0].is_locked), ("mtp_angle", 0.1, true));
/// ```
#[doc(alias = "default_value")]
pub fn coordinate_defaults(text: &str) -> Vec<CoordinateDefault> {
    let Ok(document) = xml::parse(text, DEEPEST) else { return Vec::new() };
    let nodes = document.descendants().filter(|node| node.has_tag_name("Coordinate"));
    nodes
        .filter_map(|node| {
            Some(CoordinateDefault {
                name: node.attribute("name")?.trim().to_owned(),
                value: child_words(node, "default_value")?.parse().ok()?,
                is_locked: says_so(node, "locked"),
                is_clamped: says_so(node, "clamped"),
            })
        })
        .filter(|default| default.value.is_finite())
        .collect()
}

/// Whether a child says `true`.
fn says_so(node: xml::Node, name: &str) -> bool {
    child_words(node, name).is_some_and(|told| told.eq_ignore_ascii_case("true"))
}
