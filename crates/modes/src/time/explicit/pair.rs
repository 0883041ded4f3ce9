//! One step of the pair: stages, its error, and the states within it.

use super::tableau::{A, ALL_STAGES, B, D, E3, E5, EXTRA, NODES, Row, STAGES};
use crate::time::evaluate::{Evaluator, finite};
use crate::time::{System, TimeError};

/// Terms of the interpolation.
const TERMS: usize = 7;

/// A step, and the room that it needs.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    /// The rates `kᵢ` of the stages, the thirteenth that at the end of the step.
    stages: Vec<Vec<f64>>,
    /// Whether the rate at the end of the step is there.
    has_end: bool,
    /// The interpolation of the step, where it is there.
    terms: Vec<Vec<f64>>,
    has_terms: bool,
    state: Vec<f64>,
    /// The state at the end of the step.
    pub(super) next: Vec<f64>,
    /// A state within the step.
    pub(super) between: Vec<f64>,
}

impl Pair {
    pub(super) fn new(states: usize) -> Self {
        let zeros = || vec![0.0; states];
        Self {
            stages: vec![zeros(); ALL_STAGES],
            has_end: false,
            terms: vec![zeros(); TERMS],
            has_terms: false,
            state: zeros(),
            next: zeros(),
            between: zeros(),
        }
    }

    /// Finds the rate at the beginning of the first step.
    pub(super) fn begin<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        t: f64,
        y: &[f64],
    ) -> Result<(), TimeError> {
        evaluator.rate(t, y, &mut self.stages[0])
    }

    /// The rate at the beginning of the step (1/s), in units of what is allowed.
    pub(super) fn slope(&self, y: &[f64], tolerance: f64) -> f64 {
        norm(y, tolerance, |i| self.stages[0][i])
    }

    /// How much the rate changes (1/s) in a step of length `h` (s) of order one, in units of what is allowed.
    pub(super) fn change<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        (t, h): (f64, f64),
        y: &[f64],
        tolerance: f64,
    ) -> Result<f64, TimeError> {
        sum(y, h, &[(0, 1.0)], &self.stages, &mut self.state);
        evaluator.system.settle(&mut self.state);
        evaluator.rate(t + h, &self.state, &mut self.stages[1])?;
        Ok(norm(y, tolerance, |i| self.stages[1][i] - self.stages[0][i]))
    }

    /// The state `next`, a step of length `h` (s) after `y`.
    ///
    /// ```text
    /// kᵢ = f(t + cᵢ·h, y + h·Σ aᵢⱼ·kⱼ)        y⁺ = y + h·Σ bᵢ·kᵢ
    /// ```
    pub(super) fn step<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        (t, h): (f64, f64),
        y: &[f64],
    ) -> Result<(), TimeError> {
        (self.has_end, self.has_terms) = (false, false);
        for (stage, row) in (1..STAGES).zip(A) {
            self.find(evaluator, (stage, row), (t, h), y)?;
        }
        sum(y, h, B, &self.stages, &mut self.next);
        evaluator.system.settle(&mut self.next);
        finite(&self.next).map_err(|source| TimeError::Rate { time: t + h, source })
    }

    /// Finds the rate of a stage.
    fn find<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        (stage, row): (usize, Row),
        (t, h): (f64, f64),
        y: &[f64],
    ) -> Result<(), TimeError> {
        sum(y, h, row, &self.stages, &mut self.state);
        evaluator.rate(t + NODES[stage] * h, &self.state, &mut self.stages[stage])
    }

    /// The error of the step from `y`, in units of what is allowed: relative to the state and, below 1, absolute.
    ///
    /// ```text
    /// E = h·e₅²/√(e₅² + 0.01·e₃²)        e² = Σ (Σ eᵢ·kᵢ / s)² / n        s = tolerance·(1 + max(|y|, |y⁺|))
    /// ```
    ///
    /// # Source
    ///
    /// Hairer, Nørsett, Wanner (1993), §II.10, (10.17): between the errors of the formulas of orders five and three, so that it falls
    /// with the eighth power of `h`.
    pub(super) fn error(&self, h: f64, y: &[f64], tolerance: f64) -> f64 {
        let (mut fifth, mut third) = (0.0, 0.0);
        for i in 0..y.len() {
            let scale = tolerance * (1.0 + y[i].abs().max(self.next[i].abs()));
            let of = |row: Row| row.iter().map(|(j, e)| e * self.stages[*j][i]).sum::<f64>() / scale;
            fifth += of(E5).powi(2);
            third += of(E3).powi(2);
        }
        let both = fifth + 0.01 * third;
        if both > 0.0 { h * fifth / (both * y.len() as f64).sqrt() } else { both }
    }

    /// Finds the rate at the end of the step, `t` (s), unless it is there.
    pub(super) fn find_end<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        t: f64,
    ) -> Result<(), TimeError> {
        if !self.has_end {
            evaluator.rate(t, &self.next, &mut self.stages[STAGES])?;
            self.has_end = true;
        }
        Ok(())
    }

    /// The step that follows begins where this one ended.
    pub(super) fn go_on(&mut self) {
        self.stages.swap(0, STAGES);
    }

    /// Finds the interpolation of the step of length `h` (s) from `y` at `t` (s), unless it is there: for four evaluations, of which
    /// the step after this one needs the first.
    ///
    /// # Source
    ///
    /// Hairer, Nørsett, Wanner (1993), §II.6, "Dense output for DOP853".
    pub(super) fn interpolate<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        (t, h): (f64, f64),
        y: &[f64],
    ) -> Result<(), TimeError> {
        if self.has_terms {
            return Ok(());
        }
        self.find_end(evaluator, t + h)?;
        for (stage, row) in (STAGES + 1..ALL_STAGES).zip(EXTRA) {
            self.find(evaluator, (stage, row), (t, h), y)?;
        }
        let (first, last) = (&self.stages[0], &self.stages[STAGES]);
        for i in 0..y.len() {
            let difference = self.next[i] - y[i];
            self.terms[0][i] = difference;
            self.terms[1][i] = h * first[i] - difference;
            self.terms[2][i] = 2.0 * difference - h * (first[i] + last[i]);
        }
        for (term, row) in self.terms[3..].iter_mut().zip(D) {
            term.fill(0.0);
            for (stage, weight) in row {
                for (term, rate) in term.iter_mut().zip(&self.stages[*stage]) {
                    *term += h * weight * rate;
                }
            }
        }
        self.has_terms = true;
        Ok(())
    }

    /// The state `between` at a fraction `θ` of the step from `y`, by its interpolation.
    ///
    /// ```text
    /// y(θ) = y + θ·(r₀ + (1 − θ)·(r₁ + θ·(r₂ + (1 − θ)·(r₃ + θ·(r₄ + (1 − θ)·(r₅ + θ·r₆))))))
    /// ```
    pub(super) fn at<S: System + ?Sized>(
        &mut self,
        system: &S,
        fraction: f64,
        y: &[f64],
    ) -> Result<(), crate::time::RateError> {
        for (i, between) in self.between.iter_mut().enumerate() {
            let mut value = 0.0;
            for (index, term) in self.terms.iter().enumerate().rev() {
                value = (value + term[i]) * if index % 2 == 0 { fraction } else { 1.0 - fraction };
            }
            *between = y[i] + value;
        }
        system.settle(&mut self.between);
        finite(&self.between)
    }
}

/// The root of the mean square of a change of the state `y`, in units of what is allowed.
fn norm(y: &[f64], tolerance: f64, change: impl Fn(usize) -> f64) -> f64 {
    let sum: f64 = (0..y.len()).map(|i| (change(i) / (tolerance * (1.0 + y[i].abs()))).powi(2)).sum();
    (sum / y.len() as f64).sqrt()
}

/// `y + h·Σ wⱼ·kⱼ`.
fn sum(y: &[f64], h: f64, row: Row, stages: &[Vec<f64>], next: &mut [f64]) {
    next.copy_from_slice(y);
    for (stage, weight) in row {
        let weight = h * weight;
        for (next, rate) in next.iter_mut().zip(&stages[*stage]) {
            *next += weight * rate;
        }
    }
}

#[cfg(test)]
mod orders;
