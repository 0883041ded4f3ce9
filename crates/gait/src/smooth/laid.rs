//! Steps laid along a way: as long as the pace has them, shorter round bends, each foot along the way at its middle.

use crate::error::RequestError;
use crate::request::pace::{Pace, SHORTEST_STEP};
use crate::request::path::{Run, WalkPath};
use crate::request::{CHANGING_STEPS, TURN};
use crate::smooth::walk::steps;

/// Radius (m) from which on a bend does not shorten the steps: below it they go with its third root. That speed goes with the third
/// root of the radius is people's on curved ways (H. Hicheur et al., *Experimental Brain Research* 162 (2005) 145–154); from which
/// radius on is this walker's own.
const WIDE: f64 = 4.0;
/// By how much a step turns at most where it can be shorter instead, and on the spot (rad).
const COMFORTABLE: f64 = 22.0 * std::f64::consts::PI / 180.0;
/// A turn on the spot by less than this (rad) is made by the step that goes on.
const SMALL: f64 = 12.0 * std::f64::consts::PI / 180.0;
/// By how much a step may be longer or shorter than another one, over the distance between them.
const CHANGE: f64 = 0.3;
/// Steps beside a turn on the spot, and the shortest ones of all, over the pace's.
const BESIDE_A_TURN: f64 = 0.35;
const SHORTEST: f64 = 0.1;
/// Distance of the places at which the lengths are reckoned (m).
const GRID: f64 = 0.01;
/// The styles between which steps change: tenths of the pace's length.
const STYLES: f64 = 10.0;

/// A step along a way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Laid {
    /// The pace in whose style it is made.
    pub(crate) pace: Pace,
    /// Its length (m), by how much it turns, and which way it goes against the foot before (rad).
    pub(crate) length: f64,
    pub(crate) turn: f64,
    pub(crate) bearing: f64,
    /// Where it leads (x, z; m).
    pub(crate) place: [f64; 2],
}

/// Lays steps of a pace along a way; the middle of a foot is so far ahead of its heel (m).
pub(crate) fn lay(path: &WalkPath, pace: Pace, middle: f64) -> Result<Vec<Laid>, RequestError> {
    let mut laid = Laying { pace, steps: Vec::new(), place: [0.0, 0.0], heading: 0.0 };
    let last = path.runs.len() - 1;
    for (k, run) in path.runs.iter().enumerate() {
        let spot = if run.turn.abs() > SMALL { (run.turn.abs() / COMFORTABLE).ceil() } else { 0.0 };
        for _ in 0..spot as usize {
            laid.step(laid.place, laid.heading + run.turn / spot, 0.0);
        }
        let ends = [k == 0 && spot == 0.0, k == last];
        let stations = stations(run, pace.step_length, ends)?;
        for (i, &(along, own)) in stations.iter().enumerate() {
            let ([x, z], heading) = run.at(along + middle);
            let (sin, cos) = heading.sin_cos();
            // A foot that pushes off into a longer step does so as in that one.
            let style = stations.get(i + 1).map_or(own, |(_, next)| own.max(*next));
            laid.step([x - middle * sin, z - middle * cos], heading, style);
        }
        if laid.steps.len() > CHANGING_STEPS {
            return Err(RequestError::PathTooLong { length: path.length(), most: CHANGING_STEPS });
        }
    }
    Ok(laid.steps)
}

struct Laying {
    pace: Pace,
    steps: Vec<Laid>,
    place: [f64; 2],
    heading: f64,
}

impl Laying {
    /// A step to a place and a heading, in the style of steps of some length (m).
    fn step(&mut self, place: [f64; 2], heading: f64, style: f64) {
        let (dx, dz) = (place[0] - self.place[0], place[1] - self.place[1]);
        let length = dx.hypot(dz);
        let bearing = if length > 1e-9 { dx.atan2(dz) - self.heading } else { 0.0 };
        let part = (style / self.pace.step_length * STYLES).round() / STYLES;
        let step_length = self.pace.step_length * part.clamp(1.01 * SHORTEST_STEP, 1.0);
        let pace = Pace { step_length, ..self.pace };
        let bearing = bearing.sin().atan2(bearing.cos());
        self.steps.push(Laid { pace, length, turn: heading - self.heading, bearing, place });
        (self.place, self.heading) = (place, heading);
    }
}

/// How far along a run its steps lead (m), and the lengths that they have without the factors of the ends: as few as need none longer
/// than 1.02 of what is wanted, the last one to its very end. `ends`: whether the walk begins and ends with it.
fn stations(run: &Run, step: f64, ends: [bool; 2]) -> Result<Vec<(f64, f64)>, RequestError> {
    let length = run.length();
    if length <= 0.0 {
        return Ok(Vec::new());
    }
    let wanted = wanted(run, step, ends);
    let at = |along: f64| wanted[((along / GRID) as usize).min(wanted.len() - 1)];
    let factors = |n: usize| -> Vec<f64> {
        let own = steps::factors(n).enumerate();
        own.map(|(i, factor)| {
            let begins = i == 0 && n > 1;
            if (begins && !ends[0]) || (!begins && !ends[1]) { 1.0 } else { factor }
        })
        .collect()
    };
    let walk = |n: usize, part: f64| -> Vec<(f64, f64)> {
        let mut along = 0.0;
        let step = |factor: &f64| {
            // As long as it is wanted where it is half done.
            let first = part * factor * at(along);
            let own = part * at(along + 0.5 * first);
            along += factor * own;
            (along, own)
        };
        factors(n).iter().map(step).collect()
    };
    let reached = |n: usize, part: f64| walk(n, part).last().map_or(0.0, |(along, _)| *along);
    let mut n = 1;
    while reached(n, 1.02) < length {
        n += 1;
        if n > CHANGING_STEPS {
            return Err(RequestError::PathTooLong { length, most: CHANGING_STEPS });
        }
    }
    // Where every step turns by less than a step may.
    for n in n..n + 8 {
        let (mut lower, mut upper) = (0.0, 1.02);
        for _ in 0..60 {
            let middle = 0.5 * (lower + upper);
            if reached(n, middle) < length { lower = middle } else { upper = middle }
        }
        let mut found = walk(n, upper);
        if let Some(last) = found.last_mut() {
            last.0 = length;
        }
        let mut before = 0.0;
        let turns = found.iter().all(|(along, _)| {
            let turn = run.at(*along).1 - run.at(before).1;
            before = *along;
            turn.abs() <= TURN
        });
        if turns {
            return Ok(found);
        }
    }
    let (at, turn) = bend(run, step);
    Err(RequestError::PathBends { x: at[0], z: at[1], turn: turn.to_degrees(), most: TURN.to_degrees() })
}

/// The wanted length of a step (m) over the way.
fn wanted(run: &Run, step: f64, ends: [bool; 2]) -> Vec<f64> {
    let length = run.length();
    let count = (length / GRID).ceil() as usize + 1;
    let turned: Vec<f64> = (0..count).map(|i| run.turned(GRID * i as f64)).collect();
    let half = (0.5 * step / GRID).ceil() as usize;
    let mut wanted: Vec<f64> = (0..count)
        .map(|i| {
            let (from, to) = (i.saturating_sub(half), (i + half).min(count - 1));
            let turn = turned[to] - turned[from];
            if turn < 1e-9 {
                return step;
            }
            let radius = step / turn;
            (step * (radius / WIDE).cbrt().min(1.0)).min(COMFORTABLE * radius).max(SHORTEST * step)
        })
        .collect();
    for (end, own) in [0, count - 1].into_iter().zip(ends) {
        if !own {
            wanted[end] = wanted[end].min(BESIDE_A_TURN * step);
        }
    }
    let most = CHANGE * GRID;
    for i in 1..count {
        wanted[i] = wanted[i].min(wanted[i - 1] + most);
    }
    for i in (1..count).rev() {
        wanted[i - 1] = wanted[i - 1].min(wanted[i] + most);
    }
    wanted
}

/// Where a run bends the most within a step, and by how much.
fn bend(run: &Run, step: f64) -> ([f64; 2], f64) {
    let count = (run.length() / GRID) as usize + 1;
    let turn = |i: usize| run.turned(GRID * i as f64 + SHORTEST * step) - run.turned(GRID * i as f64);
    let worst = (0..count).max_by(|&a, &b| turn(a).total_cmp(&turn(b))).unwrap_or_default();
    (run.at(GRID * worst as f64).0, turn(worst))
}
