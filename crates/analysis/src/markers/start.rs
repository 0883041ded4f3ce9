//! Where to begin when nothing is known: the markers may be anywhere in the room, seen from any side.

use super::problem::Problem;
use super::solve::{Solved, Solver};
use nalgebra::Vector3;
use solaris_dynamics::DynamicsError;
use solaris_model::AxisKind;
use std::f64::consts::FRAC_PI_2;

/// How many of the ways to stand are tried to the end.
const FINALISTS: usize = 3;

/// Solves a frame from rest: the figure, stiff, is laid on the markers from every side in quarter turns of its root, and from
/// the best of these all of it moves. `q` becomes the best that is found.
pub(super) fn solve(
    solver: &mut Solver,
    q: &mut [f64],
    points: &[Vector3<f64>],
) -> Result<Solved, DynamicsError> {
    let problem = solver.problem;
    let mut stood: Vec<(f64, Vec<f64>)> = Vec::new();
    for mut start in sides(problem) {
        let solved = solver.solve(&mut start, points, |unknown| unknown.is_root)?;
        stood.push((solved.cost, start));
    }
    stood.sort_by(|a, b| a.0.total_cmp(&b.0));
    // The same side by other angles: those that are nearest to rest stay.
    let mut finalists: Vec<(f64, Vec<f64>)> = Vec::new();
    let far = |q: &[f64]| problem.figure.distance(&problem.rest, q).unwrap_or(f64::INFINITY);
    for (cost, start) in stood {
        let is_full = finalists.len() == FINALISTS;
        match finalists.last_mut().filter(|last| cost - last.0 <= 1e-9 * last.0) {
            Some((_, other)) if far(&start) < far(other) => *other = start,
            Some(_) => {}
            None if is_full => break,
            None => finalists.push((cost, start)),
        }
    }
    let mut best: Option<Solved> = None;
    for (_, mut start) in finalists {
        let solved = solver.solve(&mut start, points, |_| true)?;
        if best.is_none_or(|best| solved.cost < best.cost) {
            best = Some(solved);
            q.copy_from_slice(&start);
        }
    }
    // There is at least the rest itself.
    Ok(best.unwrap_or(Solved { cost: f64::INFINITY, steps: 0, converged: false }))
}

/// The rest, its root turned by quarters about each of its axes.
fn sides(problem: &Problem) -> Vec<Vec<f64>> {
    let layout = problem.figure.layout();
    let mut sides = vec![problem.rest.clone()];
    let turns = |dof: &usize| layout.axis_kind(*dof) == AxisKind::Rotation;
    let roots = problem.unknowns.iter().filter(|unknown| unknown.is_root).map(|unknown| unknown.dof);
    for dof in roots.filter(turns) {
        let turned = |q: &Vec<f64>, quarters: f64| {
            let (mut step, mut turned) = (vec![0.0; layout.nv()], q.clone());
            step[dof] = quarters * FRAC_PI_2;
            problem.figure.integrate(q, &step, &mut turned).ok().map(|()| turned)
        };
        let quarters = [0.0, 1.0, -1.0, 2.0];
        sides = sides.iter().flat_map(|q| quarters.map(|n| turned(q, n))).flatten().collect();
    }
    sides
}
