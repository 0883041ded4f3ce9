//! The columns of a sweep's row.

use super::Walked;
use crate::measure::{JointPeaks, SteadyStride};

/// A number of a walk.
#[derive(Debug)]
pub struct Column {
    /// What heads it, with its unit.
    pub heading: &'static str,
    /// What it is.
    pub help: &'static str,
    value: fn(&Walked) -> Option<f64>,
}

impl Column {
    /// Its value; `None` where the walk has none, never NaN nor infinite.
    pub fn value(&self, walked: &Walked) -> Option<f64> {
        (self.value)(walked).filter(|value| value.is_finite())
    }
}

const fn column(heading: &'static str, help: &'static str, value: fn(&Walked) -> Option<f64>) -> Column {
    Column { heading, help, value }
}

fn steady(walked: &Walked, of: fn(&SteadyStride) -> f64) -> Option<f64> {
    walked.measures.steady.as_ref().map(of)
}

fn joint(walked: &Walked, name: &str, of: fn(&JointPeaks) -> f64) -> Option<f64> {
    walked.measures.joints.iter().find(|joint| joint.joint == name).map(of)
}

/// Mean over the double supports between steps; a walk of one step has one.
fn double_support(walked: &Walked) -> f64 {
    let each = &walked.measures.double_supports;
    each.iter().sum::<f64>() / each.len() as f64
}

/// The columns of a sweep, in order. Headings differ from the names of walk options, so that both stand in one table.
#[rustfmt::skip]
pub const COLUMNS: &[Column] = &[
    column("walked_steps", "steps, without the closing one", |w| Some(w.measures.steps as f64)),
    column("distance_m", "how far the centre of mass went forward", |w| Some(w.measures.distance)),
    column("duration_s", "from rest to rest", |w| Some(w.measures.duration)),
    column("step_frequency_per_min", "steps a minute of the steady part", |w| Some(w.pace.0)),
    column("step_length_m", "of the steady part", |w| Some(w.pace.1)),
    column("speed_m_s", "of the steady part", |w| Some(w.pace.0 * w.pace.1 / 60.0)),
    column("double_support_percent", "mean of the double supports, % of the stride", |w| Some(double_support(w))),
    column("stance_percent", "of a steady stride", |w| steady(w, |s| s.stance)),
    column("vertical_first_percent_bw", "first peak of the vertical force in a steady stride", |w| steady(w, |s| s.first_peak)),
    column("vertical_valley_percent_bw", "valley between the peaks", |w| steady(w, |s| s.valley)),
    column("vertical_second_percent_bw", "second peak", |w| steady(w, |s| s.second_peak)),
    column("vertical_peak_percent_bw", "greatest vertical force on one foot in the walk", |w| Some(w.measures.extremes.vertical.value)),
    column("braking_percent_bw", "greatest braking force on one foot", |w| Some(w.measures.extremes.braking.value)),
    column("pushing_percent_bw", "greatest pushing force on one foot", |w| Some(w.measures.extremes.pushing.value)),
    column("friction", "greatest friction ratio of both feet together", |w| Some(w.measures.extremes.friction.value)),
    column("foot_friction", "greatest friction ratio of one foot that bears more than 5 % of the weight", |w| Some(w.measures.extremes.foot_friction.value)),
    column("free_moment_n_m", "greatest free moment of one foot", |w| Some(w.free_moment.value)),
    column("slide_mm", "greatest slide of a planted point", |w| Some(1e3 * w.measures.extremes.slide.value)),
    column("sink_mm", "greatest depth of a point of the soles below the ground", |w| Some(1e3 * w.measures.extremes.sink.value)),
    column("clearance_mm", "least height of the toes' tip in mid-swing", |w| Some(1e3 * w.measures.extremes.clearance.value)),
    column("cop_outside_mm", "greatest distance of a centre of pressure outside of its foot", |w| Some(1e3 * w.measures.extremes.cop_outside.value)),
    column("least_knee_deg", "least knee flexion; negative is hyperextended", |w| Some(w.measures.extremes.least_knee.value.to_degrees())),
    column("com_rise_cm", "vertical range of the centre of mass in a steady stride", |w| steady(w, |s| s.com_vertical)),
    column("com_sway_cm", "lateral range of the centre of mass in a steady stride", |w| steady(w, |s| s.com_lateral)),
    column("hip_extensor_n_m_kg", "greatest moment of a hip", |w| joint(w, "hip", |j| j.extension.value)),
    column("hip_flexor_n_m_kg", "the other way", |w| joint(w, "hip", |j| j.flexion.value)),
    column("knee_extensor_n_m_kg", "greatest moment of a knee", |w| joint(w, "knee", |j| j.extension.value)),
    column("knee_flexor_n_m_kg", "the other way", |w| joint(w, "knee", |j| j.flexion.value)),
    column("ankle_plantarflexor_n_m_kg", "greatest moment of an ankle", |w| joint(w, "ankle", |j| j.extension.value)),
    column("ankle_dorsiflexor_n_m_kg", "the other way", |w| joint(w, "ankle", |j| j.flexion.value)),
];
