//! The table that is printed, and the one on the page.

use super::report::Report;
use crate::limbs;
use crate::table::{Row, at, fixed, joint_rows, lines, on_page, row};
use crate::walk::numbers::short;
use solaris::view::TableRow;
use std::fmt::Write;

/// A title for the page.
pub(super) fn title(report: &Report) -> String {
    let [height, mass, seat] = [report.height_m, report.mass_kg, report.seat_m].map(short);
    let carries =
        report.carried_kg.map_or_else(String::new, |load| format!(" with {} kg in hand", short(load)));
    let (often, motion) = match report.times {
        1 => (String::new(), report.motion),
        times => (format!(" {times} times"), report.motion),
    };
    format!("A person of {height} m and {mass} kg{carries} {motion}{often}, seat {seat} m high")
}

/// The rows for the page.
pub(super) fn page_rows(report: &Report) -> Vec<TableRow> {
    let mut all = rows(report);
    all.extend(report.notes.iter().map(|note| row("note", "", "", note)));
    on_page(&all)
}

/// The table as it is printed.
pub(super) fn table(report: &Report, written: impl Iterator<Item = String>) -> String {
    let mut all = rows(report);
    let [plan, rest] =
        [report.planning_s, report.with_forces_s - report.planning_s].map(|s| fixed(1e3 * s, 0));
    all.push(row("run time", format!("{plan} + {rest}"), "ms", "plan + forces"));
    let mut text = format!("{}\n\n{}", title(report), lines(&all));
    for note in &report.notes {
        let _ = writeln!(text, "\nnote: {note}");
    }
    let mut written = written.peekable();
    let hint =
        if written.peek().is_some() { "\n" } else { "\nnothing is written; add -o rise.html to see it\n" };
    text.push_str(hint);
    for line in written {
        let _ = writeln!(text, "{line}");
    }
    text
}

/// So many times of a list are shown.
const SHOWN: usize = 3;

fn rows(report: &Report) -> Vec<Row> {
    let (measures, extremes) = (&report.measures, &report.measures.extremes);
    let times = |times: &[f64]| {
        let first: Vec<String> = times.iter().take(SHOWN).map(|time| fixed(*time, 2)).collect();
        first.join(", ") + if times.len() > SHOWN { ", …" } else { "" }
    };
    let millimetres = |value: f64, decimals| fixed(1e3 * value, decimals);
    let mut rows = vec![
        row("time", fixed(measures.duration, 2), "s", format!("{} frames", report.frames)),
        row("one way takes", fixed(report.one_way_s, 2), "s", "and rest before and after it"),
    ];
    let events = [("seat left at", &measures.left), ("seat met at", &measures.met)];
    rows.extend(
        events
            .into_iter()
            .filter(|(_, found)| !found.is_empty())
            .map(|(label, found)| row(label, times(found), "s", "2 % of the weight on it")),
    );
    rows.extend([
        row("forward lean of the trunk", fixed(report.lean_deg, 0), "°", "at most"),
        row("force on the feet, peak", fixed(measures.feet.value, 1), "%BW", at(measures.feet)),
        row("force on the seat, peak", fixed(measures.seat.value, 1), "%BW", at(measures.seat)),
        row(
            "speed of the body, along",
            fixed(measures.along.value, 2),
            "m/s",
            format!("its centre of mass, {}", at(measures.along)),
        ),
        row("speed of the body, up or down", fixed(measures.vertical.value, 2), "m/s", at(measures.vertical)),
        row("friction needed", fixed(measures.contact_friction.value, 2), "", "of seat or foot"),
        row("CoP outside the foot", millimetres(extremes.cop_outside.value, 1), "mm", "at most"),
        row("greatest slide", millimetres(extremes.slide.value, 3), "mm", "of a planted point"),
    ]);
    rows.extend(measures.angles.iter().map(|range| {
        let label = match range.joint {
            "hip.flexion" => "hip flexion",
            "knee.flexion" => "knee flexion",
            _ => "ankle dorsiflexion",
        };
        let [least, most] = [range.least, range.greatest].map(|angle| fixed(angle.to_degrees(), 0));
        row(label, format!("{least} – {most}"), "°", "")
    }));
    rows.extend(joint_rows(&measures.joints));
    rows.extend(
        report
            .nearest_limbs
            .iter()
            .map(|near| row("nearest limbs", limbs::millimetres(near), "mm", limbs::note(near))),
    );
    let residual = format!("{:.0e} / {:.0e}", report.root_residual_n, report.root_residual_n_m);
    rows.push(row("root residual", residual, "N / N m", "what ground and seat do not explain"));
    rows
}
