//! Clips: curves with a start in time, and a policy outside of their span.

use crate::Elementary;
use crate::blend::Side;
use crate::curve::Curve;
use crate::error::{ProfileError, check_finite};
use crate::float::{floor, rem_euclid};
use crate::sample::Sample;
use core::marker::PhantomData;

/// The policy of a curve outside of its span.
#[doc(alias = "extrapolation")]
#[doc(alias = "wrap mode")]
#[doc(alias = "loop")]
#[doc(alias = "clamp")]
#[doc(alias = "ping-pong")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Outside {
    /// Holds the value at the end, at rest.
    #[default]
    Hold,
    /// Goes on: as its own formula where it is a polynomial, else with the velocity of its end.
    Extrapolate,
    /// Repeats, with the span as its period.
    Repeat,
    /// Goes back and forth.
    Mirror,
}

/// A curve that begins at a time and is defined at all times.
///
/// Times are in double precision, whatever the curve is computed in, and the beginning is subtracted before anything is
/// rounded: a curve in f32 loses nothing an hour into a clip.
#[doc(alias = "animation clip")]
#[doc(alias = "time warp")]
#[doc(alias = "loop")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip<C, F = f64> {
    curve: C,
    start: f64,
    outside: Outside,
    scalar: PhantomData<F>,
}

impl<C: Curve<F>, F: Elementary> Clip<C, F> {
    /// The curve, beginning at time 0, holding its ends.
    pub fn new(curve: C) -> Self {
        Self { curve, start: 0.0, outside: Outside::Hold, scalar: PhantomData }
    }

    /// Beginning at a time that is known to be finite.
    pub(crate) fn at_start(curve: C, start: f64) -> Self {
        Self { curve, start, outside: Outside::Hold, scalar: PhantomData }
    }

    /// The same, beginning at `start`.
    ///
    /// # Errors
    ///
    /// A time that is not finite.
    pub fn starting(self, start: f64) -> Result<Self, ProfileError> {
        check_finite("start", &[start])?;
        Ok(Self { start, ..self })
    }

    /// The same, with another way to go on outside of its span.
    pub fn outside(self, outside: Outside) -> Self {
        Self { outside, ..self }
    }

    /// The curve.
    pub fn curve(&self) -> &C {
        &self.curve
    }

    /// When it begins.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// When it ends.
    pub fn end(&self) -> f64 {
        self.start + self.curve.span()
    }

    /// What it does outside of its span.
    pub fn policy(&self) -> Outside {
        self.outside
    }

    /// Position, velocity, acceleration and jerk at any time; a time that is not finite gives NaN.
    pub fn at(&self, time: f64) -> Sample<F> {
        let duration = self.curve.span();
        let t = time - self.start;
        if (0.0..=duration).contains(&t) {
            return self.curve.at_time(t);
        }
        if !t.is_finite() {
            return Sample::from_array([F::from_f64(f64::NAN); 4]);
        }
        match self.outside {
            Outside::Hold => Sample::rest(self.curve.at_time(t).position),
            Outside::Extrapolate => self.curve.extrapolated(F::from_f64(t)),
            // Nothing to repeat.
            _ if duration <= 0.0 => self.curve.at_time(0.0),
            Outside::Repeat => self.curve.at_time(rem_euclid(t, duration)),
            Outside::Mirror => {
                let rest = rem_euclid(t, 2.0 * duration);
                if rest <= duration {
                    self.curve.at_time(rest)
                } else {
                    self.curve.at_time(2.0 * duration - rest).reversed()
                }
            }
        }
    }

    /// The same on one side of a time at which something may jump, the beginning and the end among them. The time may have
    /// derivatives, of which `derivatives` is the number without its value.
    pub(crate) fn sided(&self, time: f64, derivatives: F, side: Side) -> Sample<F> {
        let duration = self.curve.span();
        let t = time - self.start;
        let inside = match side {
            Side::After => t >= 0.0 && t < duration,
            Side::Before => t > 0.0 && t <= duration,
        };
        // A time that is a whole number of periods but for rounding is one.
        let nearest = floor(t / duration + 0.5);
        let at_turn = (t - nearest * duration).abs() <= 4.0 * f64::EPSILON * (t.abs() + self.start.abs());
        let repeats = matches!(self.outside, Outside::Repeat | Outside::Mirror);
        if inside && !(repeats && at_turn) {
            return self.within(t, derivatives, side);
        }
        if !t.is_finite() {
            return Sample::from_array([F::from_f64(f64::NAN); 4]);
        }
        match self.outside {
            Outside::Hold => Sample::rest(self.curve.at_time(t).position),
            Outside::Extrapolate => {
                // Beyond the end, though by as little as can be.
                let t = if t <= 0.0 { t.next_down() } else { t.next_up() };
                self.curve.extrapolated(F::from_f64(t) + derivatives)
            }
            _ if duration <= 0.0 => self.curve.at_time(0.0),
            Outside::Repeat | Outside::Mirror => {
                let turns = match side {
                    _ if !at_turn => floor(t / duration),
                    Side::After => nearest,
                    Side::Before => nearest - 1.0,
                };
                let rest = match side {
                    _ if !at_turn => rem_euclid(t, duration),
                    Side::After => 0.0,
                    Side::Before => duration,
                };
                if self.outside == Outside::Repeat || turns % 2.0 == 0.0 {
                    return self.within(rest, derivatives, side);
                }
                let side = if side == Side::After { Side::Before } else { Side::After };
                self.within(duration - rest, -derivatives, side).reversed()
            }
        }
    }

    fn within(&self, t: f64, derivatives: F, side: Side) -> Sample<F> {
        match side {
            Side::Before => self.curve.before(F::from_f64(t) + derivatives),
            Side::After if F::EPSILON > f64::EPSILON => self.curve.at_time(t),
            Side::After => self.curve.at(F::from_f64(t) + derivatives),
        }
    }
}
