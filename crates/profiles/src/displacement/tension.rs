//! The curve under tension: hyperbolic functions and a straight line, with given velocities at the ends.

mod scaled;
mod still;

use super::{Place, check_motion, check_velocities};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::Curve;
use crate::error::{ProfileError, check_overflow, check_range};
use crate::range::Range;
use crate::roots::bracketed;
use crate::sample::Sample;
use alloc::vec::Vec;
pub(crate) use scaled::Scaled;
use scaled::cubic_share;

/// A motion from one position and velocity to another as a cable under tension would lie: with stiffness k = 0 the cubic, and the
/// straight line, with quick changes to the velocities at both ends, as k grows.
///
/// ```text
/// x = x₀ + T·v₀·P + T·v₁·Q + R·W        u = t/T,  h = k/2,  X = h·u,  Y = h·(1 − u)
///
/// P = sinh(h + Y)·sinh X/(h·sinh 2h)    Q = sinh² X/(h·sinh 2h)    W = (g(X)·cosh Y + X·sinh X·sinh Y)/g(h)
/// g(z) = z·cosh z − sinh z              R = x₁ − x₀ − T·(v₀ + v₁)·tanh h/(2h)
///
/// v = (v₀·sinh 2Y + v₁·sinh 2X)/sinh 2h + R/T·2h·sinh X·sinh Y/g(h)
/// a = k/T·(v₁·cosh 2X − v₀·cosh 2Y)/sinh 2h + R/T²·2h²·sinh(Y − X)/g(h)
/// j = (k/T)²·(v₀·sinh 2Y + v₁·sinh 2X)/sinh 2h − R/T³·2h²·k·cosh(Y − X)/g(h)
/// ```
///
/// All these are sums of positive terms, and eʰ is taken out of all of them, so that k up to 10⁴ and beyond loses nothing
/// and k = 0 is no exception. In terms of functions of time, x is a sum of 1, u, sinh k·u and cosh k·u.
///
/// # Source
///
/// In place of Vasilonikolidakis (1991), §5.3.3 and §A.1.3, "hyperbolic with velocity constraints", whose basis sinh(t/T),
/// t·sinh t, sinh t, 1 depends on the unit of time (E10) and has no solution for some durations (E9); it is kept as
/// [`legacy::Hyperbolic`](crate::legacy::Hyperbolic). The spline in tension is D. G. Schweikert's, Journal of Mathematics
/// and Physics 45 (1966).
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, displacement::Tension};
///
/// let curve = Tension::new(2.0, (0.0, -1.0), (5.0, 0.0), 100.0)?;
/// // Away from the ends, nearly the straight line.
/// assert!((curve.at(1.0).velocity - 2.5_f64).abs() < 0.1);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "spline under tension")]
#[doc(alias = "tension spline")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tension<F = f64> {
    duration: F,
    start: (F, F),
    end: (F, F),
    stiffness: F,
    scaled: Scaled<F>,
    /// R.
    excess: F,
    /// 1/T.
    rate: F,
}

impl<F: Elementary> Tension<F> {
    /// Over `duration` > 0, from one (position, velocity) to another, with `stiffness` k ≥ 0.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, a stiffness below zero, numbers that are not finite or lead to such.
    pub fn new(duration: F, start: (F, F), end: (F, F), stiffness: F) -> Result<Self, ProfileError> {
        check_motion(duration, start.0, end.0)?;
        check_velocities(start.1, end.1)?;
        check_range("stiffness", stiffness, Range::NOT_NEGATIVE)?;
        let scaled = Scaled::new(stiffness)?;
        let delta = end.0 - start.0;
        let excess = delta - F::from_f64(0.5) * duration * (start.1 + end.1) * scaled.tangent;
        let curve =
            Self { duration, start, end, stiffness, scaled, excess, rate: F::from_f64(1.0) / duration };
        check_overflow("distance", &[delta, excess])?;
        check_overflow("rate", &[curve.rate])?;
        for t in [F::from_f64(0.0), duration] {
            check_overflow("largest jerk", &curve.at(t).to_array())?;
        }
        Ok(curve)
    }
}

impl<F: Elementary> Curve<F> for Tension<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let place = Place::new(t, self.duration);
        let ((base, near), (_, far)) =
            if place.from_end { (self.end, self.start) } else { (self.start, self.end) };
        let s = &self.scaled;
        let (half, one, two) = (F::from_f64(0.5), F::from_f64(1.0), F::from_f64(2.0));
        let (u, w) = (place.near, place.far);
        // e⁻²ᶻ − 1 and e⁻²ᶻ for X, Y and Y − X, which is not negative here.
        let (x, y) = (s.half * u, s.half * w);
        let (below_x, below_y, below_xy) =
            ((-two * x).exp_m1(), (-two * y).exp_m1(), (-two * (y - x)).exp_m1());
        let (decay_x, decay_y) = (scaled::decay(x, below_x), scaled::decay(y, below_y));
        // sinh(X)/h and cosh X without their eˣ, and the same of Y, Y − X, h + Y.
        let (sine_x, sine_y, sine_xy) = (s.sine(u, below_x), s.sine(w, below_y), s.sine(w - u, below_xy));
        let sum = s.sine(one + w, s.below + below_y * (one + s.below));
        let (cosine_x, cosine_y) = (one + half * below_x, one + half * below_y);
        // sinh 2Y/sinh 2h and sinh 2X/sinh 2h; 2h·sinh X·sinh Y/g(h).
        let ends = (sine_y * cosine_y * decay_x * s.per_sine, sine_x * cosine_x * decay_y * s.per_sine);
        let bow = two * sine_x * sine_y * s.per_share;
        // P, Q, W.
        let first = half * sum * sine_x * s.per_sine;
        let second = half * sine_x * sine_x * decay_y * s.per_sine;
        let third = u * (u * u * cubic_share(x, below_x) * cosine_y + sine_x * sine_y) * s.per_share;
        // cosh 2Y, cosh 2X, sinh(Y − X), cosh(Y − X).
        let cosines =
            (half * (one + decay_y * decay_y) * decay_x, half * (one + decay_x * decay_x) * decay_y);
        let (tilt, level) = (sine_xy * decay_x, (one + half * below_xy) * decay_x);
        let (rate, bowing) = (self.rate, self.excess * self.rate);
        let acceleration =
            (far * cosines.1 - near * cosines.0) * s.per_sine + two * bowing * tilt * s.per_share;
        let square = self.stiffness * self.stiffness;
        let jerk = square * (near * ends.0 + far * ends.1) - F::from_f64(4.0) * bowing * level * s.per_share;
        Sample {
            position: base
                + place.forward(self.duration * (near * first + far * second) + self.excess * third),
            velocity: near * ends.0 + far * ends.1 + bowing * bow,
            acceleration: place.forward(acceleration) * rate,
            jerk: jerk * rate * rate,
        }
    }
}

impl Answers for Tension {
    fn stationary(&self) -> Stationary {
        let (v0, v1) = (self.start.1, self.end.1);
        if [v0, v1, self.end.0 - self.start.0].iter().all(|x| x.abs() <= 0.0) {
            return Stationary::everywhere(self.duration);
        }
        Stationary::at(self.still(), self.duration)
    }

    /// Acceleration and jerk are sums of sinh k·u and cosh k·u, of which each has one zero at most.
    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        let derivative = match quantity {
            Quantity::Position => return self.still().into_iter().map(|(time, _)| time).collect(),
            Quantity::Velocity | Quantity::Jerk => Quantity::Acceleration,
            Quantity::Acceleration => Quantity::Jerk,
        };
        let of = |t: f64| derivative.of(&self.at(t));
        let turns = of(0.0) * of(self.duration).signum() < 0.0;
        if turns { alloc::vec![bracketed(of, 0.0, self.duration)] } else { Vec::new() }
    }
}
