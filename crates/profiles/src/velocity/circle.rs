//! The curve whose velocity follows an arc of a circle.

mod arc;

use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_duration, check_finite, check_overflow, check_range};
use crate::range::{Range, Ranges};
use crate::roots::bracketed;
use crate::sample::Sample;
use alloc::vec::Vec;
use arc::Arc;
use core::ops::Bound::Excluded;

/// A motion whose velocity, drawn over time, is an arc of a circle through three points, or a straight line where they
/// are on one.
///
/// ```text
/// v = v₀ + Δv·u + z        z = 2ν·u(1 − u)·P/(b + R)        b = T + ν·Δv·(2u − 1)
/// a = (Δv + ν·(P(1 − 2u) − 2Δv·z)/R)/T                      R = √(b² + 4ν²·u(1 − u)·P)
/// x = x₀ + (v₀ + v)·t/2 + c²·(2q − sin 2q)/(8 sin²q)        c = |chord from the start|
/// u = t/T,  Δv = v₁ − v₀,  P = T² + Δv²
/// ```
///
/// ν is the tangent of half the arc's central angle, 0 for the line, and positive where the velocity is above the
/// chord; q is half the central angle of the arc so far. The arc must be part of one semicircle above or below its
/// centre, or the velocity would not be a function of time: |ν·Δv| ≤ T. Where |ν·Δv| = T the arc begins or ends with a
/// vertical tangent, and the acceleration is infinite there.
///
/// What is a circle depends on the units: numbers of time and of velocity are laid off on axes of the same scale.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.5.2 and A.3.2, which computes centre and radius: printed with vₘ − v₀ in the place of
/// vₘ² − v₀² (E14), with a wrong acceleration (E15) and displacement (E16), and useless near a straight line, where the
/// radius is infinite. Here the arc is measured from its chord. The thesis finds one third time for its example; there
/// are two ranges with the line between them (E17), which [`feasible_third_time`](Self::feasible_third_time) gives.
/// Velocity and displacement may have stationary points (E25).
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, velocity::Circle};
///
/// let curve = Circle::new(1.0_f64, 0.0, (1.0, 3.0), (0.4, 2.0))?;
/// assert!((curve.at(0.4).velocity - 2.0).abs() < 1e-15);
/// let times = Circle::feasible_third_time(1.0, (1.0, 3.0), 2.0)?;
/// assert!(times.contains(0.3) && !times.contains(0.2));
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle<F = f64> {
    duration: F,
    from: F,
    start_velocity: F,
    /// Δv
    rise: F,
    arc: Arc<F>,
}

impl<F: Elementary> Circle<F> {
    /// Over `duration`, from position `from`, with velocity `v0` at the start, `third_velocity` at `third_time`, and
    /// `v1` at the end.
    ///
    /// # Errors
    ///
    /// A duration that is not positive; a third time that is not inside of it; a third velocity to which no such arc
    /// leads, with those to which one does; numbers that are not finite or lead to such.
    pub fn new(
        duration: F,
        from: F,
        (v0, v1): (F, F),
        (third_time, third_velocity): (F, F),
    ) -> Result<Self, ProfileError> {
        check(duration, (v0, v1))?;
        check_finite("from", &[from])?;
        check_range("third time", third_time, inside(duration.value()))?;
        check_finite("third velocity", &[third_velocity])?;
        let rise = v1 - v0;
        let arc = Arc::new(duration, (v0, v1), (third_time, third_velocity)).ok_or_else(|| {
            let velocities = (v0.value(), v1.value());
            ProfileError::Infeasible {
                what: "third velocity",
                value: third_velocity.value(),
                why: "no arc of one semicircle leads there",
                feasible: arc::third_velocity(duration.value(), velocities, third_time.value()),
            }
        })?;
        // The arc stays within half its diameter of its chord.
        let most = v0.abs() + v1.abs() + arc.chord();
        check_overflow("position", &[from.abs() + most * duration])?;
        check_overflow("arc", &arc.numbers())?;
        Ok(Self { duration, from, start_velocity: v0, rise, arc })
    }
}

impl Circle {
    /// The third velocities for which there is such an arc at the third time, a single range about the chord.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn feasible_third_velocity(
        duration: f64,
        (v0, v1): (f64, f64),
        third_time: f64,
    ) -> Result<Ranges, ProfileError> {
        check(duration, (v0, v1))?;
        check_range("third time", third_time, inside(duration))?;
        Ok(arc::third_velocity(duration, (v0, v1), third_time))
    }

    /// The third times at which an arc can have the third velocity: a single range, on either side of the time at which
    /// the straight line has it, where it has it at all; possibly none.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn feasible_third_time(
        duration: f64,
        (v0, v1): (f64, f64),
        third_velocity: f64,
    ) -> Result<Ranges, ProfileError> {
        check(duration, (v0, v1))?;
        check_finite("third velocity", &[third_velocity])?;
        Ok(arc::third_time(duration, (v0, v1), third_velocity))
    }

    /// When the velocity is greatest or least, where that is inside.
    fn apex(&self) -> Option<f64> {
        self.arc.apex().map(|u| u * self.duration)
    }
}

impl<F: Elementary> Curve<F> for Circle<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        let bow = self.arc.at(t, self.duration);
        let velocity = self.start_velocity + (self.rise * (t / self.duration) + bow.height);
        Sample {
            position: self.from + F::from_f64(0.5) * t * (self.start_velocity + velocity) + bow.area,
            velocity,
            acceleration: bow.slope,
            jerk: bow.bend,
        }
    }
}

impl Answers for Circle {
    /// The velocity rises or falls all along, or does one before and the other after its apex.
    fn stationary(&self) -> Stationary {
        let v = |t: f64| self.at(t).velocity;
        let (v0, v1) = (self.start_velocity, self.start_velocity + self.rise);
        if v0.abs().max(v1.abs()).max(self.arc.height()) <= 0.0 {
            return Stationary::everywhere(self.duration);
        }
        let opposite = |a: f64, b: f64| (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0);
        let crossing = |low: f64, high: f64| {
            let found = opposite(v(low), v(high));
            found.then(|| (bracketed(v, low, high), Turn::Reversal))
        };
        let Some(apex) = self.apex() else {
            return Stationary::at(crossing(0.0, self.duration), self.duration);
        };
        // What rounding leaves of a velocity that touches zero.
        let rest = 4.0 * f64::EPSILON * (v0.abs() + self.rise.abs() + self.arc.height());
        if v(apex).abs() <= rest && v0.abs() > rest && v1.abs() > rest {
            return Stationary::at([(apex, Turn::Touch)], self.duration);
        }
        Stationary::at(crossing(0.0, apex).into_iter().chain(crossing(apex, self.duration)), self.duration)
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => self.stationary().points.iter().map(|point| point.time).collect(),
            Quantity::Velocity | Quantity::Jerk => self.apex().into_iter().collect(),
            Quantity::Acceleration => Vec::new(),
        }
    }
}

fn check<F: Elementary>(duration: F, (v0, v1): (F, F)) -> Result<(), ProfileError> {
    check_duration(duration)?;
    check_finite("start velocity", &[v0])?;
    check_finite("end velocity", &[v1])?;
    check_overflow("end velocity", &[v1 - v0])
}

fn inside(duration: f64) -> Range {
    Range::new(Excluded(0.0), Excluded(duration))
}
