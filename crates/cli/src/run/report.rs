//! The report of a run, as it is written to JSON.

use super::BUILD_STIFF;
use super::contact::Contact;
use super::energy::Energies;
use super::outcomes::{Hit, Told};
use crate::limbs::Limbs;
use crate::print::write_json;
use serde::Serialize;
use solaris::analysis::ReactionReport;
use solaris::dynamics::scalar::Operations;
use solaris::modes::{PhaseReport, Remark, RunReport};
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
    pub(super) method: String,
    pub(super) why: String,
    pub(super) error: Option<Error>,
    pub(super) cost: Cost,
    pub(super) energy: Energies,
    pub(super) drives: Vec<Told>,
    pub(super) impacts: Vec<Hit>,
    pub(super) phases: Vec<Phase>,
    /// What the ground of the scene did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) contact: Option<Contact>,
    /// What the ground does under a walk.
    pub(super) ground: Option<Ground>,
    /// How near limbs came to each other, where there are any to measure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) nearest_limbs: Option<Limbs>,
    pub(super) remarks: Vec<String>,
}

/// How far off the run may be.
#[derive(Debug, Serialize)]
pub(super) struct Error {
    /// In rad or m.
    pub(super) position: f64,
    /// In rad/s or m/s.
    pub(super) velocity: f64,
}

#[derive(Debug, Serialize)]
pub(super) struct Cost {
    pub(super) evaluations: u64,
    pub(super) jacobians: u64,
    pub(super) steps: u64,
    pub(super) rejected_steps: u64,
    pub(super) events: u64,
    pub(super) seconds: Option<f64>,
}

/// What was computed in a part of the run.
#[derive(Debug, Serialize)]
pub(super) struct Phase {
    pub(super) start_s: f64,
    pub(super) end_s: f64,
    pub(super) dynamic: Vec<String>,
    pub(super) prescribed: Vec<String>,
    pub(super) fused: Vec<String>,
    pub(super) dropped_links: Vec<String>,
    pub(super) operations_of_all: u64,
    pub(super) operations: u64,
    pub(super) omitted: Vec<String>,
}

/// What the ground does under a walk.
#[derive(Debug, Serialize)]
pub(super) struct Ground {
    pub(super) double_support_split: &'static str,
    pub(super) root_residual_n: f64,
    pub(super) root_residual_n_m: f64,
    pub(super) from_prescribed_n: Option<f64>,
    pub(super) cop_from_nominal_m: f64,
}

impl Report {
    pub(super) fn new(scene: &Scene, simulated: &Simulated, limbs: Option<Limbs>) -> Self {
        let (figure, motion) = (scene.figure(), &simulated.motion);
        let RunReport {
            method,
            why,
            counts,
            seconds,
            error,
            energy,
            outcomes,
            impacts,
            ground,
            phases,
            remarks,
        } = simulated.report.clone();
        let remarks = remarks.iter().map(told).chain(limbs.as_ref().and_then(Limbs::overlap_note)).collect();
        Self {
            version: env!("CARGO_PKG_VERSION"),
            scene: scene.name().to_owned(),
            figure: figure.name().to_owned(),
            dofs: figure.layout().nv(),
            duration_s: scene.settings().duration,
            rate_per_s: scene.settings().rate,
            frames: motion.len(),
            method,
            why,
            error: error.map(|error| Error { position: error.position, velocity: error.velocity }),
            cost: Cost {
                evaluations: counts.evaluations,
                jacobians: counts.jacobians,
                steps: counts.steps,
                rejected_steps: counts.rejected,
                events: counts.events,
                seconds,
            },
            energy: Energies::of(&energy),
            drives: outcomes.iter().map(|outcome| Told::of(figure, outcome)).collect(),
            impacts: impacts.iter().map(|impact| Hit::of(figure, impact)).collect(),
            phases: phases.into_iter().map(Phase::of).collect(),
            contact: ground.map(Contact::of),
            ground: simulated.reactions.as_ref().map(Ground::of),
            nearest_limbs: limbs,
            remarks,
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

impl Phase {
    fn of(phase: PhaseReport) -> Self {
        let PhaseReport { start, end, dynamic, prescribed, fused, dropped, cost, omitted } = phase;
        Self {
            start_s: start,
            end_s: end,
            dynamic,
            prescribed,
            fused,
            dropped_links: dropped,
            operations_of_all: total(cost.0),
            operations: total(cost.1),
            omitted,
        }
    }
}

impl Phase {
    /// Whether the same is computed and the same left out.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let names = |phase: &Self| {
            [&phase.dynamic, &phase.prescribed, &phase.fused, &phase.dropped_links, &phase.omitted]
                .map(Clone::clone)
        };
        names(self) == names(other) && self.operations == other.operations
    }
}

/// All operations, each counted once.
fn total(operations: Operations) -> u64 {
    let Operations { multiplications, additions, divisions, sines } = operations;
    multiplications + additions + divisions + sines
}

impl Ground {
    fn of(report: &ReactionReport) -> Self {
        Self {
            double_support_split: report.split,
            root_residual_n: report.root_residual.0,
            root_residual_n_m: report.root_residual.1,
            from_prescribed_n: report.from_prescribed.map(|(off, _)| off),
            cop_from_nominal_m: report.cop_from_nominal.0,
        }
    }
}
