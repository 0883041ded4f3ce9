//! The report of a run, as it is written to JSON.

use super::BUILD_STIFF;
use crate::limbs;
use crate::print::write_json;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use solaris::analysis::{NearestLimbs, ReactionReport};
use solaris::modes::{Remark, RunReport};
use solaris::scene::{Scene, Simulated};
use std::io::Write;

/// Everything that a run came to.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// Of the program that wrote it.
    pub(super) version: &'static str,
    /// What the scene calls its figure.
    pub(super) scene: String,
    pub(super) figure: String,
    pub(super) dofs: usize,
    pub(super) duration_s: f64,
    pub(super) rate_per_s: f64,
    pub(super) frames: usize,
    /// Without its remarks.
    #[serde(flatten)]
    pub(super) run: RunReport,
    /// What the ground does under a walk.
    pub(super) ground: Option<Reactions>,
    /// How near limbs came to each other, where there are any to measure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) nearest_limbs: Option<NearestLimbs>,
    pub(super) remarks: Vec<String>,
}

/// What the ground does under a walk, without when it is worst.
#[derive(Debug)]
pub(super) struct Reactions(pub(super) ReactionReport);

impl Serialize for Reactions {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let report = &self.0;
        let mut ground = serializer.serialize_struct("Reactions", 5)?;
        ground.serialize_field("double_support_split", report.split)?;
        ground.serialize_field("root_residual_n", &report.root_force)?;
        ground.serialize_field("root_residual_n_m", &report.root_moment)?;
        ground.serialize_field("from_prescribed_n", &report.from_prescribed.map(|off| off.value))?;
        ground.serialize_field("cop_from_nominal_m", &report.cop_from_nominal.value)?;
        ground.end()
    }
}

impl Report {
    pub(super) fn new(scene: &Scene, simulated: &Simulated, nearest_limbs: Option<NearestLimbs>) -> Self {
        let figure = scene.figure();
        let mut run = simulated.report.clone();
        let remarks = std::mem::take(&mut run.remarks);
        let overlaps = nearest_limbs.as_ref().and_then(limbs::overlap_note);
        Self {
            version: env!("CARGO_PKG_VERSION"),
            scene: scene.name().to_owned(),
            figure: figure.name().to_owned(),
            dofs: figure.layout().nv(),
            duration_s: scene.settings().duration,
            rate_per_s: scene.settings().rate,
            frames: simulated.motion.len(),
            run,
            ground: simulated.reactions.clone().map(Reactions),
            nearest_limbs,
            remarks: remarks.iter().map(told).chain(overlaps).collect(),
        }
    }

    pub(super) fn write(&self, writer: &mut dyn Write) -> std::io::Result<()> {
        write_json(writer, self)
    }
}

/// A remark, with what can be done about it.
fn told(remark: &Remark) -> String {
    match remark {
        Remark::StiffNotBuiltIn { .. } => format!("{remark}; for one, {BUILD_STIFF}"),
        _ => remark.to_string(),
    }
}
