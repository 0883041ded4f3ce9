//! A pendulum through large angles against its closed form, and what a rule keeps for ever.

use crate::steppers::problems::{Motion, PENDULUM, fixed, frames_of, run};
use solaris_modes::Rule;

#[test]
fn a_pendulum_released_from_the_horizontal_is_where_elliptic_functions_put_it() {
    let mut y = PENDULUM.start;
    run(&mut Motion::new(PENDULUM.acceleration), fixed(Rule::RungeKutta4, 1e-4), 10.0, &mut y).expect("runs");
    approx::assert_abs_diff_eq!(y[0].sin(), PENDULUM.end[0], epsilon = 1e-12);
    approx::assert_abs_diff_eq!(-y[0].cos(), PENDULUM.end[1], epsilon = 1e-12);
}

#[test]
fn a_pendulum_turns_back_after_every_period() {
    // The angular velocity passes through zero after each half of a period.
    let mut pendulum = Motion::new(PENDULUM.acceleration).event(|_, _, v| v);
    let mut y = PENDULUM.start;
    let mut time = 0.0;
    for half in 1..=8 {
        let (stopped, _) = crate::steppers::problems::run_between(
            &mut pendulum,
            fixed(Rule::RungeKutta4, 1e-3),
            (time, 100.0),
            &mut y,
        )
        .expect("runs");
        time = stopped.time;
        approx::assert_abs_diff_eq!(time, 0.5 * f64::from(half) * PENDULUM.period, epsilon = 1e-10);
    }
}

#[test]
fn the_semi_implicit_rule_keeps_the_energy_of_an_oscillator_for_a_hundred_thousand_periods() {
    let mut oscillator = Motion::new(|_, q, _| -q);
    let (mut y, periods, step) = ([1.0, 0.0], 1e5, std::f64::consts::TAU / 20.0);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    let mut time = 0.0;
    while time < periods * std::f64::consts::TAU {
        let to = time + 1000.0 * step;
        crate::steppers::problems::run_between(
            &mut oscillator,
            fixed(Rule::SemiImplicitEuler, step),
            (time, to),
            &mut y,
        )
        .expect("runs");
        let energy = 0.5 * (y[0] * y[0] + y[1] * y[1]);
        (least, most, time) = (least.min(energy), most.max(energy), to);
    }
    // The rule keeps ½(q² + v² − h·q·v), which holds the energy within ½/(1 ± h/2).
    assert!(
        least > 0.5 / (1.0 + 0.5 * step) - 1e-6 && most < 0.5 / (1.0 - 0.5 * step) + 1e-6,
        "{least} {most}"
    );
    // Explicit Euler multiplies it by 1 + h² in every step.
    let mut y = [1.0, 0.0];
    run(&mut oscillator, fixed(Rule::ExplicitEuler, step), 100.0 * step, &mut y).expect("runs");
    let energy = 0.5 * (y[0] * y[0] + y[1] * y[1]);
    approx::assert_relative_eq!(energy, 0.5 * (1.0 + step * step).powi(100), max_relative = 1e-10);
}

#[test]
fn constant_accelerations_are_exact() {
    let mut y = [1.0, 3.0];
    let mut falling = Motion::new(|_, _, _| -9.81);
    run(&mut falling, fixed(Rule::ConstantAcceleration, 0.1), 0.7, &mut y).expect("runs");
    approx::assert_abs_diff_eq!(y[0], 1.0 + 3.0 * 0.7 - 0.5 * 9.81 * 0.49, epsilon = 1e-14);
    approx::assert_abs_diff_eq!(y[1], 3.0 - 9.81 * 0.7, epsilon = 1e-14);
}

#[test]
fn frames_are_shown_on_the_way_and_do_not_lengthen_the_steps() {
    let times = [0.0, 0.3, 0.35, 1.0, 2.0];
    let mut y = [1.0, 0.0];
    let mut oscillator = Motion::new(|_, q, _| -q);
    let (stopped, shown) = frames_of(&mut oscillator, fixed(Rule::RungeKutta4, 0.1), 1.0, &mut y, &times);
    approx::assert_abs_diff_eq!(stopped.time, 1.0);
    assert_eq!(
        shown.iter().map(|(time, _)| time.to_bits()).collect::<Vec<_>>(),
        [0.3_f64, 0.35, 1.0].map(f64::to_bits)
    );
    for (time, y) in &shown {
        approx::assert_abs_diff_eq!(y[0], time.cos(), epsilon = 1e-6);
    }
    // Three steps, one, seven.
    let (_, counts) =
        run(&mut oscillator, fixed(Rule::RungeKutta4, 0.1), 0.3, &mut [1.0, 0.0]).expect("runs");
    assert_eq!((counts.steps, counts.evaluations), (3, 12));
}

#[test]
fn what_jumps_at_the_end_of_a_stretch_has_not_jumped_yet() {
    let mut kicked = Motion::new(|t, _, _| if t < 1.0 { 1.0 } else { 1e6 });
    let mut y = [0.0, 0.0];
    run(&mut kicked, fixed(Rule::RungeKutta4, 0.25), 1.0, &mut y).expect("runs");
    approx::assert_abs_diff_eq!(y[0], 0.5, epsilon = 1e-12);
    approx::assert_abs_diff_eq!(y[1], 1.0, epsilon = 1e-12);
}

#[test]
fn the_same_stretch_gives_the_same_bits() {
    let end = || {
        let mut y = PENDULUM.start;
        run(&mut Motion::new(PENDULUM.acceleration), fixed(Rule::RungeKutta4, 1e-2), 3.0, &mut y)
            .expect("runs");
        y.map(f64::to_bits)
    };
    assert_eq!(end(), end());
}
