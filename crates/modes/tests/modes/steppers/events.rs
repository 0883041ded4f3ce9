//! Where a stretch ends by an event.

use crate::steppers::problems::{Motion, fixed, frames_of, run, run_between};
use solaris_modes::Rule;

const G: f64 = 9.81;

#[test]
fn a_bouncing_ball_meets_the_floor_when_it_should() {
    let mut ball = Motion::new(|_, _, _| -G).event(|_, q, _| q);
    let (mut y, mut time) = ([1.0, 0.0], 0.0);
    let first = (2.0_f64 / G).sqrt();
    let (mut hit, mut flight) = (first, 2.0 * first);
    // In the end the flights are shorter than the steps.
    for _ in 0..30 {
        let (stopped, _) =
            run_between(&mut ball, fixed(Rule::RungeKutta4, 1e-2), (time, 100.0), &mut y).expect("runs");
        assert_eq!(stopped.events, [0]);
        approx::assert_abs_diff_eq!(stopped.time, hit, epsilon = 1e-12);
        assert!((0.0..1e-15).contains(&y[0]), "{}", y[0]);
        time = stopped.time;
        y[1] *= -0.8;
        flight *= 0.8;
        hit += flight;
    }
    assert!(flight < 1e-2);
}

#[test]
fn every_rule_stops_at_its_own_zero() {
    for rule in Rule::ALL {
        let mut ball = Motion::new(|_, _, _| -G).event(|_, q, _| q);
        let mut y = [1.0, 0.0];
        let (stopped, counts) = run(&mut ball, fixed(rule, 1e-3), 10.0, &mut y).expect("runs");
        approx::assert_abs_diff_eq!(stopped.time, (2.0 / G).sqrt(), epsilon = 1.1e-3);
        approx::assert_abs_diff_eq!(y[0], 0.0, epsilon = 1e-15);
        assert_eq!(counts.events, 1);
    }
}

#[test]
fn an_event_at_the_end_of_the_stretch_is_found_and_not_found_again() {
    // v = t, so that q − ½ is zero at 1 s.
    let mut pushed = Motion::new(|_, _, _| 1.0).event(|_, q, _| q - 0.5);
    let mut y = [0.0, 0.0];
    let (stopped, _) = run(&mut pushed, fixed(Rule::RungeKutta4, 0.25), 1.0, &mut y).expect("runs");
    assert_eq!(stopped.events, [0]);
    approx::assert_abs_diff_eq!(stopped.time, 1.0, epsilon = 1e-15);
    let (stopped, _) =
        run_between(&mut pushed, fixed(Rule::RungeKutta4, 0.25), (1.0, 2.0), &mut y).expect("runs");
    assert_eq!(stopped.events, [0; 0]);
}

#[test]
fn a_frame_at_an_event_is_shown_and_one_after_it_is_not() {
    let mut pushed = Motion::new(|_, _, _| 1.0).event(|_, q, _| q - 0.5);
    let (stopped, shown) =
        frames_of(&mut pushed, fixed(Rule::RungeKutta4, 0.1), 3.0, &mut [0.0, 0.0], &[0.5, 1.0, 1.5]);
    assert_eq!(stopped.events, [0]);
    let times: Vec<u64> = shown.iter().map(|(time, _)| time.to_bits()).collect();
    assert_eq!(times, [0.5_f64, 1.0].map(f64::to_bits));
}

#[test]
fn the_earliest_of_several_events_in_one_step_wins() {
    let mut ball = Motion::new(|_, _, v: f64| 0.0 * v)
        .event(|_, q, _| 0.7 - q)
        .event(|_, q, _| q - 0.3)
        .event(|t, _, _| t - 0.5);
    let mut y = [0.0, 1.0];
    let mut times = Vec::new();
    let mut time = 0.0;
    while time < 1.0 {
        let (stopped, _) =
            run_between(&mut ball, fixed(Rule::RungeKutta4, 1.0), (time, 1.0), &mut y).expect("runs");
        time = stopped.time;
        times.push((stopped.events, time));
    }
    for ((events, time), (expected, at)) in
        times.iter().zip([(vec![1], 0.3), (vec![2], 0.5), (vec![0], 0.7), (vec![], 1.0)])
    {
        assert_eq!(*events, expected);
        approx::assert_abs_diff_eq!(*time, at, epsilon = 1e-15);
    }
}

#[test]
fn events_at_the_same_instant_are_named_together() {
    let mut ball = Motion::new(|_, _, _| 0.0).event(|_, q, _| q - 0.3).event(|t, _, _| 0.6 - 2.0 * t);
    let (stopped, counts) =
        run(&mut ball, fixed(Rule::RungeKutta4, 1.0), 1.0, &mut [0.0, 1.0]).expect("runs");
    assert_eq!(stopped.events, [0, 1]);
    assert_eq!(counts.events, 2);
}

#[test]
fn a_function_that_starts_at_zero_is_watched_from_where_it_has_left() {
    // Thrown up from the floor: down again after 2v/g, within the first step or after many.
    for step in [1.0, 1e-2] {
        let mut ball = Motion::new(|_, _, _| -G).event(|_, q, _| q);
        let (stopped, _) =
            run(&mut ball, fixed(Rule::RungeKutta4, step), 10.0, &mut [0.0, 2.0]).expect("runs");
        assert_eq!(stopped.events, [0]);
        approx::assert_abs_diff_eq!(stopped.time, 4.0 / G, epsilon = 1e-12);
    }
}

#[test]
fn a_function_that_stays_at_zero_is_no_event() {
    let mut resting = Motion::new(|_, _, _| 0.0).event(|_, q, _| q);
    let (stopped, _) = run(&mut resting, fixed(Rule::RungeKutta4, 0.1), 1.0, &mut [0.0, 0.0]).expect("runs");
    assert_eq!(stopped.events, [0; 0]);
}

#[test]
fn a_function_that_grazes_zero_within_a_step_is_no_event() {
    // It touches zero at 0.55 s, between the ends of steps.
    let mut grazing = Motion::new(|_, _, _| 0.0).event(|t, _, _| (t - 0.55) * (t - 0.55));
    let (stopped, _) = run(&mut grazing, fixed(Rule::RungeKutta4, 0.1), 1.0, &mut [0.0, 0.0]).expect("runs");
    assert_eq!(stopped.events, [0; 0]);
}

#[test]
fn locating_takes_few_evaluations() {
    let mut ball = Motion::new(|_, _, _| -G).event(|_, q, _| q);
    let (_, counts) = run(&mut ball, fixed(Rule::RungeKutta4, 0.1), 10.0, &mut [1.0, 0.0]).expect("runs");
    // Five steps of four, and three for each try at the length of the last.
    assert!(counts.evaluations <= 20 + 3 * 12, "{}", counts.evaluations);
}
