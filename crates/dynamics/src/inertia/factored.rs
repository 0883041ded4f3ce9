//! The mass matrix in factors that are zero wherever it is: between different branches.

use crate::scalar::Scalar;
use crate::tree::Tree;
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
        for body in &tree.bodies {
            for k in body.first..body.end {
                paths.extend((body.first..k).rev());
                let mut above = body.parent;
                while let Some(link) = above {
                    let body = &tree.bodies[link];
                    paths.extend((body.first..body.end).rev());
                    above = body.parent;
                }
                starts.push(paths.len());
            }
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
