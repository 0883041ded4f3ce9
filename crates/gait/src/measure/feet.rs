//! Slide, sink and clearance of the soles, and where they are pressed.

use super::series::Series;
use super::{Peak, touch_downs};
use crate::body::REFERENCE_HEIGHT;
use crate::walk::FEET;
use nalgebra::Vector3;
use solaris_model::{EventKind, Figure, Motion, SolePart};

/// A point this near to the ground touches it (m): soles and heel pads are soft.
const TOUCHING: f64 = 5e-3;
/// Heels, balls and tips are round: the centre of pressure may be this far from the model's point (m, for a height of
/// 1.741 m), and this far to the side of the foot's axis.
const ROUND: f64 = 0.012;
const HALF_WIDTH: f64 = 0.040;

/// Middle of a swing: the part in which the toes must pass over the ground.
const MID_SWING: (f64, f64) = (0.20, 0.65);

/// What the feet do.
pub(super) struct FeetMeasures {
    pub(super) slide: Peak,
    pub(super) sink: Peak,
    pub(super) clearance: Peak,
    pub(super) cop_outside: Peak,
}

impl FeetMeasures {
    pub(super) fn new(figure: &Figure, motion: &Motion, series: &Series<'_>) -> Self {
        let ground = motion.info.ground.map_or(0.0, |ground| ground.height);
        let place = |sample: usize, link: usize, point: &Vector3<f64>| {
            let pose = &series.poses[sample][link];
            pose.rotation * point + pose.translation
        };
        let nothing = Peak { value: 0.0, time: 0.0 };
        let mut measures = Self {
            slide: nothing,
            sink: nothing,
            clearance: Peak { value: f64::INFINITY, time: 0.0 },
            cop_outside: nothing,
        };
        for planted in &motion.planted {
            let inside = |&i: &usize| (planted.start..=planted.end).contains(&series.time[i]);
            let samples = (0..motion.len()).filter(inside);
            let mut first = None;
            for i in samples {
                let at = place(i, planted.link, &planted.point);
                let from = *first.get_or_insert(at);
                measures.slide = measures.slide.max(Peak { value: (at - from).norm(), time: series.time[i] });
            }
        }
        let scale = figure.stature().map_or(1.0, |height| height / REFERENCE_HEIGHT);
        for (side, name) in FEET.iter().enumerate() {
            let Some(foot) = figure.link_index(name) else { continue };
            let points: Vec<(usize, SolePart, Vector3<f64>)> = figure
                .links()
                .iter()
                .enumerate()
                .filter(|(index, link)| *index == foot || link.parent() == Some(foot))
                .flat_map(|(index, link)| {
                    link.sole().iter().map(move |point| (index, point.part, point.position))
                })
                .collect();
            for i in 0..motion.len() {
                let time = series.time[i];
                let places: Vec<Vector3<f64>> =
                    points.iter().map(|(link, _, point)| place(i, *link, point)).collect();
                let lowest = places.iter().map(|p| p.y - ground).fold(f64::INFINITY, f64::min);
                measures.sink = measures.sink.max(Peak { value: -lowest, time });
                if series.forces[side][i].y > 0.05 * series.weight {
                    let outside = outside(&series.cops[side][i], &places, ground, scale);
                    measures.cop_outside = measures.cop_outside.max(Peak { value: outside, time });
                }
            }
            let tip = points.iter().find(|(_, part, _)| *part == SolePart::ToeTip);
            if let Some((link, _, point)) = tip {
                for (from, to) in swings(motion, side) {
                    let (from, to) = (from + MID_SWING.0 * (to - from), from + MID_SWING.1 * (to - from));
                    for i in (0..motion.len()).filter(|&i| (from..=to).contains(&series.time[i])) {
                        let height = place(i, *link, point).y - ground;
                        if height < measures.clearance.value {
                            measures.clearance = Peak { value: height, time: series.time[i] };
                        }
                    }
                }
            }
        }
        measures
    }
}

/// Lift-off and next contact of one foot's swings.
fn swings(motion: &Motion, side: usize) -> Vec<(f64, f64)> {
    let contacts = touch_downs(motion);
    motion
        .events
        .iter()
        .filter(|event| matches!(&event.kind, EventKind::LiftOff { link } if link == FEET[side]))
        .filter_map(|event| {
            let next = contacts.iter().find(|(time, foot)| *foot == side && *time > event.time)?;
            Some((event.time, next.0))
        })
        .collect()
}

/// How far a centre of pressure lies outside of the part of a foot that touches the ground.
fn outside(cop: &Vector3<f64>, points: &[Vector3<f64>], ground: f64, scale: f64) -> f64 {
    let flat = |p: &Vector3<f64>| Vector3::new(p.x, ground, p.z);
    let touching: Vec<Vector3<f64>> = points.iter().filter(|p| p.y - ground < TOUCHING).map(flat).collect();
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return 0.0 };
    let Some(axis) = (flat(last) - flat(first)).try_normalize(1e-9) else { return 0.0 };
    let along = |p: &Vector3<f64>| (p - first).dot(&axis);
    let (least, most) = touching
        .iter()
        .map(along)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
    if least > most {
        return f64::INFINITY;
    }
    let x = along(cop);
    let side = (flat(cop) - flat(first) - axis * x).norm() - HALF_WIDTH * scale;
    (least - ROUND * scale - x).max(x - most - ROUND * scale).max(side).max(0.0)
}
