//! The speeds of a run's steps.

use crate::error::{GaitError, RequestError};
use crate::request::pace::range;
use crate::request::{CHANGING_RUN_STEPS, RUN_SPEED, RunEnd, RunPart};
use std::f64::consts::{FRAC_PI_2, PI};

/// The most by which a run's speed changes from step to step, on the way and from standing or to it (m/s).
const CHANGE: f64 = 0.25;
const ENDS_CHANGE: f64 = 0.30;
/// The speed (m/s) beyond which it changes by less on the way from standing or to it, and by how much.
const FAST: f64 = 2.8;
const FAST_CHANGE: f64 = 0.15;
/// The speed of the first step from standing and of the last before it (m/s).
const SLOW: f64 = 1.2;
/// By how much the first step of a run is faster than the walk before it (m/s).
const FASTER: f64 = 0.3;

/// How many steps are enough for a run that begins and ends so, for its speed (m/s) to be reached, walks beside it not counted.
pub fn least_run_steps(speed: f64, from: RunEnd, to: RunEnd) -> usize {
    least(
        speed,
        [from, to].map(|end| match end {
            RunEnd::Running => None,
            RunEnd::Standing => Some(SLOW),
            RunEnd::Walking(walk) => Some(beside(walk.speed)),
        }),
    )
}

/// The speed of a run's step beside a walk at this speed (m/s), or of people's usual one, which is no slower than that.
fn beside(walk: Option<f64>) -> f64 {
    walk.map_or(SLOW, |walk| (walk + FASTER).max(SLOW))
}

/// The same for the speeds of the first and of the last step, where it does not begin or end in full run.
fn least(speed: f64, ends: [Option<f64>; 2]) -> usize {
    // A speed that is out of range, which more steps than a run may have do not reach, is refused elsewhere.
    let ramp = |slow: f64| (0..CHANGING_RUN_STEPS).take_while(|&k| rising(slow, k) < speed - 1e-9).count();
    1 + ends.into_iter().flatten().map(ramp).sum::<usize>()
}

/// The speed `k` steps after one at the speed `slow` (m/s) as fast as it may rise.
fn rising(slow: f64, k: usize) -> f64 {
    let quick = slow + ENDS_CHANGE * k as f64;
    if quick <= FAST {
        return quick;
    }
    let quick = ((FAST - slow) / ENDS_CHANGE).max(0.0).floor();
    let fast = slow + ENDS_CHANGE * quick;
    fast + FAST_CHANGE * (k as f64 - quick)
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

/// The speeds of all steps of a run whose first part has `steps` of them, for those of the walks beside it.
pub(super) fn tempo(
    speed: f64,
    steps: usize,
    then: &[RunPart],
    (from, to): (RunEnd, RunEnd),
    walks: [Option<f64>; 2],
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
    for (walk, run) in walks.into_iter().zip([speed, before]) {
        if let Some(walk) = walk.filter(|walk| *walk > run) {
            return Err(RequestError::RunSlowerThanWalk { speed: run, walk }.into());
        }
    }
    let slow = |end: RunEnd, walk: Option<f64>| match end {
        RunEnd::Running => None,
        RunEnd::Standing | RunEnd::Walking(_) => Some(beside(walk)),
    };
    let (first, last) = (slow(from, walks[0]), slow(to, walks[1]));
    // Each end within its own part.
    let ends = if then.is_empty() {
        vec![(speed, steps, [first, last])]
    } else {
        let own = then.last().map_or(steps, |part| part.steps);
        vec![(speed, steps, [first, None]), (before, own, [None, last])]
    };
    for (k, (speed, steps, ends)) in ends.into_iter().enumerate() {
        let least = least(speed, ends);
        if steps < least {
            return Err(refuse(k * then.len(), RequestError::RunSteps { steps, speed, least }));
        }
    }
    let n = speeds_of_all.len();
    let rising = |slow: Option<f64>, k: usize| slow.map_or(f64::INFINITY, |slow| rising(slow, k));
    for (k, speed) in speeds_of_all.iter_mut().enumerate() {
        *speed = speed.min(rising(first, k)).min(rising(last, n - 1 - k));
    }
    Ok(speeds_of_all)
}
