//! The vertical plane of a planted foot, and the frames of a leg that stands or swings in it.

use super::leg::{LegGeometry, LegPose};
use super::rotations::about_x;
use nalgebra::{Matrix3, Vector3};

/// Points of a sole that are held over the ground: of the foot, and with those of the toes.
const FOOT_POINTS: usize = 8;
const SOLE_POINTS: usize = 12;

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

    /// The same axes with the normal between them, on ground that rises by `tilt` (rad) along z: the columns of `Rx(−β)·Ry(ψ)`.
    pub(crate) fn tilted(&self, tilt: f64) -> Matrix3<f64> {
        let (sin, cos) = tilt.sin_cos();
        let lean = |v: &Vector3<f64>| Vector3::new(v.x, v.y * cos + v.z * sin, v.z * cos - v.y * sin);
        Matrix3::from_columns(&[lean(&self.left), lean(&Vector3::y()), lean(&self.forward)])
    }

    /// The same as the plane itself has it: to the side, up, forward.
    pub(crate) fn tilted_within(&self, tilt: f64) -> Matrix3<f64> {
        let axes = self.tilted(tilt);
        Matrix3::from_columns(&[0, 1, 2].map(|i| self.split_vector(&axes.column(i).into())))
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
        let (foot, toes) = if pose.tilt == 0.0 {
            (pitched(pose.pitch), pitched(pose.toes))
        } else {
            // Rx(−β)·Ry(ψ)·Rx(angle + β)
            let axes = self.tilted(pose.tilt);
            (axes * about_x(pose.pitch + pose.tilt), axes * about_x(pose.toes + pose.tilt))
        };
        [turned(pose.thigh), turned(pose.thigh - pose.knee), foot, toes]
    }

    /// Points along the sole of a foot and its toes, from the heel to the tip, for a hip whose ankle is `drop` below it in the leg's plane.
    pub(crate) fn sole(
        &self,
        leg: &LegGeometry,
        hip: &Vector3<f64>,
        pose: &LegPose,
        drop: f64,
    ) -> [Vector3<f64>; SOLE_POINTS] {
        let (sin, cos) = pose.side.sin_cos();
        let up = Vector3::y() * cos + self.left * sin;
        let ankle = hip + self.forward * leg.ankle_ahead_of_hip(pose) - up * drop;
        let [_, _, foot, toes] = self.frames(pose);
        let ball = ankle + foot * Vector3::new(0.0, -leg.ball_below, leg.ball_ahead);
        std::array::from_fn(|i| {
            if i < FOOT_POINTS {
                let part = i as f64 / (FOOT_POINTS - 1) as f64;
                let along = -leg.heel_behind + part * (leg.heel_behind + leg.ball_ahead);
                ankle + foot * Vector3::new(0.0, -leg.ankle_height, along)
            } else {
                let part = (i - FOOT_POINTS) as f64 / (SOLE_POINTS - FOOT_POINTS - 1) as f64;
                ball + toes * Vector3::new(0.0, -leg.ball_height, part * leg.toe)
            }
        })
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
        LegPose { side: side.atan2(up), thigh, knee, pitch, toes, tilt: 0.0 }
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
