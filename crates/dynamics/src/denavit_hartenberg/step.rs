//! One step from axis to axis: the four constants of a Denavit-Hartenberg transform.

use super::rule::{Row, is_parallel, row};
use nalgebra::{IsometryMatrix3, Matrix3, Translation3, Vector3};

/// How far from a joint's centre, in distances between joints, the foot of a common normal may lie.
///
/// The foot of two nearly parallel axes runs away along them, and the digits of everything that is written about it are
/// lost with the square of its distance. Such an axis gets a base of its own.
const REACH: f64 = 20.0;

/// Below this share of the distance between joints a length is zero: some tens of rounding errors.
const COINCIDENT: f64 = 32.0 * f64::EPSILON;

/// The axis of a degree of freedom, seen from the frame before: z of that frame is the axis before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// The joint's centre (m).
    pub(super) point: Vector3<f64>,
    /// Unit vector along the axis.
    pub(super) axis: Vector3<f64>,
    /// Whether the degree of freedom slides; then only the direction counts.
    pub(super) slides: bool,
    /// The distance of the joint from the one before (m), which says what is a small length.
    pub(super) scale: f64,
}

/// θ⁰, s⁰, a, α from one axis to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) row: Row,
    pub(super) s: f64,
    pub(super) a: f64,
}

/// The length of a vector, of the smallest too, whose squares are zero.
pub(super) fn distance(v: &Vector3<f64>) -> f64 {
    v.x.hypot(v.y).hypot(v.z)
}

impl Line {
    /// Whether z is the axis, sense and all.
    pub(super) fn is_z(&self) -> bool {
        is_parallel(&self.axis) && self.axis.z > 0.0 && (self.slides || self.meets_z())
    }

    /// Whether the joint's centre lies on z.
    fn meets_z(&self) -> bool {
        self.point.x.hypot(self.point.y) <= COINCIDENT * self.scale
    }

    /// Whether a frame whose z is this axis serves `other` as well.
    pub(super) fn serves(&self, other: &Self) -> bool {
        let apart = other.point - self.point;
        self.axis.cross(&other.axis).norm() <= 1e-14
            && self.axis.dot(&other.axis) > 0.0
            && (other.slides || apart.cross(&self.axis).norm() <= COINCIDENT * self.scale.max(other.scale))
    }

    /// The constant that moves the frame's origin to the joint's centre and z onto the axis. `frame` has the frame's axes
    /// in the world at zero as columns.
    pub(super) fn base(&self, frame: &Matrix3<f64>) -> IsometryMatrix3<f64> {
        let rotation = nalgebra::Rotation3::from_matrix_unchecked(row(&self.axis, frame).rotation());
        IsometryMatrix3::from_parts(Translation3::from(self.point), rotation)
    }

    /// The step to this axis, x along the common normal; `None` where its foot is out of [`REACH`]. `frame` as in
    /// [`Self::base`].
    ///
    /// ```text
    /// s·z + a·x = p + t·u
    /// ```
    ///
    /// with `p` the joint's centre and `u` the axis. What the equation leaves free brings the new origin as near to `p` as
    /// it can: s for parallel axes, s and t for a slide, whose axis may be moved aside.
    pub(super) fn step(&self, frame: &Matrix3<f64>) -> Option<Step> {
        let (p, u) = (&self.point, &self.axis);
        if is_parallel(u) {
            return Some(self.parallel(row(u, frame), frame));
        }
        let row = row(u, frame);
        let ((st, ct), (sa, ca)) = (super::exact_sin_cos(row.theta), super::exact_sin_cos(row.alpha));
        // u = z·cos α + (x × z)·sin α
        let (x, across) = (Vector3::new(ct, st, 0.0), Vector3::new(st, -ct, 0.0));
        let t = if self.slides { 0.0 } else { -self.rounded(p.dot(&across)) / sa };
        let step = Step { row, s: self.rounded(p.z + t * ca), a: self.rounded(p.dot(&x)) };
        (t.abs() <= REACH * self.scale).then_some(step)
    }

    /// A frame that need not serve any axis: z stays, the origin comes to the joint's centre.
    pub(super) fn last(&self, frame: &Matrix3<f64>) -> Step {
        self.parallel(Row { alpha: 0.0, theta: 0.0 }, frame)
    }

    /// A step between parallel axes; `coincident` is its row where they are one line.
    fn parallel(&self, coincident: Row, frame: &Matrix3<f64>) -> Step {
        let apart = Vector3::new(self.point.x, self.point.y, 0.0);
        let s = self.rounded(self.point.z);
        if self.meets_z() {
            return Step { row: coincident, s, a: 0.0 };
        }
        let row =
            Row { alpha: coincident.alpha, ..Row::about(&(apart / distance(&apart)), &self.axis, frame) };
        let (st, ct) = super::exact_sin_cos(row.theta);
        Step { row, s, a: apart.x * ct + apart.y * st }
    }

    fn rounded(&self, length: f64) -> f64 {
        if length.abs() <= COINCIDENT * self.scale { 0.0 } else { length }
    }
}
