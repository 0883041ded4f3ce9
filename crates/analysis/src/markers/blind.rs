//! What the markers of a frame tell of each degree of freedom.

use super::problem::Problem;
use super::solve::Solver;
use nalgebra::{Cholesky, Vector3};
use solaris_dynamics::DynamicsError;

/// Errors of this size in the markers (m) …
const NOISE: f64 = 1e-3;
/// … leave a degree of freedom that they tell of within this (rad or m).
const TOLD: f64 = 0.5;

/// How far (rad or m) each unknown is off if every coordinate of every marker is off by 1 m, independently of each other: the root
/// of the diagonal of `(Σ w·Jᵀ·J)⁻¹`, scaled by the effective number of markers.
pub(super) fn lever(
    solver: &mut Solver,
    q: &[f64],
    points: &[Vector3<f64>],
) -> Result<Vec<f64>, DynamicsError> {
    let information = solver.information(q, points)?;
    let n = information.nrows();
    let count = effective_count(solver.problem, points);
    let Some(factors) = Cholesky::new(information) else { return Ok(vec![f64::INFINITY; n]) };
    let inverse = factors.inverse();
    Ok((0..n).map(|i| if count > 0.0 { (inverse[(i, i)] / count).sqrt() } else { f64::INFINITY }).collect())
}

/// Whether an unknown with this lever is not told of.
pub(super) fn is_blind(lever: f64) -> bool {
    lever * NOISE > TOLD
}

/// `(Σ w)² / Σ w²` of the markers that a frame has.
fn effective_count(problem: &Problem, points: &[Vector3<f64>]) -> f64 {
    let seen = problem.sights.iter().filter(|sight| !points[sight.column].x.is_nan());
    let (sum, squares) = seen.fold((0.0, 0.0), |(sum, squares), sight| {
        (sum + sight.weight, squares + sight.weight * sight.weight)
    });
    if squares > 0.0 { sum * sum / squares } else { 0.0 }
}
