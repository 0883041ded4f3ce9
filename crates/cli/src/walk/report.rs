//! The numbers of a walk, as they are written to JSON.

use super::notes::notes;
use super::numbers::short;
use super::planned::{Planned, postures, style};
use super::told::{BesideKeyPostures, Extreme, Forces, KeyPostures};
use crate::limbs::Limbs;
use serde::Serialize;
use solaris::gait::{
    Band, IsolatedPeak, Peak, RECIPE_BANDS, SteadyStride, StyledPlan, TEXTBOOK_BANDS, WALK_RATIO,
    WalkMeasures, WalkPlan, check_bands,
};
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
    pub(crate) steady_stride: Option<Stride>,
    pub(crate) whole_walk: Whole,
    pub(crate) bands: Vec<BandList>,
    pub(crate) forces: Forces,
    pub(crate) run_time: RunTime,
    pub(crate) notes: Vec<String>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Person {
    pub(crate) height_m: f64,
    pub(crate) mass_kg: f64,
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
    pub(crate) step_frequency_per_min: f64,
    pub(crate) step_length_m: f64,
    /// Step length over people's at this height and frequency.
    pub(crate) step_length_over_peoples: f64,
    pub(crate) speed_m_s: f64,
    pub(crate) distance_m: f64,
    pub(crate) duration_s: f64,
    pub(crate) frames: usize,
    pub(crate) rate_per_s: f64,
    pub(crate) double_supports_percent: Vec<f64>,
}

/// Percent of body weight, degrees, cm, N m/kg.
#[derive(Debug, Serialize)]
pub(crate) struct Stride {
    pub(crate) span_s: (f64, f64),
    pub(crate) step_length_m: f64,
    pub(crate) speed_m_s: f64,
    pub(crate) cadence_per_min: f64,
    pub(crate) double_support_percent: f64,
    pub(crate) stance_percent: f64,
    /// Step length over cadence; people's is 0.0065 (cited).
    pub(crate) walk_ratio_m_min: f64,
}

#[derive(Debug, Serialize)]
pub(crate) struct Whole {
    pub(crate) vertical_percent_bw: Extreme,
    pub(crate) braking_percent_bw: Extreme,
    pub(crate) pushing_percent_bw: Extreme,
    pub(crate) friction: Extreme,
    pub(crate) foot_friction: Extreme,
    pub(crate) slide_m: Extreme,
    pub(crate) sink_m: Extreme,
    pub(crate) toe_clearance_m: Extreme,
    pub(crate) cop_outside_m: Extreme,
    pub(crate) least_knee_deg: Extreme,
    /// How near limbs came to each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) nearest_limbs: Option<Limbs>,
    pub(crate) joints: Vec<JointPeaks>,
}

/// Moments in N m/kg, powers in W/kg.
#[derive(Debug, Serialize)]
pub(crate) struct JointPeaks {
    pub(crate) joint: &'static str,
    pub(crate) extension: Extreme,
    pub(crate) flexion: Extreme,
    pub(crate) generated: Extreme,
    pub(crate) absorbed: Extreme,
}

#[derive(Debug, Serialize)]
pub(crate) struct BandList {
    pub(crate) name: &'static str,
    pub(crate) source: &'static str,
    pub(crate) inside: usize,
    pub(crate) of: usize,
    pub(crate) checks: Vec<Check>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Check {
    pub(crate) name: &'static str,
    pub(crate) unit: &'static str,
    pub(crate) value: f64,
    pub(crate) lower: f64,
    pub(crate) upper: f64,
    pub(crate) inside: bool,
}

#[derive(Debug, Serialize)]
pub(crate) struct RunTime {
    pub(crate) planning_s: f64,
    pub(crate) with_forces_s: f64,
}

impl Report {
    pub(crate) fn new(
        mass: f64,
        planned: Planned,
        measures: &WalkMeasures,
        lone: &[IsolatedPeak],
        limbs: Option<Limbs>,
    ) -> Self {
        let Planned { plan, motion, forces, repeats, asked_frequency, changes, beside, planning, solving } =
            planned;
        let (height, step_frequency, step_length) =
            (plan.stature(), plan.step_frequency(), plan.step_length());
        let stands = matches!(plan, StyledPlan::Sequence(_));
        let m = measures;
        let overlaps = limbs.as_ref().and_then(Limbs::overlap_note).into_iter();
        let weight = mass * motion.info.gravity.norm();
        let mut notes: Vec<String> = overlaps.chain(notes(&plan, m, lone, weight, repeats)).collect();
        if (step_frequency - asked_frequency).abs() > 1e-6 * asked_frequency {
            notes.push(format!(
                "{:.1} steps/min in place of {:.1}: so the stride lasts {} frames of {} a second",
                step_frequency,
                asked_frequency,
                motion.len() - 1,
                short(motion.info.rate)
            ));
        }
        let joint = |joint: &solaris::gait::JointPeaks| JointPeaks {
            joint: joint.joint,
            extension: extreme(joint.extension),
            flexion: extreme(joint.flexion),
            generated: extreme(joint.generated),
            absorbed: extreme(joint.absorbed),
        };
        Self {
            version: env!("CARGO_PKG_VERSION"),
            person: Person { height_m: height, mass_kg: mass },
            walk: Walk {
                style: style(&plan),
                repeats,
                changes,
                steps: match &plan {
                    // Of a stride only one touch-down is within, the other is its begin.
                    _ if repeats => 2,
                    // Each walk of a journey closes.
                    StyledPlan::Sequence(journey) => journey.walks().map(WalkPlan::steps).sum(),
                    _ => m.steps,
                },
                step_frequency_per_min: step_frequency,
                step_length_m: step_length,
                step_length_over_peoples: step_length / (WALK_RATIO * height * step_frequency),
                speed_m_s: step_length * step_frequency / 60.0,
                distance_m: m.distance,
                duration_s: m.duration,
                // The last frame of a stride is its first.
                frames: if repeats { motion.len() - 1 } else { motion.len() },
                rate_per_s: motion.info.rate,
                // Not where feet stand between two walks.
                double_supports_percent: if stands { Vec::new() } else { m.double_supports.clone() },
            },
            steady_stride: m.steady.as_ref().map(stride),
            whole_walk: Whole {
                vertical_percent_bw: extreme(m.vertical),
                braking_percent_bw: extreme(m.braking),
                pushing_percent_bw: extreme(m.pushing),
                friction: extreme(m.friction),
                foot_friction: extreme(m.foot_friction),
                slide_m: extreme(m.slide),
                sink_m: extreme(m.sink),
                toe_clearance_m: extreme(m.clearance),
                cop_outside_m: extreme(m.cop_outside),
                least_knee_deg: Extreme { value: m.least_knee.value.to_degrees(), at_s: m.least_knee.time },
                nearest_limbs: limbs,
                joints: m.joints.iter().map(joint).collect(),
            },
            bands: m.steady.as_ref().map_or_else(Vec::new, bands),
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

fn extreme(peak: Peak) -> Extreme {
    Extreme { value: peak.value, at_s: peak.time }
}

fn stride(s: &SteadyStride) -> Stride {
    Stride {
        span_s: s.span,
        step_length_m: s.step_length,
        speed_m_s: s.speed,
        cadence_per_min: s.cadence,
        double_support_percent: s.double_support,
        stance_percent: s.stance,
        walk_ratio_m_min: s.step_length / s.cadence,
    }
}

fn bands(stride: &SteadyStride) -> Vec<BandList> {
    let list = |name: &'static str, source: &'static str, bands: &'static [Band]| {
        let checks: Vec<Check> = check_bands(bands, stride)
            .into_iter()
            .map(|check| Check {
                name: check.band.name,
                unit: check.band.unit,
                value: check.value,
                lower: check.band.range.0,
                upper: check.band.range.1,
                inside: check.inside,
            })
            .collect();
        let inside = checks.iter().filter(|check| check.inside).count();
        BandList { name, source, inside, of: checks.len(), checks }
    };
    vec![
        list("recipe", "the bands that the walk was fitted to", RECIPE_BANDS),
        list("textbook", "textbook range, not cited", TEXTBOOK_BANDS),
    ]
}
