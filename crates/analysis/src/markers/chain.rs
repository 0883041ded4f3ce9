//! All frames: each from the one before it, in chains of a fixed length that are solved side by side.

use super::options::IkError;
use super::problem::Problem;
use super::solve::{Solved, Solver};
use super::start;
use crate::prepared::each;
use nalgebra::Vector3;
use solaris_dynamics::DynamicsError;

/// How many frames a chain has.
const CHAIN: usize = 32;
/// A frame this many times worse than the best of the heads before it is looked at from all sides.
const POOR: f64 = 4.0;
/// Minima that differ by less than this part are equally good.
const EQUAL: f64 = 1e-9;
/// Configurations nearer than this are the same (rad, m).
const SAME: f64 = 1e-6;

/// One solved frame.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub(super) q: Vec<f64>,
    pub(super) solved: Solved,
}

/// Solves every frame of `points`.
pub(super) fn solve(problem: &Problem, points: &[Vector3<f64>]) -> Result<Vec<Frame>, IkError> {
    let heads = heads(problem, points)?;
    let frames = problem.trial.len();
    let chains = each(
        0..heads.len(),
        || Solver::new(problem),
        |solver, chain| {
            let first = chain * CHAIN;
            let mut solved = vec![heads[chain].clone()];
            for frame in first + 1..frames.min(first + CHAIN) {
                let next = from_before(solver, &solved, problem.row(points, frame))?;
                solved.push(next);
            }
            Ok::<_, DynamicsError>(solved)
        },
    )?;
    let mut solved: Vec<Frame> = chains.into_iter().flatten().collect();
    let mut solver = Solver::new(problem);
    for seam in (CHAIN..frames).step_by(CHAIN) {
        mend(&mut solver, points, &mut solved, seam)?;
    }
    Ok(solved)
}

/// A frame whose points have changed, solved anew: from the frame before it, the first one from rest.
pub(super) fn again(
    solver: &mut Solver,
    points: &[Vector3<f64>],
    solved: &[Frame],
    row: usize,
) -> Result<Frame, DynamicsError> {
    let points = solver.problem.row(points, row);
    if row > 0 {
        return from_before(solver, &solved[row - 1..row], points);
    }
    let mut q = solver.problem.rest.clone();
    let solved = start::solve(solver, &mut q, points)?;
    Ok(Frame { q, solved })
}

/// The first frame of each chain, each from the one before it.
fn heads(problem: &Problem, points: &[Vector3<f64>]) -> Result<Vec<Frame>, IkError> {
    let mut solver = Solver::new(problem);
    let mut heads: Vec<Frame> = Vec::new();
    let mut best = f64::INFINITY;
    for row in (0..problem.trial.len()).step_by(CHAIN) {
        let points = problem.row(points, row);
        let mut q = heads.last().map_or_else(|| problem.rest.clone(), |head| head.q.clone());
        let mut solved = solver.solve(&mut q, points, |_| true)?;
        if heads.is_empty() || !solved.converged || solved.cost > POOR * best {
            let mut other = problem.rest.clone();
            let found = start::solve(&mut solver, &mut other, points)?;
            if found.cost < solved.cost * (1.0 - EQUAL) {
                (q, solved) = (other, found);
            }
        }
        let sees = problem.sights.iter().any(|sight| !points[sight.column].x.is_nan());
        if sees {
            best = best.min(solved.cost);
        }
        heads.push(Frame { q, solved });
    }
    Ok(heads)
}

/// A frame from those before it: from where they are heading to, or from where the last one is if that is nearer.
fn from_before(
    solver: &mut Solver,
    before: &[Frame],
    points: &[Vector3<f64>],
) -> Result<Frame, DynamicsError> {
    let figure = solver.problem.figure;
    let last = &before[before.len() - 1].q;
    let mut q = last.clone();
    if let [.., one, two] = before {
        let (mut step, mut ahead) = (vec![0.0; figure.layout().nv()], q.clone());
        let heads_on = figure.difference(&one.q, &two.q, &mut step).is_ok()
            && figure.integrate(&two.q, &step, &mut ahead).is_ok();
        solver.problem.settle(&mut ahead);
        if heads_on && solver.cost(&ahead, points, &ahead)? < solver.cost(&q, points, &q)? {
            q = ahead;
        }
    }
    let solved = solver.solve(&mut q, points, |_| true)?;
    Ok(Frame { q, solved })
}

/// What is before and after a `seam` may have come to different minima, or to the same one by other angles. The better one is
/// carried on over the other until both agree.
pub(super) fn mend(
    solver: &mut Solver,
    points: &[Vector3<f64>],
    solved: &mut [Frame],
    seam: usize,
) -> Result<(), IkError> {
    let problem = solver.problem;
    let carried = from_before(solver, &solved[seam.saturating_sub(2)..seam], problem.row(points, seam))?;
    if is_same(problem, &carried.q, &solved[seam].q) {
        return Ok(());
    }
    if carried.solved.cost <= solved[seam].solved.cost * (1.0 + EQUAL) {
        solved[seam] = carried;
        for row in seam + 1..solved.len() {
            let next = from_before(solver, &solved[row - 2..row], problem.row(points, row))?;
            let agrees = is_same(problem, &next.q, &solved[row].q);
            if agrees || next.solved.cost > solved[row].solved.cost * (1.0 + EQUAL) {
                break;
            }
            solved[row] = next;
        }
        return Ok(());
    }
    for row in (0..seam).rev() {
        let after = [solved[row + 1].clone()];
        let next = from_before(solver, &after, problem.row(points, row))?;
        let agrees = is_same(problem, &next.q, &solved[row].q);
        if agrees || next.solved.cost >= solved[row].solved.cost * (1.0 - EQUAL) {
            break;
        }
        solved[row] = next;
    }
    Ok(())
}

/// Whether two configurations are the same, to what the solver leaves.
fn is_same(problem: &Problem, a: &[f64], b: &[f64]) -> bool {
    problem.figure.distance(a, b).is_ok_and(|distance| distance < SAME)
}
