//! The curve whose velocity rises, stays and falls along quarters of a sine.

use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_duration, check_finite, check_overflow, check_range};
use crate::range::Range;
use crate::sample::Sample;
use alloc::vec::Vec;
use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// A motion from rest that rises along a quarter of a sine to a velocity, keeps it, and falls back to rest likewise.
///
/// ```text
/// v = V·sin(πt/2T₁)                 up to T₁
/// v = V                             up to T₂
/// v = V·sin(π(T − t)/2(T − T₂))     up to T
/// ```
///
/// It is the shadow, on a straight line, of a point that goes at an even pace round a bend of radius r = 2VT₁/π, along
/// the line, and round a bend of radius 2V(T − T₂)/π. The acceleration jumps from and to standstill at both ends (to
/// V²/r) and nowhere else; the jerk jumps where the bends end. A bend of no duration is left out: the motion then
/// starts or ends with the velocity V.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.5.3. The thesis has one radius in the place of the other in its condition on V (E18),
/// the radius in the place of the length in the displacement of the second bend (E19), calls the rise of velocity
/// constant (E20), and leaves out the start position.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, velocity::Faired};
///
/// let curve = Faired::reaching(3.0_f64, 0.0, 2.0, (1.0, 2.0))?;
/// assert_eq!(curve.at(3.0).position, 2.0);
/// assert!((curve.at(1.5).position - 1.0).abs() < 1e-15);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faired<F = f64> {
    duration: F,
    from: F,
    to: F,
    velocity: F,
    /// T₁ and T₂.
    corners: (F, F),
    rise: Bend<F>,
    fall: Bend<F>,
}

/// One of the two quarters of a sine.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Bend<F> {
    /// π/2 over its duration, 0 for one of no duration.
    rate: F,
    /// Its length r.
    radius: F,
    /// V·rate and V·rate².
    acceleration: F,
    jerk: F,
}

impl<F: Elementary> Faired<F> {
    /// Over `duration`, from position `from`; `velocity` is kept from `rise` to `fall`.
    ///
    /// # Errors
    ///
    /// A duration that is not positive; unless 0 ≤ rise ≤ fall ≤ duration; numbers that are not finite or lead to such.
    pub fn new(duration: F, from: F, velocity: F, (rise, fall): (F, F)) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_corners(duration, rise, fall)?;
        check_finite("from", &[from])?;
        check_finite("velocity", &[velocity])?;
        let to = from + velocity * mean_duration(duration, rise, fall);
        Self::between(duration, (from, to), velocity, (rise, fall))
    }

    /// With the velocity that leads to `to`: V = D/(2T₁/π + (T₂ − T₁) + 2(T − T₂)/π).
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn reaching(duration: F, from: F, to: F, (rise, fall): (F, F)) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_corners(duration, rise, fall)?;
        check_finite("from", &[from])?;
        check_finite("to", &[to])?;
        let velocity = (to - from) / mean_duration(duration, rise, fall);
        check_overflow("velocity", &[velocity])?;
        Self::between(duration, (from, to), velocity, (rise, fall))
    }

    /// The velocity between the bends.
    pub fn velocity(&self) -> F {
        self.velocity
    }

    fn between(duration: F, (from, to): (F, F), velocity: F, (t1, t2): (F, F)) -> Result<Self, ProfileError> {
        check_overflow("position", &[velocity * duration, to])?;
        let (rise, fall) = (Bend::new(t1, velocity)?, Bend::new(duration - t2, velocity)?);
        Ok(Self { duration, from, to, velocity, corners: (t1, t2), rise, fall })
    }

    fn cruise(&self, t: F) -> Sample<F> {
        let way = self.rise.radius + self.velocity * (t - self.corners.0);
        Sample { velocity: self.velocity, ..Sample::rest(self.from + way) }
    }

    fn falling(&self, t: F) -> Sample<F> {
        let mirrored = self.fall.at(self.duration - t, self.velocity);
        Sample { position: self.to - mirrored.position, acceleration: -mirrored.acceleration, ..mirrored }
    }

    fn rising(&self, t: F) -> Sample<F> {
        let rising = self.rise.at(t, self.velocity);
        Sample { position: self.from + rising.position, ..rising }
    }
}

impl<F: Elementary> Bend<F> {
    fn new(duration: F, velocity: F) -> Result<Self, ProfileError> {
        let zero = F::from_f64(0.0);
        if duration.value() <= 0.0 {
            return Ok(Self { rate: zero, radius: zero, acceleration: zero, jerk: zero });
        }
        let rate = F::from_f64(FRAC_PI_2) / duration;
        let acceleration = velocity * rate;
        let jerk = acceleration * rate;
        check_overflow("acceleration", &[rate, acceleration])?;
        check_overflow("jerk", &[jerk])?;
        Ok(Self { rate, radius: velocity * duration * F::from_f64(FRAC_2_PI), acceleration, jerk })
    }

    /// `s` after it leaves, or before it reaches, standstill.
    #[inline]
    fn at(&self, s: F, velocity: F) -> Sample<F> {
        let half = F::from_f64(0.5) * self.rate * s;
        let (sine, cosine) = half.sin_cos();
        // 1 − cos x = 2 sin²(x/2), sin x = 2 sin(x/2)·cos(x/2), cos x = (cos − sin)(cos + sin)(x/2)
        let two = F::from_f64(2.0);
        let whole_sine = two * sine * cosine;
        Sample {
            position: two * self.radius * sine * sine,
            velocity: velocity * whole_sine,
            acceleration: self.acceleration * (cosine - sine) * (cosine + sine),
            jerk: -(self.jerk * whole_sine),
        }
    }
}

impl<F: Elementary> Curve<F> for Faired<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        let (rise, fall) = (self.corners.0.value(), self.corners.1.value());
        if t.value() < rise {
            self.rising(t)
        } else if t.value() >= fall && fall < self.duration.value() {
            self.falling(t)
        } else if t.value().is_nan() {
            Sample::from_array([t; 4])
        } else if rise < fall || rise <= 0.0 {
            self.cruise(t)
        } else {
            // The end of a rise that lasts to the end.
            self.rising(t)
        }
    }

    fn before(&self, t: F) -> Sample<F> {
        let (rise, fall) = (self.corners.0.value(), self.corners.1.value());
        if t.value() > 0.0 && t.value() <= rise {
            self.rising(t)
        } else if t.value() > rise && t.value() <= fall {
            self.cruise(within(t, self.duration))
        } else {
            self.at(t)
        }
    }
}

impl Answers for Faired {
    /// None inside; all where nothing moves.
    fn stationary(&self) -> Stationary {
        if self.velocity.abs() > 0.0 { Stationary::NONE } else { Stationary::everywhere(self.duration) }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        if quantity == Quantity::Position {
            return Vec::new();
        }
        let inside = |t: &f64| *t > 0.0 && *t < self.duration;
        [self.corners.0, self.corners.1].into_iter().filter(inside).collect()
    }
}

fn check_corners<F: Elementary>(duration: F, rise: F, fall: F) -> Result<(), ProfileError> {
    check_range("rise", rise, Range::closed(0.0, duration.value()))?;
    check_range("fall", fall, Range::closed(rise.value(), duration.value()))
}

/// How long the whole way would take at full velocity.
fn mean_duration<F: Elementary>(duration: F, rise: F, fall: F) -> F {
    F::from_f64(FRAC_2_PI) * (rise + (duration - fall)) + (fall - rise)
}
