//! The normal equations of a fit, with the poses eliminated.

use super::unknowns::Unknowns;
use super::{FitError, INDEPENDENT, Task, pose};
use crate::markers::options::IkError;
use crate::markers::problem::Problem;
use crate::markers::solve::Solver;
use crate::prepared::each;
use nalgebra::{Cholesky, DMatrix, DVector, Matrix3};

/// What decides where a pose is told nothing of (1/rad²).
const HOLD: f64 = 1e-6;

/// The equations `matrix·step = −gradient`, and what the objective is.
pub(super) struct Normal {
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
    /// The objective.
    pub(super) cost: f64,
    /// Root mean square distance of all markers (m).
    pub(super) rms: f64,
    /// The poses of the frames that are looked at.
    pub(super) poses: Vec<Vec<f64>>,
}

/// What one frame adds.
struct Part {
    pose: Vec<f64>,
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
    squares: f64,
    weighted: f64,
    count: usize,
}

impl Normal {
    /// Of a task at a state; `known` are poses that are near, of no frame or of all that are looked at.
    pub(super) fn of(task: &Task, state: &DVector<f64>, known: &[Vec<f64>]) -> Result<Self, FitError> {
        let Task { trials, chosen, ik, unknowns, .. } = task;
        let (figure, markers) = unknowns.apply(task.figure, task.markers, state)?;
        let problem = |trial| Problem::new(&figure, &markers, trial, ik);
        let problems = trials.iter().map(problem).collect::<Result<Vec<_>, _>>()?;
        let parts = each(
            0..chosen.len(),
            || (),
            |(), i| {
                let (trial, frame) = chosen[i];
                let problem = &problems[trial];
                let q = pose(problem, frame, known.get(i))?;
                Part::of(problem, frame, q, (unknowns, state), task.noise)
            },
        )
        .map_err(FitError::Pose)?;
        let n = unknowns.len();
        let (mut matrix, mut gradient) = (DMatrix::zeros(n, n), DVector::zeros(n));
        let share = (INDEPENDENT * trials.len() as f64 / chosen.len() as f64).min(1.0);
        let (mut cost, mut squares, mut count) = (0.0, 0.0, 0);
        for part in &parts {
            matrix += &part.matrix * share;
            gradient += &part.gradient * share;
            cost += part.weighted * share;
            squares += part.squares;
            count += part.count;
        }
        cost += unknowns.add_prior(state, &mut matrix, &mut gradient);
        let poses = parts.into_iter().map(|part| part.pose).collect();
        Ok(Self { matrix, gradient, cost, rms: (squares / count.max(1) as f64).sqrt(), poses })
    }

    /// The Gauss-Newton step.
    pub(super) fn step(&self) -> DVector<f64> {
        Cholesky::new(self.matrix.clone())
            .map_or_else(|| DVector::zeros(self.gradient.len()), |factors| -factors.solve(&self.gradient))
    }

    /// The covariance of the unknowns.
    pub(super) fn covariance(&self) -> DMatrix<f64> {
        let n = self.gradient.len();
        Cholesky::new(self.matrix.clone())
            .map_or_else(|| DMatrix::from_element(n, n, f64::INFINITY), |factors| factors.inverse())
    }
}

impl Part {
    /// With `A` the derivatives of the markers by the pose and `B` those by the unknowns, both over the noise:
    ///
    /// ```text
    /// S = Bᵀ·B − Bᵀ·A·(Aᵀ·A)⁻¹·Aᵀ·B      g = Bᵀ·r − Bᵀ·A·(Aᵀ·A)⁻¹·Aᵀ·r
    /// ```
    fn of(
        problem: &Problem,
        frame: usize,
        q: Vec<f64>,
        (unknowns, state): (&Unknowns, &DVector<f64>),
        noise: f64,
    ) -> Result<Self, IkError> {
        let mut solver = Solver::new(problem);
        let seen: Vec<usize> = (0..problem.sights.len())
            .filter(|i| problem.trial.point(frame, problem.sights[*i].column).is_some())
            .collect();
        let mean = seen.iter().map(|i| problem.sights[*i].weight).sum::<f64>() / seen.len().max(1) as f64;
        let (rows, n) = (3 * seen.len(), unknowns.len());
        let (mut a, mut b) = (DMatrix::zeros(rows, problem.unknowns.len()), DMatrix::zeros(rows, n));
        let mut off = DVector::zeros(rows);
        let poses = solver.poses(&q)?;
        let (mut squares, mut weighted) = (0.0, 0.0);
        for (row, &i) in seen.iter().enumerate() {
            let sight = &problem.sights[i];
            let scale = (sight.weight / mean).sqrt() / noise;
            let pose = &poses[sight.frame.link];
            let place = pose.translation + pose.rotation * sight.frame.placement.translation;
            let way = place - problem.trial.frame(frame)[sight.column];
            squares += way.norm_squared();
            weighted += 0.5 * (way * scale).norm_squared();
            off.fixed_rows_mut::<3>(3 * row).copy_from(&(way * scale));
            solver.columns(&q, sight, |unknown, column| {
                let mut at = a.fixed_view_mut::<3, 1>(3 * row, unknown);
                at += column * scale;
            });
            let mut add = |at: usize, block: Matrix3<f64>| {
                let mut view = b.fixed_view_mut::<3, 3>(3 * row, at);
                view += block * scale;
            };
            add(unknowns.marker(sight.marker), pose.rotation);
            // On the way to the root, each link carries what comes after it by a vector that its factors stretch.
            let own = &problem.markers[sight.marker];
            let (mut link, mut carried) = (own.link, own.position - unknowns.offset(state, sight.marker));
            loop {
                add(unknowns.scale(link), poses[link].rotation * Matrix3::from_diagonal(&carried));
                let Some(parent) = problem.figure.links()[link].parent() else { break };
                let way = poses[link].translation - poses[parent].translation;
                carried = poses[parent].rotation.transpose() * way;
                link = parent;
            }
        }
        let gauss = a.transpose() * &a + DMatrix::identity(a.ncols(), a.ncols()) * HOLD;
        let (cross, pull) = (a.transpose() * &b, a.transpose() * &off);
        let (mut matrix, mut gradient) = (b.transpose() * &b, b.transpose() * &off);
        if let Some(factors) = Cholesky::new(gauss) {
            matrix -= cross.transpose() * factors.solve(&cross);
            gradient -= cross.transpose() * factors.solve(&pull);
        }
        Ok(Self { pose: q, matrix, gradient, squares, weighted, count: seen.len() })
    }
}
