//! The sole of a foot on the ground: where its ankle is as it turns about the heel, the ball and the tip of the toes.

use crate::body::foot::FootPlane;
use crate::body::leg::{LegGeometry, Polar};
use nalgebra::Vector3;

/// A left foot on the ground (the right foot's world is mirrored); pitches are against the ground, toe down positive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sole {
    leg: LegGeometry,
    /// Axes of the ground under it: to the left, normal, forward.
    left: Vector3<f64>,
    normal: Vector3<f64>,
    forward: Vector3<f64>,
    heel: Vector3<f64>,
    flat_ankle: Vector3<f64>,
    tip: Vector3<f64>,
    heel_polar: Polar,
    ball_polar: Polar,
    toe_polar: Polar,
}

impl Sole {
    /// With its heel there, on ground that rises by `tilt` (rad) along z.
    pub(crate) fn new(leg: &LegGeometry, plane: &FootPlane, tilt: f64, heel: Vector3<f64>) -> Self {
        let axes = plane.tilted(tilt);
        let [left, normal, forward]: [Vector3<f64>; 3] = [0, 1, 2].map(|i| axes.column(i).into());
        Self {
            leg: *leg,
            left,
            normal,
            forward,
            heel,
            flat_ankle: heel + forward * leg.heel_behind + normal * leg.ankle_height,
            tip: heel + forward * leg.foot_length(),
            heel_polar: leg.heel_polar(),
            ball_polar: leg.ball_polar(),
            toe_polar: leg.toe_polar(),
        }
    }

    /// Left, up, forward.
    #[inline]
    fn split(&self, v: &Vector3<f64>) -> [f64; 3] {
        [v.dot(&self.left), v.dot(&self.normal), v.dot(&self.forward)]
    }

    /// The ankle of the flat foot.
    pub(crate) fn flat_ankle(&self) -> Vector3<f64> {
        self.flat_ankle
    }

    /// The ankle of a foot that turns about the heel.
    pub(crate) fn ankle_on_heel(&self, pitch: f64) -> Vector3<f64> {
        let (sin, cos) = pitch.sin_cos();
        let (hz, ha) = (self.leg.heel_behind, self.leg.ankle_height);
        self.heel + self.forward * (hz * cos + ha * sin) + self.normal * (ha * cos - hz * sin)
    }

    /// The ball joint while the toes are flat.
    pub(crate) fn flat_ball(&self) -> Vector3<f64> {
        self.tip - self.forward * self.leg.toe + self.normal * self.leg.ball_height
    }

    /// The ball joint, carried by toes of this pitch that roll about the tip.
    #[inline]
    pub(crate) fn ball(&self, toes: f64) -> Vector3<f64> {
        let (b, r) = self.toe_polar;
        let (sin, cos) = (b + toes).sin_cos();
        self.tip - self.forward * (r * cos) + self.normal * (r * sin)
    }

    /// The ankle of a foot that turns about the ball joint, which is at `ball`.
    #[inline]
    pub(crate) fn ankle_on_ball(&self, ball: &Vector3<f64>, pitch: f64) -> Vector3<f64> {
        let (angle, r) = self.ball_polar;
        let (sin, cos) = (pitch + angle).sin_cos();
        ball - self.forward * (r * cos) + self.normal * (r * sin)
    }

    /// The pitch about the heel that meets this knee, see [`LegGeometry::pitch_about_heel`].
    #[inline]
    pub(crate) fn pitch_on_heel(&self, hip: &Vector3<f64>, knee: f64) -> f64 {
        self.leg.pitch_about(self.heel_polar, self.split(&(hip - self.heel)), knee)
    }

    /// The pitch about the ball joint, which is at `ball`, that meets this knee, see [`LegGeometry::pitch_about_ball`].
    #[inline]
    pub(crate) fn pitch_on_ball(&self, hip: &Vector3<f64>, ball: &Vector3<f64>, knee: f64) -> f64 {
        self.leg.pitch_over(self.ball_polar, self.split(&(hip - ball)), knee)
    }
}

/// The greater one of `x` and 0, C² with a width of `soft` to either side:
///
/// ```text
/// 2ε (t³ − t⁴/2)      t = (x + ε)/(2ε) in 0 … 1
/// ```
pub(crate) fn not_below_zero(x: f64, soft: f64) -> f64 {
    if x >= soft {
        x
    } else if x <= -soft {
        0.0
    } else {
        let t = 0.5 * (x / soft + 1.0);
        2.0 * soft * t * t * t * (1.0 - 0.5 * t)
    }
}
