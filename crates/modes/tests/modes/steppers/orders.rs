//! With which power of the step the errors of the rules fall.

use crate::steppers::problems::{Motion, fixed, run};
use solaris_modes::Rule;

/// The error of the state at `to` with a step.
fn error(rule: Rule, steps: f64, to: f64, acceleration: fn(f64, f64, f64) -> f64, exact: [f64; 2]) -> f64 {
    let mut y = [1.0, 0.0];
    run(&mut Motion::new(acceleration), fixed(rule, to / steps), to, &mut y).expect("runs");
    (y[0] - exact[0]).hypot(y[1] - exact[1])
}

fn slopes(rule: Rule, to: f64, acceleration: fn(f64, f64, f64) -> f64, exact: [f64; 2]) -> Vec<f64> {
    let errors: Vec<f64> =
        [64.0, 128.0, 256.0, 512.0].map(|n| error(rule, n, to, acceleration, exact)).to_vec();
    errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect()
}

#[test]
fn errors_of_an_oscillator_fall_with_the_order_of_the_rule() {
    let to: f64 = 2.0;
    for rule in Rule::ALL {
        for slope in slopes(rule, to, |_, q, _| -q, [to.cos(), -to.sin()]) {
            approx::assert_abs_diff_eq!(slope, f64::from(rule.order()), epsilon = 0.1);
        }
    }
}

#[test]
fn errors_of_a_pendulum_with_a_driven_pivot_fall_with_the_order_of_the_rule() {
    let acceleration = |t: f64, q: f64, v: f64| -9.81 * q.sin() - 0.1 * v + (3.0 * t).cos();
    let mut exact = [1.0, 0.0];
    run(&mut Motion::new(acceleration), fixed(Rule::RungeKutta4, 1e-4), 2.0, &mut exact).expect("runs");
    for rule in Rule::ALL {
        let slopes = slopes(rule, 2.0, acceleration, exact);
        approx::assert_abs_diff_eq!(slopes[2], f64::from(rule.order()), epsilon = 0.1);
    }
}
