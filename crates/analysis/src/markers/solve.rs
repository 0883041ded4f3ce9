//! One frame: the minimum of the objective within the bounds.
//!
//! Newton's method with the exact Hessian, whose part beyond `Σ w·Jᵀ·J` comes of the second derivatives
//! `∂²x/∂q_i∂q_j = ω_i × ∂x/∂q_j`; where the Hessian is not positive, without that part, and damped as Levenberg and
//! Marquardt do wherever a step does not lower the objective. Coordinates at a bound that the gradient pushes against are left
//! out of a step, the others are cut at theirs (D. P. Bertsekas, "Projected Newton methods for optimization problems with
//! simple constraints", SIAM J. Control Optim. 20 (1982) 221–246).

use super::problem::{Problem, Role, Sight, Unknown};
use nalgebra::{Cholesky, DMatrix, DVector, Vector3};
use solaris_dynamics::{
    DynamicsError, Pose, Twist, Workspace, forward_kinematics, joint_jacobians, point_columns,
};

/// How strongly every coordinate is drawn to where it began (m²/rad²): it decides where nothing else does, and moves what one
/// marker of 40 sees from 1 cm away by 4e-7 of the way.
const HOLD: f64 = 1e-12;
/// A step that promises less than this (m²), or this part of the objective, is the last one.
const PROMISE: (f64, f64) = (1e-20, 1e-14);
/// The farthest that one step goes in any coordinate (rad or m).
const STRIDE: f64 = 1.0;
/// Steps after which a frame is told too little to come to a point: it is at its minimum once as many again lower the objective by
/// less than this (m²), 10 µm squared, and by less than this part of what is left.
const PATIENCE: (usize, f64, f64) = (40, 1e-10, 0.5);
const MOST_STEPS: usize = 200;

/// What became of a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solved {
    /// The objective (m²).
    pub(super) cost: f64,
    pub(super) steps: usize,
    pub(super) converged: bool,
}

/// Scratch memory of one thread.
pub(super) struct Solver<'p> {
    pub(super) problem: &'p Problem<'p>,
    workspace: Workspace<f64>,
    /// The columns of one marker, by degree of freedom.
    columns: Vec<Twist<f64>>,
    /// Gradient and the two parts of the Hessian (upper halves) over all degrees of freedom, then over the unknowns.
    all: Derivatives,
    few: Derivatives,
    step: Vec<f64>,
    next: Vec<f64>,
    /// How strongly each unknown is drawn to where it began.
    holds: Vec<f64>,
}

struct Derivatives {
    gradient: DVector<f64>,
    /// `Σ w·Jᵀ·J`
    squared: DMatrix<f64>,
    /// `Σ w·(x − m)·∂²x`
    bent: DMatrix<f64>,
}

impl Derivatives {
    fn zero(n: usize) -> Self {
        Self { gradient: DVector::zeros(n), squared: DMatrix::zeros(n, n), bent: DMatrix::zeros(n, n) }
    }

    fn clear(&mut self) {
        self.gradient.fill(0.0);
        self.squared.fill(0.0);
        self.bent.fill(0.0);
    }
}

impl<'p> Solver<'p> {
    pub(super) fn new(problem: &'p Problem<'p>) -> Self {
        let (nv, nq, n) =
            (problem.figure.layout().nv(), problem.figure.layout().nq(), problem.unknowns.len());
        Self {
            problem,
            workspace: Workspace::new(&problem.tree),
            columns: vec![Twist { linear: Vector3::zeros(), angular: Vector3::zeros() }; nv],
            all: Derivatives::zero(nv),
            few: Derivatives::zero(n),
            step: vec![0.0; nv],
            next: vec![0.0; nq],
            holds: vec![HOLD; n],
        }
    }

    /// Draws the unknowns of which `is_told` is false to where they begin as strongly as `pull` (m²/rad²), from now on.
    pub(super) fn hold(&mut self, is_told: &[bool], pull: f64) {
        for (hold, is_told) in self.holds.iter_mut().zip(is_told) {
            *hold = if *is_told { HOLD } else { pull };
        }
    }

    /// Moves `q` to the minimum near it, in those of the unknowns that `moves` lets. Coordinates are drawn to where they are
    /// now, ever so slightly; that is no part of the objective that is told.
    pub(super) fn solve(
        &mut self,
        q: &mut [f64],
        points: &[Vector3<f64>],
        moves: impl Fn(&Unknown) -> bool,
    ) -> Result<Solved, DynamicsError> {
        let (steps, converged) = self.descend(q, points, moves)?;
        Ok(Solved { cost: self.cost(q, points, q)?, steps, converged })
    }

    /// The steps of [`Self::solve`]: how many there were, and whether the last one came to a minimum.
    fn descend(
        &mut self,
        q: &mut [f64],
        points: &[Vector3<f64>],
        moves: impl Fn(&Unknown) -> bool,
    ) -> Result<(usize, bool), DynamicsError> {
        let problem = self.problem;
        problem.settle(q);
        let hold = q.to_vec();
        let fixed: Vec<bool> = problem.unknowns.iter().map(|unknown| !moves(unknown)).collect();
        let mut cost = self.cost(q, points, &hold)?;
        let (mut damping, mut mark) = (0.0, cost);
        for steps in 0..MOST_STEPS {
            if steps > 0 && steps % PATIENCE.0 == 0 {
                if mark - cost < PATIENCE.1 && mark - cost < PATIENCE.2 * mark {
                    return Ok((steps, true));
                }
                mark = cost;
            }
            self.differentiate(q, points, &hold)?;
            let free: Vec<bool> = (0..fixed.len()).map(|i| !fixed[i] && !self.is_pushed(i, q)).collect();
            // What a damped step promises says only how short it is.
            let (mut step, promise) = self.newton(&free, 0.0);
            if promise <= PROMISE.0 + PROMISE.1 * cost {
                return Ok((steps, true));
            }
            loop {
                if damping > 0.0 {
                    step = self.newton(&free, damping).0;
                }
                self.advance(q, &step);
                let mut next = std::mem::take(&mut self.next);
                let lower = self.cost(&next, points, &hold)?;
                let is_lower = lower < cost;
                if is_lower {
                    q.copy_from_slice(&next);
                    cost = lower;
                    damping = if damping < 1e-6 { 0.0 } else { damping * 0.1 };
                }
                std::mem::swap(&mut self.next, &mut next);
                if is_lower {
                    break;
                }
                damping = f64::max(damping * 10.0, 1e-4);
                if damping > 1e12 {
                    // No step lowers the objective: what is left is rounding, unless much was promised.
                    return Ok((steps, promise <= 1e-9 * cost));
                }
            }
        }
        Ok((MOST_STEPS, false))
    }

    /// The objective at `q`, with what draws it to `hold`.
    pub(super) fn cost(
        &mut self,
        q: &[f64],
        points: &[Vector3<f64>],
        hold: &[f64],
    ) -> Result<f64, DynamicsError> {
        let problem = self.problem;
        forward_kinematics(&problem.tree, &mut self.workspace, q)?;
        let (mut sum, mut weights) = (0.0, 0.0);
        for sight in &problem.sights {
            let seen = points[sight.column];
            if !seen.x.is_nan() {
                sum += sight.weight * (sight.frame.pose(&self.workspace).translation - seen).norm_squared();
                weights += sight.weight;
            }
        }
        let mut cost = if weights > 0.0 { 0.5 * sum / weights } else { 0.0 };
        for (unknown, pull) in problem.unknowns.iter().zip(&self.holds) {
            let Some(at) = unknown.coordinate else { continue };
            let (value, weight) = unknown.task.unwrap_or_default();
            cost += 0.5 * weight * (q[at] - value).powi(2) + 0.5 * pull * (q[at] - hold[at]).powi(2);
        }
        Ok(cost)
    }

    /// Where the markers are at `q`, in the order of the problem's sights (m, world axes).
    pub(super) fn places(&mut self, q: &[f64]) -> Result<Vec<Vector3<f64>>, DynamicsError> {
        forward_kinematics(&self.problem.tree, &mut self.workspace, q)?;
        let place = |sight: &Sight| sight.frame.pose(&self.workspace).translation;
        Ok(self.problem.sights.iter().map(place).collect())
    }

    /// Where the links are at `q`.
    pub(super) fn poses(&mut self, q: &[f64]) -> Result<Vec<Pose<f64>>, DynamicsError> {
        joint_jacobians(&self.problem.tree, &mut self.workspace, q)?;
        Ok((0..self.problem.figure.links().len()).map(|link| *self.workspace.pose(link)).collect())
    }

    /// Visits the derivatives of a marker's place by the unknowns, at the configuration of the last [`Self::poses`], which is
    /// `q`; one unknown may come several times, and they add up.
    pub(super) fn columns(&self, q: &[f64], sight: &Sight, mut visit: impl FnMut(usize, Vector3<f64>)) {
        let problem = self.problem;
        point_columns(&problem.tree, &self.workspace, &sight.frame, |dof, column| {
            match &problem.roles[dof] {
                Role::Free(unknown) => visit(*unknown, column.linear),
                Role::Follows { unknown, leader, curve, .. } => {
                    visit(*unknown, column.linear * curve.at(q[*leader])[1]);
                }
                Role::Held => {}
            }
        });
    }

    /// `Σ w·Jᵀ·J / Σ w` over the unknowns at `q`, with the weights of tasks: what the markers of a frame tell of them.
    pub(super) fn information(
        &mut self,
        q: &[f64],
        points: &[Vector3<f64>],
    ) -> Result<DMatrix<f64>, DynamicsError> {
        self.differentiate(q, points, q)?;
        Ok(self.few.squared.clone())
    }

    /// Fills `few` with the derivatives of the objective at `q`.
    fn differentiate(
        &mut self,
        q: &[f64],
        points: &[Vector3<f64>],
        hold: &[f64],
    ) -> Result<(), DynamicsError> {
        let problem = self.problem;
        joint_jacobians(&problem.tree, &mut self.workspace, q)?;
        self.all.clear();
        let seen = |sight: &&Sight| !points[sight.column].x.is_nan();
        let weights: f64 = problem.sights.iter().filter(seen).map(|sight| sight.weight).sum();
        for sight in problem.sights.iter().filter(seen) {
            self.add(sight, &points[sight.column], sight.weight / weights);
        }
        self.reduce(q);
        for (i, unknown) in problem.unknowns.iter().enumerate() {
            let (value, weight) = unknown.task.unwrap_or_default();
            if let Some(at) = unknown.coordinate {
                self.few.gradient[i] += weight * (q[at] - value) + self.holds[i] * (q[at] - hold[at]);
            }
            self.few.squared[(i, i)] += weight + self.holds[i];
        }
        Ok(())
    }

    /// Adds what one marker does to the derivatives over all degrees of freedom.
    fn add(&mut self, sight: &Sight, seen: &Vector3<f64>, weight: f64) {
        let (problem, columns) = (self.problem, &mut self.columns);
        point_columns(&problem.tree, &self.workspace, &sight.frame, |dof, column| columns[dof] = column);
        let off = (sight.frame.pose(&self.workspace).translation - seen) * weight;
        for (n, &j) in sight.path.iter().enumerate() {
            let column = columns[j];
            self.all.gradient[j] += off.dot(&column.linear);
            let pull = column.linear * weight;
            for &i in &sight.path[..=n] {
                let before = &columns[i];
                self.all.squared[(i, j)] += before.linear.dot(&pull);
                let mut bent = before.angular.cross(&column.linear);
                if i != j && problem.spheres[j].is_some() && problem.spheres[i] == problem.spheres[j] {
                    bent = (bent + column.angular.cross(&before.linear)) * 0.5;
                }
                self.all.bent[(i, j)] += off.dot(&bent);
            }
        }
    }

    /// From all degrees of freedom to the unknowns: `y = f(x)` adds `f′` times its column to that of `x`, and `f″` times its
    /// gradient to the curvature.
    fn reduce(&mut self, q: &[f64]) {
        let (all, few) = (&self.all, &mut self.few);
        few.clear();
        let roles = &self.problem.roles;
        let slopes: Vec<Option<(usize, f64)>> = roles
            .iter()
            .enumerate()
            .map(|(k, role)| match role {
                Role::Free(unknown) => Some((*unknown, 1.0)),
                Role::Follows { unknown, leader, curve, .. } => {
                    let [_, first, second] = curve.at(q[*leader]);
                    few.bent[(*unknown, *unknown)] += second * all.gradient[k];
                    Some((*unknown, first))
                }
                Role::Held => None,
            })
            .collect();
        for (l, slope) in slopes.iter().enumerate() {
            let Some((v, t)) = *slope else { continue };
            few.gradient[v] += t * all.gradient[l];
            for k in 0..=l {
                let Some((u, s)) = slopes[k] else { continue };
                let (squared, bent) = (s * t * all.squared[(k, l)], s * t * all.bent[(k, l)]);
                few.squared[(u, v)] += squared;
                few.bent[(u, v)] += bent;
                if k != l {
                    few.squared[(v, u)] += squared;
                    few.bent[(v, u)] += bent;
                }
            }
        }
    }

    /// Whether an unknown is at a bound and the gradient pushes it on.
    fn is_pushed(&self, i: usize, q: &[f64]) -> bool {
        let unknown = &self.problem.unknowns[i];
        let (Some(at), Some((lower, upper))) = (unknown.coordinate, unknown.bounds) else { return false };
        let gradient = self.few.gradient[i];
        (q[at] <= lower && gradient > 0.0) || (q[at] >= upper && gradient < 0.0)
    }

    /// The step of the free unknowns, and by how much it should lower the objective.
    fn newton(&self, free: &[bool], damping: f64) -> (DVector<f64>, f64) {
        let masked = |with_bent: bool| {
            let n = free.len();
            DMatrix::from_fn(n, n, |i, j| match (free[i] && free[j], i == j) {
                (true, on) => {
                    let bent = if with_bent { self.few.bent[(i, j)] } else { 0.0 };
                    let damped = if on { damping * self.few.squared[(i, i)] } else { 0.0 };
                    self.few.squared[(i, j)] + bent + damped
                }
                (false, on) => f64::from(u8::from(on)),
            })
        };
        let down = DVector::from_fn(free.len(), |i, _| if free[i] { -self.few.gradient[i] } else { 0.0 });
        let factors = Cholesky::new(masked(true)).or_else(|| Cholesky::new(masked(false)));
        // Without its bent part the matrix is positive but for rounding; then the gradient alone leads on.
        let mut step = factors.map_or_else(|| down.clone(), |factors| factors.solve(&down));
        let promise = 0.5 * step.dot(&down);
        let longest = step.amax();
        if longest > STRIDE {
            step *= STRIDE / longest;
        }
        (step, promise)
    }

    /// Writes to `next` where a step of the unknowns leads from `q`, within the bounds.
    fn advance(&mut self, q: &[f64], step: &DVector<f64>) {
        let problem = self.problem;
        self.step.fill(0.0);
        for (unknown, step) in problem.unknowns.iter().zip(step) {
            self.step[unknown.dof] = *step;
        }
        if problem.figure.integrate(q, &self.step, &mut self.next).is_err() {
            // A step beyond all numbers: the one that stays is not lower.
            self.next.copy_from_slice(q);
        }
        problem.settle(&mut self.next);
    }
}
