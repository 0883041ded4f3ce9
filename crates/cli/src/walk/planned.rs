//! A planned walk with its forces, whatever its style.

use super::request::Asked;
use super::told::{BesideKeyPostures, Forces, KeyPostures};
use crate::args::{Loop, RATE, RootLink, WalkArgs};
use crate::error::CliError;
use crate::planned_files::check_size;
use crate::progress::Progress;
use solaris::analysis::reactions_from_feet;
use solaris::gait::determinants::{Condition, Determinants, KeyParameter};
use solaris::gait::{
    Extent, FEET, GaitError, SteadyRun, StyledPlan, StyledRequest, WalkGround, WalkRequest, on_the_spot,
};
use solaris::model::{Figure, Motion};
use std::time::{Duration, Instant};

/// What is known of a walk with its forces, besides the motion.
pub(super) struct Planned {
    pub(super) plan: StyledPlan,
    pub(super) forces: Forces,
    /// Whether it is one stride that repeats itself.
    pub(super) repeats: bool,
    /// Steps a minute that were asked for; a stride of whole frames may have others.
    pub(super) asked_frequency: f64,
    /// The greatest flexion of the swinging knee (degrees) that was asked for, and that of the walk.
    pub(super) swinging_knee: Option<[f64; 2]>,
    /// The distance (m) that was asked for over ground where feet have to find places.
    pub(super) asked_distance: Option<f64>,
    /// Whether pace or direction change on the way.
    pub(super) changes: bool,
    pub(super) beside: Option<BesideKeyPostures>,
    /// How much of the manner and of the variability is walked, where all of it would not hold, and why.
    pub(super) in_part: Option<(f64, String)>,
    /// A steady stride of a run.
    pub(super) running: Option<SteadyRun>,
    /// Whether the root turns by its heading first, as nobody asked for.
    pub(super) heading_first: bool,
    /// How long planning took, and all with the forces.
    pub(super) planning: Duration,
    pub(super) solving: Duration,
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
    /// Plans, samples, and finds the forces, which are in the motion.
    pub(super) fn of(
        figure: &mut Figure,
        asked: &Asked,
        args: &WalkArgs,
        progress: &Progress,
    ) -> Result<(Self, Motion), CliError> {
        let (looped, rate) = (args.manner.repeats, args.extent.rate.unwrap_or(RATE.0));
        let start = Instant::now();
        progress.stage("planning the walk");
        let mut in_part = None;
        let mut plan_of = |figure: &Figure, request: &StyledRequest| -> Result<_, GaitError> {
            let (plan, part) = StyledPlan::as_far_as_it_holds(figure, request)?;
            in_part = part.map(|(part, why)| (part, why.to_string()));
            Ok(plan)
        };
        let mut heading_first = false;
        let refuse = |error| asked.refuse(error, args);
        let mut plan = match plan_of(figure, &asked.request) {
            Err(error) if error.turns_too_far() && args.who.figure.is_none() => {
                *figure = super::heading_first(&args.who.person)?;
                heading_first = true;
                plan_of(figure, &asked.request).map_err(refuse)?
            }
            found => found.map_err(refuse)?,
        };
        let figure = &*figure;
        let asked_frequency = plan.step_frequency();
        let in_step = || asked.request.in_step(plan.stature(), asked_frequency, rate);
        if let Some(request) = looped.and(args.extent.rate).and_then(|_| in_step()) {
            plan = plan_of(figure, &request).map_err(refuse)?;
        }
        let planning = start.elapsed();
        check_size(if looped.is_some() { 1.0 } else { plan.duration() }, rate)?;
        progress.stage("finding the forces");
        let found = match looped {
            None => plan.loaded(figure, rate),
            Some(_) => plan.loaded_stride(figure, rate),
        };
        let (mut motion, found) = found.map_err(CliError::other)?;
        // As it was asked for, but for rounding.
        if (motion.info.rate / rate - 1.0).abs() < 1e-9 {
            motion.info.rate = rate;
        }
        let mut forces = Forces { found, roots: None };
        if args.manner.root == RootLink::Foot {
            let rooted = reactions_from_feet(figure, &mut motion, FEET).map_err(CliError::other)?;
            forces.roots = Some(rooted);
        }
        if looped == Some(Loop::InPlace) {
            motion = on_the_spot(figure, &motion).map_err(CliError::other)?;
        }
        let running = plan.steady_run(figure).map_err(CliError::other)?;
        // One stride has its own clock.
        let beside = if looped.is_none() { beside(&plan, args.manner.determinants.into()) } else { None };
        let planned = Self {
            plan,
            forces,
            repeats: looped.is_some(),
            asked_frequency,
            swinging_knee: asked_knee(&asked.request).zip(greatest_knee(figure, &motion)).map(Into::into),
            asked_distance: match &asked.request {
                StyledRequest::Smooth(WalkRequest {
                    ground: WalkGround::Relief(_),
                    extent: Extent::Distance(distance),
                    then,
                    ..
                }) if then.is_empty() => Some(*distance),
                _ => None,
            },
            changes: match &asked.request {
                StyledRequest::Smooth(walk) => !walk.then.is_empty() || walk.path.is_some(),
                StyledRequest::Sequence(_) => true,
                StyledRequest::Run(run) => !run.then.is_empty(),
                StyledRequest::Thesis(_) => false,
            },
            beside,
            in_part,
            running,
            heading_first,
            planning,
            solving: start.elapsed(),
        };
        Ok((planned, motion))
    }
}

/// A smooth walk beside the key postures of the same step, where such a step has any.
fn beside(plan: &StyledPlan, determinants: Determinants) -> Option<BesideKeyPostures> {
    let plan = plan.smooth().filter(|plan| !plan.is_backward())?;
    let postures = plan.compare_postures(determinants).ok()?;
    Some(BesideKeyPostures { determinants: determinants.count(), postures })
}

/// The greatest flexion of the swinging knee (degrees) that a request asks for.
fn asked_knee(request: &StyledRequest) -> Option<f64> {
    let StyledRequest::Smooth(walk) = request else { return None };
    walk.parameters.iter().find(|(name, _)| *name == "swing-knee").map(|(_, knee)| *knee)
}

/// The greatest flexion (degrees) of both knees in a motion.
fn greatest_knee(figure: &Figure, motion: &Motion) -> Option<f64> {
    let knees = ["left_knee.flexion", "right_knee.flexion"];
    let angles = knees.iter().filter_map(|name| figure.anatomical_angle(name));
    let bent = angles
        .flat_map(|angle| (0..motion.len()).map(move |row| angle.sign * motion.q(row)[angle.coordinate]));
    bent.map(f64::to_degrees).reduce(f64::max)
}
