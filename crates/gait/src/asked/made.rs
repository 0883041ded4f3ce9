//! What options come to: a motion with its forces and measures.

use super::options::{GaitOptions, Repeats};
use crate::error::GaitError;
use crate::measure::{SteadyRun, WalkMeasures, measure};
use crate::styled::{StyledPlan, WalkForces};
use crate::walking::on_the_spot;
use solaris_model::{Figure, Motion};

/// Samples a second where it is not said how many (1/s).
pub const DEFAULT_RATE: f64 = 120.0;

/// A walk or a run that was planned, with its forces and measures.
///
/// With the feature `serde` its keys are `style`, `repeats`, `step_frequency_per_min`, `step_length_m`, `speed_m_s`, `duration_s`,
/// `forces`, `measures`, `run` (of a run, else null) and `notes`.
pub struct Gait {
    /// The plan.
    pub plan: StyledPlan,
    /// Its samples; the last one of a stride that repeats itself is its first one again.
    pub motion: Motion,
    /// What is known of its forces besides.
    pub forces: WalkForces,
    /// What was measured of it.
    pub measures: WalkMeasures,
    /// A steady stride of a run.
    pub run: Option<SteadyRun>,
    /// Whether it is one stride that repeats itself.
    pub repeats: bool,
    /// What is otherwise than it was asked for, and why.
    pub notes: Vec<String>,
}

impl GaitOptions {
    /// Plans it for a figure, finds its forces and measures it.
    ///
    /// # Errors
    ///
    /// Those of [`Self::request`], [`StyledPlan::of`] and [`StyledPlan::loaded`].
    pub fn make(&self, figure: &Figure) -> Result<Gait, GaitError> {
        let staged = self.request(figure)?;
        let mut notes = Vec::new();
        let mut plan_of = |request| {
            let (plan, in_part) = StyledPlan::as_far_as_it_holds(figure, request)?;
            if let Some((part, why)) = in_part {
                notes.push(format!(
                    "{:.0} % of the manner and of the variability are walked, for all of them would not hold: {why}",
                    100.0 * part
                ));
            }
            Ok::<_, GaitError>(plan)
        };
        let mut plan = plan_of(&staged.request)?;
        let rate = self.rate.unwrap_or(DEFAULT_RATE);
        let asked = plan.step_frequency();
        if self.repeats.is_some()
            && self.rate.is_some()
            && let Some(request) = staged.request.in_step(plan.stature(), asked, rate)
        {
            plan = plan_of(&request)?;
        }
        let (mut motion, forces) = if self.repeats.is_some() {
            plan.loaded_stride(figure, rate)?
        } else {
            plan.loaded(figure, rate)?
        };
        let measures = measure(figure, &motion)?;
        let run = plan.steady_run(figure)?;
        if self.repeats == Some(Repeats::InPlace) {
            motion = on_the_spot(figure, &motion)?;
        }
        if (plan.step_frequency() - asked).abs() > 1e-6 * asked {
            notes.push(format!(
                "{:.1} steps/min in place of {asked:.1}: so the stride lasts {} frames of {rate} a second",
                plan.step_frequency(),
                motion.len() - 1
            ));
        }
        Ok(Gait { plan, motion, forces, measures, run, repeats: self.repeats.is_some(), notes })
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Gait {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct as _;
        let Self { plan, motion: _, forces, measures, run, repeats, notes } = self;
        let mut fields = serializer.serialize_struct("Gait", 10)?;
        fields.serialize_field("style", plan.style_name())?;
        fields.serialize_field("repeats", repeats)?;
        fields.serialize_field("step_frequency_per_min", &plan.step_frequency())?;
        fields.serialize_field("step_length_m", &plan.step_length())?;
        fields.serialize_field("speed_m_s", &(plan.step_length() * plan.step_frequency() / 60.0))?;
        fields.serialize_field("duration_s", &plan.duration())?;
        fields.serialize_field("forces", forces)?;
        fields.serialize_field("measures", measures)?;
        fields.serialize_field("run", run)?;
        fields.serialize_field("notes", notes)?;
        fields.end()
    }
}
