//! The condition of a mass matrix.

use super::prescribed::Prescribed;
use super::small::Small;
use super::state::StateMap;
use nalgebra::{DMatrix, SymmetricEigen};
use solaris_dynamics::DynamicsError;
use std::cmp::Ordering;

/// The most degrees of freedom moved by dynamics whose mass matrix is looked at: it has as many entries as their square.
pub(super) const MOST: usize = 10_000;

/// The most of them in one part, within which each may act on each: looking at it takes as many operations as their third power.
pub(super) const MOST_IN_PART: usize = 2000;

/// The condition of the mass matrix of what dynamics move where it is beyond `most`, and the degree of freedom of the full figure where
/// it shows most. Eigenvalues are found only where a bound of them does not tell, and all of it part by part: bodies that nothing joins do
/// not act on each other by their inertia. Of more than [`MOST`] nothing is said, nor of parts larger than [`MOST_IN_PART`]: what has
/// no inertia there is found where accelerations are.
pub(super) fn beyond(
    small: &mut Small,
    state: &StateMap,
    prescribed: &Prescribed,
    (t, y): (f64, &[f64]),
    most: f64,
) -> Result<Option<(f64, usize)>, DynamicsError> {
    if state.dofs() > MOST {
        return Ok(None);
    }
    let matrix = scaled(small.mass_matrix(prescribed, t, y)?);
    let mut parts = parts(&matrix);
    parts.retain(|part| part.len() <= MOST_IN_PART);
    let blocks: Vec<DMatrix<f64>> = parts
        .iter()
        .map(|part| DMatrix::from_fn(part.len(), part.len(), |i, j| matrix[(part[i], part[j])]))
        .collect();
    drop(matrix);
    if bound(&blocks) <= most {
        return Ok(None);
    }
    let (condition, worst) = condition_of(blocks, &parts);
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

/// The rows of a symmetric matrix in parts that have nothing but zeros between them, each rising.
fn parts(matrix: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let n = matrix.nrows();
    let (mut parts, mut open): (Vec<Vec<usize>>, Vec<usize>) = (Vec::new(), (0..n).rev().collect());
    // What is still open has no part yet; all that a row of a part meets joins it.
    while let Some(first) = open.pop() {
        let mut part = vec![first];
        let mut next = 0;
        while let Some(&row) = part.get(next) {
            let met = |other: &usize| {
                let entry: f64 = matrix[(*other, row)];
                entry.abs() > 0.0 || entry.is_nan()
            };
            part.extend(open.extract_if(.., |other| met(other)));
            next += 1;
        }
        part.sort_unstable();
        parts.push(part);
    }
    parts
}

/// What the condition of a symmetric positive matrix in separate parts does not exceed: no eigenvalue is greater than the sum of all,
/// and so it is with the inverse.
///
/// ```text
/// tr M · tr M⁻¹      M⁻¹ = L⁻ᵀ·L⁻¹
/// ```
///
/// Infinite where the matrix is not positive.
fn bound(blocks: &[DMatrix<f64>]) -> f64 {
    let (mut trace, mut inverse) = (0.0, 0.0);
    for block in blocks {
        let n = block.nrows();
        let root = block.clone().cholesky();
        let own = root.and_then(|root| root.l_dirty().solve_lower_triangular(&DMatrix::identity(n, n)));
        let Some(own) = own else { return f64::INFINITY };
        trace += block.trace();
        inverse += own.norm_squared();
    }
    trace * inverse
}

/// The condition of a [scaled] symmetric positive matrix in separate blocks, and the row with the greatest entry of the eigenvector of its
/// least eigenvalue, of the `rows` of each; infinite where that eigenvalue is not positive.
fn condition_of(blocks: Vec<DMatrix<f64>>, rows: &[Vec<usize>]) -> (f64, usize) {
    let (mut least, mut most, mut worst) = (f64::INFINITY, 0.0_f64, 0);
    for (block, rows) in blocks.into_iter().zip(rows) {
        // What has no inertia at all, or none that is a number.
        if let Some(none) = block.diagonal().iter().position(|inertia| !inertia.is_finite()) {
            return (f64::INFINITY, rows[none]);
        }
        let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(block);
        most = most.max(eigenvalues.max());
        if eigenvalues.min() < least {
            least = eigenvalues.min();
            worst = rows[eigenvectors.column(eigenvalues.imin()).iamax()];
        }
    }
    (if least > 0.0 { most / least } else { f64::INFINITY }, worst)
}

#[cfg(test)]
mod tests {
    use super::{condition_of, parts, scaled};
    use approx::assert_relative_eq;
    use nalgebra::DMatrix;

    fn square(n: usize, rows: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(n, n, rows)
    }

    fn blocks(matrix: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        let block = |part: &Vec<usize>| matrix.select_rows(part).select_columns(part);
        parts(matrix).iter().map(block).collect()
    }

    fn bound(matrix: &DMatrix<f64>) -> f64 {
        super::bound(&blocks(matrix))
    }

    fn scaled_condition(matrix: DMatrix<f64>) -> (f64, usize) {
        let matrix = scaled(matrix);
        condition_of(blocks(&matrix), &parts(&matrix))
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
    fn bodies_that_nothing_joins_are_looked_at_one_by_one() {
        // 0 with 3, 1 alone, 2 with 4.
        let mut matrix = DMatrix::identity(5, 5);
        for (i, j, entry) in [(0, 3, 0.6), (2, 4, 0.8)] {
            (matrix[(i, j)], matrix[(j, i)]) = (entry, entry);
        }
        assert_eq!(parts(&matrix), [vec![0, 3], vec![1], vec![2, 4]]);
        let (condition, worst) = scaled_condition(matrix.clone());
        // Of all: 1.8 is the greatest eigenvalue, 0.2 the least.
        assert_relative_eq!(condition, 9.0, max_relative = 1e-12);
        assert!([2, 4].contains(&worst));
        assert!((9.0..90.0).contains(&bound(&matrix)));
    }

    #[test]
    fn the_condition_is_not_beyond_its_bound() {
        for correlation in [0.0, 0.6, -0.999, 1.0 - 1e-9] {
            let matrix = scaled(square(2, &[1e-6, correlation, correlation, 1e6]));
            let (condition, _) = condition_of(blocks(&matrix), &parts(&matrix));
            let bound = bound(&matrix);
            assert!((0.999_999..4.000_001).contains(&(bound / condition)), "{condition} {bound}");
        }
        assert!(bound(&scaled(square(2, &[1.0, 2.0, 2.0, 1.0]))).is_infinite());
        assert!(bound(&scaled(square(2, &[1.0, 0.0, 0.0, 0.0]))).is_infinite());
    }
}
