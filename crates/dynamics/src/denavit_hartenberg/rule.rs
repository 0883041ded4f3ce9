//! The rule that gives α and θ⁰ of a chain from its axes alone.

use nalgebra::{Matrix3, Vector3};
use std::f64::consts::FRAC_PI_2;

/// Below this angle (rad) two axes are parallel: some tens of rounding errors.
const PARALLEL: f64 = 1e-14;

/// α and θ⁰ of one step from axis to axis (rad).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// From z before to z after, about x after.
    pub alpha: f64,
    /// From x before to x after, about z before.
    pub theta: f64,
}

/// α and θ⁰ for each of the `axes` in turn (unit vectors in world axes, at zero), from a frame parallel to the world's.
///
/// ```text
/// x_i = ±z_(i−1) × u, in its positive world sense        θ_i = atan2(x_i·y_(i−1), x_i·x_(i−1))
///       the first of X, Y, Z ⟂ u where z_(i−1) ∥ u       α_i = atan2(x_i·(z_(i−1) × u), z_(i−1)·u)
/// ```
///
/// The positive world sense makes the largest coordinate positive, the first of equals. Where `z ∥ u` and none of X, Y, Z
/// is perpendicular to them, x stays.
///
/// Row i turns z onto axis i. The joint about axis i then turns about z of frame i, so that its coordinate belongs to the
/// θ of row i + 1, and row 1 is a constant.
///
/// ```
/// use solaris_dynamics::denavit_hartenberg::rows;
/// use nalgebra::Vector3;
/// let rows = rows(&[Vector3::x(), Vector3::y(), Vector3::z()]);
/// assert!(rows.iter().all(|row| row.alpha.to_degrees() == 90.0 && row.theta.to_degrees() == 90.0));
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), appendix B gives 36 tables of such rows, without the rule; 13 are wrong. See `docs/sources.md`.
pub fn rows(axes: &[Vector3<f64>]) -> Vec<Row> {
    let mut frame = Matrix3::identity();
    let rows = axes.iter().map(|axis| {
        let row = row(&(frame.transpose() * axis), &frame);
        frame *= row.rotation();
        row
    });
    rows.collect()
}

impl Row {
    /// `Rz(θ⁰)·Rx(α)`, the turn from the frame after to the frame before.
    pub fn rotation(&self) -> Matrix3<f64> {
        let ((st, ct), (sa, ca)) = (super::exact_sin_cos(self.theta), super::exact_sin_cos(self.alpha));
        #[rustfmt::skip]
        let rotation = Matrix3::new(
            ct, -st * ca,  st * sa,
            st,  ct * ca, -ct * sa,
            0.0,      sa,       ca,
        );
        rotation
    }

    /// With x along `normal`, which is perpendicular to z and to `axis`; all in the frame before, whose world axes at zero
    /// are the columns of `frame`.
    pub(super) fn about(normal: &Vector3<f64>, axis: &Vector3<f64>, frame: &Matrix3<f64>) -> Self {
        let x = *normal * positive_sense(&(frame * normal));
        // Without the negative zeros, which atan2 tells from the positive ones.
        let sine = x.y * axis.x - x.x * axis.y + 0.0;
        Self { alpha: quarter(sine.atan2(axis.z)), theta: quarter((x.y + 0.0).atan2(x.x + 0.0)) }
    }
}

/// Whether `axis` is parallel to z, in either sense.
pub(super) fn is_parallel(axis: &Vector3<f64>) -> bool {
    axis.x.hypot(axis.y) <= PARALLEL
}

/// The row to `axis`; as for [`Row::about`].
pub(super) fn row(axis: &Vector3<f64>, frame: &Matrix3<f64>) -> Row {
    let normal = if is_parallel(axis) {
        let perpendicular = (0..3).find(|&i| (frame * axis)[i].abs() < 1e-9);
        // A coordinate axis of the world, in the frame before.
        perpendicular.map_or_else(Vector3::x, |i| frame.row(i).transpose())
    } else {
        Vector3::new(-axis.y, axis.x, 0.0).normalize()
    };
    match Row::about(&normal, axis, frame) {
        row if is_parallel(axis) => Row { alpha: if axis.z > 0.0 { 0.0 } else { 2.0 * FRAC_PI_2 }, ..row },
        row => row,
    }
}

/// The sign of the largest coordinate in world axes, of the first where several are as large.
fn positive_sense(world: &Vector3<f64>) -> f64 {
    let largest = world.amax();
    world.iter().find(|x| x.abs() > largest - 1e-9).map_or(1.0, |x| x.signum())
}

/// A multiple of 90° that is missed by rounding alone becomes exact; −180° becomes 180°.
fn quarter(angle: f64) -> f64 {
    let quarters = angle / FRAC_PI_2;
    let angle = if (quarters - quarters.round()).abs() < PARALLEL {
        quarters.round() * FRAC_PI_2 + 0.0
    } else {
        angle
    };
    if angle <= -2.0 * FRAC_PI_2 { 2.0 * FRAC_PI_2 } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_that_repeats_an_axis_keeps_x() {
        let rows = rows(&[Vector3::x(), Vector3::x(), -Vector3::x()]);
        let degrees: Vec<_> =
            rows.iter().map(|row| (row.alpha.to_degrees(), row.theta.to_degrees())).collect();
        assert_eq!(degrees, [(90.0, 90.0), (0.0, 0.0), (180.0, 0.0)]);
    }

    #[test]
    fn rows_turn_z_onto_any_axis() {
        let axes =
            [Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.6, -1e-11, 0.8), Vector3::new(-2.0, 1.0, 5.0)];
        let axes = axes.map(|axis| axis.normalize());
        let mut frame = Matrix3::identity();
        for (row, axis) in rows(&axes).iter().zip(&axes) {
            frame *= row.rotation();
            assert!((frame.column(2) - axis).norm() < 1e-15, "{row:?} gives {frame}");
        }
    }
}
