//! The explicit method that chooses its steps: closed forms, its order, where it ends steps, and events between.

use crate::steppers::problems::{Equations, Jacobian, Motion, Rate, frames_of, run, run_between};
use solaris_modes::Counts;
use solaris_modes::time::{RateError, Stepping, System, TimeError};
use std::cell::Cell;

fn adaptive(tolerance: f64) -> Stepping {
    Stepping::Adaptive { tolerance }
}

/// The error of the state at `to`, and what it took.
fn oscillator(tolerance: f64, to: f64) -> (f64, Counts) {
    let mut y = [1.0, 0.0];
    let (_, counts) = run(&mut Motion::new(|_, q, _| -q), adaptive(tolerance), to, &mut y).expect("runs");
    ((y[0] - to.cos()).hypot(y[1] + to.sin()), counts)
}

/// Errors fall with the tolerance, and evaluations grow with its eighth root.
#[test]
fn a_thousandth_of_the_error_costs_little_more_than_twice_as_much() {
    let found = [1e-3, 1e-6, 1e-9, 1e-12].map(|tolerance| oscillator(tolerance, 50.0));
    for pair in found.windows(2) {
        let [(coarse, cheap), (fine, dear)] = [pair[0], pair[1]];
        let power = (coarse / fine).log10() / 3.0;
        assert!((0.85..1.25).contains(&power), "{coarse:e} {fine:e}");
        let ratio = dear.evaluations as f64 / cheap.evaluations as f64;
        assert!((1.8..2.8).contains(&ratio), "{ratio}");
    }
    assert!(found[3].0 < 1e-10, "{:e}", found[3].0);
}

/// The two bodies of Arenstorf's problem: a closed orbit that passes near to both, with steps from 1e-5 to 1.
#[test]
fn an_orbit_that_passes_near_to_both_bodies_closes() {
    const MU: f64 = 0.012_277_471;
    let mut orbit = Equations::<Rate, Jacobian> {
        len: 4,
        rate: |_, y, rate| {
            let (near, far) = (1.0 - MU, MU);
            let d1 = ((y[0] + far).powi(2) + y[1].powi(2)).powf(1.5);
            let d2 = ((y[0] - near).powi(2) + y[1].powi(2)).powf(1.5);
            rate[0] = y[2];
            rate[1] = y[3];
            rate[2] = y[0] + 2.0 * y[3] - near * (y[0] + far) / d1 - far * (y[0] - near) / d2;
            rate[3] = y[1] - 2.0 * y[2] - near * y[1] / d1 - far * y[1] / d2;
            Ok(())
        },
        jacobian: |_, _, jacobian| jacobian.fill(0.0),
    };
    // Hairer, Nørsett, Wanner (1993), §II.0, with its period.
    let start = [0.994, 0.0, 0.0, -2.001_585_106_379_082_5];
    let mut y = start;
    let (_, counts) = run(&mut orbit, adaptive(1e-12), 17.065_216_560_157_964, &mut y).expect("runs");
    let off = (y[0] - start[0]).hypot(y[1] - start[1]);
    assert!(off < 1e-6, "{off:e}");
    assert!(counts.evaluations < 6000 && counts.rejected > 0, "{counts:?}");
}

#[test]
fn what_stands_still_stays_there_in_few_steps() {
    let mut y = [0.0, 0.0];
    let (_, counts) =
        run(&mut Motion::new(|_, q, _| -9.81 * q.sin()), adaptive(1e-6), 1e3, &mut y).expect("runs");
    assert_eq!(y.map(f64::to_bits), [0, 0]);
    assert!(counts.steps < 20, "{counts:?}");
}

/// Polynomials up to the seventh degree are exact, and so is what is shown between.
#[test]
fn frames_within_a_step_are_of_order_seven() {
    let mut power = Motion::new(|t, _, _| 42.0 * t.powi(5));
    let frames: Vec<f64> = (1..=100).map(|i| f64::from(i) / 50.0).collect();
    let mut y = [0.0, 0.0];
    let (_, shown) = frames_of(&mut power, adaptive(1e-3), 2.0, &mut y, &frames);
    assert_eq!(shown.len(), 100);
    for (time, state) in shown {
        approx::assert_abs_diff_eq!(state[0], time.powi(7), epsilon = 1e-11);
        approx::assert_abs_diff_eq!(state[1], 7.0 * time.powi(6), epsilon = 1e-11);
    }
}

/// What comes to zero and goes back within a step is seen where there are frames between.
#[test]
fn what_crosses_a_line_and_comes_back_between_two_steps_is_seen() {
    // Up to 1.25 at 0.5 s, and back at 0 at 1 s: a single step would do.
    let mut thrown = Motion::new(|_, _, _| -10.0).event(|_, q, _| q - 1.0);
    let frames: Vec<f64> = (1..=20).map(|i| f64::from(i) / 20.0).collect();
    let mut y = [0.0, 5.0];
    let (stopped, shown) = frames_of(&mut thrown, adaptive(1e-6), 1.0, &mut y, &frames);
    assert_eq!(stopped.events, [0]);
    let time = (5.0 - 5.0_f64.sqrt()) / 10.0;
    approx::assert_abs_diff_eq!(stopped.time, time, epsilon = 1e-14);
    approx::assert_abs_diff_eq!(y[0], 1.0, epsilon = 1e-14);
    assert_eq!(shown.len(), 5);
}

#[test]
fn an_event_in_the_first_step_and_one_at_the_end_of_a_step_are_found() {
    let mut thrown = Motion::new(|_, _, _| 0.0).event(|t, _, _| t - 1e-9).event(|t, _, _| t - 2.0);
    let mut y = [0.0, 1.0];
    let (stopped, _) = run(&mut thrown, adaptive(1e-6), 2.0, &mut y).expect("runs");
    assert_eq!(stopped.events, [0]);
    approx::assert_abs_diff_eq!(stopped.time, 1e-9, epsilon = 1e-16);
    let (stopped, _) = run_between(&mut thrown, adaptive(1e-6), (stopped.time, 2.0), &mut y).expect("runs");
    assert_eq!((stopped.time.to_bits(), stopped.events), (2.0_f64.to_bits(), vec![1]));
}

#[test]
fn several_events_at_once_are_all_named() {
    let mut thrown =
        Motion::new(|_, _, _| 0.0).event(|_, q, _| q - 0.5).event(|t, _, _| 0.5 - t).event(|t, _, _| t - 0.7);
    let (stopped, counts) = run(&mut thrown, adaptive(1e-6), 1.0, &mut [0.0, 1.0]).expect("runs");
    assert_eq!((stopped.events, counts.events), (vec![0, 1], 2));
}

/// A rate of pieces, whose slope jumps every tenth of a second, with where they meet or without.
struct Pieces {
    are_told: bool,
    errors: f64,
}

impl System for Pieces {
    fn len(&self) -> usize {
        1
    }

    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        let tenths = (10.0 * t).floor();
        rate[0] = (10.0 * t - tenths) * (tenths + 1.0 - 10.0 * t) - y[0];
        Ok(())
    }

    fn jacobian(
        &mut self,
        _: f64,
        _: &[f64],
        jacobian: &mut nalgebra::DMatrix<f64>,
    ) -> Result<(), RateError> {
        jacobian.fill(-1.0);
        Ok(())
    }

    fn smooth_until(&self, t: f64) -> f64 {
        if self.are_told { ((10.0 * t + 1e-9).floor() + 1.0) / 10.0 } else { f64::INFINITY }
    }

    fn note_error(&mut self, error: f64) {
        self.errors += error;
    }
}

#[test]
fn steps_end_where_the_pieces_of_a_rate_meet() {
    let end = |are_told| {
        let (mut y, mut pieces) = ([0.0], Pieces { are_told, errors: 0.0 });
        let (_, counts) = run(&mut pieces, adaptive(1e-9), 3.0, &mut y).expect("runs");
        (y[0], counts, pieces.errors)
    };
    let ((told, cheap, errors), (untold, dear, _)) = (end(true), end(false));
    assert_eq!((cheap.steps, cheap.rejected), (30, 0));
    assert!(dear.evaluations > 5 * cheap.evaluations, "{cheap:?} {dear:?}");
    // In each tenth y = −210 + 21·s − s² + C·exp(−t), where s is the part of it that is over.
    let exact = (0..30).fold(0.0, |y, _| -190.0 + (y + 210.0) * (-0.1_f64).exp());
    approx::assert_abs_diff_eq!(told, exact, epsilon = 1e-12);
    approx::assert_abs_diff_eq!(untold, exact, epsilon = 1e-6);
    // Each step says of its error what it is, far below what is allowed.
    assert!(errors > 0.0 && errors < 1e-9, "{errors:e}");
}

/// Nothing is evaluated at the end of the last step for the sake of a step that there is not.
#[test]
fn a_stretch_of_one_step_takes_thirteen_evaluations() {
    let mut y = [0.0, 1.0];
    let (_, counts) = run(&mut Motion::new(|_, _, _| -10.0), adaptive(1e-6), 1.0, &mut y).expect("runs");
    // The rate at the beginning, one for the first step's length, and eleven stages; the first step may be shorter.
    assert_eq!((counts.evaluations - 13) % 12, 0, "{counts:?}");
    approx::assert_abs_diff_eq!(y[0], -4.0, epsilon = 1e-14);
}

/// A rate that jumps with the state: what goes to and fro across the line cannot be stepped through, and is not for ever.
#[test]
fn what_chatters_is_ended() {
    let calls = Cell::new(0_u64);
    let mut relay = Equations {
        len: 1,
        rate: |_: f64, y: &[f64], rate: &mut [f64]| {
            calls.set(calls.get() + 1);
            rate[0] = if y[0] > 0.0 { -1.0 } else { 2.0 };
            Ok(())
        },
        jacobian: |_: f64, _: &[f64], jacobian: &mut nalgebra::DMatrix<f64>| jacobian.fill(0.0),
    };
    let mut y = [1.0];
    let mut counts = Counts::default();
    let ended = solaris_modes::time::advance(
        &mut relay,
        adaptive(1e-9),
        (0.0, 2.0),
        &mut y,
        &[],
        &mut |_, _, _| Ok(()),
        100_000,
        &mut counts,
    );
    match ended {
        Ok(_) => assert!(y[0].abs() < 1e-6, "{}", y[0]),
        Err(error) => assert!(
            matches!(error, TimeError::Stuck { .. } | TimeError::Evaluations { .. }) && y[0].abs() < 1e-6,
            "{error}, {}",
            y[0]
        ),
    }
    assert!(calls.get() <= 100_000);
}
