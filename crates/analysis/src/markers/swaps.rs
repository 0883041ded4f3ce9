//! Labels that two markers exchanged, for some frames or for all.

use super::chain::{self, Frame};
use super::options::IkError;
use super::problem::Problem;
use super::solve::Solver;
use nalgebra::Vector3;

/// Two markers of which each is nearer to the other's place by this factor (of summed squares) have exchanged their labels …
const NEARER: f64 = 0.25;
/// … if the objective falls below this part of what it was.
const LOWER: f64 = 0.8;
/// Markers nearer to each other than this (m) are not told apart by their places.
const APART: f64 = 0.02;
/// The most pairs that are looked for in one frame.
const MOST_PAIRS: usize = 4;

/// Two markers whose labels were exchanged in some frames, and are changed back for the result.
#[derive(Clone, Debug, PartialEq)]
pub struct Swap {
    /// The markers' names in the trial.
    pub names: [String; 2],
    /// The first frame.
    pub first: usize,
    /// The last frame.
    pub last: usize,
}

/// Exchanges labels back in `points` where that lowers the objective much, and solves those frames again.
pub(super) fn mend(
    problem: &Problem,
    points: &mut [Vector3<f64>],
    solved: &mut [Frame],
) -> Result<Vec<Swap>, IkError> {
    let mut solver = Solver::new(problem);
    let width = problem.trial.names().len();
    let mut swaps: Vec<Swap> = Vec::new();
    for row in 0..solved.len() {
        for _ in 0..MOST_PAIRS {
            let places = solver.places(&solved[row].q)?;
            let Some([a, b]) = exchanged(problem, &places, problem.row(points, row)) else { break };
            points.swap(row * width + a, row * width + b);
            let next = chain::again(&mut solver, points, solved, row)?;
            if next.solved.cost >= LOWER * solved[row].solved.cost {
                points.swap(row * width + a, row * width + b);
                break;
            }
            solved[row] = next;
            let names = [a, b].map(|column| problem.trial.names()[column].clone());
            match swaps.iter_mut().find(|swap| swap.names == names && swap.last + 1 == row) {
                Some(swap) => swap.last = row,
                None => swaps.push(Swap { names, first: row, last: row }),
            }
        }
    }
    // What follows began from frames that were wrong.
    let mut ends: Vec<usize> =
        swaps.iter().map(|swap| swap.last + 1).filter(|row| *row < solved.len()).collect();
    ends.sort_unstable();
    for row in ends {
        chain::mend(&mut solver, points, solved, row)?;
    }
    Ok(swaps)
}

/// The two columns of the trial whose exchange brings both much nearer to the figure's markers; of several pairs the one that
/// gains most.
fn exchanged(problem: &Problem, places: &[Vector3<f64>], points: &[Vector3<f64>]) -> Option<[usize; 2]> {
    let mut best: Option<(f64, [usize; 2])> = None;
    for (i, one) in problem.sights.iter().enumerate() {
        let seen = points[one.column];
        for (j, two) in problem.sights.iter().enumerate().skip(i + 1) {
            let other = points[two.column];
            // Comparisons with hidden points are false.
            if (seen - other).norm_squared() > APART * APART {
                let as_told = (places[i] - seen).norm_squared() + (places[j] - other).norm_squared();
                let exchanged = (places[i] - other).norm_squared() + (places[j] - seen).norm_squared();
                let gain = as_told - exchanged;
                if exchanged < NEARER * as_told && best.is_none_or(|(most, _)| gain > most) {
                    best = Some((gain, [one.column, two.column]));
                }
            }
        }
    }
    best.map(|(_, pair)| pair)
}
