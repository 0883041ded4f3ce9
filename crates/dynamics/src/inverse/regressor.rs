//! The torque regressor: forces as a linear function of the inertial parameters, for system identification.

use crate::error::DynamicsError;
use crate::inertia::mass_matrix::levers;
use crate::kinematics::acceleration::{accelerations, carried};
use crate::scalar::Scalar;
use crate::spatial::Twist;
use crate::spatial::direction::{cross, dot};
use crate::spatial::load::Load;
use crate::tree::Tree;
use crate::workspace::{Workspace, check_length, check_result};
use nalgebra::{DMatrix, Matrix3, Vector3};
use solaris_model::Figure;

/// Number of inertial parameters of a link.
pub const INERTIAL_PARAMETERS: usize = 10;

/// Rows and columns of the six parameters of the inertia.
const INERTIA: [(usize, usize); 6] = [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)];

/// The inertial parameters `π` of all links, ten for each, in the order of the links:
///
/// ```text
/// m, m·c_x, m·c_y, m·c_z, I_xx, I_xy, I_yy, I_xz, I_yz, I_zz
/// ```
///
/// in kg, kg m and kg m², along the link's own axes, the inertia about the link's **origin** (Pinocchio's order). A link
/// without mass has ten zeros.
#[doc(alias = "dynamic parameters")]
#[doc(alias = "base parameters")]
pub fn inertial_parameters(figure: &Figure) -> Vec<f64> {
    let parameters = |link: &solaris_model::Link| {
        let (m, c) = (link.mass(), link.com());
        if m <= 0.0 {
            return [0.0; INERTIAL_PARAMETERS];
        }
        let inertia = link.inertia() + (Matrix3::identity() * c.norm_squared() - c * c.transpose()) * m;
        let [xx, xy, yy, xz, yz, zz] = INERTIA.map(|entry| inertia[entry]);
        [m, m * c.x, m * c.y, m * c.z, xx, xy, yy, xz, yz, zz]
    };
    figure.links().iter().flat_map(parameters).collect()
}

/// The regressor `Y` (`nv` × 10·links) of inverse dynamics at `q`, `v`, `a`:
///
/// ```text
/// tau = Y·π
/// ```
///
/// with `π` as [`inertial_parameters`] orders it; `Y` depends on the figure's joints and on gravity, not on its masses.
/// Armatures and external wrenches have no part in it: `Y·π` is the force of the links alone.
///
/// With `a` the acceleration of a link's origin less gravity, the link needs `(f, n)` about its origin:
///
/// ```text
/// by m:    (a, 0)
/// by m·c:  (K·e, e × a)        K = [α]× + [ω]×²
/// by I:    (0, E·α + ω × E·ω)  E the derivative of I
/// ```
///
/// Also places the links and finds their velocities and accelerations.
///
/// # Source
///
/// C. G. Atkeson, C. H. An, J. M. Hollerbach, "Estimation of inertial parameters of manipulator loads and links", Int. J.
/// Robotics Research 5 (1986) 101–119.
///
/// # Errors
///
/// As for [`crate::jacobian`].
#[doc(alias = "computeJointTorqueRegressor")]
#[doc(alias = "joint torque regressor")]
#[doc(alias = "identification")]
pub fn torque_regressor<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    check_length("each column of the regressor", matrix.nrows(), tree.nv())?;
    check_length("each row of the regressor", matrix.ncols(), INERTIAL_PARAMETERS * tree.link_count())?;
    accelerations(tree, workspace, q, v, a)?;
    levers(tree, workspace);
    matrix.as_mut_slice().fill(T::zero());
    let (ws, n) = (&*workspace, tree.nv());
    // Of all entries, most of them zero for good, the sum is finite if they are.
    let mut sum = T::zero();
    for link in 0..tree.link_count() {
        let (mut loads, moments) = loads_by_parameter(tree, ws, link);
        let columns = &mut matrix.as_mut_slice()[INERTIAL_PARAMETERS * link * n..][..INERTIAL_PARAMETERS * n];
        let mut at = link;
        loop {
            let body = &tree.bodies[at];
            let dofs = &tree.dofs[body.first..body.end];
            let (axes, levers) = (&ws.axes[body.first..body.end], &ws.levers[body.first..body.end]);
            // A column's entries stand together.
            let mut columns =
                columns.chunks_exact_mut(n.max(1)).map(|column| &mut column[body.first..body.end]);
            for (load, column) in loads.iter().zip(&mut columns) {
                for (((entry, dof), axis), lever) in column.iter_mut().zip(dofs).zip(axes).zip(levers) {
                    let about = if dof.kind.turns() { dot(axis, &load.moment) } else { T::zero() };
                    *entry = if dof.has_lever { about + dot(lever, &load.force) } else { about };
                    sum += *entry;
                }
            }
            for (moment, column) in moments.iter().zip(columns) {
                for ((entry, dof), axis) in column.iter_mut().zip(dofs).zip(axes) {
                    if dof.kind.turns() {
                        *entry = dot(axis, moment);
                        sum += *entry;
                    }
                }
            }
            let Some(parent) = body.parent else { break };
            for load in &mut loads {
                load.moment += cross(&ws.reaches[at], &load.force);
            }
            at = parent;
        }
    }
    if sum.is_finite() { Ok(()) } else { check_result("the regressor", matrix.as_slice()) }
}

/// What moves a link, by its mass and first moments: world axes, about the link's origin; and by its second moments, which take
/// moments alone, the same about any point.
fn loads_by_parameter<T: Scalar>(
    tree: &Tree<T>,
    ws: &Workspace<T>,
    link: usize,
) -> ([Load<T>; 4], [Vector3<T>; INERTIA.len()]) {
    let (rotation, spin) = (&ws.poses[link].rotation, &ws.twists[link].angular);
    let Twist { linear, angular } = &ws.accelerations[link];
    let acceleration = linear - tree.gravity;
    let axes: [Vector3<T>; 3] = [0, 1, 2].map(|i| rotation.column(i).into());
    let mut loads = [Load { force: acceleration, moment: Vector3::zeros() }; 4];
    for (load, e) in loads[1..].iter_mut().zip(&axes) {
        *load = Load { force: carried(spin, angular, e), moment: cross(e, &acceleration) };
    }
    // Along the link's own axes.
    let parts = |w: &Vector3<T>| -> [T; 3] { [0, 1, 2].map(|i| dot(&axes[i], w)) };
    let (spins, turns) = (parts(spin), parts(angular));
    let moments = INERTIA.map(|(row, column)| {
        let (x, y) = (&axes[row], &axes[column]);
        let times = |w: &[T; 3]| {
            let once = x * w[column];
            if row == column { once } else { once + y * w[row] }
        };
        times(&turns) + cross(spin, &times(&spins))
    });
    (loads, moments)
}
