//! Pose and motion of one link, by a recursion along its own path from the world.

use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, apply_transposed, cross, quaternion_rotation};
use crate::tree::mass_distribution::vector;
use nalgebra::{Matrix3, Vector3};
use solaris_model::{AxisKind, Figure, JointKind, Placement};

/// A unit quaternion (x, y, z, w).
pub(super) type Quaternion<T> = [T; 4];

/// How a frame stands and moves, in world axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving<T> {
    pub(super) quaternion: Quaternion<T>,
    /// That of the quaternion.
    pub(super) rotation: Matrix3<T>,
    pub(super) translation: Vector3<T>,
    pub(super) angular: Vector3<T>,
    pub(super) linear: Vector3<T>,
    pub(super) angular_acceleration: Vector3<T>,
    pub(super) acceleration: Vector3<T>,
}

/// What stands between the world and a frame, one step after the other.
#[derive(Clone, Debug)]
pub(super) struct Path<T> {
    steps: Vec<Step<T>>,
}

#[derive(Clone, Copy, Debug)]
enum Step<T> {
    Fixed { quaternion: Quaternion<T>, translation: Vector3<T> },
    Turn { axis: Vector3<T>, q: usize, v: usize },
    Slide { axis: Vector3<T>, q: usize, v: usize },
    Ball { q: usize, v: usize },
    Free { q: usize, v: usize },
}

impl<T: Scalar> Path<T> {
    /// The way to a frame that stands at `end` in the frame of `link`.
    pub(super) fn new(figure: &Figure, link: usize, end: &Placement) -> Result<Self, DynamicsError> {
        let mut links: Vec<usize> =
            std::iter::successors(Some(link), |&link| figure.links()[link].parent()).collect();
        links.reverse();
        let mut path = Self { steps: Vec::new() };
        for link in links {
            path.push_joint(figure, link)?;
        }
        path.push_fixed(end, "the root")?;
        Ok(path)
    }

    fn push_joint(&mut self, figure: &Figure, link: usize) -> Result<(), DynamicsError> {
        let (joint, at) = (figure.links()[link].joint(), figure.layout().joints()[link]);
        self.push_fixed(joint.placement(), joint.name())?;
        match joint.kind() {
            JointKind::Axes(dofs) => {
                for (i, dof) in dofs.iter().enumerate() {
                    let axis = dof.axis.direction.normalize().map(T::from_f64);
                    let (q, v) = (at.q + i, at.v + i);
                    self.steps.push(match dof.axis.kind {
                        AxisKind::Rotation => Step::Turn { axis, q, v },
                        AxisKind::Translation => Step::Slide { axis, q, v },
                    });
                }
            }
            JointKind::Ball { .. } => self.steps.push(Step::Ball { q: at.q, v: at.v }),
            JointKind::Free { .. } => self.steps.push(Step::Free { q: at.q, v: at.v }),
            _ => return Err(DynamicsError::Joint { joint: joint.name().to_owned() }),
        }
        Ok(())
    }

    fn push_fixed(&mut self, placement: &Placement, name: &str) -> Result<(), DynamicsError> {
        if *placement != Placement::identity() {
            let mut rotation = placement.rotation;
            rotation.renormalize();
            let translation = vector("the origin of joint ", name, &placement.translation.vector)?;
            self.steps.push(Step::Fixed { quaternion: rotation.coords.map(T::from_f64).into(), translation });
        }
        Ok(())
    }

    /// The frame at `q`, `v`, `a`; without velocities or accelerations where these are empty.
    pub(super) fn run(&self, q: &[T], v: &[T], a: &[T]) -> Moving<T> {
        self.follow(q, v, a, |_, _, _| {})
    }

    /// The frame at `q`, `v`, `a`; `seen` is told of each degree of freedom when the frame has moved as far as its axis: its
    /// index in `v`, whether it turns, and the axis in world axes.
    pub(super) fn follow(
        &self,
        q: &[T],
        v: &[T],
        a: &[T],
        mut seen: impl FnMut(&Moving<T>, usize, (bool, Vector3<T>)),
    ) -> Moving<T> {
        let mut frame = Moving::world();
        let at = |values: &[T], index: usize| values.get(index).copied().unwrap_or_else(T::zero);
        let three = |values: &[T], from: usize| Vector3::from_fn(|i, _| at(values, from + i));
        for step in &self.steps {
            match *step {
                Step::Fixed { quaternion, translation } => {
                    frame.carry(&translation);
                    frame.orient(&quaternion);
                }
                Step::Turn { axis, q: coordinate, v: dof } => {
                    let world = apply(&frame.rotation, &axis);
                    seen(&frame, dof, (true, world));
                    frame.spin(&(world * at(v, dof)), &(world * at(a, dof)));
                    let (s, c) = (q[coordinate] * T::from_f64(0.5)).sin_cos();
                    frame.orient(&[axis.x * s, axis.y * s, axis.z * s, c]);
                }
                Step::Slide { axis, q: coordinate, v: dof } => {
                    let world = apply(&frame.rotation, &axis);
                    seen(&frame, dof, (false, world));
                    frame.carry(&(axis * q[coordinate]));
                    frame.translate(&(world * at(v, dof)), &(world * at(a, dof)));
                }
                Step::Ball { q: coordinate, v: dof } => {
                    frame.orient(&unit(q, coordinate));
                    frame.tell(dof, true, &mut seen);
                    let [rate, change] = [v, a].map(|values| apply(&frame.rotation, &three(values, dof)));
                    frame.spin(&rate, &change);
                }
                Step::Free { q: coordinate, v: dof } => {
                    frame.carry(&three(q, coordinate));
                    frame.orient(&unit(q, coordinate + 3));
                    frame.tell(dof, false, &mut seen);
                    frame.tell(dof + 3, true, &mut seen);
                    let [linear, change] = [v, a].map(|values| apply(&frame.rotation, &three(values, dof)));
                    let [rate, spun] = [v, a].map(|values| apply(&frame.rotation, &three(values, dof + 3)));
                    // The components are along axes that turn at `rate` against the joint's frame.
                    frame.translate(&linear, &(change + cross(&rate, &linear)));
                    frame.spin(&rate, &spun);
                }
            }
        }
        frame.quaternion = near_unit(frame.quaternion);
        frame
    }
}

impl<T: Scalar> Moving<T> {
    fn world() -> Self {
        let (zero, one) = (Vector3::zeros(), T::one());
        Self {
            quaternion: [T::zero(), T::zero(), T::zero(), one],
            rotation: Matrix3::identity(),
            translation: zero,
            angular: zero,
            linear: zero,
            angular_acceleration: zero,
            acceleration: zero,
        }
    }

    /// To a point that is fixed to the frame at `r` (in its axes); with `d = R·r`,
    ///
    /// ```text
    /// ẋ ← ẋ + ω × d      ẍ ← ẍ + α × d + ω × (ω × d)
    /// ```
    fn carry(&mut self, r: &Vector3<T>) {
        let arm = apply(&self.rotation, r);
        let carried = cross(&self.angular, &arm);
        self.translation += arm;
        self.linear += carried;
        self.acceleration += cross(&self.angular_acceleration, &arm) + cross(&self.angular, &carried);
    }

    /// To a frame that stands turned in this one and does not move there.
    fn orient(&mut self, turn: &Quaternion<T>) {
        self.quaternion = product(&self.quaternion, turn);
        self.rotation = rotation(&self.quaternion);
    }

    /// To a point that moves at `u` against the frame, with the acceleration `u̇` there (both in world axes):
    ///
    /// ```text
    /// ẋ ← ẋ + u      ẍ ← ẍ + 2·ω × u + u̇
    /// ```
    fn translate(&mut self, u: &Vector3<T>, change: &Vector3<T>) {
        let coriolis = cross(&self.angular, u);
        self.linear += u;
        self.acceleration += coriolis + coriolis + change;
    }

    /// To a frame that turns at `w` against this one, with the acceleration `ẇ` there (both in world axes):
    ///
    /// ```text
    /// ω ← ω + w      α ← α + ω × w + ẇ
    /// ```
    fn spin(&mut self, w: &Vector3<T>, change: &Vector3<T>) {
        self.angular_acceleration += cross(&self.angular, w) + change;
        self.angular += w;
    }

    /// Writes the state of a free joint that moves so against the world: `u = Rᵀ·ẋ`, `w = Rᵀ·ω`, and their rates
    ///
    /// ```text
    /// u̇ = Rᵀ·ẍ − w × u      ẇ = Rᵀ·α
    /// ```
    pub(super) fn write_free(&self, q: &mut [T], v: &mut [T], a: &mut [T]) {
        let own = |v: &Vector3<T>| apply_transposed(&self.rotation, v);
        let (linear, angular) = (own(&self.linear), own(&self.angular));
        q[..3].copy_from_slice(self.translation.as_slice());
        q[3..7].copy_from_slice(&self.quaternion);
        v[..3].copy_from_slice(linear.as_slice());
        v[3..6].copy_from_slice(angular.as_slice());
        a[..3].copy_from_slice((own(&self.acceleration) - cross(&angular, &linear)).as_slice());
        a[3..6].copy_from_slice(own(&self.angular_acceleration).as_slice());
    }

    /// Tells of three degrees of freedom along the frame's own axes.
    fn tell(&self, dof: usize, turns: bool, seen: &mut impl FnMut(&Self, usize, (bool, Vector3<T>))) {
        for i in 0..3 {
            seen(self, dof + i, (turns, self.rotation.column(i).into_owned()));
        }
    }
}

/// The quaternion that starts at `from` in `q`; its length is 1 but for what an integrator leaves.
pub(super) fn unit<T: Scalar>(q: &[T], from: usize) -> Quaternion<T> {
    near_unit([0, 1, 2, 3].map(|i| q[from + i]))
}

/// The unit quaternion along one whose length is nearly 1: Newton's method for `1/√|q|²`, which doubles the right digits
/// with each step.
fn near_unit<T: Scalar>(mut quaternion: Quaternion<T>) -> Quaternion<T> {
    let half = T::from_f64(0.5);
    for _ in 0..4 {
        let factor = T::one() + (T::one() - squared(&quaternion)) * half;
        quaternion = quaternion.map(|x| x * factor);
    }
    quaternion
}

fn squared<T: Scalar>(quaternion: &Quaternion<T>) -> T {
    quaternion.iter().fold(T::zero(), |sum, x| sum + *x * *x)
}

/// The rotation of a quaternion.
pub(super) fn rotation<T: Scalar>(quaternion: &Quaternion<T>) -> Matrix3<T> {
    quaternion_rotation(*quaternion, squared(quaternion))
}

/// The conjugate: the rotation back.
pub(super) fn conjugate<T: Scalar>([x, y, z, w]: Quaternion<T>) -> Quaternion<T> {
    [-x, -y, -z, w]
}

/// Hamilton's product: first the right one turns, then the left one.
pub(super) fn product<T: Scalar>(left: &Quaternion<T>, right: &Quaternion<T>) -> Quaternion<T> {
    let ([a, b, c, d], [x, y, z, w]) = (*left, *right);
    [
        d * x + a * w + b * z - c * y,
        d * y - a * z + b * w + c * x,
        d * z + a * y - b * x + c * w,
        d * w - a * x - b * y - c * z,
    ]
}
