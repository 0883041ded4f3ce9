//! The pictures of error against evaluations on a ground.

use super::resting::hard;
use super::tables::{STEPS, runge_kutta};
use super::{RATE, Scene, scenes};
use crate::report::simulation::tables::fixed;
use solaris_modes::study::{method_name, setting};
use solaris_modes::{Method, Rule};
use solaris_view::precision::{Diagram, Point, Series};

/// Of all scenes by one rule, and of one scene by all methods.
pub(in crate::report::simulation) fn diagrams() -> Result<[(&'static str, Diagram); 2], String> {
    // Where a touch begins within a step is chance, which ever more steps show.
    let steps = STEPS.map(|count| (RATE * f64::from(count)).recip());
    let by_rule = |scene: &Scene| Series {
        name: scene.name.clone(),
        points: steps.iter().map(|step| point(scene, runge_kutta(*step), "")).collect(),
    };
    let scenes = Diagram {
        title: "On the ground: Runge-Kutta 4, steps of 2e-3 to 2.5e-4 s".to_owned(),
        subtitle: "worst frame, against closed forms".to_owned(),
        error: "positions (rad or m)".to_owned(),
        series: scenes::all()?.iter().map(by_rule).collect(),
        ..Diagram::default()
    };
    let scene = hard()?;
    let tolerances = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];
    let by_steps = |rule: Rule| {
        [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5].map(|step| fixed(rule, step)).to_vec()
    };
    let all = [
        by_steps(Rule::SemiImplicitEuler),
        by_steps(Rule::RungeKutta4),
        tolerances.map(|tolerance| Method::Adaptive { tolerance }).to_vec(),
        tolerances.map(|tolerance| Method::Stiff { tolerance }).to_vec(),
    ];
    let by_method = |methods: &Vec<Method>| Series {
        name: method_name(methods[0]).clone(),
        points: methods
            .iter()
            .map(|method| point(&scene, *method, &setting(*method).replace(" s", "")))
            .collect(),
    };
    let methods = Diagram {
        title: scene.name.clone(),
        subtitle:
            "dropped from 1 cm, worst frame of 0.5 s, against an integration that splits its steps at touches"
                .to_owned(),
        error: "positions (m)".to_owned(),
        series: all.iter().map(by_method).collect(),
        wanted: Some(1e-6),
        ..Diagram::default()
    };
    Ok([("ground-scenes", scenes), ("ground-methods", methods)])
}

fn point(scene: &Scene, method: Method, label: &str) -> Point {
    let found = scene.by(method).ok();
    let planned = match method {
        Method::Fixed { rule, step } => Some(scene.duration / step * rule.evaluations() as f64),
        _ => None,
    };
    Point {
        label: label.to_owned(),
        seconds: None,
        evaluations: found.as_ref().map(|found| found.evaluations).or(planned),
        error: found.map(|found| found.error.max(1e-13)),
    }
}
