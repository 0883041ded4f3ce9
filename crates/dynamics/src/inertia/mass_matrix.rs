//! The mass matrix, by the composite-rigid-body algorithm.

use crate::error::DynamicsError;
use crate::kinematics::place;
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, cross, dot};
use crate::spatial::load::Load;
use crate::spatial::symmetric::Symmetric;
use crate::tree::Tree;
use crate::wide::wide;
use crate::workspace::{Composite, Workspace, check_length, check_result};
use nalgebra::{DMatrix, Vector3};

/// The mass matrix `M` (`nv` × `nv`) at `q`, in kg, kg m, kg m²: kinetic energy is `½ vᵀ·M·v`.
///
/// Column `j` holds the forces, along every degree of freedom between `j` and the root, that accelerate by 1 all that
/// `j` carries, taken as one rigid body; entries of degrees of freedom on different branches are zero. The bodies are
/// written in world axes but about their own links' origins, so that nothing depends on where the figure stands. The
/// work grows with the number of links times the depth of the tree, plus `nv²` for writing.
///
/// Also places the links: see [`Workspace::pose`].
///
/// # Source
///
/// The composite-body method of M. W. Walker, D. E. Orin, "Efficient dynamic computer simulation of robotic
/// mechanisms", J. Dyn. Sys. Meas. Control 104 (1982) 205–211.
///
/// # Errors
///
/// [`DynamicsError`] for a slice or matrix of the wrong size, an entry that is not finite, a workspace of another tree,
/// or entries beyond the precision.
#[doc(alias = "crba")]
#[doc(alias = "composite-rigid-body algorithm")]
#[doc(alias = "inertia matrix")]
#[doc(alias = "joint space inertia")]
#[doc(alias = "mj_fullM")]
pub fn mass_matrix<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    workspace.set_positions(tree, q)?;
    check_length("each column of the mass matrix", matrix.nrows(), tree.nv())?;
    check_length("each row of the mass matrix", matrix.ncols(), tree.nv())?;
    place(tree, workspace)?;
    levers(tree, workspace);
    gather(tree, workspace);
    matrix.as_mut_slice().fill(T::zero());
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || write_entries(tree, workspace, matrix.as_mut_slice()),
    );
    for &(k, armature) in &tree.armature {
        matrix[(k, k)] += armature;
    }
    // No entry is greater than the roots of the two on the diagonal that it stands between.
    let finite = (0..tree.nv()).fold(true, |finite, k| finite & matrix[(k, k)].is_finite());
    if finite { Ok(()) } else { check_result("the mass matrix", matrix.as_slice()) }
}

/// Writes the entries that are not zero, armature left out.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn write_entries<T: Scalar>(tree: &Tree<T>, workspace: &Workspace<T>, matrix: &mut [T]) {
    for (link, body) in tree.bodies.iter().enumerate() {
        // Most joints of living things have three degrees of freedom, most of machines one.
        let mut j = body.first;
        while j < body.end {
            j = match body.end - j {
                1 => write_columns::<T, 1>(tree, workspace, link, j, matrix),
                2 => write_columns::<T, 2>(tree, workspace, link, j, matrix),
                _ => write_columns::<T, 3>(tree, workspace, link, j, matrix),
            };
        }
    }
}

/// For each degree of freedom the velocity that a unit rate gives its link's origin, and for each link the way from its
/// parent's origin to its own; world axes.
pub(crate) fn levers<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>) {
    find_levers(tree, ws);
}

/// [`levers`], compiled into whatever asks it.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn find_levers<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>) {
    for (i, body) in tree.bodies.iter().enumerate() {
        if body.only_turns {
            // Its levers are zero, and stay so.
            ws.reaches[i] = ws.arms[i];
            continue;
        }
        // How far the degrees of freedom after k carry the link's origin away from the axis of k.
        let mut slid = Vector3::zeros();
        for k in (body.first..body.end).rev() {
            let (dof, axis) = (&tree.dofs[k], ws.axes[k]);
            if dof.kind.turns() {
                ws.levers[k] = cross(&axis, &slid);
            } else {
                ws.levers[k] = axis;
                slid += axis * ws.moved[dof.q].0;
            }
        }
        ws.reaches[i] = ws.arms[i] + slid;
    }
}

/// Each link with all that it carries as one body about the link's own origin, world axes. A body `(m, h, I)` about a
/// point that is `r` away from the new one has there
///
/// ```text
/// h' = h + m·r          I' = I + (2·h·r + m·r·r)·1 − (h·rᵀ + r·hᵀ + m·r·rᵀ)
/// ```
pub(crate) fn gather<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>) {
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || gather_links(tree, ws),
    );
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn gather_links<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>) {
    for ((body, composite), pose) in tree.bodies.iter().zip(&mut ws.composites).zip(&ws.poses) {
        *composite = match &body.mass_distribution {
            Some(distribution) => Composite {
                mass: distribution.mass,
                first: apply(&pose.rotation, &distribution.first),
                inertia: distribution.inertia_at_origin.rotated(&pose.rotation),
            },
            None => Composite::zero(),
        };
    }
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let Some(parent) = body.parent else { continue };
        let (Composite { mass, first: h, inertia }, r) = (ws.composites[i], ws.reaches[i]);
        let shift = ws.composites[i].shift(&r);
        let carried = &mut ws.composites[parent];
        carried.mass += mass;
        carried.first += h + r * mass;
        carried.inertia.add(&inertia);
        carried.inertia.add(&shift);
    }
}

/// What accelerates all that link `link` carries by 1 along its degree of freedom `j`, about the link's origin.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn accelerating<T: Scalar>(tree: &Tree<T>, ws: &Workspace<T>, link: usize, j: usize) -> Load<T> {
    let Composite { mass, first, inertia } = &ws.composites[link];
    let (dof, axis, lever) = (&tree.dofs[j], &ws.axes[j], &ws.levers[j]);
    if !dof.kind.turns() {
        return Load { force: lever * *mass, moment: cross(first, lever) };
    }
    let mut load = Load { force: cross(axis, first), moment: inertia.times(axis) };
    if dof.has_lever {
        load.add(&Load { force: lever * *mass, moment: cross(first, lever) });
    }
    load
}

/// The force or moment along degree of freedom `k` of a load about its link's origin.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn along<T: Scalar>(tree: &Tree<T>, ws: &Workspace<T>, k: usize, load: &Load<T>) -> T {
    let dof = &tree.dofs[k];
    match (dof.kind.turns(), dof.has_lever) {
        (true, false) => dot(&ws.axes[k], &load.moment),
        (true, true) => dot(&ws.axes[k], &load.moment) + dot(&ws.levers[k], &load.force),
        (false, _) => dot(&ws.levers[k], &load.force),
    }
}

/// Writes columns (and rows) of `N` degrees of freedom of `link`, from `first` on, as far as those before them go; the one after them.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn write_columns<T: Scalar, const N: usize>(
    tree: &Tree<T>,
    ws: &Workspace<T>,
    link: usize,
    first: usize,
    matrix: &mut [T],
) -> usize {
    let n = tree.nv();
    let mut loads = [Load::zero(); N];
    for (i, load) in loads.iter_mut().enumerate() {
        let j = first + i;
        *load = accelerating(tree, ws, link, j);
        for k in tree.bodies[link].first..=j {
            let entry = along(tree, ws, k, load);
            matrix[j * n + k] = entry;
            matrix[k * n + j] = entry;
        }
    }
    let mut below = link;
    while let Some(above) = tree.bodies[below].parent {
        let reach = &ws.reaches[below];
        for load in &mut loads {
            load.moment += cross(reach, &load.force);
        }
        let body = &tree.bodies[above];
        for k in body.first..body.end {
            let mut entries = [T::zero(); N];
            if body.only_turns {
                let axis = &ws.axes[k];
                for (entry, load) in entries.iter_mut().zip(&loads) {
                    *entry = dot(axis, &load.moment);
                }
            } else {
                for (entry, load) in entries.iter_mut().zip(&loads) {
                    *entry = along(tree, ws, k, load);
                }
            }
            for (i, entry) in entries.iter().enumerate() {
                matrix[(first + i) * n + k] = *entry;
                matrix[k * n + first + i] = *entry;
            }
        }
        below = above;
    }
    first + N
}

impl<T: Scalar> Composite<T> {
    /// How much more inertia it has about a point from which its own origin is `r` away: with `u = h + m·r/2`,
    /// `2·u·r·1 − (u·rᵀ + r·uᵀ)`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn shift(&self, r: &Vector3<T>) -> Symmetric<T> {
        let u = self.first + r * (self.mass * T::from_f64(0.5));
        let (x, y, z) = (u.x * r.x, u.y * r.y, u.z * r.z);
        Symmetric {
            xx: y + z + (y + z),
            yy: x + z + (x + z),
            zz: x + y + (x + y),
            xy: -(u.x * r.y + r.x * u.y),
            xz: -(u.x * r.z + r.x * u.z),
            yz: -(u.y * r.z + r.y * u.z),
        }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn zero() -> Self {
        Self { mass: T::zero(), first: Vector3::zeros(), inertia: Symmetric::zero() }
    }
}
