//! Options of the style with which a walk does not hold, and the nearest ones with which it does.

use super::parameter::Parameter;
use super::plan_check::PlanCheck;
use super::route::Route;
use super::style::Style;
use crate::body::Body;
use crate::error::{GaitError, PlanError};
use crate::request::pace::tidy;

/// Options by name, in their units.
type Options = [(&'static str, f64)];

/// How often the way from a default to an option is halved.
const HALVINGS: usize = 8;
/// How many of the last places the nearest option may be nearer to its default than the halvings say.
const PLACES: usize = 8;

/// Says how near an option may come to what was asked, where options are the reason that a walk does not hold. `holds` plans and
/// judges.
pub(super) fn advise(
    error: GaitError,
    route: &Route,
    body: &Body,
    asked: &Options,
    holds: impl Fn(&Route, &Options) -> bool,
) -> GaitError {
    let GaitError::Plan(why) = &error else { return error };
    let what = match why {
        PlanError::Friction { whose, friction, limit, .. } => PlanCheck::friction(whose, *friction, *limit),
        PlanError::NotWalkable { what, .. } | PlanError::AbruptChange { what, .. } => what.clone(),
        other => other.to_string(),
    };
    let short = route.shortened();
    if asked.is_empty() || !holds(&short, &[]) {
        return error;
    }
    let pace = route.pace();
    let style = Style::of(&body.leg, body.height, pace.step_frequency, pace.step_length);
    let defaults: Vec<f64> = asked
        .iter()
        .map(|(name, value)| Parameter::named(name).map_or(*value, |parameter| parameter.get(&style)))
        .collect();
    // One that is to blame alone, or all of them together.
    let alone = (0..asked.len()).find(|&one| {
        let mut others = asked.to_vec();
        others.remove(one);
        holds(&short, &others)
    });
    let moved = |part: f64| -> Vec<(&'static str, f64)> {
        let at = |i: usize, (name, value): (&'static str, f64)| {
            let kept = alone.is_some_and(|one| one != i);
            (name, if kept { value } else { defaults[i] + part * (value - defaults[i]) })
        };
        asked.iter().enumerate().map(|(i, option)| at(i, *option)).collect()
    };
    let (mut lower, mut upper) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (lower + upper);
        if holds(&short, &moved(middle)) {
            lower = middle;
        } else {
            upper = middle;
        }
    }
    // Rounded towards the defaults, and held against the laws once more.
    let rounded = |nearer: usize| -> Vec<(&'static str, f64)> {
        let near = moved(lower);
        let towards = |i: usize, (name, value): (&'static str, f64)| {
            if alone.is_some_and(|one| one != i) {
                return (name, value);
            }
            let place = Parameter::named(name).map_or(0.1, |parameter| parameter.unit.place());
            let (whole, default) = (value / place, defaults[i] / place);
            let steps = nearer as f64;
            let to = if whole < default {
                (whole.ceil() + steps).min(default)
            } else {
                (whole.floor() - steps).max(default)
            };
            (name, tidy(to * place))
        };
        near.iter().enumerate().map(|(i, option)| towards(i, *option)).collect()
    };
    let Some(nearest) = (0..PLACES).map(rounded).find(|near| holds(&short, near)) else { return error };
    let said = |options: &mut dyn Iterator<Item = (&'static str, f64)>| -> String {
        let one = |(name, value): (&'static str, f64)| {
            let unit = Parameter::named(name).map_or("", |parameter| parameter.unit.symbol());
            format!("{name} {}{unit}", tidy(value))
        };
        options.map(one).collect::<Vec<_>>().join(", ")
    };
    let blamed = |i: usize| alone.is_none_or(|one| one == i);
    let pick = |options: &Options| -> Vec<(&'static str, f64)> {
        options.iter().enumerate().filter(|(i, _)| blamed(*i)).map(|(_, option)| *option).collect()
    };
    PlanError::Options {
        options: said(&mut pick(asked).into_iter()),
        step_length: pace.step_length,
        step_frequency: tidy(pace.step_frequency),
        what,
        nearest: said(&mut pick(&nearest).into_iter()),
    }
    .into()
}
