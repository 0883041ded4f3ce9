//! The axes of a laboratory, found by its plates, by the names of the markers and by where they go.

use super::axes::{Axes, Way};
use super::plates::{LoadOptions, Plate};
use super::recording::Recording;
use solaris_model::{Finding, FindingKind, MarkerTrial, Vector3};

/// A subject that goes farther than this (m) in the trial walks or runs.
const WALKS: f64 = 0.5;
/// Part of names of markers at the head and the shoulders, and of others at the feet; in small letters.
const HIGH: [&str; 11] = ["head", "hd", "c7", "clav", "ster", "strn", "acr", "sho", "sjn", "neck", "nose"];
/// Of the pelvis, for sets of markers of the legs alone.
const PELVIS: [&str; 3] = ["asi", "psi", "pelv"];
const LOW: [&str; 12] =
    ["heel", "hee", "cal", "toe", "mt1", "mt2", "mt5", "mmal", "lmal", "ank", "foot", "midfoot"];
const HEEL: [&str; 4] = ["heel", "hee", "cal", "hind"];
const TOE: [&str; 7] = ["toe", "mt1", "mt2", "mt5", "mtp", "hallux", "met"];

/// Which way is up and which way the subject goes, with a finding each that says by what.
///
/// Up is where head and shoulders are from the feet, by their markers' names, or where the pelvis is; without such names the way across the loaded plates on which
/// the markers are; without plates the axis along which the markers stay on one side of the floor at zero and reach farthest. Forward is
/// the axis along which the middle of the markers goes; of who stays within half a metre the one from heel to toe; without such
/// names the first horizontal one. Ways are along the laboratory's axes: who walks aslant goes along the nearest one.
pub fn find_axes(recording: &Recording) -> (Axes, Vec<Finding>) {
    let trial = &recording.markers;
    let (up, by_up, kind_up) = up(recording);
    let (forward, by_forward, kind_forward) = forward(trial, up);
    let axes = Axes::new(up, forward).unwrap_or(Axes::OPENSIM);
    let finding = |kind, message| Finding { kind, subject: "axes".to_owned(), message, place: None };
    let findings = vec![
        finding(kind_up, format!("{up} is up, {by_up}")),
        finding(kind_forward, format!("{forward} is forward, {by_forward}")),
    ];
    (axes, findings)
}

fn up(recording: &Recording) -> (Way, String, FindingKind) {
    let trial = &recording.markers;
    for (high, who) in [(&HIGH[..], "head and shoulders are"), (&PELVIS[..], "the pelvis is")] {
        if let Some(way) = between(trial, &LOW, high) {
            return (Way::nearest(&way), format!("as {who} above the feet along it"), FindingKind::Note);
        }
    }
    let force: Vector3<f64> =
        recording.plates.iter().map(|plate| plate.mean_force(&LoadOptions::default()).0).sum();
    if force.norm() > 1.0 {
        // Some files hold what the subject does to the plate; who stands on one is above it.
        let mut way = Way::nearest(&force);
        if height(recording, way) < 0.0 {
            way = way.back();
        }
        return (
            way,
            "as it lies across the plates, with the markers above them".to_owned(),
            FindingKind::Note,
        );
    }
    let (mut low, mut high) = (Vector3::repeat(f64::MAX), Vector3::repeat(f64::MIN));
    for point in all(trial) {
        (low, high) = (low.inf(&point), high.sup(&point));
    }
    // A floor at zero: what is seen of a subject stays on one side of it, near it and far from it.
    let reach = |axis: usize| {
        let (near, far) =
            if high[axis] >= -low[axis] { (low[axis], high[axis]) } else { (-high[axis], -low[axis]) };
        if near > -0.1 && near < 0.3 { far } else { 0.0 }
    };
    let axis = (0..3).max_by(|a, b| reach(*a).total_cmp(&reach(*b))).filter(|axis| reach(*axis) > 0.0);
    match axis {
        Some(axis) => {
            let way = Way::along(axis);
            let way = if high[axis] >= -low[axis] { way } else { way.back() };
            (
                way,
                "as all markers are on that side of a floor at zero: name it if that is wrong".to_owned(),
                FindingKind::Suspect,
            )
        }
        None => (Way::along(2), "which is a guess: name it".to_owned(), FindingKind::Suspect),
    }
}

/// How far the middle of all markers is from that of the plates along a way (m).
fn height(recording: &Recording, way: Way) -> f64 {
    let (mut sum, mut count) = (Vector3::zeros(), 0.0);
    for point in all(&recording.markers) {
        sum += point;
        count += 1.0;
    }
    let plates =
        recording.plates.iter().map(Plate::middle).sum::<Vector3<f64>>() / recording.plates.len() as f64;
    if count > 0.0 { (sum / count - plates).dot(&way.vector()) } else { 0.0 }
}

fn forward(trial: &MarkerTrial, up: Way) -> (Way, String, FindingKind) {
    let flat = |mut way: Vector3<f64>| {
        way[up.axis()] = 0.0;
        way
    };
    let way = flat(travel(trial));
    if way.norm() > WALKS {
        return (
            Way::nearest(&way),
            format!("as the markers' middle goes {:.2} m that way", way.amax()),
            FindingKind::Note,
        );
    }
    if let Some(way) = between(trial, &HEEL, &TOE).map(flat).filter(|way| way.norm() > 0.02) {
        return (Way::nearest(&way), "as the feet point from heel to toe".to_owned(), FindingKind::Note);
    }
    let way = Way::along(usize::from(up.axis() == 0));
    (way, "which is a guess, as nobody goes anywhere: name it if it matters".to_owned(), FindingKind::Suspect)
}

/// The mean way (m) from markers with one of `from` in their names to those with one of `to`, over frames that show both.
fn between(trial: &MarkerTrial, from: &[&str], to: &[&str]) -> Option<Vector3<f64>> {
    let with = |parts: &[&str]| -> Vec<usize> {
        let has = |name: &String| {
            // The sacrum is no acromion.
            let name = name.to_lowercase().replace("sacr", "");
            parts.iter().any(|part| name.contains(part))
        };
        (0..trial.names().len()).filter(|marker| has(&trial.names()[*marker])).collect()
    };
    let (from, to) = (with(from), with(to));
    let middle = |markers: &[usize], frame: usize| {
        let seen: Vec<_> = markers.iter().filter_map(|marker| trial.point(frame, *marker)).collect();
        (!seen.is_empty()).then(|| seen.iter().sum::<Vector3<f64>>() / seen.len() as f64)
    };
    let ways: Vec<_> =
        (0..trial.len()).filter_map(|frame| Some(middle(&to, frame)? - middle(&from, frame)?)).collect();
    (!ways.is_empty()).then(|| ways.iter().sum::<Vector3<f64>>() / ways.len() as f64)
}

/// How far the markers go (m): the steps of each pair of frames, averaged over the markers that both show, summed.
fn travel(trial: &MarkerTrial) -> Vector3<f64> {
    let mut way = Vector3::zeros();
    for frame in 1..trial.len() {
        let (mut step, mut count) = (Vector3::zeros(), 0.0);
        for marker in 0..trial.names().len() {
            if let (Some(before), Some(after)) = (trial.point(frame - 1, marker), trial.point(frame, marker))
            {
                step += after - before;
                count += 1.0;
            }
        }
        if count > 0.0 {
            way += step / count;
        }
    }
    way
}

fn all(trial: &MarkerTrial) -> impl Iterator<Item = Vector3<f64>> + '_ {
    (0..trial.len()).flat_map(|frame| trial.frame(frame)).filter(|point| !point.x.is_nan()).copied()
}
