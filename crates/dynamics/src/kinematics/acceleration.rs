//! Accelerations of the links.

use crate::error::DynamicsError;
use crate::kinematics::{is_finite, overflow, velocities};
use crate::scalar::Scalar;
use crate::spatial::Twist;
use crate::spatial::direction::cross;
use crate::tree::Tree;
use crate::workspace::{Workspace, check};
use nalgebra::Vector3;

/// Places the links and finds their velocities and accelerations: afterwards [`Workspace::acceleration`] tells the
/// acceleration of each link's origin and its angular acceleration at `q`, `v`, `a`, in world axes.
///
/// ```text
/// turn about e:   α ← α + e·a_k + ė·v_k                                              ė = ω × e
/// slide along e:  ẍ ← ẍ + e·a_k + (ė + ω × e)·v_k + α × e·q_k + ω × (ω × e·q_k)
/// ```
///
/// The axes of a ball or free joint turn with its link, and so `ω` in their `ė` is the link's. These are accelerations
/// of points as a standing observer measures them (not the rates of spatial velocities); gravity is not taken off.
///
/// `q` (rad, m) has length `nq`, `v` and `a` (per s, per s²) length `nv`.
///
/// # Errors
///
/// [`DynamicsError`] for a slice of the wrong length, an entry that is not finite, a workspace of another tree, or
/// accelerations beyond the precision.
///
/// # Examples
///
/// A stone on a string of half a metre at 4 rad/s is drawn inwards with 0.5 · 4²:
///
/// ```
/// use solaris_dynamics::{Tree, Workspace, accelerations};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let hand = LinkSpec::root("hand", Joint::new("shoulder").rz());
/// let stone = LinkSpec::child("stone", "hand", Joint::new("knot").at(Vector3::new(0.5, 0.0, 0.0))).mass(1.0);
/// let figure = FigureBuilder::new("sling").link(hand).link(stone).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::zeros())?;
/// let mut workspace = Workspace::new(&tree);
/// accelerations(&tree, &mut workspace, &[0.0], &[4.0], &[0.0])?;
/// assert_eq!(workspace.acceleration(1).linear, Vector3::new(-8.0, 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "forward kinematics")]
pub fn accelerations<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
) -> Result<(), DynamicsError> {
    velocities(tree, workspace, q, v)?;
    check("a", a, tree.nv(), |index| tree.v_name(index))?;
    accelerate(tree, workspace, v, a)
}

/// The accelerations that the links have at `q`, `v` without any acceleration of the degrees of freedom: the bias
/// accelerations `γ = J̇·v` of every link at once, in one pass and without `J̇`.
///
/// Places the links and finds their velocities; [`Workspace::acceleration`] then tells that of each link, and
/// [`crate::Frame::acceleration`] that of a point of it.
///
/// # Errors
///
/// As for [`accelerations`].
#[doc(alias = "drift")]
#[doc(alias = "acceleration bias")]
#[doc(alias = "jdot v")]
#[doc(alias = "velocity product")]
#[doc(alias = "CalcBiasSpatialAcceleration")]
pub fn bias_accelerations<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
) -> Result<(), DynamicsError> {
    // Taken out so that the workspace can be borrowed; an empty vector takes no memory.
    let zeros = std::mem::take(&mut workspace.zeros);
    let result = if zeros.len() == tree.nv() {
        accelerations(tree, workspace, q, v, &zeros)
    } else {
        Err(DynamicsError::Workspace)
    };
    workspace.zeros = zeros;
    result
}

/// Accelerations of the links from their poses and velocities.
pub(crate) fn accelerate<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    v: &[T],
    a: &[T],
) -> Result<(), DynamicsError> {
    let mut finite = true;
    for (i, body) in tree.bodies.iter().enumerate() {
        let Twist { mut linear, mut angular } =
            body.parent.map_or_else(Twist::zero, |parent| ws.accelerations[parent]);
        let mut spin = body.parent.map_or_else(Vector3::zeros, |parent| ws.twists[parent].angular);
        linear += carried(&spin, &angular, &ws.arms[i]);
        for k in body.first..body.end {
            let (dof, axis) = (&tree.dofs[k], ws.axes[k]);
            let turning = if body.sphere.is_some() { ws.twists[i].angular } else { spin };
            let axis_rate = cross(&turning, &axis);
            if dof.kind.turns() {
                angular += axis * a[k] + axis_rate * v[k];
                spin += axis * v[k];
            } else {
                let slid = axis * ws.moved[dof.q].0;
                linear += axis * a[k] + (axis_rate + cross(&spin, &axis)) * v[k];
                linear += carried(&spin, &angular, &slid);
            }
        }
        finite &= is_finite(&linear) & is_finite(&angular);
        ws.accelerations[i] = Twist { linear, angular };
    }
    overflow(finite, "the acceleration of a link", || {
        ws.accelerations.iter().map(|twist| format!("{twist:?}"))
    })
}

/// What a point at `arm` of a turning body accelerates more than the body's origin: `α × r + ω × (ω × r)`.
pub(crate) fn carried<T: Scalar>(spin: &Vector3<T>, angular: &Vector3<T>, arm: &Vector3<T>) -> Vector3<T> {
    cross(angular, arm) + cross(spin, &cross(spin, arm))
}

/// Rates of the axes, levers and reaches that `place` and `levers` have found, from the links' velocities:
///
/// ```text
/// ė = ω × e        lever of a turn = e × d:  ė × d + e × ḋ        lever of a slide = e:  ė
/// ```
///
/// with `d` the way that the slides after it have gone.
pub(crate) fn rates<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>, v: &[T]) {
    for (i, body) in tree.bodies.iter().enumerate() {
        let carrier = body.parent.map_or_else(Vector3::zeros, |parent| ws.twists[parent].angular);
        let mut spin = carrier;
        for k in body.first..body.end {
            let axis = ws.axes[k];
            let turning = if body.sphere.is_some() { ws.twists[i].angular } else { spin };
            ws.axis_rates[k] = cross(&turning, &axis);
            if tree.dofs[k].kind.turns() {
                spin += axis * v[k];
            }
        }
        let (mut slid, mut slid_rate) = (Vector3::zeros(), Vector3::zeros());
        for k in (body.first..body.end).rev() {
            let (dof, axis, axis_rate) = (&tree.dofs[k], ws.axes[k], ws.axis_rates[k]);
            if dof.kind.turns() {
                ws.lever_rates[k] = cross(&axis_rate, &slid) + cross(&axis, &slid_rate);
            } else {
                ws.lever_rates[k] = axis_rate;
                let way = ws.moved[dof.q].0;
                slid += axis * way;
                slid_rate += axis_rate * way + axis * v[k];
            }
        }
        ws.reach_rates[i] = cross(&carrier, &ws.arms[i]) + slid_rate;
    }
}
