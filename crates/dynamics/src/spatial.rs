//! Positions, velocities, forces and momenta of rigid bodies, as pairs of vectors.

pub(crate) mod direction;
pub(crate) mod load;
pub(crate) mod symmetric;

use crate::scalar::Scalar;
use nalgebra::{Isometry3, Matrix3, Vector3};

/// The pose of a link's frame in the world: its rotation and its origin.
#[doc(alias = "SE3")]
#[doc(alias = "transform")]
#[doc(alias = "isometry")]
#[doc(alias = "placement")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<T> {
    /// Turns link coordinates into world coordinates; its columns are the link's axes.
    pub rotation: Matrix3<T>,
    /// The link's origin in the world (m).
    pub translation: Vector3<T>,
}

impl<T: Scalar> Pose<T> {
    /// The world's own frame.
    pub fn identity() -> Self {
        Self { rotation: Matrix3::identity(), translation: Vector3::zeros() }
    }

    /// The same placement in this scalar; its rotation is made one once more in double precision.
    pub fn of(placement: &Isometry3<f64>) -> Self {
        let mut rotation = placement.rotation;
        rotation.renormalize();
        Self {
            rotation: rotation.to_rotation_matrix().matrix().map(T::from_f64),
            translation: placement.translation.vector.map(T::from_f64),
        }
    }

    /// Where a frame stands in the world that stands at `inner` in this one.
    pub fn then(&self, inner: &Self) -> Self {
        Self { rotation: self.rotation * inner.rotation, translation: self.transform(&inner.translation) }
    }

    /// Where the world stands in this frame.
    pub fn inverse(&self) -> Self {
        Self { rotation: self.rotation.transpose(), translation: -self.rotation.tr_mul(&self.translation) }
    }

    /// World coordinates (m) of a `point` of the link.
    pub fn transform(&self, point: &Vector3<T>) -> Vector3<T> {
        self.translation + self.rotation * point
    }
}

/// The velocity of a link, in world axes, or, where an operation says so, its acceleration.
#[doc(alias = "spatial velocity")]
#[doc(alias = "Motion")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<T> {
    /// Velocity (m/s) or acceleration (m/s²) of the link's origin.
    pub linear: Vector3<T>,
    /// Angular velocity (rad/s) or angular acceleration (rad/s²) of the link.
    pub angular: Vector3<T>,
}

impl<T: Scalar> Twist<T> {
    /// Rest.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub fn zero() -> Self {
        Self { linear: Vector3::zeros(), angular: Vector3::zeros() }
    }
}

/// A force and a moment on a link, in world axes, the moment about the world's origin where nothing else is said.
#[doc(alias = "spatial force")]
#[doc(alias = "Force")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<T> {
    /// Force (N).
    pub force: Vector3<T>,
    /// Moment (N m), about the world's origin where nothing else is said.
    pub moment: Vector3<T>,
}

impl<T: Scalar> Wrench<T> {
    /// Nothing acts.
    pub fn zero() -> Self {
        Self { force: Vector3::zeros(), moment: Vector3::zeros() }
    }

    /// A `force` (N) through a `point` of the world (m), with a free `moment` (N m); both in world axes.
    pub fn at(point: &Vector3<T>, force: Vector3<T>, moment: Vector3<T>) -> Self {
        Self { force, moment: moment + point.cross(&force) }
    }

    /// The moment (N m) about a `point` of the world (m), in world axes.
    pub fn moment_about(&self, point: &Vector3<T>) -> Vector3<T> {
        self.moment - point.cross(&self.force)
    }

    /// The same wrench along the axes of a frame that stands at `pose`, and about that frame's origin.
    pub fn seen_from(&self, pose: &Pose<T>) -> Self {
        let moment = self.moment_about(&pose.translation);
        Self { force: pose.rotation.tr_mul(&self.force), moment: pose.rotation.tr_mul(&moment) }
    }

    /// The wrench in world axes and about the world's origin, where this one is along the axes of a frame that stands at
    /// `pose` and about that frame's origin: the inverse of [`Wrench::seen_from`].
    pub fn from_frame(&self, pose: &Pose<T>) -> Self {
        Self::at(&pose.translation, pose.rotation * self.force, pose.rotation * self.moment)
    }
}

impl Wrench<f64> {
    /// The centre of pressure: the point of a ground of this `height` (m, along `up`, of length 1) about which the moment
    /// is normal to it,
    ///
    /// ```text
    /// P = (n × M + h F) / (F·n)
    /// ```
    ///
    /// with the moment `M` about the world's origin. `None` where nothing presses on the ground.
    #[doc(alias = "cop")]
    pub fn center_of_pressure(&self, up: &Vector3<f64>, height: f64) -> Option<Vector3<f64>> {
        let normal = self.force.dot(up);
        (normal > 0.0).then(|| (up.cross(&self.moment) + self.force * height) / normal)
    }
}

/// Momentum of a whole figure, in world axes, the angular part about the world's origin where nothing else is said.
#[doc(alias = "spatial momentum")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Momentum<T> {
    /// Linear momentum (kg m/s).
    pub linear: Vector3<T>,
    /// Angular momentum (kg m²/s), about the world's origin where nothing else is said.
    pub angular: Vector3<T>,
}

#[cfg(test)]
mod tests {
    use super::{Pose, Wrench};
    use nalgebra::{Isometry3, Vector3};

    #[test]
    fn there_and_back_changes_nothing() {
        let pose =
            Pose::<f64>::of(&Isometry3::new(Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.3, 0.8, -0.4)));
        let here = pose.then(&pose.inverse());
        assert!(
            (here.rotation - Pose::identity().rotation).amax() < 1e-15 && here.translation.amax() < 1e-15
        );
        let wrench = Wrench { force: Vector3::new(3.0, 4.0, 5.0), moment: Vector3::new(-1.0, 0.5, 2.0) };
        let back = wrench.seen_from(&pose).from_frame(&pose);
        assert!((back.force - wrench.force).amax() < 1e-14 && (back.moment - wrench.moment).amax() < 1e-14);
        // A force along x one metre up has the moment −1 about z.
        let up = Pose::<f64>::of(&Isometry3::translation(0.0, 1.0, 0.0));
        let push = Wrench { force: Vector3::x(), moment: Vector3::zeros() };
        assert_eq!(push.from_frame(&up).moment, -Vector3::z());
    }
}
