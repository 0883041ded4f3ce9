//! The quintic spline through equally spaced samples.

use crate::Elementary;
use crate::error::{ProfileError, check_duration, check_finite};
use crate::float::{floor, rem_euclid};
use crate::sample::Sample;
use alloc::vec::Vec;

/// Samples on either side that take part in the spline of the middle: its poles are −0.4306 and −0.0431, and
/// 0.4306⁴⁴ < 1e-16.
const REACH: usize = 44;

/// The C⁴ curve of quintic pieces through equally spaced samples, several coordinates at once.
///
/// Beyond its ends it either rests at the first and last sample or repeats. Inside, the error in a smooth curve falls
/// with the sixth power of the step.
#[doc(alias = "b-spline")]
#[doc(alias = "quintic spline")]
#[doc(alias = "spline")]
#[derive(Clone, Debug)]
pub struct UniformSpline<const D: usize> {
    start: f64,
    step: f64,
    period: Option<usize>,
    /// Coefficients of the basis functions, the first belongs to the sample `−REACH`.
    coefficients: Vec<[f64; D]>,
}

impl<const D: usize> UniformSpline<D> {
    /// Through `samples` at `start + i·step`, at rest before the first and after the last.
    ///
    /// # Errors
    ///
    /// A step that is not positive, no samples, numbers that are not finite.
    pub fn resting(start: f64, step: f64, samples: &[[f64; D]]) -> Result<Self, ProfileError> {
        let last = samples.len().saturating_sub(1) as isize;
        Self::new(start, step, samples, None, move |i| i.clamp(0, last) as usize)
    }

    /// Through `samples` at `start + i·step`, repeating after `samples.len()` steps.
    ///
    /// # Errors
    ///
    /// A step that is not positive, no samples, numbers that are not finite.
    #[doc(alias = "cyclic")]
    #[doc(alias = "loop")]
    pub fn periodic(start: f64, step: f64, samples: &[[f64; D]]) -> Result<Self, ProfileError> {
        let count = samples.len();
        Self::new(start, step, samples, Some(count), move |i| i.rem_euclid(count as isize) as usize)
    }

    fn new(
        start: f64,
        step: f64,
        samples: &[[f64; D]],
        period: Option<usize>,
        wrap: impl Fn(isize) -> usize,
    ) -> Result<Self, ProfileError> {
        check_duration(step)?;
        check_finite("start", &[start])?;
        if samples.is_empty() {
            return Err(ProfileError::Count { what: "samples", found: 0, needed: 1 });
        }
        samples.iter().try_for_each(|sample| check_finite("sample", sample))?;
        let reach = REACH as isize;
        let mut coefficients: Vec<[f64; D]> =
            (-reach..samples.len() as isize + reach).map(|i| samples[wrap(i)]).collect();
        // Basis values at the knots are (1, 26, 66, 26, 1)/120: two first-order filters there and back for each pole.
        for pole in [-0.430_575_347_099_973_8, -0.043_096_288_203_264_65] {
            filter(&mut coefficients, pole);
        }
        Ok(Self { start, step, period, coefficients })
    }

    /// All coordinates at `t`: position and its first two derivatives.
    pub fn jet(&self, t: f64) -> [[f64; D]; 3] {
        let (first, w, d1, d2) = self.weights(t);
        let mut out = [[0.0; D]; 3];
        for (k, c) in self.coefficients[first..first + 6].iter().enumerate() {
            for i in 0..D {
                out[0][i] += w[k] * c[i];
                out[1][i] += d1[k] * c[i];
                out[2][i] += d2[k] * c[i];
            }
        }
        out
    }

    /// All coordinates at `t`.
    #[inline]
    pub fn position(&self, t: f64) -> [f64; D] {
        let (first, s) = self.locate(t);
        let w = basis(s);
        let mut out = [0.0; D];
        for (k, c) in self.coefficients[first..first + 6].iter().enumerate() {
            for i in 0..D {
                out[i] += w[k] * c[i];
            }
        }
        out
    }

    /// One coordinate at `t`, with three derivatives.
    pub fn at(&self, coordinate: usize, t: f64) -> Sample {
        let (first, s) = self.locate(t);
        let h = self.step;
        let column =
            |w: [f64; 6]| (0..6).map(|k| w[k] * self.coefficients[first + k][coordinate]).sum::<f64>();
        Sample {
            position: column(basis(s)),
            velocity: column(basis1(s)) / h,
            acceleration: column(basis2(s)) / (h * h),
            jerk: column(basis3(s)) / (h * h * h),
        }
    }

    fn weights(&self, t: f64) -> (usize, [f64; 6], [f64; 6], [f64; 6]) {
        let (first, s) = self.locate(t);
        let h = self.step;
        (first, basis(s), basis1(s).map(|x| x / h), basis2(s).map(|x| x / (h * h)))
    }

    /// First of the six coefficients and the place within the step.
    #[inline]
    fn locate(&self, t: f64) -> (usize, f64) {
        let mut x = (t - self.start) / self.step;
        let samples = self.coefficients.len() - 2 * REACH;
        if let Some(period) = self.period {
            x = rem_euclid(x, period as f64);
        } else {
            // At rest a few steps beyond the ends: the spline itself settles there.
            x = x.clamp(-(REACH as f64) / 2.0, (samples + REACH / 2) as f64);
        }
        let floor = floor(x);
        ((floor as isize + REACH as isize - 2) as usize, x - floor)
    }
}

/// One pole of the interpolation: `c⁺ᵢ = (1 − z)·xᵢ + z·c⁺ᵢ₋₁`, then the same backwards; constants pass unchanged.
fn filter<const D: usize>(values: &mut [[f64; D]], pole: f64) {
    let gain = 1.0 - pole;
    let last = values.len() - 1;
    for i in 1..=last {
        for d in 0..D {
            values[i][d] = gain * values[i][d] + pole * values[i - 1][d];
        }
    }
    for i in (0..last).rev() {
        for d in 0..D {
            values[i][d] = gain * values[i][d] + pole * values[i + 1][d];
        }
    }
}

/// The six quintic B-spline values that are not zero at the place `s` in [0, 1] of a step; they add up to 1.
#[rustfmt::skip]
#[inline]
fn basis(s: f64) -> [f64; 6] {
    let r = 1.0 - s;
    let (s2, r2) = (s * s, r * r);
    let (s4, r4) = (s2 * s2, r2 * r2);
    [
        r * r4 / 120.0,
        (26.0 + s * (-50.0 + s * (20.0 + s * (20.0 + s * (-20.0 + 5.0 * s))))) / 120.0,
        (66.0 + s2 * (-60.0 + s2 * (30.0 - 10.0 * s))) / 120.0,
        (66.0 + r2 * (-60.0 + r2 * (30.0 - 10.0 * r))) / 120.0,
        (26.0 + r * (-50.0 + r * (20.0 + r * (20.0 + r * (-20.0 + 5.0 * r))))) / 120.0,
        s * s4 / 120.0,
    ]
}

#[rustfmt::skip]
fn basis1(s: f64) -> [f64; 6] {
    let r = 1.0 - s;
    let outer = |t: f64| Elementary::powi(t, 4) / 24.0;
    let middle = |t: f64| (-50.0 + t * (40.0 + t * (60.0 + t * (-80.0 + 25.0 * t)))) / 120.0;
    let inner = |t: f64| t * (-120.0 + t * t * (120.0 - 50.0 * t)) / 120.0;
    [-outer(r), middle(s), inner(s), -inner(r), -middle(r), outer(s)]
}

#[rustfmt::skip]
fn basis2(s: f64) -> [f64; 6] {
    let r = 1.0 - s;
    let outer = |t: f64| Elementary::powi(t, 3) / 6.0;
    let middle = |t: f64| (40.0 + t * (120.0 + t * (-240.0 + 100.0 * t))) / 120.0;
    let inner = |t: f64| (-120.0 + t * t * (360.0 - 200.0 * t)) / 120.0;
    [outer(r), middle(s), inner(s), inner(r), middle(r), outer(s)]
}

#[rustfmt::skip]
fn basis3(s: f64) -> [f64; 6] {
    let r = 1.0 - s;
    let outer = |t: f64| t * t / 2.0;
    let middle = |t: f64| (120.0 + t * (-480.0 + 300.0 * t)) / 120.0;
    let inner = |t: f64| t * (720.0 - 600.0 * t) / 120.0;
    [-outer(r), middle(s), inner(s), -inner(r), -middle(r), outer(s)]
}
