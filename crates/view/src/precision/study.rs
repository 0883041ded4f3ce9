//! Tables of a study, ready to be read.

use super::{Diagram, Point, Report, Series, Table};
use crate::profile::number;
use solaris_modes::Method;
use solaris_modes::study::{Accuracy, Row, Study, method_name, setting};

/// A study as a report: findings, pictures, tables. `title` says of what; `duration` (s) and `rate` (1/s) are those of
/// the runs.
pub fn report(study: &Study, title: &str, duration: f64, rate: f64) -> Report {
    let mut tables = vec![settings(study)];
    if study.choices().iter().any(|choice| choice.row.is_some()) {
        tables.insert(0, choices(study));
    }
    tables.extend(chaos(study));
    tables.extend(savings(study));
    Report { diagram: diagram(study, title, duration, rate), findings: findings(study), tables }
}

/// The pictures of a study alone.
pub fn diagram(study: &Study, title: &str, duration: f64, rate: f64) -> Diagram {
    let pace = seconds_an_evaluation(study);
    let mut series: Vec<Series> = Vec::new();
    for row in study.rows.iter().filter(|row| !matches!(row.method, Method::Usual | Method::Automatic { .. }))
    {
        let name = method_name(row.method);
        let evaluations = row.evaluations(duration).map(|count| count as f64);
        let point = Point {
            label: setting(row.method).replace(" s", ""),
            // What came to trouble stands where it would have been.
            seconds: row.seconds.or_else(|| Some(evaluations? * pace?)),
            evaluations,
            error: row.result.as_ref().ok().map(|accuracy| accuracy.position),
        };
        match series.last_mut().filter(|series| series.name == name) {
            Some(series) => series.points.push(point),
            None => series.push(Series { name, points: vec![point] }),
        }
    }
    let until = study.sensitivity.comparable_until;
    let span = if study.sensitivity.is_chaotic {
        format!("the first {} of {} s", number(until, 3), number(duration, 4))
    } else {
        format!("{} s", number(duration, 4))
    };
    let floor = study.reference.uncertainty.position;
    Diagram {
        title: title.to_owned(),
        subtitle: format!(
            "worst frame of {span} at {} frames/s, against {}",
            number(rate, 4),
            study.reference.name
        ),
        error: "positions (rad or m)".to_owned(),
        series,
        wanted: Some(study.wanted),
        floor: (floor > 0.0 && !study.sensitivity.is_chaotic).then_some(floor),
    }
}

/// What a study comes to, in sentences: the recommendation first.
pub fn findings(study: &Study) -> Vec<String> {
    let mut findings = vec![match study.cheapest(study.wanted) {
        Some(row) => format!("For errors up to {}: {row} ({}).", short(study.wanted), cost(row)),
        None => format!("No setting that was tried is known to meet {}.", short(study.wanted)),
    }];
    let reference = &study.reference;
    findings.push(if reference.beside.is_empty() {
        format!("The answer is {}.", reference.name)
    } else {
        let apart = short(reference.uncertainty.position);
        format!(
            "The answer is {}; {} beside it is {apart} away (rad or m), so no error below that is told.",
            reference.name, reference.beside
        )
    });
    if study.sensitivity.is_chaotic {
        findings.push(format!(
            "The motion cannot be compared to its end: from {} s on, last digits decide where it is. Errors are those up to \
             there.",
            number(study.sensitivity.comparable_until, 3)
        ));
    }
    if let Some(growth) = study.sensitivity.growth.filter(|growth| *growth > 100.0) {
        findings.push(format!(
            "A small change at the beginning grows {}-fold: what is not known better of the start cannot be known of the end.",
            number(growth, 2)
        ));
    }
    let (mut stopped, mut of) = (0, 0);
    for row in &study.rows {
        (stopped, of) = (stopped + usize::from(row.result.is_err()), of + 1);
    }
    if stopped > 0 {
        findings.push(format!("{stopped} of {of} settings came to no result; the table says why."));
    }
    if !study.is_complete {
        findings.push("Stopped before all was tried.".to_owned());
    }
    findings
}

/// How long an evaluation takes (s), the median over all that came to an end.
fn seconds_an_evaluation(study: &Study) -> Option<f64> {
    let pace = |row: &Row| Some(row.seconds? / row.counts.evaluations as f64);
    let mut all: Vec<f64> = study.rows.iter().filter_map(pace).filter(|x| x.is_finite()).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied()
}

/// What error asks for what.
fn choices(study: &Study) -> Table {
    let row = |choice: &solaris_modes::study::Choice<'_>| {
        let row = choice.row?;
        Some(vec![
            short(choice.wanted),
            row.to_string(),
            thousands(row.counts.evaluations),
            seconds(row),
            error(row),
        ])
    };
    Table {
        title: "Which setting for which error".to_owned(),
        note: "The cheapest setting whose error is at most what is wanted.".to_owned(),
        header: ["error up to", "setting", "evaluations", "seconds", "its error"].map(str::to_owned).into(),
        rows: study.choices().iter().filter_map(row).collect(),
        marked: Vec::new(),
    }
}

/// Every setting.
fn settings(study: &Study) -> Table {
    let has_momentum =
        study.rows.iter().any(|row| row.result.as_ref().is_ok_and(|accuracy| accuracy.momentum.is_some()));
    let mut header = vec![
        "setting",
        "evaluations",
        "Jacobians",
        "steps",
        "rejected",
        "seconds",
        "positions",
        "velocities",
        "energy",
    ];
    if has_momentum {
        header.extend(["momentum (N s)", "angular (N m s)"]);
    }
    let best = study.cheapest(study.wanted);
    let rows = study.rows.iter().map(|row| {
        let mut cells = vec![row.to_string()];
        match &row.result {
            Err(trouble) => cells.push(trouble.clone()),
            Ok(Accuracy { position, velocity, energy, momentum, .. }) => {
                let counts = &row.counts;
                let numbers = [counts.evaluations, counts.jacobians, counts.steps, counts.rejected];
                cells.extend(numbers.map(thousands));
                cells.push(seconds(row));
                cells.extend([position, velocity, energy].map(|x| short(*x)));
                if has_momentum {
                    let drift = momentum
                        .map_or([String::new(), String::new()], |it| [it.linear, it.angular].map(short));
                    cells.extend(drift);
                }
            }
        }
        cells
    });
    Table {
        title: "Every setting".to_owned(),
        note: "Positions (rad or m) and velocities (rad/s or m/s): the greatest error of all frames. Energy: what came from \
               nowhere or went, over the energy at play. Seconds: the best of the repeats, without joint forces."
            .to_owned(),
        header: header.into_iter().map(str::to_owned).collect(),
        rows: rows.collect(),
        marked: study.rows.iter().position(|row| Some(row) == best).into_iter().collect(),
    }
}

/// Single frames, where that is all that can be compared.
fn chaos(study: &Study) -> Option<Table> {
    let row = |row: &Row| {
        let agreement = row.agreement?;
        Some(vec![row.to_string(), short(agreement.position), short(agreement.velocity)])
    };
    let rows: Vec<_> = study.rows.iter().filter_map(row).collect();
    let frames = study.rows.iter().find_map(|row| row.agreement)?.frames;
    Some(Table {
        title: "One frame at a time".to_owned(),
        note: format!(
            "{frames} frames spread over the whole motion, each begun from the reference's state: the greatest error at the end of the frame."
        ),
        header: ["setting", "positions", "velocities"].map(str::to_owned).into(),
        rows,
        marked: Vec::new(),
    })
}

/// What leaving out has saved.
fn savings(study: &Study) -> Option<Table> {
    let savings = study.savings.as_ref()?;
    let (whole, left) = savings.operations;
    let mut rows = vec![vec![
        "operations of an evaluation".to_owned(),
        thousands(whole.round() as u64),
        thousands(left.round() as u64),
    ]];
    if let Some((whole, left)) = savings.seconds {
        rows.push(vec!["seconds".to_owned(), number(whole, 3), number(left, 3)]);
    }
    Some(Table {
        title: "What leaving out saves".to_owned(),
        note: format!(
            "{}; what stands still is fused, and what nothing that is computed depends on is dropped. The two motions differ by \
             {} (rad or m).",
            savings.method,
            short(savings.difference)
        ),
        header: ["", "everything", "what is left"].map(str::to_owned).into(),
        rows,
        marked: Vec::new(),
    })
}

fn cost(row: &Row) -> String {
    let evaluations = format!("{} evaluations", thousands(row.counts.evaluations));
    match row.seconds {
        Some(_) => format!("{evaluations}, {} s", seconds(row)),
        None => evaluations,
    }
}

fn error(row: &Row) -> String {
    row.result.as_ref().map_or_else(|_| String::new(), |accuracy| short(accuracy.position))
}

fn seconds(row: &Row) -> String {
    row.seconds.map_or_else(String::new, |seconds| number(seconds, 3))
}

/// A size of an error, with two digits.
fn short(x: f64) -> String {
    if x.abs() <= 0.0 { "0".to_owned() } else { format!("{x:.1e}").replace(".0e", "e") }
}

/// Digits in groups of three.
fn thousands(n: u64) -> String {
    if n < 1000 { n.to_string() } else { format!("{}\u{202f}{:03}", thousands(n / 1000), n % 1000) }
}
