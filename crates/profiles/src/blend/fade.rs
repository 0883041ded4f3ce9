//! A window of time over which one motion gives way to another.

use super::Keeps;
pub use super::shape::FadeKind;
use super::shape::Shape;
use crate::Elementary;
use crate::error::{ProfileError, check_finite, check_overflow, check_range};
use crate::range::Range;
use core::f64::consts::PI;
use core::ops::Bound::{Excluded, Included, Unbounded};

/// The policy for a fade whose α leaves 0 to 1 within its window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Leaving {
    /// Refuse it.
    #[default]
    Refuse,
    /// Hold α at 1 until it comes back to 1; from there it falls to 0, and its rate jumps there.
    Clamp,
    /// Let it be: the blend runs beyond the first motion, away from the second.
    Allow,
}

/// Which side of an instant is asked for, where something jumps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// What holds before it.
    Before,
    /// What holds from it on.
    After,
}

/// A fade: when and how one motion gives way to another; α is 1 before the window, falls to 0 within it, and is 0 after it.
///
/// Times are absolute, in double precision.
///
/// # Examples
///
/// ```
/// use solaris_profiles::blend::{Fade, FadeKind};
///
/// let fade = Fade::new(FadeKind::Linear, 1.0, 3.0)?;
/// assert_eq!(fade.alpha::<f64>(1.5), [0.75, -0.5, 0.0, 0.0]);
/// assert_eq!(fade.alpha::<f64>(9.0), [0.0; 4]);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "crossfade")]
#[doc(alias = "weight")]
#[doc(alias = "transition")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Written", into = "Written"))]
pub struct Fade {
    kind: FadeKind,
    start: f64,
    end: f64,
    shape: Shape,
    /// 1/L, 1/L², 1/L³.
    rates: [f64; 3],
    /// Up to where in the window α is held at 1.
    hold: f64,
}

impl Fade {
    /// A fade over the window from `start` to `end`.
    ///
    /// Whether α may leave 0 to 1, [`Blend`](super::Blend) is asked.
    ///
    /// # Errors
    ///
    /// A time or stiffness that is not finite; an end that is not after the start; a stiffness below 0, or of π and more for
    /// the trigonometric fade; a window so short, or a stiffness so great, that a derivative of α overflows.
    pub fn new(kind: FadeKind, start: f64, end: f64) -> Result<Self, ProfileError> {
        check_finite("start of the window", &[start])?;
        check_range("end of the window", end, Range::new(Excluded(start), Unbounded))?;
        let length = end - start;
        check_overflow("length of the window", &[length])?;
        if let Some(stiffness) = kind.stiffness() {
            let trigonometric = matches!(kind, FadeKind::Trigonometric { .. });
            let high = if trigonometric { Excluded(PI) } else { Unbounded };
            check_range("stiffness", stiffness, Range::new(Included(0.0), high))?;
        }
        let rate = 1.0 / length;
        let rates = [rate, rate * rate, rate * rate * rate];
        let fade = Self { kind, start, end, shape: Shape::new(kind), rates, hold: 0.0 };
        fade.check::<f64>()?;
        Ok(fade)
    }

    /// The thesis's own: its stiffness, if it has one, is the length of the window as a number of seconds.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new): a trigonometric fade must be shorter than π seconds.
    ///
    /// # Source
    ///
    /// Vasilonikolidakis (1991), §5.6: sinh(t₁ − t)/sinh(t₁ − t₀) and the like. Its expanded forms in e^(t₀) lose all digits
    /// where the window begins late; these do not.
    pub fn thesis(kind: FadeKind, start: f64, end: f64) -> Result<Self, ProfileError> {
        Self::new(kind.with_stiffness(end - start), start, end)
    }

    /// Its kind.
    pub fn kind(&self) -> FadeKind {
        self.kind
    }

    /// When its window begins.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// When its window ends.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The greatest α: above 1 where α leaves 0 to 1.
    pub fn largest(&self) -> f64 {
        self.shape.largest()
    }

    /// Whether α stays between 0 and 1, and so never rises.
    pub fn is_monotone(&self) -> bool {
        self.kind.stiffness().is_none_or(|stiffness| stiffness <= self.kind.largest_stiffness_within())
    }

    /// What stays continuous at the ends of the window.
    pub fn keeps(&self) -> Keeps {
        Keeps { at_rest: if self.kind == FadeKind::Smooth { 2 } else { 0 } }
    }

    /// α and its first three derivatives by time. At both ends of the window, the derivatives are those within.
    #[inline]
    pub fn alpha<F: Elementary>(&self, time: f64) -> [F; 4] {
        if time < self.start || time > self.end {
            return self.jet(time, F::from_f64(0.0), Side::After);
        }
        self.inside(time, F::from_f64(0.0))
    }

    /// The same at a time that may have derivatives.
    #[inline]
    pub fn alpha_at<F: Elementary>(&self, time: F) -> [F; 4] {
        let value = time.value();
        let derivatives = time - F::from_f64(value);
        if value < self.start || value > self.end {
            return self.jet(value, derivatives, Side::After);
        }
        self.inside(value, derivatives)
    }

    /// The same, with what holds on one side of the ends of the window. `derivatives` are those of the time, and no value.
    #[inline]
    pub(super) fn jet<F: Elementary>(&self, time: f64, derivatives: F, side: Side) -> [F; 4] {
        let (zero, one) = (F::from_f64(0.0), F::from_f64(1.0));
        let (begun, ended) = match side {
            Side::After => (time >= self.start, time >= self.end),
            Side::Before => (time > self.start, time > self.end),
        };
        if ended {
            [zero; 4]
        } else if begun || time.is_nan() {
            let alpha = self.inside(time, derivatives);
            if self.hold > 0.0 && self.is_held(time, side) { [one, zero, zero, zero] } else { alpha }
        } else {
            [one, zero, zero, zero]
        }
    }

    /// The same with α held at 1 as long as it would be above, if that is asked for.
    pub(super) fn leaving(self, leaving: Leaving) -> Result<Self, ProfileError> {
        match (leaving, self.kind.stiffness()) {
            (Leaving::Clamp, _) => Ok(Self { hold: self.shape.comes_back(), ..self }),
            (Leaving::Refuse, Some(stiffness)) => {
                check_range(
                    "stiffness",
                    stiffness,
                    Range::closed(0.0, self.kind.largest_stiffness_within()),
                )?;
                Ok(self)
            }
            _ => Ok(self),
        }
    }

    /// Where α begins to fall: the start of the window, or where it is no longer held.
    pub(super) fn begins(&self) -> f64 {
        if self.hold > 0.0 { self.start + self.hold * (self.end - self.start) } else { self.start }
    }

    /// The times between which α and its first three derivatives each only rise or only fall.
    pub(super) fn breaks(&self) -> impl Iterator<Item = f64> + use<'_> {
        let inside = self.shape.critical().map(|w| self.start + w * (self.end - self.start));
        [self.start, self.begins(), self.end].into_iter().chain(inside)
    }

    /// Refuses what overflows in the scalar of a blend.
    pub(super) fn check<F: Elementary>(&self) -> Result<(), ProfileError> {
        for w in [0.0, 0.5, 1.0] {
            let jet: [F; 4] = self.scaled(self.shape.jet(w, 1.0 - w)).map(F::from_f64);
            check_overflow("a derivative of the fade", &jet)?;
        }
        check_overflow("a derivative of the fade", &self.rates.map(F::from_f64))
    }

    fn is_held(&self, time: f64, side: Side) -> bool {
        let begins = self.begins();
        time < begins || (side == Side::Before && time <= begins)
    }

    #[inline]
    fn inside<F: Elementary>(&self, time: f64, derivatives: F) -> [F; 4] {
        let length = self.end - self.start;
        let (w, r) = ((time - self.start) / length, (self.end - time) / length);
        if F::EPSILON > f64::EPSILON {
            // The time has all its digits, and a stiff fade wants them.
            return self.scaled(self.shape.jet(w, r)).map(F::from_f64);
        }
        let derivatives = derivatives * F::from_f64(self.rates[0]);
        self.scaled(self.shape.jet(F::from_f64(w) + derivatives, F::from_f64(r) - derivatives))
    }

    #[inline]
    fn scaled<F: Elementary>(&self, jet: [F; 4]) -> [F; 4] {
        let [first, second, third] = self.rates.map(F::from_f64);
        [jet[0], jet[1] * first, jet[2] * second, jet[3] * third]
    }
}

/// A fade as it is written.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Fade", deny_unknown_fields)]
struct Written {
    kind: FadeKind,
    start: f64,
    end: f64,
}

#[cfg(feature = "serde")]
impl TryFrom<Written> for Fade {
    type Error = ProfileError;

    fn try_from(written: Written) -> Result<Self, ProfileError> {
        Self::new(written.kind, written.start, written.end)
    }
}

#[cfg(feature = "serde")]
impl From<Fade> for Written {
    fn from(fade: Fade) -> Self {
        Self { kind: fade.kind, start: fade.start, end: fade.end }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::E;

    #[test]
    fn a_clamped_fade_holds_until_alpha_is_one_again() {
        for kind in [FadeKind::Exponential { stiffness: 3.0 }, FadeKind::Trigonometric { stiffness: 2.0 }] {
            let fade = Fade::new(kind, 10.0, 12.0).expect("a fade");
            let [alpha, rate, ..] = fade.alpha::<f64>(fade.leaving(Leaving::Clamp).expect("a fade").begins());
            // Right to the last digit of the time.
            let error = f64::EPSILON * 12.0 * rate.abs();
            assert!((alpha - 1.0).abs() <= error && rate < 0.0, "{kind:?}: {alpha}, {rate}");
            let clamped = fade.leaving(Leaving::Clamp).expect("a fade");
            assert!((clamped.jet::<f64>(10.5, 0.0, Side::After)[0] - 1.0).abs() < 1e-300);
            assert!(fade.alpha::<f64>(10.5)[0] > 1.0);
        }
    }

    #[test]
    fn the_greatest_share_is_that_of_the_closed_forms() {
        // e²/(4·(e − 1)) at k = 1; 1/sin 2 at k = 2.
        let exponential = Fade::new(FadeKind::Exponential { stiffness: 1.0 }, 0.0, 1.0).expect("a fade");
        assert!((exponential.largest() - E * E / (4.0 * (E - 1.0))).abs() < 1e-14);
        let trigonometric = Fade::new(FadeKind::Trigonometric { stiffness: 2.0 }, 0.0, 1.0).expect("a fade");
        assert!((trigonometric.largest() - 1.0 / 2.0_f64.sin()).abs() < 1e-14);
    }
}
