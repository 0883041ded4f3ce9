//! The condition of a mass matrix.

use super::prescribed::Prescribed;
use super::small::Small;
use super::state::StateMap;
use nalgebra::{DMatrix, SymmetricEigen};
use solaris_dynamics::DynamicsError;
use std::cmp::Ordering;

/// The condition of the mass matrix of what dynamics move where it is beyond `most`, and the degree of freedom of the full figure where
/// it shows most. Eigenvalues are found only where a bound of them does not tell.
pub(super) fn beyond(
    small: &mut Small,
    state: &StateMap,
    prescribed: &Prescribed,
    (t, y): (f64, &[f64]),
    most: f64,
) -> Result<Option<(f64, usize)>, DynamicsError> {
    let matrix = scaled(small.mass_matrix(prescribed, t, y)?);
    if bound(&matrix) <= most {
        return Ok(None);
    }
    let (condition, worst) = scaled_condition(matrix);
    let is_beyond = condition.partial_cmp(&most).is_none_or(Ordering::is_gt);
    Ok(is_beyond.then(|| (condition, state.velocities()[worst])))
}

/// A symmetric matrix with a diagonal of ones; not finite where there is nothing positive on the diagonal.
///
/// ```text
/// M_ij / √(M_ii·M_jj)
/// ```
fn scaled(mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    let scale = matrix.diagonal().map(|inertia| inertia.sqrt().recip());
    for (j, mut column) in matrix.column_iter_mut().enumerate() {
        column.component_mul_assign(&scale);
        column *= scale[j];
    }
    matrix
}

/// What the condition of a symmetric positive matrix does not exceed: no eigenvalue is greater than the sum of all, and so it is
/// with the inverse.
///
/// ```text
/// tr M · tr M⁻¹      M⁻¹ = L⁻ᵀ·L⁻¹
/// ```
///
/// Infinite where the matrix is not positive.
fn bound(matrix: &DMatrix<f64>) -> f64 {
    let n = matrix.nrows();
    let inverse = matrix
        .clone()
        .cholesky()
        .and_then(|root| root.l_dirty().solve_lower_triangular(&DMatrix::identity(n, n)));
    inverse.map_or(f64::INFINITY, |inverse| matrix.trace() * inverse.norm_squared())
}

/// The condition of a [scaled] symmetric positive matrix, and the greatest entry of the eigenvector of its least eigenvalue; infinite
/// where that one is not positive.
fn scaled_condition(matrix: DMatrix<f64>) -> (f64, usize) {
    // What has no inertia at all, or none that is a number.
    if let Some(worst) = matrix.diagonal().iter().position(|inertia| !inertia.is_finite()) {
        return (f64::INFINITY, worst);
    }
    let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(matrix);
    let (least, at) = (eigenvalues.min(), eigenvalues.imin());
    let condition = if least > 0.0 { eigenvalues.max() / least } else { f64::INFINITY };
    (condition, eigenvectors.column(at).iamax())
}

#[cfg(test)]
mod tests {
    use super::{bound, scaled};
    use approx::assert_relative_eq;
    use nalgebra::DMatrix;

    fn square(n: usize, rows: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(n, n, rows)
    }

    fn scaled_condition(matrix: DMatrix<f64>) -> (f64, usize) {
        super::scaled_condition(scaled(matrix))
    }

    #[test]
    fn units_do_not_count() {
        // Correlated by 0.6: eigenvalues 1.6 and 0.4.
        let (condition, _) = scaled_condition(square(2, &[1e-6, 0.6, 0.6, 1e6]));
        assert_relative_eq!(condition, 4.0, max_relative = 1e-12);
        assert_relative_eq!(scaled_condition(DMatrix::identity(3, 3)).0, 1.0);
    }

    #[test]
    fn the_worst_is_where_the_least_inertia_is() {
        let matrix = square(3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.8, 0.0, 0.8, 1.0]);
        let (condition, worst) = scaled_condition(matrix);
        assert_relative_eq!(condition, 9.0, max_relative = 1e-12);
        assert!(worst > 0);
        assert_eq!(scaled_condition(square(2, &[1.0, 0.0, 0.0, 0.0])), (f64::INFINITY, 1));
    }

    #[test]
    fn the_condition_is_not_beyond_its_bound() {
        for correlation in [0.0, 0.6, -0.999, 1.0 - 1e-9] {
            let matrix = scaled(square(2, &[1e-6, correlation, correlation, 1e6]));
            let (condition, _) = super::scaled_condition(matrix.clone());
            let bound = bound(&matrix);
            assert!((0.999_999..4.000_001).contains(&(bound / condition)), "{condition} {bound}");
        }
        assert!(bound(&scaled(square(2, &[1.0, 2.0, 2.0, 1.0]))).is_infinite());
        assert!(bound(&scaled(square(2, &[1.0, 0.0, 0.0, 0.0]))).is_infinite());
    }
}
