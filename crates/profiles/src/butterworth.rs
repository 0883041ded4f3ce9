//! Butterworth low-pass filters without delay.

use crate::{Elementary, Scalar};
use alloc::{vec, vec::Vec};
use core::f64::consts::PI;

/// A digital Butterworth low-pass filter, applied forwards and backwards so that nothing is delayed.
///
/// `order` is that of **one pass**, and so is `cutoff`: each pass halves the power at the cut-off (−3 dB), both together
/// leave half the amplitude (−6 dB), and the whole falls off as one of twice the order. The cut-off is not corrected for
/// the two passes. This is how `OpenSim` (order 3) and `scipy.signal.sosfiltfilt` count.
///
/// The analogue filter is warped so that the cut-off is exact (bilinear transform) and split into sections of second
/// order, which keeps high orders and low cut-offs precise.
///
/// ```
/// use solaris_profiles::Butterworth;
///
/// let filter = Butterworth::low_pass(2, 6.0, 100.0)?;
/// let tremor: Vec<f64> = (0..400).map(|i| (i as f64 * 0.01 * std::f64::consts::TAU * 6.0).cos()).collect();
/// let smooth = filter.zero_phase(&tremor)?;
/// assert!((smooth[200] - 0.5 * tremor[200]).abs() < 1e-6); // half the amplitude at 6 Hz, in phase
/// # Ok::<(), solaris_profiles::FilterError>(())
/// ```
#[doc(alias = "filter")]
#[doc(alias = "low-pass")]
#[doc(alias = "filtfilt")]
#[doc(alias = "iir")]
#[doc(alias = "smoothing")]
#[derive(Clone, Debug)]
pub struct Butterworth {
    order: usize,
    sections: Vec<Section>,
}

/// `y = b₀·x + b₁·x₁ + b₂·x₂ − a₁·y₁ − a₂·y₂`, with gain 1 for what is constant.
#[derive(Clone, Copy, Debug)]
struct Section {
    b: [f64; 3],
    a: [f64; 2],
}

/// The error of a filter: why a signal cannot be filtered.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FilterError {
    /// The order is not one.
    #[error("filter order {order}: it must be 1 to {}", Butterworth::HIGHEST_ORDER)]
    Order {
        /// What was asked.
        order: usize,
    },
    /// The cut-off is not one.
    #[error(
        "cut-off {cutoff} Hz: it must be more than zero and less than half of the {rate} samples/s, {} Hz", .rate / 2.0
    )]
    Cutoff {
        /// What was asked (Hz).
        cutoff: f64,
        /// Samples a second (1/s).
        rate: f64,
    },
    /// There are too few samples.
    #[error(
        "{samples} samples are too few for a filter of order {order}; it needs {needed}: leave the filter out"
    )]
    TooShort {
        /// How many there are.
        samples: usize,
        /// Order of a pass.
        order: usize,
        /// How many there must be.
        needed: usize,
    },
    /// The samples are not equally spaced.
    #[error(
        "sample {sample} at {time} s is {off} s off the equal spacing of {step} s that a filter needs (it may be off by {} % \
         of a step): resample the record, or leave the filter out", 100.0 * Butterworth::SPACING_TOLERANCE
    )]
    Spacing {
        /// Index of the sample.
        sample: usize,
        /// When (s).
        time: f64,
        /// How far it is from where it should be (s).
        off: f64,
        /// The mean step (s).
        step: f64,
    },
    /// A number is not finite.
    #[error("sample {sample} is {value}; it must be a finite number")]
    NotFinite {
        /// Index of the sample.
        sample: usize,
        /// The number.
        value: f64,
    },
}

impl Butterworth {
    /// The highest order of a pass.
    pub const HIGHEST_ORDER: usize = 10;

    /// How far a sample may be from equal spacing, over the mean step.
    pub const SPACING_TOLERANCE: f64 = 0.01;

    /// A filter whose single pass has `order` poles and half the power at `cutoff` (Hz), for `rate` samples a second.
    ///
    /// ```text
    /// K = tan(π·cutoff/rate)      H(s) = 1/∏(s² + 2 sin(π(2k−1)/2N)·s + 1)      s = (1 − z⁻¹)/(1 + z⁻¹)/K
    /// ```
    ///
    /// # Errors
    ///
    /// An order that is not 1 to 10, a cut-off that is not between zero and half the rate.
    #[doc(alias = "butter")]
    pub fn low_pass(order: usize, cutoff: f64, rate: f64) -> Result<Self, FilterError> {
        if !(1..=Self::HIGHEST_ORDER).contains(&order) {
            return Err(FilterError::Order { order });
        }
        if !(rate.is_finite() && cutoff > 0.0 && cutoff < rate / 2.0) {
            return Err(FilterError::Cutoff { cutoff, rate });
        }
        let (sine, cosine) = Scalar::sin_cos(PI * cutoff / rate);
        let k = sine / cosine;
        let mut sections = Vec::with_capacity(order.div_ceil(2));
        if order % 2 == 1 {
            let b = k / (1.0 + k);
            sections.push(Section { b: [b, b, 0.0], a: [(k - 1.0) / (k + 1.0), 0.0] });
        }
        for pair in 1..=order / 2 {
            let damping = 2.0 * Elementary::sin(PI * (2 * pair - 1) as f64 / (2 * order) as f64);
            let scale = 1.0 + k * damping + k * k;
            let b = k * k / scale;
            let a = [2.0 * (k * k - 1.0) / scale, (1.0 - k * damping + k * k) / scale];
            sections.push(Section { b: [b, 2.0 * b, b], a });
        }
        Ok(Self { order, sections })
    }

    /// The rate (1/s) of samples at these times (s), which must be equally spaced.
    ///
    /// # Errors
    ///
    /// Fewer than two samples; one that is off by more than [`Butterworth::SPACING_TOLERANCE`] of the mean step.
    pub fn rate_of(time: &[f64]) -> Result<f64, FilterError> {
        let [first, .., last] = time else {
            return Err(FilterError::TooShort { samples: time.len(), order: 1, needed: 2 });
        };
        let step = (last - first) / (time.len() - 1) as f64;
        for (sample, &time) in time.iter().enumerate() {
            let off = time - (first + sample as f64 * step);
            if !(step > 0.0 && off.abs() <= Self::SPACING_TOLERANCE * step) {
                return Err(FilterError::Spacing { sample, time, off, step });
            }
        }
        Ok(1.0 / step)
    }

    /// Poles of one pass.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The fewest samples that [`zero_phase`](Self::zero_phase) takes: three for each pole of a pass and four more.
    pub fn fewest(&self) -> usize {
        3 * (self.order + 1) + 1
    }

    /// The filtered `values`, forwards and backwards.
    ///
    /// Before the first and after the last sample the signal is taken to go on, turned about the end by half a turn: `x₋ₖ
    /// = 2 x₀ − xₖ` for `3 (order + 1)` samples; each pass starts in the steady state of its first sample. A constant
    /// passes to the bit, a straight line to rounding once the filter has settled.
    ///
    /// # Errors
    ///
    /// Fewer than [`fewest`](Self::fewest) samples, numbers that are not finite.
    #[doc(alias = "filtfilt")]
    #[doc(alias = "dual pass")]
    pub fn zero_phase(&self, values: &[f64]) -> Result<Vec<f64>, FilterError> {
        let (samples, needed, order) = (values.len(), self.fewest(), self.order);
        if samples < needed {
            return Err(FilterError::TooShort { samples, order, needed });
        }
        if let Some((sample, &value)) = values.iter().enumerate().find(|(_, value)| !value.is_finite()) {
            return Err(FilterError::NotFinite { sample, value });
        }
        let pad = needed - 1;
        let mut signal = odd_extension(values, pad);
        self.pass(&mut signal);
        signal.reverse();
        self.pass(&mut signal);
        signal.reverse();
        Ok(signal[pad..pad + samples].to_vec())
    }

    /// Samples that pass until the response to an impulse stays below 1 % of its peak, in one pass: so far into the
    /// record the filter is still filled with what was guessed beyond the end. At most `most`.
    pub fn settling(&self, most: usize) -> usize {
        let (mut states, mut peak) = (vec![[0.0; 2]; self.sections.len()], 0.0_f64);
        let mut settled = 0;
        for sample in 0..most {
            let mut x = if sample == 0 { 1.0 } else { 0.0 };
            for (section, state) in self.sections.iter().zip(&mut states) {
                x = section.step(state, x);
            }
            peak = peak.max(x.abs());
            if x.abs() >= 0.01 * peak {
                settled = sample + 1;
            } else if sample > 8 * (settled + self.order) {
                break;
            }
        }
        settled
    }

    /// One pass in the steady state of the first value: what differs from it, from rest.
    fn pass(&self, values: &mut [f64]) {
        let first = values[0];
        for section in &self.sections {
            let mut state = [0.0; 2];
            for value in values.iter_mut() {
                *value = first + section.step(&mut state, *value - first);
            }
        }
    }
}

impl Section {
    /// The next output, in the transposed direct form.
    #[inline]
    fn step(&self, state: &mut [f64; 2], x: f64) -> f64 {
        let y = self.b[0] * x + state[0];
        state[0] = self.b[1] * x - self.a[0] * y + state[1];
        state[1] = self.b[2] * x - self.a[1] * y;
        y
    }
}

/// `values` with `pad` more on either side, turned about the ends by half a turn: value and slope go on.
///
/// ```text
/// x₋ₖ = 2 x₀ − xₖ        x₍ₙ₋₁₊ₖ₎ = 2 xₙ₋₁ − xₙ₋₁₋ₖ
/// ```
///
/// At most `values.len() − 1` are there to be turned; no more are added.
#[doc(alias = "padding")]
#[doc(alias = "reflect")]
pub fn odd_extension(values: &[f64], pad: usize) -> Vec<f64> {
    let [first, .., last] = values else { return values.to_vec() };
    let pad = pad.min(values.len() - 1);
    let before = values[1..=pad].iter().rev().map(|x| 2.0 * first - x);
    let after = values[values.len() - 1 - pad..values.len() - 1].iter().rev().map(|x| 2.0 * last - x);
    before.chain(values.iter().copied()).chain(after).collect()
}
