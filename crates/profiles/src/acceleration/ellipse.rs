//! The curve whose acceleration follows an ellipse.

use super::{check, constant_to, feasible};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_overflow};
use crate::range::Ranges;
use crate::roots::bracketed;
use crate::sample::Sample;
use crate::segment::{ellipse, segment};
use alloc::vec::Vec;
use core::f64::consts::{FRAC_PI_2, PI};

/// A motion whose acceleration, drawn over time, is a quarter or a half of an ellipse.
///
/// ```text
/// x = x₀ + v₀·t + (âB²/2)·(sin p − p·cos p − sin³p/3)        a = â·√(w·(2 − w)) = â·sin p
/// v = v₀ + (âB/2)·(p − sin p·cos p)                          j = (â/B)·cot p
/// w = t/B,  p = arccos(1 − w) = 2 asin √(w/2)
/// ```
///
/// The quarter has B = T and â = 2aₘ/√3, where aₘ is the acceleration at half time: it rises from 0 to its greatest at
/// the end. The half has B = T/2 and â = aₘ, its greatest, at half time, and is 0 at both ends. The jerk is infinite
/// where an ellipse begins or ends with a vertical tangent: at the start, and at the end of the half.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.4.3, describes the half; A.2.3 has the quarter (E13), with wrong signs in velocity and
/// displacement and a wrong constant (E11, E12). Here the angle p replaces the arc sine that loses its digits near the
/// start, and the brackets are series where their terms cancel.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, acceleration::Ellipse};
///
/// let half = Ellipse::half(2.0, (0.0, 0.0), 1.0)?;
/// assert_eq!(half.at(1.0).acceleration, 1.0);
/// assert!((half.at(2.0).velocity - std::f64::consts::FRAC_PI_2).abs() < 1e-15); // the ellipse's area
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse<F = f64> {
    duration: F,
    from: F,
    start_velocity: F,
    /// B, the half axis along time.
    base: F,
    /// â, the half axis along acceleration.
    peak: F,
    /// âB²/2
    reach: F,
    /// âB/2
    gain: F,
    /// â/B
    jerk: F,
    /// p at the end: π/2 or π.
    angle: f64,
}

impl<F: Elementary> Ellipse<F> {
    /// Over `duration`, from position `from` with velocity `v0`; `middle` is the acceleration at half time, of either
    /// sign. The greatest, at the end, is 2/√3 of it.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or lead to such.
    pub fn quarter(duration: F, (from, v0): (F, F), middle: F) -> Result<Self, ProfileError> {
        check(duration, (from, v0), "middle acceleration", middle)?;
        Self::new(duration, (from, v0), duration, middle * F::from_f64(QUARTER_PEAK), FRAC_PI_2)
    }

    /// Over `duration`, from position `from` with velocity `v0`; `peak` is the acceleration at half time, of either
    /// sign.
    ///
    /// # Errors
    ///
    /// As [`quarter`](Self::quarter).
    pub fn half(duration: F, (from, v0): (F, F), peak: F) -> Result<Self, ProfileError> {
        check(duration, (from, v0), "peak acceleration", peak)?;
        Self::new(duration, (from, v0), F::from_f64(0.5) * duration, peak, PI)
    }

    /// The quarter whose acceleration leads to `to`: aₘ = (3√3/2)·(D − v₀·T)/T².
    ///
    /// # Errors
    ///
    /// As [`quarter`](Self::quarter).
    pub fn quarter_reaching(duration: F, (from, v0): (F, F), to: F) -> Result<Self, ProfileError> {
        // 3√3/4, written through the peak 2aₘ/√3 of the quarter.
        let middle = constant_to(duration, (from, v0), to)? * F::from_f64(1.5 / QUARTER_PEAK);
        Self::quarter(duration, (from, v0), middle)
    }

    /// The half whose acceleration leads to `to`: aₘ = (8/π)·(D − v₀·T)/T².
    ///
    /// # Errors
    ///
    /// As [`quarter`](Self::quarter).
    pub fn half_reaching(duration: F, (from, v0): (F, F), to: F) -> Result<Self, ProfileError> {
        let peak = constant_to(duration, (from, v0), to)? * F::from_f64(4.0 / PI);
        Self::half(duration, (from, v0), peak)
    }

    /// The greatest acceleration: at the end of the quarter, at half time of the half.
    pub fn peak_acceleration(&self) -> F {
        self.peak
    }

    fn new(duration: F, (from, v0): (F, F), base: F, peak: F, angle: f64) -> Result<Self, ProfileError> {
        let jerk = peak / base;
        check_overflow("jerk", &[jerk])?;
        let gain = F::from_f64(0.5) * peak * base;
        Ok(Self { duration, from, start_velocity: v0, base, peak, reach: gain * base, gain, jerk, angle })
    }
}

impl Ellipse {
    /// The start velocities with which the quarter never turns round: all but those strictly between −πaₘT/(2√3) and 0.
    ///
    /// # Errors
    ///
    /// As [`quarter`](Self::quarter).
    pub fn quarter_feasible_start_velocity(duration: f64, middle: f64) -> Result<Ranges, ProfileError> {
        feasible(duration, "middle acceleration", middle, PI / 4.0 * QUARTER_PEAK * middle * duration)
    }

    /// The start velocities with which the half never turns round: all but those strictly between −πaₘT/4 and 0.
    ///
    /// # Errors
    ///
    /// As [`quarter`](Self::quarter).
    pub fn half_feasible_start_velocity(duration: f64, peak: f64) -> Result<Ranges, ProfileError> {
        feasible(duration, "peak acceleration", peak, PI / 4.0 * peak * duration)
    }
}

impl<F: Elementary> Curve<F> for Ellipse<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        let (one, two) = (F::from_f64(1.0), F::from_f64(2.0));
        // Beyond the top, by the angle that is left to the other end of the ellipse.
        let falling = t.value() > self.base.value();
        let w = (if falling { two * self.base - t } else { t }) / self.base;
        let (sine, cosine) = (root(w * (two - w)), one - w);
        let p = two * root(w / two).asin();
        let (bow, way) = (segment(two * p, two * sine * cosine) / two, ellipse(p, (sine, cosine)));
        let half_turn = F::from_f64(PI);
        let (bow, way, slope) =
            if falling { (half_turn - bow, half_turn * cosine + way, -cosine) } else { (bow, way, cosine) };
        // 0·∞ where there is no acceleration at all.
        let jerk = if self.jerk.value().abs() > 0.0 { self.jerk * (slope / sine) } else { self.jerk * w };
        Sample {
            position: self.from + t * self.start_velocity + self.reach * way,
            velocity: self.start_velocity + self.gain * bow,
            acceleration: self.peak * sine,
            jerk,
        }
    }
}

impl Answers for Ellipse {
    /// p − sin p·cos p = −2v₀/(âB), whose left side rises with p.
    fn stationary(&self) -> Stationary {
        let (v0, gain) = (self.start_velocity, self.gain);
        if v0.abs().max(gain.abs()) <= 0.0 {
            return Stationary::everywhere(self.duration);
        }
        // The velocity is zero where the bow is this, or this less than at the other end of the ellipse.
        let (bow, rest) = (-v0 / gain, (v0 + gain * PI) / gain);
        let end = if self.angle < PI { FRAC_PI_2 } else { PI };
        if !(bow > 0.0 && bow < end) {
            return Stationary::NONE;
        }
        let angle = |bow: f64| {
            let missing =
                |p: f64| 0.5 * segment(2.0 * p, 2.0 * Elementary::sin(p) * Elementary::cos(p)) - bow;
            bracketed(missing, 0.0, FRAC_PI_2)
        };
        // 1 − cos p = 2 sin²(p/2)
        let time = |p: f64| 2.0 * self.base * Elementary::powi(Elementary::sin(0.5 * p), 2);
        let time = if bow <= FRAC_PI_2 { time(angle(bow)) } else { self.duration - time(angle(rest)) };
        Stationary::at([(time, Turn::Reversal)], self.duration)
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => self.stationary().points.iter().map(|point| point.time).collect(),
            Quantity::Acceleration => alloc::vec![self.base],
            Quantity::Velocity | Quantity::Jerk => Vec::new(),
        }
    }
}

/// 2/√3: the greatest acceleration of the quarter in terms of that at half time.
const QUARTER_PEAK: f64 = 1.154_700_538_379_251_5;

/// √x, with no derivative at 0, where it is infinite: a number that does not move there keeps its derivatives by
/// others.
fn root<F: Elementary>(x: F) -> F {
    if x.value().abs() > 0.0 || x.value().is_nan() { x.sqrt() } else { F::from_f64(0.0) }
}
