//! Curves that come again: sines, and any curve several times.

mod repeat;
mod sine;

pub use repeat::Repeat;
pub use sine::Sine;

use crate::error::{ProfileError, check_range};
use crate::float::floor;
use crate::range::Range;

/// The most often that a curve comes again.
const MOST: f64 = 1e6;

/// Refuses a number of times that is none.
pub(crate) fn check_times(what: &'static str, times: f64, least: f64) -> Result<(), ProfileError> {
    check_range(what, times, Range::closed(least, MOST))
}

/// A whole number of times.
#[cfg(feature = "text")]
pub(crate) fn whole_times(times: f64) -> Result<u32, ProfileError> {
    check_times("times", times, 1.0)?;
    let whole = times as u32;
    if f64::from(whole) < times {
        Err(ProfileError::NotWhole { what: "times", value: times })
    } else {
        Ok(whole)
    }
}

/// `k` and the rest of `t = k·period + rest`, and whether the rest is none but for rounding.
fn laps(t: f64, period: f64) -> (f64, f64, bool) {
    let nearest = floor(t / period + 0.5);
    let off = t - nearest * period;
    if off.abs() <= 8.0 * f64::EPSILON * t.abs() {
        return (nearest, 0.0, true);
    }
    let whole = floor(t / period);
    (whole, (t - whole * period).clamp(0.0, period), false)
}
