//! The condition of a mass matrix.

use super::prescribed::Prescribed;
use super::small::Small;
use super::state::StateMap;
use nalgebra::{DMatrix, SymmetricEigen};
use solaris_dynamics::DynamicsError;

/// The condition of the mass matrix of what dynamics move, and the degree of freedom of the full figure where it shows most.
pub(super) fn condition(
    small: &mut Small,
    state: &StateMap,
    prescribed: &Prescribed,
    t: f64,
    y: &[f64],
) -> Result<(f64, usize), DynamicsError> {
    let (condition, worst) = scaled_condition(small.mass_matrix(prescribed, t, y)?);
    Ok((condition, state.velocities()[worst]))
}

/// The condition of a symmetric positive matrix with a diagonal of ones,
///
/// ```text
/// M_ij / √(M_ii·M_jj)
/// ```
///
/// and the greatest entry of the eigenvector of its least eigenvalue; infinite where that one is not positive.
fn scaled_condition(mut matrix: DMatrix<f64>) -> (f64, usize) {
    let scale = matrix.diagonal().map(|inertia| inertia.sqrt().recip());
    // What has no inertia at all, or none that is a number.
    if let Some(worst) = scale.iter().position(|scale| !scale.is_finite()) {
        return (f64::INFINITY, worst);
    }
    for (j, mut column) in matrix.column_iter_mut().enumerate() {
        column.component_mul_assign(&scale);
        column *= scale[j];
    }
    let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(matrix);
    let (least, at) = (eigenvalues.min(), eigenvalues.imin());
    let condition = if least > 0.0 { eigenvalues.max() / least } else { f64::INFINITY };
    (condition, eigenvectors.column(at).iamax())
}

#[cfg(test)]
mod tests {
    use super::scaled_condition;
    use approx::assert_relative_eq;
    use nalgebra::DMatrix;

    fn square(n: usize, rows: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(n, n, rows)
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
}
