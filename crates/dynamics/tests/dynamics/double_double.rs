//! The scalar of 32 digits against exact integers, long constants and identities.

#![allow(clippy::approx_constant, reason = "angles near quarter turns are what is tested")]

use crate::support::random::Random;
use solaris_dynamics::Real;
use solaris_dynamics::scalar::DoubleDouble;

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from_f64(x)
}

/// A whole number of at most 106 bits, or the nearest.
fn whole(x: i128) -> DoubleDouble {
    let high = x as f64;
    DoubleDouble::from_parts(high, (x - high as i128) as f64)
}

/// The difference in units of the expected number, or of 1 where that is zero.
fn error(found: DoubleDouble, expected: DoubleDouble) -> f64 {
    let difference = (found - expected).abs().to_f64();
    if expected.to_f64() == 0.0 { difference } else { difference / expected.abs().to_f64() }
}

/// 2⁻¹⁰⁶
const UNIT: f64 = 1.0 / (1_u128 << 106) as f64;

#[test]
fn sums_products_and_quotients_of_whole_numbers_are_right_to_the_last_digits() {
    let mut random = Random::new(1);
    // Up to 60 bits, more than a number of double precision holds.
    let mut draw = || (random.unit() * 2.0_f64.powi(60)) as i128 + (random.unit() * 128.0) as i128;
    for _ in 0..20_000 {
        let (a, b) = (draw(), draw());
        assert_eq!(whole(a) + whole(b), whole(a + b));
        assert_eq!(whole(a) - whole(b), whole(a - b));
        let product = whole(a) * whole(b);
        assert!(error(product, whole(a * b)) < 5.0 * UNIT, "{a} · {b} = {product}");
        if b != 0 {
            let quotient = whole(a) / whole(b) * whole(b);
            assert!(error(quotient, whole(a)) < 15.0 * UNIT, "{a} / {b} · {b} = {quotient}");
        }
    }
}

/// Angle, sine and cosine, each in two parts: the nearest number of double precision and what is left. Computed with
/// mpmath 1.3 at 700 bits.
#[rustfmt::skip]
const SINES: [(f64, [f64; 2], [f64; 2]); 8] = [
    (1.0, [0.841_470_984_807_896_5, 1.776_845_092_935_536e-18], [0.540_302_305_868_139_8, -4.760_954_612_604_417e-17]),
    (0.1, [0.099_833_416_646_828_15, 3.080_015_129_294_92e-18], [0.995_004_165_278_025_8, -5.502_101_569_183_77e-17]),
    (-2.5, [-0.598_472_144_103_956_5, 5.521_403_334_082_375e-17], [-0.801_143_615_546_933_7, -1.867_474_270_508_555_3e-17]),
    (0.785_4, [0.707_108_079_859_473_5, 3.682_127_389_714_127e-17], [0.707_105_482_511_236_3, 3.247_411_719_092_536e-17]),
    (22.0, [-0.008_851_309_290_403_876, 2.848_530_308_922_005_7e-19], [-0.999_960_826_394_637_1, -8.516_033_800_174_13e-19]),
    (355.0, [-3.014_435_335_948_845e-05, 1.301_264_399_104_634_7e-21], [-0.999_999_999_545_659, 1.057_461_284_664_352_1e-17]),
    (100_000.0, [0.035_748_797_972_016_51, 1.542_974_370_610_986_1e-18], [-0.999_360_807_438_212_4, -2.344_708_890_518_740_2e-17]),
    (1e15, [0.858_272_793_170_235_9, -2.372_639_689_262_412e-17], [-0.513_193_737_786_970_3, 5.317_997_726_826_167_5e-17]),
];

#[test]
fn sines_and_cosines_are_those_of_long_tables() {
    for (angle, sine, cosine) in SINES {
        let (s, c) = number(angle).sin_cos();
        for (found, [high, low]) in [(s, sine), (c, cosine)] {
            let error = error(found, DoubleDouble::from_parts(high, low));
            assert!(error < 1e-31, "{found} at {angle}: {error:e}");
        }
    }
}

/// π, π² and 1/π with mpmath 1.3 at 700 bits.
fn constants() -> [DoubleDouble; 3] {
    [
        DoubleDouble::from_parts(std::f64::consts::PI, 1.224_646_799_147_353_2e-16),
        DoubleDouble::from_parts(9.869_604_401_089_358, 6.265_295_508_739_711e-16),
        DoubleDouble::from_parts(0.318_309_886_183_790_7, -1.967_867_667_518_248_6e-17),
    ]
}

#[test]
fn expressions_in_pi_are_those_of_long_constants() {
    let [pi, square, reciprocal] = constants();
    assert!(error(pi * pi, square) < 5.0 * UNIT);
    assert!(error(number(1.0) / pi, reciprocal) < 10.0 * UNIT);
    assert!(error(pi * reciprocal, number(1.0)) < 5.0 * UNIT);
    // Machin: π = 16·arctan(1/5) − 4·arctan(1/239), with arctan x = x − x³/3 + x⁵/5 − …
    let arctangent = |x: f64| {
        (0..50)
            .rev()
            .fold(number(0.0), |sum, k| number(1.0) / number(f64::from(2 * k + 1)) - sum / number(x * x))
            / number(x)
    };
    let machin = number(16.0) * arctangent(5.0) - number(4.0) * arctangent(239.0);
    assert!(error(machin, pi) < 20.0 * UNIT, "{machin}");
    // What the 32 digits lack of π is its sine.
    let sine = pi.sin_cos().0.to_f64();
    assert!((sine / -2.994_769_809_718_339_7e-33 - 1.0).abs() < 1e-14, "{sine:e}");
    assert_eq!(pi.to_string(), "3.1415926535897932384626433832795e0");
    let third = number(1.0) / number(3.0);
    assert!(
        error(third, DoubleDouble::from_parts(0.333_333_333_333_333_3, 1.850_371_707_708_594e-17)) < UNIT
    );
}

/// Angles of every size up to 1e15 rad with digits beyond double precision, multiples of the eighth turn among them.
fn angles() -> impl Iterator<Item = DoubleDouble> {
    let mut random = Random::new(5);
    let [pi, ..] = constants();
    (0..6_000).map(move |i| {
        let size = 10.0_f64.powf(7.0 + 8.0 * random.unit());
        match i % 3 {
            0 => pi * number(size.round() / 4.0),
            1 => number(random.unit() * 10.0) + number(random.unit() * 1e-17),
            _ => DoubleDouble::from_parts(size, size * 1e-17),
        }
    })
}

#[test]
fn squares_of_sine_and_cosine_make_one() {
    for angle in angles() {
        let (s, c) = angle.sin_cos();
        let error = (s * s + c * c - number(1.0)).abs().to_f64();
        assert!(error < 3e-31, "{angle}: {error:e}");
    }
}

#[test]
fn sines_add_and_have_their_signs() {
    let (sine, cosine) = number(0.7).sin_cos();
    for angle in angles() {
        let ((s, c), (negative, same)) = (angle.sin_cos(), (-angle).sin_cos());
        assert_eq!((negative, same), (-s, c));
        // Exact sums only: beyond 1e3, the sum of two angles is rounded by more than the sine may be off.
        if angle.abs().to_f64() < 1e3 {
            let (t, d) = (angle + number(0.7)).sin_cos();
            let rounding = angle.abs().to_f64() * UNIT;
            assert!((t - (s * cosine + c * sine)).abs().to_f64() < 5e-31 + rounding, "{angle}");
            assert!((d - (c * cosine - s * sine)).abs().to_f64() < 5e-31 + rounding, "{angle}");
        }
        let (t, d) = angle.to_f64().sin_cos();
        let slack = 2.0 * f64::EPSILON * (1.0 + angle.abs().to_f64());
        assert!((s.to_f64() - t).abs() < slack && (c.to_f64() - d).abs() < slack, "{angle}");
    }
}

#[test]
fn small_angles_keep_all_their_digits_and_large_ones_those_of_double_precision() {
    let (s, c) = number(1e-20).sin_cos();
    // sin x = x − x³/6
    assert!(error(s, number(1e-20)) < 1e-31 && error(c, number(1.0)) < 1e-31);
    for x in [1e16, -3e22, 1e300] {
        let (s, c) = number(x).sin_cos();
        assert!((s.to_f64() - x.sin()).abs() < 1e-15 && (c.to_f64() - x.cos()).abs() < 1e-15);
    }
    let (s, c) = number(f64::INFINITY).sin_cos();
    assert!(!s.is_finite() && !c.is_finite());
}
