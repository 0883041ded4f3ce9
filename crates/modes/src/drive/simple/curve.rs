//! The two curves of simple mode that are no profiles of their own: from rest to rest in one time.

use solaris_profiles::{Curve, ProfileError, Sample};
use std::f64::consts::TAU;

/// A constant acceleration until halfway, then its negative.
///
/// ```text
/// x = x₀ + 2·D·u²  for u ≤ 1/2,   x₁ − 2·D·(1 − u)²  after        u = t/T,  D = x₁ − x₀
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BangBang {
    duration: f64,
    from: f64,
    to: f64,
    /// 4·D/T²
    acceleration: f64,
}

impl BangBang {
    pub(super) fn new(duration: f64, from: f64, to: f64) -> Result<Self, ProfileError> {
        check(duration, from, to)?;
        let acceleration = 4.0 * (to - from) / duration / duration;
        finite("acceleration", acceleration)?;
        Ok(Self { duration, from, to, acceleration })
    }

    fn sided(&self, t: f64, late: bool) -> Sample {
        let a = if late { -self.acceleration } else { self.acceleration };
        // The time to or from the nearer end.
        let (base, near) = if late { (self.to, self.duration - t) } else { (self.from, t) };
        let position = base + 0.5 * a * near * near;
        // NaN for no time.
        Sample { position, velocity: self.acceleration * near, acceleration: a + 0.0 * t, jerk: 0.0 * t }
    }
}

impl Curve for BangBang {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn at(&self, t: f64) -> Sample {
        let t = within(t, self.duration);
        self.sided(t, t >= 0.5 * self.duration)
    }

    fn before(&self, t: f64) -> Sample {
        let t = within(t, self.duration);
        self.sided(t, t > 0.5 * self.duration)
    }
}

/// An acceleration that is a whole sine over the time.
///
/// ```text
/// x = x₀ + D·(u − sin(2π·u)/(2π))        a = 2π·D/T²·sin(2π·u)        u = t/T,  D = x₁ − x₀
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Harmonic {
    duration: f64,
    from: f64,
    to: f64,
    /// 2π/T
    rate: f64,
    /// D/T
    mean: f64,
}

impl Harmonic {
    pub(super) fn new(duration: f64, from: f64, to: f64) -> Result<Self, ProfileError> {
        check(duration, from, to)?;
        let (rate, mean) = (TAU / duration, (to - from) / duration);
        finite("jerk", rate * rate * mean)?;
        Ok(Self { duration, from, to, rate, mean })
    }
}

impl Curve for Harmonic {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn at(&self, t: f64) -> Sample {
        let t = within(t, self.duration);
        let late = t > 0.5 * self.duration;
        // From the nearer end, where the curve is the same walked backwards.
        let (base, near, way) = if late { (self.to, self.duration - t, -1.0) } else { (self.from, t, 1.0) };
        let (sine, cosine) = (self.rate * near).sin_cos();
        Sample {
            position: base + way * self.mean * (near - sine / self.rate),
            velocity: self.mean * (1.0 - cosine),
            acceleration: way * self.mean * self.rate * sine,
            jerk: self.mean * self.rate * self.rate * cosine,
        }
    }
}

fn check(duration: f64, from: f64, to: f64) -> Result<(), ProfileError> {
    finite("from", from)?;
    finite("to", to)?;
    if duration.is_finite() && duration > 0.0 { Ok(()) } else { Err(ProfileError::Duration { duration }) }
}

fn finite(what: &'static str, value: f64) -> Result<(), ProfileError> {
    if value.is_finite() { Ok(()) } else { Err(ProfileError::NotFinite { what, value }) }
}

/// The nearer end for a time outside of the span; NaN stays NaN.
fn within(t: f64, duration: f64) -> f64 {
    if t < 0.0 {
        0.0
    } else if t > duration {
        duration
    } else {
        t
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// The derivatives are those of the position, by central differences inside of the pieces.
    fn check_derivatives(curve: &dyn Curve, times: &[f64]) {
        let h = 1e-5;
        for &t in times {
            let (before, at, after) = (curve.at(t - h), curve.at(t), curve.at(t + h));
            assert_abs_diff_eq!((after.position - before.position) / (2.0 * h), at.velocity, epsilon = 1e-8);
            assert_abs_diff_eq!(
                (after.velocity - before.velocity) / (2.0 * h),
                at.acceleration,
                epsilon = 1e-8
            );
            assert_abs_diff_eq!(
                (after.acceleration - before.acceleration) / (2.0 * h),
                at.jerk,
                epsilon = 1e-7
            );
        }
    }

    #[test]
    fn velocity_acceleration_and_jerk_are_derivatives() {
        let times = [0.1, 0.5, 0.9, 1.1, 1.7, 1.9];
        check_derivatives(&BangBang::new(2.0, 0.3, -1.2).expect("valid"), &times);
        check_derivatives(&Harmonic::new(2.0, 0.3, -1.2).expect("valid"), &times);
    }

    #[test]
    fn the_middle_of_bang_bang_has_two_sides() {
        let curve = BangBang::new(2.0, 0.0, 1.0).expect("valid");
        assert_abs_diff_eq!(curve.before(1.0).acceleration, 1.0, epsilon = 0.0);
        assert_abs_diff_eq!(curve.at(1.0).acceleration, -1.0, epsilon = 0.0);
        assert_abs_diff_eq!(curve.at(1.0).position, 0.5, epsilon = 0.0);
        assert_abs_diff_eq!(curve.before(1.0).velocity, curve.at(1.0).velocity, epsilon = 0.0);
    }

    #[test]
    fn numbers_that_are_none_are_refused_and_nan_stays_nan() {
        assert!(BangBang::new(0.0, 0.0, 1.0).is_err());
        assert!(BangBang::new(1.0, f64::NAN, 1.0).is_err());
        assert!(BangBang::new(1e-200, 0.0, 1.0).is_err());
        assert!(Harmonic::new(f64::INFINITY, 0.0, 1.0).is_err());
        assert!(Harmonic::new(1e-200, 0.0, 1.0).is_err());
        let curves: [&dyn Curve; 2] =
            [&BangBang::new(2.0, 0.0, 1.0).expect("valid"), &Harmonic::new(2.0, 0.0, 1.0).expect("valid")];
        for curve in curves {
            assert!(curve.at(f64::NAN).to_array().iter().all(|x| x.is_nan()));
        }
    }
}
