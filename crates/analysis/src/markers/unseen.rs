//! Frames in which no marker tells of some degrees of freedom: what these do between the frames that do tell.

use super::blind::{is_blind, lever};
use super::chain::Frame;
use super::problem::Problem;
use super::solve::Solver;
use crate::prepared::each;
use nalgebra::Vector3;
use solaris_dynamics::DynamicsError;

/// How strongly what no marker tells of is drawn to where it is led (m²/rad²): 10° weigh as much as 2 µm in all markers.
const PULL: f64 = 1e-10;

/// Moves each degree of freedom, where no marker tells of it, from where it was seen last to where it is seen next: along a cubic that
/// does not overshoot, ball and free joints by the shortest turn; before the first and after the last it stays. What the markers do tell
/// of is then found again, from there. Gives what each frame tells of, as it was found before that.
pub(super) fn fill(
    problem: &Problem,
    points: &[Vector3<f64>],
    solved: &mut [Frame],
) -> Result<Telling, DynamicsError> {
    let scratch = || Solver::new(problem);
    let telling = telling(problem, points, solved)?;
    let told = &telling.told;
    let groups: Vec<Group> = groups(problem, told);
    let is_unseen = |row: usize| groups.iter().any(|group| !group.told[row] && !group.rows.is_empty());
    let rows: Vec<usize> = (0..solved.len()).filter(|row| is_unseen(*row)).collect();
    let before: &[Frame] = solved;
    let found = each(0..rows.len(), scratch, |solver, i| {
        let row = rows[i];
        let mut q = before[row].q.clone();
        for group in groups.iter().filter(|group| !group.told[row]) {
            group.lead(problem, before, row, &mut q);
        }
        solver.hold(&told[row], PULL);
        let solved = solver.solve(&mut q, problem.row(points, row), |_| true)?;
        Ok::<_, DynamicsError>(Frame { q, solved })
    })?;
    for (row, frame) in rows.into_iter().zip(found) {
        solved[row] = frame;
    }
    Ok(telling)
}

/// What the markers of each frame tell of the unknowns.
pub(super) struct Telling {
    /// How far each one is off if every coordinate of every marker is off by 1 m: see [`lever`].
    pub(super) levers: Vec<Vec<f64>>,
    /// Whether they tell of it.
    pub(super) told: Vec<Vec<bool>>,
}

/// What the markers of each frame tell of.
///
/// Where two axes of a joint fall together nothing tells their angles apart, although everything is in view: what all markers
/// together would not tell of there, and do tell of in other frames, is none that is unseen.
fn telling(problem: &Problem, points: &[Vector3<f64>], solved: &[Frame]) -> Result<Telling, DynamicsError> {
    let in_view = vec![Vector3::zeros(); problem.trial.names().len()];
    let found = each(
        0..solved.len(),
        || Solver::new(problem),
        |solver, row| {
            let q = &solved[row].q;
            let levers = lever(solver, q, problem.row(points, row))?;
            let is_whole = !levers.iter().any(|lever| is_blind(*lever));
            let whole = if is_whole { levers.clone() } else { lever(solver, q, &in_view)? };
            Ok::<_, DynamicsError>((levers, whole))
        },
    )?;
    let is_ever = |u: usize| found.iter().any(|(_, whole)| !is_blind(whole[u]));
    let ever: Vec<bool> = (0..problem.unknowns.len()).map(is_ever).collect();
    let frame = |(levers, whole): &(Vec<f64>, Vec<f64>)| {
        (0..levers.len()).map(|u| !is_blind(levers[u]) || (ever[u] && is_blind(whole[u]))).collect()
    };
    let told = found.iter().map(frame).collect();
    Ok(Telling { told, levers: found.into_iter().map(|(levers, _)| levers).collect() })
}

/// What is told of together: a coordinate, or a ball or free joint.
struct Group {
    /// Index in `v` of its first degree of freedom.
    dof: usize,
    /// Of a coordinate its place in `q`.
    coordinate: Option<usize>,
    /// Of a joint where its positions begin and how many there are, and how many degrees of freedom it has.
    joint: (usize, usize, usize),
    told: Vec<bool>,
    /// The frames that tell of it.
    rows: Vec<usize>,
}

fn groups(problem: &Problem, told: &[Vec<bool>]) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    let joints = problem.figure.layout().joints();
    for (u, unknown) in problem.unknowns.iter().enumerate() {
        let sphere = problem.spheres[unknown.dof].filter(|_| unknown.coordinate.is_none());
        let (dof, joint) = sphere.map_or((unknown.dof, (0, 0, 0)), |link| {
            let at = joints[link];
            (at.v, (at.q, at.nq, at.nv))
        });
        let own = told.iter().map(|row| row[u]);
        match groups.last_mut().filter(|group| group.dof == dof && group.coordinate.is_none()) {
            Some(group) => group.told.iter_mut().zip(own).for_each(|(all, own)| *all &= own),
            None => groups.push(Group {
                dof,
                coordinate: unknown.coordinate,
                joint,
                told: own.collect(),
                rows: Vec::new(),
            }),
        }
    }
    for group in &mut groups {
        group.rows = (0..told.len()).filter(|row| group.told[*row]).collect();
    }
    groups
}

impl Group {
    /// Puts into `q` where this group is led in a frame that does not tell of it.
    fn lead(&self, problem: &Problem, solved: &[Frame], row: usize, q: &mut [f64]) {
        let next = self.rows.partition_point(|told| *told < row);
        let before = next.checked_sub(1).map(|i| self.rows[i]);
        match (before, self.rows.get(next).copied()) {
            (Some(a), Some(b)) => self.between(problem, solved, [a, row, b], q),
            (Some(end), None) | (None, Some(end)) => self.copy(&solved[end].q, q),
            (None, None) => {}
        }
    }

    fn copy(&self, from: &[f64], to: &mut [f64]) {
        let (start, count, _) = self.joint;
        let range = self.coordinate.map_or(start..start + count, |at| at..at + 1);
        to[range.clone()].copy_from_slice(&from[range]);
    }

    fn between(&self, problem: &Problem, solved: &[Frame], [a, row, b]: [usize; 3], q: &mut [f64]) {
        let (lasts, s) = ((b - a) as f64, (row - a) as f64 / (b - a) as f64);
        if let Some(at) = self.coordinate {
            let value = |row: usize| solved[row].q[at];
            let rise = value(b) - value(a);
            // What it did just before and goes on doing just after, if that is told.
            let slope = |told: Option<usize>, step: &dyn Fn(usize) -> f64| {
                let slope = told.filter(|row| self.told[*row]).map_or(0.0, |row| step(row) * lasts);
                if slope * rise > 0.0 { slope.signum() * slope.abs().min(3.0 * rise.abs()) } else { 0.0 }
            };
            let from = slope(a.checked_sub(1), &|row| value(a) - value(row));
            let to = slope(Some(b + 1).filter(|row| *row < solved.len()), &|row| value(row) - value(b));
            q[at] = value(a) + hermite(rise, from, to, s);
            return;
        }
        let figure = problem.figure;
        let mut way = vec![0.0; figure.layout().nv()];
        let (from, to) = (&solved[a].q, &solved[b].q);
        let mut led = from.clone();
        if figure.difference(from, to, &mut way).is_ok() {
            for x in &mut way {
                *x *= s;
            }
            if figure.integrate(from, &way, &mut led).is_ok() {
                self.copy(&led, q);
            }
        }
    }
}

/// The cubic from 0 to `rise` with these slopes at its ends, at `s` of its way.
fn hermite(rise: f64, from: f64, to: f64, s: f64) -> f64 {
    let t = 1.0 - s;
    s * s * (3.0 - 2.0 * s) * rise + s * t * t * from - s * s * t * to
}

#[cfg(test)]
mod tests {
    use super::hermite;

    #[test]
    fn the_cubic_has_its_ends_and_slopes() {
        let at = |s: f64| hermite(2.0, 0.5, 1.5, s);
        assert_eq!((at(0.0), at(1.0)), (0.0, 2.0));
        let slope = |s: f64| (at(s + 1e-6) - at(s - 1e-6)) / 2e-6;
        assert!((slope(0.0) - 0.5).abs() < 1e-5 && (slope(1.0) - 1.5).abs() < 1e-5);
    }
}
