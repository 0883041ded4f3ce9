//! Far from ordinary: masses, springs, steps.

use super::figures::{self, Case, studied};
use super::solutions;
use solaris_modes::{Method, Rule};

/// For ratios of masses: the errors at steps of 1e-2 s and 1e-3 s, and how well the answer is known.
pub(super) fn ratios() -> Result<Vec<(f64, [f64; 3])>, String> {
    let methods = [1e-2, 1e-3].map(|step| Method::Fixed { rule: Rule::RungeKutta4, step });
    let one = |ratio: f64| {
        let simulation = figures::ratio(ratio)?;
        let case = Case { name: "two rods", simulation, duration: 2.0, rate: 100.0, solution: None };
        let study = studied(&case, &methods)?;
        let error =
            |row: usize| study.rows[row].result.as_ref().map_or(f64::INFINITY, |accuracy| accuracy.position);
        Ok((ratio, [error(0), error(1), study.reference.uncertainty.position]))
    };
    [1e-6, 1e-3, 1.0, 1e3, 1e6].into_iter().map(one).collect()
}

/// What a spring of a stiffness (N/m) comes to.
pub(super) struct Spring {
    pub(super) stiffness: f64,
    /// The longest step (s) at which the classical rule of order four is stable.
    pub(super) longest: f64,
    /// The error (m) at a step of 1e-3 s, or what was said.
    pub(super) at_a_millisecond: Result<f64, String>,
    /// The same where a tolerance of 1e-6 was asked.
    pub(super) automatic: Result<f64, String>,
}

pub(super) fn springs() -> Result<Vec<Spring>, String> {
    let methods =
        [Method::Fixed { rule: Rule::RungeKutta4, step: 1e-3 }, Method::Automatic { tolerance: 1e-6 }];
    let one = |power: i32| {
        let stiffness = 10_f64.powi(power);
        let rate = stiffness.sqrt();
        // A fifth of the critical damping: δ = ω/5.
        let solution = solutions::damped(0.1, rate, 0.2 * rate);
        let simulation = figures::spring(stiffness)?;
        let case = Case { name: "spring", simulation, duration: 1.0, rate: 100.0, solution: Some(solution) };
        let study = studied(&case, &methods)?;
        let result = |row: usize| study.rows[row].result.clone().map(|accuracy| accuracy.position);
        let longest = stable_step(0.2) / rate;
        Ok(Spring { stiffness, longest, at_a_millisecond: result(0), automatic: result(1) })
    };
    [0, 2, 4, 6, 7, 9].into_iter().map(one).collect()
}

/// The longest stable step of the classical rule of order four, times ω, for an oscillation with the damping ratio `ζ`.
fn stable_step(damping: f64) -> f64 {
    let growth = |h: f64| {
        let z = nalgebra::Complex::new(-damping * h, (1.0 - damping * damping).sqrt() * h);
        (z * (z * (z * (z / 24.0 + 1.0 / 6.0) + 0.5) + 1.0) + 1.0).norm()
    };
    let (mut low, mut high) = (1.0, 4.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if growth(middle) < 1.0 { low = middle } else { high = middle }
    }
    low
}
