//! Refusals of curves, in the words of the options that ask for them.

use crate::args::{BlendArgs, KindArgs, option};
use crate::error::{CliError, Refusal};
use crate::words::short;
use solaris::profiles::{Parameter, ProfileError};

/// Of a curve of one kind.
pub(super) fn of_kind(error: &ProfileError, args: &KindArgs) -> CliError {
    let Some((what, value, why)) = at_fault(error) else { return other(error) };
    if let Some(keys) = args.keys.as_ref().filter(|_| matches!(what, "key" | "keys")) {
        return CliError::option("keys", &keys.typed, why);
    }
    let Some(parameter) = args.kind.parameters().find(|parameter| parameter.name == what) else {
        let to = args.to.as_ref().filter(|_| what == Parameter::TO.name);
        return to.map_or_else(|| other(error), |to| CliError::option("to", &to.typed, why));
    };
    let typed = args.value(what).map_or_else(|| value.to_string(), |number| number.typed.clone());
    CliError::option(&option(parameter), typed, why)
}

/// Of a blend.
pub(super) fn of_blend(error: &ProfileError, args: &BlendArgs) -> CliError {
    let Some((what, value, why)) = at_fault(error) else { return other(error) };
    match what {
        "start of the window" | "end of the window" | "length of the window" => {
            CliError::option("window", &args.window.typed, format!("{what} is {}; {why}", short(value)))
        }
        "stiffness" => {
            let typed =
                args.stiffness.as_ref().map_or_else(|| value.to_string(), |number| number.typed.clone());
            CliError::option("stiffness", typed, why)
        }
        _ => other(error),
    }
}

/// Which number is at fault, its value, and what is wrong with it.
fn at_fault(error: &ProfileError) -> Option<(&'static str, f64, Refusal)> {
    Some(match error {
        ProfileError::NotFinite { what, value } => (what, *value, Refusal::NotFinite),
        ProfileError::NotWhole { what, value } => (what, *value, Refusal::NotWhole),
        ProfileError::OutOfRange { what, value, range } => (what, *value, Refusal::Ranges((*range).into())),
        ProfileError::Infeasible { what, value, why, feasible } => {
            (what, *value, Refusal::Infeasible { what, why, among: feasible.clone() })
        }
        ProfileError::Duration { duration } => ("duration", *duration, Refusal::NotPositive),
        ProfileError::Knots { time, .. } => ("keys", *time, error.to_string().into()),
        ProfileError::Count { found, needed, .. } => {
            ("keys", *found as f64, format!("{found} given, {needed} needed").into())
        }
        _ => return None,
    })
}

fn other(error: &ProfileError) -> CliError {
    CliError::Other(error.to_string().into())
}
