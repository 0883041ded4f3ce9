//! The blended motion.

use super::fade::{Fade, Leaving, Side};
use super::jet::{complement, constant, difference, quotient, sum, weighted};
use super::layer::{self, Layer};
use crate::Elementary;
use crate::clip::{Clip, Outside};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_duration, check_overflow, check_range};
use crate::range::Range;
use crate::sample::Sample;
use alloc::vec::Vec;

/// One motion that fades into another, or the weighted mean of several: itself a curve, from time 0 to the latest end of its
/// clips.
///
/// ```text
/// R = Σ Wᵢ·fᵢ        Wᵢ = wᵢ/Σ w
/// R′ = Σ Wᵢ·fᵢ′ + Wᵢ′·(fᵢ − h)
/// R″ = Σ Wᵢ·fᵢ″ + 2·Wᵢ′·(fᵢ′ − h′) + Wᵢ″·(fᵢ − h)
/// ```
///
/// and so on for the jerk, with h any of the motions, since the Wᵢ sum to one; of two motions, W₁ = α and W₂ = 1 − α.
///
/// Clips of different kinds of curves are blended as `Clip<&dyn Curve>` or `Clip<Box<dyn Answers>>`.
///
/// # Examples
///
/// ```
/// use solaris_profiles::blend::{Blend, Fade, FadeKind, Leaving};
/// use solaris_profiles::{Clip, Curve, Quintic};
///
/// let up = Quintic::minimum_jerk(2.0_f64, 0.0, 1.0)?;
/// let down = Quintic::minimum_jerk(2.0, 0.0, -1.0)?;
/// let fade = Fade::new(FadeKind::Smooth, 0.0, 2.0)?;
/// let blend = Blend::between(Clip::new(up), Clip::new(down), fade, Leaving::Refuse)?;
/// // Half-way, they cancel out.
/// assert!(blend.at(1.0).position.abs() < 1e-15);
/// assert_eq!(blend.at(2.0).position, -1.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.6 and §6.7.1, which blends position, velocity and acceleration alike with α; but a velocity
/// blended so is not that of the blended position (E26 of the misprints in `docs/sources.md`). Here all are derivatives of the
/// blended position. More than two motions the thesis blends one after the other, so that the result depends on their order;
/// here they have weights. That is done too by blending blends.
#[doc(alias = "crossfade")]
#[doc(alias = "transition")]
#[doc(alias = "mix")]
#[doc(alias = "animation blending")]
#[derive(Clone, Debug, PartialEq)]
pub struct Blend<C, F = f64> {
    pub(super) parts: Parts<C, F>,
    pub(super) duration: f64,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Parts<C, F> {
    Two([Clip<C, F>; 2], Fade),
    Many(Vec<Layer<C, F>>),
}

impl<C: Curve<F>, F: Elementary> Blend<C, F> {
    /// `first` fades into `second`.
    ///
    /// # Errors
    ///
    /// With [`Leaving::Refuse`], a fade whose α leaves 0 to 1, which is one with too great a stiffness; clips that end at 0
    /// or before, or so late that it overflows; a clip that repeats more than 1e5 times; a window so short that a derivative of α overflows in `F`.
    pub fn between(
        first: Clip<C, F>,
        second: Clip<C, F>,
        fade: Fade,
        leaving: Leaving,
    ) -> Result<Self, ProfileError> {
        let fade = fade.leaving(leaving)?;
        fade.check::<F>()?;
        let duration = duration([&first, &second].into_iter())?;
        Ok(Self { parts: Parts::Two([first, second], fade), duration })
    }

    /// The mean of motions with weights that may fade in and out.
    ///
    /// # Errors
    ///
    /// No layers; an amount below zero or not finite; a fade whose α leaves 0 to 1; clips that end at 0 or before;
    /// [`ProfileError::Weightless`] where there is a time in the span at which the weights sum to less than a millionth of the
    /// largest amount.
    pub fn weighted(layers: Vec<Layer<C, F>>) -> Result<Self, ProfileError> {
        let duration =
            if layers.is_empty() { 1.0 } else { duration(layers.iter().map(|layer| &layer.clip))? };
        layer::check(&layers, duration)?;
        Ok(Self { parts: Parts::Many(layers), duration })
    }

    /// Allocates nothing. `derivatives` are those of the time, and no value.
    #[inline]
    pub(super) fn sample(&self, time: f64, derivatives: F, side: Side) -> Sample<F> {
        Sample::from_array(match &self.parts {
            Parts::Two([first, second], fade) => {
                let alpha = fade.jet(time, derivatives, side);
                if alpha == constant(F::from_f64(0.0)) {
                    return second.sided(time, derivatives, side);
                } else if alpha == constant(F::from_f64(1.0)) {
                    return first.sided(time, derivatives, side);
                }
                let first = first.sided(time, derivatives, side).to_array();
                let second = second.sided(time, derivatives, side).to_array();
                let part = weighted(alpha, first, difference(first, second));
                sum(part, weighted(complement(alpha), second, constant(F::from_f64(0.0))))
            }
            Parts::Many(layers) => {
                let (total, Some(chosen)) = layer::total(layers, time, derivatives, side) else {
                    return Sample::from_array([F::from_f64(f64::NAN); 4]);
                };
                let reference = chosen.clip.sided(time, derivatives, side).to_array();
                let zero = constant(F::from_f64(0.0));
                layers.iter().fold(zero, |blended, layer| {
                    let weight = layer.weight(time, derivatives, side);
                    if weight == zero {
                        return blended;
                    }
                    let weight = quotient(weight, total);
                    let part = if core::ptr::eq(layer, chosen) {
                        weighted(weight, reference, zero)
                    } else {
                        let curve = layer.clip.sided(time, derivatives, side).to_array();
                        weighted(weight, curve, difference(curve, reference))
                    };
                    sum(blended, part)
                })
            }
        })
    }

    pub(super) fn clips(&self) -> impl Iterator<Item = &Clip<C, F>> {
        let (two, many) = match &self.parts {
            Parts::Two(clips, _) => (clips.as_slice(), [].as_slice()),
            Parts::Many(layers) => ([].as_slice(), layers.as_slice()),
        };
        two.iter().chain(many.iter().map(|layer| &layer.clip))
    }

    pub(super) fn fades(&self) -> impl Iterator<Item = &Fade> {
        let (two, many) = match &self.parts {
            Parts::Two(_, fade) => (Some(fade), [].as_slice()),
            Parts::Many(layers) => (None, layers.as_slice()),
        };
        two.into_iter().chain(many.iter().flat_map(Layer::fades))
    }
}

impl<C: Curve<F>, F: Elementary> Curve<F> for Blend<C, F> {
    fn duration(&self) -> F {
        F::from_f64(self.duration)
    }

    fn span(&self) -> f64 {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration());
        let time = t.value();
        let side = if time >= self.duration().value() { Side::Before } else { Side::After };
        self.sample(time, t - F::from_f64(time), side)
    }

    fn at_time(&self, t: f64) -> Sample<F> {
        let time = within(t, self.duration);
        let side = if time >= self.duration { Side::Before } else { Side::After };
        self.sample(time, F::from_f64(0.0), side)
    }

    fn before(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration());
        let time = t.value();
        let side = if time > 0.0 { Side::Before } else { Side::After };
        self.sample(time, t - F::from_f64(time), side)
    }
}

/// More repeats of a clip than this would take too long to answer for.
const MOST_REPEATS: f64 = 1e5;

/// A clip that repeats begins at most this many repeats before the blend: a time that is farther away says nothing about
/// where in a repeat the blend begins.
const FARTHEST: f64 = 1e9;

/// The latest end of the clips.
fn duration<'a, C: Curve<F> + 'a, F: Elementary>(
    clips: impl Iterator<Item = &'a Clip<C, F>> + Clone,
) -> Result<f64, ProfileError> {
    let duration = clips.clone().map(Clip::end).fold(f64::NEG_INFINITY, f64::max);
    check_overflow("duration of the blend", &[F::from_f64(duration)])?;
    check_duration(duration)?;
    for clip in clips.filter(|clip| matches!(clip.policy(), Outside::Repeat | Outside::Mirror)) {
        let period = clip.curve().span();
        if period > 0.0 {
            check_range("number of repeats in the blend", duration / period, Range::at_most(MOST_REPEATS))?;
            let before = clip.start().abs() / period;
            check_range("number of repeats before the blend", before, Range::at_most(FARTHEST))?;
        }
    }
    Ok(duration)
}
