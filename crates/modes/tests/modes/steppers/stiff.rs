//! Stiff problems with published answers, by the method for them and by the one that is not.

use crate::steppers::problems::{Equations, run};
use crate::steppers_stiff::stiff_problems::{Governor, robertson, van_der_pol};
use nalgebra::DMatrix;
use solaris_modes::time::{Stepping, System};

fn stiff(tolerance: f64) -> Stepping {
    Stepping::Stiff { tolerance }
}

fn end(system: &mut impl System, stepping: Stepping, to: f64, start: &[f64]) -> (Vec<f64>, u64) {
    let mut y = start.to_vec();
    let (stopped, counts) = run(system, stepping, to, &mut y).expect("runs");
    approx::assert_abs_diff_eq!(stopped.time, to);
    (y, counts.evaluations)
}

/// x(2000) = 1.70616773 for μ = 1000 and the start (2, 0).
#[test]
fn van_der_pols_relaxation_oscillator_is_where_it_is_known_to_be() {
    for (tolerance, error, most) in [(1e-6, 5e-5, 3000), (1e-8, 5e-6, 6000), (1e-11, 1.5e-8, 16000)] {
        let (y, evaluations) = end(&mut van_der_pol(1e3), stiff(tolerance), 2e3, &[2.0, 0.0]);
        approx::assert_abs_diff_eq!(y[0], 1.706_167_73, epsilon = error);
        assert!(evaluations < most, "{evaluations} evaluations");
    }
}

/// At 1e11 s: F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers (2008), problem ROBER. At 40 s: two
/// methods of orders three and five at tolerances of 1e-12 agree on the digits given.
#[test]
fn robertsons_reaction_is_where_it_is_known_to_be() {
    let (y, _) = end(&mut robertson(), stiff(1e-11), 40.0, &[1.0, 0.0, 0.0]);
    approx::assert_abs_diff_eq!(y[0], 0.715_827_068_7, epsilon = 1e-9);
    let (y, evaluations) = end(&mut robertson(), stiff(1e-13), 1e11, &[1.0, 0.0, 0.0]);
    for (y, exact) in
        y.iter().zip([0.208_334_014_970_125_5e-7, 0.833_336_077_033_471_3e-13, 0.999_999_979_166_505])
    {
        approx::assert_abs_diff_eq!(*y, exact, epsilon = 1e-11);
    }
    assert!(evaluations < 5000, "{evaluations} evaluations");
}

/// Height of the base at 0.5, 1, 2, 5 and 10 s, and the speed of the shaft at the end.
const GOVERNOR: [(f64, f64); 5] = [
    (0.5, 0.743_249_425),
    (1.0, 0.501_420_922),
    (2.0, 0.505_909_294),
    (5.0, 0.535_563_104),
    (10.0, 0.619_622_917),
];

#[test]
fn a_flyball_governor_is_where_other_programs_put_it() {
    for (time, height) in GOVERNOR {
        let (y, _) = end(&mut Governor, stiff(1e-10), time, &Governor::START);
        approx::assert_abs_diff_eq!(y[0], height, epsilon = 2e-9);
    }
    let (y, evaluations) = end(&mut Governor, stiff(1e-8), 10.0, &Governor::START);
    approx::assert_abs_diff_eq!(y[0], 0.619_622_917, epsilon = 1e-6);
    approx::assert_abs_diff_eq!(y[5], 5.548_203_623, epsilon = 1e-5);
    assert!(evaluations < 6000, "{evaluations} evaluations");
}

/// The eigenvalue −8117 1/s allows the explicit method steps of about 4e-4 s, whatever the tolerance.
#[test]
fn an_explicit_method_pays_for_stiffness_and_not_for_accuracy() {
    for tolerance in [1e-3, 1e-6] {
        let (y, evaluations) = end(&mut Governor, Stepping::Adaptive { tolerance }, 10.0, &Governor::START);
        approx::assert_abs_diff_eq!(y[0], 0.619_622_917, epsilon = 1e-3);
        assert!((60_000..120_000).contains(&evaluations), "{evaluations} evaluations");
    }
}

#[test]
fn decay_to_a_slow_curve_is_cheap_only_where_it_should_be() {
    let mut relaxation = Equations {
        len: 1,
        rate: |t: f64, y: &[f64], rate: &mut [f64]| {
            rate[0] = -1e4 * (y[0] - t.cos());
            Ok(())
        },
        jacobian: |_: f64, _: &[f64], jacobian: &mut DMatrix<f64>| jacobian.fill(-1e4),
    };
    // y = (λ² cos t + λ sin t)/(λ² + 1), after the transient.
    let (rate, to) = (1e4_f64, 5.0_f64);
    let exact = (rate * rate * to.cos() + rate * to.sin()) / (rate * rate + 1.0);
    let (y, cheap) = end(&mut relaxation, stiff(1e-8), to, &[0.0]);
    approx::assert_abs_diff_eq!(y[0], exact, epsilon = 1e-7);
    let (y, dear) = end(&mut relaxation, Stepping::Adaptive { tolerance: 1e-8 }, to, &[0.0]);
    approx::assert_abs_diff_eq!(y[0], exact, epsilon = 1e-7);
    assert!(cheap < 1000 && dear > 60_000, "{cheap} and {dear} evaluations");
}
