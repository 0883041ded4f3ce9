//! One island of a step by impulses: Newton's method for what is joined by conditions.

use super::cholesky::{Envelope, dot};
use super::cone::{Law, Pushed};
use super::search;

/// The most steps of Newton's method; a handful is usual.
const MOST_STEPS: usize = 100;

/// The most rounds in which friction is bound anew; three or four are usual.
const MOST_BOUNDS: usize = 16;

/// Bounds whose change is more than this part of the one before go to and fro.
const FALLS: f64 = 0.9;

/// A bound of friction that changes by less than this part of the greatest push is the same.
pub(super) const SAME_BOUND: f64 = 1e-3;

/// How much of the momentum may be left unbalanced.
const BALANCED: f64 = 1e-9;

/// One condition: where its rows are, and its law.
#[derive(Clone, Copy, Debug)]
pub(super) struct Condition {
    pub(super) first: usize,
    pub(super) count: usize,
    pub(super) law: Law,
    pub(super) bias: [f64; 3],
    /// `u`, its change along the direction, and what pushes.
    pub(super) u: [f64; 3],
    pub(super) du: [f64; 3],
    pub(super) pushed: Pushed,
}

impl Condition {
    /// One whose entries begin at `first`.
    pub(super) fn at(first: usize) -> Self {
        let law = Law::Limit { weight: 0.0, target: 0.0 };
        let (bias, u, du, pushed) = ([0.0; 3], [0.0; 3], [0.0; 3], Pushed::default());
        Self { first, count: 0, law, bias, u, du, pushed }
    }

    /// `J·x`, where `entries` are those of all conditions.
    pub(super) fn along(&self, entries: &[(usize, [f64; 3])], x: &[f64]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (column, rows) in &entries[self.first..][..self.count] {
            for (sum, row) in sum.iter_mut().zip(rows) {
                *sum += row * x[*column];
            }
        }
        sum
    }
}

/// A problem, and room for solving it.
#[derive(Clone, Debug, Default)]
pub(super) struct Island {
    /// The lower triangle of the mass matrix, and what of it may not be zero.
    pub(super) mass: Vec<f64>,
    pub(super) of_mass: Envelope,
    /// The same of the Hessian: what touches joins what the mass matrix does not.
    hessian: Vec<f64>,
    of_hessian: Envelope,
    /// The velocities without impulses.
    pub(super) free: Vec<f64>,
    /// The velocities.
    pub(super) v: Vec<f64>,
    /// `v − v*`.
    off: Vec<f64>,
    gradient: Vec<f64>,
    direction: Vec<f64>,
    /// `M·(v − v*)` and `M·d`.
    momentum: Vec<f64>,
    turned: Vec<f64>,
    pub(super) conditions: Vec<Condition>,
    /// The entries of all rows that are not zero, with their columns.
    pub(super) entries: Vec<(usize, [f64; 3])>,
    /// Rows of the condition that is worked on.
    scratch: Vec<[f64; 3]>,
}

impl Island {
    /// Room for so many velocities, conditions and entries.
    pub(super) fn with_room(n: usize, conditions: usize, entries: usize) -> Self {
        let [numbers, square] = [n, n * n].map(|length| move || Vec::with_capacity(length));
        Self {
            mass: square(),
            of_mass: Envelope::full(n),
            hessian: square(),
            of_hessian: Envelope::full(n),
            free: numbers(),
            v: numbers(),
            off: numbers(),
            gradient: numbers(),
            direction: numbers(),
            momentum: numbers(),
            turned: numbers(),
            conditions: Vec::with_capacity(conditions),
            entries: Vec::with_capacity(entries),
            scratch: Vec::with_capacity(n),
        }
    }

    /// Makes room for a problem of `n` velocities without conditions.
    pub(super) fn resize(&mut self, n: usize) {
        let Self { mass, hessian, free, v, off, gradient, direction, momentum, turned, .. } = self;
        for numbers in [mass, hessian] {
            numbers.resize(n * n, 0.0);
        }
        for numbers in [free, v, off, gradient, direction, momentum, turned] {
            numbers.resize(n, 0.0);
        }
        self.of_mass.resize(n);
        self.of_hessian.resize(n);
        self.conditions.clear();
        self.entries.clear();
    }

    /// Solves it; the number of Newton's steps.
    ///
    /// A cone makes what slides lift off, for its impulses are square to it. So friction is then bound by the push that was found,
    /// which is convex again, and so on until the push does not change: Coulomb's law, with each answer on the way one of its own.
    /// Where legs are wedged against the ground, friction of one foot presses the other down, more than by as much, and bounds go to
    /// and fro for ever: then they go only half of the way, and half of that.
    pub(super) fn solve(&mut self) -> usize {
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
            self.join();
            self.of_hessian.copy((&self.of_mass, &self.mass), &mut self.hessian);
            for index in 0..self.conditions.len() {
                self.add_stiffness(index);
            }
            self.of_hessian.factor(&mut self.hessian);
            for (direction, gradient) in self.direction.iter_mut().zip(&self.gradient) {
                *direction = -gradient;
            }
            self.of_hessian.solve(&self.hessian, &mut self.direction);
            if !self.go_along() {
                return step;
            }
        }
        MOST_STEPS
    }

    /// Finds what may not be zero of the Hessian.
    fn join(&mut self) {
        self.of_hessian.copy_from(&self.of_mass);
        for condition in self.conditions.iter().filter(|condition| condition.pushed.stiffness.is_some()) {
            let entries = &self.entries[condition.first..][..condition.count];
            let Some(first) = entries.iter().map(|(column, _)| *column).min() else { continue };
            for (row, _) in entries {
                self.of_hessian.reach(*row, first);
            }
        }
    }

    /// Finds velocities of the conditions, impulses and the gradient.
    fn evaluate(&mut self) {
        for (off, (v, free)) in self.off.iter_mut().zip(self.v.iter().zip(&self.free)) {
            *off = v - free;
        }
        self.of_mass.times(&self.mass, &self.off, &mut self.momentum);
        self.gradient.copy_from_slice(&self.momentum);
        for index in 0..self.conditions.len() {
            let mut condition = self.conditions[index];
            let moved = condition.along(&self.entries, &self.v);
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
        let n = self.v.len();
        for i in 0..n {
            let mass = self.mass[i * n + i];
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
        let n = self.v.len();
        for (own, (row, _)) in self.scratch.iter().zip(entries) {
            for (column, rows) in entries.iter().filter(|(column, _)| column <= row) {
                self.hessian[row * n + column] += own[0] * rows[0] + own[1] * rows[1] + own[2] * rows[2];
            }
        }
    }

    /// Goes along the direction as far as is best; whether that is anywhere.
    fn go_along(&mut self) -> bool {
        self.of_mass.times(&self.mass, &self.direction, &mut self.turned);
        for index in 0..self.conditions.len() {
            let condition = self.conditions[index];
            self.conditions[index].du = condition.along(&self.entries, &self.direction);
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
