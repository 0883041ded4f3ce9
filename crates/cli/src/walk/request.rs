//! The walk that is asked for, out of the options.

mod path;
mod refused;
mod terrain;

use super::everyone::dressed;
use crate::args::{
    DEFAULT_STEPS, DoubleSupportLaw, Gait, InBetweens, Loop, Number, PaceArgs, PersonArgs, RunBound, Side,
    StyleName, Then, WalkArgs,
};
use crate::error::{CliError, Typed, UsageError};
use refused::refuse_others;
use solaris::gait::determinants::{Determinants, DoubleSupport};
use solaris::gait::{
    DEFAULT_RUN_SPEED, DEFAULT_STEP_FREQUENCY, Extent, GaitError, InBetween, Next, PARAMETERS, RequestError,
    RunEnd, RunPart, RunRequest, STEPS, Staged, StyledRequest, ThesisRequest, WalkPart, WalkRequest,
    least_run_steps, stages,
};
use solaris::model::Figure;

/// Steps of which one in the middle is taken where a stride is to repeat itself.
const LOOPED_STEPS: (usize, usize) = (42, 6);
const LOOPED_RUN: usize = 2;
/// What standing, the first and the closing step add to the time of a walk's steps (s), at the usual step frequency.
const BEGINNING_AND_END: f64 = 2.6;

/// A walk as the library takes it.
pub(crate) struct Asked {
    pub(crate) request: StyledRequest,
    /// Of each stage, and of each part of it, the `--then` that asked for it; none of what stands before the first.
    origins: Vec<Vec<Option<String>>>,
}

impl Asked {
    /// Of a figure: unless something else is asked for, the foot that its cane helps goes first.
    pub(crate) fn of(self, figure: &Figure, args: &WalkArgs) -> Self {
        if args.manner.first.is_some() {
            return self;
        }
        Self { request: self.request.helped_foot_first(figure), ..self }
    }
}

/// What is asked of the walk.
pub(crate) fn asked(args: &WalkArgs) -> Result<Asked, CliError> {
    check(args)?;
    let determinants: Determinants = args.manner.determinants.into();
    refuse_others(args, determinants)?;
    if args.manner.style == StyleName::Thesis {
        let request = StyledRequest::Thesis(thesis(args, determinants));
        return Ok(Asked { request, origins: Vec::new() });
    }
    if args.manner.gait == Gait::Run {
        return running(args);
    }
    let pace = &args.pace;
    let mut parameters: Vec<(&'static str, f64)> =
        PARAMETERS.iter().filter_map(|p| Some((p.name, args.style.0.get(p.name)?.value))).collect();
    if determinants == Determinants::Three {
        // The determinant that is missing: the pelvis does not turn.
        parameters.push(("rotation", 0.0));
    }
    let path = args.changes.path.as_deref().map(path::read).transpose()?;
    let turn = value(args.changes.turn.as_ref()).unwrap_or_default().to_radians();
    // The inner foot opens a turn.
    let inner = if turn > 0.0 || path.as_ref().is_some_and(|path| path.begins() > 0.0) {
        Side::Left
    } else {
        Side::Right
    };
    let ground = terrain::of(&args.ground)?;
    let usual = ground.usual_step_frequency();
    let open = pace.step_length.is_none() && pace.speed.is_none();
    let first = WalkRequest {
        ground,
        step_frequency: value(pace.step_frequency.as_ref()).or(usual.filter(|_| open)),
        step_length: value(pace.step_length.as_ref()),
        speed: value(pace.speed.as_ref()),
        extent: extent(args, LOOPED_STEPS.0),
        turn,
        backward: args.changes.backward,
        path,
        left_first: args.manner.first.unwrap_or(inner) == Side::Left,
        parameters,
        ..WalkRequest::default()
    };
    let first = dressed(first, &args.everyone)?;
    if let (Some((option, typed)), Some(_)) = (args.everyone.uneven(), args.manner.repeats) {
        let why = "one stride that repeats itself has no steps that differ; leave out --loop, or this";
        return Err(CliError::option(option, typed, why));
    }
    smooth(&first, &args.changes.then)
}

/// Refuses options that contradict each other.
fn check(args: &WalkArgs) -> Result<(), UsageError> {
    let (pace, extent) = (&args.pace, &args.extent);
    if let (Some(frequency), Some(length), Some(speed)) =
        (&pace.step_frequency, &pace.step_length, &pace.speed)
    {
        let [step_frequency, step_length, speed] = [frequency, length, speed].map(|n| n.typed.clone());
        return Err(UsageError::Overdetermined { step_frequency, step_length, speed });
    }
    if let Some(duration) = &extent.duration {
        let step_frequency = value(pace.step_frequency.as_ref()).unwrap_or(DEFAULT_STEP_FREQUENCY);
        let steps = ((duration.value - BEGINNING_AND_END) * step_frequency / 60.0).round();
        let steps = steps.clamp(STEPS.0 as f64, STEPS.1 as f64) as usize;
        return Err(UsageError::Duration { typed: duration.typed.clone(), step_frequency, steps });
    }
    // Until a body stands, more steps follow.
    let next = args.changes.then.first().filter(|then| !matches!(then.what, Next::Stand(_)));
    if let (Some(distance), Some(then)) = (&extent.distance, next) {
        let (distance, then) = (distance.typed.clone(), then.typed.clone());
        return Err(UsageError::DistanceThenMore { distance, then });
    }
    Ok(())
}

/// A walk through key postures.
fn thesis(args: &WalkArgs, determinants: Determinants) -> ThesisRequest {
    let (pace, manner) = (&args.pace, &args.manner);
    let names = refused::key_parameters(determinants).iter().map(|parameter| parameter.name);
    let given = names.filter(|name| *name != "step-length");
    ThesisRequest {
        determinants,
        step_frequency: value(pace.step_frequency.as_ref()),
        step_length: value(pace.step_length.as_ref()),
        speed: value(pace.speed.as_ref()),
        extent: extent(args, LOOPED_STEPS.1),
        parameters: given.filter_map(|name| Some((name, args.style.0.get(name)?.value))).collect(),
        double_support: match manner.double_support {
            None | Some(DoubleSupportLaw::Thesis) => Some(DoubleSupport::Thesis),
            Some(DoubleSupportLaw::Measured) => Some(DoubleSupport::Measured),
            Some(DoubleSupportLaw::Travel) => None,
        },
        in_between: match manner.in_betweens {
            None | Some(InBetweens::Rest) => InBetween::Rest,
            Some(InBetweens::Linear) => InBetween::Linear,
        },
        step_width: value(args.style.0.get("step-width")),
        sway: value(manner.sway.as_ref()).unwrap_or_default(),
        left_first: manner.first == Some(Side::Left),
    }
}

/// A run, and the speeds that come next.
fn running(args: &WalkArgs) -> Result<Asked, CliError> {
    let bound = |end: &Option<RunBound>| end.as_ref().map_or(RunEnd::Running, |bound| bound.end);
    let (from, to) = (bound(&args.manner.from), bound(&args.manner.to));
    let speed = value(args.pace.speed.as_ref()).unwrap_or(DEFAULT_RUN_SPEED);
    let (mut parts, mut origins) = (Vec::new(), vec![None]);
    for Then { what, typed } in &args.changes.then {
        let Next::Steps(WalkPart {
            steps,
            step_frequency: None,
            step_length: None,
            speed: Some(speed),
            turn,
            backward: false,
        }) = *what
        else {
            return Err(UsageError::NotOfRuns { typed: typed.clone() }.into());
        };
        if turn != 0.0 {
            return Err(UsageError::NotOfRuns { typed: typed.clone() }.into());
        }
        parts.push(RunPart { steps, speed });
        origins.push(Some(typed.clone()));
    }
    let extent = match extent(args, LOOPED_RUN) {
        // As many as it takes to reach its speed, where it is not said how many.
        Extent::Steps(steps) if args.extent.steps.is_none() && args.manner.repeats.is_none() => {
            let to = if parts.is_empty() { to } else { RunEnd::Running };
            Extent::Steps(steps.max(least_run_steps(speed, from, to)))
        }
        extent => extent,
    };
    let left_first = args.manner.first == Some(Side::Left);
    let usual = RunRequest::default();
    let (forefoot, give) = (args.manner.forefoot, args.manner.give.unwrap_or(usual.give));
    let request = RunRequest { speed, extent, then: parts, from, to, left_first, forefoot, give, ..usual };
    Ok(Asked { request: StyledRequest::Run(request), origins: vec![origins] })
}

/// A walk and what comes next: one walk, or several with standing still in between.
fn smooth(first: &WalkRequest, then: &[Then]) -> Result<Asked, CliError> {
    let next: Vec<Next> = then.iter().map(|then| then.what).collect();
    let Staged { request, origins } = stages(first, &next).map_err(|error| match error {
        RequestError::DistanceOnTheWay { number, .. } => {
            UsageError::DistanceOnTheWay { typed: then[number - 1].typed.clone() }.into()
        }
        RequestError::BackwardOnTheWay { number } => {
            UsageError::BackwardOnTheWay { typed: then[number - 1].typed.clone() }.into()
        }
        error => CliError::other(error),
    })?;
    let typed = |origin: Option<usize>| Some(then.get(origin?)?.typed.clone());
    let origins = origins.into_iter().map(|parts| parts.into_iter().map(typed).collect()).collect();
    Ok(Asked { request, origins })
}

fn extent(args: &WalkArgs, looped_steps: usize) -> Extent {
    match (args.manner.repeats, &args.extent.distance) {
        (Some(Loop::InPlace | Loop::Moving), _) => Extent::Steps(looped_steps),
        (None, Some(distance)) => Extent::Distance(distance.value),
        (None, None) => Extent::Steps(args.extent.steps.unwrap_or(DEFAULT_STEPS)),
    }
}

fn value(number: Option<&Number>) -> Option<f64> {
    number.map(|number| number.value)
}

impl Asked {
    /// Why there is no such walk, said of the options or of the `--then` that asks for it.
    pub(crate) fn refuse(&self, error: GaitError, args: &WalkArgs) -> CliError {
        self.refuse_in(0, error, args)
    }

    fn refuse_in(&self, stage: usize, error: GaitError, args: &WalkArgs) -> CliError {
        let origin =
            |part: usize| self.origins.get(stage).and_then(|parts| parts.get(part)).cloned().flatten();
        match error {
            GaitError::InSegment { number, why } => self.refuse_in(number.saturating_sub(1), *why, args),
            GaitError::BesideRun { before, why } => {
                let (option, bound) =
                    if before { ("from", &args.manner.from) } else { ("to", &args.manner.to) };
                let typed = bound.as_ref().map_or_else(String::new, |bound| bound.typed.clone());
                CliError::of_part(*why, option, typed)
            }
            GaitError::InPart { number, why } => match origin(number.saturating_sub(1)) {
                Some(then) => CliError::of_then(*why, then),
                None => CliError::of_gait(*why, args),
            },
            error => match origin(0) {
                Some(then) => CliError::of_then(error, then),
                None => CliError::of_gait(error, args),
            },
        }
    }
}

impl Typed for WalkArgs {
    fn typed(&self, name: &str) -> Option<&str> {
        let number = match name {
            "height" => &self.who.person.height,
            "mass" => &self.who.person.mass,
            "step frequency" => &self.pace.step_frequency,
            "step length" => &self.pace.step_length,
            "speed" => &self.pace.speed,
            "distance" => &self.extent.distance,
            "turn" => &self.changes.turn,
            "slope" => &self.ground.slope,
            "rise" => &self.ground.rise,
            "tread" => &self.ground.tread,
            "sway" => &self.manner.sway,
            "variability" => &self.everyone.variability,
            "cane load" => &self.everyone.cane_load,
            other => return Some(&self.style.0.get(&other.replace(' ', "-"))?.typed),
        };
        number.as_ref().map(|number| number.typed.as_str())
    }

    fn pace(&self) -> Vec<(&'static str, &Number)> {
        let PaceArgs { step_frequency, step_length, speed } = &self.pace;
        let all = [("step-frequency", step_frequency), ("step-length", step_length), ("speed", speed)];
        all.into_iter().filter_map(|(name, number)| Some((name, number.as_ref()?))).collect()
    }
}

impl Typed for PersonArgs {
    fn typed(&self, name: &str) -> Option<&str> {
        let number = match name {
            "height" => &self.height,
            "age" => &self.age,
            "mass" => &self.mass,
            _ => return None,
        };
        number.as_ref().map(|number| number.typed.as_str())
    }

    fn pace(&self) -> Vec<(&'static str, &Number)> {
        Vec::new()
    }
}
