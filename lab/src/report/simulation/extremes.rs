//! Far from ordinary: masses, springs, steps, chains, locks, hours.

use super::figures::{self, Case, studied};
use super::solutions;
use crate::report::measured;
use crate::report::samples::{Random, Sample, chain, near_lock, person, tipped_chain};
use solaris_dynamics::{DynamicsError, Formulation};
use solaris_modes::{Method, Rule, Settings};
use std::f64::consts::FRAC_PI_2;

/// The errors at steps of 1e-2 s and 1e-3 s, and how well the answer is known; or what was said.
pub(super) type Errors = Result<[f64; 3], String>;

/// By ratios of masses.
pub(super) fn ratios() -> Result<Vec<(f64, Errors)>, String> {
    let methods = [1e-2, 1e-3].map(|step| Method::Fixed { rule: Rule::RungeKutta4, step });
    let one = |ratio: f64| {
        let simulation = figures::ratio(ratio)?;
        let case = Case { name: "two rods", simulation, duration: 2.0, rate: 100.0, solution: None };
        let study = studied(&case, &methods)?;
        let error = |row: usize| study.rows[row].result.clone().map(|accuracy| accuracy.position);
        let errors =
            error(0).and_then(|coarse| Ok([coarse, error(1)?, study.reference.uncertainty.position]));
        Ok((ratio, errors))
    };
    [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9].into_iter().map(one).collect()
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

/// What single evaluations lose in f64: inverse dynamics (Newton-Euler) and forward dynamics, as `‖x − x*‖ / ‖x*‖` with the right answers
/// from 32 digits, as geometric means over some samples.
pub(super) fn evaluations() -> Result<Vec<(&'static str, [f64; 2])>, String> {
    type Make = fn(&mut Random) -> Result<Sample, String>;
    const CASES: [(&str, u64, Make); 5] = [
        ("chain of 100 000 links", 3, |random| chain(random, 100_000)),
        ("chain of 10, the last 1e9 times as heavy", 20, |random| tipped_chain(random, 10, 1e9)),
        ("chain of 10, the last 1e9 times as light", 20, |random| tipped_chain(random, 10, 1e-9)),
        ("Z-Y-X joint, 1e-8 rad from lock", 20, |random| {
            let mut sample = near_lock(random, 0.0)?;
            sample.q[1] = FRAC_PI_2 - 1e-8;
            Ok(sample)
        }),
        ("human, shoulder 1e-8 rad from lock", 20, |random| {
            let mut sample = person(random)?;
            let shoulder =
                sample.figure.layout().dof_index("left_shoulder.ry").ok_or("a human has shoulders")?;
            sample.q[shoulder] = FRAC_PI_2 - 1e-8;
            Ok(sample)
        }),
    ];
    let of = |(name, samples, make): (&'static str, u64, Make)| {
        eprintln!("report: {name}");
        let mut random = Random::new(1);
        let mut logarithms = [0.0; 2];
        for _ in 0..samples {
            let sample = make(&mut random)?;
            let losses = losses(&sample).map_err(|error| format!("{name}: {error}"))?;
            logarithms.iter_mut().zip(losses).for_each(|(sum, loss)| *sum += loss.ln() / samples as f64);
        }
        Ok((name, logarithms.map(f64::exp)))
    };
    CASES.into_iter().map(of).collect()
}

fn losses(sample: &Sample) -> Result<[f64; 2], DynamicsError> {
    let by = Formulation::NewtonEuler;
    let torques = measured::error(&measured::inverse::<f64>(sample, by)?, &measured::inverse(sample, by)?);
    let accelerations = measured::error(&measured::forward::<f64>(sample)?, &measured::forward(sample)?);
    Ok([torques, accelerations])
}

/// A million seconds of the pendulum, let go from 1 rad, by some methods: how far off the angle is at most (rad), how much of the energy at play came
/// from nowhere or went, and evaluations of the dynamics.
pub(super) fn long() -> Result<Vec<(Method, [f64; 2], u64)>, String> {
    let fixed = |rule, step| Method::Fixed { rule, step };
    let methods = [
        fixed(Rule::SemiImplicitEuler, 1e-2),
        fixed(Rule::RungeKutta4, 1e-2),
        Method::Adaptive { tolerance: 1e-9 },
        Method::Adaptive { tolerance: 1e-12 },
    ];
    // Near 90° semi-implicit Euler keeps time by chance.
    let known = solutions::pendulum(1.0, figures::G.sqrt());
    let one = |method: Method| {
        eprintln!("report: a million seconds, {method:?}");
        let mut settings = Settings { method, forces: false, estimate: false, ..Settings::new(1e6, 1e-3) };
        settings.guard.evaluations = u64::MAX;
        settings.guard.energy = 1.0;
        let mut simulation = figures::pendulum()?;
        simulation.set_start(&[1.0], &[0.0]).map_err(|error| error.to_string())?;
        let run = simulation.run(&settings).map_err(|error| error.to_string())?;
        let (mut q, mut v) = ([0.0], [0.0]);
        let worst = run.motion.time().iter().enumerate().fold(0.0, |worst: f64, (i, t)| {
            known(*t, &mut q, &mut v);
            worst.max((run.motion.q(i)[0] - q[0]).abs())
        });
        let energy = &run.report.energy;
        Ok((method, [worst, energy.imbalance / energy.scale], run.report.cost.counts.evaluations))
    };
    methods.into_iter().map(one).collect()
}
