//! The summary of a curve and its answers, for people.

use super::feasible::Feasible;
use super::request::Request;
use crate::args::CurveArgs;
use solaris::profiles::{Measure, Parameter, Profile, ProfileCurve};
use solaris::view::TableRow;
use solaris::view::profile::{Labels, answers as rows, number, unit};
use std::io::Write;

/// Digits of a parameter.
const DIGITS: usize = 7;
/// The most keys that are listed.
const MOST_KEYS: usize = 8;

/// What stands beside the curves in a picture.
pub(super) fn labels(request: &Request<'_>, args: &CurveArgs, feasible: &[Feasible]) -> Labels {
    let unit = args.unit.clone().unwrap_or_default();
    let title = args.title.clone().unwrap_or_else(|| title(&request.profile));
    let keys = keys_of(&request.profile).to_vec();
    let rows = feasible.iter().map(|feasible| TableRow::new(feasible.label(), "", "", feasible.short()));
    Labels { title, parameters: parameters(&request.profile, &unit), unit, keys, rows: rows.collect() }
}

/// "Minimum jerk".
fn title(profile: &Profile) -> String {
    let name = name(profile).replace('-', " ");
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// What its kind is called.
pub(super) fn name(profile: &Profile) -> &'static str {
    match profile {
        Profile::Weighted { .. } => "weighted mean",
        Profile::Sine { .. } => "sine",
        Profile::Repeat { .. } => "repeated",
        other => other.kind().map_or("blend", |kind| kind.name),
    }
}

/// Values, units and keys in one line.
fn parameters(profile: &Profile, unit: &str) -> String {
    if let Profile::Blend { first, second, fade, .. } = profile {
        let (start, end) = (number(fade.start(), DIGITS), number(fade.end(), DIGITS));
        let [first, second] = [first, second].map(|layer| name(&layer.profile));
        return format!("{first} fades into {second} from {start} to {end} s");
    }
    if let Profile::Weighted { layers } = profile {
        let names: Vec<&str> = layers.iter().map(|layer| name(&layer.profile)).collect();
        return names.join(" + ");
    }
    if let Profile::Repeat { of, times } = profile {
        return format!("{} {times} times", name(of));
    }
    if let Profile::Sine { amplitude, period, cycles, phase, offset } = profile {
        let [amplitude, period, cycles, phase, offset] =
            [amplitude, period, cycles, phase, offset].map(|value| number(*value, DIGITS));
        return format!(
            "amplitude {amplitude} {unit}, period {period} s, cycles {cycles}, phase {phase} rad, offset {offset} {unit}"
        );
    }
    let required = |parameter: &Parameter| {
        profile.kind().is_some_and(|kind| kind.required.iter().any(|other| other.name == parameter.name))
    };
    let said = |(parameter, value): &(&Parameter, f64)| {
        let value = number(*value, DIGITS);
        let text = format!("{} {value} {}", parameter.name, measured(parameter.measure, unit));
        text.trim_end().to_owned()
    };
    let values = profile.values();
    let shown = values.iter().filter(|(parameter, value)| required(parameter) || value.abs() > 0.0).map(said);
    let keys = Some(keys_of(profile)).filter(|keys| !keys.is_empty()).map(keys);
    shown.chain(keys).collect::<Vec<_>>().join(", ")
}

/// The unit of a measure, where positions have this one.
pub(super) fn measured(measure: Measure, label: &str) -> String {
    match measure {
        Measure::Position => unit(label, 0),
        Measure::Velocity => unit(label, 1),
        Measure::Acceleration => unit(label, 2),
        Measure::Jerk => unit(label, 3),
        Measure::Time => "s".to_owned(),
        Measure::Number => String::new(),
    }
}

/// The keys of a profile that has them.
fn keys_of(profile: &Profile) -> &[(f64, f64)] {
    match profile {
        Profile::CatmullRom { keys }
        | Profile::Centripetal { keys }
        | Profile::MonotoneCubic { keys }
        | Profile::KochanekBartels { keys, .. }
        | Profile::NaturalSpline { keys }
        | Profile::ClampedSpline { keys, .. } => keys,
        _ => &[],
    }
}

fn keys(keys: &[(f64, f64)]) -> String {
    let start = match keys.first() {
        Some(&(start, _)) if start.abs() > 0.0 => {
            format!(" (times count from the first key, at {} s)", number(start, DIGITS))
        }
        _ => String::new(),
    };
    if keys.len() > MOST_KEYS {
        return format!("{} keys{start}", keys.len());
    }
    let keys: Vec<String> =
        keys.iter().map(|&(t, x)| format!("{}:{}", number(t, DIGITS), number(x, DIGITS))).collect();
    format!("keys {}{start}", keys.join(" "))
}

/// What it is, in two lines.
pub(super) fn heading(out: &mut dyn Write, request: &Request<'_>, labels: &Labels) -> std::io::Result<()> {
    let name = name(&request.profile);
    match request.profile.kind() {
        Some(kind) => writeln!(out, "{name}: {}", kind.summary)?,
        None => writeln!(out, "{name}")?,
    }
    writeln!(out, "{}\n", labels.parameters)
}

/// What the whole curve answers.
pub(super) fn answers(out: &mut dyn Write, curve: &ProfileCurve, labels: &Labels) -> std::io::Result<()> {
    let rows = rows(curve, labels);
    let widest = |cell: fn(&TableRow) -> &str, least: usize| {
        rows.iter().map(|row| cell(row).chars().count()).max().unwrap_or(0).max(least)
    };
    let (label, value, unit) =
        (widest(|row| &row.label, 20), widest(|row| &row.value, 8), widest(|row| &row.unit, 1));
    for row in &rows {
        let line = format!("{:<label$}  {:>value$} {:<unit$}  {}", row.label, row.value, row.unit, row.note);
        writeln!(out, "{}", line.trim_end())?;
    }
    Ok(())
}
