//! The inverse of the mass matrix, and what it makes of many columns: forward dynamics of a figure at rest, a column in each lane.

use crate::error::DynamicsError;
use crate::forward::articulated::Articulated;
use crate::inertia::columns::{
    LANES, Lanes, add_cross, add_load, add_scaled, halves, plus_along, write_mirrored,
};
use crate::inertia::mass_matrix::find_levers;
use crate::kinematics::place;
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, dot};
use crate::tree::Tree;
use crate::wide::wide;
use crate::workspace::{Workspace, check_result};
use nalgebra::{DMatrix, Vector3};

/// A pivot that keeps less than this part of what it was made of has lost too many digits.
const LEAST: f64 = 1e-9;

/// How one degree of freedom answers to forces and accelerations, world axes, about its link's origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answer<T> {
    /// What it turns about, and how fast it carries the link's origin along, as in the workspace.
    axis: Vector3<T>,
    lever: Vector3<T>,
    /// `−U/D`: what a force of 1 along the degree of freedom takes off the load that is handed on.
    force: Vector3<T>,
    moment: Vector3<T>,
    /// `1/D`
    inverse: T,
}

impl<T: Scalar> Answer<T> {
    pub(crate) fn idle() -> Self {
        let zero = Vector3::zeros();
        Self { axis: zero, lever: zero, force: zero, moment: zero, inverse: T::zero() }
    }
}

/// Writes the inverse of the mass matrix at `q`; `false` where too little of a pivot is left beside what it was made of, and then the
/// matrix means nothing. Also places the links, and leaves what [`divide`] needs.
///
/// The links are gathered once, each with all that hangs from it as one body whose joints give way; then every column is forward dynamics
/// without velocity or gravity,
///
/// ```text
/// U = I·s      D = s·U + armature      I ← I − U·Uᵀ/D
/// u = τ − s·p      p ← p + U·u/D      q̈ = (u − U·a)/D      a ← a + s·q̈
/// ```
///
/// inwards from where the column's force acts, and outwards as far as the diagonal. The work grows with `nv²`.
///
/// # Source
///
/// R. Featherstone, "Rigid Body Dynamics Algorithms" (2008), chapter 7; here written in world axes about the links' own origins, so that no
/// column is turned from frame to frame.
pub(crate) fn invert<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<bool, DynamicsError> {
    workspace.set_positions(tree, q)?;
    place(tree, workspace)?;
    let entries = matrix.as_mut_slice();
    let sum = wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || {
            find_levers(tree, workspace);
            articulate(tree, workspace).then(|| {
                if T::IS_FLOAT {
                    write_inverse::<T, LANES>(tree, workspace, entries)
                } else {
                    write_inverse::<T, 1>(tree, workspace, entries)
                }
            })
        },
    );
    let Some(sum) = sum else { return Ok(false) };
    if !sum.is_finite() {
        // An entry is not, or their sum alone.
        check_result("the inverse mass matrix", matrix.as_slice())?;
    }
    Ok(true)
}

/// Writes `−M⁻¹·columns` to `to`, where [`invert`] was called last and an entry of column `k` is zero unless one of its degree of freedom
/// and `k` is carried by the other's link; the sum of all that is written, finite only if all of it is.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn divide<T: Scalar, const W: usize>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    columns: &[T],
    to: &mut [T],
) -> T {
    let (n, links, mut sum) = (tree.nv(), tree.link_count(), T::zero());
    let Workspace { columns: room, answers, reaches, .. } = workspace;
    let mut lanes = room.lanes::<W>();
    for first in (0..n).step_by(W) {
        let end = n.min(first + W);
        for (i, body) in tree.bodies.iter().enumerate() {
            let own = body.first < end && first < body.end;
            // Whether it carries a column's degree of freedom shows itself on the way in.
            lanes.loaded[i] = own || body.parent.is_some_and(|parent| lanes.loaded[parent]);
        }
        for lane in 0..W {
            // Lanes without a column repeat the last.
            let column = &columns[(first + lane).min(end - 1) * n..][..n];
            for (row, entry) in lanes.rows.iter_mut().zip(column) {
                row[lane] = -*entry;
            }
        }
        sum += solve(tree, &mut lanes, answers, reaches, links);
        for lane in 0..end - first {
            let column = &mut to[(first + lane) * n..][..n];
            for (entry, row) in column.iter_mut().zip(&*lanes.rows) {
                *entry = row[lane];
            }
        }
    }
    sum
}

/// Gathers the links as they are placed; whether enough is left of every pivot beside all that was added and taken off to make it.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn articulate<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>) -> bool {
    let Workspace { articulated, answers, axes, levers, reaches, poses, made_of, .. } = ws;
    for (((body, to), pose), made_of) in
        tree.bodies.iter().zip(&mut *articulated).zip(&*poses).zip(&mut *made_of)
    {
        *made_of = (T::zero(), T::zero());
        *to = Articulated::zero();
        if let Some(own) = &body.mass_distribution {
            let (first, inertia) =
                (apply(&pose.rotation, &own.first), own.inertia_at_origin.rotated(&pose.rotation));
            to.add_mass(own.mass, &first, &inertia);
        }
    }
    let mut is_sound = true;
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let mut inertia = articulated[i];
        // What the digits of all that hangs from the link are lost from.
        let (turning, sliding) =
            (made_of[i].0 + inertia.angular.trace(), made_of[i].1 + inertia.linear.trace());
        for k in (body.first..body.end).rev() {
            let (dof, axis, lever) = (&tree.dofs[k], &axes[k], &levers[k]);
            let ((moment, force), parts) = if !dof.kind.turns() {
                (inertia.of_linear(lever), sliding)
            } else if dof.has_lever {
                let (turn, slide) = (inertia.of_angular(axis), inertia.of_linear(lever));
                ((turn.0 + slide.0, turn.1 + slide.1), turning + sliding * dot(lever, lever))
            } else {
                (inertia.of_angular(axis), turning)
            };
            let own = match (dof.kind.turns(), dof.has_lever) {
                (true, false) => dot(axis, &moment),
                (true, true) => dot(axis, &moment) + dot(lever, &force),
                (false, _) => dot(lever, &force),
            };
            let pivot = own + dof.armature;
            is_sound &= (pivot / (parts + dof.armature)).all_within(LEAST, 2.0);
            let inverse = T::one() / pivot;
            answers[k] = Answer {
                axis: *axis,
                lever: *lever,
                force: force * -inverse,
                moment: moment * -inverse,
                inverse,
            };
            inertia.give_way(&moment, &force, inverse);
        }
        if let Some(parent) = body.parent {
            let reach = &reaches[i];
            inertia.shift(reach);
            articulated[parent].add(&inertia);
            made_of[parent].0 += turning + sliding * dot(reach, reach);
            made_of[parent].1 += sliding;
        }
    }
    is_sound
}

/// Writes the inverse, where [`articulate`] went before; the sum of its entries as far as the diagonal, finite only if all of them are.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn write_inverse<T: Scalar, const W: usize>(tree: &Tree<T>, ws: &mut Workspace<T>, matrix: &mut [T]) -> T {
    let (n, mut last, mut sum) = (tree.nv(), 0, T::zero());
    let Workspace { columns, answers, reaches, .. } = ws;
    let mut lanes = columns.lanes::<W>();
    for first in (0..n).step_by(W) {
        let end = n.min(first + W);
        loop {
            lanes.loaded[last] = tree.bodies[last].end > first;
            if tree.bodies[last].end >= end {
                break;
            }
            last += 1;
        }
        // A force of 1 along each degree of freedom.
        lanes.rows[..tree.bodies[last].end].fill([T::zero(); W]);
        for k in first..end {
            lanes.rows[k][k - first] = T::one();
        }
        sum += solve(tree, &mut lanes, answers, reaches, last + 1);
        write_mirrored(lanes.rows, first, end, n, matrix);
    }
    sum
}

/// In each lane the accelerations that the forces in `rows` give the first `links` links, in their place. Those that the forces act on are
/// `loaded`; on others there are none. The sum of all accelerations.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn solve<T: Scalar, const W: usize>(
    tree: &Tree<T>,
    lanes: &mut Lanes<'_, T, W>,
    answers: &[Answer<T>],
    reaches: &[Vector3<T>],
    links: usize,
) -> T {
    let Lanes { rows, loads, motions, loaded } = lanes;
    for (i, body) in tree.bodies[..links].iter().enumerate().rev() {
        if !loaded[i] {
            continue;
        }
        // What the parent is relieved of.
        let (mut force, mut moment) = halves(&loads[i]);
        (loads[i], loaded[i]) = ([[T::zero(); W]; 6], false);
        let own = body.first..body.end;
        let joint = tree.dofs[own.clone()].iter().zip(&answers[own.clone()]);
        for (row, (dof, answer)) in rows[own].iter_mut().zip(joint).rev() {
            let mut left = *row;
            if dof.kind.turns() {
                left = plus_along(left, &answer.axis, &moment);
            }
            if dof.has_lever {
                left = plus_along(left, &answer.lever, &force);
            }
            let mut accelerations = left;
            for acceleration in &mut accelerations {
                *acceleration *= answer.inverse;
            }
            *row = accelerations;
            add_scaled(&mut force, &answer.force, &left);
            add_scaled(&mut moment, &answer.moment, &left);
        }
        if let Some(parent) = body.parent {
            add_cross(&mut moment, &reaches[i], &force);
            add_load(&mut loads[parent], &force, &moment);
            loaded[parent] = true;
        }
    }
    let mut sums = [T::zero(); W];
    for (i, body) in tree.bodies[..links].iter().enumerate() {
        let (mut linear, mut angular) = ([[T::zero(); W]; 3], [[T::zero(); W]; 3]);
        if let Some(parent) = body.parent {
            (linear, angular) = halves(&motions[parent]);
            // α × r
            add_cross(&mut linear, &-reaches[i], &angular);
        }
        let own = body.first..body.end;
        let joint = tree.dofs[own.clone()].iter().zip(&answers[own.clone()]);
        for (row, (dof, answer)) in rows[own].iter_mut().zip(joint) {
            let taken = plus_along(plus_along(*row, &answer.force, &linear), &answer.moment, &angular);
            for lane in 0..W {
                sums[lane] += taken[lane];
            }
            *row = taken;
            if dof.kind.turns() {
                add_scaled(&mut angular, &answer.axis, row);
            }
            if dof.has_lever {
                add_scaled(&mut linear, &answer.lever, row);
            }
        }
        motions[i] = [linear[0], linear[1], linear[2], angular[0], angular[1], angular[2]];
    }
    sums.iter().fold(T::zero(), |all, sum| all + *sum)
}
