//! Cholesky's factors of a small dense matrix, in its own place.

/// Overwrites the lower triangle of a symmetric positive definite matrix (`n` × `n`, row by row) with `L`, `L·Lᵀ = A`.
///
/// Entries left of the first of a row that is not zero stay zero and cost nothing: mass matrices of trees have many of them.
pub(crate) fn factor(matrix: &mut [f64], n: usize) {
    for i in 0..n {
        let (above, rest) = matrix.split_at_mut(i * n);
        let row = &mut rest[..n];
        let first = row[..i].iter().position(|x| *x != 0.0).unwrap_or(i);
        for j in first..i {
            let other = &above[j * n..][..n];
            row[j] = (row[j] - dot(&row[first..j], &other[first..j])) / other[j];
        }
        // Positive but for rounding.
        row[i] = (row[i] - dot(&row[first..i], &row[first..i])).max(f64::MIN_POSITIVE).sqrt();
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

/// Solves `L·Lᵀ·x = b` in the place of `b`.
pub(crate) fn solve(factors: &[f64], n: usize, x: &mut [f64]) {
    for i in 0..n {
        let row = &factors[i * n..][..n];
        x[i] = (x[i] - dot(&row[..i], &x[..i])) / row[i];
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
