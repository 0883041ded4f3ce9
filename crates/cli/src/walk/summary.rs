//! The table that a walk prints, and the one on its page.

use super::numbers::{beside, short, wrapped};
use super::report::Report;
use super::told::{BesideKeyPostures, KeyPostures};
use crate::limbs;
use crate::table::{Row, at, fixed, joint_rows, lines, on_page, pair, row};
use solaris::gait::{BandCheck, BandReport, Peak, PostureComparison};
use solaris::view::TableRow;
use std::fmt::Write;

/// Columns of the lists of bands.
const WIDTH: usize = 100;

/// A title for the page.
pub(super) fn title(report: &Report) -> String {
    let (person, walk) = (&report.person, &report.walk);
    let plural = if walk.steps == 1 { "" } else { "s" };
    let [height, mass, pace] = [person.height_m, person.mass_kg, walk.step_frequency_per_min].map(short);
    let carries =
        person.carried_kg.map_or_else(String::new, |load| format!(" with {} kg in hand", short(load)));
    let holds = person
        .cane
        .as_ref()
        .map_or_else(String::new, |cane| format!(" with a cane in the {} hand", cane.hand));
    let who = format!("person of {height} m and {mass} kg{carries}{holds}");
    let first = if walk.changes { ", at first" } else { "" };
    let back = if walk.backward { " backward" } else { "" };
    if walk.style == "run" {
        let speed = short(walk.speed_m_s);
        return if walk.repeats {
            format!("A stride of a run that repeats itself, of a {who} at {speed} m/s")
        } else {
            let [before, after] = walk.walked_steps.unwrap_or_default();
            let counted = |steps: usize| format!("{steps} step{}", if steps == 1 { "" } else { "s" });
            let run = counted(walk.steps - before - after);
            let walks = if before > 0 { format!(" walks {},", counted(before)) } else { String::new() };
            let then = if after > 0 { format!(", walks {}", counted(after)) } else { String::new() };
            format!("A {who}{walks} runs {run}{first} at {speed} m/s{then}")
        };
    }
    if walk.repeats {
        return format!("A stride{back} that repeats itself, of a {who} at {pace} steps/min");
    }
    format!("A {who} walks {} step{plural}{back}{first} at {pace} steps/min", walk.steps)
}

/// The rows for the page.
pub(super) fn page_rows(report: &Report) -> Vec<TableRow> {
    let mut all = walk_rows(report);
    all.extend(report.key_postures.iter().flat_map(posture_rows));
    all.extend(report.beside_key_postures.iter().flat_map(beside_rows));
    all.extend(steady_rows(report));
    all.extend(report.bands.iter().map(|list| {
        let [inside, outside] = names(list).map(|names| names.join(", "));
        let value = format!("{} of {} inside", list.inside, list.of);
        row(heading(list), value, "", format!("{}; outside: {outside}; inside: {inside}", list.source))
    }));
    all.extend(trust_rows(report));
    all.extend(report.notes.iter().map(|note| row("note", "", "", note)));
    on_page(&all)
}

/// The table as it is printed.
pub(super) fn table(report: &Report, written: impl Iterator<Item = String>) -> String {
    let mut text = format!("{}\n\n{}", title(report), lines(&walk_rows(report)));
    if let Some(postures) = &report.key_postures {
        let _ = writeln!(text, "\nIts key postures, of {} determinants\n", postures.determinants);
        text.push_str(&lines(&posture_rows(postures)));
    }
    if let Some(beside) = &report.beside_key_postures {
        let _ = writeln!(
            text,
            "\nBeside the key postures of {} determinants at the same step: the walk less the posture\n",
            beside.determinants
        );
        text.push_str(&lines(&beside_rows(beside)));
    }
    if let Some(stride) = &report.steady_stride {
        let (from, to) = stride.span;
        let beside = if stride.backward { "" } else { ", and people's" };
        let _ = writeln!(text, "\nA steady stride, from {from:.2} to {to:.2} s{beside}\n");
        text.push_str(&lines(&steady_rows(report)));
    }
    for list in &report.bands {
        let _ =
            writeln!(text, "\n{}: {} of {} inside ({})", heading(list), list.inside, list.of, list.source);
        for (verdict, names) in ["inside", "outside"].iter().zip(names(list)) {
            let names = if names.is_empty() { vec!["none".to_owned()] } else { names };
            let _ = writeln!(text, "  {verdict:<9}{}", wrapped(&names, 11, WIDTH));
        }
    }
    let mut trust = trust_rows(report);
    trust.push(time_row(report));
    let _ = write!(text, "\nHow far to trust it\n\n{}", lines(&trust));
    for note in &report.notes {
        let _ = writeln!(text, "\nnote: {note}");
    }
    let mut written = written.peekable();
    let hint =
        if written.peek().is_some() { "\n" } else { "\nnothing is written; add -o walk.html to see it\n" };
    text.push_str(hint);
    for line in written {
        let _ = writeln!(text, "{line}");
    }
    text
}

/// A number that means nothing beyond a bound.
fn capped(value: f64, decimals: usize, most: f64) -> String {
    if value > most { format!("over {most}") } else { fixed(value, decimals) }
}

/// The whole walk.
fn walk_rows(report: &Report) -> Vec<Row> {
    let (walk, whole) = (&report.walk, &report.whole_walk.extremes);
    let millimetres = |peak: Peak, decimals| fixed(1e3 * peak.value, decimals);
    let people = walk.step_length_over_peoples.map_or_else(String::new, |ratio| {
        let part = if (ratio - 1.0).abs() < 5e-4 { String::new() } else { format!("{ratio:.2} of ") };
        format!("{part}people's at this pace")
    });
    let frames = if walk.repeats {
        format!("{} frames, {} a second; after the last comes the first", walk.frames, short(walk.rate_per_s))
    } else {
        format!("{} frames", walk.frames)
    };
    let mut rows = vec![
        row("step length", fixed(walk.step_length_m, 3), "m", people),
        row("speed", fixed(walk.speed_m_s, 2), "m/s", ""),
        row("cadence", fixed(walk.step_frequency_per_min, 1), "steps/min", ""),
        row("distance", fixed(walk.distance_m, 2), "m", ""),
        row("time", fixed(walk.duration_s, 2), "s", frames),
    ];
    rows.extend(double_support_row(&walk.double_supports_percent));
    rows.extend(report.person.cane.iter().map(|cane| {
        let part = format!("{:.0} % of the weight", 100.0 * cane.bears_over_weight);
        row("cane bears at most", fixed(cane.bears_n, 0), "N", part)
    }));
    rows.extend([
        row(
            "vertical force, peak",
            fixed(whole.vertical.value, 1),
            "%BW",
            format!("of one foot, {}", at(whole.vertical)),
        ),
        row("fore-aft force, peaks", pair(whole.braking, whole.pushing, 1), "%BW", "brake / push"),
        row(
            "friction needed",
            format!(
                "{} / {}",
                capped(whole.friction.value, 2, 10.0),
                capped(whole.foot_friction.value, 2, 10.0)
            ),
            "",
            "both feet / one foot",
        ),
        row("greatest slide", millimetres(whole.slide, 3), "mm", "of a planted point"),
        row("greatest sink", millimetres(whole.sink, 3), "mm", "of a sole's point"),
        row("toe clearance", millimetres(whole.clearance, 1), "mm", "least in mid-swing"),
        row("CoP outside the foot", capped(1e3 * whole.cop_outside.value, 1, 1e3), "mm", "at most"),
        row("least knee flexion", fixed(whole.least_knee.value.to_degrees(), 1), "°", at(whole.least_knee)),
    ]);
    rows.extend(
        report
            .whole_walk
            .nearest_limbs
            .iter()
            .map(|near| row("nearest limbs", limbs::millimetres(near), "mm", limbs::note(near))),
    );
    rows.extend(joint_rows(&report.whole_walk.joints));
    rows
}

/// The parameters and the angles of key postures.
fn posture_rows(postures: &KeyPostures) -> Vec<Row> {
    let parameters = postures.parameters.iter().map(|(name, symbol, value, unit)| {
        let decimals = if *unit == "°" { 2 } else { 4 };
        row(name, fixed(*value, decimals), unit, format!("{symbol}, a parameter"))
    });
    let angles = postures
        .angles_deg
        .iter()
        .filter(|(symbol, ..)| !postures.parameters.iter().any(|(_, parameter, ..)| parameter == symbol));
    let angles = angles.map(|(symbol, what, value)| row(what, fixed(*value, 2), "°", *symbol));
    let remarks = postures.remarks.iter().map(|remark| row("remark", "", "", remark));
    parameters.chain(angles).chain(remarks).collect()
}

/// A smooth walk less the key postures.
fn beside_rows(beside: &BesideKeyPostures) -> Vec<Row> {
    let leg = |posture: &PostureComparison, angles: &[f64], leg: &str| {
        let angles: Vec<String> = angles.iter().map(|angle| fixed(angle.to_degrees(), 0)).collect();
        let note = format!("thigh / shank / foot of the {leg} leg, at {:.2} s", posture.time);
        row(posture.name, angles.join(" / "), "°", note)
    };
    let both = |posture: &PostureComparison| {
        let off = posture.deviations();
        [leg(posture, &off[..3], "standing"), leg(posture, &off[3..], "other")]
    };
    beside.postures.iter().flat_map(both).collect()
}

fn double_support_row(supports: &[f64]) -> Option<Row> {
    let least = supports.iter().copied().reduce(f64::min)?;
    let most = supports.iter().copied().reduce(f64::max)?;
    let value = if most - least < 0.05 { fixed(most, 1) } else { format!("{least:.1} – {most:.1}") };
    Some(row("double support", value, "% stride", if supports.len() > 1 { "each" } else { "" }))
}

/// A steady stride beside people's.
fn steady_rows(report: &Report) -> Vec<Row> {
    let Some(stride) = &report.steady_stride else { return Vec::new() };
    // Kirtley, Whittle and Jefferson 1985: stance = 64.2 − 3.5 v.
    let stance = format!("people {:.1} at this speed (Kirtley 1985)", 64.2 - 3.5 * stride.speed);
    let ratio = "people 0.0065 (Sekiya 1996, PMC5430280)".to_owned();
    // Those are of walking forward.
    let [ratio, stance] = [ratio, stance].map(|people| if stride.backward { String::new() } else { people });
    let mut rows = vec![
        row("walk ratio", fixed(stride.walk_ratio(), 5), "m·min", ratio),
        row("stance", fixed(stride.stance, 1), "% stride", stance),
        row("on a plate, stance", fixed(stride.plate_stance, 1), "% stride", "above 20 N"),
        row(
            "on a plate, double support",
            fixed(stride.plate_double_support, 1),
            "% stride",
            "both above 20 N",
        ),
    ];
    for list in report.bands.iter().filter(|list| list.name == "textbook") {
        rows.extend(list.checks.iter().map(|check| {
            let verdict = if check.inside { "inside" } else { "OUTSIDE" };
            let (lower, upper) = check.range;
            let note = format!("{verdict:<7} {lower} to {upper}, {}", list.source);
            row(check.name, value(check), check.unit, note)
        }));
    }
    rows
}

/// What the forces rest on and what the run cost.
fn trust_rows(report: &Report) -> Vec<Row> {
    let forces = &report.forces.found;
    let mut rows = Vec::new();
    if let Some(off) = forces.from_prescribed() {
        rows.push(row(
            "force off the planned one",
            fixed(off.value, 1),
            "N",
            format!("at most, {}", at(off)),
        ));
    }
    let [force, moment] = forces.root_residual();
    let residual = format!("{force:.0e} / {moment:.0e}");
    rows.push(row("root residual", residual, "N / N m", "what no ground reaction explains"));
    if let Some(roots) = &report.forces.roots {
        let value = format!("{:.0e} / {:.0e}", roots.reaction_force, roots.torque);
        let note = format!("off those from the pelvis; {} changes of root", roots.roots.len() - 1);
        rows.push(row("forces from the feet", value, "N / N m", &note));
    }
    if let Some(pull) = forces.pull() {
        let note = format!("the ground would have to pull, at {:.2} s; no ground does", pull.time);
        rows.push(row("least force on a foot", fixed(pull.percent, 0), "%BW", note));
    }
    rows.extend(forces.split().map(|split| row("double support", split, "", "split: an assumption, no law")));
    rows
}

/// How long it took, which no page says: the same walk is the same page.
fn time_row(report: &Report) -> Row {
    let time = &report.run_time;
    let [plan, rest] = [time.planning_s, time.with_forces_s - time.planning_s].map(|s| fixed(1e3 * s, 0));
    row("run time", format!("{plan} + {rest}"), "ms", "plan + forces")
}

fn heading(list: &BandReport) -> &'static str {
    match list.name {
        "recipe" => "Recipe's bands",
        "running" => "Runners' bands",
        _ => "Textbook bands",
    }
}

/// The bands that hold, and those that do not with their numbers.
fn names(list: &BandReport) -> [Vec<String>; 2] {
    let (inside, outside): (Vec<&BandCheck>, Vec<&BandCheck>) =
        list.checks.iter().partition(|check| check.inside);
    let off = |check: &&BandCheck| {
        let (lower, upper) = check.range;
        format!("{} {} {} ({lower} to {upper})", check.name, value(check), check.unit)
    };
    [inside.iter().map(|check| check.name.to_owned()).collect(), outside.iter().map(off).collect()]
}

/// Two decimals for moments, one for the rest.
fn value(check: &BandCheck) -> String {
    let decimals = if check.unit == "N m/kg" { 2 } else { 1 };
    beside(check.value, check.range, decimals)
}
