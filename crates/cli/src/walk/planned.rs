//! A planned walk with its forces, whatever its style.

use super::request::{Looped, determinants};
use super::told::{BesideKeyPostures, BesidePosture, Forces, KeyPostures, Pull, roots};
use crate::error::CliError;
use crate::progress::Progress;
use clap::ArgMatches;
use solaris::analysis::reactions_from_feet;
use solaris::gait::determinants::{Condition, Determinants, KeyParameter};
use solaris::gait::{FEET, PostureComparison, StyledPlan, StyledRequest, WalkForces, on_the_spot};
use solaris::model::{Figure, Motion};
use std::time::{Duration, Instant};

/// A walk with its forces.
pub(super) struct Planned {
    pub(super) plan: StyledPlan,
    pub(super) motion: Motion,
    pub(super) forces: Forces,
    /// Whether it is one stride that repeats itself.
    pub(super) repeats: bool,
    /// Whether pace or direction change on the way.
    pub(super) changes: bool,
    pub(super) beside: Option<BesideKeyPostures>,
    /// How long planning took, and all with the forces.
    pub(super) planning: Duration,
    pub(super) solving: Duration,
}

/// The name of a plan's style.
pub(super) fn style(plan: &StyledPlan) -> &'static str {
    match plan {
        StyledPlan::Smooth(_) | StyledPlan::Sequence(_) => "smooth",
        StyledPlan::Thesis(_) => "thesis",
    }
}

/// The postures of the thesis's style.
pub(super) fn postures(plan: &StyledPlan) -> Option<KeyPostures> {
    let StyledPlan::Thesis(plan) = plan else { return None };
    let parameters = plan.determinants.parameters(&plan.proportions);
    let named = |(parameter, value): (&KeyParameter, &f64)| {
        (parameter.name, parameter.symbol, *value, parameter.unit.trim())
    };
    Some(KeyPostures {
        determinants: plan.determinants.count(),
        parameters: parameters.iter().zip(&plan.postures.values).map(named).collect(),
        angles_deg: plan.postures.angles.iter().map(|(s, what, x)| (*s, *what, x.to_degrees())).collect(),
        remarks: plan.postures.remarks.iter().filter(|r| !r.holds()).map(Condition::to_string).collect(),
    })
}

impl Planned {
    /// Plans, samples, and finds the forces.
    pub(super) fn of(
        figure: &Figure,
        request: &StyledRequest,
        looped: Option<Looped>,
        rate: f64,
        progress: &Progress,
        matches: &ArgMatches,
    ) -> Result<Self, CliError> {
        let start = Instant::now();
        progress.stage("planning the walk");
        let refuse = |error| CliError::of_gait(error, matches);
        let plan = StyledPlan::of(figure, request).map_err(refuse)?;
        let planning = start.elapsed();
        super::check_size(if looped.is_some() { 1.0 } else { plan.duration() }, rate)?;
        progress.stage("finding the forces");
        let found = match looped {
            None => plan.loaded(figure, rate),
            Some(_) => plan.loaded_stride(figure, rate),
        };
        let (mut motion, found) = found.map_err(CliError::other)?;
        let mut forces = forces(&found);
        if matches.get_one::<String>("root").is_some_and(|root| root == "foot") {
            let rooted = reactions_from_feet(figure, &mut motion, FEET).map_err(CliError::other)?;
            forces.roots = Some(roots(&rooted));
        }
        if looped == Some(Looped::InPlace) {
            motion = on_the_spot(figure, &motion).map_err(CliError::other)?;
        }
        // One stride has its own clock.
        let beside = if looped.is_none() { beside(&plan, determinants(matches)) } else { None };
        Ok(Self {
            plan,
            motion,
            forces,
            repeats: looped.is_some(),
            changes: match request {
                StyledRequest::Smooth(walk) => !walk.then.is_empty(),
                StyledRequest::Sequence(_) => true,
                StyledRequest::Thesis(_) => false,
            },
            beside,
            planning,
            solving: start.elapsed(),
        })
    }
}

/// A smooth walk beside the key postures of the same step, where such a step has any.
fn beside(plan: &StyledPlan, determinants: Determinants) -> Option<BesideKeyPostures> {
    let plan = plan.smooth()?;
    let posture = |beside: PostureComparison| {
        let [a, b, c, d, e, f] = beside.deviations().map(f64::to_degrees);
        BesidePosture { posture: beside.name, at_s: beside.time, stance_deg: [a, b, c], swing_deg: [d, e, f] }
    };
    let postures = plan.compare_postures(determinants).ok()?.into_iter().map(posture).collect();
    Some(BesideKeyPostures { determinants: determinants.count(), postures })
}

/// What is told of the forces.
fn forces(found: &WalkForces) -> Forces {
    match found {
        WalkForces::Prescribed(report) => Forces {
            double_support_split: report.split,
            root_residual_n: report.root_residual.0,
            root_residual_n_m: report.root_residual.1,
            from_prescribed_n: report.from_prescribed.map(Into::into),
            cop_from_prescribed_m: Some(report.cop_from_nominal.into()),
            pulls: None,
            roots: None,
        },
        WalkForces::Needed(report, residual) => {
            let least = report.feet.iter().filter_map(|foot| foot.least);
            let least = least.min_by(|a, b| a.value.total_cmp(&b.value));
            Forces {
                double_support_split: report.split.name(),
                root_residual_n: residual.force,
                root_residual_n_m: residual.moment,
                from_prescribed_n: None,
                cop_from_prescribed_m: None,
                pulls: least.filter(|least| least.value < 0.0).map(|least| Pull {
                    least_percent_bw: 100.0 * least.value / report.weight,
                    at_s: least.time,
                    share_of_stance: least.share,
                }),
                roots: None,
            }
        }
    }
}
