//! The vertical plane of a planted foot, and the frames of a leg that stands or swings in it.

use super::leg::{LegGeometry, LegPose};
use nalgebra::{Matrix3, Vector3};

/// Axes of the foot's vertical plane: forward and to the left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FootPlane {
    pub(crate) forward: Vector3<f64>,
    pub(crate) left: Vector3<f64>,
}

impl FootPlane {
    /// The left foot's plane, turned outward by `yaw`.
    pub(crate) fn new(yaw: f64) -> Self {
        let (sin, cos) = yaw.sin_cos();
        Self { forward: Vector3::new(sin, 0.0, cos), left: Vector3::new(cos, 0.0, -sin) }
    }

    /// To the side, up, forward.
    #[inline]
    pub(crate) fn split(&self, v: &Vector3<f64>) -> [f64; 3] {
        [v.dot(&self.left), v.y, v.dot(&self.forward)]
    }

    /// The same, as a vector.
    pub(crate) fn split_vector(&self, v: &Vector3<f64>) -> Vector3<f64> {
        Vector3::from(self.split(v))
    }

    /// World rotations of the left thigh, shank, foot and toes.
    #[inline]
    pub(crate) fn frames(&self, pose: &LegPose) -> [Matrix3<f64>; 4] {
        let (sin, cos) = pose.side.sin_cos();
        let (f, s) = (self.forward, self.left);
        // Leg plane: up = cos η Y + sin η s, left = cos η s − sin η Y.
        let (lx, ly, lz) = (cos * s.x, -sin, cos * s.z);
        let (ux, uy, uz) = (sin * s.x, cos, sin * s.z);
        let turned = |angle: f64| {
            // [left, up, f]·Rx(−angle)
            let (sa, ca) = angle.sin_cos();
            Matrix3::new(
                lx,
                ca * ux - sa * f.x,
                sa * ux + ca * f.x, //
                ly,
                ca * uy - sa * f.y,
                sa * uy + ca * f.y, //
                lz,
                ca * uz - sa * f.z,
                sa * uz + ca * f.z,
            )
        };
        let pitched = |angle: f64| {
            // Ry(ψ)·Rx(angle)
            let (sa, ca) = angle.sin_cos();
            Matrix3::new(s.x, sa * f.x, ca * f.x, 0.0, ca, -sa, s.z, sa * f.z, ca * f.z)
        };
        [turned(pose.thigh), turned(pose.thigh - pose.knee), pitched(pose.pitch), pitched(pose.toes)]
    }

    /// The leg's angles for a given ankle: `hip` against `ankle`, pitches of foot and toes as they are.
    ///
    /// ```text
    /// η = atan2(D·s, D_y)   v = hypot(D·s, D_y)   k from v² + (D·f)²   α = atan2(−D·f, v) + β(k)
    /// ```
    #[inline]
    pub(crate) fn pose(
        &self,
        leg: &LegGeometry,
        hip_from_ankle: &Vector3<f64>,
        pitch: f64,
        toes: f64,
    ) -> LegPose {
        let [side, up, forward] = self.split(hip_from_ankle);
        let v = side.hypot(up);
        let knee = leg.knee_for(v * v + forward * forward);
        let thigh = (-forward).atan2(v) + leg.thigh_against_leg(leg.geometric_knee(knee));
        LegPose { side: side.atan2(up), thigh, knee, pitch, toes }
    }
}

/// The mirror image of a vector in the body's middle plane.
#[inline]
pub(crate) fn mirror(v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.x, v.y, v.z)
}

/// The mirror image of a rotation or a tensor in the body's middle plane.
#[inline]
#[rustfmt::skip]
pub(crate) fn mirror_rotation(r: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::new(
        r[(0, 0)], -r[(0, 1)], -r[(0, 2)],
        -r[(1, 0)], r[(1, 1)], r[(1, 2)],
        -r[(2, 0)], r[(2, 1)], r[(2, 2)],
    )
}

/// A vector turned to the left about the vertical.
#[inline]
pub(crate) fn turned(angle: f64, v: &Vector3<f64>) -> Vector3<f64> {
    if angle == 0.0 {
        return *v;
    }
    let (sin, cos) = angle.sin_cos();
    Vector3::new(cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x)
}
