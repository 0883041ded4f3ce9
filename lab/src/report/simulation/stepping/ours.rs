//! Our side.

use super::bodies::{FRICTION, Scene};
use super::points::{End, Point, Series};
use crate::report::simulation::figures::G;
use solaris_modes::{Method, Rule, RunError, Settings, Simulation};
use std::time::Instant;

/// Runs of a setting are repeated for so long (s), but three times where that is no longer than the second.
const SPENT: [f64; 2] = [0.08, 0.3];

/// Steps of a run.
const STEPS: [u32; 15] = [2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16_384, 32_768];

/// The steps of the finest run.
const FINEST: u32 = 65_536;

/// Frames a second where the library looks for the step: it begins with one to a frame.
const RATE: f64 = 100.0;

/// One frame, the last, where nobody asked for others.
fn settings(scene: &Scene, method: Method) -> Settings {
    let rate = if let Method::Automatic { .. } = method { RATE } else { scene.duration.recip() };
    let mut settings =
        Settings { method, forces: false, estimate: false, ..Settings::new(scene.duration, rate) };
    settings.guard.evaluations = 2_000_000;
    settings
}

fn end(simulation: &Simulation, settings: &Settings) -> Result<End, RunError> {
    let motion = simulation.run(settings)?.motion;
    let last = motion.len() - 1;
    Ok((motion.q(last).to_vec(), motion.v(last).to_vec()))
}

/// The end of the finest run, and of one with twice its step.
pub(super) fn finest(scene: &Scene) -> Result<[End; 2], String> {
    let by = |steps: u32| {
        let method = fixed(scene, Rule::RungeKutta4, steps);
        end(&scene.simulation, &settings(scene, method)).map_err(|error| format!("{}: {error}", scene.name))
    };
    Ok([by(FINEST)?, by(FINEST / 2)?])
}

fn fixed(scene: &Scene, rule: Rule, steps: u32) -> Method {
    Method::Fixed { rule, step: scene.duration / f64::from(steps) }
}

/// Every method at every setting.
pub(super) fn series(scene: &Scene, answer: &End) -> Vec<Series> {
    let tolerances = |least: i32| (1..=least).map(|digits| 10_f64.powi(-digits));
    let by_rule = |rule: Rule| STEPS.iter().map(|steps| fixed(scene, rule, *steps)).collect::<Vec<_>>();
    let all = [
        ("Runge-Kutta 4", by_rule(Rule::RungeKutta4)),
        ("semi-implicit Euler", by_rule(Rule::SemiImplicitEuler)),
        ("adaptive", tolerances(12).map(|tolerance| Method::Adaptive { tolerance }).collect()),
        ("tolerance of the run", tolerances(10).map(|tolerance| Method::Automatic { tolerance }).collect()),
    ];
    let measured = all.into_iter().map(|(name, methods)| {
        let points = methods.into_iter().filter_map(|method| point(scene, answer, method)).collect();
        Series { name, is_ours: true, points }
    });
    measured.collect()
}

/// Nothing where the library refuses.
fn point(scene: &Scene, answer: &End, method: Method) -> Option<Point> {
    let simulation = match scene.with_slip {
        Some(with_slip) => with_slip(slip(method)).ok()?,
        None => scene.simulation.clone(),
    };
    let settings = settings(scene, method);
    let found = match end(&simulation, &settings) {
        Ok(found) => found,
        Err(error) => {
            eprintln!("  {}: {error}", setting(method));
            return None;
        }
    };
    let (mut least, mut spent, mut rounds) = (f64::INFINITY, 0.0, 0);
    while if spent < SPENT[0] { rounds < 1000 } else { rounds < 3 && spent < SPENT[1] } {
        let from = Instant::now();
        simulation.run(&settings).ok()?;
        let seconds = from.elapsed().as_secs_f64();
        (least, spent, rounds) = (least.min(seconds), spent + seconds, rounds + 1);
    }
    let count =
        if let Method::Fixed { step, .. } = method { (scene.duration / step).round() } else { f64::NAN };
    Some(Point { setting: setting(method), count, seconds: least, error: scene.error(&found, answer) })
}

/// The speed (m/s) below which friction creeps that goes with a method: as small as its steps allow, and what it changes (the square, over
/// the deceleration) as much as the tolerance.
fn slip(method: Method) -> f64 {
    match method {
        Method::Fixed { step, .. } => FRICTION * G * step,
        Method::Automatic { tolerance } | Method::Adaptive { tolerance } | Method::Stiff { tolerance } => {
            tolerance.sqrt()
        }
        _ => 1e-2,
    }
}

fn setting(method: Method) -> String {
    match method {
        Method::Fixed { step, .. } => format!("{step:.1e} s"),
        Method::Automatic { tolerance } | Method::Adaptive { tolerance } | Method::Stiff { tolerance } => {
            format!("{tolerance:.0e}")
        }
        _ => String::new(),
    }
}
