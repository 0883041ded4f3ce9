//! Measures of a walk: numbers of a finished motion, found from the motion alone.
//!
//! Nothing here knows the plan. The motion must carry its events, planted points, ground reactions and joint forces.

mod bands;
mod chair;
mod feet;
mod isolated;
mod joints;
pub(crate) mod peaks;
mod range;
mod series;
mod steady;
mod steady_run;
pub(crate) mod window;

pub use bands::{Band, BandCheck, BandReport, RECIPE_BANDS, TEXTBOOK_BANDS, band_reports, check_bands};
pub use chair::{ChairMeasures, JointRange, measure_chair};
pub use isolated::{IsolatedPeak, isolated_peaks};
pub use range::BeyondRange;
pub use solaris_analysis::Peak;
pub use steady::SteadyStride;
pub use steady_run::{RUN_BANDS, RunBand, SteadyRun, measure_run, run_bands};

use crate::body::FEET;
use crate::error::GaitError;
use joints::JointSeries;
use series::Series;
use solaris_model::{EventKind, Figure, Motion};

/// Greatest moments and powers of one joint, both sides, over the whole walk; per kg of body mass.
///
/// With the feature `serde` its keys are the fields' names, in N m/kg and W/kg.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct JointPeaks {
    /// Hip, knee or ankle.
    pub joint: &'static str,
    /// Greatest extending moment (plantarflexing for the ankle), N m/kg.
    pub extension: Peak,
    /// Greatest flexing moment (dorsiflexing for the ankle), N m/kg.
    pub flexion: Peak,
    /// Greatest power that the joint gives, W/kg.
    pub generated: Peak,
    /// Greatest power that it takes, W/kg; negative.
    pub absorbed: Peak,
}

/// The numbers of a walk.
///
/// With the feature `serde` its keys are `steps`, `distance_m`, `duration_s`, `double_supports_percent`, those of [`WalkExtremes`],
/// `joints` and `steady_stride`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[doc(alias = "spatiotemporal parameters")]
#[doc(alias = "gait parameters")]
pub struct WalkMeasures {
    /// Steps, without the closing one.
    pub steps: usize,
    /// Distance that the centre of mass went along z, or against it where the body walks backward (m).
    #[cfg_attr(feature = "serde", serde(rename = "distance_m"))]
    pub distance: f64,
    /// How long it lasts (s).
    #[cfg_attr(feature = "serde", serde(rename = "duration_s"))]
    pub duration: f64,
    /// Each double support between steps, in % of the stride time at it; a run has none.
    #[doc(alias = "double support")]
    #[doc(alias = "dual support")]
    #[cfg_attr(feature = "serde", serde(rename = "double_supports_percent"))]
    pub double_supports: Vec<f64>,
    /// Greatest and least values over all of it.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub extremes: WalkExtremes,
    /// Hip, knee and ankle.
    pub joints: Vec<JointPeaks>,
    /// A stride from the middle, where the walk is long enough to have a steady one (eight steps); none of a run, see
    /// [`measure_run`].
    #[cfg_attr(feature = "serde", serde(rename = "steady_stride"))]
    pub steady: Option<SteadyStride>,
}

/// Greatest and least values over a whole walk.
///
/// With the feature `serde` its keys are `vertical_percent_bw`, `braking_percent_bw`, `pushing_percent_bw`, `friction`,
/// `foot_friction`, `slide_m`, `sink_m`, `toe_clearance_m`, `cop_outside_m`, `least_knee_deg` and, where
/// a joint leaves its range, `beyond_range`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct WalkExtremes {
    /// Greatest vertical force on one foot (% of body weight).
    #[doc(alias = "grf")]
    #[doc(alias = "vgrf")]
    #[doc(alias = "ground reaction force")]
    #[cfg_attr(feature = "serde", serde(rename = "vertical_percent_bw"))]
    pub vertical: Peak,
    /// Greatest braking and pushing force on one foot, against and along z (% of body weight); where the body walks backward, the other way
    /// round.
    #[doc(alias = "grf")]
    #[cfg_attr(feature = "serde", serde(rename = "braking_percent_bw"))]
    pub braking: Peak,
    /// See `braking`.
    #[cfg_attr(feature = "serde", serde(rename = "pushing_percent_bw"))]
    pub pushing: Peak,
    /// Greatest friction ratio of both feet together.
    pub friction: Peak,
    /// Greatest friction ratio of one foot that bears more than 5 % of the weight.
    pub foot_friction: Peak,
    /// Greatest distance that a planted point moves (m).
    #[doc(alias = "foot skate")]
    #[doc(alias = "foot sliding")]
    #[cfg_attr(feature = "serde", serde(rename = "slide_m"))]
    pub slide: Peak,
    /// Greatest depth of a point of the soles below the ground (m).
    #[cfg_attr(feature = "serde", serde(rename = "sink_m"))]
    pub sink: Peak,
    /// Least height of the toes' tip in mid-swing (m).
    #[doc(alias = "toe clearance")]
    #[doc(alias = "foot clearance")]
    #[doc(alias = "mtc")]
    #[cfg_attr(feature = "serde", serde(rename = "toe_clearance_m"))]
    pub clearance: Peak,
    /// Greatest distance of a centre of pressure outside the part of the foot that touches the ground (m).
    #[doc(alias = "cop")]
    #[doc(alias = "centre of pressure")]
    #[doc(alias = "center of pressure")]
    #[cfg_attr(feature = "serde", serde(rename = "cop_outside_m"))]
    pub cop_outside: Peak,
    /// Least knee flexion (rad); negative is hyperextended.
    #[cfg_attr(feature = "serde", serde(rename = "least_knee_deg", serialize_with = "degrees"))]
    pub least_knee: Peak,
    /// The joint that goes farthest beyond its own range, if one does.
    #[doc(alias = "joint limits")]
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub beyond_range: Option<BeyondRange>,
}

/// An angle (rad) in degrees.
#[cfg(feature = "serde")]
fn degrees<S: serde::Serializer>(angle: &Peak, serializer: S) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&Peak { value: angle.value.to_degrees(), ..*angle }, serializer)
}

/// An angle (rad) in degrees.
#[cfg(feature = "serde")]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature is serde's")]
fn angle_in_degrees<S: serde::Serializer>(angle: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(angle.to_degrees())
}

/// Measures a walk.
///
/// # Errors
///
/// A motion without ground reactions or joint forces.
pub fn measure(figure: &Figure, motion: &Motion) -> Result<WalkMeasures, GaitError> {
    let joints = JointSeries::new(figure, motion)?;
    let series = Series::new(figure, motion)?;
    let contacts: Vec<(f64, usize)> = touch_downs(motion);
    let along = |sample: usize| series.sense * series.com[sample].z;
    let last = motion.len() - 1;
    let double_supports = double_supports(motion, &contacts);
    Ok(WalkMeasures {
        steps: contacts.len().saturating_sub(1),
        distance: along(last) - along(0),
        duration: motion.time()[last],
        extremes: WalkExtremes::of(figure, motion, &series),
        joints: joints.peaks(&series),
        // A run's stride has other measures.
        steady: if double_supports.is_empty() || flies(motion) {
            None
        } else {
            SteadyStride::find(motion, &series, &joints, &contacts)
        },
        double_supports,
    })
}

/// Only the greatest and least values of a walk, whose joint forces need not be known.
///
/// # Errors
///
/// A motion without ground reactions.
pub(crate) fn extremes(figure: &Figure, motion: &Motion) -> Result<WalkExtremes, GaitError> {
    Ok(WalkExtremes::of(figure, motion, &Series::new(figure, motion)?))
}

impl WalkExtremes {
    fn of(figure: &Figure, motion: &Motion, series: &Series<'_>) -> Self {
        let (sink, cop_outside) = feet::sink_and_cop(figure, motion, series);
        let percent = 100.0 / series.weight;
        let force = |f: fn(&nalgebra::Vector3<f64>) -> f64, sign: f64| {
            let values = |side: usize| series.forces[side].iter().map(move |force| sign * percent * f(force));
            let peak = series.greatest(values(0)).max(series.greatest(values(1)));
            Peak { value: sign * peak.value, ..peak }
        };
        Self {
            vertical: force(|f| f.y, 1.0),
            braking: force(|f| f.z, -series.sense),
            pushing: force(|f| f.z, series.sense),
            friction: series.greatest((0..motion.len()).map(|i| {
                let total = series.forces[0][i] + series.forces[1][i];
                total.x.hypot(total.z) / total.y
            })),
            foot_friction: series.greatest((0..motion.len()).map(|i| {
                let loaded =
                    series.forces.iter().map(|forces| forces[i]).filter(|f| f.y > 0.05 * series.weight);
                loaded.map(|f| f.x.hypot(f.z) / f.y).fold(0.0, f64::max)
            })),
            slide: feet::slide(motion, series),
            sink,
            clearance: feet::clearance(figure, motion, series),
            cop_outside,
            least_knee: {
                let knees = (0..motion.len()).map(|i| -series.knee[0][i].min(series.knee[1][i]));
                let peak = series.greatest(knees);
                Peak { value: -peak.value, ..peak }
            },
            beyond_range: range::beyond_range(figure, motion, series),
        }
    }
}

/// Measures a motion that is one steady stride, from left contact to left contact.
///
/// # Errors
///
/// A motion without ground reactions or joint forces.
pub fn measure_stride(figure: &Figure, motion: &Motion) -> Result<SteadyStride, GaitError> {
    let joints = JointSeries::new(figure, motion)?;
    let series = Series::new(figure, motion)?;
    let time = motion.time();
    Ok(SteadyStride::of(motion, &series, &joints, (time[0], time[time.len() - 1])))
}

/// Times this near are one (s).
pub(crate) const SAME_TIME: f64 = 1e-9;

/// Greatest free moment (N m) of one foot: the moment of its contact about the vertical through its centre of pressure,
/// either way round.
///
/// ```text
/// T = n·(M − p × F)
/// ```
#[doc(alias = "vertical torque")]
#[doc(alias = "tz")]
pub fn free_moment(motion: &Motion) -> Peak {
    let up = -motion.info.gravity.normalize();
    let mut worst = Peak { value: 0.0, time: 0.0 };
    for track in &motion.contacts {
        for (contact, &time) in track.samples.iter().zip(motion.time()) {
            let value = up.dot(&(contact.moment - contact.cop.cross(&contact.force))).abs();
            worst = worst.max(Peak { value, time });
        }
    }
    worst
}

/// Times of the contacts, and the side of each.
fn touch_downs(motion: &Motion) -> Vec<(f64, usize)> {
    motion
        .events
        .iter()
        .filter_map(|event| match &event.kind {
            EventKind::TouchDown { link } => {
                FEET.iter().position(|foot| foot == link).map(|side| (event.time, side))
            }
            _ => None,
        })
        .collect()
}

/// Whether both feet are in the air somewhere: the other foot lifts before one lands.
fn flies(motion: &Motion) -> bool {
    // When each foot has lifted, where it is in the air.
    let mut lifted: [Option<f64>; 2] = [None; 2];
    for event in &motion.events {
        let side = |link: &String| FEET.iter().position(|foot| foot == link);
        match &event.kind {
            EventKind::LiftOff { link } => {
                if let Some(side) = side(link) {
                    lifted[side] = Some(event.time);
                }
            }
            EventKind::TouchDown { link } => {
                let Some(side) = side(link) else { continue };
                if lifted[1 - side].is_some_and(|time| time < event.time - SAME_TIME) {
                    return true;
                }
                lifted[side] = None;
            }
            _ => {}
        }
    }
    false
}

/// From each contact but the closing one to the next lift-off, in % of the stride that the two contacts around it make.
fn double_supports(motion: &Motion, contacts: &[(f64, usize)]) -> Vec<f64> {
    let lifts: Vec<(f64, &str)> = motion
        .events
        .iter()
        .filter_map(|event| match &event.kind {
            EventKind::LiftOff { link } => Some((event.time, link.as_str())),
            _ => None,
        })
        .collect();
    let spans = contacts.windows(2).map(|pair| (pair[0], 2.0 * (pair[1].0 - pair[0].0)));
    spans
        .filter_map(|((contact, side), stride)| {
            // A foot may lift at the very moment at which the other one lands.
            let next = lifts.partition_point(|(lift, _)| *lift < contact - SAME_TIME);
            let (lift, link) = lifts.get(next)?;
            // Where the foot that has landed lifts next, the other one is in the air: it runs.
            (*link != FEET[side]).then(|| 100.0 * (lift - contact).max(0.0) / stride)
        })
        .collect()
}
