//! Ground that goes by under somebody who stays in place: a treadmill's belt, or that of a loop which a game moves on.

use crate::feet::Sole;
use crate::planted::{SLOW, Stands, WINDOW, slow};
use solaris_model::{Placement, Vector3};

/// A foot that stands in less than this share of the frames walks on no ground that is known: who sprints does in a fifth, of which what is seen loses a
/// tenth of a second at its ends.
const STANDS: f64 = 0.08;
/// How high (of the ankle) above where it is lowest, but for so many of the frames, a point may be for its velocity to be the ground's.
const LOW: f64 = 0.2;
const LOWER: f64 = 0.05;
/// Who goes farther than this, of the way of the ground, is not in place.
const IN_PLACE: f64 = 0.3;

/// How the ground moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Belt {
    /// m/s, level, in the frame of the heading.
    pub(crate) velocity: Vector3<f64>,
    /// When it is where it is (s).
    since: f64,
}

impl Belt {
    /// Where both feet hardly ever stand though somebody stays in place, the ground on which they do: frames are then moved so that it rests. Gives which
    /// points stand.
    pub(crate) fn found(
        soles: &[Sole; 2],
        pelvis: usize,
        time: &[f64],
        frames: &mut [Vec<Placement>],
        stands: &[[Stands; 2]],
    ) -> Option<(Self, Vec<[Stands; 2]>)> {
        if (0..2).any(|side| share(stands, side) >= STANDS) {
            return None;
        }
        let belt = Self { velocity: velocity(soles, time, frames)?, since: *time.first()? };
        let [first, last] = [frames.first()?, frames.last()?].map(|places| places[pelvis].translation.vector);
        let way = (last - first).xz().norm();
        if belt.velocity.norm() < SLOW || way > IN_PLACE * belt.way(*time.last()?).norm() {
            return None;
        }
        belt.shift(time, frames, -1.0);
        let stands = slow(soles, time, frames);
        if (0..2).all(|side| share(&stands, side) >= STANDS) {
            return Some((belt, stands));
        }
        belt.shift(time, frames, 1.0);
        None
    }

    /// How far it has gone at a time (m).
    pub(crate) fn way(&self, time: f64) -> Vector3<f64> {
        self.velocity * (time - self.since)
    }

    fn shift(&self, time: &[f64], frames: &mut [Vec<Placement>], sign: f64) {
        for (time, places) in time.iter().zip(frames) {
            let way = self.way(*time) * sign;
            for place in places {
                place.translation.vector += way;
            }
        }
    }
}

/// In which share of the frames a foot stands.
fn share(stands: &[[Stands; 2]], side: usize) -> f64 {
    let stood = stands.iter().filter(|of| of[side].contains(&true)).count();
    stood as f64 / stands.len().max(1) as f64
}

/// The velocity that points of soles have when they are low: the middle one of all, for on the whole they stand longer than they swing by.
fn velocity(soles: &[Sole; 2], time: &[f64], frames: &[Vec<Placement>]) -> Option<Vector3<f64>> {
    let points: Vec<[[Vector3<f64>; 3]; 2]> =
        frames.iter().map(|places| soles.each_ref().map(|sole| sole.at(places))).collect();
    let mut found: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
    for (side, i) in (0..6).map(|k| (k / 3, k % 3)) {
        let mut heights: Vec<f64> = points.iter().map(|of| of[side][i].y).collect();
        heights.sort_by(f64::total_cmp);
        let lowest = heights.get((LOWER * heights.len() as f64) as usize)?;
        let most = lowest + LOW * soles[side].ankle.max(1e-6);
        let mut from = 0;
        for to in 1..points.len() {
            // One frame at least, however few there are in a second.
            while time[to] - time[from] > WINDOW && from + 1 < to {
                from += 1;
            }
            let lasts = time[to] - time[from];
            if lasts > 0.0 && (from..=to).all(|frame| points[frame][side][i].y < most) {
                let way = points[to][side][i] - points[from][side][i];
                found[0].push(way.x / lasts);
                found[1].push(way.z / lasts);
            }
        }
    }
    let [x, z] = found.map(|mut of| {
        of.sort_by(f64::total_cmp);
        of.get(of.len() / 2).copied()
    });
    Some(Vector3::new(x?, 0.0, z?))
}
