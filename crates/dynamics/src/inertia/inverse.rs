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
/// `M = Lᵀ·D·L`, with `L` one on its diagonal and zero but on the paths to the root. First its entries stand above the diagonal and `1/D` on it;
/// then the inverse grows row by row, its symmetric half with it:
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
    // The diagonal, with the inertia that it is a part of.
    for (body, composite) in tree.bodies.iter().zip(&workspace.composites) {
        let Symmetric { xx, yy, zz, .. } = composite.inertia;
        for k in body.first..body.end {
            let whole = if tree.dofs[k].kind.turns() { xx + yy + zz } else { composite.mass };
            column[k] = entries[k * n + k] + whole;
        }
    }
    for k in (0..n).rev() {
        let pivot = entries[k * n + k];
        is_sound &= (pivot / column[k]).all_within(LEAST, 2.0);
        let inverse = T::one() / pivot;
        let mut next = tree.before[k];
        while let Some(i) = next {
            let part = entries[k * n + i] * inverse;
            let mut last = Some(i);
            while let Some(l) = last {
                let taken = part * entries[k * n + l];
                entries[i * n + l] -= taken;
                last = tree.before[l];
            }
            entries[k * n + i] = part;
            next = tree.before[i];
        }
        entries[k * n + k] = inverse;
    }
    if !is_sound {
        return false;
    }
    for k in 0..n {
        let (before, rest) = entries.split_at_mut(k * n);
        let own = &mut rest[..=k];
        column[..k].copy_from_slice(&own[..k]);
        own[..k].fill(T::zero());
        let mut next = tree.before[k];
        // Two at a time, so that what they are taken from is read and written half as often.
        while let Some(i) = next {
            let (a, one) = (column[i], &before[i * n..][..k]);
            next = tree.before[i];
            if let Some(l) = next {
                let (b, two) = (column[l], &before[l * n..][..k]);
                let both = one.iter().zip(two);
                own[..k].iter_mut().zip(both).for_each(|(x, (one, two))| *x -= a * *one + b * *two);
                next = tree.before[l];
            } else {
                own[..k].iter_mut().zip(one).for_each(|(x, one)| *x -= a * *one);
            }
        }
        let mut next = tree.before[k];
        while let Some(i) = next {
            let taken = column[i] * own[i];
            own[k] -= taken;
            next = tree.before[i];
        }
        for (j, x) in own[..k].iter().enumerate() {
            before[j * n + k] = *x;
        }
    }
    true
}
