//! The table that a run prints, and the one on its page.

use super::energy::digits;
use super::report::{Reactions, Report};
use super::{contact, energy, outcomes};
use crate::limbs;
use solaris::modes::Cost;
use solaris::view::TableRow;
use std::fmt::Write;

/// The most impacts that are listed.
const MANY: usize = 12;

/// A title for the page.
pub(super) fn title(report: &Report) -> String {
    let plural = if report.dofs == 1 { "" } else { "s" };
    format!(
        "Scene '{}': figure '{}', {} degree{plural} of freedom, {} s",
        report.scene,
        report.figure,
        report.dofs,
        digits(report.duration_s)
    )
}

/// How many frames a second, and when the last is where it is not at the end.
fn frames(report: &Report) -> String {
    let last = report.frames.saturating_sub(1) as f64 / report.rate_per_s;
    let rate = format!("{} a second", digits(report.rate_per_s));
    if report.duration_s - last > 1e-6 * last {
        format!("{rate}, the last at {} s", digits(last))
    } else {
        rate
    }
}

const RUN_TIME: &str = "run time";

/// Label, value and note.
fn rows(report: &Report) -> Vec<[String; 3]> {
    let row = |label: &str, value: String, note: &str| [label.to_owned(), value, note.to_owned()];
    let run = &report.run;
    let Cost { counts, seconds } = run.cost;
    let mut rows = vec![
        row("frames", report.frames.to_string(), &frames(report)),
        row("method", run.method.clone(), ""),
    ];
    if !run.why.is_empty() {
        rows.push(row("because", run.why.clone(), ""));
    }
    if let Some(error) = &run.error {
        rows.push(row(
            "error of positions",
            format!("{:.1e}", error.position),
            "rad or m, at most, as far as can be told",
        ));
        rows.push(row("error of velocities", format!("{:.1e}", error.velocity), "rad/s or m/s"));
    }
    if counts.evaluations > 0 {
        let mut note = format!("in {} steps", counts.steps);
        for (count, what) in
            [(counts.rejected, "rejected"), (counts.jacobians, "Jacobians"), (counts.events, "events")]
        {
            if count > 0 {
                let _ = write!(note, ", {count} {what}");
            }
        }
        rows.push(row("evaluations", counts.evaluations.to_string(), &note));
    }
    if let Some(seconds) = seconds {
        rows.push(row(RUN_TIME, format!("{} ms", digits(1e3 * seconds)), "with all that was tried"));
    }
    if run.energy.scale > 0.0 {
        rows.extend(energy::rows(&run.energy));
    }
    if let Some(ground) = &run.ground {
        rows.extend(contact::rows(ground));
    }
    rows.extend(contact::collisions(&run.collisions));
    rows.extend(contact::loops(&run.loops));
    if let Some(limbs) = &report.nearest_limbs {
        rows.push(row("nearest limbs", format!("{} mm", limbs::millimetres(limbs)), &limbs::note(limbs)));
    }
    if let Some(Reactions(ground)) = &report.ground {
        let residual = format!("{:.0e} / {:.0e}", ground.root_force, ground.root_moment);
        rows.push(row("root residual", residual, "N / N m, what no ground reaction explains"));
        if let Some(off) = ground.from_prescribed {
            rows.push(row(
                "force off the planned one",
                format!("{:.1} N", off.value),
                "of the ground, at most",
            ));
        }
    }
    rows
}

/// The rows for the page.
pub(super) fn page_rows(report: &Report) -> Vec<TableRow> {
    // Where values stand in a column, a sentence goes with the notes. How long it took no page says: the same scene is the same page.
    let row = |[label, value, note]: &[String; 3]| match label.as_str() {
        "because" => TableRow::new(label, "", "", value),
        _ => TableRow::new(label, value, "", note),
    };
    let timeless = rows(report).into_iter().filter(|[label, ..]| label != RUN_TIME);
    let mut all: Vec<TableRow> = timeless.map(|each| row(&each)).collect();
    all.extend(outcomes::lines(&report.run.outcomes).iter().map(|line| TableRow::new("drive", "", "", line)));
    all.extend(
        outcomes::hits(&report.run.impacts).iter().take(MANY).map(|hit| TableRow::new("impact", "", "", hit)),
    );
    all.extend(report.remarks.iter().map(|remark| TableRow::new("note", "", "", remark)));
    all
}

/// The table as it is printed.
pub(super) fn text(report: &Report) -> String {
    let mut text = format!("{}\n\n", title(report));
    for [label, value, note] in rows(report) {
        let line = format!("  {label:<28}{value:<28} {note}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
    if !report.run.outcomes.is_empty() {
        let _ = writeln!(text, "\nWhat became of the drives\n");
        for line in outcomes::lines(&report.run.outcomes) {
            let _ = writeln!(text, "  {line}");
        }
    }
    if !report.run.impacts.is_empty() {
        let _ = writeln!(text, "\nImpacts\n");
        let hits = outcomes::hits(&report.run.impacts);
        for hit in hits.iter().take(MANY) {
            let _ = writeln!(text, "  {hit}");
        }
        if hits.len() > MANY {
            let _ = writeln!(text, "  and {} more", hits.len() - MANY);
        }
    }
    for remark in &report.remarks {
        let _ = writeln!(text, "\nnote: {remark}");
    }
    text
}

/// Which files were written.
pub(super) fn written(lines: impl Iterator<Item = String>) -> String {
    let mut lines = lines.peekable();
    if lines.peek().is_none() {
        return "\nnothing is written; add -o motion.html to see it\n".to_owned();
    }
    lines.fold("\n".to_owned(), |text, line| text + &line + "\n")
}
