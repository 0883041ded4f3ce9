//! The shortest solution of a linear system that need not have only one.

use crate::scalar::Real;

/// Solves `W·x = b` for a symmetric `W` without negative eigenvalues: of all solutions the one with the least `x·x`.
///
/// `W = L·D·Lᵀ`, row by row; a row of which nothing is left once those before it are taken out is dependent on them, and
/// skipped. That gives a solution with zeros in the skipped places and, for each of these, one vector that `W` takes to
/// zero; the part along these is taken out. No step branches on a value, so that lanes may differ in their rank.
#[derive(Clone, Debug)]
pub(super) struct LeastNorm<T> {
    rows: usize,
    /// `W`, then `L`, by columns.
    matrix: Vec<T>,
    pivots: Vec<T>,
    /// `1/D`, zero for a skipped row.
    inverses: Vec<T>,
    /// The vectors that `W` takes to zero, by columns; zero for a row that is not skipped.
    null: Vec<T>,
    /// `NᵀN`, then its factor.
    gram: Vec<T>,
    gram_pivots: Vec<T>,
    gram_inverses: Vec<T>,
    along: Vec<T>,
    solution: Vec<T>,
}

impl<T: Real> LeastNorm<T> {
    pub(super) fn new(rows: usize) -> Self {
        let (square, line) = (vec![T::zero(); rows * rows], vec![T::zero(); rows]);
        Self {
            rows,
            matrix: square.clone(),
            pivots: line.clone(),
            inverses: line.clone(),
            null: square.clone(),
            gram: square,
            gram_pivots: line.clone(),
            gram_inverses: line.clone(),
            along: line.clone(),
            solution: line,
        }
    }

    pub(super) fn set_column(&mut self, column: usize, values: &[T]) {
        self.matrix[column * self.rows..][..self.rows].copy_from_slice(values);
    }

    pub(super) fn solution(&self) -> &[T] {
        &self.solution
    }

    pub(super) fn solve(&mut self, right: &[T]) {
        let n = self.rows;
        factor(
            n,
            &mut self.matrix,
            &mut self.pivots,
            &mut self.inverses,
            T::from_f64(T::EPSILON.sqrt()),
            None,
        );
        self.solution.copy_from_slice(right);
        substitute(n, &self.matrix, &self.inverses, &mut self.solution);
        self.find_null();
        // x ← x − N·(NᵀN)⁻¹·Nᵀ·x
        for i in 0..n {
            for j in 0..n {
                self.gram[j * n + i] = inner(column(&self.null, n, i), column(&self.null, n, j));
            }
            self.along[i] = inner(column(&self.null, n, i), &self.solution);
        }
        // A true column has a pivot of at least 1, that of its skipped row; the others are zero to rounding.
        let half = Some(T::from_f64(0.5));
        factor(n, &mut self.gram, &mut self.gram_pivots, &mut self.gram_inverses, T::zero(), half);
        substitute(n, &self.gram, &self.gram_inverses, &mut self.along);
        for k in 0..n {
            for (x, null) in self.solution.iter_mut().zip(&self.null[k * n..][..n]) {
                *x -= *null * self.along[k];
            }
        }
    }

    /// For a skipped row `k`: `n_k = 1` and `Lᵀ·n = 0` in the rows before it.
    fn find_null(&mut self) {
        let n = self.rows;
        self.null.fill(T::zero());
        for k in 0..n {
            let skipped = T::one() - self.pivots[k] * self.inverses[k];
            let null = &mut self.null[k * n..][..n];
            null[k] = skipped;
            for j in (0..k).rev() {
                let mut sum = T::zero();
                for i in j + 1..=k {
                    sum += self.matrix[j * n + i] * null[i];
                }
                null[j] = -sum;
            }
        }
    }
}

fn column<T>(matrix: &[T], rows: usize, index: usize) -> &[T] {
    &matrix[index * rows..][..rows]
}

fn inner<T: Real>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::zero(), |sum, (a, b)| sum + *a * *b)
}

/// `L·D·Lᵀ` in place, by columns, the diagonal of ones left out. A pivot is skipped where it is not above `relative` times
/// what stood on the diagonal, or not above `absolute`; its column of `L` is zero.
fn factor<T: Real>(
    n: usize,
    matrix: &mut [T],
    pivots: &mut [T],
    inverses: &mut [T],
    relative: T,
    absolute: Option<T>,
) {
    for k in 0..n {
        let whole = matrix[k * n + k];
        let mut pivot = whole;
        for j in 0..k {
            let l = matrix[j * n + k];
            pivot -= l * l * pivots[j];
        }
        pivots[k] = pivot;
        inverses[k] = pivot.recip_above(absolute.unwrap_or(whole * relative));
        for i in k + 1..n {
            let mut entry = matrix[k * n + i];
            for j in 0..k {
                entry -= matrix[j * n + i] * matrix[j * n + k] * pivots[j];
            }
            matrix[k * n + i] = entry * inverses[k];
        }
    }
}

/// Solves with the factors; the places of skipped rows become zero.
fn substitute<T: Real>(n: usize, factors: &[T], inverses: &[T], x: &mut [T]) {
    for j in 0..n {
        for i in j + 1..n {
            let removed = factors[j * n + i] * x[j];
            x[i] -= removed;
        }
    }
    for j in (0..n).rev() {
        let mut sum = x[j] * inverses[j];
        for i in j + 1..n {
            sum -= factors[j * n + i] * x[i];
        }
        x[j] = sum;
    }
}
