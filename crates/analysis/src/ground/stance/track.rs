//! Tracks of the points of the soles, and the ground that they tell of.

use super::Belt;
use crate::ground::{PlacedFeet, Stance};
use nalgebra::Vector3;

/// A foot whose lowest point never comes nearer to the lowest one of all feet than this (m) never stands.
const RAISED: f64 = 0.05;

/// Share of the frames that may lie below a point's lowest height.
const STRAY: f64 = 0.05;

/// Feet in all frames, and how low they come.
pub(super) struct Tracks<'a> {
    placed: &'a PlacedFeet<'a>,
    /// By foot, the lowest height (m, along up) of heel, ball and tip.
    low: Vec<[f64; 3]>,
    /// By foot, whether it ever comes down.
    stands: Vec<bool>,
}

/// How one foot moves: of heel, ball and tip in each frame.
pub(super) struct FootTrack {
    /// How far above its own lowest height (m).
    pub(super) above: Vec<[f64; 3]>,
    /// How fast against the ground (m/s).
    pub(super) speed: Vec<[f64; 3]>,
    /// Whether it ever comes down.
    pub(super) stands: bool,
}

impl<'a> Tracks<'a> {
    pub(super) fn of(placed: &'a PlacedFeet<'a>) -> Self {
        let up = placed.prepared().up;
        let low = |foot: usize, i: usize| {
            quantile(placed.frames().map(|feet| feet[foot].points[i].dot(&up)).collect(), STRAY)
        };
        let low: Vec<_> = (0..placed.soles().len()).map(|foot| [0, 1, 2].map(|i| low(foot, i))).collect();
        let lowest = |low: &[f64; 3]| low.iter().copied().fold(f64::INFINITY, f64::min);
        let ground = low.iter().map(lowest).fold(f64::INFINITY, f64::min);
        let stands = low.iter().map(|low| lowest(low) <= ground + RAISED).collect();
        Self { placed, low, stands }
    }

    /// Median of the lowest heights of all points of the feet that may stand.
    pub(super) fn level(&self) -> f64 {
        let standing = self.low.iter().zip(&self.stands).filter(|(_, stands)| **stands);
        quantile(standing.flat_map(|(low, _)| *low).collect(), 0.5)
    }

    /// Median velocity of the lowest point of all where it is less than `height` (m) above its lowest and `borne` says of the
    /// frame that something is borne there; zero where it is slow, or little next to how the figure travels over it.
    pub(super) fn belt(
        &self,
        height: f64,
        borne: impl Fn(usize) -> bool,
        travel: &Vector3<f64>,
    ) -> Vector3<f64> {
        let up = &self.placed.prepared().up;
        let lowest =
            self.placed.frames().enumerate().filter(|(row, _)| borne(*row)).filter_map(|(_, feet)| {
                let standing = feet.iter().enumerate().filter(|(foot, _)| self.stands[*foot]);
                let points = standing.flat_map(|(foot, at)| {
                    [0, 1, 2].map(|i| (at.points[i].dot(up) - self.low[foot][i], at.velocities[i]))
                });
                points.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(above, _)| *above < height)
            });
        let level = |v: Vector3<f64>| v - up * v.dot(up);
        let velocities: Vec<Vector3<f64>> = lowest.map(|(_, velocity)| level(velocity)).collect();
        if velocities.is_empty() {
            return Vector3::zeros();
        }
        let median = [0, 1, 2].map(|k| quantile(velocities.iter().map(|v| v[k]).collect(), 0.5));
        let belt = level(Vector3::from(median));
        let least = Belt::LEAST.max(Belt::LEAST_OF_TRAVEL * level(travel - belt).norm());
        if belt.norm() < least { Vector3::zeros() } else { belt }
    }

    /// The same above what it stands on in the nearest of its stances.
    pub(super) fn foot_on(&self, foot: usize, belt: &Vector3<f64>, list: &[Stance]) -> FootTrack {
        let up = &self.placed.prepared().up;
        let own = list.iter().filter(|stance| stance.foot == foot);
        let own: Vec<_> = own.filter_map(|stance| Some((stance, self.placed.lies(stance, belt)?))).collect();
        let mut track = self.foot(foot, belt);
        // However high it stands.
        track.stands = !own.is_empty();
        for (row, above) in track.above.iter_mut().enumerate() {
            let time = self.placed.prepared().time()[row];
            let away = |stance: &Stance| (stance.start - time).max(time - stance.end).max(0.0);
            let next = own.partition_point(|(stance, _)| stance.start <= time);
            let near = own[next.saturating_sub(1)..(next + 1).min(own.len())].iter();
            let nearest = near.min_by(|a, b| away(a.0).total_cmp(&away(b.0)));
            if let Some((_, lying)) = nearest {
                // Below the tread that it comes to it is not on it either.
                *above = lying.raised(&self.placed.frame(row)[foot].points, up).map(f64::abs);
            }
        }
        track
    }

    /// How a foot moves on a ground that moves with the velocity `belt` (m/s).
    pub(super) fn foot(&self, foot: usize, belt: &Vector3<f64>) -> FootTrack {
        let up = &self.placed.prepared().up;
        let low = self.low[foot];
        let above =
            |feet: &[crate::ground::PlacedSole]| [0, 1, 2].map(|i| feet[foot].points[i].dot(up) - low[i]);
        let speed =
            |feet: &[crate::ground::PlacedSole]| [0, 1, 2].map(|i| (feet[foot].velocities[i] - belt).norm());
        FootTrack {
            above: self.placed.frames().map(above).collect(),
            speed: self.placed.frames().map(speed).collect(),
            stands: self.stands[foot],
        }
    }
}

impl FootTrack {
    /// What decides whether the foot is down in a frame, less than zero where it is:
    ///
    /// ```text
    /// min over the points of max((z − z_low)/height, |v − v_belt|/speed) − 1
    /// ```
    pub(super) fn decides(&self, row: usize, height: f64, speed: f64) -> f64 {
        let point = |i: usize| (self.above[row][i] / height).max(self.speed[row][i] / speed);
        [0, 1, 2].map(point).into_iter().fold(f64::INFINITY, f64::min) - 1.0
    }

    /// The speed (m/s) of the fastest point in a frame.
    pub(super) fn fastest(&self, row: usize) -> f64 {
        self.speed[row].into_iter().fold(0.0, f64::max)
    }

    /// The height (m) that the points of the foot are lifted to, but for the highest twentieth of the frames.
    pub(super) fn lift(&self) -> f64 {
        let of = |i: usize| quantile(self.above.iter().map(|above| above[i]).collect(), 1.0 - STRAY);
        [0, 1, 2].map(of).into_iter().fold(0.0, f64::max)
    }

    /// The speed (m/s) of the fastest point, but for the fastest twentieth of the frames.
    pub(super) fn pace(&self) -> f64 {
        quantile((0..self.speed.len()).map(|row| self.fastest(row)).collect(), 1.0 - STRAY)
    }
}

/// The value that this share of all lies below; the least of few.
pub(super) fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let index = (values.len().saturating_sub(1) as f64 * share).floor() as usize;
    values.get(index).copied().unwrap_or(0.0)
}
