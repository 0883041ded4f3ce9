//! Measures of standing up and sitting down: numbers of a finished motion, found from the motion alone.

use super::joints::JointSeries;
use super::series::{Series, angle};
use super::{JointPeaks, Peak, WalkExtremes};
use crate::body::roles::{SEATED, SIDED_ANGLES};
use crate::error::{GaitError, MeasureError};
use solaris_model::{Contact, EventKind, Figure, Motion};

/// Least part of the weight at which friction is looked at.
const LOADED: f64 = 0.05;

/// The numbers of standing up from a seat or sitting down.
///
/// With the feature `serde` its keys are `duration_s`, `left_s`, `met_s`, `lifted_m`, `seat_percent_bw`, `feet_percent_bw`, `along_m_s`, `vertical_m_s`,
/// `contact_friction`, `angles`, `joints` and those of [`WalkExtremes`].
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ChairMeasures {
    /// How long it lasts (s).
    #[cfg_attr(feature = "serde", serde(rename = "duration_s"))]
    pub duration: f64,
    /// When the seat is left (s).
    #[doc(alias = "seat-off")]
    #[cfg_attr(feature = "serde", serde(rename = "left_s"))]
    pub left: Vec<f64>,
    /// When it is met (s).
    #[doc(alias = "seat-on")]
    #[cfg_attr(feature = "serde", serde(rename = "met_s"))]
    pub met: Vec<f64>,
    /// How far the root is over its lowest place when the seat is left or met, at most (m).
    #[cfg_attr(feature = "serde", serde(rename = "lifted_m"))]
    pub lifted: f64,
    /// Greatest vertical force on the seat (% of body weight).
    #[cfg_attr(feature = "serde", serde(rename = "seat_percent_bw"))]
    pub seat: Peak,
    /// Greatest vertical force on both feet together (% of body weight).
    #[doc(alias = "grf")]
    #[cfg_attr(feature = "serde", serde(rename = "feet_percent_bw"))]
    pub feet: Peak,
    /// Greatest speed of the centre of mass along z, either way (m/s).
    #[cfg_attr(feature = "serde", serde(rename = "along_m_s"))]
    pub along: Peak,
    /// Greatest speed of the centre of mass up or down (m/s).
    #[cfg_attr(feature = "serde", serde(rename = "vertical_m_s"))]
    pub vertical: Peak,
    /// Greatest friction ratio of the seat or of a foot that bears more than 5 % of the weight.
    pub contact_friction: Peak,
    /// Least and greatest angles of hip, knee and ankle, both sides.
    pub angles: Vec<JointRange>,
    /// Their greatest moments and powers.
    pub joints: Vec<JointPeaks>,
    /// Greatest and least values as of walks; nothing swings.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub extremes: WalkExtremes,
}

/// Least and greatest angle of a joint (rad).
///
/// With the feature `serde` its keys are `joint`, `least_deg` and `greatest_deg`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[doc(alias = "range of motion")]
pub struct JointRange {
    /// Which angle, of either side: `hip.flexion`.
    pub joint: &'static str,
    /// The least (rad).
    #[cfg_attr(feature = "serde", serde(rename = "least_deg", serialize_with = "super::angle_in_degrees"))]
    pub least: f64,
    /// The greatest (rad).
    #[cfg_attr(
        feature = "serde",
        serde(rename = "greatest_deg", serialize_with = "super::angle_in_degrees")
    )]
    pub greatest: f64,
}

/// Measures how somebody stands up from a seat or sits down.
///
/// # Errors
///
/// A motion without joint forces, or without the contacts of both feet and of the seat, which is the pelvis'.
pub fn measure_chair(figure: &Figure, motion: &Motion) -> Result<ChairMeasures, GaitError> {
    let seat =
        motion.contact(SEATED).ok_or(MeasureError::NothingToMeasure { what: "contacts of the pelvis" })?;
    let joints = JointSeries::new(figure, motion)?;
    let series = Series::new(figure, motion)?;
    let extremes = WalkExtremes::of(figure, motion, &series);
    let percent = 100.0 / series.weight;
    let (left, met) = (times(motion, false), times(motion, true));
    let root = figure.layout().joints()[0].q + 1;
    let height = |i: usize| motion.q(i)[root];
    let lowest = (0..motion.len()).map(height).fold(f64::INFINITY, f64::min);
    let at = |time: f64| {
        let after = motion.time().partition_point(|t| *t < time).clamp(1, motion.len() - 1);
        let [from, to] = [after - 1, after].map(|i| motion.time()[i]);
        let part = (time - from) / (to - from);
        height(after - 1) + part * (height(after) - height(after - 1))
    };
    let speed = |axis: usize| {
        let rate = |i: usize| {
            let (before, after) = (i.saturating_sub(1), (i + 1).min(motion.len() - 1));
            (series.com[after][axis] - series.com[before][axis])
                / (motion.time()[after] - motion.time()[before])
        };
        series.greatest((0..motion.len()).map(|i| rate(i).abs()))
    };
    let on_seat = series.greatest(seat.samples.iter().map(|contact| {
        let Contact { force, .. } = contact;
        if force.y > LOADED * series.weight { force.x.hypot(force.z) / force.y } else { 0.0 }
    }));
    let range = |joint: &'static str| -> Result<JointRange, GaitError> {
        let sides = [format!("left_{joint}"), format!("right_{joint}")];
        let [left, right] =
            [angle(figure, motion, sides[0].clone())?, angle(figure, motion, sides[1].clone())?];
        let all = || left.iter().chain(&right).copied();
        Ok(JointRange {
            joint,
            least: all().fold(f64::INFINITY, f64::min),
            greatest: all().fold(f64::NEG_INFINITY, f64::max),
        })
    };
    Ok(ChairMeasures {
        duration: motion.time()[motion.len() - 1],
        lifted: left.iter().chain(&met).map(|time| at(*time) - lowest).fold(0.0, f64::max),
        left,
        met,
        seat: series.greatest(seat.samples.iter().map(|contact| percent * contact.force.y)),
        feet: series
            .greatest((0..motion.len()).map(|i| percent * (series.forces[0][i].y + series.forces[1][i].y))),
        along: speed(2),
        vertical: speed(1),
        contact_friction: extremes.foot_friction.max(on_seat),
        angles: SIDED_ANGLES.into_iter().map(range).collect::<Result<_, _>>()?,
        joints: joints.peaks(&series),
        extremes,
    })
}

/// When the seat is met, or left (s).
fn times(motion: &Motion, met: bool) -> Vec<f64> {
    let of = |kind: &EventKind| match kind {
        EventKind::TouchDown { link } => met && link == SEATED,
        EventKind::LiftOff { link } => !met && link == SEATED,
        _ => false,
    };
    motion.events.iter().filter(|event| of(&event.kind)).map(|event| event.time).collect()
}
