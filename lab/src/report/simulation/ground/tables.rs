//! The tables of what is measured on a ground.

use super::resting::{self, RATIOS};
use super::scenes;
use crate::report::simulation::tables::{cell, fixed};
use crate::table::{Cell, Table};
use solaris_modes::{Method, Rule};

type Tables = Vec<(&'static str, Table)>;

const AUTOMATIC: Method = Method::Automatic { tolerance: 1e-6 };

pub(super) const fn runge_kutta(step: f64) -> Method {
    fixed(Rule::RungeKutta4, step)
}

/// What the run said of itself, where it says so, with the error and the evaluations; or why there is none.
fn found(found: Result<super::Found, String>) -> Cell {
    match found {
        Ok(found) => {
            let errors = found.said.into_iter().chain([found.error]).map(|error| error.max(1e-13));
            Cell::Numbers(errors.chain([found.evaluations]).collect())
        }
        Err(said) => Cell::text(said),
    }
}

/// Scenes with a known answer by some methods.
fn known(methods: &[Method], header: Vec<&'static str>) -> Result<Table, String> {
    let row = |scene: &super::Scene| {
        let cells = methods.iter().map(|method| found(scene.by(*method)));
        std::iter::once(Cell::text(scene.name.clone())).chain(cells).collect()
    };
    let header = std::iter::once("error (rad or m) / evaluations").chain(header).collect();
    Ok(Table { header, rows: scenes::all()?.iter().map(row).collect() })
}

/// So many steps to a frame, for an order: where in a step a touch begins is chance.
pub(super) const STEPS: [u32; 13] = [5, 6, 7, 8, 10, 12, 14, 17, 20, 24, 28, 34, 40];

/// Of these, what is shown.
const SHOWN: [u32; 4] = [5, 10, 20, 40];

/// The same by ever shorter steps, and the power of the step with which the error falls.
fn orders() -> Result<Table, String> {
    let row = |scene: &super::Scene| {
        let error = |count: u32| {
            let step = (super::RATE * f64::from(count)).recip();
            scene.by(runge_kutta(step)).map_or(f64::INFINITY, |found| found.error)
        };
        let errors: Vec<(u32, f64)> = STEPS.iter().map(|count| (*count, error(*count))).collect();
        let mut row = vec![Cell::text(scene.name.clone())];
        let shown = errors.iter().filter(|(count, _)| SHOWN.contains(count));
        row.extend(shown.map(|(_, error)| cell(*error)));
        row.push(Cell::text(order(&errors)));
        row
    };
    let header = vec!["Runge-Kutta 4", "2e-3 s", "1e-3 s", "5e-4 s", "2.5e-4 s", "order seen"];
    Ok(Table { header, rows: scenes::all()?.iter().map(row).collect() })
}

/// The slope of the straight line through the logarithms of the errors above rounding.
fn order(errors: &[(u32, f64)]) -> String {
    let points: Vec<(f64, f64)> = errors
        .iter()
        .filter(|(_, error)| error.is_finite() && *error > 1e-12)
        .map(|(count, error)| (-f64::from(*count).ln(), error.ln()))
        .collect();
    if points.len() < 3 {
        return "exact".to_owned();
    }
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let along: f64 = points.iter().map(|point| (point.0 - x).powi(2)).sum();
    let both: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    format!("{:.0}", both / along)
}

/// Grounds from soft to hard.
fn stiffness(methods: &[Method], header: Vec<&'static str>) -> Result<Table, String> {
    let row = |ground: &resting::Ground| {
        let longest = ground.longest.map_or(Cell::text("no bound"), |step| Cell::Numbers(vec![step]));
        let cells = methods.iter().map(|method| found(ground.scene.by(*method)));
        [Cell::text(ground.scene.name.clone()), longest].into_iter().chain(cells).collect()
    };
    let header = ["error (m) / evaluations", "longest stable step (s)"].into_iter().chain(header).collect();
    Ok(Table { header, rows: resting::grounds()?.iter().map(row).collect() })
}

/// Feet from light to heavy.
fn feet(method: Method) -> Table {
    let row = |(ratio, planted): (f64, bool)| {
        let name = format!("{ratio:e} : 1, {}", if planted { "Rigid" } else { "springs" });
        let mut row = vec![Cell::text(name)];
        match resting::foot(ratio, planted, method) {
            Ok(stood) => {
                row.extend([stood.off, stood.energy, stood.said].map(cell));
                row.extend([Cell::Numbers(vec![stood.evaluations]), Cell::text("")]);
            }
            Err(said) => {
                row.extend(vec![Cell::text("–"); 4]);
                row.push(Cell::text(said));
            }
        }
        row
    };
    let header = vec!["foot : body", "force − weight, share", "energy, share", "said (m)", "evaluations", ""];
    let all = [false, true].into_iter().flat_map(|planted| RATIOS.map(|ratio| (ratio, planted)));
    Table { header, rows: all.map(row).collect() }
}

/// Tables that need no more than the fixed rules.
pub(in crate::report::simulation) fn all() -> Result<Tables, String> {
    let methods = [
        fixed(Rule::SemiImplicitEuler, 1e-3),
        runge_kutta(1e-3),
        runge_kutta(1e-4),
        runge_kutta(1e-5),
        AUTOMATIC,
    ];
    let header = vec![
        "semi-implicit Euler, 1e-3 s",
        "Runge-Kutta 4, 1e-3 s",
        "Runge-Kutta 4, 1e-4 s",
        "Runge-Kutta 4, 1e-5 s",
        "tolerance 1e-6: said / error / evaluations",
    ];
    let sweep = [runge_kutta(1e-3), runge_kutta(1e-4), AUTOMATIC];
    let swept =
        vec!["Runge-Kutta 4, 1e-3 s", "Runge-Kutta 4, 1e-4 s", "tolerance 1e-6: said / error / evaluations"];
    Ok(vec![
        ("on the ground", known(&methods, header)?),
        ("on the ground, orders", orders()?),
        ("on the ground, stiffness", stiffness(&sweep, swept)?),
        ("on the ground, feet", feet(AUTOMATIC)),
    ])
}

/// Tables of the methods that choose their steps.
#[cfg(feature = "stiff")]
pub(in crate::report::simulation) fn adaptive() -> Result<Tables, String> {
    let methods = [(1e-6, false), (1e-9, false), (1e-6, true), (1e-9, true)].map(|(tolerance, is_stiff)| {
        if is_stiff { Method::Stiff { tolerance } } else { Method::Adaptive { tolerance } }
    });
    let header = vec!["adaptive, 1e-6", "adaptive, 1e-9", "stiff, 1e-6", "stiff, 1e-9"];
    Ok(vec![
        ("on the ground, adaptive", known(&methods, header.clone())?),
        ("on the ground, stiffness, adaptive", stiffness(&methods, header)?),
        ("on the ground, feet, adaptive", feet(AUTOMATIC)),
    ])
}
