//! Outcomes of drives, and impacts, in words.

use super::energy::digits;
use crate::words::some;
use solaris::model::AxisKind;
use solaris::modes::{Impact, Outcome, OutcomeKind};

/// A line for each impact; those at the same time share their loss, and the last of them tells it.
pub(super) fn hits(impacts: &[Impact]) -> Vec<String> {
    let at_once = |a: &Impact, b: &Impact| (a.time - b.time).abs() < 1e-9;
    let mut lines = Vec::new();
    for group in impacts.chunk_by(at_once) {
        let loss: f64 = group.iter().map(|impact| impact.loss).sum();
        for (i, impact) in group.iter().enumerate() {
            let together = if group.len() > 1 { "together " } else { "" };
            let loss = format!("; {together}{} J lost", digits(loss));
            let loss = if i + 1 == group.len() { loss } else { String::new() };
            lines.push(format!("{:>7.3} s  {}{loss}", impact.time, hit(impact)));
        }
    }
    lines
}

/// A line for each drive; those of the same kind over the same time with the same end share one.
pub(super) fn lines(drives: &[Outcome]) -> Vec<String> {
    let mut groups: Vec<Vec<&Outcome>> = Vec::new();
    for outcome in drives {
        let same = |other: &Outcome| {
            let times = [(outcome.start, other.start), (outcome.end, other.end)];
            let together = times.iter().all(|(a, b)| (a - b).abs() < 1e-9);
            together && outcome.drive == other.drive && outcome.result == other.result
        };
        match groups.iter_mut().find(|group| same(group[0])) {
            Some(group) => group.push(outcome),
            None => groups.push(vec![outcome]),
        }
    }
    let mut lines = Vec::new();
    for group in groups {
        let when = |outcome: &Outcome| format!("{:>7.3} to {:>7.3} s", outcome.start, outcome.end);
        if group.len() > FEW {
            let names: Vec<String> = group.iter().map(|outcome| outcome.name.clone()).collect();
            let what = words_of_many(group[0]);
            lines.push(format!("{}  {}: {what}; {}", when(group[0]), group[0].drive, some(&names)));
        } else {
            lines.extend(group.iter().map(|outcome| {
                format!("{}  {}, {}: {}", when(outcome), outcome.name, outcome.drive, words(outcome))
            }));
        }
    }
    lines
}

/// What became of it, in words.
fn words(outcome: &Outcome) -> String {
    let (position, velocity) =
        (amount(outcome.position, outcome.axis_kind), rate(outcome.velocity, outcome.axis_kind));
    match outcome.result {
        OutcomeKind::Reached => format!("reached {position}"),
        OutcomeKind::ReachedWithVelocity => format!("reached {position} with {velocity}"),
        OutcomeKind::NoMotion => {
            format!("stayed at {position}: the force of the target gives no acceleration")
        }
        OutcomeKind::WrongSign => {
            let acceleration = outcome
                .acceleration
                .map_or_else(String::new, |a| format!(" ({}²)", rate(a, outcome.axis_kind)));
            format!(
                "stayed at {position}: the force of the target accelerates it away from there{acceleration}"
            )
        }
        OutcomeKind::Unreachable => format!("stayed at {position}: it would turn round before the target"),
        OutcomeKind::NeedsRest => {
            format!("stayed at {position}: this drive goes from rest to rest, and it came with a velocity")
        }
        OutcomeKind::LimitedByTorque => format!("came to {position}: the force was at its limit"),
        OutcomeKind::Missed => {
            let off = amount(outcome.missed_by.unwrap_or_default(), outcome.axis_kind);
            format!("came to {position}, {off} beside the target")
        }
        OutcomeKind::LimitHit => format!("came to {position}, the limit of the joint"),
        OutcomeKind::Interrupted => format!("at {position} when the next drive took over"),
        OutcomeKind::Unfinished => format!("not done at the end of the run, at {position}"),
        OutcomeKind::NotBegun => "the run ended before it began".to_owned(),
        _ if !outcome.has_position => "ended".to_owned(),
        _ => format!("ended at {position}"),
    }
}

/// What several have in common, in words.
fn words_of_many(outcome: &Outcome) -> &'static str {
    match outcome.result {
        OutcomeKind::Unfinished => "not done at the end of the run",
        OutcomeKind::Interrupted => "the next drive took over",
        OutcomeKind::NotBegun => "the run ended before they began",
        result => result.name(),
    }
}

/// What happened, in words.
fn hit(impact: &Impact) -> String {
    let [before, after] = [impact.velocity_before, impact.velocity_after].map(|v| rate(v, impact.axis_kind));
    let unit = if impact.axis_kind == AxisKind::Rotation { "N m s" } else { "N s" };
    format!("{} ({}) {before} to {after}, {} {unit}", impact.name, impact.what, digits(impact.impulse))
}

/// As many drives of one kind each have a line of their own.
const FEW: usize = 3;

/// A position for people: degrees or m.
fn amount(value: f64, axis_kind: AxisKind) -> String {
    match axis_kind {
        AxisKind::Rotation => format!("{}°", digits(value.to_degrees())),
        AxisKind::Translation => format!("{} m", digits(value)),
    }
}

fn rate(value: f64, axis_kind: AxisKind) -> String {
    match axis_kind {
        AxisKind::Rotation => format!("{}°/s", digits(value.to_degrees())),
        AxisKind::Translation => format!("{} m/s", digits(value)),
    }
}
