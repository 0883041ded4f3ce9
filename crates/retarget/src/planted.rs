//! When which points of a foot stand.

use crate::feet::Sole;
use solaris_model::{Motion, Placement, Vector3};

/// Whether heel, ball and tip stand.
pub(crate) type Stands = [bool; 3];

/// A point that moves slower than this (m/s) stands, of somebody whose ankles are 0.1 m up; swinging feet go twenty times as fast.
pub(crate) const SLOW: f64 = 0.1;
/// Times on both sides over which a velocity is taken (s): longer than a camera's noise, shorter than a step.
pub(crate) const WINDOW: f64 = 0.04;
/// A stance is no shorter than this (s).
const SHORT: f64 = 0.06;

/// Which points stand in each frame: those that the motion says are planted, and where it says nothing those that hardly move.
pub(crate) fn planted(
    soles: &[Sole; 2],
    time: &[f64],
    frames: &[Vec<Placement>],
    motion: &Motion,
) -> Vec<[Stands; 2]> {
    if motion.planted.is_empty() {
        return slow(soles, time, frames);
    }
    let mut stands = vec![[[false; 3]; 2]; time.len()];
    for interval in &motion.planted {
        let Some(side) =
            soles.iter().position(|sole| interval.link == sole.foot || interval.link == sole.toes)
        else {
            continue;
        };
        for (frame, at) in time.iter().enumerate() {
            if (interval.start..=interval.end).contains(at) {
                let point = frames[frame][interval.link] * nalgebra::Point3::from(interval.point);
                let of = soles[side].at(&frames[frame]);
                let near = |i: &usize| (of[*i] - point.coords).norm();
                let nearest = (0..3).min_by(|a, b| near(a).total_cmp(&near(b))).unwrap_or(0);
                stands[frame][side][nearest] = true;
            }
        }
    }
    stands
}

/// The points that hardly move.
pub(crate) fn slow(soles: &[Sole; 2], time: &[f64], frames: &[Vec<Placement>]) -> Vec<[Stands; 2]> {
    let points: Vec<[[Vector3<f64>; 3]; 2]> =
        frames.iter().map(|places| soles.each_ref().map(|sole| sole.at(places))).collect();
    let count = time.len();
    let mut stands = vec![[[false; 3]; 2]; count];
    let (mut from, mut to) = (0, 0);
    for frame in 0..count {
        while time[frame] - time[from] > WINDOW {
            from += 1;
        }
        while to + 1 < count && (to <= frame || time[to] - time[frame] < WINDOW) {
            to += 1;
        }
        let (first, last) = (from.min(frame.saturating_sub(1)), to.max(frame));
        let lasts = time[last] - time[first];
        for (side, sole) in soles.iter().enumerate() {
            // A foot of one whose ankles are a tenth of a metre up goes by less than 0.17 m/s.
            let slow = SLOW * (sole.ankle.max(1e-6) / 0.1).sqrt();
            for i in 0..3 {
                let way = (points[last][side][i] - points[first][side][i]).norm();
                stands[frame][side][i] = lasts <= 0.0 || way < slow * lasts;
            }
        }
    }
    for side in 0..2 {
        let runs: Vec<_> = runs(count, |frame| stands[frame][side].contains(&true)).collect();
        for run in runs {
            if time[run.end - 1] - time[run.start] < SHORT && count > 1 {
                stands[run].iter_mut().for_each(|sides| sides[side] = [false; 3]);
            }
        }
    }
    stands
}

/// The stretches of frames in which something holds.
pub(crate) fn runs(
    count: usize,
    holds: impl Fn(usize) -> bool,
) -> impl Iterator<Item = std::ops::Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let start = (at..count).find(|frame| holds(*frame))?;
        let end = (start..count).find(|frame| !holds(*frame)).unwrap_or(count);
        at = end;
        Some(start..end)
    })
}
