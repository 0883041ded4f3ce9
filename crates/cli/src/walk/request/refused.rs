//! Options of the other style, and of the other number of determinants.

use crate::args::{DeterminantCount, Gait, RootLink, RunBound, StyleName, WalkArgs, key_options};
use crate::error::CliError;
use clap::ValueEnum;
use solaris::gait::determinants::{Determinants, KeyParameter, five, three};
use solaris::gait::{Parameter, RunEnd};

/// The parameters of key postures.
pub(super) fn key_parameters(determinants: Determinants) -> &'static [KeyParameter] {
    match determinants {
        Determinants::Three => three::PARAMETERS,
        Determinants::Five => five::PARAMETERS,
    }
}

/// Refuses options of the other style and of the other number of determinants.
pub(super) fn refuse_others(args: &WalkArgs, determinants: Determinants) -> Result<(), CliError> {
    if args.manner.gait == Gait::Run {
        if let Some((option, end)) =
            ends(args).find(|(_, bound)| bound.end != RunEnd::Running && args.manner.repeats.is_some())
        {
            return Err(CliError::option(option, &end.typed, "a stride that repeats is one of full run"));
        }
        let changes =
            ends(args).any(|(_, bound)| bound.end != RunEnd::Running) || !args.changes.then.is_empty();
        if let Some((option, typed, _)) = of_full_runs(args).filter(|_| changes) {
            let why = "a run has this in full run alone, without --from, --to and --then";
            return Err(CliError::option(option, &typed, why));
        }
        return of_walks(args).map_or(Ok(()), |(option, typed)| {
            Err(CliError::option(
                option,
                &typed,
                "a run has no such option: it has --speed, --steps or --distance, --forefoot, --give, --from, --to, --then, --first and --loop",
            ))
        });
    }
    if let Some((option, typed, of_walks)) = of_full_runs(args) {
        return Err(CliError::option(option, &typed, format!("only --gait run has this; {of_walks}")));
    }
    if let Some((option, end)) = ends(args).next() {
        return Err(CliError::option(
            option,
            &end.typed,
            "only --gait run has this; a walk begins and ends in standing",
        ));
    }
    let style = args.manner.style;
    let has = |name: &str| match style {
        StyleName::Thesis => {
            name == "step-width" || key_parameters(determinants).iter().any(|own| own.name == name)
        }
        StyleName::Smooth => {
            (Parameter::named(name).is_some() || name == "step-length")
                && !(determinants == Determinants::Three && name == "rotation")
        }
    };
    let length = args.pace.step_length.as_ref().filter(|_| key_options().contains(&"step-length"));
    let mut given = args.style.0.iter().chain(length.map(|length| ("step-length", length)));
    if let Some((name, number)) = given.find(|(name, _)| !has(name)) {
        let (style, count) = (style.name(), determinants.count());
        let why = format!("the style '{style}' of {count} determinants has no such parameter");
        return Err(CliError::option(name, &number.typed, why));
    }
    let of_other = match style {
        StyleName::Thesis => changes(args),
        StyleName::Smooth => key_postures(args),
    };
    let Some((option, typed)) = of_other else { return Ok(()) };
    let other = match style {
        StyleName::Thesis => StyleName::Smooth,
        StyleName::Smooth => StyleName::Thesis,
    };
    Err(CliError::option(option, typed, format!("only --style {} has this", other.name())))
}

/// What was given that full runs alone have, as it was typed, and what walks do instead.
fn of_full_runs(args: &WalkArgs) -> Option<(&'static str, String, &'static str)> {
    let manner = &args.manner;
    let forefoot = manner.forefoot.then(|| ("forefoot", String::new(), "a walk lands on its heels"));
    let give = manner.give.filter(|give| *give > 0.0);
    forefoot.or_else(|| Some(("give", give?.to_string(), "a walk's soles are rigid")))
}

/// How a run is to begin and to end, where that is said.
fn ends(args: &WalkArgs) -> impl Iterator<Item = (&'static str, &RunBound)> {
    let ends = [("from", &args.manner.from), ("to", &args.manner.to)];
    ends.into_iter().filter_map(|(option, end)| Some((option, end.as_ref()?)))
}

/// What was given that only walks have.
fn of_walks(args: &WalkArgs) -> Option<(&'static str, String)> {
    let manner = &args.manner;
    let pace = [("step-frequency", &args.pace.step_frequency), ("step-length", &args.pace.step_length)];
    let pace = pace.into_iter().find_map(|(name, number)| Some((name, number.as_ref()?.typed.clone())));
    let style = args.style.0.iter().next().map(|(name, number)| (name, number.typed.clone()));
    let thesis = (manner.style == StyleName::Thesis).then(|| ("style", manner.style.name().to_owned()));
    let three = (manner.determinants == DeterminantCount::Three).then(|| ("determinants", "3".to_owned()));
    let foot = (manner.root == RootLink::Foot).then(|| ("root", "foot".to_owned()));
    pace.or(style)
        .or(thesis)
        .or(three)
        .or(foot)
        .or_else(|| turns(args))
        .or_else(|| others(args))
        .or_else(|| key_postures(args))
}

/// What was given that the smooth style alone has.
fn changes(args: &WalkArgs) -> Option<(&'static str, String)> {
    turns(args)
        .or_else(|| args.changes.then.first().map(|then| ("then", then.typed.clone())))
        .or_else(|| others(args))
}

/// A turn or a way.
fn turns(args: &WalkArgs) -> Option<(&'static str, String)> {
    let turn = args.changes.turn.as_ref().map(|turn| ("turn", turn.typed.clone()));
    let path = args.changes.path.as_ref().map(|path| ("path", path.display().to_string()));
    let backward = args.changes.backward.then(|| ("backward", String::new()));
    turn.or(path).or(backward)
}

/// Whose walk, and on which ground.
fn others(args: &WalkArgs) -> Option<(&'static str, String)> {
    args.everyone.given().or_else(|| args.ground.given())
}

/// What was given that the thesis's style alone has.
fn key_postures(args: &WalkArgs) -> Option<(&'static str, String)> {
    let manner = &args.manner;
    let in_betweens = manner.in_betweens.map(|how| ("in-betweens", name(&how)));
    let double_support = manner.double_support.map(|law| ("double-support", name(&law)));
    in_betweens.or(double_support).or_else(|| Some(("sway", manner.sway.as_ref()?.typed.clone())))
}

fn name(value: &impl ValueEnum) -> String {
    value.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
}
