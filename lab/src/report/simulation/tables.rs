//! The tables of docs/trust.md.

use super::between::{self, KINDS, RATES};
use super::extremes::{self, Spring};
use super::figures::{Case, closed, conserved, governor, studied};
use super::widths;
use crate::table::{Cell, Table, number};
use solaris_modes::study::{Accuracy, Row, method_name, setting};
use solaris_modes::{Method, Rule, Settings};

pub(super) const fn fixed(rule: Rule, step: f64) -> Method {
    Method::Fixed { rule, step }
}

/// The settings of the table of closed forms.
const PLAIN: [Method; 6] = [
    fixed(Rule::ExplicitEuler, 1e-3),
    fixed(Rule::SemiImplicitEuler, 1e-3),
    fixed(Rule::ConstantAcceleration, 1e-3),
    fixed(Rule::RungeKutta4, 1e-2),
    fixed(Rule::RungeKutta4, 1e-3),
    fixed(Rule::RungeKutta4, 1e-4),
];

/// The tolerances of those that choose.
const TOLERANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// The error of a row, infinite where it failed.
fn error(row: &Row) -> f64 {
    row.result.as_ref().map_or(f64::INFINITY, |accuracy| accuracy.position)
}

/// The error with the least that is told: what is less counts as 1e-13.
pub(super) fn cell(error: f64) -> Cell {
    Cell::Numbers(vec![if error < 1e-13 { 1e-13 } else { error }])
}

/// A table of cases and methods.
fn by_method(
    first: &'static str,
    cases: &[Case],
    methods: &[Method],
    header: Vec<&'static str>,
) -> Result<Table, String> {
    let row = |case: &Case| {
        let study = studied(case, methods)?;
        let mut row = vec![Cell::text(case.name)];
        row.extend(study.rows.iter().map(|row| cell(error(row))));
        Ok(row)
    };
    let header = std::iter::once(first).chain(header).collect();
    Ok(Table { header, rows: cases.iter().map(row).collect::<Result<_, String>>()? })
}

/// Fixed rules where the answer is known.
pub(super) fn closed_forms() -> Result<Table, String> {
    let header = vec![
        "explicit Euler, 1e-3 s",
        "semi-implicit Euler, 1e-3 s",
        "constant acceleration, 1e-3 s",
        "Runge-Kutta 4, 1e-2 s",
        "Runge-Kutta 4, 1e-3 s",
        "Runge-Kutta 4, 1e-4 s",
    ];
    by_method("worst position (rad or m)", &closed()?, &PLAIN, header)
}

/// What a run says of itself beside what is true.
pub(super) fn estimates() -> Result<Table, String> {
    let methods = TOLERANCES.map(|tolerance| Method::Automatic { tolerance });
    let row = |case: &Case| {
        let study = studied(case, &methods)?;
        let mut row = vec![Cell::text(case.name)];
        for found in &study.rows {
            let (said, is) = found.result.as_ref().map_or((f64::INFINITY, f64::INFINITY), |accuracy| {
                (accuracy.estimate.unwrap_or(f64::INFINITY), accuracy.position)
            });
            row.push(Cell::Numbers([said, is].map(|x| if x < 1e-13 { 1e-13 } else { x }).into()));
        }
        Ok(row)
    };
    Ok(Table {
        header: vec!["said / is (rad or m)", "tolerance 1e-3", "tolerance 1e-6", "tolerance 1e-9"],
        rows: closed()?.iter().map(row).collect::<Result<_, String>>()?,
    })
}

/// Energy and momentum where nothing changes them.
pub(super) fn kept() -> Result<Table, String> {
    let methods = [
        fixed(Rule::SemiImplicitEuler, 1e-3),
        fixed(Rule::RungeKutta4, 1e-2),
        fixed(Rule::RungeKutta4, 1e-3),
    ];
    let mut rows = Vec::new();
    for case in &conserved()? {
        for row in studied(case, &methods)?.rows {
            let Accuracy { energy, momentum, .. } =
                row.result.as_ref().map_err(|trouble| format!("{}: {trouble}", case.name))?;
            let momentum = momentum.unwrap_or_default();
            rows.push(vec![
                Cell::text(format!("{}, {row}", case.name)),
                cell(*energy),
                cell(momentum.linear),
                cell(momentum.angular),
            ]);
        }
    }
    Ok(Table { header: vec!["drift", "energy, share", "momentum (N s)", "angular momentum (N m s)"], rows })
}

/// `s` of the governor (m) at some times (s), published with the benchmark.
const GOVERNOR: [(f64, f64); 7] = [
    (0.5, 0.743_249_425),
    (1.0, 0.501_420_922),
    (2.0, 0.505_909_294),
    (3.0, 0.513_246_078),
    (5.0, 0.535_563_104),
    (8.0, 0.583_178_337),
    (10.0, 0.619_622_917),
];

/// The governor by some methods, against the published table.
pub(super) fn governor_by(methods: &[Method]) -> Result<Table, String> {
    let case = governor()?;
    let row = |method: &Method| {
        let settings =
            Settings { method: *method, forces: false, estimate: false, ..Settings::new(10.0, 10.0) };
        let name = Cell::text(format!("{}, {}", method_name(*method), setting(*method)));
        match case.simulation.run(&settings) {
            Err(trouble) => vec![name, Cell::text("–"), Cell::text("–"), Cell::text(trouble.to_string())],
            Ok(run) => {
                let s = |time: f64| run.motion.q((time * 10.0).round() as usize)[1];
                let worst = GOVERNOR.iter().map(|(t, known)| (s(*t) - known).abs()).fold(0.0, f64::max);
                let evaluations = run.report.cost.counts.evaluations as f64;
                vec![
                    name,
                    Cell::Numbers(vec![evaluations]),
                    Cell::Numbers(vec![worst.max(1e-9)]),
                    Cell::text(""),
                ]
            }
        }
    };
    Ok(Table {
        header: vec!["governor, 10 s", "evaluations", "error of s (m)", ""],
        rows: methods.iter().map(row).collect(),
    })
}

/// The governor by fixed steps.
pub(super) fn governor_fixed() -> Result<Table, String> {
    governor_by(&[
        fixed(Rule::RungeKutta4, 1e-3),
        fixed(Rule::RungeKutta4, 3e-4),
        fixed(Rule::RungeKutta4, 1e-4),
        fixed(Rule::ExplicitEuler, 1e-4),
    ])
}

/// Mass ratios far from one.
pub(super) fn ratios() -> Result<Table, String> {
    let row = |(ratio, errors): &(f64, extremes::Errors)| {
        let cells = match errors {
            Ok(errors) => errors.map(cell),
            Err(said) => [Cell::text(said), Cell::text("–"), Cell::text("–")],
        };
        std::iter::once(Cell::text(format!("1 : {ratio:e}"))).chain(cells).collect()
    };
    Ok(Table {
        header: vec!["masses, upper : lower", "Runge-Kutta 4, 1e-2 s", "Runge-Kutta 4, 1e-3 s", "known to"],
        rows: extremes::ratios()?.iter().map(row).collect(),
    })
}

/// Single evaluations far from ordinary.
fn evaluations() -> Result<Table, String> {
    let row = |(name, losses): &(&'static str, [f64; 2])| {
        std::iter::once(Cell::text(*name)).chain(losses.map(|loss| Cell::Numbers(vec![loss]))).collect()
    };
    Ok(Table {
        header: vec!["lost, f64", "inverse dynamics", "forward dynamics"],
        rows: extremes::evaluations()?.iter().map(row).collect(),
    })
}

/// A million seconds.
fn long() -> Result<Table, String> {
    let row = |(method, [off, energy], evaluations): &(Method, [f64; 2], u64)| {
        vec![
            Cell::text(format!("{}, {}", method_name(*method), setting(*method))),
            cell(*off),
            cell(*energy),
            Cell::Numbers(vec![*evaluations as f64]),
        ]
    };
    Ok(Table {
        header: vec!["pendulum, 1e6 s", "off (rad)", "energy, share", "evaluations"],
        rows: extremes::long()?.iter().map(row).collect(),
    })
}

/// Springs from soft to hard.
pub(super) fn stiffness() -> Result<Table, String> {
    let row = |found: &Spring| {
        let said = |result: &Result<f64, String>| match result {
            Ok(error) => cell(*error),
            Err(trouble) => Cell::text(trouble.clone()),
        };
        vec![
            Cell::text(format!("{:e}", found.stiffness)),
            Cell::Numbers(vec![found.longest]),
            said(&found.at_a_millisecond),
            said(&found.automatic),
        ]
    };
    Ok(Table {
        header: vec![
            "stiffness (N/m) on 1 kg",
            "longest stable step (s)",
            "Runge-Kutta 4, 1e-3 s",
            "tolerance 1e-6",
        ],
        rows: extremes::springs()?.iter().map(row).collect(),
    })
}

/// f32 beside f64.
pub(super) fn precisions() -> Result<Table, String> {
    let row = |step: &f64| {
        let [single, double] = [widths::error::<f32>(*step), widths::error::<f64>(*step)];
        Ok(vec![Cell::text(number(*step)), cell(single?), cell(double?)])
    };
    Ok(Table {
        header: vec!["pendulum, 10 s: step (s)", "f32", "f64"],
        rows: widths::STEPS.iter().map(row).collect::<Result<_, String>>()?,
    })
}

/// Between frames.
pub(super) fn in_betweens() -> Table {
    let row = |rate: &f64| {
        let mut row = vec![Cell::text(format!("{rate}"))];
        row.extend(KINDS.map(|kind| cell(between::error(kind, *rate))));
        row
    };
    Table {
        header: vec!["frames/s", "straight lines", "cubics, by velocities", "quintics, by accelerations"],
        rows: RATES.iter().map(row).collect(),
    }
}

/// Tables that need no more than the fixed rules.
pub(super) fn all() -> Result<Vec<(&'static str, Table)>, String> {
    Ok(vec![
        ("closed forms", closed_forms()?),
        ("estimates", estimates()?),
        ("kept", kept()?),
        ("governor", governor_fixed()?),
        ("ratios", ratios()?),
        ("stiffness", stiffness()?),
        ("far evaluations", evaluations()?),
        ("a million seconds", long()?),
        ("precisions", precisions()?),
        ("in-betweens", in_betweens()),
    ])
}

/// Tables of the methods that choose their steps.
#[cfg(feature = "stiff")]
pub(super) mod adaptive {
    use super::{Method, Table, by_method, closed, governor_by};

    fn adaptive(tolerance: f64) -> Method {
        Method::Adaptive { tolerance }
    }

    fn stiff(tolerance: f64) -> Method {
        Method::Stiff { tolerance }
    }

    pub(in crate::report::simulation) fn all() -> Result<Vec<(&'static str, Table)>, String> {
        let methods = [adaptive(1e-6), adaptive(1e-9), stiff(1e-6), stiff(1e-9)];
        let header = vec!["adaptive, 1e-6", "adaptive, 1e-9", "stiff, 1e-6", "stiff, 1e-9"];
        let governor = [stiff(1e-4), stiff(1e-6), stiff(1e-8), stiff(1e-10), adaptive(1e-4), adaptive(1e-8)];
        Ok(vec![
            ("adaptive", by_method("worst position (rad or m)", &closed()?, &methods, header)?),
            ("governor, adaptive", governor_by(&governor)?),
            ("equations", crate::report::simulation::systems::table()?),
        ])
    }
}
