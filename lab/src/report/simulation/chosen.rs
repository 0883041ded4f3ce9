//! What a tolerance of the run costs, beside the cheapest setting that is as good.

use super::figures::{Case, closed, conserved};
use super::ground::{resting, scenes};
use super::tables::fixed;
use crate::workspace::read;
use solaris_modes::study::{Row, Study, StudyOptions, study};
use solaris_modes::{Method, Rule, Settings};

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

fn cheapest(study: &Study, wanted: f64) -> Option<&Row> {
    let meets = |row: &&Row| {
        let error = row.result.as_ref().ok().map(|accuracy| accuracy.position);
        error.is_some_and(|error| error <= wanted) && !matches!(row.method, Method::Automatic { .. })
    };
    study.rows.iter().filter(meets).min_by_key(|row| row.counts.evaluations)
}

pub(super) fn run() -> Result<(), String> {
    let only = std::env::var("ONLY").ok();
    let verbose = std::env::var("ROWS").is_ok();
    let mut ratios = vec![Vec::new(); 3];
    for case in all()? {
        if only.as_ref().is_some_and(|only| !case.name.contains(only.as_str())) {
            continue;
        }
        let mut settings = Settings::new(case.duration, case.rate);
        settings.method = Method::Automatic { tolerance: 1e-6 };
        let options = StudyOptions {
            methods: methods(),
            solution: case.solution.as_deref().map(|solution| solution as _),
            repeats: 1,
            evaluations: 2_000_000,
            ..StudyOptions::default()
        };
        let study = match study(&case.simulation, &settings, &options, &mut (), &mut |_| {}) {
            Ok(study) => study,
            Err(error) => {
                println!("{}: {error}", case.name);
                continue;
            }
        };
        if verbose {
            for row in &study.rows {
                println!("    {row}: {} {:?}", row.counts.evaluations, row.result.as_ref().map(|a| a.position));
            }
        }
        println!("{} [{} known to {:.1e}, comparable until {:.3}]", case.name, study.reference.name, study.reference.uncertainty.position, study.sensitivity.comparable_until);
        for (i, wanted) in WANTED.into_iter().enumerate() {
            let auto = study.rows.iter().find(|row| row.method == Method::Automatic { tolerance: wanted });
            let Some(auto) = auto else { continue };
            let best = cheapest(&study, wanted);
            let of_best = best.map_or(0, |row| row.counts.evaluations);
            let ratio = auto.counts.evaluations as f64 / of_best as f64;
            let result = match &auto.result {
                Ok(a) => format!("said {:.1e} is {:.1e}", a.estimate.unwrap_or(f64::NAN), a.position),
                Err(e) => e.chars().take(90).collect(),
            };
            println!("  {wanted:e}: {} / {of_best} = {ratio:.2}  best {}  {result}", auto.counts.evaluations, best.map_or(String::new(), |row| row.to_string()));
            if best.is_some() && auto.result.is_ok() {
                ratios[i].push(ratio);
            }
        }
    }
    for (wanted, ratios) in WANTED.iter().zip(&mut ratios) {
        ratios.sort_by(f64::total_cmp);
        if !ratios.is_empty() {
            println!("{wanted:e}: median {:.2}, worst {:.1}, of {}", ratios[ratios.len() / 2], ratios[ratios.len() - 1], ratios.len());
        }
    }
    Ok(())
}
