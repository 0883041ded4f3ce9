//! Exact first derivatives.

use super::Scalar;
use core::array::from_fn;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// A number with its first derivatives along `N` directions, carried through every operation by the rules of
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
/// use solaris_profiles::Dual;
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

impl<const N: usize> Add for Dual<N> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, partials: from_fn(|i| self.partials[i] + other.partials[i]) }
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, partials: from_fn(|i| self.partials[i] - other.partials[i]) }
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the product rule has a sum")]
impl<const N: usize> Mul for Dual<N> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let (x, y) = (self.value, other.value);
        Self { value: x * y, partials: from_fn(|i| x * other.partials[i] + self.partials[i] * y) }
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the quotient rule has a difference and a product")]
impl<const N: usize> Div for Dual<N> {
    type Output = Self;

    /// With z = x/y: ż = (ẋ − z·ẏ)/y.
    #[inline]
    fn div(self, other: Self) -> Self {
        let (y, z) = (other.value, self.value / other.value);
        Self { value: z, partials: from_fn(|i| (self.partials[i] - z * other.partials[i]) / y) }
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;

    #[inline]
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
    fn value(self) -> f64 {
        self.value
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.partials.iter().fold(self.value.is_finite(), |finite, partial| finite & partial.is_finite())
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = Scalar::sqrt(self.value);
        self.chain(root, 0.5 / root)
    }

    #[inline]
    fn exp(self) -> Self {
        let power = Scalar::exp(self.value);
        self.chain(power, power)
    }

    #[inline]
    fn exp_m1(self) -> Self {
        self.chain(Scalar::exp_m1(self.value), Scalar::exp(self.value))
    }

    #[inline]
    fn ln(self) -> Self {
        self.chain(Scalar::ln(self.value), 1.0 / self.value)
    }

    #[inline]
    fn ln_1p(self) -> Self {
        self.chain(Scalar::ln_1p(self.value), 1.0 / (1.0 + self.value))
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Scalar::sin_cos(self.value);
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    #[inline]
    fn sinh(self) -> Self {
        self.chain(Scalar::sinh(self.value), Scalar::cosh(self.value))
    }

    #[inline]
    fn cosh(self) -> Self {
        self.chain(Scalar::cosh(self.value), Scalar::sinh(self.value))
    }

    #[inline]
    fn tanh(self) -> Self {
        let cosine = Scalar::cosh(self.value);
        self.chain(Scalar::tanh(self.value), 1.0 / cosine / cosine)
    }

    #[inline]
    fn asin(self) -> Self {
        self.chain(Scalar::asin(self.value), 1.0 / Scalar::sqrt((1.0 - self.value) * (1.0 + self.value)))
    }

    #[inline]
    fn atan(self) -> Self {
        self.chain(Scalar::atan(self.value), 1.0 / (1.0 + self.value * self.value))
    }

    /// `xⁿ` by `ẋ·n·xⁿ⁻¹ + ṅ·xⁿ·ln x`; the second part only where n depends on something.
    #[inline]
    fn powf(self, n: Self) -> Self {
        let power = Scalar::powf(self.value, n.value);
        let by_base = n.value * Scalar::powf(self.value, n.value - 1.0);
        let by_exponent = if power.is_zero() { 0.0 } else { power * Scalar::ln(self.value) };
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
            (Scalar::sqrt, 0.5 / 0.7_f64.sqrt()),
            (Scalar::exp, 0.7_f64.exp()),
            (Scalar::exp_m1, 0.7_f64.exp()),
            (Scalar::ln, 1.0 / 0.7),
            (Scalar::ln_1p, 1.0 / 1.7),
            (Scalar::sin, 0.7_f64.cos()),
            (Scalar::cos, -0.7_f64.sin()),
            (Scalar::sinh, 0.7_f64.cosh()),
            (Scalar::cosh, 0.7_f64.sinh()),
            (Scalar::tanh, 0.7_f64.cosh().powi(-2)),
            (Scalar::asin, 1.0 / (1.0 - 0.49_f64).sqrt()),
            (Scalar::atan, 1.0 / 1.49),
            (|x| Scalar::powi(x, 3), 3.0 * 0.49),
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
        assert_dual(Scalar::powf(x, n), power, [2.5 * 0.7_f64.powf(1.5), power * 0.7_f64.ln()]);
        let at_zero = Scalar::powf(Dual::<2>::variable(0.0, 0), n);
        assert_dual(at_zero, 0.0, [0.0, 0.0]);
    }
}
