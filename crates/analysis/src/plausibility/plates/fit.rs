//! One force and the foot that it is given to.

use super::{AIRBORNE, AWAY, FAR, FAR_SHARE, PlateFit, SWAPPED, Scene};
use crate::ground::{PlacedFeet, SOLE_BREADTH, Stances};
use crate::plausibility::{FarCause, MotionFinding};
use nalgebra::{Vector2, Vector3};
use solaris_model::GroundAxes;

/// How near (m) to its foot a force that is shifted as a whole comes, on average, when it is shifted back.
const STEADY: f64 = 0.03;

/// One frame of so many may show a foot lower than it stands.
const STRAY: usize = 20;

/// A force, held against all feet.
pub(super) struct Placed {
    force: usize,
    sole: Option<usize>,
    /// The frames in which it bears.
    rows: Vec<usize>,
    /// By such a frame, the centre of pressure as seen from above (m).
    points: Vec<Vector2<f64>>,
    /// By sole, by such a frame: the way on the ground from the nearest point of the sole to the centre of pressure (m), zero inside.
    ways: Vec<Vec<Vector2<f64>>>,
    /// The first time (s) at which its foot swings away from it, and the share that it bears then.
    airborne: Option<(f64, f64)>,
    ground: GroundAxes,
}

impl Placed {
    pub(super) fn of(scene: &Scene<'_>, feet: &PlacedFeet<'_>, stances: &Stances, force: usize) -> Self {
        let sole = scene.soles[force];
        let bears = |row: &usize| scene.normal(force, *row).is_some_and(|normal| normal > scene.loaded());
        let rows: Vec<usize> = scene.frames().filter(bears).collect();
        let ground = GroundAxes::new(&scene.prepared.up);
        let point =
            |row: &usize| scene.pressure(force, *row).map(|point| ground.flat(&point)).unwrap_or_default();
        let points: Vec<Vector2<f64>> = rows.iter().map(point).collect();
        let ways = (0..feet.soles().len()).map(|sole| {
            let way = |(row, point): (&usize, &Vector2<f64>)| beside(feet, &ground, (*row, sole), point);
            rows.iter().zip(&points).map(way).collect()
        });
        let ways = ways.collect();
        let mut placed = Self { force, sole, rows, points, ways, airborne: None, ground };
        placed.airborne = sole.and_then(|sole| placed.swings(scene, feet, stances, sole));
        placed
    }

    /// The first time (s) at which its foot swings away from it, and the share that it bears then.
    ///
    /// That no stance was found there is not enough: feet that strike and leave fast, or turn on their toes, are found late and lost
    /// early, with the force still under them. Such a foot is low and at its force, one that swings is neither for long.
    fn swings(
        &self,
        scene: &Scene<'_>,
        feet: &PlacedFeet<'_>,
        stances: &Stances,
        sole: usize,
    ) -> Option<(f64, f64)> {
        // What never stands is a hand or a seat, or its sole is not where it should be.
        stances.list.iter().find(|stance| stance.foot == sole)?;
        let time = scene.prepared.time();
        let height = |row: usize| {
            let points = feet.frame(row)[sole].points.map(|point| point.dot(&scene.prepared.up));
            points.into_iter().fold(f64::INFINITY, f64::min)
        };
        let mut heights: Vec<f64> = scene.frames().map(height).collect();
        heights.sort_by(f64::total_cmp);
        let down = heights[heights.len() / STRAY];
        let pairs = self.rows.iter().zip(&self.ways[sole]);
        let away = pairs.filter(|(row, way)| {
            let is_away = way.norm() > AWAY || height(**row) - down > AWAY;
            is_away && !stances.stands(sole, time[**row])
        });
        let away: Vec<usize> = away.map(|(row, _)| *row).collect();
        // Weighed by the force: where it comes and goes, it is small and its place is little known.
        let borne =
            |rows: &[usize]| rows.iter().filter_map(|row| scene.normal(self.force, *row)).sum::<f64>();
        Some((time[*away.first()?], borne(&away) / borne(&self.rows)))
    }

    /// Distances from a sole (m), by loaded frame.
    fn distances(&self, sole: usize) -> impl Iterator<Item = f64> {
        self.ways[sole].iter().map(Vector2::norm)
    }

    fn mean(&self, sole: usize) -> f64 {
        self.distances(sole).sum::<f64>() / self.rows.len().max(1) as f64
    }

    fn greatest(&self, scene: &Scene<'_>, sole: usize) -> Option<(f64, f64)> {
        let times = self.rows.iter().map(|row| scene.prepared.time()[*row]);
        self.distances(sole).zip(times).max_by(|a, b| a.0.total_cmp(&b.0))
    }

    pub(super) fn fit(&self, scene: &Scene<'_>, feet: &PlacedFeet<'_>) -> PlateFit {
        let sole = self.sole.filter(|_| !self.rows.is_empty());
        PlateFit {
            foot: self.name(scene, feet),
            loaded: self.rows.len(),
            mean_distance: sole.map(|sole| self.mean(sole)),
            greatest_distance: sole.and_then(|sole| self.greatest(scene, sole)),
        }
    }

    fn name(&self, scene: &Scene<'_>, feet: &PlacedFeet<'_>) -> String {
        self.sole.map_or_else(
            || scene.measured[self.force].links[0].clone(),
            |sole| feet.soles()[sole].name.clone(),
        )
    }

    /// The one way by which all centres of pressure are off, where there is one.
    fn shift(&self, feet: &PlacedFeet<'_>, sole: usize) -> Option<Vector3<f64>> {
        let count = self.rows.len() as f64;
        let mut by = Vector2::zeros();
        let mut left = f64::INFINITY;
        // A sole is long: what lies along it shows only after some of it is taken back.
        for _ in 0..8 {
            let pairs = self.rows.iter().zip(&self.points);
            let ways = pairs.map(|(row, point)| beside(feet, &self.ground, (*row, sole), &(point - by)));
            let (sum, size) =
                ways.fold((Vector2::zeros(), 0.0), |(sum, size), way| (sum + way, size + way.norm()));
            left = size / count;
            if left < STEADY {
                break;
            }
            by += sum / count;
        }
        (left < STEADY && by.norm() > FAR).then(|| self.ground.raise(&by, 0.0))
    }
}

/// What does not fit of force `i` of all.
pub(super) fn findings(
    scene: &Scene<'_>,
    feet: &PlacedFeet<'_>,
    all: &[Placed],
    i: usize,
) -> Vec<MotionFinding> {
    let one = &all[i];
    let Some(sole) = one.sole.filter(|_| !one.rows.is_empty()) else { return Vec::new() };
    let share = one.distances(sole).filter(|distance| *distance > FAR).count() as f64 / one.rows.len() as f64;
    let airborne = one.airborne.filter(|(_, share)| *share > AIRBORNE);
    let foot = one.name(scene, feet);
    let cause = || {
        let swapped = all.iter().find(|other| {
            let Some(theirs) = other.sole.filter(|theirs| *theirs != sole && !other.rows.is_empty()) else {
                return false;
            };
            let own = one.mean(sole) + other.mean(theirs);
            let crossed = one.mean(theirs) + other.mean(sole);
            one.mean(sole) > one.mean(theirs) && crossed < SWAPPED * own
        });
        match (swapped, airborne, one.shift(feet, sole)) {
            (Some(other), _, _) => FarCause::Swapped { with: other.name(scene, feet) },
            (None, Some(_), _) => FarCause::OtherTrial,
            (None, None, Some(by)) => FarCause::Shifted { by: by.into() },
            (None, None, None) => FarCause::Unknown,
        }
    };
    let mut found = Vec::new();
    if let Some((distance, time)) = one.greatest(scene, sole).filter(|_| share > FAR_SHARE) {
        found.push(MotionFinding::Far { foot, distance, time, share, cause: cause() });
    } else if let Some((time, share)) = airborne {
        // Where the force is far as well, it is one fault.
        found.push(MotionFinding::Airborne { foot, share, time, cause: cause() });
    }
    found
}

/// The way (m, on the ground) from the nearest point of a sole in a frame to a point, less half the sole's breadth; zero inside.
fn beside(
    feet: &PlacedFeet<'_>,
    ground: &GroundAxes,
    (row, foot): (usize, usize),
    point: &Vector2<f64>,
) -> Vector2<f64> {
    let placed = feet.frame(row)[foot].points.map(|point| ground.flat(&point));
    let length = (placed[1] - placed[0]).norm() + (placed[2] - placed[1]).norm();
    let half = 0.5 * feet.soles()[foot].width.unwrap_or(SOLE_BREADTH * length);
    let mut nearest = point - placed[0];
    for pair in placed.windows(2) {
        let (along, to) = (pair[1] - pair[0], point - pair[0]);
        let length = along.norm_squared();
        let part = if length > 0.0 { (to.dot(&along) / length).clamp(0.0, 1.0) } else { 0.0 };
        let way = to - along * part;
        if way.norm() < nearest.norm() {
            nearest = way;
        }
    }
    let size = nearest.norm();
    if size <= half { Vector2::zeros() } else { nearest * ((size - half) / size) }
}
