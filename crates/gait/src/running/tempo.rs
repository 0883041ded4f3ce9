//! The speeds of a run's steps.

use crate::error::{GaitError, RequestError};
use crate::request::pace::range;
use crate::request::{CHANGING_RUN_STEPS, RUN_SPEED, RunEnd, RunPart};
use std::f64::consts::{FRAC_PI_2, PI};

/// The most by which a run's speed changes from step to step, on the way and from standing or to it (m/s).
const CHANGE: f64 = 0.25;
const ENDS_CHANGE: f64 = 0.30;
/// The speed of the first step from standing and of the last before it (m/s).
const SLOW: f64 = 1.2;

/// How many steps a run has at least that begins and ends so, for its speed (m/s) to be reached.
pub fn least_run_steps(speed: f64, from: RunEnd, to: RunEnd) -> usize {
    let ramp = ((speed - SLOW) / ENDS_CHANGE - 1e-9).ceil().max(0.0) as usize;
    1 + [from, to].into_iter().filter(|end| *end == RunEnd::Standing).count() * ramp
}

/// How many steps a change of speed takes.
fn least_steps(from: f64, to: f64) -> usize {
    (FRAC_PI_2 * (to - from).abs() / CHANGE - 1e-9).ceil().max(1.0) as usize
}

/// The speeds of a part's steps after one at the speed `before`: half a wave of a cosine, and on.
///
/// ```text
/// V_k = V₀ + (V₁ − V₀)(1 − cos(π k/m))/2      k = 1, 2, … m
/// ```
fn speeds(before: f64, part: &RunPart) -> impl Iterator<Item = f64> + use<> {
    let (change, least) = (part.speed - before, least_steps(before, part.speed) as f64);
    (1..=part.steps).map(move |k| before + 0.5 * change * (1.0 - (PI * (k as f64 / least).min(1.0)).cos()))
}

/// The speeds of all steps of a run whose first part has `steps` of them.
pub(super) fn tempo(
    speed: f64,
    steps: usize,
    then: &[RunPart],
    (from, to): (RunEnd, RunEnd),
) -> Result<Vec<f64>, GaitError> {
    let refuse = |part: usize, why: RequestError| match part {
        0 => GaitError::from(why),
        _ => GaitError::InPart { number: part + 1, why: Box::new(why.into()) },
    };
    let all: usize = steps + then.iter().map(|part| part.steps).sum::<usize>();
    if all > CHANGING_RUN_STEPS {
        return Err(RequestError::RunTooLong { steps: all, most: CHANGING_RUN_STEPS }.into());
    }
    let mut speeds_of_all = vec![speed; steps];
    let mut before = speed;
    for (k, part) in then.iter().enumerate() {
        range("speed", part.speed, " m/s", RUN_SPEED, String::new).map_err(|why| refuse(k + 1, why))?;
        let least = least_steps(before, part.speed);
        if part.steps < least {
            let why = RequestError::RunChange { steps: part.steps, from: before, to: part.speed, least };
            return Err(refuse(k + 1, why));
        }
        speeds_of_all.extend(speeds(before, part));
        before = part.speed;
    }
    // Each end within its own part.
    let last = then.last().map_or(steps, |part| part.steps);
    let ends = if then.is_empty() {
        vec![(speed, steps, from, to)]
    } else {
        vec![(speed, steps, from, RunEnd::Running), (before, last, RunEnd::Running, to)]
    };
    for (k, (speed, steps, from, to)) in ends.into_iter().enumerate() {
        let least = least_run_steps(speed, from, to);
        if steps < least {
            return Err(refuse(k * then.len(), RequestError::RunSteps { steps, speed, least }));
        }
    }
    let n = speeds_of_all.len();
    let rising = |k: usize| SLOW + ENDS_CHANGE * k as f64;
    for (k, speed) in speeds_of_all.iter_mut().enumerate() {
        if from == RunEnd::Standing {
            *speed = speed.min(rising(k));
        }
        if to == RunEnd::Standing {
            *speed = speed.min(rising(n - 1 - k));
        }
    }
    Ok(speeds_of_all)
}
