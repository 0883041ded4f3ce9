//! The plan of a run: computed, and left out.

use crate::words::some;
use solaris::dynamics::scalar::Operations;
use solaris::modes::PhaseReport;
use std::fmt::Write;

/// The parts of the run, each with what is in it and what it costs.
pub(super) fn text(phases: &[PhaseReport]) -> String {
    let mut text = "\nWhat is computed, and what is left out\n".to_owned();
    let omitted = |phase: &PhaseReport| phase.omitted.clone();
    let always = phases.first().map(omitted).unwrap_or_default();
    let always: Vec<String> =
        always.into_iter().filter(|what| phases.iter().all(|phase| phase.omitted.contains(what))).collect();
    for group in phases.chunk_by(is_like) {
        let (first, last) = (&group[0], &group[group.len() - 1]);
        // An instant at the end is no part of the run.
        if last.end > first.start || phases.len() == 1 {
            part(&mut text, first, last.end, &always);
        }
    }
    if !always.is_empty() {
        text.push_str("\n  left out throughout\n");
        for what in always {
            let _ = writeln!(text, "    {what}");
        }
    }
    text
}

/// Whether the same is computed and the same left out.
fn is_like(a: &PhaseReport, b: &PhaseReport) -> bool {
    let names = |phase: &PhaseReport| {
        [&phase.dynamic, &phase.prescribed, &phase.fused, &phase.dropped, &phase.omitted].map(Clone::clone)
    };
    names(a) == names(b) && a.operations.total() == b.operations.total()
}

/// One part, until `end` (s), without what is `always` left out.
fn part(text: &mut String, phase: &PhaseReport, end: f64, always: &[String]) {
    let _ = writeln!(text, "\n  {:.3} to {end:.3} s", phase.start);
    let mut row = |what: &str, names: &[String]| {
        if !names.is_empty() {
            let _ = writeln!(text, "    {what:<20}{:>6}  {}", names.len(), some(names));
        }
    };
    row("dynamics move", &phase.dynamic);
    row("move as prescribed", &phase.prescribed);
    row("stand still, fused", &phase.fused);
    row("links dropped", &phase.dropped);
    if phase.dynamic.is_empty() {
        let _ = writeln!(text, "    nothing is integrated: every motion is given");
    } else if phase.operations_of_all.total() > 0 {
        let [all, left] = [phase.operations_of_all, phase.operations].map(Operations::total);
        let share = 100.0 * left as f64 / all as f64;
        let _ = writeln!(
            text,
            "    {:<20}{left:>6}  of the {all} that the whole figure takes: {share:.0} %",
            "operations"
        );
    }
    for what in phase.omitted.iter().filter(|what| !always.contains(what)) {
        let _ = writeln!(text, "    left out: {what}");
    }
}
