//! Symmetric positive definite systems with three diagonals on either side.

/// The Cholesky factor `L` of `A = L Lᵀ`; row i keeps L[i][i−3 … i].
pub(crate) struct Band(Vec<[f64; 4]>);

impl Band {
    /// Factors the matrix whose row i holds `rows[i] = A[i][i−3 … i]`.
    pub(crate) fn factor(mut rows: Vec<[f64; 4]>) -> Self {
        for i in 0..rows.len() {
            for j in i.saturating_sub(3)..=i {
                let column = j + 3 - i;
                let mut sum = rows[i][column];
                for k in i.saturating_sub(3)..j {
                    if k + 3 >= j {
                        sum -= rows[i][k + 3 - i] * rows[j][k + 3 - j];
                    }
                }
                rows[i][column] = if i == j { sum.sqrt() } else { sum / rows[j][3] };
            }
        }
        Self(rows)
    }

    /// Solves for several right sides at once, in place.
    pub(crate) fn solve<const D: usize>(&self, rhs: &mut [[f64; D]]) {
        let n = self.0.len();
        for i in 0..n {
            for k in i.saturating_sub(3)..i {
                let l = self.0[i][k + 3 - i];
                for d in 0..D {
                    rhs[i][d] -= l * rhs[k][d];
                }
            }
            rhs[i].iter_mut().for_each(|x| *x /= self.0[i][3]);
        }
        for i in (0..n).rev() {
            for k in i + 1..(i + 4).min(n) {
                let l = self.0[k][i + 3 - k];
                for d in 0..D {
                    rhs[i][d] -= l * rhs[k][d];
                }
            }
            rhs[i].iter_mut().for_each(|x| *x /= self.0[i][3]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_solves_what_it_factored() {
        let n = 9;
        let entry = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 5.0 + i as f64 * 0.3,
            1 => -2.7,
            2 => 0.27,
            3 => -0.02,
            _ => 0.0,
        };
        let rows = (0..n).map(|i| [3, 2, 1, 0].map(|k| if i >= k { entry(i, i - k) } else { 0.0 })).collect();
        let mut x: Vec<[f64; 2]> = (0..n).map(|i| [i as f64, 1.0]).collect();
        Band::factor(rows).solve(&mut x);
        for i in 0..n {
            let sum: f64 = (0..n).map(|j| entry(i, j) * x[j][0]).sum();
            assert!((sum - i as f64).abs() < 1e-12);
        }
    }
}
