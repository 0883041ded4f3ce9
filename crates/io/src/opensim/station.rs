//! `StationDefinedFrame`: a frame through points.

use crate::xml::Node;
use solaris_model::{Matrix3, Placement, Rotation3, UnitQuaternion, Vector3};

use super::element::child_words;

/// The sockets of the points that such a frame goes through: three corners, and its origin.
pub(super) const POINTS: [&str; 4] =
    ["socket_point_a", "socket_point_b", "socket_point_c", "socket_origin_point"];

/// The frame through the points `a`, `b`, `c` with its origin at the last, all in the frame of one body; nothing where the
/// three lie on a line, or its axes are no two of `+x`, `-x`, `+y` …
///
/// ```text
/// e_i = ±(b − a)/|b − a|      e_j = ±(b − a)×(c − a)/|…|      e_k = ±e_i×e_j
/// ```
///
/// # Source
///
/// OpenSim's documentation of `StationDefinedFrame`; the axes `i` and `j` are `ab_axis` and `ab_x_ac_axis`.
pub(super) fn through(node: Node, [a, b, c, origin]: [Vector3<f64>; 4]) -> Option<Placement> {
    let axis = |name, absent| direction(child_words(node, name).unwrap_or(absent));
    let (along, across) = (axis("ab_axis", "+x")?, axis("ab_x_ac_axis", "+y")?);
    let ab = (b - a).try_normalize(1e-12)?;
    let normal = ab.cross(&(c - a)).try_normalize(1e-12)?;
    // Columns of the rotation: which of the frame's axes each vector is.
    let third = along.cross(&across);
    (third.norm() > 0.5).then_some(())?;
    let rotation: Matrix3<f64> =
        ab * along.transpose() + normal * across.transpose() + ab.cross(&normal) * third.transpose();
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation));
    Some(Placement::from_parts(origin.into(), turn))
}

/// `-x`, `y`, `+z` …
fn direction(word: &str) -> Option<Vector3<f64>> {
    let axis = word.trim_start_matches(['+', '-']).chars().next()?.to_ascii_lowercase();
    let i = ['x', 'y', 'z'].into_iter().position(|letter| letter == axis)?;
    Some(Vector3::ith(i, if word.starts_with('-') { -1.0 } else { 1.0 }))
}
