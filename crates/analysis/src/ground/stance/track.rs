//! Tracks of the points of the soles, and the ground that they tell of.

use super::{Belt, StanceOptions};
use crate::ground::{PlacedFeet, PlacedSole};
use nalgebra::Vector3;

/// A foot whose lowest point never comes nearer to the lowest one of all feet than this (m) never stands.
const RAISED: f64 = 0.05;

/// Share of the frames that may lie below a point's lowest height.
const STRAY: f64 = 0.05;

/// Feet in all frames, and how low they come.
pub(super) struct Tracks<'a> {
    placed: &'a PlacedFeet<'a>,
    feet: Vec<Foot>,
}

struct Foot {
    /// Lowest height (m, along up) of heel, ball and tip.
    low: [f64; 3],
    /// Whether it ever comes down.
    stands: bool,
}

impl Foot {
    fn lowest(&self) -> f64 {
        self.low.into_iter().fold(f64::INFINITY, f64::min)
    }
}

impl<'a> Tracks<'a> {
    pub(super) fn of(placed: &'a PlacedFeet<'a>) -> Self {
        let up = placed.prepared().up;
        let low = |foot: usize, i: usize| {
            quantile(placed.frames().map(|feet| feet[foot].points[i].dot(&up)).collect(), STRAY)
        };
        let lows = (0..placed.soles().len()).map(|foot| [0, 1, 2].map(|i| low(foot, i)));
        let mut feet: Vec<Foot> = lows.map(|low| Foot { low, stands: true }).collect();
        let ground = feet.iter().map(Foot::lowest).fold(f64::INFINITY, f64::min);
        for foot in &mut feet {
            foot.stands = foot.lowest() <= ground + RAISED;
        }
        Self { placed, feet }
    }

    /// Of heel, ball and tip of a foot, how far above its own lowest height (m) each is, and its velocity (m/s).
    fn points(&self, foot: usize, at: &PlacedSole) -> [(f64, Vector3<f64>); 3] {
        let up = &self.placed.prepared().up;
        [0, 1, 2].map(|i| (at.points[i].dot(up) - self.feet[foot].low[i], at.velocities[i]))
    }

    /// Median of the lowest heights of all points of the feet that may stand.
    pub(super) fn level(&self) -> f64 {
        quantile(self.feet.iter().filter(|foot| foot.stands).flat_map(|foot| foot.low).collect(), 0.5)
    }

    /// Median velocity of the lowest point of all where it is down; zero where it is slow.
    pub(super) fn belt(&self, height: f64) -> Vector3<f64> {
        let up = &self.placed.prepared().up;
        let lowest = self.placed.frames().filter_map(|feet| {
            let standing = feet.iter().enumerate().filter(|(foot, _)| self.feet[*foot].stands);
            let points = standing.flat_map(|(foot, at)| self.points(foot, at));
            points.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(above, _)| *above < height)
        });
        let velocities: Vec<Vector3<f64>> =
            lowest.map(|(_, velocity)| velocity - up * velocity.dot(up)).collect();
        if velocities.is_empty() {
            return Vector3::zeros();
        }
        let median = [0, 1, 2].map(|k| quantile(velocities.iter().map(|v| v[k]).collect(), 0.5));
        let median = Vector3::from(median);
        let belt = median - up * median.dot(up);
        if belt.norm() < Belt::LEAST { Vector3::zeros() } else { belt }
    }

    /// What decides whether a foot is down, a number a frame, less than zero where it is:
    ///
    /// ```text
    /// min over the points of max((z − z_low)/height, |v − v_belt|/speed) − 1
    /// ```
    pub(super) fn decisive(&self, foot: usize, belt: &Vector3<f64>, options: &StanceOptions) -> Vec<f64> {
        let decide = |feet: &[PlacedSole]| {
            if !self.feet[foot].stands {
                return f64::INFINITY;
            }
            let points = self.points(foot, &feet[foot]).map(|(above, velocity)| {
                (above / options.height).max((velocity - belt).norm() / options.speed)
            });
            points.into_iter().fold(f64::INFINITY, f64::min) - 1.0
        };
        self.placed.frames().map(decide).collect()
    }
}

/// The value that this share of all lies below; the least of few.
fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let index = (values.len().saturating_sub(1) as f64 * share).floor() as usize;
    values.get(index).copied().unwrap_or(0.0)
}
