//! Linear least squares with few unknowns and many rows.

use nalgebra::{DMatrix, DVector};

/// Rows `a·x = b`, each with a weight, gathered in normal equations.
pub(super) struct Fit {
    matrix: DMatrix<f64>,
    right: DVector<f64>,
    exact: Vec<(DVector<f64>, f64)>,
}

impl Fit {
    pub(super) fn new(unknowns: usize) -> Self {
        Self {
            matrix: DMatrix::zeros(unknowns, unknowns),
            right: DVector::zeros(unknowns),
            exact: Vec::new(),
        }
    }

    /// That one unknown is about `value`, give or take `spread`.
    pub(super) fn expect(&mut self, unknown: usize, value: f64, spread: f64) {
        let weight = spread.powi(-2);
        self.matrix[(unknown, unknown)] += weight;
        self.right[unknown] += weight * value;
    }

    /// `Σ a x = b`, give or take `spread`.
    pub(super) fn row(&mut self, row: &[f64], value: f64, spread: f64) {
        let weight = spread.powi(-2);
        let used: Vec<usize> = (0..row.len()).filter(|&k| row[k] != 0.0).collect();
        for (n, &i) in used.iter().enumerate() {
            let scaled = weight * row[i];
            for &j in &used[..=n] {
                self.matrix[(i, j)] += scaled * row[j];
            }
            self.right[i] += scaled * value;
        }
    }

    /// That `Σ a x = b`.
    pub(super) fn exactly(&mut self, row: &[f64], value: f64) {
        self.exact.push((DVector::from_column_slice(row), value));
    }

    /// The unknowns; none where they are not determined.
    ///
    /// ```text
    /// x = M⁻¹(r + Cᵀλ)      (C M⁻¹ Cᵀ) λ = d − C M⁻¹ r
    /// ```
    pub(super) fn solve(mut self) -> Option<Vec<f64>> {
        let n = self.right.len();
        // Unknowns of very different sizes: each in its own unit.
        let scale = DVector::from_fn(n, |i, _| self.matrix[(i, i)].max(f64::MIN_POSITIVE).sqrt().recip());
        for i in 0..n {
            for j in 0..=i {
                self.matrix[(i, j)] *= scale[i] * scale[j];
                self.matrix[(j, i)] = self.matrix[(i, j)];
            }
        }
        let factor = self.matrix.cholesky()?;
        let mut solved = factor.solve(&self.right.component_mul(&scale));
        if !self.exact.is_empty() {
            let rows: Vec<DVector<f64>> =
                self.exact.iter().map(|(row, _)| row.component_mul(&scale)).collect();
            let ways: Vec<DVector<f64>> = rows.iter().map(|row| factor.solve(row)).collect();
            let m = rows.len();
            let missing = DVector::from_fn(m, |i, _| self.exact[i].1 - rows[i].dot(&solved));
            let by = DMatrix::from_fn(m, m, |i, j| rows[i].dot(&ways[j])).lu().solve(&missing)?;
            ways.iter().zip(by.iter()).for_each(|(way, by)| solved.axpy(*by, way, 1.0));
        }
        let found = solved.component_mul(&scale);
        found.iter().all(|x| x.is_finite()).then(|| found.iter().copied().collect())
    }
}
