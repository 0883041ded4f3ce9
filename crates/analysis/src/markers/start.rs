//! Where to begin when nothing is known: the markers may be anywhere in the room, seen from any side.

use super::problem::Problem;
use super::solve::{Solved, Solver};
use nalgebra::{Matrix3, Vector3};
use solaris_dynamics::DynamicsError;
use solaris_model::AxisKind;
use std::f64::consts::FRAC_PI_2;

/// How many of the sides are tried, and how many of the ways to stand to the end.
const TRIED: usize = 8;
const FINALISTS: usize = 3;

/// Solves a frame from rest: the figure, stiff, is laid on the markers from the sides that are nearest to how they are turned, in
/// quarter turns of its root, and from the best of these all of it moves. `q` becomes the best that is found.
pub(super) fn solve(
    solver: &mut Solver,
    q: &mut [f64],
    points: &[Vector3<f64>],
) -> Result<Solved, DynamicsError> {
    let problem = solver.problem;
    let mut stood: Vec<(f64, Vec<f64>)> = Vec::new();
    for mut start in nearest_sides(solver, points)? {
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

/// The sides that turn the root nearest to what turns the markers of the figure at rest into those that were seen.
fn nearest_sides(solver: &mut Solver, points: &[Vector3<f64>]) -> Result<Vec<Vec<f64>>, DynamicsError> {
    let problem = solver.problem;
    let places = solver.places(&problem.rest)?;
    let turned = turn(problem, &places, points) * solver.poses(&problem.rest)?[0].rotation;
    let mut sides = Vec::new();
    for side in sides_of(problem) {
        let alike = (turned.transpose() * solver.poses(&side)?[0].rotation).trace();
        sides.push((alike, side));
    }
    sides.sort_by(|a, b| b.0.total_cmp(&a.0));
    sides.truncate(TRIED);
    Ok(sides.into_iter().map(|(_, side)| side).collect())
}

/// The rotation that brings `places` nearest to where they were seen, both about their middles.
///
/// # Source
///
/// W. Kabsch, Acta Cryst. A32 (1976) 922–923, with the determinant of S. Umeyama, IEEE PAMI 13 (1991) 376–380.
fn turn(problem: &Problem, places: &[Vector3<f64>], points: &[Vector3<f64>]) -> Matrix3<f64> {
    let pairs = || {
        let of = problem.sights.iter().zip(places);
        of.map(|(sight, place)| (*place, points[sight.column])).filter(|(_, seen)| !seen.x.is_nan())
    };
    let count = pairs().count().max(1) as f64;
    let (here, there) = pairs().fold((Vector3::zeros(), Vector3::zeros()), |(a, b), (x, m)| (a + x, b + m));
    let spread = pairs()
        .fold(Matrix3::zeros(), |sum, (x, m)| sum + (m - there / count) * (x - here / count).transpose());
    let svd = spread.svd(true, true);
    let (Some(u), Some(v)) = (svd.u, svd.v_t) else { return Matrix3::identity() };
    let sign = (u.determinant() * v.determinant()).signum();
    u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, sign)) * v
}

/// The rest, its root turned by quarters about each of its axes.
fn sides_of(problem: &Problem) -> Vec<Vec<f64>> {
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
