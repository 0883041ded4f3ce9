//! The numbers of a walk, as they are written to JSON.

use super::notes::notes;
use super::numbers::short;
use super::planned::{Planned, postures};
use super::told::{BesideKeyPostures, Forces, KeyPostures};
use crate::limbs::overlap_note;
use serde::Serialize;
use solaris::analysis::NearestLimbs;
use solaris::gait::{
    BandReport, CANE, IsolatedPeak, JointPeaks, SteadyRun, SteadyStride, StyledPlan, WALK_RATIO,
    WalkExtremes, WalkMeasures, WalkPlan, band_reports, helped_side, run_bands, step_length_on_slope,
};
use solaris::model::{Figure, Motion, Relief};
use std::io::Write;

/// Everything that a walk came to.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    /// Of the program that wrote it.
    pub(crate) version: &'static str,
    pub(crate) person: Person,
    pub(crate) walk: Walk,
    /// Of a walk in the thesis's style.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) key_postures: Option<KeyPostures>,
    /// Of a smooth walk: what it has at the instants of the key postures of the same step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) beside_key_postures: Option<BesideKeyPostures>,
    pub(crate) steady_stride: Option<SteadyStride>,
    /// Of a run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) steady_run: Option<SteadyRun>,
    pub(crate) whole_walk: Whole,
    pub(crate) bands: Vec<BandReport>,
    pub(crate) forces: Forces,
    pub(crate) run_time: RunTime,
    pub(crate) notes: Vec<String>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Person {
    pub(crate) height_m: f64,
    /// Of the person alone.
    pub(crate) mass_kg: f64,
    /// In both hands together.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) carried_kg: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) cane: Option<CaneReport>,
}

impl Person {
    /// Of a figure so tall (m), whose hands carry so much (kg), as it walks.
    fn of(figure: &Figure, height_m: f64, carried: f64, motion: &Motion) -> Self {
        let cane = CaneReport::of(figure, motion);
        let held = cane.as_ref().map_or(0.0, |cane| cane.mass_kg);
        let carried_kg = Some(carried).filter(|carried| *carried > 0.0);
        Self { height_m, mass_kg: figure.mass() - carried - held, carried_kg, cane }
    }
}

/// The cane in a hand.
#[derive(Debug, Serialize)]
pub(crate) struct CaneReport {
    pub(crate) hand: &'static str,
    pub(crate) mass_kg: f64,
    /// The most that it bears, upward, also over the weight.
    pub(crate) bears_n: f64,
    pub(crate) bears_over_weight: f64,
}

impl CaneReport {
    /// Of a figure that holds one, as it walks.
    fn of(figure: &Figure, motion: &Motion) -> Option<Self> {
        let (link, helped) = (figure.link(CANE)?, helped_side(figure)?);
        let track = motion.contacts.iter().find(|track| track.link == CANE);
        let bears =
            track.iter().flat_map(|track| &track.samples).map(|cane| cane.force.y).fold(0.0, f64::max);
        let weight = figure.mass() * motion.info.gravity.norm();
        let hand = ["right", "left"][helped];
        Some(Self { hand, mass_kg: link.mass(), bears_n: bears, bears_over_weight: bears / weight })
    }
}

#[derive(Debug, Serialize)]
pub(crate) struct Walk {
    pub(crate) style: &'static str,
    /// Whether it is one stride that repeats itself.
    pub(crate) repeats: bool,
    /// Whether pace or direction change on the way, or the body stands in between: frequency, length and speed are those at first.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(crate) changes: bool,
    pub(crate) steps: usize,
    /// How many of them are walked before and after a run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) walked_steps: Option<[usize; 2]>,
    pub(crate) step_frequency_per_min: f64,
    pub(crate) step_length_m: f64,
    /// Whether it goes backward, the first walk of several.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(crate) backward: bool,
    /// Step length over people's at this height and frequency, on the level or on the one slope that all ground is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) step_length_over_peoples: Option<f64>,
    pub(crate) speed_m_s: f64,
    pub(crate) distance_m: f64,
    pub(crate) duration_s: f64,
    pub(crate) frames: usize,
    pub(crate) rate_per_s: f64,
    pub(crate) double_supports_percent: Vec<f64>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Whole {
    #[serde(flatten)]
    pub(crate) extremes: WalkExtremes,
    /// How near limbs came to each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) nearest_limbs: Option<NearestLimbs>,
    pub(crate) joints: Vec<JointPeaks>,
}

#[derive(Debug, Serialize)]
pub(crate) struct RunTime {
    pub(crate) planning_s: f64,
    pub(crate) with_forces_s: f64,
}

/// What people's steps are over height and frequency (min), on level ground and on a slope from behind the first step to beyond the last one;
/// elsewhere the ground decides how long a step is.
fn peoples(motion: &Motion, distance: f64) -> Option<f64> {
    match motion.relief.as_ref().map(Relief::points) {
        None => Some(WALK_RATIO),
        Some(&[[from, low], [to, high]]) if from < 0.0 && to > distance => {
            Some(WALK_RATIO * step_length_on_slope(((high - low) / (to - from)).atan()))
        }
        Some(_) => None,
    }
}

/// How much more (degrees) than asked for a knee must bend in swing for it to be told, and how much longer or shorter (m) a walk must be.
const KNEE_TOLD: f64 = 3.0;
const DISTANCE_TOLD: f64 = 0.02;

impl Report {
    /// Of a person, whose hands carry so much (kg).
    pub(crate) fn new(
        (figure, carried): (&Figure, f64),
        planned: Planned,
        motion: &Motion,
        measures: WalkMeasures,
        lone: &[IsolatedPeak],
        nearest_limbs: Option<NearestLimbs>,
    ) -> Self {
        let Planned {
            plan,
            forces,
            repeats,
            asked_frequency,
            swinging_knee,
            asked_distance,
            changes,
            beside,
            in_part,
            running,
            heading_first,
            planning,
            solving,
        } = planned;
        let mass = figure.mass();
        let (height, step_frequency, step_length) =
            (plan.stature(), plan.step_frequency(), plan.step_length());
        let stands = matches!(plan, StyledPlan::Sequence(_));
        let overlaps = nearest_limbs.as_ref().and_then(overlap_note).into_iter();
        let weight = mass * motion.info.gravity.norm();
        let mut notes: Vec<String> = overlaps.chain(notes(&plan, &measures, lone, weight, repeats)).collect();
        if let Some((part, why)) = in_part {
            notes.push(format!(
                "{:.0} % of the manner and of the variability are walked, for all of them would not hold: {why}",
                100.0 * part
            ));
        }
        if (step_frequency - asked_frequency).abs() > 1e-6 * asked_frequency {
            notes.push(format!(
                "{:.1} steps/min in place of {:.1}: so the stride lasts {} frames of {} a second",
                step_frequency,
                asked_frequency,
                motion.len() - 1,
                short(motion.info.rate)
            ));
        }
        if let Some([asked, bends]) = swinging_knee.filter(|[asked, bends]| *bends > asked + KNEE_TOLD) {
            notes.push(format!(
                "the swinging knee bends to {bends:.0}°, not to the {asked}° asked for: a foot that leaves the ground bends it on, \
                 and has to clear the ground"
            ));
        }
        if let Some(asked) = asked_distance.filter(|asked| (measures.distance - asked).abs() > DISTANCE_TOLD)
        {
            notes.push(format!(
                "it goes {:.2} m, not the {} m asked for: feet stand where they find places",
                measures.distance,
                short(asked)
            ));
        }
        if heading_first {
            notes.push(
                "it turns too far for a root that turns about z first: the root turns by its heading first (root.ry, rz, rx); \
                 solaris figure human --heading-first writes this figure"
                    .to_owned(),
            );
        }
        let WalkMeasures { steps, distance, duration, double_supports, extremes, joints, steady } = measures;
        Self {
            version: env!("CARGO_PKG_VERSION"),
            person: Person::of(figure, height, carried, motion),
            walk: Walk {
                style: plan.style_name(),
                repeats,
                changes,
                steps: match &plan {
                    // Of a stride only one touch-down is within, the other is its begin.
                    _ if repeats => 2,
                    // Each walk of a journey closes.
                    StyledPlan::Sequence(journey) => journey.walks().map(WalkPlan::steps).sum(),
                    _ => steps,
                },
                walked_steps: match &plan {
                    StyledPlan::Run(run) => Some(run.walked_steps()).filter(|walked| *walked != [0, 0]),
                    _ => None,
                },
                backward: plan.smooth().is_some_and(WalkPlan::is_backward),
                step_frequency_per_min: step_frequency,
                step_length_m: step_length,
                step_length_over_peoples: peoples(motion, distance)
                    .filter(|_| !matches!(plan, StyledPlan::Run(_)))
                    .map(|peoples| step_length / (peoples * height * step_frequency)),
                speed_m_s: step_length * step_frequency / 60.0,
                distance_m: distance,
                duration_s: duration,
                // The last frame of a stride is its first.
                frames: if repeats { motion.len() - 1 } else { motion.len() },
                rate_per_s: motion.info.rate,
                // Not where feet stand between two walks.
                double_supports_percent: if stands { Vec::new() } else { double_supports },
            },
            bands: steady.iter().flat_map(band_reports).chain(running.iter().map(run_bands)).collect(),
            steady_run: running,
            steady_stride: steady,
            whole_walk: Whole { extremes, nearest_limbs, joints },
            key_postures: postures(&plan),
            beside_key_postures: beside,
            forces,
            run_time: RunTime { planning_s: planning.as_secs_f64(), with_forces_s: solving.as_secs_f64() },
            notes,
        }
    }

    /// Writes the report as JSON.
    pub(crate) fn write(&self, mut writer: impl Write) -> std::io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, self).map_err(std::io::Error::from)?;
        writer.write_all(b"\n")
    }
}
