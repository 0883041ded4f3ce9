//! The peaks of the ground's force on one foot in its stride, where gait laboratories look for them.

use super::stride::{Steps, Stride};
use super::tracks::Tracks;
use super::{Metric, MetricsInput, NoValue};
use crate::measure::steady::{FIRST_PEAK, SECOND_PEAK_FROM, VALLEY_AFTER, VALLEY_TO};
use crate::measure::window::Window;
use nalgebra::Vector3;
use solaris_model::ContactTrack;

/// The forces on the stride's foot, in % of body weight.
struct Pushed<'a> {
    window: Window<'a>,
    stride: Stride,
    track: &'a ContactTrack,
    up: Vector3<f64>,
    percent: f64,
}

pub(super) fn metrics(given: &MetricsInput<'_>, tracks: &Tracks<'_>, steps: &Steps) -> Vec<Metric> {
    let pushed = pushed(given, tracks, steps);
    let of = |value: &dyn Fn(&Pushed<'_>) -> Result<f64, NoValue>| match &pushed {
        Ok(pushed) => value(pushed),
        Err(why) => Err(*why),
    };
    let row = |key, name, value| Metric::new((key, name, "%BW"), value, None);
    vec![
        row(
            "vertical_first_percent_bw",
            "vertical force, first peak",
            of(&|p| Ok(p.most(FIRST_PEAK, &p.up))),
        ),
        row(
            "vertical_valley_percent_bw",
            "vertical force, valley",
            of(&|p| {
                let from = p.stride.double_support? + VALLEY_AFTER;
                Ok(-p.most((from, VALLEY_TO), &-p.up))
            }),
        ),
        row(
            "vertical_second_percent_bw",
            "vertical force, second peak",
            of(&|p| Ok(p.most((SECOND_PEAK_FROM, p.stride.toe_off), &p.up))),
        ),
        row(
            "braking_percent_bw",
            "braking force",
            of(&|p| Ok(-p.most((0.0, p.stride.toe_off), &-p.stride.heading()?))),
        ),
        row(
            "pushing_percent_bw",
            "pushing force",
            of(&|p| Ok(p.most((0.0, p.stride.toe_off), &p.stride.heading()?))),
        ),
    ]
}

fn pushed<'a>(given: &MetricsInput<'a>, tracks: &Tracks<'a>, steps: &Steps) -> Result<Pushed<'a>, NoValue> {
    if given.soles.is_empty() {
        return Err(NoValue::NoFeet);
    }
    let contacts = given.contacts.ok_or(NoValue::NoForces)?;
    let stride = steps.stride?;
    let track = contacts.get(stride.foot).ok_or(NoValue::NoForces)?;
    let window = Window { time: tracks.time, span: stride.span };
    Ok(Pushed { window, stride, track, up: tracks.up, percent: 100.0 / tracks.weight })
}

impl Pushed<'_> {
    /// The greatest force along an axis in a part of the stride.
    fn most(&self, part: (f64, f64), axis: &Vector3<f64>) -> f64 {
        self.window.most(part, &|i| self.percent * self.track.samples[i].force.dot(axis))
    }
}
