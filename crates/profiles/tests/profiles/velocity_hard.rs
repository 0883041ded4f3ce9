//! Hard cases of the curves given by acceleration and velocity: where the textbook formulas cancel, and where numbers
//! are extreme. Wanted values are of 60 digits.

#![allow(clippy::float_cmp, reason = "what is to be met exactly is compared exactly")]
#![allow(clippy::excessive_precision, reason = "digits as they were computed")]

use solaris_profiles::acceleration::{Constant, Ellipse, Trigonometric};
use solaris_profiles::velocity::{Circle, Faired, Line};
use solaris_profiles::{
    Answers, Boundary, CubicHermite, Curve, Elementary, ProfileError, Quintic, Sample, Turn,
};

/// Within so many units in the last place of the number itself, half of one each.
fn close<F: Elementary>(found: F, wanted: f64, units: f64) {
    let error = (found.value() - wanted).abs() / wanted.abs() / (F::EPSILON / 2.0);
    assert!(error <= units, "{found:?}, not {wanted:e}: {error:.1} of {units}");
}

#[test]
fn s6_an_ellipse_leaves_rest_to_the_last_digits() {
    // Greatest acceleration 1, from rest at 0, over 1.
    fn curve<F: Elementary>() -> Ellipse<F> {
        let (zero, one) = (F::from_f64(0.0), F::from_f64(1.0));
        Ellipse::quarter(one, (zero, zero), F::from_f64(0.75).sqrt()).expect("valid")
    }
    for (t, position, velocity) in [
        (1e-2, 3.767_192_745_697_013_754_2e-6, 0.000_941_393_562_867_481_497_36),
        (1e-4, 3.771_195_759_945_869_433_6e-11, 9.427_948_993_201_681_793_2e-7),
        (1e-6, 3.771_235_762_267_207_156_2e-16, 9.428_089_001_606_944_376_5e-10),
    ] {
        let sample = curve::<f64>().at(t);
        close(sample.position, position, 10.0);
        close(sample.velocity, velocity, 10.0);
    }
    for (t, position, velocity) in [
        (1e-2, 3.767_192_535_279_158_675e-6, 0.000_941_393_531_336_469_630_5),
        (1e-4, 3.771_195_521_775_849_076_4e-11, 9.427_948_635_950_219_412_6e-7),
        (1e-6, 3.771_235_738_463_571_170_3e-16, 9.428_088_965_901_493_923_2e-10),
    ] {
        let sample = curve::<f32>().at(t);
        close(sample.position, position, 10.0);
        close(sample.velocity, velocity, 10.0);
    }
}

#[test]
fn s7_a_circle_becomes_a_line_without_a_loss() {
    // (0, 1), (T₁, 2), (1, 3): position at 0.25 and 1, velocity at 0.25.
    for (third, quarter, velocity, end) in [
        (0.4999, 0.312_520_837_834_149_417_43, 1.500_150_024_001_439_253_6, 2.000_133_333_333_717_318_6),
        (0.499_999, 0.312_500_208_333_783_328_58, 1.500_001_500_002_399_961_3, 2.000_001_333_333_333_298),
        (
            0.499_999_99,
            0.312_500_002_083_333_377_24,
            1.500_000_015_000_000_232_1,
            2.000_000_013_333_333_326_3,
        ),
        (
            0.499_999_999_999,
            0.312_500_000_000_208_328_72,
            1.500_000_000_001_499_966_8,
            2.000_000_000_001_333_303_8,
        ),
        (0.5, 0.3125, 1.5, 2.0),
    ] {
        let curve = Circle::new(1.0, 0.0, (1.0, 3.0), (third, 2.0)).expect("valid");
        close(curve.at(0.25).position, quarter, 4.0);
        close(curve.at(0.25).velocity, velocity, 4.0);
        close(curve.at(1.0).position, end, 4.0);
        close(curve.at(1.0).velocity, 3.0, 2.0);
    }
    let curve = Circle::<f32>::new(1.0, 0.0, (1.0, 3.0), (0.499, 2.0)).expect("valid");
    close(curve.at(0.25).position, 0.312_708_781_456_369_124_88, 4.0);
    close(curve.at(0.25).velocity, 1.501_502_382_058_919_480_8, 4.0);
    close(curve.at(1.0).position, 2.001_333_316_551_180_770_6, 4.0);
}

#[test]
fn s7_a_circle_may_be_a_semicircle() {
    // Half a turn but for 2⁻⁴⁰ of its height.
    let curve = Circle::new(2.0, 0.0, (0.0, 0.0), (1.0, 1.0 - 0.5_f64.powi(40))).expect("valid");
    close(curve.at(0.25).position, 0.113_327_938_494_175_064_05, 40.0);
    close(curve.at(1.75).position, 1.457_468_388_298_902_565_8, 10.0);
    close(curve.at(2.0).position, 1.570_796_326_793_077_629_8, 4.0);
    // Half a turn: vertical at both ends, where the acceleration is infinite.
    let curve = Circle::new(2.0, 0.0, (0.0, 0.0), (1.0, -1.0)).expect("valid");
    close(curve.at(2.0).position, -core::f64::consts::FRAC_PI_2, 2.0);
    assert_eq!(curve.at(1.0), Sample { jerk: 1.0, acceleration: 0.0, velocity: -1.0, ..curve.at(1.0) });
    assert_eq!((curve.at(0.0).acceleration, curve.at(2.0).acceleration), (f64::NEG_INFINITY, f64::INFINITY));
    let refused = Circle::new(2.0, 0.0, (0.0, 0.0), (1.0, 1.001)).expect_err("more than half a turn");
    assert_eq!(
        refused.to_string(),
        "third velocity is 1.001: no arc of one semicircle leads there; it may be at least -1 and at most 1"
    );
}

#[test]
fn s9_a_half_sine_leaves_rest_to_the_last_digits() {
    fn curve<F: Elementary>() -> Trigonometric<F> {
        let (zero, one) = (F::from_f64(0.0), F::from_f64(1.0));
        Trigonometric::new(one, (zero, zero), one).expect("valid")
    }
    for (t, position, velocity) in [
        (1e-2, 5.235_729_376_415_722_471_4e-7, 0.000_157_066_713_822_559_392_79),
        (1e-5, 5.235_987_755_724_604_376_7e-16, 1.570_796_326_665_704_056_7e-10),
    ] {
        close(curve::<f64>().at(t).position, position, 10.0);
        close(curve::<f64>().at(t).velocity, velocity, 10.0);
    }
    for (t, position, velocity) in [
        (1e-2, 5.235_729_025_344_266_862_1e-7, 0.000_157_066_706_807_701_701_03),
        (1e-5, 5.235_987_358_908_084_147_6e-16, 1.570_796_247_302_399_015e-10),
    ] {
        close(curve::<f32>().at(t).position, position, 10.0);
        close(curve::<f32>().at(t).velocity, velocity, 10.0);
    }
}

type Made<F> = Result<Box<dyn Curve<F>>, ProfileError>;

/// Every curve over `duration`, from 0 to 1 or with velocities of its order.
fn all<F: Elementary>(duration: f64) -> Vec<(&'static str, Made<F>)> {
    fn boxed<F: Elementary, C: Curve<F> + 'static>(curve: Result<C, ProfileError>) -> Made<F> {
        curve.map(|curve| Box::new(curve) as Box<dyn Curve<F>>)
    }
    let n = F::from_f64;
    let (t, v) = (n(duration), 1.0 / duration);
    let (zero, one) = (n(0.0), n(1.0));
    let boundary = |x: f64, sign: f64| Boundary::new(n(x), n(sign * v), n(0.0));
    vec![
        ("constant", boxed(Constant::reaching(t, (zero, n(v)), one))),
        ("half sine", boxed(Trigonometric::reaching(t, (zero, n(v)), one))),
        ("quarter ellipse", boxed(Ellipse::quarter_reaching(t, (zero, n(-v)), one))),
        ("half ellipse", boxed(Ellipse::half_reaching(t, (zero, n(-v)), one))),
        ("line", boxed(Line::reaching(t, (zero, n(-v)), one))),
        ("circle", boxed(Circle::new(t, zero, (n(v), n(v)), (n(duration / 2.0), n(v))))),
        ("faired", boxed(Faired::reaching(t, zero, one, (n(duration / 4.0), n(duration / 2.0))))),
        ("quintic", boxed(Quintic::new(t, boundary(0.0, -1.0), boundary(1.0, 1.0)))),
        ("cubic", boxed(CubicHermite::new(t, (zero, n(-v)), (one, n(2.0 * v))))),
    ]
}

#[test]
fn very_short_and_very_long_curves_end_where_they_should() {
    for duration in [1e-9, 1e-3, 1.0, 1e9] {
        for (name, curve) in all::<f64>(duration) {
            let end = curve.unwrap_or_else(|error| panic!("{name} {duration}: {error}")).at(duration);
            assert!((end.position - 1.0).abs() <= 4.0 * f64::EPSILON, "{name} {duration}: {end:?}");
        }
        for (name, curve) in all::<f32>(duration) {
            let end = curve.unwrap_or_else(|error| panic!("{name} {duration}: {error}")).at_time(duration);
            assert!((end.position - 1.0).abs() <= 8.0 * f32::EPSILON, "{name} {duration}: {end:?}");
        }
    }
}

#[test]
fn no_curve_is_silent_about_what_cannot_be() {
    for duration in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        for (name, curve) in all::<f64>(duration) {
            assert!(curve.is_err(), "{name} over {duration}");
        }
    }
    for (name, curve) in all::<f64>(2.0) {
        let curve = curve.expect(name);
        for x in curve.at(f64::NAN).to_array() {
            assert!(x.is_nan(), "{name}: {x}");
        }
        assert_eq!(curve.at(-1.0).position, curve.at(0.0).position, "{name}");
        assert_eq!(curve.at(3.0).position, curve.at(2.0).position, "{name}");
        assert!(curve.try_at(3.0).is_err() && curve.try_at(f64::NAN).is_err() && curve.try_at(1.0).is_ok());
    }
    assert!(matches!(
        Constant::new(1.0, (0.0, 0.0), f64::NAN),
        Err(ProfileError::NotFinite { what: "acceleration", .. })
    ));
    assert!(matches!(Trigonometric::new(1.0, (0.0, 0.0), 1e308), Err(ProfileError::Overflow { .. })));
    assert!(matches!(
        Ellipse::half(1.0, (f64::NAN, 0.0), 1.0),
        Err(ProfileError::NotFinite { what: "from", .. })
    ));
    assert!(matches!(Line::new(1.0, 0.0, (-1e308, 1e308)), Err(ProfileError::Overflow { .. })));
    assert!(matches!(
        Faired::new(1.0, 0.0, 1.0, (0.5, 0.4)),
        Err(ProfileError::OutOfRange { what: "fall", .. })
    ));
    assert!(matches!(
        Faired::new(1.0, 0.0, 1.0, (1.5, 2.0)),
        Err(ProfileError::OutOfRange { what: "rise", .. })
    ));
    for third_time in [0.0, 1.0, -1.0] {
        let circle = Circle::new(1.0, 0.0, (1.0, 3.0), (third_time, 2.0));
        assert!(matches!(circle, Err(ProfileError::OutOfRange { what: "third time", .. })));
    }
    assert!(matches!(
        Quintic::minimum_jerk(1.0, 0.0, f64::NAN),
        Err(ProfileError::NotFinite { what: "to", .. })
    ));
}

#[test]
fn what_does_not_move_rests_all_the_time() {
    let resting: [Box<dyn Answers>; 9] = [
        Box::new(Constant::reaching(2.0, (1.0, 0.0), 1.0).expect("valid")),
        Box::new(Trigonometric::reaching(2.0, (1.0, 0.0), 1.0).expect("valid")),
        Box::new(Ellipse::quarter_reaching(2.0, (1.0, 0.0), 1.0).expect("valid")),
        Box::new(Ellipse::half_reaching(2.0, (1.0, 0.0), 1.0).expect("valid")),
        Box::new(Line::reaching(2.0, (1.0, 0.0), 1.0).expect("valid")),
        Box::new(Circle::new(2.0, 1.0, (0.0, 0.0), (0.5, 0.0)).expect("valid")),
        Box::new(Faired::reaching(2.0, 1.0, 1.0, (0.5, 1.5)).expect("valid")),
        Box::new(Quintic::minimum_jerk(2.0, 1.0, 1.0).expect("valid")),
        Box::new(CubicHermite::new(2.0, (1.0, 0.0), (1.0, 0.0)).expect("valid")),
    ];
    for curve in resting {
        let stationary = curve.stationary();
        assert_eq!((stationary.points.len(), stationary.rests), (0, vec![(0.0, 2.0)]));
        assert_eq!(curve.at(0.7), Sample::rest(1.0));
        assert_eq!(curve.peaks().velocity.value, 0.0);
    }
}

#[test]
fn bends_of_no_duration_are_left_out() {
    let uneased = Faired::new(2.0, 1.0, 3.0, (0.0, 2.0)).expect("valid");
    assert_eq!(uneased.at(0.0), Sample { velocity: 3.0, ..Sample::rest(1.0) });
    assert_eq!(uneased.at(2.0), Sample { velocity: 3.0, ..Sample::rest(7.0) });
    let rise_only = Faired::new(2.0, 0.0, 3.0, (2.0, 2.0)).expect("valid");
    assert_eq!(rise_only.at(2.0).velocity, 3.0);
    let fall_only = Faired::new(2.0, 0.0, 3.0, (0.0, 0.0)).expect("valid");
    assert_eq!((fall_only.at(0.0).velocity, fall_only.at(2.0).velocity), (3.0, 0.0));
}

#[test]
fn a_velocity_that_touches_zero_is_a_touch() {
    let circle = Circle::new(1.0, 0.0, (0.25, 0.25), (0.5, 0.0)).expect("valid");
    let points = circle.stationary().points;
    assert_eq!((points.len(), points[0].turn), (1, Turn::Touch));
    assert!((points[0].time - 0.5).abs() < 1e-12 && circle.is_monotone());
    // v = (1 − 2u)².
    let cubic = CubicHermite::new(1.0, (0.0, 1.0), (1.0 / 3.0, 1.0)).expect("valid");
    assert_eq!(cubic.stationary().points[0].turn, Turn::Touch);
}
