//! Inverse dynamics: the generalized forces of a given motion.

pub(crate) mod ground;
pub(crate) mod reacting;
pub(crate) mod reactions;
pub(crate) mod regressor;
pub(crate) mod slopes;

use crate::error::DynamicsError;
use crate::kinematics::{is_finite, place_links};
use crate::scalar::Scalar;
use crate::spatial::direction::{Direction, Moved, apply, apply_transposed, cross, sum_of_products};
use crate::spatial::load::Load;
use crate::spatial::{Pose, Wrench};
use crate::tree::dof::{along, along_three};
use crate::tree::mass_distribution::MassDistribution;
use crate::tree::{Body, Tree};
use crate::wide::wide;
use crate::workspace::{LinkMotion, Workspace, are_finite, check, check_length};
use nalgebra::{Matrix3, Vector3};

/// The generalized forces `tau` (N m or N) that move the figure with accelerations `a` through the state `q`, `v`.
///
/// Newton and Euler's equations of every link, in the link's own frame about its own origin: motion from the root
/// outwards, forces back,
///
/// ```text
/// K = [α]× + [ω]×²      f = m·a + K·h      n = h × a + ∫ r × K·r dm      tau_k = e_k·n  or  e_k·f
/// ```
///
/// where gravity enters as an acceleration of the world and `h = m·c`. Nothing depends on where the figure stands in
/// the world, except for `external`.
///
/// `q` (rad, m) has length `nq`; `v`, `a` (per s, per s²) and `tau` length `nv`. `external` lists what acts **on** links
/// besides gravity: link index and [`Wrench`] in world axes, about the world's origin; a link may be named more than
/// once. With external wrenches the links are also placed: see [`Workspace::pose`].
///
/// # Source
///
/// The recursion of J. Y. S. Luh, M. W. Walker, R. P. C. Paul, "On-line computational scheme for mechanical
/// manipulators", J. Dyn. Sys. Meas. Control 102 (1980) 69–76, with the links' mass distributions as second moments
/// `∫ r·rᵀ dm`, the thesis's own choice: Vasilonikolidakis (1991), §3.7, whose pseudo-inertia holds the same ten
/// numbers.
///
/// # Errors
///
/// [`DynamicsError`] for a slice of the wrong length, an entry that is not finite, a wrench on a link that does not
/// exist, a workspace of another tree, or a state whose forces are beyond the precision. `tau` then means nothing.
///
/// # Examples
///
/// Held level, a pendulum of 2 kg at half a metre needs 2 · 9.81 · 0.5 N m:
///
/// ```
/// use solaris_dynamics::{Tree, Workspace, inverse_dynamics};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0))?;
/// let (mut workspace, mut tau) = (Workspace::new(&tree), [0.0]);
/// inverse_dynamics(&tree, &mut workspace, &[-std::f64::consts::FRAC_PI_2], &[0.0], &[0.0], &[], &mut tau)?;
/// assert!((tau[0] - -9.81).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "rnea")]
#[doc(alias = "recursive Newton-Euler")]
#[doc(alias = "id")]
#[doc(alias = "computed torque")]
#[doc(alias = "mj_inverse")]
pub fn inverse_dynamics<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
    external: &[(usize, Wrench<T>)],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || inverse(tree, workspace, q, v, a, external, tau),
    )
}

/// [`inverse_dynamics`], compiled into whatever asks it.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn inverse<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
    external: &[(usize, Wrench<T>)],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    workspace.take_positions(tree, q)?;
    check("v", v, tree.nv(), |index| tree.v_name(index))?;
    check("a", a, tree.nv(), |index| tree.v_name(index))?;
    check_length("tau", tau.len(), tree.nv())?;
    outward(tree, workspace, v, a);
    apply_external(tree, workspace, external)?;
    inward(tree, workspace, tau);
    for &(k, armature) in &tree.armature {
        tau[k] += armature * a[k];
    }
    check_forces(tree, tau)
}

/// The bias forces: `tau` (N m or N) of the state `q`, `v` without acceleration, that is gravity, centrifugal and
/// Coriolis forces. With `v = 0`, the forces that hold the figure against gravity.
///
/// # Errors
///
/// As for [`inverse_dynamics`].
#[doc(alias = "bias")]
#[doc(alias = "nonlinear effects")]
#[doc(alias = "nonLinearEffects")]
#[doc(alias = "nle")]
#[doc(alias = "qfrc_bias")]
pub fn bias_forces<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    // Taken out so that the workspace can be borrowed; an empty vector takes no memory.
    let zeros = std::mem::take(&mut workspace.zeros);
    let result = if zeros.len() == tree.nv() {
        inverse_dynamics(tree, workspace, q, v, &zeros, &[], tau)
    } else {
        Err(DynamicsError::Workspace)
    };
    workspace.zeros = zeros;
    result
}

/// Motion of every link and what it takes, from the root outwards.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn outward<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>, v: &[T], a: &[T]) {
    for (i, body) in tree.bodies.iter().enumerate() {
        let parent = body.parent.map(|parent| &ws.motions[parent]);
        let mut motion = at_joint(body, parent, &tree.gravity);
        if let Some(slot) = body.sphere {
            motion.fly(&ws.spheres[slot], &v[body.first..body.end], &a[body.first..body.end]);
        }
        for k in body.first..body.single_end {
            let dof = &tree.dofs[k];
            let (moved, rate, acceleration) = (dof.moved(ws.moved[dof.q]), v[k] * dof.sign, a[k] * dof.sign);
            along!(dof, ws.rotations, |e| turn {
                motion.turn(e, moved, rate, acceleration);
            }, slide {
                motion.slide(e, moved, rate, acceleration);
            });
        }
        if let Some(triple) = body.triple {
            let (turns, from) = (ws.last_three(body), body.single_end);
            let (v, a) = (&v[from..][..3], &a[from..][..3]);
            along_three!(triple, |x, y, z| {
                motion.turn(x, turns[0], v[0], a[0]);
                motion.turn(y, turns[1], v[1], a[1]);
                motion.turn(z, turns[2], v[2], a[2]);
            });
        }
        let field = field(&motion.angular, &motion.angular_acceleration);
        ws.loads[i] = match &body.mass_distribution {
            Some(distribution) => inertial_load(distribution, &motion.acceleration, &field),
            None => Load::zero(),
        };
        ws.motions[i] = LinkMotion {
            angular: motion.angular,
            angular_acceleration: motion.angular_acceleration,
            acceleration: motion.acceleration,
            field,
        };
    }
}

/// Angular velocity, angular acceleration and acceleration (less gravity) of a moving frame.
struct FrameMotion<T> {
    angular: Vector3<T>,
    angular_acceleration: Vector3<T>,
    acceleration: Vector3<T>,
}

/// Motion of the joint's frame before its first degree of freedom.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn at_joint<T: Scalar>(
    body: &Body<T>,
    parent: Option<&LinkMotion<T>>,
    gravity: &Vector3<T>,
) -> FrameMotion<T> {
    let motion = match parent {
        Some(parent) => FrameMotion {
            angular: parent.angular,
            angular_acceleration: parent.angular_acceleration,
            acceleration: parent.acceleration + apply(&parent.field, &body.offset),
        },
        None => FrameMotion {
            angular: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
            acceleration: -gravity,
        },
    };
    match &body.turned {
        Some(turned) => FrameMotion {
            angular: apply_transposed(turned, &motion.angular),
            angular_acceleration: apply_transposed(turned, &motion.angular_acceleration),
            acceleration: apply_transposed(turned, &motion.acceleration),
        },
        None => motion,
    }
}

impl<T: Scalar> FrameMotion<T> {
    /// Past a turn about `e`:
    ///
    /// ```text
    /// α ← Rᵀα + Rᵀω × e·q̇ + e·q̈      ω ← Rᵀω + e·q̇      a ← Rᵀa
    /// ```
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn turn<E: Direction<T>>(&mut self, e: E, turn: Moved<T>, rate: T, acceleration: T) {
        let angular = e.enter(self.angular, turn);
        let rotated = e.enter(self.angular_acceleration, turn) + e.crossed(&angular, rate);
        self.angular_acceleration = e.add(rotated, acceleration);
        self.angular = e.add(angular, rate);
        self.acceleration = e.enter(self.acceleration, turn);
    }

    /// Past a ball or free joint that holds the link at `d`, turned by `R`; `u` and `w` are the linear and angular velocity
    /// along the link's axes:
    ///
    /// ```text
    /// a ← Rᵀ(a + α × d + ω × (ω × d)) + 2·Rᵀω × u + w × u + u̇      α ← Rᵀα + Rᵀω × w + ẇ      ω ← Rᵀω + w
    /// ```
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn fly(&mut self, sphere: &Pose<T>, v: &[T], a: &[T]) {
        let enter = |v: &Vector3<T>| apply_transposed(&sphere.rotation, v);
        let angular = enter(&self.angular);
        let (w, spun) = (last_three(v), last_three(a));
        if v.len() == 6 {
            let (u, d) = (first_three(v), &sphere.translation);
            let carried =
                cross(&self.angular_acceleration, d) + cross(&self.angular, &cross(&self.angular, d));
            let turned = cross(&(angular + angular + w), &u);
            self.acceleration = enter(&(self.acceleration + carried)) + turned + first_three(a);
        } else {
            self.acceleration = enter(&self.acceleration);
        }
        self.angular_acceleration = enter(&self.angular_acceleration) + cross(&angular, &w) + spun;
        self.angular = angular + w;
    }

    /// Past a slide along `e`:
    ///
    /// ```text
    /// a ← a + α × e·q + ω × (ω × e·q + 2·e·q̇) + e·q̈
    /// ```
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn slide<E: Direction<T>>(&mut self, e: E, slide: Moved<T>, rate: T, acceleration: T) {
        let carried = e.add(e.crossed(&self.angular, slide.s), rate + rate);
        let turned = e.crossed(&self.angular_acceleration, slide.s) + cross(&self.angular, &carried);
        self.acceleration = e.add(self.acceleration + turned, acceleration);
    }
}

/// `K = [α]× + [ω]×²`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn field<T: Scalar>(angular: &Vector3<T>, acceleration: &Vector3<T>) -> Matrix3<T> {
    let (w, d) = (angular, acceleration);
    let (xx, yy, zz) = (w.x * w.x, w.y * w.y, w.z * w.z);
    let (xy, xz, yz) = (w.x * w.y, w.x * w.z, w.y * w.z);
    #[rustfmt::skip]
    let field = Matrix3::new(
        -(yy + zz), xy - d.z,   xz + d.y,
        xy + d.z,   -(xx + zz), yz - d.x,
        xz - d.y,   yz + d.x,   -(xx + yy),
    );
    field
}

/// What moves the mass of one link: `f = m·a + K·h` and `n = h × a + ∫ r × K·r dm`.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn inertial_load<T: Scalar>(distribution: &MassDistribution<T>, a: &Vector3<T>, k: &Matrix3<T>) -> Load<T> {
    let Load { force, moment } = centrifugal_load(distribution, k);
    let m = distribution.mass;
    let force =
        Vector3::new(a.x.times_plus(m, force.x), a.y.times_plus(m, force.y), a.z.times_plus(m, force.z));
    Load { force, moment: cross(&distribution.first, a) + moment }
}

/// What keeps the mass of one link on its way about its origin: `f = K·h` and `n = ∫ r × K·r dm`, the antisymmetric part
/// of `K·∫ r·rᵀ dm`.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn centrifugal_load<T: Scalar>(distribution: &MassDistribution<T>, k: &Matrix3<T>) -> Load<T> {
    let s = &distribution.second;
    let (x, y, z) = ([k.m11, k.m12, k.m13], [k.m21, k.m22, k.m23], [k.m31, k.m32, k.m33]);
    let (s_x, s_y, s_z) = ([s.xx, s.xy, s.xz], [s.xy, s.yy, s.yz], [s.xz, s.yz, s.zz]);
    let moment = Vector3::new(
        sum_of_products(z, s_y) - sum_of_products(y, s_z),
        sum_of_products(x, s_z) - sum_of_products(z, s_x),
        sum_of_products(y, s_x) - sum_of_products(x, s_y),
    );
    Load { force: apply(k, &distribution.first), moment }
}

/// Takes what acts from outside off what the joints have to carry.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn apply_external<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    external: &[(usize, Wrench<T>)],
) -> Result<(), DynamicsError> {
    if external.is_empty() {
        return Ok(());
    }
    place_links(tree, ws)?;
    apply_placed(tree, ws, external)
}

/// The same for links that are placed.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn apply_placed<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    external: &[(usize, Wrench<T>)],
) -> Result<(), DynamicsError> {
    for (index, &(link, wrench)) in external.iter().enumerate() {
        if link >= tree.link_count() || !(is_finite(&wrench.force) && is_finite(&wrench.moment)) {
            return refuse(tree, index, link, &wrench);
        }
        let (pose, load) = (&ws.poses[link], &mut ws.loads[link]);
        let at_origin = wrench.moment - cross(&pose.translation, &wrench.force);
        load.force -= apply_transposed(&pose.rotation, &wrench.force);
        load.moment -= apply_transposed(&pose.rotation, &at_origin);
    }
    Ok(())
}

/// What is wrong with a wrench from outside.
#[cold]
#[inline(never)]
fn refuse<T: Scalar>(
    tree: &Tree<T>,
    index: usize,
    link: usize,
    Wrench { force: f, moment: m }: &Wrench<T>,
) -> Result<(), DynamicsError> {
    if link >= tree.link_count() {
        return Err(DynamicsError::NoSuchLink { index, link, last: tree.link_count() - 1 });
    }
    let link = tree.link_name(link);
    let wrench = format!("force {:?}, moment {:?}", [f.x, f.y, f.z], [m.x, m.y, m.z]);
    Err(DynamicsError::WrenchNotFinite { index, link, wrench })
}

/// Collects the loads towards the root and reads the joints' forces on the way.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn inward<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>, tau: &mut [T]) {
    ws.base = Load::zero();
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let mut load = ws.loads[i];
        if let Some(triple) = body.triple {
            let turns = ws.last_three(body);
            let tau = &mut tau[body.single_end..][..3];
            along_three!(triple, |x, y, z| {
                tau[2] = load.leave_turn(z, turns[2]);
                tau[1] = load.leave_turn(y, turns[1]);
                tau[0] = load.leave_turn(x, turns[0]);
            });
        }
        for k in (body.first..body.single_end).rev() {
            let dof = &tree.dofs[k];
            let moved = dof.moved(ws.moved[dof.q]);
            let force = along!(dof, ws.rotations, |e| turn {
                load.leave_turn(e, moved)
            }, slide {
                load.leave_slide(e, moved)
            });
            tau[k] = force * dof.sign;
        }
        if let Some(slot) = body.sphere {
            load.land(&ws.spheres[slot], &mut tau[body.first..body.end]);
        }
        if let Some(turned) = &body.turned {
            load.leave_frame(turned);
        }
        load.shift(&body.offset);
        // The root is carried by the world.
        match body.parent {
            Some(parent) => ws.loads[parent].add(&load),
            None => ws.base.add(&load),
        }
    }
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn first_three<T: Scalar>(values: &[T]) -> Vector3<T> {
    Vector3::new(values[0], values[1], values[2])
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn last_three<T: Scalar>(values: &[T]) -> Vector3<T> {
    first_three(&values[values.len() - 3..])
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn check_forces<T: Scalar>(tree: &Tree<T>, tau: &[T]) -> Result<(), DynamicsError> {
    if are_finite(tau) {
        return Ok(());
    }
    too_great(tree, tau)
}

#[cold]
#[inline(never)]
fn too_great<T: Scalar>(tree: &Tree<T>, tau: &[T]) -> Result<(), DynamicsError> {
    let bad = tau.iter().position(|value| !value.is_finite()).unwrap_or_default();
    let (what, value) = (format!("the force of dof '{}'", tree.v_name(bad)), format!("{:?}", tau[bad]));
    Err(DynamicsError::Overflow { what, value })
}
