//! The S-curve: least time with limited velocity, acceleration and jerk.

use super::{at_least, at_most, inner, placed, stretch, way};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_overflow};
use crate::sample::Sample;
use alloc::vec::Vec;

/// A motion from rest to rest in the least time with a limited velocity V, acceleration A and jerk J: seven phases of constant
/// jerk.
///
/// ```text
/// phase   1     2     3     4     5     6     7
/// jerk    J     0    −J     0    −J     0     J
/// lasts   tⱼ    tₐ    tⱼ    tᵥ    tⱼ    tₐ    tⱼ
///
/// V reached, A reached:  tⱼ = A/J          tⱼ + tₐ = V/A
/// V reached, A not:      tⱼ = √(V/J)       tₐ = 0
/// V not, A reached:      tⱼ = A/J          tⱼ + tₐ = √((tⱼ/2)² + D/A) − tⱼ/2
/// neither:               tⱼ = ∛(D/2J)      tₐ = 0                                D = |to − from|
/// ```
///
/// and tᵥ = D/V − 2tⱼ − tₐ where V is reached. The acceleration is continuous, the jerk jumps. No way takes no time:
/// with `from` = `to` the duration is 0.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, limited::SCurve};
///
/// let motion = SCurve::new(0.0, 4.0, 1.0, 1.0, 2.0)?;
/// assert_eq!(motion.phases(), [0.5, 0.5, 0.5, 2.5, 0.5, 0.5, 0.5]);
/// assert_eq!(motion.at(0.75).acceleration, 1.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "jerk-limited")]
#[doc(alias = "double s")]
#[doc(alias = "ruckig")]
#[doc(alias = "time-optimal")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SCurve<F = f64> {
    ends: (F, F),
    /// 1 or −1.
    sign: F,
    /// tⱼ, tₐ and tᵥ.
    times: (F, F, F),
    duration: F,
    /// When the first six phases end.
    corners: [F; 6],
    velocity: F,
    acceleration: F,
    jerk: F,
}

impl<F: Elementary> SCurve<F> {
    /// From `from` to `to`; the limits are magnitudes.
    ///
    /// # Errors
    ///
    /// A limit that is not positive; numbers that are not finite or lead to such.
    pub fn new(
        from: F,
        to: F,
        max_velocity: F,
        max_acceleration: F,
        max_jerk: F,
    ) -> Result<Self, ProfileError> {
        let (v, a, j) = (max_velocity, max_acceleration, max_jerk);
        let limits = [("largest velocity", v), ("largest acceleration", a), ("largest jerk", j)];
        let (way, sign) = way(from, to, &limits)?;
        let (zero, half, two) = (F::from_f64(0.0), F::from_f64(0.5), F::from_f64(2.0));
        if way.value() <= 0.0 {
            return Ok(Self::of((from, to), sign, (zero, zero, zero), zero, [zero, zero, j]));
        }
        let ramp = a / j;
        // With V reached: A is on the way to it or not.
        let (tj, ta, top) =
            if (v / a).value() >= ramp.value() { (ramp, v / a - ramp, a) } else { root_of(v, j) };
        let cruise = way / v - (tj + ta + tj);
        let (times, speed, top) = if cruise.value() >= 0.0 {
            ((tj, ta, cruise), v, top)
        } else {
            let (rest, ratio) = (half * ramp, way / a);
            // D/A ≥ 2tⱼ², without squares that overflow where A is as good as unlimited.
            if ratio.sqrt().value() >= core::f64::consts::SQRT_2 * ramp.value() {
                // Free of cancellation where D/A is small beside tⱼ²: (D/A − 2tⱼ²)/(√((tⱼ/2)² + D/A) + 3tⱼ/2).
                let held = (ratio - two * ramp * ramp) / ((rest * rest + ratio).sqrt() + rest + ramp);
                let held = if held.value() > 0.0 { held } else { zero };
                ((ramp, held, zero), a * (ramp + held), a)
            } else {
                let tj = cube_root(half * way / j);
                ((tj, zero, zero), way / (two * tj), j * tj)
            }
        };
        check_overflow("duration", &[way / a])?;
        let motion = Self::of((from, to), sign, times, times.0 + times.1 + times.0, [speed, top, j]);
        check_overflow("duration", &[times.0, times.1, times.2, motion.duration])?;
        check_overflow("velocity", &[speed])?;
        check_overflow("acceleration", &[top])?;
        Ok(motion)
    }

    /// The same way, so much slower that it lasts `duration`: slower throughout, n times longer with 1/n of the
    /// velocities, 1/n² of the accelerations and 1/n³ of the jerks.
    ///
    /// # Errors
    ///
    /// A duration shorter than the motion's own, which is the least; the error tells it.
    pub fn lasting(self, duration: F) -> Result<Self, ProfileError> {
        let Some(n) = stretch(self.duration, duration)? else { return Ok(Self { duration, ..self }) };
        let (tj, ta, tv) = self.times;
        let rates = [self.velocity / n, self.acceleration / n / n, self.jerk / n / n / n];
        let slower = Self::of(self.ends, self.sign, (tj * n, ta * n, tv * n), (tj + ta + tj) * n, rates);
        check_overflow("duration", &[slower.duration])?;
        // What was asked for, to the last digit.
        Ok(Self { duration, ..slower })
    }

    /// How long each of the seven phases lasts; some may be 0.
    pub fn phases(&self) -> [F; 7] {
        let (tj, ta, tv) = self.times;
        [tj, ta, tj, tv, tj, ta, tj]
    }

    /// `ramp` is how long the motion speeds up.
    fn of(ends: (F, F), sign: F, times: (F, F, F), ramp: F, [velocity, acceleration, jerk]: [F; 3]) -> Self {
        let (tj, ta, tv) = times;
        let duration = ramp + tv + ramp;
        let corners = [tj, tj + ta, ramp, duration - ramp, duration - (tj + ta), duration - tj];
        Self { ends, sign, times, duration, corners, velocity, acceleration, jerk }
    }

    fn evaluate(&self, t: F, phase: usize) -> Sample<F> {
        if self.velocity.value() <= 0.0 {
            return Sample::rest(self.ends.0);
        }
        let backwards = phase > 3 || (phase == 3 && t.value() + t.value() > self.duration.value());
        let s = if backwards { self.duration - t } else { t };
        placed(self.speeding_up(s, phase.min(6 - phase)), self.ends, self.sign, backwards)
    }

    /// The way gone at `s`, in one of the phases 0 to 3.
    fn speeding_up(&self, s: F, phase: usize) -> Sample<F> {
        let n = F::from_f64;
        let (zero, half, sixth) = (n(0.0), n(0.5), n(1.0 / 6.0));
        let (j, a, v) = (self.jerk, self.acceleration, self.velocity);
        let (tj, ta, _) = self.times;
        let ramp = tj + ta + tj;
        match phase {
            0 => {
                let s = at_most(s, tj);
                let acceleration = j * s;
                let velocity = half * s * acceleration;
                Sample { position: sixth * s * s * acceleration, velocity, acceleration, jerk: j }
            }
            1 => {
                let since = at_most(s, tj + ta) - tj;
                let reached = half * a * tj;
                let position = sixth * a * tj * tj + since * (reached + half * a * since);
                Sample { position, velocity: reached + a * since, acceleration: a, jerk: zero }
            }
            2 => {
                let left = at_least(at_most(ramp - s, tj), zero);
                let acceleration = j * left;
                let position = v * (half * ramp - left) + sixth * left * left * acceleration;
                Sample { position, velocity: v - half * left * acceleration, acceleration, jerk: -j }
            }
            _ => {
                let position = v * (s - half * ramp);
                Sample { position, velocity: v, acceleration: zero, jerk: zero }
            }
        }
    }
}

impl<F: Elementary> Curve<F> for SCurve<F> {
    /// How long it lasts; 0 where there is no way to go.
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        if t.value().is_nan() {
            return Sample::from_array([t; 4]);
        }
        let phase = self.corners.iter().filter(|corner| corner.value() <= t.value()).count();
        self.evaluate(t, phase)
    }

    fn before(&self, t: F) -> Sample<F> {
        if t.value() > 0.0 && t.value() <= self.duration.value() {
            let phase = self.corners.iter().filter(|corner| corner.value() < t.value()).count();
            self.evaluate(t, phase)
        } else {
            self.at(t)
        }
    }
}

impl Answers for SCurve {
    /// None inside; all of a rest that was made to last.
    fn stationary(&self) -> Stationary {
        if self.velocity > 0.0 || self.duration <= 0.0 {
            Stationary::NONE
        } else {
            Stationary::everywhere(self.duration)
        }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => Vec::new(),
            Quantity::Velocity | Quantity::Acceleration | Quantity::Jerk => {
                inner(self.corners, self.duration)
            }
        }
    }
}

/// tⱼ, no tₐ, and the acceleration reached where V is reached without reaching A.
fn root_of<F: Elementary>(v: F, j: F) -> (F, F, F) {
    let tj = v.sqrt() / j.sqrt();
    (tj, F::from_f64(0.0), v.sqrt() * j.sqrt())
}

/// ∛x of a positive number; one step of Newton's takes off what the rounded exponent 1/3 leaves.
fn cube_root<F: Elementary>(x: F) -> F {
    let third = F::from_f64(1.0 / 3.0);
    let y = x.powf(third);
    y - (y - x / (y * y)) * third
}
