//! Joints whose child glides on an ellipsoid, as axes each of which is a function of one coordinate.

use super::axes::Step;
use super::joint::JointAt;
use crate::xml::{Reader, element, tag};
use solaris_model::{AxisKind, Curve, Vector3};
use std::f64::consts::FRAC_PI_2;

/// The steps of an `EllipsoidJoint`: the child turns by three angles, and its origin is where the ellipsoid's normal is its
/// z axis.
///
/// ```text
/// X = T(a·n_x, b·n_y, c·n_z)·Rx(θ₁)·Ry(θ₂)·Rz(θ₃)        n = (sin θ₂, −sin θ₁·cos θ₂, cos θ₁·cos θ₂)
///   = Tx(a·sin θ₂)·Rx(−θ₁)·Tz(½(c − b)·cos θ₂)·Rx(2·θ₁)·Tz(½(c + b)·cos θ₂)·Ry(θ₂)·Rz(θ₃)
/// ```
///
/// # Source
///
/// The first line: A. Seth, M. Sherman, P. Eastman, S. Delp, *Minimal formulation of joint motion for biomechanisms*,
/// Nonlinear Dynamics 62 (2010), 291–303, and the documentation of Simbody's `MobilizedBody::Ellipsoid`. The second is ours:
/// half of the sum and the difference of a turn and its opposite are the two products.
pub(super) fn joint(reader: &mut Reader, at: &JointAt) -> Option<Vec<Step>> {
    Some(glide(radii(reader, at, "radii_x_y_z")?))
}

/// The steps of a `ScapulothoracicJoint`: the ellipsoid's frame is turned by a quarter about z, so that its coordinates are
/// abduction, elevation and upward rotation, and the fourth turns about an axis in the plane that touches the ellipsoid.
///
/// # Source
///
/// A. Seth, R. Matias, A. P. Veloso, S. L. Delp, *A biomechanical model of the scapulothoracic joint to accurately capture
/// scapular kinematics during shoulder movements*, PLOS ONE 11 (2016), e0141028.
pub(super) fn scapulothoracic(reader: &mut Reader, at: &JointAt) -> Option<Vec<Step>> {
    let [x, y, z] = radii(reader, at, "thoracic_ellipsoid_radii_x_y_z")?;
    let origin = element(at.node, "scapula_winging_axis_origin")
        .map_or(Some(vec![0.0; 2]), |node| reader.text_numbers(node, 2..=2))?;
    let direction = element(at.node, "scapula_winging_axis_direction")
        .map_or(Some(0.0), |node| reader.text_number(node))?;
    let quarter = |by| Step::by(AxisKind::Rotation, Vector3::z(), by);
    let slide = |i: usize, by| Step::by(AxisKind::Translation, Vector3::ith(i, 1.0), by);
    let winging = Vector3::new(-direction.sin(), direction.cos(), 0.0);
    let mut steps = vec![quarter(FRAC_PI_2)];
    steps.extend(glide([y, x, z]));
    steps.extend([
        quarter(-FRAC_PI_2),
        slide(0, origin[0]),
        slide(1, origin[1]),
        Step::with(AxisKind::Rotation, winging, 3),
        slide(1, -origin[1]),
        slide(0, -origin[0]),
    ]);
    Some(steps)
}

fn glide([a, b, c]: [f64; 3]) -> Vec<Step> {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let wave = |amplitude, phase| Curve::Sine { amplitude, frequency: 1.0, phase, offset: 0.0 };
    let slide = |direction, amplitude, phase| {
        Step::along(AxisKind::Translation, direction, 1, wave(amplitude, phase))
    };
    let turn = |slope| Step::along(AxisKind::Rotation, x, 0, Curve::linear(slope, 0.0));
    let mut steps = vec![slide(x, a, 0.0)];
    // Where the section is a circle, one turn is enough.
    if (b - c).abs() > 0.0 {
        steps.extend([turn(-1.0), slide(z, 0.5 * (c - b), FRAC_PI_2), turn(1.0)]);
    }
    steps.extend([
        Step::with(AxisKind::Rotation, x, 0),
        slide(z, 0.5 * (c + b), FRAC_PI_2),
        Step::with(AxisKind::Rotation, y, 1),
        Step::with(AxisKind::Rotation, z, 2),
    ]);
    steps
}

/// Three radii, which must be there.
fn radii(reader: &mut Reader, at: &JointAt, name: &str) -> Option<[f64; 3]> {
    let Some(node) = element(at.node, name) else {
        let message = format!("joint '{}' has no <{name}>; give it the ellipsoid's three radii (m)", at.name);
        reader.fault(tag(at.node), message);
        return None;
    };
    reader.text_numbers(node, 3..=3)?.try_into().ok()
}
