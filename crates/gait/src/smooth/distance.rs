//! How many steps lead to a distance, and how long they are.

use crate::body::LegGeometry;
use crate::request::WalkGround;
use crate::request::pace::{Pace, STEP_LENGTH_MARGIN};
use crate::smooth::ends::eased;
use crate::smooth::walk::{Terrain, steps};
use std::ops::RangeInclusive;

/// How often the steps over a relief are fitted to where they lead.
const SETTLES: usize = 20;
/// How many secants are drawn after that, and how far from where they begin steps may come, over their length there.
const SECANTS: usize = 6;
const FROM_START: RangeInclusive<f64> = 0.5..=1.5;
/// From how many per cent longer and shorter steps on that is tried at most.
const MOST_STARTS: u32 = 12;
/// What counts as there, of the distance.
const THERE: f64 = 1e-9;

/// How many steps a distance (m) takes on this ground, in the first way over it or the other one, and the length of the pace, for step frequencies of this
/// `tempo`. Over a relief as near to it as feet find places.
pub(super) fn to_distance(
    distance: f64,
    (ground, otherwise): (&WalkGround, bool),
    leg: &LegGeometry,
    pace: Pace,
    tempo: f64,
) -> (usize, f64) {
    let over = |n: usize, length: f64| {
        Terrain::parts_on_ground((ground, otherwise), leg, length, &steps::even(n, length))
    };
    let parts = |n: usize| -> Vec<f64> {
        match ground {
            WalkGround::Level => {
                let walked = eased(vec![pace; n], tempo).into_iter();
                walked.map(|walked| walked.step_length / pace.step_length).collect()
            }
            WalkGround::Slope(slope) => (0..n).map(|i| Terrain::part_on_slope(*slope, i, n)).collect(),
            WalkGround::Relief(_) => over(n, pace.step_length).unwrap_or_else(|| vec![1.0; n]),
            _ => vec![1.0; n],
        }
    };
    let even = steps::for_distance(distance, pace.step_length, parts);
    match ground {
        WalkGround::Relief(_) => over_relief(distance, over, pace, even).unwrap_or(even),
        _ => even,
    }
}

/// Steps to a distance over a relief, from `even` ones that lead there or nearly. Longer or shorter steps meet other slopes, and where a foot finds no place
/// those before it are fitted: from one length on all may be others, so that of so many steps there may be none that lead there, but of one more or less.
fn over_relief(
    distance: f64,
    parts: impl Fn(usize, f64) -> Option<Vec<f64>>,
    pace: Pace,
    (count, length): (usize, f64),
) -> Option<(usize, f64)> {
    let total = |n: usize, length: f64| -> Option<f64> {
        let parts = parts(n, length)?;
        Some(steps::factors(n).zip(parts).map(|(factor, part)| factor * part * length).sum())
    };
    // The length to which steps settle, and by how much it misses; none where a foot finds no place.
    let settled = |n: usize, from: f64| -> Option<(f64, f64)> {
        let mut length = from;
        for _ in 0..SETTLES {
            length *= distance / total(n, length)?;
        }
        let mut off = total(n, length)? - distance;
        // Where steps before an edge stay as long as they are that comes near to it slowly: on by secants.
        let (mut other, mut other_off) = (from, total(n, from)? - distance);
        for _ in 0..SECANTS {
            let next = length - off * (length - other) / (off - other_off);
            if off.abs() < THERE * distance || !FROM_START.contains(&(next / from)) {
                break;
            }
            (other, other_off) = (length, off);
            (length, off) = (next, total(n, next)? - distance);
        }
        Some((length, off.abs()))
    };
    let longest = (1.0 + STEP_LENGTH_MARGIN) * pace.step_length;
    let other = (1..=MOST_STARTS).flat_map(|k| [1.0 + 0.01 * f64::from(k), 1.0 - 0.01 * f64::from(k)]);
    let stretched = std::iter::once(1.0).chain(other);
    let counts = [count, count + 1, count - 1].into_iter().filter(|&n| n > 0);
    let starts = counts.flat_map(|n| {
        let even = length * count as f64 / n as f64;
        stretched.clone().map(move |stretched| (n, even * stretched))
    });
    let mut nearest: Option<(usize, f64, f64)> = None;
    for (n, from) in starts {
        let Some((length, off)) = settled(n, from).filter(|(length, _)| *length <= longest) else { continue };
        if nearest.is_none_or(|(_, _, least)| off < least) {
            nearest = Some((n, length, off));
        }
        if off < THERE * distance {
            break;
        }
    }
    nearest.map(|(n, length, _)| (n, length))
}
