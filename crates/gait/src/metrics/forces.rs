//! The peaks of the ground's force on one foot in its stride, where gait laboratories look for them.

use super::stride::{Steps, Stride};
use super::tracks::Tracks;
use super::{Metric, MetricsInput, NoValue};
use crate::measure::peaks::Stance;
use crate::measure::window::Window;
use nalgebra::Vector3;
use solaris_model::ContactTrack;

/// The forces on the stride's foot, in % of body weight.
struct Pushed<'a> {
    stance: Stance<'a>,
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
            of(&|p| Ok(p.stance.first_peak(&p.along(p.up)))),
        ),
        row(
            "vertical_valley_percent_bw",
            "vertical force, valley",
            of(&|p| Ok(p.stance.valley(p.stride.double_support?, &p.along(p.up)))),
        ),
        row(
            "vertical_second_percent_bw",
            "vertical force, second peak",
            of(&|p| Ok(p.stance.second_peak(&p.along(p.up)))),
        ),
        row(
            "braking_percent_bw",
            "braking force",
            of(&|p| Ok(p.stance.braking(&p.along(p.stride.heading()?)))),
        ),
        row(
            "pushing_percent_bw",
            "pushing force",
            of(&|p| Ok(p.stance.pushing(&p.along(p.stride.heading()?)))),
        ),
    ]
}

fn pushed<'a>(given: &MetricsInput<'a>, tracks: &Tracks<'a>, steps: &Steps) -> Result<Pushed<'a>, NoValue> {
    if given.soles().is_empty() {
        return Err(NoValue::NoFeet);
    }
    let contacts = given.contacts.ok_or(NoValue::NoForces)?;
    let stride = steps.stride?;
    let track = contacts.get(stride.foot).ok_or(NoValue::NoForces)?;
    let window = Window { time: tracks.time, span: stride.span };
    let stance = Stance { window, toe_off: stride.toe_off };
    Ok(Pushed { stance, stride, track, up: tracks.up, percent: 100.0 / tracks.weight })
}

impl Pushed<'_> {
    /// The force along an axis, by sample.
    fn along(&self, axis: Vector3<f64>) -> impl Fn(usize) -> f64 {
        move |i| self.percent * self.track.samples[i].force.dot(&axis)
    }
}
