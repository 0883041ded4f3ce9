//! Counting operations.

use crate::Scalar;
use crate::scalar::assignments;
use num_traits::{One, Zero};
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    /// All that this thread has counted since it started.
    static COUNT: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

/// A number of double precision that counts what is done with it. Its digits are those of `f64`, bit for bit.
///
/// A change of sign, a comparison and a constant cost nothing. Each thread counts for itself.
///
/// # Examples
///
/// ```
/// use solaris_scalar::{Counted, Operations};
///
/// let (a, b) = (Counted::new(3.0), Counted::new(4.0));
/// let (sum, operations) = Counted::measure(|| a * a + b * b);
/// assert_eq!(sum.value(), 25.0);
/// assert_eq!(operations, Operations { multiplications: 2, additions: 1, divisions: 0, sines: 0 });
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Counted(f64);

/// How many operations were done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Operations {
    /// Products of two numbers.
    pub multiplications: u64,
    /// Sums and differences of two numbers.
    pub additions: u64,
    /// Quotients and reciprocals.
    pub divisions: u64,
    /// Pairs of a sine and a cosine.
    pub sines: u64,
}

impl Counted {
    /// The number `x`.
    pub const fn new(x: f64) -> Self {
        Self(x)
    }

    /// The number without the counting.
    pub const fn value(self) -> f64 {
        self.0
    }

    /// What `call` returns, and the operations that it did on this thread. Measurements can be nested.
    pub fn measure<R>(call: impl FnOnce() -> R) -> (R, Operations) {
        let before = COUNT.get();
        let result = call();
        (result, COUNT.get().since(before))
    }
}

impl Operations {
    const NONE: Self = Self { multiplications: 0, additions: 0, divisions: 0, sines: 0 };

    /// Operations of all kinds, a pair of a sine and a cosine as one.
    pub const fn total(self) -> u64 {
        self.multiplications + self.additions + self.divisions + self.sines
    }

    /// What was added to an earlier count.
    fn since(self, before: Self) -> Self {
        Self {
            multiplications: self.multiplications - before.multiplications,
            additions: self.additions - before.additions,
            divisions: self.divisions - before.divisions,
            sines: self.sines - before.sines,
        }
    }
}

fn multiplied(operations: &mut Operations) {
    operations.multiplications += 1;
}

fn added(operations: &mut Operations) {
    operations.additions += 1;
}

fn divided(operations: &mut Operations) {
    operations.divisions += 1;
}

/// Adds to this thread's count.
#[inline]
fn count(change: impl FnOnce(&mut Operations)) {
    let mut operations = COUNT.get();
    change(&mut operations);
    COUNT.set(operations);
}

impl Add for Counted {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn add(self, other: Self) -> Self {
        count(added);
        Self(self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn sub(self, other: Self) -> Self {
        count(added);
        Self(self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn mul(self, other: Self) -> Self {
        count(multiplied);
        Self(self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn div(self, other: Self) -> Self {
        count(divided);
        Self(self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

assignments!(Counted);

impl Zero for Counted {
    fn zero() -> Self {
        Self(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl One for Counted {
    fn one() -> Self {
        Self(1.0)
    }
}

impl Scalar for Counted {
    const EPSILON: f64 = f64::EPSILON;

    fn from_f64(x: f64) -> Self {
        Self(x)
    }

    fn sin_cos(self) -> (Self, Self) {
        count(|operations| operations.sines += 1);
        let (sine, cosine) = Scalar::sin_cos(self.0);
        (Self(sine), Self(cosine))
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    fn greatest(self) -> f64 {
        self.0.greatest()
    }

    fn all_within(self, lower: f64, upper: f64) -> bool {
        self.0.all_within(lower, upper)
    }

    /// One division, whichever side the number is on: what it costs in lanes.
    fn recip_above(self, threshold: Self) -> Self {
        count(divided);
        Self(self.0.recip_above(threshold.0))
    }

    /// One division.
    fn recip_or_nan(self, threshold: Self) -> Self {
        count(divided);
        Self(self.0.recip_or_nan(threshold.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operation_is_counted_once_and_signs_are_free() {
        let (x, y) = (Counted::new(0.5), Counted::new(3.0));
        let ((), operations) = Counted::measure(|| {
            let mut z = x;
            z += y;
            z -= x;
            z *= y;
            let _ = (x + y, x - y, x * y, x / y, -x, x.sin_cos(), x.recip_above(y), x.all_within(0.0, 1.0));
            let _ = (Counted::from_f64(2.0), Counted::zero().is_zero(), x < y);
        });
        assert_eq!(operations, Operations { multiplications: 2, additions: 4, divisions: 2, sines: 1 });
    }

    #[test]
    fn measurements_can_be_nested_and_leave_other_threads_alone() {
        let x = Counted::new(2.0);
        let (inner, outer) = Counted::measure(|| {
            let _ = x * x;
            std::thread::spawn(move || x + x).join().expect("no panic");
            Counted::measure(|| x * x + x).1
        });
        assert_eq!((inner.multiplications, inner.additions), (1, 1));
        assert_eq!((outer.multiplications, outer.additions), (2, 1));
    }
}
