//! Rotations as quaternions: exponential, logarithm, and what a turn does to a slide on the way.
//!
//! Every formula is in terms of a direction and a length, so that nothing underflows for the smallest turns, and of sine
//! and cosine together, so that nothing is lost near half a turn.

use nalgebra::{Quaternion, UnitQuaternion, Vector3, Vector4};

/// Below this, `sin h/h` is 1 to rounding.
const TINY: f64 = 1e-8;
/// A quaternion's squared length is 1 to rounding within this.
const UNIT: f64 = 4.0 * f64::EPSILON;

/// The quaternion at the head of a slice (x, y, z, w).
pub(crate) fn read(q: &[f64]) -> Quaternion<f64> {
    Quaternion::from(Vector4::new(q[0], q[1], q[2], q[3]))
}

/// Whether the squared length is 1 to rounding.
fn is_unit(q: &Quaternion<f64>) -> bool {
    (q.norm_squared() - 1.0).abs() <= UNIT
}

/// `q/|q|`; `q` itself, to the bit, where that is a matter of rounding only; `None` without a direction.
pub(crate) fn unit(q: &Quaternion<f64>) -> Option<Quaternion<f64>> {
    if is_unit(q) {
        return Some(*q);
    }
    let (length, direction) = (q.coords.amax(), q.coords / q.coords.amax());
    let is_direction = length > 0.0 && direction.iter().all(|x| x.is_finite());
    is_direction.then(|| Quaternion::from(direction / direction.norm()))
}

/// `exp(φ/2)`: the turn by the angle `|φ|` (rad) about `φ`.
pub(crate) fn exp(turn: &Vector3<f64>) -> Quaternion<f64> {
    let (angle, axis) = polar(turn);
    let (sine, cosine) = (angle / 2.0).sin_cos();
    Quaternion::from_imag(axis * sine) + Quaternion::from_real(cosine)
}

/// The `φ` (rad) of which `q` is the [`exp`], `|φ| ≤ 2π`: the long way round where `q.w < 0`.
pub(crate) fn log(q: &Quaternion<f64>) -> Vector3<f64> {
    let (sine, axis) = polar(&q.imag());
    axis * (2.0 * sine.atan2(q.w))
}

/// `a⁻¹⊗b` for quaternions of unit length.
///
/// The vector part is taken from `b − a`, to which `a` itself adds nothing: neighbours differ by as many digits as they
/// hold, and a quaternion differs from itself by exactly nothing.
pub(crate) fn between(a: &Quaternion<f64>, b: &Quaternion<f64>) -> Quaternion<f64> {
    let step = b - a;
    let (from, to) = (a.imag(), step.imag());
    let vector = to * a.w - from * step.w - from.cross(&to);
    Quaternion::from_parts(a.dot(b), vector)
}

/// `a⁻¹⊗b` the shortest way round, whatever the signs of `a` and `b`. At exactly half a turn both ways are as long: one is
/// taken, the same for all signs.
pub(crate) fn shortest(a: &Quaternion<f64>, b: &Quaternion<f64>) -> Quaternion<f64> {
    let cosine = a.dot(b);
    if cosine < 0.0 {
        between(a, &-b)
    } else if cosine > 0.0 {
        between(a, b)
    } else {
        between(&positive(a), &positive(b))
    }
}

/// `q` or `−q`, the one whose first component that is not zero is positive.
fn positive(q: &Quaternion<f64>) -> Quaternion<f64> {
    if q.coords.iter().find(|x| **x != 0.0).is_some_and(|x| *x < 0.0) { -q } else { *q }
}

/// `q·v·q⁻¹` for a quaternion of unit length.
pub(crate) fn apply(q: &Quaternion<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    UnitQuaternion::new_unchecked(*q) * v
}

/// Where a body comes to that slides by `slide` (m) along its own axes while it turns by `turn` (rad) about its own axes,
/// both evenly: with `u` the axis and `θ` the angle,
///
/// ```text
/// V(φ)·s = s + (1 − cos θ)/θ · u×s + (1 − sin θ/θ) · u×(u×s)
/// ```
pub(crate) fn sweep(turn: &Vector3<f64>, slide: &Vector3<f64>) -> Vector3<f64> {
    let (angle, axis) = polar(turn);
    let half = angle / 2.0;
    let (sine, cosine) = half.sin_cos();
    // sin h/h, with 1 − cos θ = 2 sin² h and sin θ = 2 sin h cos h.
    let ratio = if half < TINY { 1.0 } else { sine / half };
    let across = axis.cross(slide);
    slide + across * (sine * ratio) + axis.cross(&across) * (1.0 - cosine * ratio)
}

/// The slide (m) that [`sweep`] brings to `place` (m) during the turn `q` of unit length, `q.w ≥ 0`: with `h = θ/2`,
///
/// ```text
/// V(φ)⁻¹·p = p − h · u×p + (1 − h cot h) · u×(u×p)
/// ```
pub(crate) fn unsweep(q: &Quaternion<f64>, place: &Vector3<f64>) -> Vector3<f64> {
    let (sine, axis) = polar(&q.imag());
    let half = sine.atan2(q.w);
    let ratio = if half < TINY { 1.0 } else { half / sine };
    let across = axis.cross(place);
    place - across * half + axis.cross(&across) * (1.0 - q.w * ratio)
}

/// Length and direction; no direction for no length.
fn polar(v: &Vector3<f64>) -> (f64, Vector3<f64>) {
    let largest = v.amax();
    if largest == 0.0 {
        return (0.0, Vector3::zeros());
    }
    let scaled = v / largest;
    let norm = scaled.norm();
    (largest * norm, scaled / norm)
}
