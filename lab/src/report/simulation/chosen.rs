//! What a tolerance of the run costs, beside the cheapest setting that is as good: a table and a picture of docs/trust.md.

use super::figures::{Case, closed, conserved};
use super::ground::{resting, scenes};
use super::tables::fixed;
use crate::table::{self, Cell, Table};
use crate::workspace::{read, write};
use solaris_modes::study::{Row, Study, StudyOptions, study};
use solaris_modes::{Method, Rule, Settings};
use solaris_view::precision::{Against, Diagram, Point, Series, svg};

const PAGE: &str = "docs/trust.md";

/// The errors that are wanted (rad or m).
const WANTED: [f64; 3] = [1e-4, 1e-6, 1e-8];

/// Scenes of the fixtures whose motion can be compared to its end.
const FIXTURES: [&str; 15] = [
    "arm_modes",
    "carried",
    "falling_cat",
    "jump",
    "literal",
    "pendulum",
    "pushed",
    "reach",
    "sequence",
    "servos",
    "slide",
    "standing",
    "tops",
    "two",
    "walk_loose_arm",
];

/// What is run.
fn methods() -> Vec<Method> {
    let steps = [1.0 / 30.0, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5];
    let tolerances = (4..=24).map(|half| 10_f64.powf(-0.5 * f64::from(half)));
    let is_stiff = cfg!(feature = "stiff");
    steps
        .map(|step| fixed(Rule::SemiImplicitEuler, step))
        .into_iter()
        .chain(steps.map(|step| fixed(Rule::RungeKutta4, step)))
        .chain(tolerances.clone().map(|tolerance| Method::Adaptive { tolerance }))
        .chain(tolerances.filter(|_| is_stiff).map(|tolerance| Method::Stiff { tolerance }))
        .chain(WANTED.map(|tolerance| Method::Automatic { tolerance }))
        .collect()
}

fn all() -> Result<Vec<Case>, String> {
    let mut cases = closed()?;
    cases.extend(conserved()?);
    let of = |scene: super::ground::Scene| Case {
        name: Box::leak(scene.name.into_boxed_str()),
        simulation: scene.simulation,
        duration: scene.duration,
        rate: 100.0,
        solution: Some(scene.solution),
    };
    cases.extend(scenes::all()?.into_iter().map(of));
    cases.extend(resting::grounds()?.into_iter().map(|ground| of(ground.scene)));
    for name in FIXTURES {
        let path = format!("fixtures/scenes/{name}.ron");
        let scene = solaris_scene::read(&read(&path)?, &mut solaris_scene::NoFiles)
            .map_err(|error| format!("{path}: {error:?}"))?;
        cases.push(Case {
            name,
            simulation: scene.simulation().clone(),
            duration: scene.settings().duration,
            rate: scene.settings().rate,
            solution: None,
        });
    }
    Ok(cases)
}

/// A study of every scene by every setting.
fn studies() -> Result<Vec<(&'static str, Study)>, String> {
    let of = |case: Case| {
        eprintln!("report: {}, all settings", case.name);
        let options = StudyOptions {
            methods: methods(),
            solution: case.solution.as_deref().map(|solution| solution as _),
            repeats: 1,
            evaluations: 2_000_000,
            ..StudyOptions::default()
        };
        let settings = Settings::new(case.duration, case.rate);
        let found = study(&case.simulation, &settings, &options, &mut (), &mut |_| {});
        found.map(|study| (case.name, study)).map_err(|error| format!("{}: {error}", case.name))
    };
    all()?.into_iter().map(of).collect()
}

fn error(row: &Row) -> Option<f64> {
    row.result.as_ref().ok().map(|accuracy| accuracy.position)
}

/// The setting of the fewest evaluations that is as good as wanted, of all that do not look for one themselves.
fn cheapest(study: &Study, wanted: f64) -> Option<&Row> {
    let rows = study.rows.iter().filter(|row| !matches!(row.method, Method::Automatic { .. }));
    let meets = |row: &&Row| error(row).is_some_and(|error| error <= wanted);
    rows.filter(meets).min_by_key(|row| row.counts.evaluations)
}

/// What the tolerance took, and how many times as much as the cheapest setting; none where either came to nothing.
fn costs(study: &Study, wanted: f64) -> Option<(f64, f64)> {
    let chosen = study.rows.iter().find(|row| row.method == Method::Automatic { tolerance: wanted })?;
    let evaluations = chosen.counts.evaluations as f64;
    error(chosen)?;
    Some((evaluations, evaluations / cheapest(study, wanted)?.counts.evaluations as f64))
}

fn table(studies: &[(&'static str, Study)]) -> Table {
    let row = |(name, study): &(&'static str, Study)| {
        let cells = WANTED.iter().map(|wanted| match costs(study, *wanted) {
            Some((evaluations, ratio)) => Cell::Numbers(vec![evaluations, ratio]),
            None => Cell::text("–"),
        });
        let best = cheapest(study, WANTED[1]).map_or_else(|| "–".to_owned(), Row::to_string);
        std::iter::once(Cell::text(*name)).chain(cells).chain([Cell::Time(best)]).collect()
    };
    let mut rows: Vec<Vec<Cell>> = studies.iter().map(row).collect();
    let mut medians = vec![Cell::text("median")];
    for wanted in WANTED {
        let mut ratios: Vec<f64> =
            studies.iter().filter_map(|(_, study)| costs(study, wanted)).map(|(_, ratio)| ratio).collect();
        ratios.sort_by(f64::total_cmp);
        medians.push(Cell::Numbers(ratios.get(ratios.len() / 2).copied().into_iter().collect()));
    }
    medians.push(Cell::text(""));
    rows.push(medians);
    Table {
        header: vec![
            "evaluations / times the cheapest",
            "tolerance 1e-4",
            "tolerance 1e-6",
            "tolerance 1e-8",
            "the cheapest for 1e-6",
        ],
        rows,
    }
}

/// Every tolerance of every scene: how far off it is, against how many times the cheapest setting it took.
fn picture(studies: &[(&'static str, Study)]) -> Diagram {
    let of = |wanted: f64| {
        let point = |(name, study): &(&'static str, Study)| {
            let chosen = study.rows.iter().find(|row| row.method == Method::Automatic { tolerance: wanted });
            let found = chosen.and_then(error).zip(chosen);
            found.map(|(error, row)| Point {
                label: (*name).to_owned(),
                seconds: None,
                evaluations: Some(row.counts.evaluations as f64),
                error: Some(error.max(1e-13)),
            })
        };
        let mut points: Vec<Point> = studies.iter().filter_map(point).collect();
        points.sort_by(|a, b| a.evaluations.unwrap_or(0.0).total_cmp(&b.evaluations.unwrap_or(0.0)));
        for point in &mut points {
            point.label.clear();
        }
        Series { name: format!("tolerance {wanted:e}"), points }
    };
    Diagram {
        title: "A tolerance of the run: every scene".to_owned(),
        subtitle: "worst frame, against closed forms or the finest run".to_owned(),
        error: "positions (rad or m)".to_owned(),
        series: WANTED.map(of).into(),
        ..Diagram::default()
    }
}

/// Measures, and writes both.
pub(super) fn run() -> Result<(), String> {
    let studies = studies()?;
    let text = table::replace(&read(PAGE)?, "chosen", &table(&studies).markdown())
        .map_err(|error| format!("{PAGE}: {error}"))?;
    write(PAGE, &text)?;
    write("docs/trust/chosen.svg", &svg(&picture(&studies), Against::Evaluations))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[ignore = "all scenes by all settings, a minute: cargo xtask nightly"]
    fn the_page_says_what_a_tolerance_costs() {
        let studies = studies().expect("every scene runs");
        let differences = table(&studies)
            .differences(table::block(&read(PAGE).expect("the page"), "chosen").expect("a table"));
        assert!(
            differences.is_empty(),
            "{PAGE}: `cargo lab report chosen` is due:\n{}",
            differences.join("\n")
        );
    }
}
