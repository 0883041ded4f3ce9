//! Three rotations about the coordinate axes, in the six orders, and the ball joint that they stand for.

mod angles;
mod convert;
mod gimbal;

pub use convert::{BallState, EulerState};
pub use gimbal::GimbalDistance;

use crate::joint::{AxisKind, JointKind};
use nalgebra::{Matrix3, Vector3};
use std::fmt;

/// The order of three rotations about the axes x, y, z, each about the axes that those before it have turned.
///
/// The name is read from the parent outwards, as a joint's degrees of freedom are: Z-Y-X turns about z first, and its angles
/// are `[z, y, x]`. With `i, j, k` the axes in this order and `a, b, c` the angles (rad),
///
/// ```text
/// R = R_i(a)·R_j(b)·R_k(c)
/// ```
///
/// turns coordinates of the link into those of the joint's frame. The middle angle ±π/2 is **gimbal lock**: the first and the
/// last axis are parallel there, so only the sum or the difference of their angles means anything, and no rates of the angles
/// turn the link about the axis that is missing.
///
/// Angles, rates and vectors that go in must be finite; [`EulerState`] and [`BallState`] are converted with a check.
#[doc(alias = "Euler angles")]
#[doc(alias = "Cardan")]
#[doc(alias = "Tait-Bryan")]
#[doc(alias = "rotation order")]
#[doc(alias = "rpy")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EulerOrder {
    /// X-Y-Z.
    Xyz,
    /// X-Z-Y.
    Xzy,
    /// Y-X-Z.
    Yxz,
    /// Y-Z-X.
    Yzx,
    /// Z-X-Y.
    Zxy,
    /// Z-Y-X: side bend, twist, flexion of generated figures.
    Zyx,
}

/// The error of a conversion: why a state has no counterpart.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EulerError {
    /// Three rotations in gimbal lock.
    #[error(
        "the middle angle of {order} is {angle} rad, gimbal lock: the rates of its angles cannot make every angular velocity \
         there; take another order, a ball joint, or a posture at least 1e-15 rad away"
    )]
    Locked {
        /// The order of rotations.
        order: EulerOrder,
        /// Its middle angle (rad).
        angle: f64,
    },
    /// A number that goes in is not finite.
    #[error("{what} is {value}; it must be a finite number")]
    NotFinite {
        /// Which one.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A quaternion has no direction.
    #[error("the quaternion is zero, which is no rotation; no rotation at all is 0 0 0 1")]
    ZeroQuaternion,
}

impl EulerOrder {
    /// All six.
    pub const ALL: [Self; 6] = [Self::Xyz, Self::Xzy, Self::Yxz, Self::Yzx, Self::Zxy, Self::Zyx];

    /// Below this cosine of the middle angle, rounding is all that keeps the axes apart.
    const LOCK: f64 = 4.0 * f64::EPSILON;

    /// The axes in order, from the parent outwards: 0, 1, 2 for x, y, z.
    pub fn axes(self) -> [usize; 3] {
        match self {
            Self::Xyz => [0, 1, 2],
            Self::Xzy => [0, 2, 1],
            Self::Yxz => [1, 0, 2],
            Self::Yzx => [1, 2, 0],
            Self::Zxy => [2, 0, 1],
            Self::Zyx => [2, 1, 0],
        }
    }

    /// The order of a joint of exactly three rotations about +x, +y and +z; `None` for any other joint.
    pub fn of(kind: &JointKind) -> Option<Self> {
        let is_axis = |(dof, axis): (&crate::Dof, usize)| {
            dof.axis.kind == AxisKind::Rotation && dof.axis.direction == Vector3::ith(axis, 1.0)
        };
        let fits = |order: &Self| kind.axes().iter().zip(order.axes()).all(is_axis);
        Self::ALL.into_iter().find(|order| kind.axes().len() == 3 && fits(order))
    }

    /// Whether the axes follow each other cyclically (X-Y-Z, Y-Z-X, Z-X-Y): the third is the first crossed with the
    /// second.
    pub fn is_cyclic(self) -> bool {
        matches!(self, Self::Xyz | Self::Yzx | Self::Zxy)
    }

    /// +1 for a cyclic order, −1 otherwise: `e_i × e_j = sense·e_k`.
    fn sense(self) -> f64 {
        if self.is_cyclic() { 1.0 } else { -1.0 }
    }

    /// The velocity map `J`: the angular velocity (rad/s) of the link against the joint's frame, along the **link's** axes, is
    /// `J·rates` (rad/s).
    ///
    /// Its columns are the axes of the three rotations in the link's frame; with `ε` the sense of the order,
    ///
    /// ```text
    /// J = | cos b cos c·e_i − ε cos b sin c·e_j + ε sin b·e_k    ε sin c·e_i + cos c·e_j    e_k |
    /// ```
    #[doc(alias = "angular velocity jacobian")]
    pub fn velocity_map(self, angles: &[f64; 3]) -> Matrix3<f64> {
        let [_, (sb, cb), (sc, cc)] = angles.map(f64::sin_cos);
        let e = self.sense();
        let columns = [[cb * cc, -e * cb * sc, e * sb], [e * sc, cc, 0.0], [0.0, 0.0, 1.0]];
        self.matrix(&columns)
    }

    /// The time derivative of [`EulerOrder::velocity_map`] at these rates (rad/s): the angular acceleration along the link's axes
    /// is `J·r̈ + J̇·ṙ`.
    pub fn velocity_map_rate(self, angles: &[f64; 3], rates: &[f64; 3]) -> Matrix3<f64> {
        let [_, (sb, cb), (sc, cc)] = angles.map(f64::sin_cos);
        let ([_, b, c], e) = (*rates, self.sense());
        let first = [-sb * cc * b - cb * sc * c, e * (sb * sc * b - cb * cc * c), e * cb * b];
        let columns = [first, [e * cc * c, -sc * c, 0.0], [0.0; 3]];
        self.matrix(&columns)
    }

    /// The rates of the angles (rad/s) at which the link turns with `velocity` (rad/s) along its own axes: `J⁻¹·ω`.
    ///
    /// They grow as 1/distance to gimbal lock, and so does what rounding does to them.
    ///
    /// # Errors
    ///
    /// [`EulerError::Locked`] in gimbal lock.
    pub fn rates(self, angles: &[f64; 3], velocity: &Vector3<f64>) -> Result<[f64; 3], EulerError> {
        let [(sb, cb), (sc, cc)] = self.unlocked(angles)?;
        let ([i, j, k], e) = (self.axes().map(|axis| velocity[axis]), self.sense());
        let first = (cc * i - e * sc * j) / cb;
        Ok([first, e * sc * i + cc * j, k - e * sb * first])
    }

    /// The moment (N m) along the link's axes that does what the moments `tau` (N m) about the three axes do: `J⁻ᵀ·τ`.
    ///
    /// # Errors
    ///
    /// [`EulerError::Locked`] in gimbal lock, unless all moments are zero.
    pub fn moment(self, angles: &[f64; 3], tau: &[f64; 3]) -> Result<Vector3<f64>, EulerError> {
        if tau.iter().all(|moment| *moment == 0.0) {
            return Ok(Vector3::zeros());
        }
        let [(sb, cb), (sc, cc)] = self.unlocked(angles)?;
        let ([first, middle, last], e) = (*tau, self.sense());
        let along = (first - e * sb * last) / cb;
        let [i, j, k] = self.axes();
        let mut moment = Vector3::zeros();
        moment[i] = cc * along + e * sc * middle;
        moment[j] = cc * middle - e * sc * along;
        moment[k] = last;
        Ok(moment)
    }

    /// Sine and cosine of the middle and of the last angle.
    fn unlocked(self, angles: &[f64; 3]) -> Result<[(f64, f64); 2], EulerError> {
        let (middle, last) = (angles[1].sin_cos(), angles[2].sin_cos());
        if middle.1.abs() <= Self::LOCK {
            return Err(EulerError::Locked { order: self, angle: angles[1] });
        }
        Ok([middle, last])
    }

    /// The matrix of columns whose entries are along the axes i, j, k.
    fn matrix(self, columns: &[[f64; 3]; 3]) -> Matrix3<f64> {
        let mut matrix = Matrix3::zeros();
        for (column, entries) in columns.iter().enumerate() {
            for (axis, entry) in self.axes().into_iter().zip(entries) {
                matrix[(axis, column)] = *entry;
            }
        }
        matrix
    }
}

impl fmt::Display for EulerOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [i, j, k] = self.axes().map(|axis| ['X', 'Y', 'Z'][axis]);
        write!(f, "{i}-{j}-{k}")
    }
}
