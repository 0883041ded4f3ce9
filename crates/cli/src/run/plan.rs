//! What was computed, and what was left out.

use super::report::Phase;
use crate::convert::some;
use std::fmt::Write;

/// The parts of the run, each with what is in it and what it costs.
pub(super) fn text(phases: &[Phase]) -> String {
    let mut text = "\nWhat is computed, and what is left out\n".to_owned();
    for phase in phases {
        let _ = writeln!(text, "\n  {:.3} to {:.3} s", phase.start_s, phase.end_s);
        let mut row = |what: &str, names: &[String]| {
            if !names.is_empty() {
                let _ = writeln!(text, "    {what:<20}{:>5}  {}", names.len(), some(names));
            }
        };
        row("dynamics move", &phase.dynamic);
        row("move as prescribed", &phase.prescribed);
        row("stand still, fused", &phase.fused);
        row("links dropped", &phase.dropped_links);
        if phase.dynamic.is_empty() {
            let _ = writeln!(text, "    nothing is integrated: every motion is given");
        }
        if phase.operations_of_all > 0 {
            let share = 100.0 * phase.operations as f64 / phase.operations_of_all as f64;
            let _ = writeln!(
                text,
                "    operations          {:>5}  of the {} that the whole figure takes: {share:.0} %",
                phase.operations, phase.operations_of_all
            );
        }
        for omitted in &phase.omitted {
            let _ = writeln!(text, "    left out: {omitted}");
        }
    }
    text
}
