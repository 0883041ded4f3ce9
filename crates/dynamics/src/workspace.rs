//! Scratch memory of the recursions, and where their results by link are read.

use crate::error::DynamicsError;
use crate::forward::articulated::Articulated;
use crate::forward::propagation::{Hinge, Yielding};
use crate::inertia::columns::Columns;
use crate::inertia::inverse::Answer;
use crate::scalar::Scalar;
use crate::spatial::direction::{Moved, quaternion_rotation, rodrigues};
use crate::spatial::load::Load;
use crate::spatial::symmetric::Symmetric;
use crate::spatial::{Pose, Twist, Wrench};
use crate::tree::{Body, Tree};
use crate::wide::wide;
use nalgebra::{Matrix3, Vector3};

/// How far the squared length of a quaternion may be from 1: what an integrator leaves is used as the direction that it
/// is, what was never meant as a rotation is refused.
const UNIT: f64 = 1e-3;

/// Scratch memory for one tree: allocated once, then no operation allocates.
///
/// Each thread needs one of its own.
#[doc(alias = "Data")]
#[doc(alias = "mjData")]
#[doc(alias = "Context")]
#[derive(Clone, Debug)]
pub struct Workspace<T> {
    pub(crate) poses: Vec<Pose<T>>,
    pub(crate) twists: Vec<Twist<T>>,
    /// Acceleration of each link's origin and angular acceleration, in world axes.
    pub(crate) accelerations: Vec<Twist<T>>,
    /// For each coordinate of `q`, sine and cosine of its angle, or how far it has slid; last those of no motion.
    pub(crate) moved: Vec<(T, T)>,
    /// Rotation matrices about the axes that are not coordinate axes.
    pub(crate) rotations: Vec<Matrix3<T>>,
    /// Where the links of ball and free joints stand in their joints' frames.
    pub(crate) spheres: Vec<Pose<T>>,
    /// Axis of each degree of freedom in world axes.
    pub(crate) axes: Vec<Vector3<T>>,
    /// Offset of each joint, if it is free of its link, from its parent's origin in world axes.
    pub(crate) arms: Vec<Vector3<T>>,
    /// Velocity that a unit rate of each degree of freedom gives its link's origin, in world axes.
    pub(crate) levers: Vec<Vector3<T>>,
    /// Offset of each link's origin from its parent's, in world axes.
    pub(crate) reaches: Vec<Vector3<T>>,
    /// Rates of `axes`, `levers` and `reaches`.
    pub(crate) axis_rates: Vec<Vector3<T>>,
    pub(crate) lever_rates: Vec<Vector3<T>>,
    pub(crate) reach_rates: Vec<Vector3<T>>,
    /// Where the links' origins are as seen from the centre of mass, in world axes.
    pub(crate) offsets: Vec<Vector3<T>>,
    /// How what each link carries moves about the link's origin.
    pub(crate) flows: Vec<Flow<T>>,
    /// What each joint transmits to its link.
    pub(crate) reactions: Vec<Wrench<T>>,
    /// Motion of each link in its own frame.
    pub(crate) motions: Vec<LinkMotion<T>>,
    /// Load on each link in its own frame, about its own origin.
    pub(crate) loads: Vec<Load<T>>,
    /// Those loads before what hangs from the links is added.
    pub(crate) own_loads: Vec<Load<T>>,
    /// What the world carries: the root's load, in world axes about the world's origin.
    pub(crate) base: Load<T>,
    /// Each link with all that it carries, in world axes about its own origin.
    pub(crate) composites: Vec<Composite<T>>,
    /// Each link with what hangs from it, its free joints giving way, in the link's own frame.
    pub(crate) articulated: Vec<Articulated<T>>,
    /// How each degree of freedom answers to accelerations.
    pub(crate) hinges: Vec<Hinge<T>>,
    /// How the links of joints that give way to every turn do so.
    pub(crate) yieldings: Vec<Yielding<T>>,
    /// Acceleration of the link that velocities alone bring past each degree of freedom, in the frame after it: angular
    /// for a turn, linear for a slide. A ball or free joint has its own as a whole, at its first slide and its last turn.
    pub(crate) velocity_products: Vec<Vector3<T>>,
    /// Acceleration of each joint's place that the parent's velocity alone brings, in the parent's frame.
    pub(crate) offset_velocity_products: Vec<Vector3<T>>,
    pub(crate) zeros: Vec<T>,
    /// How each degree of freedom answers where many columns are solved.
    pub(crate) answers: Vec<Answer<T>>,
    /// By link, what inertia and mass were added and taken off to make what it opposes to turning and to sliding.
    pub(crate) made_of: Vec<(T, T)>,
    pub(crate) columns: Columns<T>,
}

/// How a link moves, in its own frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkMotion<T> {
    /// Angular velocity.
    pub(crate) angular: Vector3<T>,
    /// Angular acceleration.
    pub(crate) angular_acceleration: Vector3<T>,
    /// Acceleration of the origin, less gravity.
    pub(crate) acceleration: Vector3<T>,
    /// `K = [α]× + [ω]×²`: a point at `r` has the acceleration `a + K·r`.
    pub(crate) field: Matrix3<T>,
}

/// Mass, first moment and inertia of several links taken as one body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Composite<T> {
    pub(crate) mass: T,
    pub(crate) first: Vector3<T>,
    pub(crate) inertia: Symmetric<T>,
}

/// How the mass that a link carries moves about the link's origin, in world axes: `r` the way there, `ṙ` its rate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flow<T> {
    /// `∫ ṙ dm`
    pub(crate) first: Vector3<T>,
    /// `∫ ṙ·rᵀ dm`
    pub(crate) second: Matrix3<T>,
}

impl<T: Scalar> Flow<T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn zero() -> Self {
        Self { first: Vector3::zeros(), second: Matrix3::zeros() }
    }
}

impl<T: Scalar> Workspace<T> {
    /// Scratch memory for `tree`.
    pub fn new(tree: &Tree<T>) -> Self {
        let (links, dofs, zero) = (tree.link_count(), tree.nv(), Vector3::zeros());
        let rest = LinkMotion {
            angular: zero,
            angular_acceleration: zero,
            acceleration: zero,
            field: Matrix3::zeros(),
        };
        Self {
            poses: vec![Pose::identity(); links],
            twists: vec![Twist::zero(); links],
            accelerations: vec![Twist::zero(); links],
            moved: vec![(T::zero(), T::one()); tree.nq() + 1],
            rotations: vec![Matrix3::identity(); tree.skews.len()],
            spheres: vec![Pose::identity(); tree.spheres.len()],
            axes: vec![zero; dofs],
            arms: vec![zero; links],
            levers: vec![zero; dofs],
            reaches: vec![zero; links],
            axis_rates: vec![zero; dofs],
            lever_rates: vec![zero; dofs],
            reach_rates: vec![zero; links],
            offsets: vec![zero; links],
            flows: vec![Flow::zero(); links],
            reactions: vec![Wrench { force: zero, moment: zero }; links],
            motions: vec![rest; links],
            loads: vec![Load::zero(); links],
            own_loads: vec![Load::zero(); links],
            base: Load::zero(),
            composites: vec![Composite::zero(); links],
            articulated: vec![Articulated::zero(); links],
            hinges: vec![Hinge::idle(); dofs],
            yieldings: vec![Yielding::idle(); links],
            velocity_products: vec![zero; dofs],
            offset_velocity_products: vec![zero; links],
            zeros: vec![T::zero(); dofs],
            answers: vec![Answer::idle(); dofs],
            made_of: vec![(T::zero(), T::zero()); links],
            columns: Columns::new(tree),
        }
    }

    /// The pose of a link, since the last operation on this workspace that is said to place the links.
    ///
    /// # Panics
    ///
    /// Where the tree has no such link.
    #[doc(alias = "oMi")]
    #[doc(alias = "oMf")]
    #[doc(alias = "transform")]
    pub fn pose(&self, link: usize) -> &Pose<T> {
        &self.poses[link]
    }

    /// The wrench that has to act on the whole figure from outside, at its root or elsewhere, besides gravity and the external wrenches
    /// that were given: the root's residual of the last inverse dynamics, in world axes about the world's origin.
    ///
    /// It is the rate of the figure's momentum less gravity's and the given wrenches' part, whatever joint the root has.
    #[doc(alias = "residual force")]
    #[doc(alias = "residuals")]
    #[doc(alias = "root force")]
    pub fn base_wrench(&self) -> Wrench<T> {
        Wrench { force: self.base.force, moment: self.base.moment }
    }

    /// The velocity of a link, since the last operation on this workspace that is said to find the links' velocities.
    ///
    /// # Panics
    ///
    /// Where the tree has no such link.
    pub fn velocity(&self, link: usize) -> &Twist<T> {
        &self.twists[link]
    }

    /// The acceleration of a link, since the last operation on this workspace that is said to find the links' accelerations:
    /// acceleration of its origin (m/s²) and angular acceleration (rad/s²), in world axes, gravity not taken off.
    ///
    /// # Panics
    ///
    /// Where the tree has no such link.
    pub fn acceleration(&self, link: usize) -> &Twist<T> {
        &self.accelerations[link]
    }

    /// The wrench that a link's joint transmits to it from its parent, or from the world to the root, since the last
    /// [`crate::joint_reactions`]: in world axes about the world's origin.
    ///
    /// # Panics
    ///
    /// Where the tree has no such link.
    pub fn reaction(&self, link: usize) -> &Wrench<T> {
        &self.reactions[link]
    }

    /// What the last three turns of a joint with a triple have done.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn last_three(&self, body: &Body<T>) -> [Moved<T>; 3] {
        let from = body.q + (body.single_end - body.first);
        let pairs = &self.moved[from..][..3];
        let moved = |pair: (T, T)| Moved { s: pair.0, c: pair.1 };
        [moved(pairs[0]), moved(pairs[1]), moved(pairs[2])]
    }

    /// Checks `q`, and keeps what each degree of freedom does at it.
    pub(crate) fn set_positions(&mut self, tree: &Tree<T>, q: &[T]) -> Result<(), DynamicsError> {
        wide::<T, _>(
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            || self.take_positions(tree, q),
        )
    }

    /// [`set_positions`](Self::set_positions), compiled into whatever asks it.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn take_positions(&mut self, tree: &Tree<T>, q: &[T]) -> Result<(), DynamicsError> {
        let fits = self.poses.len() == tree.link_count()
            && self.axes.len() == tree.nv()
            && self.moved.len() == tree.nq() + 1
            && self.rotations.len() == tree.skews.len()
            && self.spheres.len() == tree.spheres.len();
        if !fits {
            return Err(DynamicsError::Workspace);
        }
        check("q", q, tree.nq(), |index| tree.q_name(index))?;
        // Sines of slides are found in vain: one loop over everything is the fastest.
        T::sin_cos_all(q, &mut self.moved[..tree.nq()]);
        for &k in &tree.slides {
            let index = tree.dofs[k].q;
            self.moved[index].0 = q[index];
        }
        for (&k, rotation) in tree.skews.iter().zip(&mut self.rotations) {
            let (dof, (s, c)) = (&tree.dofs[k], self.moved[tree.dofs[k].q]);
            if dof.kind.turns() {
                *rotation = rodrigues(&dof.axis, s, c);
            }
        }
        for (sphere, pose) in tree.spheres.iter().zip(&mut self.spheres) {
            let entry = |index: usize| q[index];
            let first = sphere.quaternion;
            let quaternion = [q[first], q[first + 1], q[first + 2], q[first + 3]];
            let squared = check_quaternion(&quaternion, || tree.q_name(sphere.quaternion))?;
            pose.rotation = quaternion_rotation(quaternion, squared);
            if let Some(from) = sphere.position {
                pose.translation = Vector3::new(entry(from), entry(from + 1), entry(from + 2));
            }
        }
        Ok(())
    }
}

/// Refuses a slice of the wrong length and one that is not finite.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn check<T: Scalar>(
    what: &'static str,
    values: &[T],
    expected: usize,
    name: impl Fn(usize) -> String,
) -> Result<(), DynamicsError> {
    check_length(what, values.len(), expected)?;
    if are_finite(values) {
        return Ok(());
    }
    not_finite(what, values, name)
}

/// The first of the values that is not finite.
#[cold]
#[inline(never)]
fn not_finite<T: Scalar>(
    what: &'static str,
    values: &[T],
    name: impl Fn(usize) -> String,
) -> Result<(), DynamicsError> {
    let bad = values.iter().position(|value| !value.is_finite()).unwrap_or_default();
    Err(DynamicsError::NotFinite { what, dof: name(bad), value: format!("{:?}", values[bad]) })
}

/// Whether all are finite. Without an early exit the loop runs in vector registers.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn are_finite<T: Scalar>(values: &[T]) -> bool {
    let mut finite = true;
    for value in values {
        finite &= value.is_finite();
    }
    finite
}

/// Refuses a quaternion that is no rotation; tells its squared length.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn check_quaternion<T: Scalar>(
    quaternion: &[T; 4],
    name: impl Fn() -> String,
) -> Result<T, DynamicsError> {
    let squared = quaternion.iter().fold(T::zero(), |sum, x| sum + *x * *x);
    if squared.all_within(1.0 - UNIT, 1.0 + UNIT) {
        return Ok(squared);
    }
    no_rotation(squared, name)
}

#[cold]
#[inline(never)]
fn no_rotation<T: Scalar>(squared: T, name: impl Fn() -> String) -> Result<T, DynamicsError> {
    Err(DynamicsError::Quaternion { name: name(), squared: format!("{squared:?}") })
}

/// Refuses the wrong length.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn check_length(what: &'static str, found: usize, expected: usize) -> Result<(), DynamicsError> {
    if found == expected { Ok(()) } else { Err(DynamicsError::Length { what, expected, found }) }
}

/// Whether all of these are certain to be finite. Of a matrix that is seen by its sum, which is finite only if all parts are, eight at
/// once in vector registers; a few are looked at by themselves, so that no sums are counted.
fn is_all_finite<T: Scalar>(values: &[T]) -> bool {
    const FEW: usize = 512;
    if values.len() < FEW {
        return are_finite(values);
    }
    let (mut sums, chunks) = ([T::zero(); 8], values.chunks_exact(8));
    let rest = chunks.remainder();
    for chunk in chunks {
        for (sum, value) in sums.iter_mut().zip(chunk) {
            *sum += *value;
        }
    }
    sums.iter().chain(rest).fold(T::zero(), |all, value| all + *value).is_finite()
}

/// Refuses a result that is not finite.
pub(crate) fn check_result<T: Scalar>(what: &str, values: &[T]) -> Result<(), DynamicsError> {
    if is_all_finite(values) {
        return Ok(());
    }
    values.iter().find(|value| !value.is_finite()).map_or(Ok(()), |value| {
        Err(DynamicsError::Overflow { what: what.to_owned(), value: format!("{value:?}") })
    })
}
