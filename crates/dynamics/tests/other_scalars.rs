//! The recursions run over any scalar: here over one that counts its operations.

mod support;

use nalgebra::Vector3;
use num_traits::{One, Zero};
use solaris_dynamics::Real;
use solaris_model::human;
use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use support::Kernel;
use support::random::Random;

thread_local! {
    /// Multiplications, and additions with subtractions.
    static COUNT: Cell<(usize, usize)> = const { Cell::new((0, 0)) };
}

fn multiplied() {
    COUNT.with(|count| count.set((count.get().0 + 1, count.get().1)));
}

fn added() {
    COUNT.with(|count| count.set((count.get().0, count.get().1 + 1)));
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Counted(f64);

macro_rules! operation {
    ($operation:ident, $method:ident, $assign:ident, $assign_method:ident, $counts:ident) => {
        impl $operation for Counted {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                $counts();
                Self(self.0.$method(other.0))
            }
        }
        impl $assign for Counted {
            fn $assign_method(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    };
}
operation!(Add, add, AddAssign, add_assign, added);
operation!(Sub, sub, SubAssign, sub_assign, added);
operation!(Mul, mul, MulAssign, mul_assign, multiplied);

impl Div for Counted {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        multiplied();
        Self(self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

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

impl Real for Counted {
    fn from_f64(x: f64) -> Self {
        Self(x)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = Real::sin_cos(self.0);
        (Self(s), Self(c))
    }
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    fn all_within(self, lower: f64, upper: f64) -> bool {
        self.0.all_within(lower, upper)
    }
    fn recip_above(self, threshold: Self) -> Self {
        Self(self.0.recip_above(threshold.0))
    }
}

#[test]
fn a_counting_scalar_gets_the_same_digits_and_stays_within_the_budget() {
    let (figure, gravity) = (human(1.75, 73.0).expect("within range"), Vector3::new(0.0, -9.806_65, 0.0));
    let mut random = Random::new(17);
    let state = [random.slice(66, 1.0), random.slice(66, 2.0), random.slice(66, 5.0)];
    let counted = state.each_ref().map(|slice| slice.iter().map(|x| Counted(*x)).collect::<Vec<_>>());
    let mut plain = Kernel::<f64>::new(&figure, gravity);
    let mut counting = Kernel::<Counted>::new(&figure, gravity);
    COUNT.set((0, 0));
    let tau = counting.inverse(&counted[0], &counted[1], &counted[2], &[]).expect("valid");
    let (multiplications, additions) = COUNT.get();
    let expected = plain.inverse(&state[0], &state[1], &state[2], &[]).expect("valid");
    assert_eq!(tau.into_iter().map(|tau| tau.0.to_bits()).collect::<Vec<_>>(), {
        expected.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    });
    // 63 turns, 3 slides, 21 links; without the sines. More is a step back.
    assert!(multiplications <= 2700 && additions <= 2300, "{multiplications} and {additions}");
}
