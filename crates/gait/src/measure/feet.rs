//! Slide, sink and clearance of the soles, and where they are pressed.

use super::series::Series;
use super::window::{mid_swing, samples_between};
use super::{Peak, touch_downs};
use crate::body::FEET;
use crate::body::REFERENCE_HEIGHT;
use nalgebra::Vector3;
use solaris_model::{EventKind, Figure, Motion, SolePart};

/// A point this near to the ground touches it (m): soles and heel pads are soft.
const TOUCHING: f64 = 5e-3;
/// Heels, balls and tips are round: the centre of pressure may be this far from the model's point (m, for a height of
/// 1.741 m), and this far to the side of the foot's axis.
const ROUND: f64 = 0.012;
const HALF_WIDTH: f64 = 0.040;

/// Points that a stretch of a sole is looked at.
const BETWEEN: u32 = 10;

/// Greatest distance of a planted point from where it was when it was planted (m).
pub(super) fn slide(motion: &Motion, series: &Series<'_>) -> Peak {
    let mut worst = Peak { value: 0.0, time: 0.0 };
    for planted in &motion.planted {
        let mut first = None;
        for i in samples_between(series.time, (planted.start, planted.end)) {
            let Some(at) = series.place(i, planted.link, &planted.point) else { continue };
            let from = *first.get_or_insert(at);
            worst = worst.max(Peak { value: (at - from).norm(), time: series.time[i] });
        }
    }
    worst
}

/// Greatest depth of a sole below the ground, and greatest distance of a loaded foot's centre of pressure outside the
/// part that touches it (m).
pub(super) fn sink_and_cop(figure: &Figure, motion: &Motion, series: &Series<'_>) -> (Peak, Peak) {
    let scale = figure.stature().map_or(1.0, |height| height / REFERENCE_HEIGHT);
    let mut sink = Peak::NONE;
    let mut outside = Peak { value: 0.0, time: 0.0 };
    for (side, name) in FEET.iter().enumerate() {
        let points = sole(figure, name);
        for (i, &time) in series.time.iter().enumerate() {
            let places: Vec<Vector3<f64>> =
                points.iter().filter_map(|(link, _, point)| series.place(i, *link, point)).collect();
            let over: Vec<f64> = places.iter().map(|p| height(motion, p)).collect();
            let lowest = over.iter().copied().fold(f64::INFINITY, f64::min);
            sink = sink.max(Peak { value: -lowest, time });
            if series.forces[side][i].y > 0.05 * series.weight {
                // Where the ground has edges the sole between its points touches it, too.
                let between = motion.relief.as_ref().map(|_| along_sole(&places));
                let places = between.as_ref().unwrap_or(&places);
                let over: Vec<f64> = places.iter().map(|p| height(motion, p)).collect();
                let value = outside_of(&series.cops[side][i], places, &over, scale);
                outside = outside.max(Peak { value, time });
            }
        }
    }
    (sink, outside)
}

/// Least height of the toes' tip in the middle of the swings (m).
pub(super) fn clearance(figure: &Figure, motion: &Motion, series: &Series<'_>) -> Peak {
    let mut least = Peak { value: f64::INFINITY, time: 0.0 };
    for (side, name) in FEET.iter().enumerate() {
        let points = sole(figure, name);
        let Some((link, _, tip)) = points.iter().find(|(_, part, _)| *part == SolePart::ToeTip) else {
            continue;
        };
        for (lift, contact) in swings(motion, side) {
            for i in mid_swing(series.time, (lift, contact)) {
                let Some(place) = series.place(i, *link, tip) else { continue };
                least = least.min(Peak { value: height(motion, &place), time: series.time[i] });
            }
        }
    }
    least
}

/// Points of a sole, and some between each and the next one.
fn along_sole(points: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let between = |pair: &[Vector3<f64>]| {
        let [from, to] = [pair[0], pair[1]];
        (0..BETWEEN).map(move |i| from.lerp(&to, f64::from(i) / f64::from(BETWEEN)))
    };
    points.windows(2).flat_map(between).chain(points.last().copied()).collect()
}

/// Height of a point over the ground (m); within a millimetre of a riser either side of it counts.
fn height(motion: &Motion, point: &Vector3<f64>) -> f64 {
    match &motion.relief {
        Some(relief) => point.y - relief.lowest_near(point.z, 1e-3),
        None => point.y - motion.info.ground.map_or(0.0, |ground| ground.height),
    }
}

/// The sole points of a foot and of its toes: link, part, position.
fn sole(figure: &Figure, foot: &str) -> Vec<(usize, SolePart, Vector3<f64>)> {
    let foot = figure.link_index(foot);
    let links = figure.links().iter().enumerate();
    links
        .filter(|(index, link)| foot.is_some() && (Some(*index) == foot || link.parent() == foot))
        .flat_map(|(index, link)| link.sole().iter().map(move |point| (index, point.part, point.position)))
        .collect()
}

/// Lift-off and next contact of one foot's swings.
fn swings(motion: &Motion, side: usize) -> Vec<(f64, f64)> {
    let contacts: Vec<f64> =
        touch_downs(motion).into_iter().filter(|(_, foot)| *foot == side).map(|(time, _)| time).collect();
    motion
        .events
        .iter()
        .filter(|event| matches!(&event.kind, EventKind::LiftOff { link } if link == FEET[side]))
        .filter_map(|event| {
            let next = contacts.get(contacts.partition_point(|time| *time <= event.time))?;
            Some((event.time, *next))
        })
        .collect()
}

/// How far a centre of pressure lies outside of the part of a foot that touches the ground.
///
/// `over` is how high each of its points is over the ground (m). Ways are horizontal.
fn outside_of(cop: &Vector3<f64>, points: &[Vector3<f64>], over: &[f64], scale: f64) -> f64 {
    let flat = |p: &Vector3<f64>| Vector3::new(p.x, 0.0, p.z);
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return 0.0 };
    let Some(axis) = (flat(last) - flat(first)).try_normalize(1e-9) else { return 0.0 };
    let along = |p: &Vector3<f64>| (p - flat(first)).dot(&axis);
    let touching =
        points.iter().zip(over).filter(|(_, over)| **over < TOUCHING).map(|(p, _)| along(&flat(p)));
    let (least, most) =
        touching.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
    if least > most {
        // A loaded foot in the air: how far its nearest point is from where it should press.
        return points.iter().map(|p| (p - cop).norm()).fold(f64::INFINITY, f64::min);
    }
    let x = along(&flat(cop));
    let side = (flat(cop) - flat(first) - axis * x).norm() - HALF_WIDTH * scale;
    (least - ROUND * scale - x).max(x - most - ROUND * scale).max(side).max(0.0)
}
