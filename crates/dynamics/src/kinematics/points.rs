//! Columns of the Jacobians of many points, at one configuration.

use crate::error::DynamicsError;
use crate::inertia::mass_matrix::levers;
use crate::kinematics::climb::{Step, climb};
use crate::kinematics::forward_kinematics;
use crate::kinematics::frame::Frame;
use crate::kinematics::jacobian::column;
use crate::scalar::Scalar;
use crate::spatial::Twist;
use crate::tree::Tree;
use crate::workspace::Workspace;

/// Places the links at `q` (rad or m, length `nq`) and finds how each degree of freedom moves its link, which
/// [`point_columns`] then tells of any number of points without another pass over the tree.
///
/// # Errors
///
/// As for [`forward_kinematics`].
#[doc(alias = "computeJointJacobians")]
pub fn joint_jacobians<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
) -> Result<(), DynamicsError> {
    forward_kinematics(tree, workspace, q)?;
    levers(tree, workspace);
    Ok(())
}

/// Visits the columns of the Jacobian of `frame` that are not zero, each with the index of its degree of freedom: the
/// velocity of the frame's origin and its angular velocity for a unit rate, along the world's axes. From link to link they
/// come from the frame to the root.
///
/// The workspace holds the configuration of the last [`joint_jacobians`].
///
/// With `i` before `j` on the way from the root (a smaller index), the second derivative of the origin is
///
/// ```text
/// ∂²x/∂q_i∂q_j = ω_i × ∂x/∂q_j
/// ```
///
/// and for two degrees of freedom of one ball or free joint the mean of this both ways round, for a step as
/// [`solaris_model::Figure::integrate`] takes it.
///
/// # Panics
///
/// Where the tree has no such link.
///
/// # Examples
///
/// ```
/// use solaris_dynamics::{Frame, Tree, Workspace, joint_jacobians, point_columns};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let rod = LinkSpec::root("rod", Joint::new("pivot").rz()).mass(1.0);
/// let figure = FigureBuilder::new("lever").link(rod).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::zeros())?;
/// let mut workspace = Workspace::new(&tree);
/// joint_jacobians(&tree, &mut workspace, &[0.0])?;
/// for length in [1.0, 2.0] {
///     let tip = Frame::at(0, Vector3::new(length, 0.0, 0.0));
///     point_columns(&tree, &workspace, &tip, |dof, column| {
///         assert_eq!((dof, column.linear), (0, Vector3::new(0.0, length, 0.0)));
///     });
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "getFrameJacobian")]
pub fn point_columns<T: Scalar>(
    tree: &Tree<T>,
    workspace: &Workspace<T>,
    frame: &Frame<T>,
    mut visit: impl FnMut(usize, Twist<T>),
) {
    let mut arm = frame.arm(workspace);
    climb(tree, frame.link, tree.bodies[frame.link].end, |step| match step {
        Step::Dof(k) => visit(k, column(tree, workspace, k, &arm)),
        Step::Parent(link) => arm += workspace.reaches[link],
    });
}
