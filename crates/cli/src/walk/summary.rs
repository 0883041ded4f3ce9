//! The table that a walk prints, and the one on its page.

use super::report::{BandList, Check, Extreme, Report};
use solaris::view::TableRow;
use std::fmt::Write;
use std::path::Path;

/// One line: what, how much, unit, and what to hold it against.
struct Row {
    label: &'static str,
    value: String,
    unit: &'static str,
    note: String,
}

fn row(label: &'static str, value: impl Into<String>, unit: &'static str, note: impl Into<String>) -> Row {
    Row { label, value: value.into(), unit, note: note.into() }
}

/// A title for the page.
pub(super) fn title(report: &Report) -> String {
    let steps =
        if report.walk.steps == 1 { "1 step".to_owned() } else { format!("{} steps", report.walk.steps) };
    format!(
        "A person of {} m and {:.1} kg walks {steps} at {:.4} steps/min",
        report.person.height_m, report.person.mass_kg, report.walk.step_frequency_per_min
    )
}

/// The rows for the page.
pub(super) fn page_rows(report: &Report) -> Vec<TableRow> {
    rows(report).into_iter().map(|r| TableRow::new(r.label, &r.value, r.unit, &r.note)).collect()
}

/// The table as it is printed.
pub(super) fn table<'a>(report: &Report, written: impl Iterator<Item = &'a Path>) -> String {
    let mut text = format!("{}\n\n", title(report));
    for Row { label, value, unit, note } in rows(report) {
        let line = format!("  {label:<28}{value:>15} {unit:<9} {note}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
    for note in &report.notes {
        let _ = writeln!(text, "\nnote: {note}");
    }
    let mut written = written.peekable();
    if written.peek().is_some() {
        text.push('\n');
    } else {
        text.push_str("\nnothing is written; add -o walk.html to see it\n");
    }
    for path in written {
        let _ = writeln!(text, "wrote {}", path.display());
    }
    text
}

fn rows(report: &Report) -> Vec<Row> {
    let (walk, whole) = (&report.walk, &report.whole_walk);
    let mut rows = vec![
        row(
            "step length",
            format!("{:.3}", walk.step_length_m),
            "m",
            ratio_note(walk.step_length_over_peoples),
        ),
        row("speed", format!("{:.2}", walk.speed_m_s), "m/s", ""),
        row("cadence", format!("{:.1}", walk.step_frequency_per_min), "steps/min", ""),
        row("distance, time", format!("{:.2}, {:.2}", walk.distance_m, walk.duration_s), "m, s", ""),
    ];
    rows.extend(double_support_row(&walk.double_supports_percent, report));
    let at = |extreme: &Extreme| format!("at {:.2} s", extreme.at_s);
    rows.extend([
        row(
            "vertical force, peak",
            format!("{:.1}", whole.vertical_percent_bw.value),
            "%BW",
            at(&whole.vertical_percent_bw),
        ),
        row(
            "fore-aft force, peaks",
            format!("{:.1} / {:.1}", whole.braking_percent_bw.value, whole.pushing_percent_bw.value),
            "%BW",
            "brake / push",
        ),
        row(
            "friction, both / one foot",
            format!("{:.2} / {:.2}", whole.friction.value, whole.foot_friction.value),
            "",
            "",
        ),
        row("greatest slide", format!("{:.3}", 1e3 * whole.slide_m.value), "mm", "of a planted point"),
        row("greatest sink", format!("{:.3}", 1e3 * whole.sink_m.value), "mm", ""),
        row("toe clearance", format!("{:.1}", 1e3 * whole.toe_clearance_m.value), "mm", "least in mid-swing"),
        row("CoP outside the foot", format!("{:.1}", 1e3 * whole.cop_outside_m.value), "mm", ""),
        row(
            "least knee flexion",
            format!("{:.1}", whole.least_knee_deg.value),
            "°",
            at(&whole.least_knee_deg),
        ),
    ]);
    for joint in &whole.joints {
        let (moment, power) = match joint.joint {
            "hip" => ("hip moment, peaks", "hip power, peaks"),
            "knee" => ("knee moment, peaks", "knee power, peaks"),
            _ => ("ankle moment, peaks", "ankle power, peaks"),
        };
        let names = if joint.joint == "ankle" { "plantarflexor / dorsiflexor" } else { "extensor / flexor" };
        let pair = |a: &Extreme, b: &Extreme| format!("{:.2} / {:.2}", a.value, b.value);
        rows.push(row(moment, pair(&joint.extension, &joint.flexion), "N m/kg", names));
        rows.push(row(power, pair(&joint.generated, &joint.absorbed), "W/kg", "given / taken"));
    }
    if let Some(stride) = &report.steady_stride {
        let (from, to) = stride.span_s;
        rows.push(row("a steady stride", format!("{from:.2} – {to:.2}"), "s", "and people's bands:"));
        if let Some(textbook) = report.bands.iter().find(|list| list.name == "textbook") {
            rows.extend(textbook.checks.iter().map(|check| check_row(check)));
        }
        let ratio = format!("{:.5}", stride.walk_ratio_m_min);
        rows.push(row("walk ratio", ratio, "m·min", "people 0.0065 (Sekiya 1996, PMC5430280)"));
        rows.push(row(
            "stance",
            format!("{:.1}", stride.stance_percent),
            "% stride",
            kirtley(stride.speed_m_s),
        ));
        rows.extend(report.bands.iter().map(list_row));
    }
    let forces = &report.forces;
    if let Some(difference) = &forces.from_prescribed_n {
        rows.push(row("force from prescribed", format!("{:.1}", difference.value), "N", at(difference)));
    }
    let time = &report.run_time;
    rows.push(row(
        "run time",
        format!("{:.0} + {:.0}", 1e3 * time.planning_s, 1e3 * (time.with_forces_s - time.planning_s)),
        "ms",
        format!("plan + forces of {} frames", walk.frames),
    ));
    rows
}

fn ratio_note(ratio: f64) -> String {
    if (ratio - 1.0).abs() < 5e-4 {
        "people's at this pace".to_owned()
    } else {
        format!("{ratio:.2} of people's at this pace")
    }
}

fn double_support_row(supports: &[f64], report: &Report) -> Option<Row> {
    let (least, most) =
        supports.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
    if supports.is_empty() {
        return None;
    }
    let value = if most - least < 0.05 { format!("{most:.1}") } else { format!("{least:.1} – {most:.1}") };
    let note = if report.walk.steps > 1 { "each" } else { "" };
    Some(row("double support", value, "% stride", note))
}

fn check_row(check: &Check) -> Row {
    let verdict = if check.inside { "inside" } else { "OUTSIDE" };
    let note = format!("{verdict} {} to {}, textbook range, not cited", check.lower, check.upper);
    row(check.name, format!("{:.2}", check.value), check.unit, note)
}

/// Kirtley, Whittle and Jefferson 1985: stance = 64.2 − 3.5 v.
fn kirtley(speed: f64) -> String {
    format!("people {:.1} at this speed (Kirtley 1985)", 64.2 - 3.5 * speed)
}

fn list_row(list: &BandList) -> Row {
    let outside: Vec<String> = list
        .checks
        .iter()
        .filter(|check| !check.inside)
        .map(|check| format!("{} {:.2} ({} to {})", check.name, check.value, check.lower, check.upper))
        .collect();
    let label = if list.name == "recipe" { "recipe's bands held" } else { "textbook bands held" };
    let note = if outside.is_empty() { String::new() } else { format!("outside: {}", outside.join(", ")) };
    row(label, format!("{} of {}", list.inside, list.of), "", note)
}
