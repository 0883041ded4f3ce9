//! Cholesky's factors of a small dense matrix, in its own place.

/// Overwrites the lower triangle of a symmetric positive definite matrix (`n` × `n`, row by row) with `L`, `L·Lᵀ = A`.
///
/// Entries left of the first of a row that is not zero stay zero and cost nothing: mass matrices of trees have many of them.
pub(super) fn factor(matrix: &mut [f64], n: usize) {
    for i in 0..n {
        let (above, rest) = matrix.split_at_mut(i * n);
        let row = &mut rest[..n];
        let first = row[..i].iter().position(|x| *x != 0.0).unwrap_or(i);
        for j in first..i {
            let other = &above[j * n..][..n];
            let sum: f64 = row[first..j].iter().zip(&other[first..j]).map(|(a, b)| a * b).sum();
            row[j] = (row[j] - sum) / other[j];
        }
        let sum: f64 = row[first..i].iter().map(|x| x * x).sum();
        // Positive but for rounding.
        row[i] = (row[i] - sum).max(f64::MIN_POSITIVE).sqrt();
    }
}

/// Solves `L·Lᵀ·x = b` in the place of `b`.
pub(super) fn solve(factors: &[f64], n: usize, x: &mut [f64]) {
    for i in 0..n {
        let row = &factors[i * n..][..n];
        let sum: f64 = row[..i].iter().zip(&x[..i]).map(|(a, b)| a * b).sum();
        x[i] = (x[i] - sum) / row[i];
    }
    for i in (0..n).rev() {
        let row = &factors[i * n..][..n];
        x[i] /= row[i];
        let value = x[i];
        for (x, factor) in x[..i].iter_mut().zip(row) {
            *x -= factor * value;
        }
    }
}
