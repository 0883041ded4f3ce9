//! Jacobians of frames, and their rates.

use crate::error::DynamicsError;
use crate::inertia::mass_matrix::levers;
use crate::kinematics::acceleration::rates;
use crate::kinematics::climb::{Step, climb};
use crate::kinematics::frame::Frame;
use crate::kinematics::{forward_kinematics, velocities};
use crate::scalar::Scalar;
use crate::spatial::Twist;
use crate::spatial::direction::{apply_transposed, cross};
use crate::tree::Tree;
use crate::workspace::{Workspace, check_length, check_result};
use nalgebra::{DMatrix, Matrix3, Vector3};

/// Along which axes the velocity of a frame is written.
#[doc(alias = "ReferenceFrame")]
#[doc(alias = "LOCAL")]
#[doc(alias = "WORLD")]
#[doc(alias = "LOCAL_WORLD_ALIGNED")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum JacobianAxes {
    /// The world's. Pinocchio calls this `LOCAL_WORLD_ALIGNED`.
    #[default]
    World,
    /// The frame's own. Pinocchio calls this `LOCAL`.
    Frame,
}

/// The Jacobian `J` (6 × `nv`) of a `frame` at `q`: `J·v` is the velocity of the frame's origin (rows 0 to 2), then its
/// angular velocity (rows 3 to 5), along the `axes` asked for.
///
/// ```text
/// turn about e through o:  (e × (p − o), e)          slide along e:  (e, 0)
/// ```
///
/// Columns of degrees of freedom that do not move the frame are zero. Nothing depends on where the figure stands. `q`
/// (rad, m) has length `nq`. Also places the links.
///
/// # Errors
///
/// [`DynamicsError`] for a slice or matrix of the wrong size, an entry that is not finite, a link that does not exist, a
/// workspace of another tree, or entries beyond the precision.
///
/// # Examples
///
/// The tip of a rod of 2 m that lies along x rises at 2 m/s for 1 rad/s about z:
///
/// ```
/// use solaris_dynamics::{Frame, JacobianAxes, Tree, Workspace, jacobian};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let rod = LinkSpec::root("rod", Joint::new("pivot").rz()).mass(1.0);
/// let figure = FigureBuilder::new("lever").link(rod).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::zeros())?;
/// let (mut workspace, mut j) = (Workspace::new(&tree), nalgebra::DMatrix::zeros(6, 1));
/// let tip = Frame::at(0, Vector3::new(2.0, 0.0, 0.0));
/// jacobian(&tree, &mut workspace, &[0.0], &tip, JacobianAxes::World, &mut j)?;
/// assert_eq!(j.as_slice(), [0.0, 2.0, 0.0, 0.0, 0.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "frame jacobian")]
#[doc(alias = "joint jacobian")]
#[doc(alias = "computeFrameJacobian")]
#[doc(alias = "geometric jacobian")]
#[doc(alias = "mj_jac")]
pub fn jacobian<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    frame: &Frame<T>,
    axes: JacobianAxes,
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    check_call(tree, frame, matrix)?;
    forward_kinematics(tree, workspace, q)?;
    levers(tree, workspace);
    matrix.as_mut_slice().fill(T::zero());
    let ws = &*workspace;
    let turn = turn(ws, frame, axes);
    visit_columns(tree, ws, frame, |k, arm, _| {
        write(matrix, k, &turned(turn.as_ref(), column(tree, ws, k, arm)));
    });
    check_result("the Jacobian", matrix.as_slice())
}

/// The rate `J̇` (6 × `nv`) of [`jacobian`] at `q`, `v`: the acceleration of the frame is `J·a + J̇·v`.
///
/// Along the world's axes that is the acceleration of the frame's origin and the angular acceleration; along the frame's own
/// axes it is the rate of the six numbers `J·v`, which a turning observer reads: `d/dt (Rᵀ·J) = Rᵀ·(J̇ − ω × J)`.
///
/// Also places the links and finds their velocities. Where only `J̇·v` is wanted, [`crate::bias_accelerations`] is cheaper.
///
/// # Errors
///
/// As for [`jacobian`].
#[doc(alias = "jdot")]
#[doc(alias = "jacobian time variation")]
#[doc(alias = "jacobian derivative")]
pub fn jacobian_rate<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    frame: &Frame<T>,
    axes: JacobianAxes,
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    check_call(tree, frame, matrix)?;
    velocities(tree, workspace, q, v)?;
    levers(tree, workspace);
    rates(tree, workspace, v);
    matrix.as_mut_slice().fill(T::zero());
    let ws = &*workspace;
    let (turn, spin) = (turn(ws, frame, axes), &ws.twists[frame.link].angular);
    visit_columns(tree, ws, frame, |k, arm, arm_rate| {
        let mut rate = column_rate(tree, ws, k, arm, arm_rate);
        if axes == JacobianAxes::Frame {
            let column = column(tree, ws, k, arm);
            rate.linear -= cross(spin, &column.linear);
            rate.angular -= cross(spin, &column.angular);
        }
        write(matrix, k, &turned(turn.as_ref(), rate));
    });
    check_result("the rate of the Jacobian", matrix.as_slice())
}

fn check_call<T: Scalar>(tree: &Tree<T>, frame: &Frame<T>, matrix: &DMatrix<T>) -> Result<(), DynamicsError> {
    frame.check(tree)?;
    check_length("each column of the Jacobian", matrix.nrows(), 6)?;
    check_length("each row of the Jacobian", matrix.ncols(), tree.nv())
}

/// Velocity that a unit rate of degree of freedom `k` gives a point at `arm` from the origin of its link.
pub(crate) fn column<T: Scalar>(tree: &Tree<T>, ws: &Workspace<T>, k: usize, arm: &Vector3<T>) -> Twist<T> {
    let (lever, axis) = (ws.levers[k], ws.axes[k]);
    if tree.dofs[k].kind.turns() {
        Twist { linear: lever + cross(&axis, arm), angular: axis }
    } else {
        Twist { linear: lever, angular: Vector3::zeros() }
    }
}

/// The rate of [`column`].
fn column_rate<T: Scalar>(
    tree: &Tree<T>,
    ws: &Workspace<T>,
    k: usize,
    arm: &Vector3<T>,
    arm_rate: &Vector3<T>,
) -> Twist<T> {
    let (lever, rate) = (ws.lever_rates[k], ws.axis_rates[k]);
    if tree.dofs[k].kind.turns() {
        Twist { linear: lever + cross(&rate, arm) + cross(&ws.axes[k], arm_rate), angular: rate }
    } else {
        Twist { linear: lever, angular: Vector3::zeros() }
    }
}

/// Visits the degrees of freedom that move `frame`, from its link to the root, each with the way from the origin of its
/// link to the frame's and the rate of that way; world axes. The rate means something once the links' velocities and
/// `rates` are found.
fn visit_columns<T: Scalar>(
    tree: &Tree<T>,
    ws: &Workspace<T>,
    frame: &Frame<T>,
    mut visit: impl FnMut(usize, &Vector3<T>, &Vector3<T>),
) {
    let mut arm = frame.arm(ws);
    let mut arm_rate = cross(&ws.twists[frame.link].angular, &arm);
    climb(tree, frame.link, tree.bodies[frame.link].end, |step| match step {
        Step::Dof(k) => visit(k, &arm, &arm_rate),
        Step::Parent(link) => {
            arm += ws.reaches[link];
            arm_rate += ws.reach_rates[link];
        }
    });
}

/// The axes to write along, if they are not the world's.
fn turn<T: Scalar>(ws: &Workspace<T>, frame: &Frame<T>, axes: JacobianAxes) -> Option<Matrix3<T>> {
    (axes == JacobianAxes::Frame).then(|| ws.poses[frame.link].rotation * frame.placement.rotation)
}

fn turned<T: Scalar>(turn: Option<&Matrix3<T>>, column: Twist<T>) -> Twist<T> {
    turn.map_or(column, |turn| Twist {
        linear: apply_transposed(turn, &column.linear),
        angular: apply_transposed(turn, &column.angular),
    })
}

fn write<T: Scalar>(matrix: &mut DMatrix<T>, k: usize, column: &Twist<T>) {
    let out = &mut matrix.as_mut_slice()[6 * k..][..6];
    out[..3].copy_from_slice(column.linear.as_slice());
    out[3..].copy_from_slice(column.angular.as_slice());
}
