//! Which velocities keep a motion from turning round.

use proptest::prelude::*;
use solaris_profiles::displacement::{ExponentialVelocities, Tension, TrigonometricVelocities};
use solaris_profiles::{Answers, CubicHermite, ProfileError, Ranges};
use std::ops::Bound;

proptest! {
    #[test]
    fn feasible_velocities_are_those_that_a_search_finds(
        (duration, from, distance) in (0.1..10.0, -5.0..5.0, 0.1..5.0),
        other in 0.0..6.0_f64,
        (backwards, at_end) in any::<(bool, bool)>(),
        (exponent, shape) in (3..10_u32, -3.0..0.9),
        stiffness in prop_oneof![Just(0.0), 0.0..20.0, (-9.0..3.0_f64).prop_map(|x| 10_f64.powf(x))],
    ) {
        let sign = if backwards { -1.0 } else { 1.0 };
        let (to, other): (f64, f64) = (from + sign * distance, sign * other);
        let (start, end) = (|v| (from, v), |v| (to, v));
        macro_rules! check {
            ($curve:ident $(, $parameter:expr)*) => {
                if at_end {
                    let found = $curve::feasible_end_velocity(duration, from, to, other $(, $parameter)*)?;
                    check_feasible(&found, sign, |v| $curve::new(duration, start(other), end(v) $(, $parameter)*))?;
                } else {
                    let found = $curve::feasible_start_velocity(duration, from, to, other $(, $parameter)*)?;
                    check_feasible(&found, sign, |v| $curve::new(duration, start(v), end(other) $(, $parameter)*))?;
                }
            };
        }
        check!(CubicHermite);
        check!(TrigonometricVelocities);
        check!(Tension, stiffness);
        check!(ExponentialVelocities, exponent, shape);
        check!(ExponentialVelocities, exponent, 2.5);
    }
}

/// Velocities on a grid and close to the bounds are feasible where the curve does not turn round.
fn check_feasible<C: Answers>(
    found: &Ranges,
    sign: f64,
    curve: impl Fn(f64) -> Result<C, ProfileError>,
) -> Result<(), TestCaseError> {
    let bounds = found.as_slice().iter().flat_map(|range| [range.low, range.high]);
    let bounds: Vec<f64> = bounds
        .filter_map(|bound| match bound {
            Bound::Included(x) | Bound::Excluded(x) => Some(x),
            Bound::Unbounded => None,
        })
        .collect();
    let near = bounds.iter().flat_map(|x| [x * (1.0 - 1e-6), x * (1.0 + 1e-6)]);
    let grid = (-20..200).map(|i| sign * f64::from(i) * 0.1);
    for v in grid.chain(near).filter(|v| bounds.iter().all(|bound| (v - bound).abs() > 1e-9 * bound.abs())) {
        let monotone = curve(v)?.is_monotone();
        prop_assert_eq!(found.contains(v), monotone, "{} in {}", v, found);
    }
    Ok(())
}

/// T = 2, from 0 to 5; intervals that were found by a search in steps of 0.01.
#[test]
fn feasible_velocities_have_known_bounds() {
    let check = |found: Result<Ranges, ProfileError>, low: f64, high: f64| {
        let found = found.expect("ranges");
        for (x, inside) in
            [(low - 1e-5, false), (low + 1e-5, true), (high - 1e-5, true), (high + 1e-5, false)]
        {
            assert_eq!(found.contains(x), inside, "{x} in {found}");
        }
    };
    let start = |v1| TrigonometricVelocities::feasible_start_velocity(2.0, 0.0, 5.0, v1);
    check(start(1.0), 0.0, 7.482_94);
    check(start(7.0), 0.592_08, 6.755_90);
    check(start(8.3), 2.500_74, 4.354_72);
    assert!(start(8.5).expect("ranges").is_empty() && start(-5.0).expect("ranges").is_empty());
    check(CubicHermite::feasible_start_velocity(2.0, 0.0, 5.0, 5.0), 0.0, 9.330_127);
    check(Tension::feasible_start_velocity(2.0, 0.0, 5.0, 5.0, 0.0), 0.0, 9.330_127);
    // Rest stays at rest only.
    let rest = CubicHermite::feasible_end_velocity(2.0, 1.0, 1.0, 0.0).expect("ranges");
    assert!(rest.contains(0.0) && !rest.contains(1e-9) && !rest.contains(-1e-9));
    assert!(CubicHermite::feasible_end_velocity(2.0, 1.0, 1.0, 1e-9).expect("ranges").is_empty());
    let error = Tension::feasible_start_velocity(2.0, 0.0, 5.0, f64::NAN, 1.0).expect_err("NaN");
    assert_eq!(error.to_string(), "end velocity is NaN; it must be a finite number");
}
