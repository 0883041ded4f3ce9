//! A planned walk with its forces, whatever its style.

use super::report::{Forces, KeyPostures, Pull, roots};
use super::request::{Looped, Request};
use crate::error::CliError;
use crate::progress::Progress;
use clap::ArgMatches;
use solaris::gait::determinants::{Condition, KeyParameter};
use solaris::gait::{FEET, StrideLoop, ThesisWalk, WalkPlan, on_the_spot, thesis_walk, walk};
use solaris::model::{Figure, Motion, Trajectory};
use solaris::modes::ground::{GroundReport, Split, reactions_of_planted};
use solaris::modes::{ReactionReport, SupportLaw, ground_reactions, reactions_from_feet};
use std::time::{Duration, Instant};

/// The plan of a style.
pub(super) enum Plan {
    Smooth(WalkPlan),
    Thesis(Box<ThesisWalk>),
}

/// A walk with its forces.
pub(super) struct Planned {
    pub(super) plan: Plan,
    pub(super) motion: Motion,
    pub(super) forces: Forces,
    /// How long planning took, and all with the forces.
    pub(super) planned: Duration,
    pub(super) solved: Duration,
}

impl Plan {
    pub(super) fn step_frequency(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.style().step_frequency,
            Self::Thesis(plan) => plan.step_frequency,
        }
    }

    pub(super) fn step_length(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.style().step_length,
            Self::Thesis(plan) => plan.step_length,
        }
    }

    pub(super) fn stature(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.stature(),
            Self::Thesis(plan) => plan.proportions.height,
        }
    }

    pub(super) fn style(&self) -> &'static str {
        match self {
            Self::Smooth(_) => "smooth",
            Self::Thesis(_) => "thesis",
        }
    }

    /// The postures of the thesis's style.
    pub(super) fn postures(&self) -> Option<KeyPostures> {
        let Self::Thesis(plan) = self else { return None };
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

    fn duration(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.duration(),
            Self::Thesis(plan) => plan.walk.duration(),
        }
    }
}

impl Planned {
    /// Plans, samples, and finds the forces.
    pub(super) fn of(
        figure: &Figure,
        request: &Request,
        looped: Option<Looped>,
        rate: f64,
        progress: &Progress,
        matches: &ArgMatches,
    ) -> Result<Self, CliError> {
        let start = Instant::now();
        progress.stage("planning the walk");
        let refuse = |error| CliError::of_gait(error, matches);
        let plan = match request {
            Request::Smooth(request) => Plan::Smooth(walk(figure, request).map_err(refuse)?),
            Request::Thesis(request) => Plan::Thesis(Box::new(thesis_walk(figure, request).map_err(refuse)?)),
        };
        let planned = start.elapsed();
        super::check_size(if looped.is_some() { 1.0 } else { plan.duration() }, rate)?;
        progress.stage("finding the forces");
        let (mut motion, mut forces) = match (&plan, looped) {
            (Plan::Smooth(plan), None) => {
                let motion = plan.motion(figure, rate).map_err(CliError::other)?;
                smooth(figure, motion, plan)?
            }
            (Plan::Smooth(plan), Some(_)) => {
                let stride = plan.stride_loop().ok_or_else(no_stride)?;
                let motion = stride.balanced_motion(figure, rate).map_err(CliError::other)?;
                smooth(figure, motion, &stride)?
            }
            (Plan::Thesis(plan), None) => {
                planted(figure, plan.walk.motion(figure, rate).map_err(CliError::other)?)?
            }
            (Plan::Thesis(plan), Some(_)) => {
                let stride: StrideLoop<'_, _> = plan.walk.stride_loop().ok_or_else(no_stride)?;
                planted(figure, stride.motion(figure, rate).map_err(CliError::other)?)?
            }
        };
        if matches.get_one::<String>("root").is_some_and(|root| root == "foot") {
            let rooted = reactions_from_feet(figure, &mut motion, FEET).map_err(CliError::other)?;
            forces.roots = Some(roots(&rooted));
        }
        if looped == Some(Looped::InPlace) {
            motion = on_the_spot(figure, &motion).map_err(CliError::other)?;
        }
        Ok(Self { plan, motion, forces, planned, solved: start.elapsed() })
    }
}

fn no_stride() -> CliError {
    CliError::Other("the walk has no stride that repeats itself; this is a fault of the program".into())
}

/// Forces that a plan prescribes.
fn smooth(figure: &Figure, mut motion: Motion, law: &impl SupportLaw) -> Result<(Motion, Forces), CliError> {
    let found = ground_reactions(figure, &mut motion, FEET, law).map_err(CliError::other)?;
    let ReactionReport { split, root_residual, from_prescribed, cop_from_nominal } = found;
    let forces = Forces {
        double_support_split: split,
        root_residual_n: root_residual.0,
        root_residual_n_m: root_residual.1,
        from_prescribed_n: from_prescribed.map(Into::into),
        cop_from_prescribed_m: Some(cop_from_nominal.into()),
        pulls: None,
        roots: None,
    };
    Ok((motion, forces))
}

/// Forces that a motion needs, whatever they are.
fn planted(figure: &Figure, mut motion: Motion) -> Result<(Motion, Forces), CliError> {
    let split = Split::default();
    let (report, residual) = reactions_of_planted(figure, &mut motion, split).map_err(CliError::other)?;
    let GroundReport { feet, weight, .. } = report;
    let least = feet.iter().filter_map(|foot| foot.least).min_by(|a, b| a.value.total_cmp(&b.value));
    let pulls = least.filter(|least| least.value < 0.0).map(|least| Pull {
        least_percent_bw: 100.0 * least.value / weight,
        at_s: least.time,
        share_of_stance: least.share,
    });
    let forces = Forces {
        double_support_split: split.name(),
        root_residual_n: residual.force,
        root_residual_n_m: residual.moment,
        from_prescribed_n: None,
        cop_from_prescribed_m: None,
        pulls,
        roots: None,
    };
    Ok((motion, forces))
}
