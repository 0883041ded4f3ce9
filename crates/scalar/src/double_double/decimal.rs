//! Writing 32 digits.

use super::DoubleDouble;
use num_traits::One;
use std::fmt;

/// Digits written.
const DIGITS: i32 = 32;

/// As a decimal number of at most 32 digits with its exponent, like `3.14159265358979323846264338327951e0`; for numbers of
/// extreme size the last digit or two may be off.
impl fmt::Display for DoubleDouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.high == 0.0 || !self.high.is_finite() {
            return write!(f, "{:e}", self.high);
        }
        let sign = if self.high < 0.0 { "-" } else { "" };
        let (digits, exponent) = digits(self.abs());
        let digits = digits.to_string();
        let (first, rest) = digits.split_at(1);
        match rest.trim_end_matches('0') {
            "" => write!(f, "{sign}{first}e{exponent}"),
            rest => write!(f, "{sign}{first}.{rest}e{exponent}"),
        }
    }
}

/// As it is displayed.
impl fmt::Debug for DoubleDouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// `(d, e)`: a positive number as d·10^(e − 31), where d has 32 digits.
fn digits(x: DoubleDouble) -> (u128, i32) {
    let least = 10_u128.pow(DIGITS as u32 - 1);
    let at = |exponent: i32| nearest(shifted(x, DIGITS - 1 - exponent));
    let mut exponent = x.high.log10().floor() as i32;
    // Just below a power of ten, the logarithm is that of the power.
    if at(exponent) < least {
        exponent -= 1;
    }
    (at(exponent).clamp(least, 10 * least - 1), exponent)
}

/// The nearest whole number of a positive number below 2¹²⁷.
fn nearest(x: DoubleDouble) -> u128 {
    // From 2⁵³ on, the high part is whole.
    let whole = x.high as u128;
    whole.saturating_add_signed(x.low.round() as i128)
}

/// `x·10^n`, in steps that stay within the range of `f64` where `x` and the result do.
fn shifted(x: DoubleDouble, n: i32) -> DoubleDouble {
    let step = n.clamp(-150, 150);
    let power = (0..step.abs()).fold(DoubleDouble::one(), |power, _| power * DoubleDouble::from_f64(10.0));
    let x = if step < 0 { x / power } else { x * power };
    if step == n { x } else { shifted(x, n - step) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_far_as_they_are_known() {
        let written = |high: f64, low: f64| DoubleDouble::from_parts(high, low).to_string();
        assert_eq!(written(0.0, 0.0), "0e0");
        assert_eq!(written(1.0, 0.0), "1e0");
        assert_eq!(written(-0.5, 0.0), "-5e-1");
        assert_eq!(written(1000.0, 0.0), "1e3");
        assert_eq!(written(0.1, 0.0), "1.0000000000000000555111512312578e-1");
        assert_eq!(
            written(std::f64::consts::PI, 1.224_646_799_147_353_2e-16),
            "3.1415926535897932384626433832795e0"
        );
        assert_eq!(written(f64::NAN, 0.0), "NaN");
        assert_eq!(format!("{:?}", DoubleDouble::from_f64(-2.5e10)), "-2.5e10");
    }

    #[test]
    fn numbers_beside_a_power_of_ten_have_the_right_exponent() {
        let beside = |low: f64| DoubleDouble::from_parts(1000.0, low).to_string();
        assert_eq!(beside(1e-20), "1.00000000000000000000001e3");
        assert_eq!(beside(-1e-20), "9.9999999999999999999999e2");
    }

    #[test]
    fn numbers_of_extreme_size_are_written() {
        for x in [f64::MAX, f64::MIN_POSITIVE, 1e-300, 1.25e300, 5e-324] {
            let written = DoubleDouble::from_f64(x).to_string();
            let read: f64 = written.parse().expect("a number");
            assert!((read - x).abs() <= x * 1e-15, "{written}");
        }
    }
}
