//! Four linear equations.

use super::Number;

/// The solution of `matrix · x = right`, by elimination with partial pivoting; numbers that are not finite where there is
/// none.
pub(super) fn solve<F: Number>(mut matrix: [[F; 4]; 4], mut right: [F; 4]) -> [F; 4] {
    for column in 0..4 {
        let mut pivot = column;
        for row in column + 1..4 {
            if matrix[row][column].abs() > matrix[pivot][column].abs() {
                pivot = row;
            }
        }
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        for row in column + 1..4 {
            let factor = matrix[row][column] / matrix[column][column];
            for k in column..4 {
                matrix[row][k] = matrix[row][k] - factor * matrix[column][k];
            }
            right[row] = right[row] - factor * right[column];
        }
    }
    let mut x = [F::zero(); 4];
    for row in (0..4).rev() {
        let rest = (row + 1..4).fold(right[row], |rest, k| rest - matrix[row][k] * x[k]);
        x[row] = rest / matrix[row][row];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_swapped_where_they_must_be() {
        let matrix =
            [[0.0, 2.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 4.0, 1.0], [0.0, 2.0, 0.0, -1.0]];
        // By hand: x = 3; 2y + w = 5 and 2y − w = 3, so y = 2, w = 1; 4z + 1 = −7.
        let found = solve(matrix, [5.0, 3.0, -7.0, 3.0]);
        for (found, right) in found.into_iter().zip([3.0, 2.0, -2.0, 1.0]) {
            assert!(f64::abs(found - right) < 1e-15);
        }
    }
}
