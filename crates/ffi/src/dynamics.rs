//! The kernel.

use crate::error::{Failure, Status, guard};
use crate::figure::Figure;
use crate::given::{free, give, handle, handle_mut, numbers, numbers_mut};
use solaris::dynamics::{self as kernel, DMatrix, Tree, Workspace};
use solaris::model::{Rotation3, UnitQuaternion, Vector3};

/// Numbers of a pose: place (m) and quaternion (x, y, z, w).
pub const POSE_NUMBERS: usize = 7;

/// The dynamics of a figure, with scratch memory: calls allocate nothing but in errors.
pub struct Dynamics {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    matrix: DMatrix<f64>,
}

/// Makes the dynamics of a figure under its own gravity, or under `gravity` (three numbers, m/s²) where that is not `NULL`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_dynamics_new(
    figure: *const Figure,
    gravity: *const f64,
    out: *mut *mut Dynamics,
) -> Status {
    guard(|| {
        let body = &unsafe { handle("figure", figure) }?.body;
        let gravity = if gravity.is_null() {
            body.gravity
        } else {
            Vector3::from_column_slice(unsafe { numbers("gravity", gravity, 3, 3) }?)
        };
        let tree = Tree::new(&body.figure, gravity).map_err(Failure::refused)?;
        let (workspace, nv) = (Workspace::new(&tree), tree.nv());
        unsafe { give("out", out, Dynamics { tree, workspace, matrix: DMatrix::zeros(nv, nv) }) }
    })
}

/// Frees it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_dynamics_free(dynamics: *mut Dynamics) {
    unsafe { free(dynamics) }
}

/// Inverse dynamics: the generalized forces `tau` (N m, N) of a motion.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_inverse_dynamics(
    dynamics: *mut Dynamics,
    q: *const f64,
    nq: usize,
    v: *const f64,
    a: *const f64,
    tau: *mut f64,
    nv: usize,
) -> Status {
    guard(|| {
        let Dynamics { tree, workspace, .. } = unsafe { handle_mut("dynamics", dynamics) }?;
        let q = unsafe { numbers("q", q, nq, tree.nq()) }?;
        let v = unsafe { numbers("v", v, nv, tree.nv()) }?;
        let a = unsafe { numbers("a", a, nv, tree.nv()) }?;
        let tau = unsafe { numbers_mut("tau", tau, nv, tree.nv(), &[q, v, a]) }?;
        kernel::inverse_dynamics(tree, workspace, q, v, a, &[], tau).map_err(Failure::refused)
    })
}

/// Forward dynamics: the accelerations `a` that forces bring about.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_forward_dynamics(
    dynamics: *mut Dynamics,
    q: *const f64,
    nq: usize,
    v: *const f64,
    tau: *const f64,
    a: *mut f64,
    nv: usize,
) -> Status {
    guard(|| {
        let Dynamics { tree, workspace, .. } = unsafe { handle_mut("dynamics", dynamics) }?;
        let q = unsafe { numbers("q", q, nq, tree.nq()) }?;
        let v = unsafe { numbers("v", v, nv, tree.nv()) }?;
        let tau = unsafe { numbers("tau", tau, nv, tree.nv()) }?;
        let a = unsafe { numbers_mut("a", a, nv, tree.nv(), &[q, v, tau]) }?;
        kernel::forward_dynamics(tree, workspace, q, v, tau, &[], a).map_err(Failure::refused)
    })
}

/// The mass matrix, `nv * nv` numbers; it is symmetric.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_mass_matrix(
    dynamics: *mut Dynamics,
    q: *const f64,
    nq: usize,
    matrix: *mut f64,
    length: usize,
) -> Status {
    guard(|| {
        let Dynamics { tree, workspace, matrix: own } = unsafe { handle_mut("dynamics", dynamics) }?;
        let q = unsafe { numbers("q", q, nq, tree.nq()) }?;
        let out = unsafe { numbers_mut("matrix", matrix, length, tree.nv() * tree.nv(), &[q]) }?;
        kernel::mass_matrix(tree, workspace, q, own).map_err(Failure::refused)?;
        out.copy_from_slice(own.as_slice());
        Ok(())
    })
}

/// Where all links stand in the world: `SOLARIS_POSE_NUMBERS` numbers a link, its place (m) and its quaternion (x, y, z, w).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_link_poses(
    dynamics: *mut Dynamics,
    q: *const f64,
    nq: usize,
    poses: *mut f64,
    length: usize,
) -> Status {
    guard(|| {
        let Dynamics { tree, workspace, .. } = unsafe { handle_mut("dynamics", dynamics) }?;
        let q = unsafe { numbers("q", q, nq, tree.nq()) }?;
        let out = unsafe { numbers_mut("poses", poses, length, POSE_NUMBERS * tree.link_count(), &[q]) }?;
        kernel::forward_kinematics(tree, workspace, q).map_err(Failure::refused)?;
        for (link, numbers) in out.chunks_exact_mut(POSE_NUMBERS).enumerate() {
            let pose = workspace.pose(link);
            let rotation = Rotation3::from_matrix_unchecked(pose.rotation);
            let turned = UnitQuaternion::from_rotation_matrix(&rotation);
            numbers[..3].copy_from_slice(pose.translation.as_slice());
            numbers[3..].copy_from_slice(turned.coords.as_slice());
        }
        Ok(())
    })
}
