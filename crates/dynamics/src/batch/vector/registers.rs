//! Registers over the instructions of [`x86`](super::x86).
//!
//! A register is a thin name for the machine's own type, so that little is left for the compiler to see through.

#![expect(unsafe_code, reason = "vector instructions may be asked only of machines that have them")]

use super::x86::{avx2, avx512, sse2};
use super::{Register, Token};
use crate::scalar::Scalar;
use core::arch::x86_64::{_MM_HINT_T1, _mm_prefetch};
use num_traits::{One, Zero};
use solaris_scalar::sine::{self, MODERATE};
use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// Bytes that the caches hold together.
const LINE: usize = 64;

/// Sines and cosines one by one.
#[cold]
#[inline(never)]
fn lane_by_lane<R: Register>(angle: R) -> (R, R) {
    let (mut sine, mut cosine) = (angle, angle);
    for (s, c) in sine.lanes_mut().iter_mut().zip(cosine.lanes_mut()) {
        (*s, *c) = s.sin_cos();
    }
    (sine, cosine)
}

/// One set of instructions: its token, and its registers of double and of single precision, with the modules of their operations.
macro_rules! instructions {
    ($token:ident, [$($feature:tt),*], $enable:literal, $doubles:ident, $singles:ident, $module:ident) => {
        #[doc = concat!("The proof that the machine has ", $enable, ".")]
        #[derive(Clone, Copy)]
        pub(in crate::batch) struct $token(());

        impl Token for $token {
            fn new() -> Option<Self> {
                (true $(&& std::arch::is_x86_feature_detected!($feature))*).then_some(Self(()))
            }

            #[inline]
            fn ahead<F>(self, numbers: &[F]) {
                let start = numbers.as_ptr().cast::<i8>();
                for at in (0..size_of_val(numbers)).step_by(LINE) {
                    // SAFETY: the place is within the slice, and all that happens is that its line comes nearer.
                    unsafe { _mm_prefetch::<_MM_HINT_T1>(start.add(at)) };
                }
            }

            #[inline]
            fn run<A>(self, f: impl FnOnce() -> A) -> A {
                #[target_feature(enable = $enable)]
                fn with<A>(f: impl FnOnce() -> A) -> A {
                    f()
                }
                // SAFETY: `new` has found all of them.
                unsafe { with(f) }
            }
        }

        instructions!(@register $token, $doubles, f64, $module::doubles);
        instructions!(@register $token, $singles, f32, $module::singles);

        impl $doubles {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn moderate_sin_cos(self) -> (Self, Self) {
                sine::sin_cos(self)
            }
        }

        impl sine::Bits for $doubles {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn turn_back(self, sine: Self, cosine: Self) -> (Self, Self) {
                // SAFETY: see `Groups`.
                let (sine, cosine) = unsafe { $module::doubles::turn_back(self.0, sine.0, cosine.0) };
                (Self(sine), Self(cosine))
            }
        }

        impl $singles {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn moderate_sin_cos(self) -> (Self, Self) {
                // SAFETY: see `Groups`.
                let [low, high] = unsafe { $module::singles::widen(self.0) };
                let (s, c) = sine::sin_cos_single($doubles(low));
                let (t, d) = sine::sin_cos_single($doubles(high));
                // SAFETY: see `Groups`.
                unsafe { (Self($module::singles::narrow(s.0, t.0)), Self($module::singles::narrow(c.0, d.0))) }
            }
        }
    };
    (@register $token:ident, $name:ident, $lane:ident, $module:ident::$width:ident) => {
        #[doc = concat!("A register of `", stringify!($lane), "`.")]
        #[derive(Clone, Copy)]
        #[repr(transparent)]
        pub(in crate::batch) struct $name($module::$width::Register);

        // SAFETY (of all that follows): see `Groups`: registers are there only where a token has proved that the machine has their
        // instructions.
        instructions!(@operation $name, $module::$width, Add, add, AddAssign, add_assign);
        instructions!(@operation $name, $module::$width, Sub, sub, SubAssign, sub_assign);
        instructions!(@operation $name, $module::$width, Mul, mul, MulAssign, mul_assign);

        impl Div for $name {
            type Output = Self;

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn div(self, other: Self) -> Self {
                Self(unsafe { $module::$width::div(self.0, other.0) })
            }
        }

        impl Neg for $name {
            type Output = Self;

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn neg(self) -> Self {
                Self(unsafe { $module::$width::xor(self.0, Self::splat(-0.0).0) })
            }
        }

        impl $name {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn splat(x: $lane) -> Self {
                Self(unsafe { $module::$width::splat(x) })
            }

            /// Whether `|x| ≤ bound` in all lanes.
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn is_within(self, bound: $lane) -> bool {
                let magnitude = unsafe { $module::$width::andnot(Self::splat(-0.0).0, self.0) };
                unsafe { $module::$width::all_le(magnitude, Self::splat(bound).0) }
            }

            /// `x` where `self > threshold`, elsewhere `y`.
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn where_above(self, threshold: Self, x: Self, y: Self) -> Self {
                Self(unsafe { $module::$width::select_gt(self.0, threshold.0, x.0, y.0) })
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.lanes().fmt(f)
            }
        }

        /// Equal where all lanes are.
        impl PartialEq for $name {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn eq(&self, other: &Self) -> bool {
                unsafe { $module::$width::all_le(self.0, other.0) && $module::$width::all_le(other.0, self.0) }
            }
        }

        impl Zero for $name {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn zero() -> Self {
                Self::splat(0.0)
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl One for $name {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn one() -> Self {
                Self::splat(1.0)
            }
        }

        impl Register for $name {
            type Token = $token;
            type Lane = $lane;

            const LANES: usize = size_of::<Self>() / size_of::<$lane>();

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn lanes(&self) -> &[$lane] {
                // SAFETY: a register is `LANES` numbers in a row, at a place that is aligned for one.
                unsafe { std::slice::from_raw_parts(std::ptr::from_ref(self).cast(), Self::LANES) }
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn lanes_mut(&mut self) -> &mut [$lane] {
                // SAFETY: as above.
                unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(self).cast(), Self::LANES) }
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn transposed(square: &[Self]) -> impl AsRef<[Self]> + use<> {
                const LANES: usize = $name::LANES;
                let mut square: [Self; LANES] = square.try_into().expect("as many as lanes");
                // A place is told by a number, its register's digits before its lane's. Each round puts the first binary digit last.
                let mut rounds = LANES.trailing_zeros();
                while rounds > 0 {
                    let from = square;
                    for i in 0..LANES / 2 {
                        let (a, b) = (from[i].0, from[i + LANES / 2].0);
                        let [low, high] = unsafe { $module::$width::interleave(a, b) };
                        (square[2 * i], square[2 * i + 1]) = (Self(low), Self(high));
                    }
                    rounds -= 1;
                }
                square
            }
        }

        #[allow(clippy::cast_lossless, reason = "one text for both widths")]
        impl Scalar for $name {
            const EPSILON: f64 = $lane::EPSILON as f64;

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn from_f64(x: f64) -> Self {
                Self::splat(x as $lane)
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn times_plus(self, a: Self, b: Self) -> Self {
                Self(unsafe { $module::$width::times_plus(self.0, a.0, b.0) })
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn times_from(self, a: Self, b: Self) -> Self {
                Self(unsafe { $module::$width::times_from(self.0, a.0, b.0) })
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn sin_cos(self) -> (Self, Self) {
                if self.is_within(MODERATE as $lane) { self.moderate_sin_cos() } else { lane_by_lane(self) }
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn sin_cos_all(angles: &[Self], pairs: &mut [(Self, Self)]) {
                for (angle, pair) in angles.iter().zip(pairs) {
                    *pair = angle.sin_cos();
                }
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn is_finite(self) -> bool {
                self.is_within($lane::MAX)
            }

            fn greatest(self) -> f64 {
                self.lanes().iter().fold(f64::NEG_INFINITY, |greatest, lane| greatest.max(lane.greatest()))
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn all_within(self, lower: f64, upper: f64) -> bool {
                let (lower, upper) = (Self::from_f64(lower), Self::from_f64(upper));
                unsafe { $module::$width::all_le(lower.0, self.0) && $module::$width::all_le(self.0, upper.0) }
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn recip_above(self, threshold: Self) -> Self {
                self.where_above(threshold, Self::one() / self, Self::zero())
            }

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn recip_or_nan(self, threshold: Self) -> Self {
                let nan = Self::splat($lane::NAN);
                let recip = self.where_above(threshold, Self::one() / self, nan);
                self.where_above(Self::zero(), recip, nan)
            }
        }
    };
    (@operation $name:ident, $module:ident::$width:ident, $operation:ident, $method:ident, $assignment:ident, $assign:ident) => {
        impl $operation for $name {
            type Output = Self;

            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self(unsafe { $module::$width::$method(self.0, other.0) })
            }
        }

        impl $assignment for $name {
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            fn $assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    };
}

instructions!(Sse2, ["sse2"], "sse2", Doubles2, Singles4, sse2);
instructions!(Avx2, ["avx2", "fma"], "avx2,fma", Doubles4, Singles8, avx2);
instructions!(
    Avx512,
    ["avx512f", "avx512dq", "avx512vl", "avx2", "fma"],
    "avx512f,avx512dq,avx512vl,avx2,fma",
    Doubles8,
    Singles16,
    avx512
);
