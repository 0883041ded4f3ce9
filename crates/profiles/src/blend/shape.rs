//! The shapes of a fade: how the weight α falls from 1 to 0 over its window.

use crate::Elementary;
use core::f64::consts::{FRAC_PI_2, LN_2};

/// The kind of a fade: the share α of the first, over the window's own time w from 0 to 1.
///
/// ```text
/// Linear          α = 1 − w
/// Exponential     α = e^(2kw)·(e^(k(1−w)) − 1)/(eᵏ − 1)
/// Sinh            α = sinh k(1−w)/sinh k
/// Trigonometric   α = sin k(1−w)/sin k
/// Smooth          α = 1 − w³·(10 − 15w + 6w²)
/// ```
///
/// k is the stiffness; k = 0 is the linear fade in all three.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.6, for the first four. There the exponential, hyperbolic and trigonometric ones are functions
/// of seconds, so that their shape changes with the unit of time; here they are functions of w, and a stiffness that is the
/// number of seconds of the window gives the thesis's own ([`Fade::thesis`](super::Fade::thesis)). `Smooth` is not in the
/// thesis: T. Flash, N. Hogan, "The coordination of arm movements", Journal of Neuroscience 5 (1985), has its polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FadeKind {
    /// At a constant rate.
    Linear,
    /// By a difference of exponentials. α rises above 1 before it falls where the stiffness is above ln 2.
    Exponential {
        /// k, not negative.
        stiffness: f64,
    },
    /// By a hyperbolic sine: fast at first.
    Sinh {
        /// k, not negative.
        stiffness: f64,
    },
    /// By a sine: slow at first. α rises above 1 before it falls where the stiffness is above π/2; there is none at π and
    /// above.
    Trigonometric {
        /// k, not negative and less than π.
        stiffness: f64,
    },
    /// By the minimum-jerk polynomial: velocity and acceleration of α are zero at both ends.
    Smooth,
}

impl FadeKind {
    /// The same kind with another stiffness; the same where it has none.
    pub fn with_stiffness(self, stiffness: f64) -> Self {
        match self {
            Self::Linear | Self::Smooth => self,
            Self::Exponential { .. } => Self::Exponential { stiffness },
            Self::Sinh { .. } => Self::Sinh { stiffness },
            Self::Trigonometric { .. } => Self::Trigonometric { stiffness },
        }
    }

    /// Its stiffness, if it has one.
    pub fn stiffness(self) -> Option<f64> {
        match self {
            Self::Linear | Self::Smooth => None,
            Self::Exponential { stiffness }
            | Self::Sinh { stiffness }
            | Self::Trigonometric { stiffness } => Some(stiffness),
        }
    }

    /// The greatest stiffness with which α stays between 0 and 1.
    pub fn largest_stiffness_within(self) -> f64 {
        match self {
            Self::Exponential { .. } => LN_2,
            Self::Trigonometric { .. } => FRAC_PI_2,
            Self::Linear | Self::Sinh { .. } | Self::Smooth => f64::INFINITY,
        }
    }
}

/// A kind with what can be computed beforehand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shape {
    kind: FadeKind,
    k: f64,
    /// e^(−k) − 1, e^(−2k) − 1, sin k.
    whole: f64,
}

impl Shape {
    pub(super) fn new(kind: FadeKind) -> Self {
        let k = kind.stiffness().unwrap_or(0.0);
        // Below this, all digits are those of the linear fade.
        let kind = if k < 1e-100 && kind != FadeKind::Smooth { FadeKind::Linear } else { kind };
        let whole = match kind {
            FadeKind::Linear | FadeKind::Smooth => 1.0,
            FadeKind::Exponential { .. } => Elementary::exp_m1(-k),
            FadeKind::Sinh { .. } => Elementary::exp_m1(-2.0 * k),
            FadeKind::Trigonometric { .. } => Elementary::sin(k),
        };
        Self { kind, k, whole }
    }

    /// α and its first three derivatives by w, from w and r = 1 − w, each of which has all its digits.
    ///
    /// No exponential is of a positive number but that which is part of the result, and no difference is of numbers
    /// that are nearly the same.
    #[inline]
    pub(super) fn jet<F: Elementary>(&self, w: F, r: F) -> [F; 4] {
        let f = F::from_f64;
        let (k, whole) = (self.k, f(self.whole));
        match self.kind {
            FadeKind::Linear => [r, f(-1.0), f(0.0), f(0.0)],
            FadeKind::Exponential { .. } => {
                // e = e^(kw), m = e^(−kr) − 1: α = e·m/(e^(−k) − 1), and e^(2kw − k) = e·(1 + m).
                let (e, m) = ((f(k) * w).exp(), (f(-k) * r).exp_m1());
                let rate = f(-k / self.whole) * e;
                [
                    e * m / whole,
                    rate * (f(-1.0) - f(2.0) * m),
                    f(k) * rate * (f(-3.0) - f(4.0) * m),
                    f(k * k) * rate * (f(-7.0) - f(8.0) * m),
                ]
            }
            FadeKind::Sinh { .. } => {
                // sinh kr/sinh k = e^(−kw)·(1 − e^(−2kr))/(1 − e^(−2k)), and the like for cosh kr/sinh k.
                let (e, m) = ((f(-k) * w).exp(), (f(-2.0 * k) * r).exp_m1());
                let (alpha, rate) = (e * m / whole, f(k / self.whole) * e * (f(2.0) + m));
                [alpha, rate, f(k * k) * alpha, f(k * k) * rate]
            }
            FadeKind::Trigonometric { .. } => {
                let (sine, cosine) = (f(k) * r).sin_cos();
                let (alpha, rate) = (sine / whole, f(-k / self.whole) * cosine);
                [alpha, rate, f(-k * k) * alpha, f(-k * k) * rate]
            }
            FadeKind::Smooth => {
                let polynomial = |x: F| x * x * x * (f(10.0) - x * (f(15.0) - f(6.0) * x));
                let alpha = if w.value() < 0.5 { f(1.0) - polynomial(w) } else { polynomial(r) };
                let x = w * r;
                [alpha, f(-30.0) * x * x, f(-60.0) * x * (r - w), f(-60.0) * (f(1.0) - f(6.0) * x)]
            }
        }
    }

    /// The greatest α.
    pub(super) fn largest(&self) -> f64 {
        match self.kind {
            FadeKind::Exponential { .. } if self.k > LN_2 => {
                // e^(2k)/(4·(eᵏ − 1)).
                -0.25 * Elementary::exp(self.k) / self.whole
            }
            FadeKind::Trigonometric { .. } if self.k > FRAC_PI_2 => 1.0 / self.whole,
            _ => 1.0,
        }
    }

    /// Where α comes back to 1 after it was above; 0 where it never is.
    pub(super) fn comes_back(&self) -> f64 {
        match self.kind {
            // In x = e^(kw), α = 1 is (x − 1)·(x·e^(−k) − 1 + e^(−k)) = 0.
            FadeKind::Exponential { .. } if self.k > LN_2 => {
                1.0 + Elementary::ln_1p(-Elementary::exp(-self.k)) / self.k
            }
            FadeKind::Trigonometric { .. } if self.k > FRAC_PI_2 => {
                // sin k(1 − w) is sin k again where k(1 − w) = π − k.
                2.0 - core::f64::consts::PI / self.k
            }
            _ => 0.0,
        }
    }

    /// All w inside of the window at which α or one of its first three derivatives is greatest or smallest.
    pub(super) fn critical(&self) -> impl Iterator<Item = f64> + use<> {
        let aside = Elementary::sqrt(1.0 / 12.0_f64);
        let times = match self.kind {
            FadeKind::Linear | FadeKind::Sinh { .. } => [1.0; 4],
            // The derivatives of orders 1 to 4 are zero where e^(−kr) is 1/2, 1/4, 1/8, 1/16.
            FadeKind::Exponential { .. } => [1.0, 2.0, 3.0, 4.0].map(|order| 1.0 - order * LN_2 / self.k),
            FadeKind::Trigonometric { .. } => [1.0 - FRAC_PI_2 / self.k, 1.0, 1.0, 1.0],
            FadeKind::Smooth => [0.5 - aside, 0.5, 0.5 + aside, 1.0],
        };
        times.into_iter().filter(|&w| w > 0.0 && w < 1.0)
    }
}
