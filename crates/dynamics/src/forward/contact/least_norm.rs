//! The shortest solution of a linear system that need not have only one.

use crate::scalar::Scalar;

/// Solves `W·x = b` for a symmetric `W` without negative eigenvalues: of all solutions the one with the least `x·x`.
///
/// `W = L·D·Lᵀ`, the row of which most is left first; a row of which nothing is left once those before it are taken out is
/// dependent on them, and skipped. That gives a solution with zeros in the skipped places and, for each of these, one
/// vector that `W` takes to zero; the part along these is taken out. What is left of `b` is solved for once more.
///
/// No lane depends on another but in the order of the rows, which is that of the lane where most is left: lanes may
/// differ in their rank.
#[derive(Clone, Debug)]
pub(super) struct LeastNorm<T> {
    rows: usize,
    /// `W`, by columns.
    matrix: Vec<T>,
    factor: Factor<T>,
    /// The vectors that `W` takes to zero, by columns; zero for a row that is not skipped.
    null: Vec<T>,
    /// `NᵀN`.
    gram: Vec<T>,
    gram_factor: Factor<T>,
    /// How much of a solution is along each of them.
    along: Vec<T>,
    left: Vec<T>,
    correction: Vec<T>,
    solution: Vec<T>,
}

/// `L·D·Lᵀ` of a matrix whose rows are taken in an order of their own.
#[derive(Clone, Debug)]
struct Factor<T> {
    /// The row taken at each step.
    order: Vec<usize>,
    /// By step: its column of `L`, in the places of the rows taken later; zero for a skipped row.
    columns: Vec<T>,
    pivots: Vec<T>,
    /// `1/D`, zero for a skipped row.
    inverses: Vec<T>,
    /// What is left of the diagonal.
    remaining: Vec<T>,
}

impl<T: Scalar> LeastNorm<T> {
    pub(super) fn new(rows: usize) -> Self {
        let (square, line) = (vec![T::zero(); rows * rows], vec![T::zero(); rows]);
        Self {
            rows,
            matrix: square.clone(),
            factor: Factor::new(rows),
            null: square.clone(),
            gram: square,
            gram_factor: Factor::new(rows),
            along: line.clone(),
            left: line.clone(),
            correction: line.clone(),
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
        self.factor.factor(&self.matrix, |whole| whole * T::from_f64(T::EPSILON.sqrt()));
        self.find_null();
        for i in 0..n {
            for j in 0..n {
                self.gram[j * n + i] = inner(&self.null[i * n..][..n], &self.null[j * n..][..n]);
            }
        }
        // A true column has a pivot of at least 1, that of its skipped row; the others are zero to rounding.
        self.gram_factor.factor(&self.gram, |_| T::from_f64(0.5));
        self.solution.fill(T::zero());
        self.left.copy_from_slice(right);
        self.correct();
        for i in 0..n {
            let reached = (0..n).fold(T::zero(), |sum, j| sum + self.matrix[j * n + i] * self.solution[j]);
            self.left[i] = right[i] - reached;
        }
        self.correct();
    }

    /// Adds to the solution what `left` asks for, and takes out what is along the null vectors:
    /// `x ← x − N·(NᵀN)⁻¹·Nᵀ·x`.
    fn correct(&mut self) {
        let n = self.rows;
        self.correction.copy_from_slice(&self.left);
        self.factor.substitute(&mut self.correction);
        for (x, correction) in self.solution.iter_mut().zip(&self.correction) {
            *x += *correction;
        }
        for k in 0..n {
            self.along[k] = inner(&self.null[k * n..][..n], &self.solution);
        }
        self.gram_factor.substitute(&mut self.along);
        for k in 0..n {
            for (x, null) in self.solution.iter_mut().zip(&self.null[k * n..][..n]) {
                *x -= *null * self.along[k];
            }
        }
    }

    /// For the row `p` skipped at a step: `n_p = 1` and `Lᵀ·n = 0` in the rows taken before it.
    fn find_null(&mut self) {
        let (n, factor) = (self.rows, &self.factor);
        self.null.fill(T::zero());
        for step in 0..n {
            let null = &mut self.null[step * n..][..n];
            null[factor.order[step]] = T::one() - factor.pivots[step] * factor.inverses[step];
            for before in (0..step).rev() {
                let column = &factor.columns[before * n..][..n];
                let taken = &factor.order[before + 1..=step];
                let sum = taken.iter().fold(T::zero(), |sum, &row| sum + column[row] * null[row]);
                null[factor.order[before]] = -sum;
            }
        }
    }
}

impl<T: Scalar> Factor<T> {
    fn new(rows: usize) -> Self {
        let line = vec![T::zero(); rows];
        Self {
            order: (0..rows).collect(),
            columns: vec![T::zero(); rows * rows],
            pivots: line.clone(),
            inverses: line.clone(),
            remaining: line,
        }
    }

    /// Skips a row where what is left on the diagonal is not above the `threshold` for what stood there.
    fn factor(&mut self, matrix: &[T], threshold: impl Fn(T) -> T) {
        let n = self.order.len();
        self.columns.fill(T::zero());
        for i in 0..n {
            (self.order[i], self.remaining[i]) = (i, matrix[i * n + i]);
        }
        for step in 0..n {
            let share =
                |row: usize| (self.remaining[row] * matrix[row * n + row].recip_above(T::zero())).greatest();
            let mut next = step;
            for other in step + 1..n {
                if share(self.order[other]) > share(self.order[next]) {
                    next = other;
                }
            }
            self.order.swap(step, next);
            let row = self.order[step];
            let pivot = self.remaining[row];
            let inverse = pivot.recip_above(threshold(matrix[row * n + row]));
            (self.pivots[step], self.inverses[step]) = (pivot, inverse);
            for &later in &self.order[step + 1..] {
                let mut entry = matrix[row * n + later];
                for before in 0..step {
                    let column = &self.columns[before * n..][..n];
                    entry -= column[later] * column[row] * self.pivots[before];
                }
                let scaled = entry * inverse;
                self.columns[step * n + later] = scaled;
                self.remaining[later] -= scaled * scaled * pivot;
            }
        }
    }

    /// Solves with the factors; the places of skipped rows become zero.
    fn substitute(&self, x: &mut [T]) {
        let n = self.order.len();
        for step in 0..n {
            let (known, column) = (x[self.order[step]], &self.columns[step * n..][..n]);
            for &later in &self.order[step + 1..] {
                x[later] -= column[later] * known;
            }
        }
        for step in (0..n).rev() {
            let (row, column) = (self.order[step], &self.columns[step * n..][..n]);
            let mut sum = x[row] * self.inverses[step];
            for &later in &self.order[step + 1..] {
                sum -= column[later] * x[later];
            }
            x[row] = sum;
        }
    }
}

fn inner<T: Scalar>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::zero(), |sum, (a, b)| sum + *a * *b)
}
