//! The methods that choose their steps: accuracy, frames, events, and refusals.

use crate::steppers::problems::{Equations, Jacobian, Motion, PENDULUM, Rate, frames_of, run, run_between};
use nalgebra::DMatrix;
use solaris_modes::Counts;
use solaris_modes::time::{RateError, Stepping, TimeError, advance};

const G: f64 = 9.81;

/// The implicit one where it is built in.
fn both(tolerance: f64) -> Vec<Stepping> {
    let stiff = cfg!(feature = "stiff").then_some(Stepping::Stiff { tolerance });
    [Stepping::Adaptive { tolerance }].into_iter().chain(stiff).collect()
}

fn system(rate: Rate) -> Equations<Rate, Jacobian> {
    Equations { len: 1, rate, jacobian: |_, y, jacobian| jacobian.fill(2.0 * y[0]) }
}

#[test]
fn a_pendulum_is_right_to_the_digits_that_the_tolerance_promises() {
    for tolerance in [1e-6, 1e-8, 1e-10] {
        // Errors of single steps add up: over four periods, to some hundreds and, of the method for stiff scenes,
        // thousands.
        for (stepping, factor) in both(tolerance).into_iter().zip([300.0, 3000.0]) {
            let mut y = PENDULUM.start;
            run(&mut Motion::new(PENDULUM.acceleration), stepping, 10.0, &mut y).expect("runs");
            let error = (y[0].sin() - PENDULUM.end[0]).hypot(-y[0].cos() - PENDULUM.end[1]);
            assert!(error < factor * tolerance, "{stepping:?}: {error:e}");
        }
    }
}

#[test]
fn frames_are_interpolated_and_the_end_is_exact() {
    let times: Vec<f64> = (0..=300).map(|i| f64::from(i) / 30.0).collect();
    for stepping in both(1e-9) {
        let mut y = [1.0, 0.0];
        let (stopped, shown) = frames_of(&mut Motion::new(|_, q, _| -q), stepping, 10.0, &mut y, &times);
        assert_eq!(stopped.time.to_bits(), 10.0_f64.to_bits());
        assert_eq!(shown.len(), 300);
        for ((time, state), asked) in shown.iter().zip(&times[1..]) {
            assert_eq!(time.to_bits(), asked.to_bits());
            approx::assert_abs_diff_eq!(state[0], time.cos(), epsilon = 1e-6);
            approx::assert_abs_diff_eq!(state[1], -time.sin(), epsilon = 1e-6);
        }
        assert_eq!(shown[299].1, y);
    }
}

#[test]
fn a_bouncing_ball_meets_the_floor_when_it_should() {
    for stepping in both(1e-10) {
        let mut ball = Motion::new(|_, _, _| -G).event(|_, q, _| q);
        let (mut y, mut time) = ([1.0, 0.0], 0.0);
        let first = (2.0_f64 / G).sqrt();
        let (mut hit, mut flight) = (first, 2.0 * first);
        for _ in 0..15 {
            let (stopped, counts) = run_between(&mut ball, stepping, (time, 100.0), &mut y).expect("runs");
            assert_eq!((stopped.events, counts.events), (vec![0], 1));
            approx::assert_abs_diff_eq!(stopped.time, hit, epsilon = 1e-8);
            approx::assert_abs_diff_eq!(y[0], 0.0, epsilon = 1e-14);
            time = stopped.time;
            y[1] *= -0.8;
            flight *= 0.8;
            hit += flight;
        }
    }
}

#[test]
fn the_earliest_event_wins_and_frames_after_it_are_not_shown() {
    for stepping in both(1e-8) {
        let mut thrown = Motion::new(|_, _, _| 0.0).event(|_, q, _| q - 0.7).event(|t, _, _| 0.3 - t);
        let (stopped, shown) = frames_of(&mut thrown, stepping, 1.0, &mut [0.0, 1.0], &[0.1, 0.2, 0.4]);
        assert_eq!(stopped.events, [1]);
        approx::assert_abs_diff_eq!(stopped.time, 0.3, epsilon = 1e-14);
        assert_eq!(shown.len(), 2);
    }
}

#[test]
fn a_function_that_starts_at_zero_is_watched_from_where_it_has_left() {
    for stepping in both(1e-8) {
        let mut ball = Motion::new(|_, _, _| -G).event(|_, q, _| q);
        let (stopped, _) = run(&mut ball, stepping, 10.0, &mut [0.0, 2.0]).expect("runs");
        assert_eq!(stopped.events, [0]);
        approx::assert_abs_diff_eq!(stopped.time, 4.0 / G, epsilon = 1e-7);
    }
}

#[test]
fn an_event_at_the_end_of_the_stretch_is_found_once() {
    for stepping in both(1e-8) {
        let mut clock = Motion::new(|_, _, _| 0.0).event(|t, _, _| t - 1.0);
        let mut y = [0.0, 1.0];
        let (stopped, _) = run(&mut clock, stepping, 1.0, &mut y).expect("runs");
        assert_eq!(stopped.events, [0]);
        approx::assert_abs_diff_eq!(stopped.time, 1.0, epsilon = 1e-15);
        let (stopped, _) = run_between(&mut clock, stepping, (1.0, 2.0), &mut y).expect("runs");
        assert!(stopped.events.is_empty());
    }
}

#[test]
fn a_rate_that_is_no_number_ends_the_stretch() {
    for stepping in both(1e-6) {
        let mut broken = system(|t, _, rate| {
            rate[0] = if t < 0.5 { 1.0 } else { f64::NAN };
            Ok(())
        });
        let mut y = [0.0];
        let error = run(&mut broken, stepping, 1.0, &mut y).expect_err("no rate");
        assert!(
            matches!(error, TimeError::Rate { time, source: RateError::NotFinite { index: 0, .. } } if time >= 0.5),
            "{error}"
        );
        assert!((0.0..=0.5).contains(&y[0]), "{}", y[0]);
        let mut broken = system(|_, _, rate| {
            rate[0] = f64::INFINITY;
            Ok(())
        });
        let error = run(&mut broken, stepping, 1.0, &mut [0.0]).expect_err("no rate");
        assert!(matches!(error, TimeError::Rate { time, .. } if time.to_bits() == 0), "{error}");
    }
}

#[test]
fn a_trial_that_goes_too_far_is_no_failure() {
    // The rate ends beyond 1, which the solution, 1 − exp(−t), never reaches, but long steps do.
    for stepping in both(1e-3) {
        let mut edge = Equations {
            len: 1,
            rate: |_: f64, y: &[f64], rate: &mut [f64]| {
                rate[0] = if y[0] <= 1.0 { 1.0 - y[0] } else { f64::NAN };
                Ok(())
            },
            jacobian: |_: f64, _: &[f64], jacobian: &mut DMatrix<f64>| jacobian.fill(-1.0),
        };
        let mut y = [0.0];
        run(&mut edge, stepping, 3.0, &mut y).expect("runs");
        approx::assert_abs_diff_eq!(y[0], 1.0 - (-3.0_f64).exp(), epsilon = 1e-2);
    }
}

#[cfg(feature = "stiff")]
#[test]
fn a_jacobian_that_is_no_number_ends_the_stretch() {
    let mut broken = Equations {
        len: 1,
        rate: |_: f64, y: &[f64], rate: &mut [f64]| {
            rate[0] = -1e6 * y[0];
            Ok(())
        },
        jacobian: |_: f64, _: &[f64], jacobian: &mut DMatrix<f64>| jacobian.fill(f64::NAN),
    };
    let result = run(&mut broken, Stepping::Stiff { tolerance: 1e-6 }, 1.0, &mut [1.0]);
    assert!(matches!(result, Err(TimeError::Rate { .. })), "{result:?}");
}

#[test]
fn a_solution_that_runs_away_gets_stuck_before_it_does() {
    // y = 1/(1 − t).
    for stepping in both(1e-6) {
        let mut pole = system(|_, y, rate| {
            rate[0] = y[0] * y[0];
            Ok(())
        });
        let mut y = [1.0];
        let error = run(&mut pole, stepping, 2.0, &mut y).expect_err("there is no solution");
        assert!(matches!(error, TimeError::Stuck { .. } | TimeError::Rate { .. }), "{error}");
        assert!(y[0].is_finite() && y[0] > 1e3, "{}", y[0]);
    }
}

#[test]
fn no_more_is_evaluated_than_was_allowed() {
    for stepping in both(1e-8) {
        let (mut y, mut counts) = ([1.0, 0.0], Counts::default());
        let mut oscillator = Motion::new(|_, q, _| -q);
        let mut nobody = |_: &mut _, _, _: &[f64]| Ok(());
        let error =
            advance(&mut oscillator, stepping, (0.0, 1e3), &mut y, &[], &mut nobody, 200, &mut counts)
                .expect_err("spent");
        assert!(matches!(error, TimeError::Evaluations { evaluations: 200, .. }), "{error}");
        assert_eq!(counts.evaluations, 200);
        approx::assert_abs_diff_eq!(y[0] * y[0] + y[1] * y[1], 1.0, epsilon = 1e-4);
    }
}

#[test]
fn stretches_may_be_as_short_as_numbers_allow() {
    for stepping in both(1e-8) {
        for length in [1e-15, 1e-13, 1e-12, 1e-10, 1e-6] {
            let (mut y, from) = ([0.0, 1.0], 10.0);
            let to = f64::max(from + length, f64::next_up(from));
            let (stopped, _) = run_between(&mut Motion::new(|_, _, _| -G), stepping, (from, to), &mut y)
                .unwrap_or_else(|error| panic!("{length}: {error}"));
            assert_eq!(stopped.time.to_bits(), to.to_bits());
            approx::assert_relative_eq!(y[0], to - from, max_relative = 1e-5);
        }
    }
}

#[test]
fn what_jumps_at_the_end_of_a_stretch_has_not_jumped_yet() {
    for stepping in both(1e-10) {
        let mut kicked = Motion::new(|t, _, _| if t < 1.0 { 1.0 } else { 1e6 });
        let mut y = [0.0, 0.0];
        run(&mut kicked, stepping, 1.0, &mut y).expect("runs");
        approx::assert_abs_diff_eq!(y[0], 0.5, epsilon = 1e-8);
        approx::assert_abs_diff_eq!(y[1], 1.0, epsilon = 1e-8);
    }
}

#[test]
fn the_same_stretch_gives_the_same_bits() {
    for stepping in both(1e-7) {
        let end = || {
            let mut y = PENDULUM.start;
            let (_, counts) =
                run(&mut Motion::new(PENDULUM.acceleration), stepping, 3.0, &mut y).expect("runs");
            (y.map(f64::to_bits), counts)
        };
        assert_eq!(end(), end());
    }
}
