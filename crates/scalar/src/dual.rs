//! Dual numbers, which carry exact first derivatives.

use crate::{Elementary, Scalar};
use core::array::from_fn;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// A dual number: a value with its first derivatives along `N` directions, carried through every operation by the rules of
/// differentiation: the derivatives of a result are exact up to rounding, and its value is that of `f64`, bit for bit.
///
/// ```text
/// (x + ε·ẋ)·(y + ε·ẏ) = x·y + ε·(x·ẏ + ẋ·y)        ε² = 0
/// ```
///
/// One pass over `Dual<8>` gives the derivatives along eight directions and costs less than eight over `Dual<1>`.
///
/// Numbers are ordered by their values first, then by their partials; they are equal where all of that is.
///
/// # Examples
///
/// Of x²·y at (3, 2), the derivatives are 2·x·y = 12 and x² = 9:
///
/// ```
/// use solaris_scalar::Dual;
///
/// let (x, y) = (Dual::<2>::variable(3.0, 0), Dual::<2>::variable(2.0, 1));
/// let z = x * x * y;
/// assert_eq!((z.value(), z.partials()), (18.0, [12.0, 9.0]));
/// ```
///
/// # Source
///
/// W. K. Clifford's dual numbers; forward differentiation by them: A. Griewank, A. Walther, "Evaluating Derivatives",
/// 2nd ed., SIAM (2008), §3.1.
#[doc(alias = "automatic differentiation")]
#[doc(alias = "autodiff")]
#[doc(alias = "jet")]
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Dual<const N: usize> {
    value: f64,
    partials: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// A number with its derivatives along each direction.
    pub const fn new(value: f64, partials: [f64; N]) -> Self {
        Self { value, partials }
    }

    /// A number that depends on nothing.
    pub const fn constant(value: f64) -> Self {
        Self { value, partials: [0.0; N] }
    }

    /// A number whose derivative is 1 along one direction and 0 along the others.
    ///
    /// # Panics
    ///
    /// Where `direction` is not below `N`.
    pub const fn variable(value: f64, direction: usize) -> Self {
        let mut partials = [0.0; N];
        partials[direction] = 1.0;
        Self { value, partials }
    }

    /// The number itself.
    pub const fn value(self) -> f64 {
        self.value
    }

    /// Its derivatives along all directions.
    pub const fn partials(self) -> [f64; N] {
        self.partials
    }

    /// Its derivative along one direction.
    ///
    /// # Panics
    ///
    /// Where `direction` is not below `N`.
    pub const fn partial(self, direction: usize) -> f64 {
        self.partials[direction]
    }

    /// The number `value` with derivatives `slope` times those of this one: the chain rule.
    #[inline]
    pub fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, partials: self.partials.map(|partial| slope * partial) }
    }
}

// Where a program is sent before it is run, or compiled again and again, its size counts: there these are calls, elsewhere they are written out.
impl<const N: usize> Add for Dual<N> {
    type Output = Self;

    #[cfg_attr(any(target_family = "wasm", debug_assertions), inline(never))]
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline)]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, partials: from_fn(|i| self.partials[i] + other.partials[i]) }
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;

    #[cfg_attr(any(target_family = "wasm", debug_assertions), inline(never))]
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline)]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, partials: from_fn(|i| self.partials[i] - other.partials[i]) }
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the product rule has a sum")]
impl<const N: usize> Mul for Dual<N> {
    type Output = Self;

    #[cfg_attr(any(target_family = "wasm", debug_assertions), inline(never))]
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline)]
    fn mul(self, other: Self) -> Self {
        let (x, y) = (self.value, other.value);
        Self { value: x * y, partials: from_fn(|i| x * other.partials[i] + self.partials[i] * y) }
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the quotient rule has a difference and a product")]
impl<const N: usize> Div for Dual<N> {
    type Output = Self;

    /// With z = x/y: ż = (ẋ − z·ẏ)/y.
    #[cfg_attr(any(target_family = "wasm", debug_assertions), inline(never))]
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline)]
    fn div(self, other: Self) -> Self {
        let (y, z) = (other.value, self.value / other.value);
        Self { value: z, partials: from_fn(|i| (self.partials[i] - z * other.partials[i]) / y) }
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;

    #[cfg_attr(any(target_family = "wasm", debug_assertions), inline(never))]
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline)]
    fn neg(self) -> Self {
        Self { value: -self.value, partials: self.partials.map(Neg::neg) }
    }
}

impl<const N: usize> AddAssign for Dual<N> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize> SubAssign for Dual<N> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<const N: usize> MulAssign for Dual<N> {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<const N: usize> Zero for Dual<N> {
    #[inline]
    fn zero() -> Self {
        Self::constant(0.0)
    }

    /// Whether the value and all derivatives are zero.
    #[inline]
    fn is_zero(&self) -> bool {
        self.partials.iter().fold(self.value.is_zero(), |zero, partial| zero & partial.is_zero())
    }
}

impl<const N: usize> One for Dual<N> {
    #[inline]
    fn one() -> Self {
        Self::constant(1.0)
    }
}

impl<const N: usize> Scalar for Dual<N> {
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::constant(x)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Scalar::sin_cos(self.value);
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.partials.iter().fold(self.value.is_finite(), |finite, partial| finite & partial.is_finite())
    }

    #[inline]
    fn greatest(self) -> f64 {
        self.value.greatest()
    }

    #[inline]
    fn all_within(self, lower: f64, upper: f64) -> bool {
        self.value.all_within(lower, upper)
    }

    #[inline]
    fn recip_above(self, threshold: Self) -> Self {
        // Zero below the threshold, and the slope with it.
        let reciprocal = self.value.recip_above(threshold.value);
        self.chain(reciprocal, -(reciprocal * reciprocal))
    }

    #[inline]
    fn recip_or_nan(self, threshold: Self) -> Self {
        let reciprocal = self.value.recip_or_nan(threshold.value);
        self.chain(reciprocal, -(reciprocal * reciprocal))
    }
}

impl<const N: usize> Elementary for Dual<N> {
    #[inline]
    fn value(self) -> f64 {
        self.value
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = Elementary::sqrt(self.value);
        self.chain(root, 0.5 / root)
    }

    #[inline]
    fn exp(self) -> Self {
        let power = Elementary::exp(self.value);
        self.chain(power, power)
    }

    #[inline]
    fn exp_m1(self) -> Self {
        self.chain(Elementary::exp_m1(self.value), Elementary::exp(self.value))
    }

    #[inline]
    fn ln(self) -> Self {
        self.chain(Elementary::ln(self.value), 1.0 / self.value)
    }

    #[inline]
    fn ln_1p(self) -> Self {
        self.chain(Elementary::ln_1p(self.value), 1.0 / (1.0 + self.value))
    }

    #[inline]
    fn sinh(self) -> Self {
        self.chain(Elementary::sinh(self.value), Elementary::cosh(self.value))
    }

    #[inline]
    fn cosh(self) -> Self {
        self.chain(Elementary::cosh(self.value), Elementary::sinh(self.value))
    }

    #[inline]
    fn tanh(self) -> Self {
        let cosine = Elementary::cosh(self.value);
        self.chain(Elementary::tanh(self.value), 1.0 / cosine / cosine)
    }

    #[inline]
    fn asin(self) -> Self {
        self.chain(
            Elementary::asin(self.value),
            1.0 / Elementary::sqrt((1.0 - self.value) * (1.0 + self.value)),
        )
    }

    #[inline]
    fn atan(self) -> Self {
        self.chain(Elementary::atan(self.value), 1.0 / (1.0 + self.value * self.value))
    }

    /// `xⁿ` by `ẋ·n·xⁿ⁻¹ + ṅ·xⁿ·ln x`; the second part only where n depends on something.
    #[inline]
    fn powf(self, n: Self) -> Self {
        let power = Elementary::powf(self.value, n.value);
        let by_base = n.value * Elementary::powf(self.value, n.value - 1.0);
        let by_exponent = if power.is_zero() { 0.0 } else { power * Elementary::ln(self.value) };
        Self {
            value: power,
            partials: from_fn(|i| {
                let along_base = by_base * self.partials[i];
                if n.partials[i].is_zero() { along_base } else { along_base + by_exponent * n.partials[i] }
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// At x = 0.7, y = −1.3, with derivatives along both.
    fn variables() -> (Dual<2>, Dual<2>) {
        (Dual::variable(0.7, 0), Dual::variable(-1.3, 1))
    }

    fn assert_dual(found: Dual<2>, value: f64, partials: [f64; 2]) {
        assert_relative_eq!(found.value(), value, max_relative = 1e-15);
        for i in 0..2 {
            assert_relative_eq!(found.partial(i), partials[i], max_relative = 1e-14, epsilon = 1e-16);
        }
    }

    #[test]
    fn each_operation_has_its_rule() {
        let (a, b) = variables();
        let (x, y) = (a.value(), b.value());
        assert_dual(a + b, x + y, [1.0, 1.0]);
        assert_dual(a - b, x - y, [1.0, -1.0]);
        assert_dual(a * b, x * y, [y, x]);
        assert_dual(a / b, x / y, [1.0 / y, -x / (y * y)]);
        assert_dual(-a, -x, [-1.0, 0.0]);
        let (sine, cosine) = a.sin_cos();
        assert_dual(sine, x.sin(), [x.cos(), 0.0]);
        assert_dual(cosine, x.cos(), [-x.sin(), 0.0]);
        assert_dual(Dual::constant(2.0) * b, 2.0 * y, [0.0, 2.0]);
    }

    #[test]
    fn assignments_follow_their_operations() {
        let (a, b) = variables();
        let mut c = a;
        c += b;
        assert_eq!(c, a + b);
        c -= a;
        assert_eq!(c, a + b - a);
        c *= b;
        assert_eq!(c, (a + b - a) * b);
    }

    #[test]
    fn a_composed_expression_obeys_the_chain_rule() {
        // f = sin(x·y)/(x + y²), by the quotient rule on paper.
        let (a, b) = variables();
        let f = (a * b).sin_cos().0 / (a + b * b);
        let (x, y) = (a.value(), b.value());
        let ((s, c), below) = ((x * y).sin_cos(), x + y * y);
        let by_x = c * y / below - s / (below * below);
        let by_y = c * x / below - s * 2.0 * y / (below * below);
        assert_dual(f, s / below, [by_x, by_y]);
    }

    #[test]
    fn each_function_has_its_derivative() {
        type Function = fn(Dual<1>) -> Dual<1>;
        let functions: [(Function, f64); 13] = [
            (Elementary::sqrt, 0.5 / 0.7_f64.sqrt()),
            (Elementary::exp, 0.7_f64.exp()),
            (Elementary::exp_m1, 0.7_f64.exp()),
            (Elementary::ln, 1.0 / 0.7),
            (Elementary::ln_1p, 1.0 / 1.7),
            (Elementary::sin, 0.7_f64.cos()),
            (Elementary::cos, -0.7_f64.sin()),
            (Elementary::sinh, 0.7_f64.cosh()),
            (Elementary::cosh, 0.7_f64.sinh()),
            (Elementary::tanh, 0.7_f64.cosh().powi(-2)),
            (Elementary::asin, 1.0 / (1.0 - 0.49_f64).sqrt()),
            (Elementary::atan, 1.0 / 1.49),
            (|x| Elementary::powi(x, 3), 3.0 * 0.49),
        ];
        for (function, slope) in functions {
            let found = function(Dual::variable(0.7, 0));
            assert_relative_eq!(found.partial(0), slope, max_relative = 1e-14);
            // The value is that of the same function of a number without derivatives.
            assert_relative_eq!(found.value(), function(Dual::constant(0.7)).value(), max_relative = 1e-16);
        }
    }

    #[test]
    fn a_power_depends_on_base_and_exponent() {
        let (x, n) = (Dual::<2>::variable(0.7, 0), Dual::variable(2.5, 1));
        let power = 0.7_f64.powf(2.5);
        assert_dual(Elementary::powf(x, n), power, [2.5 * 0.7_f64.powf(1.5), power * 0.7_f64.ln()]);
        let at_zero = Elementary::powf(Dual::<2>::variable(0.0, 0), n);
        assert_dual(at_zero, 0.0, [0.0, 0.0]);
    }

    #[test]
    fn sine_and_cosine_are_those_of_its_value() {
        let (sine, cosine) = Dual::<1>::variable(0.7, 0).sin_cos();
        let (s, c) = Scalar::sin_cos(0.7_f64);
        assert_eq!((sine, cosine), (Dual::new(s, [c]), Dual::new(c, [-s])));
    }

    #[test]
    fn a_reciprocal_above_a_threshold_has_the_derivatives_of_its_side() {
        let (a, b) = variables();
        let found = a.recip_above(b);
        assert_dual(found, 1.0 / 0.7, [-1.0 / 0.49, 0.0]);
        assert!(found.partial(1).is_zero());
        assert_eq!(a.recip_above(Dual::constant(0.7)), Dual::zero());
        assert_eq!(b.recip_above(a), Dual::zero());
        assert_eq!(Dual::<1>::variable(f64::NAN, 0).recip_above(Dual::zero()).value().to_bits(), 0);
    }

    #[test]
    fn derivatives_count_for_what_is_finite_and_zero_but_not_for_what_is_within() {
        assert!(!Dual::new(1.0, [f64::NAN]).is_finite() && !Dual::new(f64::INFINITY, [0.0]).is_finite());
        assert!(Dual::new(1.0, [2.0]).is_finite());
        assert!(
            Dual::new(1.0, [9.0]).all_within(1.0, 2.0) && !Dual::new(f64::NAN, [0.0]).all_within(-1.0, 1.0)
        );
        assert!(!Dual::new(0.0, [1.0]).is_zero() && Dual::<1>::constant(0.0).is_zero());
    }
}
