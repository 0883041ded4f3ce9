//! The inverse of the mass matrix by factors that are zero wherever it is: between different branches.

use crate::scalar::Scalar;
use crate::spatial::symmetric::Symmetric;
use crate::tree::Tree;
use crate::workspace::Workspace;
use nalgebra::DMatrix;

/// A pivot that keeps less than this part of what it was made of has lost too many digits.
const LEAST: f64 = 1e-9;

/// Puts the inverse of the mass matrix that `workspace` was used for last in its place; `false` where too little of a pivot is left beside
/// what it was made of, and then the matrix means nothing. `column` is scratch of length `nv`.
///
/// `M = Lᵀ·D·L`, with `L` one on its diagonal and zero but on the paths to the root. First its entries stand above the diagonal, at the head
/// of their columns, and `1/D` on it; then the inverse grows row by row, its symmetric half with it:
///
/// ```text
/// X_kj = −Σ L_ki·X_ij  for j < k          X_kk = 1/D_k − Σ L_ki·X_ki
/// ```
///
/// over `i` before `k` on its path.
///
/// # Source
///
/// R. Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees", Int. J. Robotics Research 24
/// (2005) 487–500, for the factors.
pub(crate) fn invert<T: Scalar>(
    tree: &Tree<T>,
    workspace: &Workspace<T>,
    matrix: &mut DMatrix<T>,
    column: &mut [T],
) -> bool {
    let n = tree.nv();
    let entries = matrix.as_mut_slice();
    let mut is_sound = true;
    // What stands on the path comes to the head of each column: of degrees of freedom before k it is the head of that of k.
    for k in 0..n {
        let own = &mut entries[k * n..][..k];
        column[..k].copy_from_slice(own);
        climb(tree, k, |p, i| own[p] = column[i]);
    }
    // The diagonal, with the inertia that it is a part of.
    for (body, composite) in tree.bodies.iter().zip(&workspace.composites) {
        let Symmetric { xx, yy, zz, .. } = composite.inertia;
        for k in body.first..body.end {
            let whole = if tree.dofs[k].kind.turns() { xx + yy + zz } else { composite.mass };
            column[k] = entries[k * n + k] + whole;
        }
    }
    for k in (0..n).rev() {
        let (before, own) = entries.split_at_mut(k * n);
        is_sound &= (own[k] / column[k]).all_within(LEAST, 2.0);
        own[k] = T::one() / own[k];
        climb(tree, k, |p, i| {
            let part = own[p] * own[k];
            let to = &mut before[i * n..][..=i];
            to[..p].iter_mut().zip(&*own).for_each(|(to, from)| *to -= part * *from);
            to[i] -= part * own[p];
            own[p] = part;
        });
    }
    if !is_sound {
        return false;
    }
    for k in 0..n {
        let (before, rest) = entries.split_at_mut(k * n);
        let own = &mut rest[..=k];
        column[..k].copy_from_slice(&own[..k]);
        own[..k].fill(T::zero());
        climb(tree, k, |p, i| {
            let factor = column[p];
            own[..k].iter_mut().zip(&before[i * n..]).for_each(|(x, from)| *x -= factor * *from);
        });
        climb(tree, k, |p, i| {
            let taken = column[p] * own[i];
            own[k] -= taken;
        });
        for (j, x) in own[..k].iter().enumerate() {
            before[j * n + k] = *x;
        }
    }
    true
}

/// Visits the degrees of freedom before `k` on its path, the nearest one first, each with how many are before it.
#[inline]
fn climb<T: Scalar>(tree: &Tree<T>, k: usize, mut visit: impl FnMut(usize, usize)) {
    let (mut place, mut next) = (tree.depth[k], tree.before[k]);
    while let Some(i) = next {
        place -= 1;
        visit(place, i);
        next = tree.before[i];
    }
}
