//! Poses and velocities of the links.

pub(crate) mod acceleration;
pub(crate) mod climb;
pub(crate) mod frame;
pub(crate) mod jacobian;
pub(crate) mod points;

use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::spatial::direction::{Direction, apply, cross, product};
use crate::spatial::{Pose, Twist};
use crate::tree::Tree;
use crate::tree::dof::{along, along_three};
use crate::wide::wide;
use crate::workspace::{Workspace, check};
use nalgebra::Vector3;

/// Places the links: afterwards [`Workspace::pose`] tells where each one stands at `q`.
///
/// With `P` the parent, `B` and `p` the joint's placement and `E_k`, `d_k` what its degrees of freedom do,
///
/// ```text
/// R = R_P·B·E_1·E_2·…          x = x_P + R_P·p + Σ R_P·B·E_1·…·E_(k−1)·d_k
/// ```
///
/// `q` (rad or m) has length `nq`.
///
/// # Errors
///
/// [`DynamicsError`] for a slice of the wrong length, an entry that is not finite, a workspace of another tree, or links
/// too far away for the precision.
#[doc(alias = "fk")]
#[doc(alias = "forward kinematics")]
#[doc(alias = "mj_kinematics")]
pub fn forward_kinematics<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
) -> Result<(), DynamicsError> {
    workspace.set_positions(tree, q)?;
    place(tree, workspace)
}

/// Places the links and finds their velocities: afterwards [`Workspace::pose`] and [`Workspace::velocity`] tell where
/// each one stands and how it moves at `q`, `v`.
///
/// ```text
/// turn about e:  ω ← ω + e·v_k          slide along e:  ẋ ← ẋ + e·v_k + ω × e·q_k
/// ```
///
/// with `e` in world axes. `q` (rad or m) has length `nq`, `v` (rad/s or m/s) length `nv`.
///
/// # Errors
///
/// As for [`forward_kinematics`].
#[doc(alias = "forward kinematics")]
#[doc(alias = "fk")]
pub fn velocities<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
) -> Result<(), DynamicsError> {
    workspace.set_positions(tree, q)?;
    check("v", v, tree.nv(), |index| tree.v_name(index))?;
    place(tree, workspace)?;
    let ws = workspace;
    let mut finite = true;
    for (i, body) in tree.bodies.iter().enumerate() {
        let Twist { mut linear, mut angular } =
            body.parent.map_or_else(Twist::zero, |parent| ws.twists[parent]);
        linear += cross(&angular, &ws.arms[i]);
        let dofs = body.first..body.end;
        for ((dof, axis), rate) in tree.dofs[dofs.clone()].iter().zip(&ws.axes[dofs.clone()]).zip(&v[dofs]) {
            if dof.kind.turns() {
                angular += axis * *rate;
            } else {
                let slid = axis * ws.moved[dof.q].0;
                linear += axis * *rate + cross(&angular, &slid);
            }
        }
        finite &= is_finite(&linear) & is_finite(&angular);
        ws.twists[i] = Twist { linear, angular };
    }
    overflow(finite, "the velocity of a link", || ws.twists.iter().map(|twist| format!("{twist:?}")))
}

/// Places the links from the positions kept; also keeps axes and arms in world axes.
pub(crate) fn place<T: Scalar>(tree: &Tree<T>, workspace: &mut Workspace<T>) -> Result<(), DynamicsError> {
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || place_links(tree, workspace),
    )
}

/// [`place`], compiled into whatever asks it.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn place_links<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
) -> Result<(), DynamicsError> {
    let ws = workspace;
    let mut finite = true;
    for (i, body) in tree.bodies.iter().enumerate() {
        let Pose { mut rotation, mut translation } = match body.parent {
            Some(parent) => ws.poses[parent],
            None => Pose::identity(),
        };
        let mut arm = apply(&rotation, &body.offset);
        if let Some(turned) = &body.turned {
            rotation = product(&rotation, turned);
        }
        if let Some(slot) = body.sphere {
            let sphere = &ws.spheres[slot];
            arm += apply(&rotation, &sphere.translation);
            rotation = product(&rotation, &sphere.rotation);
            for k in body.first..body.end {
                ws.axes[k] = apply(&rotation, &tree.dofs[k].axis);
            }
        }
        translation += arm;
        for k in body.first..body.single_end {
            let dof = &tree.dofs[k];
            let moved = dof.moved(ws.moved[dof.q]);
            along!(dof, ws.rotations, |e| turn {
                ws.axes[k] = e.of(&rotation) * dof.sign;
                rotation = e.turned(&rotation, moved);
            }, slide {
                ws.axes[k] = e.of(&rotation) * dof.sign;
                translation += e.of(&rotation) * moved.s;
            });
        }
        if let Some(triple) = body.triple {
            let turns = ws.last_three(body);
            let axes = &mut ws.axes[body.single_end..][..3];
            along_three!(triple, |x, y, z| {
                axes[0] = x.of(&rotation);
                rotation = x.turned(&rotation, turns[0]);
                axes[1] = y.of(&rotation);
                rotation = y.turned(&rotation, turns[1]);
                axes[2] = z.of(&rotation);
                rotation = z.turned(&rotation, turns[2]);
            });
        }
        ws.arms[i] = arm;
        finite &= is_finite(&translation);
        ws.poses[i] = Pose { rotation, translation };
    }
    overflow(finite, "the position of a link", || {
        ws.poses.iter().map(|pose| format!("{:?}", pose.translation))
    })
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn is_finite<T: Scalar>(v: &Vector3<T>) -> bool {
    v.x.is_finite() & v.y.is_finite() & v.z.is_finite()
}

/// The error of a result that is not finite, with the first such value.
pub(crate) fn overflow<I: Iterator<Item = String>>(
    finite: bool,
    what: &str,
    values: impl Fn() -> I,
) -> Result<(), DynamicsError> {
    if finite {
        return Ok(());
    }
    let bad = values().find(|value| value.contains("inf") || value.contains("NaN")).unwrap_or_default();
    Err(DynamicsError::Overflow { what: what.to_owned(), value: bad })
}
