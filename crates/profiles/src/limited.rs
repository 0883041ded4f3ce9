//! Time-optimal motions: from rest to rest in the least time that limits of velocity, acceleration and jerk allow.
//!
//! | curve | limits | phases | where a limit is not reached |
//! |---|---|---|---|
//! | [`Trapezoidal`] | velocity, acceleration | 3 | no cruise: two phases |
//! | [`SCurve`] | velocity, acceleration, jerk | 7 | no cruise, no phase of constant acceleration, or neither |
//!
//! In every phase one of the limits is reached and none is exceeded, which makes the motion the fastest there is. Each
//! is the same walked backwards, so that it is computed from the nearer end and meets both. `lasting` makes a motion
//! slower, so that several can end at once.
//!
//! Such motions are the first thing that a machine's drives are asked for; the thesis has none of them.

mod s_curve;
mod trapezoidal;

pub use s_curve::SCurve;
pub use trapezoidal::Trapezoidal;

use crate::Elementary;
use crate::error::{ProfileError, check_duration, check_finite, check_overflow, check_range};
use crate::range::Range;
use crate::sample::Sample;

/// Refuses ends that are not finite and limits that are not positive; answers the way and its sign.
fn way<F: Elementary>(from: F, to: F, limits: &[(&'static str, F)]) -> Result<(F, F), ProfileError> {
    check_finite("from", &[from])?;
    check_finite("to", &[to])?;
    for &(what, limit) in limits {
        check_range(what, limit, Range::POSITIVE)?;
    }
    let way = to - from;
    check_overflow("way", &[way])?;
    Ok((way.abs(), F::from_f64(if way.value() < 0.0 { -1.0 } else { 1.0 })))
}

/// How many times longer a motion that takes `least` is to last; refuses what is shorter. None where there is no
/// motion.
fn stretch<F: Elementary>(least: F, duration: F) -> Result<Option<F>, ProfileError> {
    if least.value() <= 0.0 {
        check_range("duration", duration, Range::NOT_NEGATIVE)?;
        return Ok(None);
    }
    check_duration(duration)?;
    check_range("duration", duration, Range::at_least(least.value()))?;
    let factor = duration / least;
    check_overflow("duration", &[factor * factor * factor])?;
    Ok(Some(factor))
}

/// A sample of the way gone from the start, as one of the motion: in its direction, and from the end backwards where it
/// was taken from there.
fn placed<F: Elementary>(way: Sample<F>, (from, to): (F, F), sign: F, backwards: bool) -> Sample<F> {
    let way = Sample::from_array(way.to_array().map(|x| sign * x));
    if backwards {
        Sample { position: to - way.position, acceleration: -way.acceleration, ..way }
    } else {
        Sample { position: from + way.position, ..way }
    }
}

/// The time, or the bound where rounding has led it beyond: no limit is exceeded by the rounding of a late time.
fn at_most<F: Elementary>(s: F, bound: F) -> F {
    let beyond = s.value() - bound.value();
    if beyond > 0.0 { s - F::from_f64(beyond) } else { s }
}

/// The same for a lower bound.
fn at_least<F: Elementary>(s: F, bound: F) -> F {
    -at_most(-s, -bound)
}

/// The inner ends of the phases.
fn inner<const N: usize>(ends: [f64; N], duration: f64) -> alloc::vec::Vec<f64> {
    let mut times: alloc::vec::Vec<f64> = ends.into_iter().filter(|&t| t > 0.0 && t < duration).collect();
    times.dedup();
    times
}
