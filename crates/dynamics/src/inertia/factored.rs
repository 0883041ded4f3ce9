//! The mass matrix in factors that are zero wherever it is: between different branches.

use crate::scalar::Scalar;
use crate::spatial::symmetric::Symmetric;
use crate::tree::Tree;
use crate::workspace::Workspace;
use nalgebra::DMatrix;

/// A pivot that keeps less than this part of its entry has lost too many digits.
const LEAST: f64 = 1e-9;

/// `M = Lᵀ·D·L`, with `L` one on its diagonal and zero but on the paths to the root.
///
/// R. Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees", Int. J. Robotics Research 24
/// (2005) 487–500.
#[derive(Clone, Debug)]
pub(crate) struct Factored<T> {
    /// Of each degree of freedom those before it on its path, the nearest one first; all of them one after the other, and where each
    /// one's begin.
    paths: Vec<usize>,
    starts: Vec<usize>,
    /// `L` along these paths.
    lower: Vec<T>,
    /// `1/D`
    pivots: Vec<T>,
    /// One row of right sides.
    row: Vec<T>,
}

impl<T: Scalar> Factored<T> {
    /// For right sides of at most `width` columns.
    pub(crate) fn new(tree: &Tree<T>, width: usize) -> Self {
        let (mut paths, mut starts) = (Vec::new(), vec![0]);
        for k in 0..tree.nv() {
            let mut next = tree.before[k];
            while let Some(i) = next {
                paths.push(i);
                next = tree.before[i];
            }
            starts.push(paths.len());
        }
        Self {
            lower: vec![T::zero(); paths.len()],
            pivots: vec![T::zero(); tree.nv()],
            row: vec![T::zero(); width],
            paths,
            starts,
        }
    }

    /// Factors a mass matrix; whether enough of every pivot is left.
    pub(crate) fn factor(&mut self, mass: &DMatrix<T>) -> bool {
        let n = self.pivots.len();
        for k in 0..n {
            self.pivots[k] = mass[(k, k)];
            for p in self.starts[k]..self.starts[k + 1] {
                self.lower[p] = mass[(self.paths[p], k)];
            }
        }
        let mut is_sound = true;
        for k in (0..n).rev() {
            let pivot = self.pivots[k];
            is_sound &= (pivot / mass[(k, k)]).all_within(LEAST, 2.0);
            self.pivots[k] = T::one() / pivot;
            let (start, end) = (self.starts[k], self.starts[k + 1]);
            for p in start..end {
                let i = self.paths[p];
                let part = self.lower[p] * self.pivots[k];
                self.pivots[i] -= part * self.lower[p];
                // The path of i is what is left of this one.
                let rest = self.starts[i + 1] - self.starts[i];
                let (before, own) = self.lower.split_at_mut(start);
                let to = &mut before[self.starts[i]..][..rest];
                for (to, from) in to.iter_mut().zip(&own[p + 1 - start..][..rest]) {
                    *to -= part * *from;
                }
            }
            for p in start..end {
                self.lower[p] *= self.pivots[k];
            }
        }
        is_sound
    }

    /// Solves `M·X = B` in place; `right` holds `B` row by row, each `width` long.
    pub(crate) fn solve(&mut self, right: &mut [T], width: usize) {
        let n = self.pivots.len();
        let row = &mut self.row[..width];
        for k in (0..n).rev() {
            row.copy_from_slice(&right[k * width..][..width]);
            for p in self.starts[k]..self.starts[k + 1] {
                let (by, to) = (self.lower[p], &mut right[self.paths[p] * width..][..width]);
                to.iter_mut().zip(&*row).for_each(|(to, from)| *to -= by * *from);
            }
        }
        for k in 0..n {
            row.copy_from_slice(&right[k * width..][..width]);
            for x in row.iter_mut() {
                *x *= self.pivots[k];
            }
            for p in self.starts[k]..self.starts[k + 1] {
                let (by, from) = (self.lower[p], &right[self.paths[p] * width..][..width]);
                row.iter_mut().zip(from).for_each(|(to, from)| *to -= by * *from);
            }
            right[k * width..][..width].copy_from_slice(row);
        }
    }
}

/// Puts the inverse of the mass matrix that `workspace` was used for last in its place; `false` where too little of a pivot is left beside
/// what it was made of, and then the matrix means nothing.
///
/// Above the diagonal stand first the factors of [`Factored`]; below it the inverse is found column by column. With `x` the column `j`,
/// of which what stands before `j` is known as the row,
///
/// ```text
/// x_j = 1/D_j − Σ L_ji·x_i          x_k = −Σ L_ki·x_i  for k > j
/// ```
///
/// over `i` before `j` and `k` on their paths.
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
    for j in 0..n {
        for (i, x) in column[..j].iter_mut().enumerate() {
            *x = entries[i * n + j];
        }
        for k in j..n {
            let mut sum = if k == j { entries[j * n + j] } else { T::zero() };
            let own = &entries[k * n..][..=k];
            let mut next = tree.before[k];
            while let Some(i) = next {
                sum -= own[i] * column[i];
                next = tree.before[i];
            }
            column[k] = sum;
        }
        entries[j * n + j..][..n - j].copy_from_slice(&column[j..]);
    }
    for j in 0..n {
        for i in 0..j {
            entries[j * n + i] = entries[i * n + j];
        }
    }
    true
}
