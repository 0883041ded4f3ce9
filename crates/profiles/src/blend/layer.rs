//! A motion as a part of a weighted blend.

use super::fade::{Fade, Leaving, Side};
use super::jet::{self, complement, constant, product};
use crate::Elementary;
use crate::clip::Clip;
use crate::error::{ProfileError, check_range};
use crate::range::Range;
use alloc::vec::Vec;

/// A motion with its weight over time.
///
/// ```text
/// w(t) = amount·(1 − α_in(t))·α_out(t)
/// ```
#[doc(alias = "animation layer")]
#[doc(alias = "track")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer<C, F = f64> {
    /// The motion.
    pub clip: Clip<C, F>,
    /// Its weight beside the others', not negative.
    pub amount: f64,
    /// The weight rises from zero in this window.
    pub fade_in: Option<Fade>,
    /// The weight falls to zero in this window.
    pub fade_out: Option<Fade>,
}

impl<C, F: Elementary> Layer<C, F> {
    /// A motion with weight 1 all the time.
    pub fn new(clip: Clip<C, F>) -> Self {
        Self { clip, amount: 1.0, fade_in: None, fade_out: None }
    }

    /// w.
    #[inline]
    pub(super) fn weight(&self, time: f64, derivatives: F, side: Side) -> [F; 4] {
        let mut weight = constant(F::from_f64(self.amount));
        if let Some(fade) = &self.fade_in {
            weight = product(weight, complement(fade.jet(time, derivatives, side)));
        }
        if let Some(fade) = &self.fade_out {
            weight = product(weight, fade.jet(time, derivatives, side));
        }
        weight
    }

    /// 1 − α of the fade in and α of the fade out, each of which only rises or falls between breaks.
    pub(super) fn factors(&self, time: f64, side: Side) -> [[f64; 4]; 2] {
        let jet = |fade: &Option<Fade>| fade.as_ref().map(|fade| fade.jet(time, 0.0, side));
        [jet(&self.fade_in).map_or(constant(1.0), complement), jet(&self.fade_out).unwrap_or(constant(1.0))]
    }

    pub(super) fn fades(&self) -> impl Iterator<Item = &Fade> {
        self.fade_in.iter().chain(&self.fade_out)
    }
}

/// Refuses amounts and fades that are none, and weights that vanish together between 0 and `duration`.
pub(super) fn check<C, F: Elementary>(layers: &[Layer<C, F>], duration: f64) -> Result<(), ProfileError> {
    let needed = 1;
    if layers.len() < needed {
        return Err(ProfileError::Count { what: "layers", found: layers.len(), needed });
    }
    for layer in layers {
        check_range("amount", layer.amount, Range::NOT_NEGATIVE)?;
        crate::error::check_overflow("amount", &[F::from_f64(layer.amount)])?;
        for fade in layer.fades() {
            fade.leaving(Leaving::Refuse)?;
            fade.check::<F>()?;
        }
    }
    let largest = layers.iter().fold(0.0_f64, |largest, layer| largest.max(layer.amount));
    match weightless(layers, duration, 1e-6 * largest) {
        Some(time) => Err(ProfileError::Weightless { time }),
        None => Ok(()),
    }
}

/// A time at which the sum of the weights is not above `least`, if there is one: halves spans until the sum of the least that
/// each weight may be within is above.
fn weightless<C, F: Elementary>(layers: &[Layer<C, F>], duration: f64, least: f64) -> Option<f64> {
    let mut times: Vec<f64> = layers.iter().flat_map(Layer::fades).flat_map(Fade::breaks).collect();
    times.retain(|&time| time > 0.0 && time < duration);
    times.extend([0.0, duration]);
    times.sort_by(f64::total_cmp);
    let mut spans: Vec<(f64, f64)> = times.windows(2).map(|pair| (pair[0], pair[1])).collect();
    spans.reverse();
    while let Some((from, to)) = spans.pop() {
        let (mut at_from, mut at_to, mut bound) = (0.0, 0.0, 0.0);
        for layer in layers {
            let [fade_in, fade_out] = layer.factors(from, Side::After).map(|jet| jet[0]);
            let [to_in, to_out] = layer.factors(to, Side::Before).map(|jet| jet[0]);
            at_from += layer.amount * fade_in * fade_out;
            at_to += layer.amount * to_in * to_out;
            bound += layer.amount * fade_in.min(to_in) * fade_out.min(to_out);
        }
        if bound > least {
            continue;
        }
        let middle = 0.5 * (from + to);
        if at_from <= least {
            return Some(from);
        } else if at_to <= least || middle <= from || middle >= to {
            return Some(to);
        }
        spans.extend([(middle, to), (from, middle)]);
    }
    None
}

/// The sum of the weights, and the first layer that has one.
#[inline]
pub(super) fn total<C, F: Elementary>(
    layers: &[Layer<C, F>],
    time: f64,
    derivatives: F,
    side: Side,
) -> ([F; 4], Option<&Layer<C, F>>) {
    let zero = constant(F::from_f64(0.0));
    let (mut total, mut first) = (zero, None);
    for layer in layers {
        let weight = layer.weight(time, derivatives, side);
        if weight != zero {
            total = jet::sum(total, weight);
            first = first.or(Some(layer));
        }
    }
    (total, first)
}
