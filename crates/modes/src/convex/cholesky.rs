//! Symmetric matrices of which only the envelope is looked at, and Cholesky's factors in their own place.

/// Which entries of the lower triangle of a symmetric matrix (`n` × `n`, row by row) may not be zero: from `first[i]` on in row `i`.
///
/// Factors have no entry outside it that is not zero, and nothing there is read or written: of what does not touch each other each
/// block costs what it would cost alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Envelope {
    first: Vec<usize>,
}

impl Envelope {
    /// Of rows that begin at these columns.
    pub(crate) fn new(first: Vec<usize>) -> Self {
        Self { first }
    }

    /// Of a matrix that is full.
    pub(crate) fn full(n: usize) -> Self {
        Self::new(vec![0; n])
    }

    pub(crate) fn len(&self) -> usize {
        self.first.len()
    }

    /// The same rows as in another.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.first.copy_from_slice(&other.first);
    }

    /// Of so many rows; new ones are full.
    pub(crate) fn resize(&mut self, n: usize) {
        self.first.resize(n, 0);
    }

    /// Lets a row begin at a column.
    pub(crate) fn begin(&mut self, row: usize, column: usize) {
        self.first[row] = column;
    }

    /// Lets a row begin at a column or before it.
    pub(crate) fn reach(&mut self, row: usize, column: usize) {
        self.first[row] = self.first[row].min(column);
    }

    /// Where a row begins.
    pub(crate) fn first(&self, row: usize) -> usize {
        self.first[row]
    }

    /// Puts a matrix of an envelope within this one into another one's place.
    pub(crate) fn copy(&self, from: (&Self, &[f64]), matrix: &mut [f64]) {
        let n = self.len();
        for i in 0..n {
            let (first, begins) = (self.first[i], from.0.first[i]);
            let row = &mut matrix[i * n..][..=i];
            row[first..begins].fill(0.0);
            row[begins..].copy_from_slice(&from.1[i * n..][begins..=i]);
        }
    }

    /// `y = A·x`
    pub(crate) fn times(&self, matrix: &[f64], x: &[f64], y: &mut [f64]) {
        let n = self.len();
        y.fill(0.0);
        for i in 0..n {
            let first = self.first[i];
            let row = &matrix[i * n..][first..=i];
            let (left, diagonal) = row.split_at(i - first);
            y[i] += dot(left, &x[first..i]) + diagonal[0] * x[i];
            for (y, entry) in y[first..i].iter_mut().zip(left) {
                *y += entry * x[i];
            }
        }
    }

    /// Overwrites the lower triangle of a positive definite matrix with `L`, `L·Lᵀ = A`.
    pub(crate) fn factor(&self, matrix: &mut [f64]) {
        let n = self.len();
        for i in 0..n {
            let (above, rest) = matrix.split_at_mut(i * n);
            let (row, first) = (&mut rest[..n], self.first[i]);
            for j in first..i {
                let other = &above[j * n..][..n];
                let from = first.max(self.first[j]);
                row[j] = (row[j] - dot(&row[from..j], &other[from..j])) / other[j];
            }
            // Positive but for rounding.
            row[i] = (row[i] - dot(&row[first..i], &row[first..i])).max(f64::MIN_POSITIVE).sqrt();
        }
    }

    /// Solves `L·Lᵀ·x = b` in the place of `b`.
    pub(crate) fn solve(&self, factors: &[f64], x: &mut [f64]) {
        let n = self.len();
        for i in 0..n {
            let (row, first) = (&factors[i * n..][..n], self.first[i]);
            x[i] = (x[i] - dot(&row[first..i], &x[first..i])) / row[i];
        }
        for i in (0..n).rev() {
            let (row, first) = (&factors[i * n..][..n], self.first[i]);
            x[i] /= row[i];
            let value = x[i];
            for (x, factor) in x[first..i].iter_mut().zip(&row[first..i]) {
                *x -= factor * value;
            }
        }
    }
}

/// `a·b`, in eight sums at a time, which the machine has registers for.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (heads, others) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = heads.remainder().iter().zip(others.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; 8];
    for (a, b) in heads.zip(others) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    sums.iter().sum::<f64>() + rest
}
