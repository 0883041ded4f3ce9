//! Bounces, beside what the law's own equation gives.

use crate::contact::{G, at, fixed, floor, point, simulation};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use solaris_model::{EventKind, Vector3};
use solaris_modes::{FailureKind, RunError, Settings};

/// The speed with which a mass that meets the ground at `u` leaves it, without gravity. From `m·v·v′ = −k·x·(1 + b·v)`,
///
/// ```text
/// b·(u + w) = ln((1 + b·u)/(1 − b·w))
/// ```
///
/// whatever the stiffness and the mass; `w` stays below `1/b`.
fn rebound(u: f64, b: f64) -> f64 {
    let left = |w: f64| b * (u + w) - ((1.0 + b * u) / (1.0 - b * w)).ln();
    let (mut low, mut high) = (0.0, (1.0 / b).min(u));
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if left(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

#[test]
fn a_mass_leaves_with_the_speed_that_the_law_gives_whatever_the_stiffness() {
    for (u, b) in [(0.1, 0.5), (1.0, 0.3), (2.0, 1.0), (5.0, 1.0), (3.0, 4.0)] {
        for stiffness in [1e3, 1e5] {
            let plane = floor(0.5, stiffness, b, 1e-2);
            let mut simulation = simulation(&point(), 0.0, plane, vec![at(Vector3::zeros(), 0.0)]);
            simulation.set_start(&[0.0, 0.1 * u], &[0.0, -u]).expect("valid");
            // There, half a period of the spring and more for a slow way out.
            let way_out = 20.0 * (2.0 / stiffness).sqrt();
            let run =
                simulation.run(&fixed(0.1 + way_out, 1000.0, 1e-3 * (1e3 / stiffness).sqrt())).expect("runs");
            let last = run.motion.len() - 1;
            assert!(run.motion.q(last)[1] > 0.0, "it is out again");
            assert_relative_eq!(run.motion.v(last)[1], rebound(u, b), max_relative = 2e-5);
            let energy = run.report.energy;
            let ground = run.report.ground.expect("a ground");
            // All that is lost the damper took, and the impulse is the change of momentum.
            let lost = u * u - rebound(u, b).powi(2);
            assert_relative_eq!(ground.damping, lost, max_relative = 1e-4);
            assert_relative_eq!(energy.heat, ground.damping, max_relative = 1e-12);
            assert!(ground.friction == 0.0);
            assert_relative_eq!(ground.impulse[1], 2.0 * (u + rebound(u, b)), max_relative = 1e-4);
            assert!(energy.imbalance < 1e-4 * energy.scale, "{energy:?}");
        }
    }
}

/// With gravity, beside an integration of the one equation by steps of a microsecond.
#[test]
fn a_ball_under_gravity_bounces_as_a_fine_integration_says() {
    let (k, b, m, h) = (2e4, 0.4, 2.0, 0.3);
    let rate = |y: [f64; 2]| {
        let d = -y[0];
        let push = if d > 0.0 { (k * d * (1.0 - b * y[1])).max(0.0) } else { 0.0 };
        [y[1], push / m - G]
    };
    let mut y = [h, 0.0];
    let mut heights = vec![h];
    let step = 1e-6;
    for i in 1..=1_000_000 {
        let at = |rate: [f64; 2], by: f64| [y[0] + by * rate[0], y[1] + by * rate[1]];
        let one = rate(y);
        let two = rate(at(one, 0.5 * step));
        let three = rate(at(two, 0.5 * step));
        let four = rate(at(three, step));
        y = std::array::from_fn(|j| y[j] + step / 6.0 * (one[j] + 2.0 * (two[j] + three[j]) + four[j]));
        if i % 10_000 == 0 {
            heights.push(y[0]);
        }
    }
    let radius = 0.05;
    let mut simulation = simulation(&point(), G, floor(0.5, k, b, 1e-2), vec![at(Vector3::zeros(), radius)]);
    simulation.set_start(&[0.0, h + radius], &[0.0, 0.0]).expect("valid");
    let run = simulation.run(&Settings::new(1.0, 100.0)).expect("runs");
    let error = run.report.error.expect("an estimate").position;
    assert!(error < 1e-6, "{error:e}");
    for (frame, expected) in heights.iter().enumerate() {
        assert_abs_diff_eq!(run.motion.q(frame)[1] - radius, expected, epsilon = 2e-6);
    }
    // The first fall ends at √(2h/g), to the square of a frame.
    let first = &run.motion.events[0];
    assert!(matches!(&first.kind, EventKind::TouchDown { link } if link == "point"), "{first:?}");
    assert_abs_diff_eq!(first.time, (2.0 * h / G).sqrt(), epsilon = 3e-4);
    assert!(matches!(run.motion.events[1].kind, EventKind::LiftOff { .. }));
}

/// Without damping nothing is lost, bounce for bounce.
#[test]
fn without_damping_it_comes_back_to_where_it_fell_from() {
    let mut simulation = simulation(&point(), G, floor(0.0, 1e4, 0.0, 1e-2), vec![at(Vector3::zeros(), 0.0)]);
    simulation.set_start(&[0.0, 0.5], &[0.0, 0.0]).expect("valid");
    let run = simulation.run(&Settings::new(3.0, 500.0)).expect("runs");
    let report = &run.report;
    assert!(report.energy.heat.abs() < 1e-9 && report.energy.imbalance < 1e-5 * report.energy.scale);
    let late = (1000..run.motion.len()).map(|frame| run.motion.q(frame)[1]).fold(f64::MIN, f64::max);
    assert_abs_diff_eq!(late, 0.5, epsilon = 1e-4);
}

/// A touch begins within a step, so that the differences of ever shorter steps fall by chance: none of them was sixteen times as large as
/// what is left, though one may be sixteen times as large as the next.
#[test]
fn what_is_said_of_a_fall_on_springs_is_no_less_than_what_is_true() {
    for stiffness in [1e3, 1e4, 1e5] {
        let plane = floor(0.0, stiffness, 10.0, 1e-2);
        let mut simulation = simulation(&point(), G, plane, vec![at(Vector3::zeros(), 0.0)]);
        simulation.set_start(&[0.0, 0.01], &[0.0, 0.0]).expect("valid");
        let run = simulation.run(&Settings::new(0.5, 100.0)).expect("runs");
        let fine = simulation.run(&fixed(0.5, 100.0, 1e-5)).expect("runs");
        let off = (0..run.motion.len()).map(|frame| (run.motion.q(frame)[1] - fine.motion.q(frame)[1]).abs());
        let (off, said) = (off.fold(0.0, f64::max), run.report.error.expect("an estimate").position);
        assert!(off <= said && said <= 1e-6, "{stiffness}: said {said:e}, is {off:e}");
    }
}

/// It said "take a shorter step", and nobody knew which.
#[test]
fn energy_from_a_touch_that_steps_pass_over_is_answered_with_a_step() {
    let plane = floor(0.0, 1e7, 10.0, 1e-2);
    let mut simulation = simulation(&point(), G, plane, vec![at(Vector3::zeros(), 0.0)]);
    simulation.set_start(&[0.0, 0.01], &[0.0, 0.0]).expect("valid");
    let error = simulation.run(&fixed(0.5, 100.0, 1e-3)).expect_err("its energy does not balance");
    let RunError::Failed(failure) = &error else { panic!("{error}") };
    assert!(matches!(&failure.cause, FailureKind::Energy { .. }), "{error}");
    let said = "a shorter step, such as a tenth, 1.0e-4 s, or give a tolerance instead of a step";
    assert!(error.to_string().ends_with(said), "{error}");
    // As it says.
    assert!(simulation.run(&fixed(0.5, 100.0, 1e-4)).is_ok());
}
