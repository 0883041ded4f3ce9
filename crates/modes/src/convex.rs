//! Impulses of contact, friction and limits in one step: a convex problem that always has one answer.

pub(crate) mod cholesky;
mod cone;
mod search;

use cholesky::{dot, factor, solve};
use cone::{Law, Pushed};
use nalgebra::DMatrix;

/// The most steps of Newton's method; a handful is usual.
const MOST_STEPS: usize = 100;

/// The most rounds in which friction is bound anew; three or four are usual.
const MOST_BOUNDS: usize = 16;

/// Bounds whose change is more than this part of the one before go to and fro.
const FALLS: f64 = 0.9;

/// A bound of friction that changes by less than this part of the greatest push is the same.
const SAME_BOUND: f64 = 1e-3;

/// How much of the momentum may be left unbalanced.
const BALANCED: f64 = 1e-9;

/// The velocities after a step, with the impulses of what touches and what is at its limits.
///
/// ```text
/// v⁺ = argmin ½(v − v*)ᵀM(v − v*) + Σ ℓᵢ(Jᵢv + bᵢ)          γᵢ = −∂ℓᵢ/∂u
/// ```
///
/// `v*` are the velocities without impulses. Each condition has a velocity `u = J·v + b` of one number (a limit) or three (two along
/// the ground, one out of it), and an impulse `γ(u)` that is the projection of `R⁻¹(û − u)` onto what it can be: pushes, and
/// Coulomb's cone. `R` is a small compliance of the step, so that the problem is strictly convex. It is solved by Newton's method
/// with an exact line search.
///
/// # Source
///
/// A. M. Castro, F. N. Permenter, X. Han, "An Unconstrained Convex Formulation of Compliant Contact", IEEE Transactions on
/// Robotics 39 (2023). That friction is bound by a push known before: D. M. Kaufman, S. Sueda, D. L. James, D. K. Pai, "Staggered
/// projections for frictional contact in multibody systems", ACM Transactions on Graphics 27 (2008).
#[derive(Clone, Debug, Default)]
pub(crate) struct Convex {
    /// How many velocities.
    n: usize,
    mass: Vec<f64>,
    hessian: Vec<f64>,
    /// Whether its place has the factors of the mass.
    is_factored: bool,
    /// The velocities without impulses.
    free: Vec<f64>,
    /// The velocities.
    pub(crate) v: Vec<f64>,
    /// `v − v*`.
    off: Vec<f64>,
    gradient: Vec<f64>,
    direction: Vec<f64>,
    /// `M·(v − v*)` and `M·d`.
    momentum: Vec<f64>,
    turned: Vec<f64>,
    conditions: Vec<Condition>,
    /// The entries of all rows that are not zero, with their columns.
    entries: Vec<(usize, [f64; 3])>,
    /// Rows of the condition that is worked on.
    scratch: Vec<[f64; 3]>,
}

/// One condition: where its rows are, and its law.
#[derive(Clone, Copy, Debug)]
struct Condition {
    first: usize,
    count: usize,
    law: Law,
    bias: [f64; 3],
    /// `u`, its change along the direction, and what pushes.
    u: [f64; 3],
    du: [f64; 3],
    pushed: Pushed,
}

impl Convex {
    /// Room for a problem; kept from step to step. Rows have at most `width` entries that are not zero.
    pub(crate) fn new(n: usize, conditions: usize, width: usize) -> Self {
        let zeros = || vec![0.0; n];
        Self {
            n,
            mass: vec![0.0; n * n],
            hessian: vec![0.0; n * n],
            is_factored: false,
            free: zeros(),
            v: zeros(),
            off: zeros(),
            gradient: zeros(),
            direction: zeros(),
            momentum: zeros(),
            turned: zeros(),
            conditions: Vec::with_capacity(conditions),
            entries: Vec::with_capacity(conditions * width.min(n)),
            scratch: Vec::with_capacity(n),
        }
    }

    /// More momentum for the velocities without impulses.
    pub(crate) fn push(&mut self, momentum: impl Iterator<Item = f64>) {
        self.direction.iter_mut().zip(momentum).for_each(|(to, from)| *to = from);
        if !self.is_factored {
            self.hessian.copy_from_slice(&self.mass);
            factor(&mut self.hessian, self.n);
        }
        solve(&self.hessian, self.n, &mut self.direction);
        for (free, direction) in self.free.iter_mut().zip(&self.direction) {
            *free += direction;
        }
    }

    /// The velocities without impulses.
    pub(crate) fn free(&self) -> &[f64] {
        &self.free
    }

    /// Begins a problem without conditions: the mass matrix of `matrix` for the degrees of freedom `of`, the velocities before the
    /// step, and the change of them that forces would make if they stayed as they are; of these forces `−d·v − k·q` are those of the
    /// end of the step, with `held` = `(h·d, h²·k)` by degree of freedom:
    ///
    /// ```text
    /// (M + h·D + h²·K)·(v* − v) = M·Δv − h²·K·v
    /// ```
    pub(crate) fn begin(
        &mut self,
        matrix: &DMatrix<f64>,
        of: &[usize],
        before: &[f64],
        change: impl Iterator<Item = f64>,
        held: impl Fn(usize) -> (f64, f64),
    ) {
        for (i, &row) in of.iter().enumerate() {
            for (j, &column) in of.iter().enumerate() {
                self.mass[i * self.n + j] = matrix[(row, column)];
            }
        }
        self.v.copy_from_slice(before);
        self.conditions.clear();
        self.entries.clear();
        self.direction.iter_mut().zip(change).for_each(|(to, from)| *to = from);
        self.is_factored = false;
        if of.iter().any(|k| held(*k) != (0.0, 0.0)) {
            let n = self.n;
            for i in 0..n {
                let row = &self.mass[i * n..][..n];
                let momentum = dot(row, &self.direction);
                self.momentum[i] = momentum - held(of[i]).1 * before[i];
            }
            for (i, k) in of.iter().enumerate() {
                let (damping, stiffness) = held(*k);
                self.mass[i * n + i] += damping + stiffness;
            }
            self.hessian.copy_from_slice(&self.mass);
            factor(&mut self.hessian, n);
            self.is_factored = true;
            self.direction.copy_from_slice(&self.momentum);
            solve(&self.hessian, n, &mut self.direction);
        }
        for (free, (before, change)) in self.free.iter_mut().zip(before.iter().zip(&self.direction)) {
            *free = before + change;
        }
    }

    /// Begins a condition; its entries follow.
    pub(crate) fn condition(&mut self) {
        let first = self.entries.len();
        let law = Law::Limit { weight: 0.0, target: 0.0 };
        let (bias, u, du, pushed) = ([0.0; 3], [0.0; 3], [0.0; 3], Pushed::default());
        self.conditions.push(Condition { first, count: 0, law, bias, u, du, pushed });
    }

    /// An entry of the condition's rows that is not zero.
    pub(crate) fn entry(&mut self, column: usize, rows: [f64; 3]) {
        self.entries.push((column, rows));
        if let Some(last) = self.conditions.last_mut() {
            last.count += 1;
        }
    }

    /// The compliance that a unit mass would have at each row of the condition: `Σ J²/M_kk`.
    fn lightness(&self, condition: &Condition) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (column, rows) in &self.entries[condition.first..][..condition.count] {
            let mass = self.mass[column * self.n + column];
            for (sum, row) in sum.iter_mut().zip(rows) {
                *sum += row * row / mass;
            }
        }
        sum
    }

    /// Ends a contact: `bias` is the velocity that is not the unknowns', `gap` how far it is off (m), in a step of `h` (s); its spring
    /// has a stiffness (N/m) and a time of relaxation (s). Friction is bound by `push` (N s) to begin with, where that is above zero: a
    /// guess, such as the push of the step before.
    pub(crate) fn contact(
        &mut self,
        bias: [f64; 3],
        friction: f64,
        gap: f64,
        (stiffness, relaxation): (f64, f64),
        push: f64,
        h: f64,
    ) {
        let Some(last) = self.conditions.last().copied() else { return };
        let [x, y, z] = self.lightness(&last);
        let law = Law::contact([0.5 * (x + y), z], friction, gap, (stiffness, relaxation), h);
        let law = if push > 0.0 { law.bound_by(push) } else { law };
        if let Some(last) = self.conditions.last_mut() {
            (last.law, last.bias) = (law, bias);
        }
    }

    /// Ends a limit that is `gap` (rad or m) away and pushes along its one row; what comes with the speed `[speed, e]` (rad/s or m/s) bounces
    /// off it with `e` times that.
    pub(crate) fn limit(&mut self, gap: f64, bounce: [f64; 2], h: f64) {
        let Some(last) = self.conditions.last().copied() else { return };
        let law = Law::limit(self.lightness(&last)[2], gap, bounce, h);
        if let Some(last) = self.conditions.last_mut() {
            last.law = law;
        }
    }

    /// Ends three velocities that are held at a target; `bias` is the part of them that is not the unknowns'.
    pub(crate) fn hold(&mut self, bias: [f64; 3], target: [f64; 3]) {
        let Some(last) = self.conditions.last().copied() else { return };
        let law = Law::hold(self.lightness(&last), target);
        if let Some(last) = self.conditions.last_mut() {
            (last.law, last.bias) = (law, bias);
        }
    }

    /// The impulse and the mean velocity (before and after the step, if `before` are the velocities before it) of each condition.
    pub(crate) fn impulses<'a>(
        &'a self,
        before: &'a [f64],
    ) -> impl Iterator<Item = ([f64; 3], [f64; 3])> + 'a {
        self.conditions.iter().map(|condition| {
            let old = self.at(condition, before);
            let mean = [0, 1, 2].map(|i| 0.5 * (old[i] + condition.bias[i] + condition.u[i]));
            (condition.pushed.impulse, mean)
        })
    }

    /// `J·x` of a condition.
    fn at(&self, condition: &Condition, x: &[f64]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (column, rows) in &self.entries[condition.first..][..condition.count] {
            for (sum, row) in sum.iter_mut().zip(rows) {
                *sum += row * x[*column];
            }
        }
        sum
    }

    /// Solves it; the number of Newton's steps.
    ///
    /// A cone makes what slides lift off, for its impulses are square to it. So friction is then bound by the push that was found,
    /// which is convex again, and so on until the push does not change: Coulomb's law, with each answer on the way one of its own.
    /// Where legs are wedged against the ground, friction of one foot presses the other down, more than by as much, and bounds go to
    /// and fro for ever: then they go only half of the way, and half of that.
    pub(crate) fn solve(&mut self) -> usize {
        if self.conditions.is_empty() {
            self.v.copy_from_slice(&self.free);
            return 0;
        }
        let mut steps = self.minimize();
        let (mut share, mut before) = (1.0, f64::INFINITY);
        for _ in 0..MOST_BOUNDS {
            let changes = self.conditions.iter().map(|condition| condition.law.off_bound(&condition.pushed));
            let change = changes.fold(0.0, f64::max);
            let pushes = self.conditions.iter().map(|condition| condition.pushed.impulse[2]);
            if change <= SAME_BOUND * pushes.fold(0.0, f64::max) {
                break;
            }
            if change > FALLS * before {
                share *= 0.5;
            }
            before = change;
            for condition in &mut self.conditions {
                condition.law = condition.law.nearer_to(condition.pushed.impulse[2], share);
            }
            steps += self.minimize();
        }
        steps
    }

    /// Newton's method for the laws as they are.
    fn minimize(&mut self) -> usize {
        for step in 0..MOST_STEPS {
            self.evaluate();
            if self.is_balanced() {
                return step;
            }
            self.hessian.copy_from_slice(&self.mass);
            for index in 0..self.conditions.len() {
                self.add_stiffness(index);
            }
            factor(&mut self.hessian, self.n);
            for (direction, gradient) in self.direction.iter_mut().zip(&self.gradient) {
                *direction = -gradient;
            }
            solve(&self.hessian, self.n, &mut self.direction);
            if !self.go_along() {
                return step;
            }
        }
        MOST_STEPS
    }

    /// Finds velocities of the conditions, impulses and the gradient.
    fn evaluate(&mut self) {
        let n = self.n;
        for (off, (v, free)) in self.off.iter_mut().zip(self.v.iter().zip(&self.free)) {
            *off = v - free;
        }
        for i in 0..n {
            let row = &self.mass[i * n..][..n];
            self.momentum[i] = dot(row, &self.off);
        }
        self.gradient.copy_from_slice(&self.momentum);
        for index in 0..self.conditions.len() {
            let mut condition = self.conditions[index];
            let moved = self.at(&condition, &self.v);
            condition.u = [0, 1, 2].map(|i| moved[i] + condition.bias[i]);
            condition.pushed = condition.law.push(condition.u);
            for (column, rows) in &self.entries[condition.first..][..condition.count] {
                let pushed: f64 =
                    rows.iter().zip(condition.pushed.impulse).map(|(row, part)| row * part).sum();
                self.gradient[*column] -= pushed;
            }
            self.conditions[index] = condition;
        }
    }

    /// Whether momentum is balanced, each velocity in units in which its own mass is 1.
    fn is_balanced(&self) -> bool {
        let (mut left, mut scale) = (0.0, 0.0);
        for i in 0..self.n {
            let mass = self.mass[i * self.n + i];
            left += self.gradient[i] * self.gradient[i] / mass;
            let impulse = self.momentum[i] - self.gradient[i];
            scale += (self.momentum[i] * self.momentum[i]).max(impulse * impulse) / mass
                + mass * self.free[i] * self.free[i];
        }
        left <= BALANCED * BALANCED * scale
    }

    /// Adds `JᵀGJ` of a condition, the lower triangle of it.
    fn add_stiffness(&mut self, index: usize) {
        let Condition { first, count, pushed, .. } = self.conditions[index];
        let Some(stiffness) = pushed.stiffness else { return };
        let entries = &self.entries[first..][..count];
        self.scratch.clear();
        self.scratch.extend(
            entries
                .iter()
                .map(|(_, rows)| [0, 1, 2].map(|i| (0..3).map(|j| stiffness[i][j] * rows[j]).sum::<f64>())),
        );
        for (own, (row, _)) in self.scratch.iter().zip(entries) {
            for (column, rows) in entries.iter().filter(|(column, _)| column <= row) {
                self.hessian[row * self.n + column] += own[0] * rows[0] + own[1] * rows[1] + own[2] * rows[2];
            }
        }
    }

    /// Goes along the direction as far as is best; whether that is anywhere.
    fn go_along(&mut self) -> bool {
        let n = self.n;
        for i in 0..n {
            let row = &self.mass[i * n..][..n];
            self.turned[i] = dot(row, &self.direction);
        }
        for index in 0..self.conditions.len() {
            let condition = self.conditions[index];
            self.conditions[index].du = self.at(&condition, &self.direction);
        }
        let (slope, curvature) = (dot(&self.momentum, &self.direction), dot(&self.turned, &self.direction));
        let conditions = &self.conditions;
        let alpha = search::minimum(|alpha| {
            let (mut first, mut second) = (slope + alpha * curvature, curvature);
            for Condition { law, u, du, .. } in conditions {
                let pushed = law.push([0, 1, 2].map(|i| u[i] + alpha * du[i]));
                first -= (0..3).map(|i| pushed.impulse[i] * du[i]).sum::<f64>();
                if let Some(stiffness) = pushed.stiffness {
                    second += (0..3)
                        .flat_map(|i| (0..3).map(move |j| (i, j)))
                        .map(|(i, j)| du[i] * stiffness[i][j] * du[j])
                        .sum::<f64>();
                }
            }
            (first, second)
        });
        let mut moved = false;
        for (v, direction) in self.v.iter_mut().zip(&self.direction) {
            let next = *v + alpha * direction;
            moved |= next.to_bits() != v.to_bits();
            *v = next;
        }
        moved
    }
}

#[cfg(test)]
mod tests;
