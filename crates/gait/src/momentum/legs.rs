//! A leg's segments in its foot's plane (left, up, forward), from eighteen products of sines and cosines.
//!
//! The axes of thigh, shank, foot and toes are linear in these products, and so are positions: the rates of everything
//! follow from the products' rates, which are all that has to be differenced.

use super::parts::{Parts, turning};
use crate::body::Segment;
use crate::body::leg::LegPose;
use nalgebra::{Matrix3, Vector3};

/// How many products there are.
pub(crate) const LEG_SHAPE: usize = 18;

/// Axes of ground that is not level in the foot's plane, and their rates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tilt {
    pub(crate) axes: Matrix3<f64>,
    pub(crate) rates: Matrix3<f64>,
}

/// The constants of a leg that stands or swings in its foot's plane: thigh, shank, foot, toes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LegMotion([Segment; 4]);

impl LegMotion {
    pub(crate) fn new(segments: &[Segment; 4]) -> Self {
        Self(*segments)
    }

    /// The products: (cos η, sin η); for α and then for α − k: (cos·sin η, cos·cos η, sin, sin·sin η, sin·cos η, cos); then
    /// cosine and sine of γ + β and of ε + β.
    #[inline]
    pub(crate) fn shape(pose: &LegPose) -> [f64; LEG_SHAPE] {
        let (side_sin, side_cos) = pose.side.sin_cos();
        let turned = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            [cos * side_sin, cos * side_cos, sin, sin * side_sin, sin * side_cos, cos]
        };
        let ([a, b, c, d, e, f], [g, h, i, j, k, l]) = (turned(pose.thigh), turned(pose.thigh - pose.knee));
        let (foot, toes) = (pose.pitch + pose.tilt, pose.toes + pose.tilt);
        let ((foot_sin, foot_cos), (toes_sin, toes_cos)) = (foot.sin_cos(), toes.sin_cos());
        [side_cos, side_sin, a, b, c, d, e, f, g, h, i, j, k, l, foot_cos, foot_sin, toes_cos, toes_sin]
    }

    /// Orientations of thigh, shank, foot and toes, for `one` = 1; their rates, for the products' rates and `one` = 0.
    #[inline]
    #[rustfmt::skip]
    fn axes(p: &[f64; LEG_SHAPE], one: f64) -> [Matrix3<f64>; 4] {
        let turned = |q: &[f64]| Matrix3::new(
            p[0],  q[0],  q[3],
            -p[1], q[1],  q[4],
            0.0,   -q[2], q[5],
        );
        let pitched = |cos: f64, sin: f64| Matrix3::new(
            one, 0.0, 0.0,
            0.0, cos, -sin,
            0.0, sin, cos,
        );
        [turned(&p[2..8]), turned(&p[8..14]), pitched(p[14], p[15]), pitched(p[16], p[17])]
    }

    /// Sums over the leg, for the products and the hip with their rates, and for the ground that the foot is turned in.
    #[inline]
    pub(crate) fn parts(
        &self,
        shape: &[f64; LEG_SHAPE],
        rate: &[f64; LEG_SHAPE],
        hip: &Vector3<f64>,
        hip_rate: &Vector3<f64>,
        tilt: Option<&Tilt>,
    ) -> Parts {
        let (mut axes, mut rates) = (Self::axes(shape, 1.0), Self::axes(rate, 0.0));
        if let Some(tilt) = tilt {
            for i in [2, 3] {
                rates[i] = tilt.axes * rates[i] + tilt.rates * axes[i];
                axes[i] = tilt.axes * axes[i];
            }
        }
        let (mut origin, mut origin_rate) = (*hip, *hip_rate);
        let mut parts = Parts::default();
        for (i, segment) in self.0.iter().enumerate() {
            if i > 0 {
                origin += axes[i - 1] * segment.offset;
                origin_rate += rates[i - 1] * segment.offset;
            }
            let com = origin + axes[i] * segment.com;
            let com_rate = origin_rate + rates[i] * segment.com;
            parts.add(segment, &axes[i], &rates[i], &com, &com_rate);
        }
        parts
    }

    /// The angular momentum of the leg in a turn of its plane at 1 rad/s, for the products and the hip.
    pub(crate) fn turning(
        &self,
        shape: &[f64; LEG_SHAPE],
        hip: &Vector3<f64>,
        tilt: Option<&Tilt>,
    ) -> Vector3<f64> {
        let mut axes = Self::axes(shape, 1.0);
        if let Some(tilt) = tilt {
            axes[2] = tilt.axes * axes[2];
            axes[3] = tilt.axes * axes[3];
        }
        let (mut origin, mut sum) = (*hip, Vector3::zeros());
        for (i, segment) in self.0.iter().enumerate() {
            if i > 0 {
                origin += axes[i - 1] * segment.offset;
            }
            sum += turning(segment, &axes[i], &(origin + axes[i] * segment.com));
        }
        sum
    }
}
