//! What is asked of a walk, out of the options.

use crate::args::{DEFAULT_STEPS, Then, key_options};
use crate::error::{CliError, typed};
use clap::ArgMatches;
use solaris::gait::determinants::{Determinants, DoubleSupport, five, three};
use solaris::gait::{
    Extent, InBetween, PARAMETERS, Parameter, STEPS, StyledRequest, ThesisRequest, WalkPart, WalkRequest,
    WalkSegment,
};

/// One stride, and whether it stays on the spot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Looped {
    InPlace,
    Moving,
}

/// Steps of which one in the middle is taken where a stride is to repeat itself.
const LOOPED_STEPS: (usize, usize) = (42, 6);

/// What is asked of the walk.
pub(crate) fn request(matches: &ArgMatches) -> Result<StyledRequest, CliError> {
    let thesis = word(matches, "style") == Some("thesis");
    let determinants = determinants(matches);
    let extent = extent(matches, if thesis { LOOPED_STEPS.1 } else { LOOPED_STEPS.0 })?;
    let left_first = word(matches, "first") == Some("left");
    refuse_others(matches, thesis, determinants)?;
    let [step_frequency, step_length, speed] =
        ["step-frequency", "step-length", "speed"].map(|name| number(matches, name));
    if thesis {
        let names = determinants_options(determinants);
        let given = names.filter(|name| *name != "step-length");
        let parameters = given.filter_map(|name| number(matches, name).map(|value| (name, value)));
        let double_support = match word(matches, "double-support") {
            Some("measured") => Some(DoubleSupport::Measured),
            Some("travel") => None,
            _ => Some(DoubleSupport::Thesis),
        };
        let linear = word(matches, "in-betweens") == Some("linear");
        return Ok(StyledRequest::Thesis(ThesisRequest {
            determinants,
            step_frequency,
            step_length,
            speed,
            extent,
            parameters: parameters.collect(),
            double_support,
            in_between: if linear { InBetween::Linear } else { InBetween::Rest },
            step_width: number(matches, "step-width"),
            sway: number(matches, "sway").unwrap_or_default(),
            left_first,
        }));
    }
    let given = PARAMETERS.iter().filter_map(|p| number(matches, p.name).map(|value| (p.name, value)));
    let mut parameters: Vec<(&'static str, f64)> = given.collect();
    if determinants == Determinants::Three {
        // The determinant that is missing: the pelvis does not turn.
        parameters.push(("rotation", 0.0));
    }
    let turn = number(matches, "turn").unwrap_or_default().to_radians();
    let first = WalkRequest {
        step_frequency,
        step_length,
        speed,
        extent,
        turn,
        left_first,
        parameters,
        ..WalkRequest::default()
    };
    let then = matches.try_get_many::<Then>("then").ok().flatten().unwrap_or_default();
    smooth(&first, then.copied())
}

/// A walk and what comes next: one walk, or several with standing still in between.
fn smooth(first: &WalkRequest, then: impl Iterator<Item = Then>) -> Result<StyledRequest, CliError> {
    let WalkRequest { step_frequency, step_length, speed, .. } = *first;
    // What is left out stays as it was.
    let mut pace = WalkPart { step_frequency, step_length, speed, ..WalkPart::default() };
    let anew = |extent: Extent, turn: f64, pace: &WalkPart| {
        let WalkPart { step_frequency, step_length, speed, .. } = *pace;
        Some(WalkRequest { step_frequency, step_length, speed, extent, turn, ..first.clone() })
    };
    let (mut stages, mut walk) = (Vec::new(), Some(first.clone()));
    for next in then {
        if let Then::Steps(part) | Then::Distance(_, part) = next
            && part.step_frequency.or(part.step_length).or(part.speed).is_some()
        {
            pace = part;
        }
        match (next, &mut walk) {
            (Then::Stand(time), _) => {
                stages.extend(walk.take().map(WalkSegment::Walk));
                stages.push(WalkSegment::Stand(time));
            }
            (Then::Steps(part), Some(walk)) => walk.then.push(part),
            (Then::Steps(part), None) => walk = anew(Extent::Steps(part.steps), part.turn, &pace),
            (Then::Distance(distance, part), None) => {
                walk = anew(Extent::Distance(distance), part.turn, &pace);
            }
            (Then::Distance(distance, _), Some(_)) => {
                return Err(CliError::Usage(format!(
                    "--then distance={distance}: a distance is met from standing to standing; say --then stand=1 before it, or count \
                     steps"
                )));
            }
        }
    }
    stages.extend(walk.map(WalkSegment::Walk));
    Ok(match stages.pop() {
        Some(WalkSegment::Walk(walk)) if stages.is_empty() => StyledRequest::Smooth(walk),
        last => StyledRequest::Sequence(stages.into_iter().chain(last).collect()),
    })
}

/// How one stride is to be repeated, if it is.
pub(super) fn looped(matches: &ArgMatches) -> Option<Looped> {
    word(matches, "loop").map(|how| if how == "in-place" { Looped::InPlace } else { Looped::Moving })
}

/// How many determinants are asked for.
pub(super) fn determinants(matches: &ArgMatches) -> Determinants {
    if word(matches, "determinants") == Some("3") { Determinants::Three } else { Determinants::Five }
}

fn determinants_options(determinants: Determinants) -> impl Iterator<Item = &'static str> {
    let parameters = match determinants {
        Determinants::Three => three::PARAMETERS,
        Determinants::Five => &five::PARAMETERS[..],
    };
    parameters.iter().map(|parameter| parameter.name)
}

fn extent(matches: &ArgMatches, looped_steps: usize) -> Result<Extent, CliError> {
    if looped(matches).is_some() {
        return Ok(Extent::Steps(looped_steps));
    }
    if let Some(distance) = number(matches, "distance") {
        return Ok(Extent::Distance(distance));
    }
    let steps = matches.get_one::<i64>("steps").copied().unwrap_or(DEFAULT_STEPS);
    let in_range = usize::try_from(steps).ok().filter(|steps| (STEPS.0..=STEPS.1).contains(steps));
    let why = || format!("it must be {} to {}", STEPS.0, STEPS.1);
    Ok(Extent::Steps(in_range.ok_or_else(|| out_of_range(matches, "steps", why()))?))
}

/// Refuses options of the other style and of the other number of determinants.
fn refuse_others(matches: &ArgMatches, thesis: bool, determinants: Determinants) -> Result<(), CliError> {
    let own: Vec<&str> = determinants_options(determinants).collect();
    let style = if thesis { "thesis" } else { "smooth" };
    let has = |name: &str| {
        if thesis {
            own.contains(&name) || name == "step-width"
        } else {
            (Parameter::named(name).is_some() || name == "step-length")
                && !(determinants == Determinants::Three && name == "rotation")
        }
    };
    let all = PARAMETERS.iter().map(|parameter| parameter.name).chain(key_options());
    let count = determinants.count();
    let mut given = all.filter(|name| typed(matches, name).is_some());
    if let Some(name) = given.find(|name| !has(name)) {
        let why = format!("the style '{style}' of {count} determinants has no such parameter");
        return Err(out_of_range(matches, name, why));
    }
    let (others, other) = if thesis {
        (&["turn", "then"][..], "smooth")
    } else {
        (&["in-betweens", "double-support", "sway"][..], "thesis")
    };
    match others.iter().find(|name| typed(matches, name).is_some()) {
        Some(name) => Err(out_of_range(matches, name, format!("only --style {other} has this"))),
        None => Ok(()),
    }
}

pub(super) fn number(matches: &ArgMatches, name: &str) -> Option<f64> {
    matches.try_get_one::<f64>(name).ok().flatten().copied()
}

fn word<'a>(matches: &'a ArgMatches, name: &str) -> Option<&'a str> {
    matches.try_get_one::<String>(name).ok().flatten().map(String::as_str)
}

pub(super) fn out_of_range(matches: &ArgMatches, option: &str, why: String) -> CliError {
    CliError::Option { option: option.to_owned(), value: typed(matches, option).unwrap_or_default(), why }
}
