//! The questions about a whole curve: stationary points, peaks, ranges.

use crate::curve::Curve;
use crate::sample::Sample;
use alloc::boxed::Box;
use alloc::vec::Vec;

/// One of the four functions of time that a curve gives: position, velocity, acceleration, jerk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The position.
    Position,
    /// Its first derivative.
    Velocity,
    /// Its second derivative.
    Acceleration,
    /// Its third derivative.
    Jerk,
}

impl Quantity {
    /// Its value in a sample.
    pub fn of(self, sample: &Sample) -> f64 {
        match self {
            Self::Position => sample.position,
            Self::Velocity => sample.velocity,
            Self::Acceleration => sample.acceleration,
            Self::Jerk => sample.jerk,
        }
    }
}

/// The behaviour of a curve where its velocity is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// The velocity changes its sign: the motion turns round.
    Reversal,
    /// The velocity touches zero and keeps its sign.
    Touch,
}

/// A time at which the velocity is zero, or jumps from one sign to the other.
#[doc(alias = "extremum")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StationaryPoint {
    /// Since the curve's beginning.
    pub time: f64,
    /// Whether the motion turns round there.
    pub turn: Turn,
}

/// The times inside of its open span at which a curve stands still.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stationary {
    /// The instants, rising.
    pub points: Vec<StationaryPoint>,
    /// The spans over which it rests, rising: the whole curve where start and end are the same and nothing moves, or a
    /// piece of a spline between equal keys.
    pub rests: Vec<(f64, f64)>,
}

impl Stationary {
    /// Nowhere.
    pub const NONE: Self = Self { points: Vec::new(), rests: Vec::new() };

    /// All the time.
    pub fn everywhere(duration: f64) -> Self {
        Self { points: Vec::new(), rests: alloc::vec![(0.0, duration)] }
    }

    /// At these instants, those outside of the open span left out.
    pub fn at(points: impl IntoIterator<Item = (f64, Turn)>, duration: f64) -> Self {
        let inside = |&(time, _): &(f64, Turn)| time > 0.0 && time < duration;
        let mut points: Vec<StationaryPoint> =
            points.into_iter().filter(inside).map(|(time, turn)| StationaryPoint { time, turn }).collect();
        points.sort_by(|a, b| a.time.total_cmp(&b.time));
        Self { points, rests: Vec::new() }
    }
}

/// The greatest magnitude of a quantity, and when it is reached.
#[doc(alias = "maximum")]
#[doc(alias = "extremum")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Since the curve's beginning; the first such time.
    pub time: f64,
    /// The magnitude; infinite where it grows without bound.
    pub value: f64,
}

/// The greatest magnitudes of velocity, acceleration and jerk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peaks {
    /// Of |velocity|.
    pub velocity: Peak,
    /// Of |acceleration|.
    pub acceleration: Peak,
    /// Of |jerk|.
    pub jerk: Peak,
}

/// Exact answers about a whole curve, in double precision.
#[doc(alias = "extrema")]
#[doc(alias = "analysis")]
pub trait Answers: Curve<f64> {
    /// Where the velocity is zero, ends excluded: none missing, none extra, times right to 2e-12 of the duration where the
    /// velocity crosses zero.
    fn stationary(&self) -> Stationary;

    /// Times inside of the span among which are all where `quantity` is greatest or smallest, other than the ends: where
    /// its derivative is zero, and where it jumps. More times than needed do no harm. Two of them come from
    /// a search and are not proven: those of a blend's jerk, and of the velocity, acceleration and jerk of the
    /// [`legacy`](crate::legacy) curve.
    fn critical(&self, quantity: Quantity) -> Vec<f64>;

    /// Times inside of the span between which position, velocity, acceleration and jerk each only rise or only fall, and nothing
    /// jumps, as far as [`Self::critical`] knows: what a blend of this curve asks. All four at once, which a blend of blends finds in
    /// one go.
    fn breaks(&self) -> Vec<f64> {
        let all = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk];
        all.into_iter().flat_map(|quantity| self.critical(quantity)).collect()
    }

    /// The least and the greatest value of `quantity` between two times of the span.
    fn range(&self, quantity: Quantity, from: f64, to: f64) -> (f64, f64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut take = |sample: &Sample| {
            let x = quantity.of(sample);
            (low, high) = (low.min(x), high.max(x));
        };
        take(&self.at(from));
        take(&self.before(to));
        for t in self.critical(quantity).into_iter().filter(|&t| t > from && t < to) {
            take(&self.at(t));
            take(&self.before(t));
        }
        (low, high)
    }

    /// Where |velocity|, |acceleration| and |jerk| are greatest.
    fn peaks(&self) -> Peaks {
        let peak = |quantity| {
            let mut times = self.critical(quantity);
            times.extend([0.0, self.duration()]);
            times.sort_by(f64::total_cmp);
            let mut peak = Peak { time: 0.0, value: -1.0 };
            for time in times {
                let (before, after) =
                    (quantity.of(&self.before(time)).abs(), quantity.of(&self.at(time)).abs());
                if before.max(after) > peak.value {
                    peak = Peak { time, value: before.max(after) };
                }
            }
            peak
        };
        Peaks {
            velocity: peak(Quantity::Velocity),
            acceleration: peak(Quantity::Acceleration),
            jerk: peak(Quantity::Jerk),
        }
    }

    /// Whether the motion never turns round: it may touch standstill and rest.
    fn is_monotone(&self) -> bool {
        self.stationary().points.iter().all(|point| point.turn == Turn::Touch)
    }
}

macro_rules! through {
    ($pointer:ty) => {
        impl<C: Answers + ?Sized> Answers for $pointer {
            fn stationary(&self) -> Stationary {
                (**self).stationary()
            }

            fn critical(&self, quantity: Quantity) -> Vec<f64> {
                (**self).critical(quantity)
            }

            fn breaks(&self) -> Vec<f64> {
                (**self).breaks()
            }

            fn range(&self, quantity: Quantity, from: f64, to: f64) -> (f64, f64) {
                (**self).range(quantity, from, to)
            }

            fn peaks(&self) -> Peaks {
                (**self).peaks()
            }

            fn is_monotone(&self) -> bool {
                (**self).is_monotone()
            }
        }
    };
}

through!(&C);
through!(Box<C>);
