//! Where a stretch ends by an event.

use crate::problems::{Motion, fixed, run_between};
use solaris_modes::Rule;

const G: f64 = 9.81;

#[test]
fn a_bouncing_ball_meets_the_floor_when_it_should() {
    let mut ball = Motion::new(|_, _, _| -G).event(|_, q, _| q);
    let (mut y, mut time) = ([1.0, 0.0], 0.0);
    let first = (2.0_f64 / G).sqrt();
    let (mut hit, mut flight) = (first, 2.0 * first);
    for bounce in 0..20 {
        let (stopped, _) =
            run_between(&mut ball, fixed(Rule::RungeKutta4, 1e-2), (time, 100.0), &mut y).expect("runs");
        println!("{bounce} {} {:e} {:e}", stopped.time, stopped.time - hit, y[0]);
        assert_eq!(stopped.events, [0]);
        approx::assert_abs_diff_eq!(stopped.time, hit, epsilon = 1e-12);
        time = stopped.time;
        y[1] *= -0.8;
        flight *= 0.8;
        hit += flight;
    }
}
