//! The tables: times at equal error, times of a step, and how well the answers are known.

use super::Measured;
use super::mujoco::MuJoCo;
use super::points::{Series, time};
use crate::report::page;
use crate::table::{Cell, Table};

/// The errors (rad or m) at which times are compared.
const ERRORS: [f64; 6] = [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10];

/// What is set beside our quickest: our own way to a tolerance, and MuJoCo's integrators, those of order one that differ in how they
/// treat dampers alone together.
const BESIDE: [(&str, &[&str]); 4] = [
    ("ours, a tolerance of the run", &["tolerance of the run"]),
    ("RK4", &["MuJoCo: RK4"]),
    ("implicit", &["MuJoCo: implicit"]),
    ("Euler, implicitfast, discrete", &["MuJoCo: Euler", "MuJoCo: implicitfast", "MuJoCo: discrete"]),
];

pub(super) fn tables(measured: &[Measured]) -> Vec<(&'static str, Table)> {
    vec![
        ("beside MuJoCo", ratios(measured)),
        ("beside MuJoCo, steps", steps(measured)),
        ("beside MuJoCo, answers", answers(measured)),
    ]
}

/// Steps of a run that shows what it costs beside them.
const FEW: f64 = 128.0;

/// Where, when and with what.
pub(super) fn circumstances(peer: &MuJoCo) -> String {
    format!("{} MuJoCo {} from C, SciPy {}.", page::circumstances(), peer.version, peer.scipy)
}

fn ratios(measured: &[Measured]) -> Table {
    let mut rows = Vec::new();
    for Measured { scene, series, .. } in measured {
        let ours: Vec<Option<(f64, &str)>> = ERRORS.iter().map(|error| quickest(series, *error)).collect();
        let own = ours.iter().map(|found| {
            Cell::Time(found.map_or("–".to_owned(), |(seconds, name)| {
                format!("{} {}", page::duration(1e9 * seconds), short(name))
            }))
        });
        rows.push([Cell::text(scene.name), Cell::text("ours")].into_iter().chain(own).collect());
        for (name, of) in BESIDE {
            let theirs: Vec<&Series> = series.iter().filter(|series| of.contains(&series.name)).collect();
            let cells =
                ERRORS.iter().zip(&ours).map(|(error, ours)| Cell::Time(ratio(&theirs, *error, *ours)));
            rows.push([Cell::text(""), Cell::text(name)].into_iter().chain(cells).collect());
        }
    }
    let header = vec!["error at the end (rad or m)", "by", "1e-2", "1e-3", "1e-4", "1e-6", "1e-8", "1e-10"];
    Table { header, rows }
}

/// Our least time, and by which method.
fn quickest(series: &[Series], error: f64) -> Option<(f64, &'static str)> {
    let ours = series.iter().filter(|series| series.is_ours);
    let times = ours.filter_map(|series| Some((time(series, error, 0)?, series.name)));
    times.min_by(|a, b| a.0.total_cmp(&b.0))
}

fn short(name: &str) -> &'static str {
    match name {
        "Runge-Kutta 4" => "R",
        "adaptive" => "A",
        "semi-implicit Euler" => "E",
        _ => "T",
    }
}

/// How many times as long they take: more than so many where their finest setting is not good enough.
fn ratio(theirs: &[&Series], error: f64, ours: Option<(f64, &str)>) -> String {
    let Some((ours, _)) = ours else { return "–".to_owned() };
    let least = theirs.iter().filter_map(|series| time(series, error, 0)).min_by(f64::total_cmp);
    if let Some(least) = least {
        return times(least / ours);
    }
    let longest = theirs.iter().filter_map(|series| series.points.last()).map(|point| point.seconds);
    format!("> {}", times(longest.fold(f64::INFINITY, f64::min) / ours))
}

/// Two digits.
fn times(ratio: f64) -> String {
    match ratio {
        ..10.0 => format!("{ratio:.1}"),
        ..100.0 => format!("{ratio:.0}"),
        _ => format!("{:.0}", 10.0 * (0.1 * ratio).round()),
    }
}

/// What a step costs, and a run beside its steps.
fn steps(measured: &[Measured]) -> Table {
    let row = |Measured { scene, series, .. }: &Measured| {
        let [ours, theirs] = ["Runge-Kutta 4", "MuJoCo: RK4"].map(|name| line(series, name));
        let euler = ["semi-implicit Euler", "MuJoCo: Euler"].map(|name| line(series, name).1);
        let time = |seconds: f64| Cell::Time(page::duration(1e9 * seconds));
        vec![
            Cell::text(scene.name),
            time(ours.1),
            time(theirs.1),
            Cell::Time(times(theirs.1 / ours.1)),
            time(euler[0]),
            time(euler[1]),
            Cell::Time(times(euler[1] / euler[0])),
            time(ours.0.max(0.0)),
        ]
    };
    let header = vec![
        "a step",
        "Runge-Kutta 4",
        "MuJoCo RK4",
        "ratio",
        "semi-implicit Euler",
        "MuJoCo Euler",
        "ratio",
        "ours, beside the steps",
    ];
    Table { header, rows: measured.iter().map(row).collect() }
}

/// Time beside the steps, as seen by few of them, and of each (s).
fn line(series: &[Series], name: &str) -> (f64, f64) {
    let found = series.iter().find(|series| series.name == name).map(|series| series.points.as_slice());
    let points = found.unwrap_or_default();
    let each = points.iter().map(|point| point.seconds / point.count).fold(f64::INFINITY, f64::min);
    let few = points.iter().filter(|point| point.count <= FEW);
    (few.map(|point| point.seconds - each * point.count).fold(f64::INFINITY, f64::min), each)
}

/// How far the answers of scenes in the air are from each other.
fn answers(measured: &[Measured]) -> Table {
    let row = |Measured { scene, agreement, .. }: &Measured| {
        let apart = (*agreement)?;
        let cells = apart.map(|apart| Cell::Numbers(vec![apart.max(1e-13)]));
        Some(std::iter::once(Cell::text(scene.name)).chain(cells).collect())
    };
    let header = vec![
        "apart at the end (rad, m; rad/s, m/s)",
        "Runge-Kutta 4, 65536 and 32768 steps",
        "and DOP853 on MuJoCo's accelerations",
    ];
    Table { header, rows: measured.iter().filter_map(row).collect() }
}
