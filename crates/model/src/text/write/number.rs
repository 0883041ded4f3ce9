//! Numbers, angles, vectors and names, so that they read back with the same bits.

use crate::joint::Placement;
use nalgebra::{Unit, UnitQuaternion, Vector3};
use solaris_text::layout::{Doc, field, group, number};

/// A number as an atom.
pub(super) fn plain(value: f64) -> Doc {
    Doc::Atom(number(value))
}

/// Degrees where they give the same bits, the shortest such; otherwise a number in rad.
pub(super) fn angle(value: f64) -> String {
    degrees(value, |degrees| degrees.to_radians().to_bits() == value.to_bits())
        .unwrap_or_else(|| number(value))
}

/// `deg(…)` with the fewest decimals that are `right`, for an angle of about `value` rad.
fn degrees(value: f64, right: impl Fn(f64) -> bool) -> Option<String> {
    let about = value.to_degrees();
    if !about.is_finite() || value.abs() > 1e3 {
        return None;
    }
    for decimals in [0, 1, 2, 3, 4, 6, 8, 10] {
        let text = format!("{about:.decimals$}");
        if text.parse().is_ok_and(&right) {
            // A zero that was rounded off at the end says nothing.
            return Some(format!("deg({text})"));
        }
    }
    right(about).then(|| format!("deg({about:?})"))
}

/// An angle where it turns, a length where it slides.
pub(super) fn coordinate(value: f64, turns: bool) -> String {
    if turns && value.is_finite() { angle(value) } else { number(value) }
}

/// `(x, y, z)`
pub(super) fn tuple(values: &[f64]) -> Doc {
    Doc::Atom(format!("({})", values.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")))
}

/// Whether all of it is `+0.0`, bit for bit.
pub(super) fn is_plain_zero(values: &[f64]) -> bool {
    values.iter().all(|value| value.to_bits() == 0)
}

/// The fields `at` and `turned`, where they say anything.
pub(super) fn placement(placement: &Placement) -> Vec<Doc> {
    let mut fields = Vec::new();
    let (at, turned) = (placement.translation.vector, placement.rotation);
    if !is_plain_zero(at.as_slice()) {
        fields.push(field("at", tuple(at.as_slice())));
    }
    if !same(&turned, &UnitQuaternion::identity()) {
        fields.push(field("turned", rotation(&turned)));
    }
    fields
}

fn same(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> bool {
    a.coords.iter().zip(b.coords.iter()).all(|(a, b)| a.to_bits() == b.to_bits())
}

/// About a coordinate axis by degrees, where that gives the same bits; otherwise the quaternion.
fn rotation(rotation: &UnitQuaternion<f64>) -> Doc {
    let q = rotation.coords;
    for axis in 0..3 {
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        if others.iter().any(|other| q[*other] != 0.0) {
            continue;
        }
        let direction = Vector3::ith(axis, 1.0);
        let right = |degrees: f64| {
            let turned =
                UnitQuaternion::from_axis_angle(&Unit::new_unchecked(direction), degrees.to_radians());
            same(&turned, rotation)
        };
        if let Some(degrees) = degrees(2.0 * q[axis].atan2(q.w), right) {
            let axis = field("axis", tuple(direction.as_slice()));
            return group("About(", vec![axis, field("angle", Doc::Atom(degrees))], ")");
        }
    }
    Doc::Atom(format!("Quaternion{}", quaternion(q.as_slice())))
}

fn quaternion(coordinates: &[f64]) -> String {
    format!("({})", coordinates.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", "))
}
