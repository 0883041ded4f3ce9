//! A curve several times, one after the other.

use super::{check_times, laps};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, StationaryPoint, Turn};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_overflow, check_range};
use crate::range::Range;
use crate::sample::Sample;
use alloc::vec::Vec;

/// A curve several times, each from its own beginning: where it does not end as it begins, it jumps.
///
/// ```
/// use solaris_profiles::{Curve, Quintic, cyclic::Repeat};
///
/// let twice = Repeat::new(Quintic::minimum_jerk(2.0, 0.0, 1.0)?, 2)?;
/// assert_eq!(twice.duration(), 4.0);
/// assert!((twice.at(3.0).position - 0.5_f64).abs() < 1e-15);
/// // At the joint what holds after it; before it the end of the first.
/// assert_eq!((twice.at(2.0).position, twice.before(2.0).position), (0.0, 1.0));
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "loop")]
#[doc(alias = "periodic")]
#[derive(Clone, Debug, PartialEq)]
pub struct Repeat<C> {
    curve: C,
    times: u32,
    /// Of the curve (s).
    period: f64,
}

impl<C> Repeat<C> {
    /// `curve` so many times.
    ///
    /// # Errors
    ///
    /// A number of times that is not 1 to 1e6, and a curve that takes no time.
    pub fn new<F: Elementary>(curve: C, times: u32) -> Result<Self, ProfileError>
    where
        C: Curve<F>,
    {
        check_times("times", f64::from(times), 1.0)?;
        let period = curve.span();
        check_range("duration", period, Range::POSITIVE)?;
        check_overflow("duration", &[period * f64::from(times)])?;
        Ok(Self { curve, times, period })
    }

    /// Which time around it is at `t`, the time since that one began, and whether it is a joint.
    fn lap(&self, t: f64) -> (f64, f64, bool) {
        let (whole, rest, is_joint) = laps(t, self.period);
        let last = f64::from(self.times - 1);
        if whole > last { (last, self.period, false) } else { (whole, rest, is_joint && whole > 0.0) }
    }

    /// The joints, inside.
    fn joints(&self) -> impl Iterator<Item = f64> {
        (1..self.times).map(|k| f64::from(k) * self.period)
    }
}

impl<F: Elementary, C: Curve<F>> Curve<F> for Repeat<C> {
    fn duration(&self) -> F {
        F::from_f64(self.span())
    }

    fn span(&self) -> f64 {
        f64::from(self.times) * self.period
    }

    fn at(&self, t: F) -> Sample<F> {
        if t.value().is_nan() {
            return self.curve.at(t);
        }
        let t = within(t, F::from_f64(f64::from(self.times) * self.period));
        let (lap, rest, is_joint) = self.lap(t.value());
        // With what derivatives the time has.
        let local = t - F::from_f64(lap * self.period);
        self.curve.at(if is_joint || rest >= self.period { F::from_f64(rest) } else { local })
    }

    fn before(&self, t: F) -> Sample<F> {
        let (_, rest, is_joint) = self.lap(t.value());
        self.curve.before(F::from_f64(if is_joint { self.period } else { rest }))
    }
}

impl<C: Answers> Repeat<C> {
    /// Times of the curve, in each of its laps.
    fn each<'a>(&'a self, times: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        (0..self.times).flat_map(move |k| times.iter().map(move |t| f64::from(k) * self.period + t))
    }

    /// Times of the curve in each of its laps, and the joints, rising.
    fn every(&self, own: &[f64]) -> Vec<f64> {
        let mut times: Vec<f64> = self.each(own).chain(self.joints()).collect();
        times.sort_by(f64::total_cmp);
        times
    }

    /// What the motion does at a joint, if it stands still there.
    fn turn(&self) -> Option<Turn> {
        let (before, after) = (self.curve.before(self.period), self.curve.at(0.0));
        // Where it comes to rest, it came from where it is slowed down to.
        let side = |velocity: f64, towards: f64| if velocity == 0.0 { towards } else { velocity };
        let (came, goes) =
            (side(before.velocity, -before.acceleration), side(after.velocity, after.acceleration));
        match () {
            () if came * goes < 0.0 => Some(Turn::Reversal),
            () if before.velocity == 0.0 || after.velocity == 0.0 => Some(Turn::Touch),
            () => None,
        }
    }
}

impl<C: Answers> Answers for Repeat<C> {
    fn stationary(&self) -> Stationary {
        let own = self.curve.stationary();
        let laps = (0..self.times).map(|k| f64::from(k) * self.period);
        let rests = laps.clone().flat_map(|start| own.rests.iter().map(move |(a, b)| (start + a, start + b)));
        let inside = laps.flat_map(|start| {
            own.points.iter().map(move |point| StationaryPoint { time: start + point.time, ..*point })
        });
        let mut points: Vec<StationaryPoint> = inside.collect();
        if own.rests.is_empty()
            && let Some(turn) = self.turn()
        {
            points.extend(self.joints().map(|time| StationaryPoint { time, turn }));
        }
        points.sort_by(|a, b| a.time.total_cmp(&b.time));
        Stationary { rests: rests.collect(), points }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        self.every(&self.curve.critical(quantity))
    }

    fn breaks(&self) -> Vec<f64> {
        self.every(&self.curve.breaks())
    }
}
