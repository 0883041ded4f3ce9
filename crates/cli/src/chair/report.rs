//! The numbers of standing up or sitting down, as they are written to JSON.

use crate::limbs::overlap_note;
use serde::Serialize;
use solaris::analysis::{NearestLimbs, ReactionReport};
use solaris::gait::{ChairMeasures, ChairMotion, ChairPlan, ChairRequest};
use solaris::model::Motion;
use std::io::Write;
use std::time::Duration;

/// Everything that it came to.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// Of the program that wrote it.
    pub(super) version: &'static str,
    pub(super) height_m: f64,
    /// Of the person alone.
    pub(super) mass_kg: f64,
    /// In both hands together.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) carried_kg: Option<f64>,
    pub(super) motion: &'static str,
    /// How often somebody stands up or sits down.
    pub(super) times: usize,
    pub(super) seat_m: f64,
    pub(super) shank_deg: f64,
    pub(super) one_way_s: f64,
    pub(super) frames: usize,
    pub(super) rate_per_s: f64,
    /// Greatest forward lean of the trunk.
    pub(super) lean_deg: f64,
    #[serde(flatten)]
    pub(super) measures: ChairMeasures,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) nearest_limbs: Option<NearestLimbs>,
    /// Greatest force (N) and moment (N m) that no force of ground or seat explains.
    pub(super) root_residual_n: f64,
    pub(super) root_residual_n_m: f64,
    pub(super) planning_s: f64,
    pub(super) with_forces_s: f64,
    pub(super) notes: Vec<String>,
}

impl Report {
    /// Of a person of so much mass, of which hands carry so much (kg).
    #[expect(clippy::too_many_arguments, reason = "all that is known")]
    pub(super) fn new(
        (mass, carried): (f64, f64),
        request: &ChairRequest,
        plan: &ChairPlan,
        motion: &Motion,
        measures: ChairMeasures,
        forces: &ReactionReport,
        nearest_limbs: Option<NearestLimbs>,
        [planning, solving]: [Duration; 2],
    ) -> Self {
        let (name, times) = match request.motion {
            ChairMotion::Rise => ("stands up", 1),
            ChairMotion::Sit => ("sits down", 1),
            ChairMotion::RiseAndSit(times) => ("stands up and sits down", times),
        };
        Self {
            version: env!("CARGO_PKG_VERSION"),
            height_m: plan.stature(),
            mass_kg: mass - carried,
            carried_kg: Some(carried).filter(|carried| *carried > 0.0),
            motion: name,
            times,
            seat_m: plan.seat(),
            shank_deg: request.shank.to_degrees(),
            one_way_s: plan.one_way(),
            frames: motion.len(),
            rate_per_s: motion.info.rate,
            lean_deg: motion.time().iter().map(|time| plan.lean(*time)).fold(0.0, f64::max).to_degrees(),
            measures,
            notes: nearest_limbs.as_ref().and_then(overlap_note).into_iter().collect(),
            nearest_limbs,
            root_residual_n: forces.root_force,
            root_residual_n_m: forces.root_moment,
            planning_s: planning.as_secs_f64(),
            with_forces_s: solving.as_secs_f64(),
        }
    }

    /// Writes the report as JSON.
    pub(super) fn write(&self, mut writer: impl Write) -> std::io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, self).map_err(std::io::Error::from)?;
        writer.write_all(b"\n")
    }
}
