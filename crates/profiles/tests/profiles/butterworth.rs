//! The zero-phase filter against another program's, and its laws.

use approx::assert_relative_eq;
use solaris_profiles::{Butterworth, FilterError, odd_extension};
use std::f64::consts::TAU;

fn low_pass(order: usize, cutoff: f64, rate: f64) -> Butterworth {
    Butterworth::low_pass(order, cutoff, rate).expect("a filter")
}

fn filtered(filter: &Butterworth, values: &[f64]) -> Vec<f64> {
    filter.zero_phase(values).expect("long enough")
}

/// Computed with `scipy` 1.17.1: `sosfiltfilt(butter(order, cutoff, fs=60, output="sos"), x, padlen=3*(order + 1))`.
#[test]
#[rustfmt::skip]
fn numbers_are_those_of_scipy() {
    let x: Vec<f64> = (0..40).map(|i| (0.4 * f64::from(i)).sin() + 0.2 * f64::from((i * i * 7) % 11 - 5)).collect();
    let cases = [
        (1, 6.0, [-1.011_913_271_702_882_3, -0.160_830_162_107_796_88, 0.486_194_128_033_524_46,
                  0.897_519_098_593_057, 1.050_749_817_304_094_3, 1.101_217_204_903_218_5]),
        (2, 6.0, [-0.998_114_583_869_409_4, -0.134_505_085_448_816_1, 0.637_062_201_329_870_6,
                  0.998_074_663_595_699_9, 1.100_294_520_244_426_5, 1.115_180_609_071_553_3]),
        (3, 6.0, [-1.003_090_665_417_514, -0.112_383_588_985_065_06, 0.669_625_519_511_253_5,
                  1.062_758_855_070_804_7, 1.117_791_600_348_579, 1.099_518_841_915_985_8]),
        (5, 10.0, [-0.998_256_454_528_323_2, 0.139_975_754_516_140_6, 0.684_376_251_404_947_4,
                   1.087_705_443_432_643_2, 1.070_245_886_933_657_5, 1.107_070_027_219_558_4]),
        (10, 12.0, [-1.000_452_984_671_266_6, 0.278_706_327_812_786_6, 0.794_124_680_192_402,
                    1.095_527_436_318_27, 0.972_984_781_794_402_6, 1.107_954_933_751_218_5]),
    ];
    for (order, cutoff, expected) in cases {
        let y = filtered(&low_pass(order, cutoff, 60.0), &x);
        for (i, expected) in [0, 1, 7, 20, 38, 39].into_iter().zip(expected) {
            assert_relative_eq!(y[i], expected, epsilon = 1e-11);
        }
    }
}

/// `|H|² = 1/(1 + (tan(πf/rate)/tan(πc/rate))^2N)`, once for each pass, and no phase.
#[test]
fn a_wave_keeps_its_phase_and_shrinks_as_the_formula_says() {
    for order in 1..=Butterworth::HIGHEST_ORDER {
        let filter = low_pass(order, 8.0, 120.0);
        for frequency in [1.0, 6.0, 8.0, 13.0, 40.0] {
            let wave = |i: usize| (TAU * frequency * i as f64 / 120.0 + 0.4).sin();
            let x: Vec<f64> = (0..3000).map(wave).collect();
            let ratio = (TAU * frequency / 240.0).tan() / (TAU * 8.0 / 240.0).tan();
            let gain = 1.0 / (1.0 + ratio.powi(2 * order as i32));
            for (i, y) in filtered(&filter, &x).iter().enumerate().skip(1200).take(600) {
                assert_relative_eq!(*y, gain * wave(i), epsilon = 1e-9);
            }
        }
    }
}

#[test]
fn constants_pass_to_the_bit_and_lines_to_rounding() {
    for order in [1, 2, 3, 10] {
        let filter = low_pass(order, 0.5, 100.0);
        assert!(filtered(&filter, &[0.1; 60]).iter().all(|y| y.to_bits() == 0.1_f64.to_bits()));
    }
    // A line goes on in the padding, but a pass starts at rest and lags behind it by its delay at first: the padding is
    // long enough where the filter settles within it.
    let line: Vec<f64> = (0..200).map(|i| 3.0 - 0.25 * f64::from(i)).collect();
    for (x, y) in line.iter().zip(filtered(&low_pass(2, 40.0, 100.0), &line)).skip(80).take(40) {
        assert_relative_eq!(*x, y, epsilon = 1e-10);
    }
}

#[test]
fn backwards_in_time_it_is_the_same_filter_inside() {
    let x: Vec<f64> = (0..400).map(|i| f64::from((i * i * 13) % 31)).collect();
    let back: Vec<f64> = x.iter().rev().copied().collect();
    let filter = low_pass(3, 6.0, 60.0);
    let (there, back) = (filtered(&filter, &x), filtered(&filter, &back));
    for i in 150..250 {
        assert_relative_eq!(there[i], back[399 - i], epsilon = 1e-9);
    }
}

/// A filter of first order forgets by a factor each sample: `p = (1 − K)/(1 + K)`, after a first sample of `b` and a
/// second of `b(1 + p)`.
#[test]
fn what_the_ends_spoil_is_the_length_of_the_impulse_response() {
    let k = (TAU * 6.0 / 120.0).tan();
    let p = (1.0 - k) / (1.0 + k);
    let expected = 2 + (0.01_f64.ln() / p.ln()).floor() as usize;
    assert_eq!(low_pass(1, 6.0, 60.0).settling(1000), expected);
    let seconds = |order, rate: f64| low_pass(order, 6.0, rate).settling(100_000) as f64 / rate;
    assert_relative_eq!(seconds(2, 60.0), seconds(2, 6000.0), epsilon = 2.5 / 60.0);
    assert!(seconds(2, 1000.0) < seconds(3, 1000.0) && seconds(3, 1000.0) < seconds(10, 1000.0));
    assert_eq!(low_pass(2, 1e-4, 60.0).settling(50), 50);
}

#[test]
fn the_record_goes_on_turned_about_its_ends() {
    assert_eq!(odd_extension(&[1.0, 3.0, 4.0], 2), [-2.0, -1.0, 1.0, 3.0, 4.0, 5.0, 7.0]);
    assert_eq!(odd_extension(&[1.0, 3.0, 4.0], 9).len(), 7);
    assert_eq!(odd_extension(&[1.0], 4), [1.0]);
    assert!(odd_extension(&[], 4).is_empty());
}

#[test]
fn what_cannot_be_filtered_is_refused() {
    let error =
        |order, cutoff, rate| Butterworth::low_pass(order, cutoff, rate).expect_err("none").to_string();
    assert_eq!(error(0, 6.0, 60.0), "filter order 0: it must be 1 to 10");
    assert_eq!(error(11, 6.0, 60.0), "filter order 11: it must be 1 to 10");
    let message = "it must be more than zero and less than half of the 60 samples/s, 30 Hz";
    for cutoff in ["0", "30", "-1", "NaN", "inf"] {
        let asked = cutoff.parse().expect("a number");
        assert_eq!(error(2, asked, 60.0), format!("cut-off {cutoff} Hz: {message}"));
    }
    let filter = low_pass(2, 6.0, 60.0);
    assert_eq!(filter.fewest(), 10);
    assert_eq!(filter.zero_phase(&[0.0; 9]), Err(FilterError::TooShort { samples: 9, order: 2, needed: 10 }));
    let error = filter.zero_phase(&[f64::INFINITY; 10]).expect_err("not finite");
    assert_eq!(error.to_string(), "sample 0 is inf; it must be a finite number");
}

#[test]
fn times_with_few_digits_are_equally_spaced_and_jumps_are_not() {
    let rounded: Vec<f64> = (0..151).map(|i| (f64::from(i) / 60.0 * 1e6).round() / 1e6).collect();
    assert_relative_eq!(Butterworth::rate_of(&rounded).expect("equal"), 60.0, max_relative = 1e-6);
    let mut gap = rounded.clone();
    gap[70..].iter_mut().for_each(|t| *t += 0.02);
    assert!(matches!(Butterworth::rate_of(&gap), Err(FilterError::Spacing { sample: 2.., .. })));
    assert!(Butterworth::rate_of(&[1.0]).is_err() && Butterworth::rate_of(&[1.0, 1.0]).is_err());
}
