//! The quintic curve, which meets positions, velocities and accelerations at both ends.

use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_duration, check_finite, check_overflow};
use crate::roots;
use crate::sample::{Boundary, Sample};
use alloc::vec::Vec;

/// The curve of degree five that meets position, velocity and acceleration at both ends.
///
/// ```text
/// x(t) = Σ cₖ wᵏ,  w = 2t/T − 1,  k = 0 … 5
/// ```
///
/// Of all curves with these six boundary values it has the least ∫ jerk² dt. Expanded about its middle it has no end that is
/// far from where it is exact, and needs no choice between two expansions; at the ends themselves it answers what it was
/// given. Beyond its ends it goes on as the same polynomial ([`extrapolated`](Curve::extrapolated)).
///
/// # Source
///
/// T. Flash, N. Hogan, "The coordination of arm movements: an experimentally confirmed mathematical model", Journal of
/// Neuroscience 5 (1985): the minimum-jerk movement. The thesis asks for all six boundary values (Vasilonikolidakis (1991),
/// §5.2), but none of its profiles meets them (E31).
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Boundary, Curve, Quintic};
///
/// let curve = Quintic::new(2.0, Boundary::new(0.0, 0.5, 0.0), Boundary::rest(1.0))?;
/// assert_eq!(curve.at(0.0).velocity, 0.5);
/// assert_eq!(curve.at(2.0).position, 1.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
// Two numbers of a pair are read at once, without an instruction of their own where they are aligned.
#[doc(alias = "fifth-order polynomial")]
#[doc(alias = "minimum jerk")]
#[repr(align(16))]
pub struct Quintic<F = f64> {
    duration: F,
    /// 2/T
    rate: F,
    /// Coefficients of the powers of w: those of position and velocity stand side by side, and those of acceleration and
    /// jerk, to be computed two at a time.
    position_velocity: [[F; 2]; 6],
    acceleration_jerk: [[F; 2]; 4],
    ends: [Boundary<F>; 2],
}

impl<F: Elementary> Quintic<F> {
    /// Over `duration`, from `start` at time 0 to `end`.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or become so by being so large in so short a time.
    pub fn new(duration: F, start: Boundary<F>, end: Boundary<F>) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_finite("start", &start.numbers())?;
        check_finite("end", &end.numbers())?;
        let n = F::from_f64;
        let rate = n(2.0) / duration;
        check_overflow("velocity", &[rate])?;
        let c = about_the_middle(n(0.5) * duration, &start, &end);
        let [mut position_velocity, mut acceleration_jerk] = [[[n(0.0); 2]; 6]; 2];
        let rates = [rate, rate * rate, rate * rate * rate];
        for k in 0..6 {
            let factor = |derivative: usize| (0..derivative).map(|i| (k + derivative - i) as f64).product();
            let coefficient = |derivative: usize| match c.get(k + derivative) {
                Some(&c) => n(factor(derivative)) * c * rates[derivative - 1],
                None => n(0.0),
            };
            position_velocity[k] = [c[k], coefficient(1)];
            acceleration_jerk[k] = [coefficient(2), coefficient(3)];
        }
        // Of six terms that are at most as large as their coefficients.
        check_overflow("position", &position_velocity.map(|c| n(8.0) * c[0]))?;
        check_overflow("velocity", &position_velocity.map(|c| n(8.0) * c[1]))?;
        check_overflow("acceleration", &acceleration_jerk.map(|c| n(8.0) * c[0]))?;
        check_overflow("jerk", &acceleration_jerk.map(|c| n(8.0) * c[1]))?;
        let [c0, c1, c2, c3, ..] = acceleration_jerk;
        let (acceleration_jerk, ends) = ([c0, c1, c2, c3], [start, end]);
        Ok(Self { duration, rate, position_velocity, acceleration_jerk, ends })
    }

    /// From rest at `from` to rest at `to`, with no acceleration at either end: x(t) = from + D·u³·(10 − 15 u + 6 u²). The
    /// greatest velocity is 15/8 of the mean one.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    #[doc(alias = "smootherstep")]
    #[doc(alias = "Flash and Hogan")]
    pub fn minimum_jerk(duration: F, from: F, to: F) -> Result<Self, ProfileError> {
        check_finite("from", &[from])?;
        check_finite("to", &[to])?;
        Self::new(duration, Boundary::rest(from), Boundary::rest(to))
    }

    /// At any time. By Estrin's rule, c₀ + c₁w + w²·(c₂ + c₃w + w²·(c₄ + c₅w)), whose parts do not wait for each other.
    #[allow(clippy::inline_always, reason = "a call would take a third as long as the answer")]
    #[inline(always)]
    fn evaluate(&self, t: F) -> Sample<F> {
        let w = t * self.rate - F::from_f64(1.0);
        let square = w * w;
        let line = |c: &[F; 2], slope: &[F; 2]| [c[0] + slope[0] * w, c[1] + slope[1] * w];
        let join = |low: [F; 2], high: [F; 2]| [low[0] + high[0] * square, low[1] + high[1] * square];
        let [p0, p1, p2, p3, p4, p5] = &self.position_velocity;
        let [position, velocity] = join(line(p0, p1), join(line(p2, p3), line(p4, p5)));
        let [a0, a1, a2, a3] = &self.acceleration_jerk;
        let [acceleration, jerk] = join(line(a0, a1), line(a2, a3));
        Sample { position, velocity, acceleration, jerk }
    }

    /// At an end: what it was given, with the derivatives of a time that has such.
    #[cold]
    #[inline(never)]
    fn end(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        let late = t.value() > 0.0;
        let end = &self.ends[usize::from(late)];
        let since = if late { t - self.duration } else { t };
        let jerk = self.evaluate(t).jerk;
        Sample {
            position: end.position + since * end.velocity,
            velocity: end.velocity + since * end.acceleration,
            acceleration: end.acceleration + since * jerk,
            jerk,
        }
    }
}

/// The coefficients of w = −1 … 1 over two times `half` a duration. Even and odd powers separate: with s and d half the sum
/// and half the difference of the ends' values, velocities multiplied by h = T/2 and accelerations by h²,
///
/// ```text
/// c₄ = (a_s − v_d)/8    c₂ = v_d/2 − 2c₄           c₀ = x_s − c₂ − c₄
/// c₅ = (a_d − 3e)/8     c₃ = e/2 − 2c₅             c₁ = x_d − c₃ − c₅        e = v_s − x_d
/// ```
fn about_the_middle<F: Elementary>(half: F, start: &Boundary<F>, end: &Boundary<F>) -> [F; 6] {
    let n = F::from_f64;
    let sum = |x: F, y: F| n(0.5) * x + n(0.5) * y;
    let (xs, xd) = (sum(start.position, end.position), sum(-start.position, end.position));
    let (vs, vd) = (half * sum(start.velocity, end.velocity), half * sum(-start.velocity, end.velocity));
    let square = half * half;
    let accelerations = (start.acceleration, end.acceleration);
    let (a_s, ad) =
        (square * sum(accelerations.0, accelerations.1), square * sum(-accelerations.0, accelerations.1));
    let c4 = n(0.125) * (a_s - vd);
    let c2 = n(0.5) * vd - n(2.0) * c4;
    let excess = vs - xd;
    let c5 = n(0.125) * (ad - n(3.0) * excess);
    let c3 = n(0.5) * excess - n(2.0) * c5;
    [xs - c2 - c4, xd - c3 - c5, c2, c3, c4, c5]
}

impl Quintic {
    /// The velocity of u, times the duration, in the Bernstein basis of degree 4.
    fn velocity(&self) -> [f64; 5] {
        let ([x0, v0, a0], [x1, v1, a1]) = self.scaled_ends();
        let middle = 5.0 * (x1 - x0) - 2.0 * (v0 + v1) + 0.25 * (a1 - a0);
        [v0, v0 + 0.25 * a0, middle, v1 - 0.25 * a1, v1]
    }

    /// The acceleration likewise, of degree 3.
    fn acceleration(&self) -> [f64; 4] {
        let (v, ([_, _, a0], [_, _, a1])) = (self.velocity(), self.scaled_ends());
        [a0, 4.0 * (v[2] - v[1]), 4.0 * (v[3] - v[2]), a1]
    }

    /// The jerk likewise, of degree 2.
    fn jerk(&self) -> [f64; 3] {
        let a = self.acceleration();
        [3.0 * (a[1] - a[0]), 3.0 * (a[2] - a[1]), 3.0 * (a[3] - a[2])]
    }

    /// x, v·T and a·T² at both ends.
    fn scaled_ends(&self) -> ([f64; 3], [f64; 3]) {
        let t = self.duration;
        let scaled = |end: &Boundary| [end.position, end.velocity * t, end.acceleration * t * t];
        (scaled(&self.ends[0]), scaled(&self.ends[1]))
    }

    fn times(&self, shares: Vec<(f64, crate::Turn)>) -> Vec<f64> {
        shares.into_iter().map(|(u, _)| u * self.duration).collect()
    }
}

impl<F: Elementary> Curve<F> for Quintic<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[allow(clippy::inline_always, reason = "see `evaluate`")]
    #[inline(always)]
    fn at(&self, t: F) -> Sample<F> {
        if t.value() > 0.0 && t.value() < self.duration.value() { self.evaluate(t) } else { self.end(t) }
    }

    fn extrapolated(&self, t: F) -> Sample<F> {
        self.evaluate(t)
    }
}

impl Answers for Quintic {
    fn stationary(&self) -> Stationary {
        let velocity = self.velocity();
        if velocity.iter().all(|c| c.abs() <= 0.0) {
            return Stationary::everywhere(self.duration);
        }
        let points = roots::bernstein(&velocity).into_iter().map(|(u, turn)| (u * self.duration, turn));
        Stationary::at(points, self.duration)
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => self.stationary().points.iter().map(|point| point.time).collect(),
            Quantity::Velocity => self.times(roots::bernstein(&self.acceleration())),
            Quantity::Acceleration => self.times(roots::bernstein(&self.jerk())),
            Quantity::Jerk => {
                let [j0, j1, j2] = self.jerk();
                self.times(roots::bernstein(&[j1 - j0, j2 - j1]))
            }
        }
    }
}
