//! Which foot stands on which force plate, and when.

use crate::ground::PlacedFeet;
use nalgebra::Vector3;
use solaris_model::{Contact, MeasuredForce};

/// Loads nearer in time than this (s) are one.
const BREAK: f64 = 0.05;
/// Loads shorter than this (s) are noise.
const SHORTEST: f64 = 0.05;
/// How far (m) the centre of pressure may be from the line between a foot's heel and tip, on the whole: half a sole's breadth, what a
/// sole is long beyond its points, and what cameras and plates differ by.
const NEAR: f64 = 0.12;

/// What a force plate recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct PlateRecord {
    /// What it is called.
    pub name: String,
    /// When (s), rising.
    pub time: Vec<f64>,
    /// What acted on whoever stood there, one a time: world axes, moment about the world's origin; no force where nobody did.
    pub samples: Vec<Contact>,
}

/// A time in which something stood on a plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateLoad {
    /// The plate.
    pub plate: usize,
    /// From when to when (s).
    pub span: (f64, f64),
    /// Mean force (N).
    pub force: f64,
    /// The foot that stood there: an index of the soles; `None` where none was near.
    pub foot: Option<usize>,
    /// How far the centre of pressure was from the nearest foot, on the mean (m).
    pub distance: f64,
}

/// Finds the foot for each time that a plate was loaded: the one whose line from heel to tip the centre of pressure is nearest to,
/// weighted by the force, if it is near at all. Returns the forces by foot (on the link of its heel), and all loads.
///
/// Times of a load that the motion does not cover decide nothing; a load that it does not cover at all has no foot.
#[doc(alias = "ExternalLoads")]
pub fn feet_on_plates(feet: &PlacedFeet, plates: &[PlateRecord]) -> (Vec<MeasuredForce>, Vec<PlateLoad>) {
    let (mut forces, mut loads) = (Vec::new(), Vec::new());
    let prepared = feet.prepared();
    let links = prepared.figure().links();
    for (plate, record) in plates.iter().enumerate() {
        let mut by_foot: Vec<Option<MeasuredForce>> = vec![None; feet.soles().len()];
        for span in spans(record, prepared.up()) {
            let found = nearest(feet, record, &span);
            let foot = found.filter(|(_, distance)| *distance <= NEAR).map(|(foot, _)| foot);
            let samples = &record.samples[span.clone()];
            loads.push(PlateLoad {
                plate,
                span: (record.time[span.start], record.time[span.end - 1]),
                force: samples.iter().map(|sample| sample.force.norm()).sum::<f64>() / span.len() as f64,
                foot,
                distance: found.map_or(f64::INFINITY, |(_, distance)| distance),
            });
            let Some(foot) = foot else { continue };
            let own = by_foot[foot].get_or_insert_with(|| MeasuredForce {
                links: vec![links[feet.soles()[foot].foot].name().to_owned()],
                ball_and_tip: None,
                time: record.time.clone(),
                samples: vec![Contact::default(); record.time.len()],
            });
            own.samples[span].copy_from_slice(samples);
        }
        forces.extend(by_foot.into_iter().flatten());
    }
    (forces, loads)
}

/// The samples of each time that a plate is loaded; one that pulls down is not, but has not been set to zero.
fn spans(record: &PlateRecord, up: Option<Vector3<f64>>) -> Vec<std::ops::Range<usize>> {
    let mut spans: Vec<std::ops::Range<usize>> = Vec::new();
    let is_load = |force: &Vector3<f64>| match up {
        Some(up) => force.dot(&up) > 0.0,
        None => *force != Vector3::zeros(),
    };
    let loaded = (0..record.time.len()).filter(|i| is_load(&record.samples[*i].force));
    for i in loaded {
        match spans.last_mut() {
            Some(last) if record.time[i] - record.time[last.end - 1] <= BREAK => last.end = i + 1,
            _ => spans.push(i..i + 1),
        }
    }
    spans.retain(|span| record.time[span.end - 1] - record.time[span.start] >= SHORTEST);
    spans
}

/// The foot nearest to the centre of pressure over a load, and its mean distance (m).
fn nearest(feet: &PlacedFeet, record: &PlateRecord, span: &std::ops::Range<usize>) -> Option<(usize, f64)> {
    let prepared = feet.prepared();
    let up = prepared.up()?;
    let level = |way: Vector3<f64>| way - up * way.dot(&up);
    let (start, end) = (record.time[span.start], record.time[span.end - 1]);
    let mut sums = vec![0.0; feet.soles().len()];
    let mut weights = 0.0;
    let within = prepared.motion().time().iter().enumerate().filter(|(_, t)| (start..=end).contains(*t));
    for (row, time) in within {
        let at = record.time.partition_point(|t| t < time).min(record.time.len() - 1);
        let sample = &record.samples[at];
        let weight = sample.force.norm();
        weights += weight;
        for (sum, foot) in sums.iter_mut().zip(feet.frame(row)) {
            let [heel, _, tip] = foot.points.map(level);
            *sum += weight * from_line(&level(sample.cop), &heel, &tip);
        }
    }
    if weights <= 0.0 {
        return None;
    }
    let nearest = sums.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
    Some((nearest.0, nearest.1 / weights))
}

/// The distance of a point from the line between two others.
fn from_line(point: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let way = to - from;
    let along = (point - from).dot(&way) / way.norm_squared().max(1e-12);
    (point - from - way * along.clamp(0.0, 1.0)).norm()
}
