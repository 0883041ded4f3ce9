//! Tracks of the points of the soles, and the ground that they tell of.

use super::{Belt, StanceOptions};
use crate::ground::{GroundError, Sole};
use crate::prepared::PreparedMotion;
use nalgebra::Vector3;
use solaris_dynamics::velocities;

/// A foot whose lowest point never comes nearer to the lowest one of all feet than this (m) never stands.
const RAISED: f64 = 0.05;

/// Share of the frames that may lie below a point's lowest height.
const STRAY: f64 = 0.05;

/// A point of a sole at one time: height along up (m) and velocity (m/s).
#[derive(Clone, Copy)]
struct Point {
    height: f64,
    velocity: Vector3<f64>,
}

/// All points at all times.
pub(super) struct Tracks {
    up: Vector3<f64>,
    /// By frame, by foot: heel, ball, tip.
    frames: Vec<Vec<[Point; 3]>>,
    /// By foot.
    feet: Vec<Foot>,
}

struct Foot {
    /// Lowest height of each point.
    low: [f64; 3],
    /// Whether it ever comes down.
    stands: bool,
}

impl Foot {
    fn lowest(&self) -> f64 {
        self.low.into_iter().fold(f64::INFINITY, f64::min)
    }
}

impl Tracks {
    pub(super) fn of(prepared: &PreparedMotion<'_>, soles: &[Sole]) -> Result<Self, GroundError> {
        let up = prepared.up;
        let frames = prepared.frames(|workspace, row| {
            velocities(&prepared.tree, workspace, prepared.q(row), prepared.v(row))?;
            let foot = |sole: &Sole| {
                let (points, velocities) = (sole.points(workspace), sole.velocities(workspace));
                [0, 1, 2].map(|i| Point { height: points[i].dot(&up), velocity: velocities[i] })
            };
            Ok(soles.iter().map(foot).collect::<Vec<_>>())
        })?;
        let low = |foot: usize, i: usize| {
            let heights: Vec<f64> =
                frames.iter().map(|feet: &Vec<[Point; 3]>| feet[foot][i].height).collect();
            quantile(heights, STRAY)
        };
        let lows = (0..soles.len()).map(|foot| [0, 1, 2].map(|i| low(foot, i)));
        let mut feet: Vec<Foot> = lows.map(|low| Foot { low, stands: true }).collect();
        let ground = feet.iter().map(Foot::lowest).fold(f64::INFINITY, f64::min);
        for foot in &mut feet {
            foot.stands = foot.lowest() <= ground + RAISED;
        }
        Ok(Self { up, frames, feet })
    }

    /// Median of the lowest heights of all points of the feet that may stand.
    pub(super) fn level(&self) -> f64 {
        quantile(self.feet.iter().filter(|foot| foot.stands).flat_map(|foot| foot.low).collect(), 0.5)
    }

    /// Median velocity of the lowest point of all where it is down; zero where it is slow.
    pub(super) fn belt(&self, height: f64) -> Vector3<f64> {
        let lowest = self.frames.iter().filter_map(|feet| {
            let points =
                feet.iter().zip(&self.feet).filter(|(_, foot)| foot.stands).flat_map(|(points, foot)| {
                    points.iter().zip(&foot.low).map(|(point, low)| (point.height - low, point.velocity))
                });
            points.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(above, _)| *above < height)
        });
        let velocities: Vec<Vector3<f64>> =
            lowest.map(|(_, velocity)| velocity - self.up * velocity.dot(&self.up)).collect();
        if velocities.is_empty() {
            return Vector3::zeros();
        }
        let median = [0, 1, 2].map(|k| quantile(velocities.iter().map(|v| v[k]).collect(), 0.5));
        let median = Vector3::from(median);
        let belt = median - self.up * median.dot(&self.up);
        if belt.norm() < Belt::LEAST { Vector3::zeros() } else { belt }
    }

    /// What decides whether a foot is down, a number a frame, less than zero where it is:
    ///
    /// ```text
    /// min over the points of max((z − z_low)/height, |v − v_belt|/speed) − 1
    /// ```
    pub(super) fn decisive(&self, foot: usize, belt: &Vector3<f64>, options: &StanceOptions) -> Vec<f64> {
        let Foot { low, stands } = &self.feet[foot];
        if !stands {
            return vec![f64::INFINITY; self.frames.len()];
        }
        let decide = |feet: &Vec<[Point; 3]>| {
            let points = feet[foot].iter().zip(low).map(|(point, low)| {
                let (above, fast) = (point.height - low, (point.velocity - belt).norm());
                (above / options.height).max(fast / options.speed)
            });
            points.fold(f64::INFINITY, f64::min) - 1.0
        };
        self.frames.iter().map(decide).collect()
    }
}

/// The value that this share of all lies below; the least of few.
fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let index = (values.len().saturating_sub(1) as f64 * share).floor() as usize;
    values.get(index).copied().unwrap_or(0.0)
}
