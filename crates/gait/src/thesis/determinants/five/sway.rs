//! The sixth determinant: the pelvis sways to the standing side.

use super::parameters::check_range;
use crate::error::GaitError;
use std::f64::consts::PI;

/// By how much the pelvis sways to either side, in the unit of the width.
///
/// ```text
/// A = g_l · w/2 · (1 − sech(T/2 · √(g/h)))
/// ```
///
/// It is the periodic orbit of an inverted pendulum of height `height` (h) that falls from foot to foot, these being
/// `width` (w) apart, in steps of `step_time` (T, s) under `gravity` (g, length/s²); a person sways by `gain` (`g_l`) times that,
/// 1.3 or so. It falls with the step frequency: 45 mm in all at 110 steps/min, for 0.12 m, 0.95 m and 1.3.
///
/// # Source
///
/// The linear inverted pendulum. Vasilonikolidakis (1991) leaves the sixth determinant out.
///
/// # Errors
///
/// What is no positive number.
pub fn sway_amplitude(
    step_time: f64,
    width: f64,
    gain: f64,
    height: f64,
    gravity: f64,
) -> Result<f64, GaitError> {
    let positive = (f64::MIN_POSITIVE, f64::MAX);
    check_range("step time", step_time, " s", positive, "")?;
    check_range("width", width, " m", (0.0, f64::MAX), "")?;
    check_range("gain of the sway", gain, "", (0.0, f64::MAX), "")?;
    check_range("height of the pendulum", height, " m", positive, "")?;
    check_range("gravity", gravity, " m/s²", positive, "")?;
    let half = 0.5 * step_time * (gravity / height).sqrt();
    Ok(gain * 0.5 * width * (1.0 - 1.0 / half.cosh()))
}

/// The sway in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PelvicSway {
    /// To either side (A).
    pub amplitude: f64,
    /// Of a step (T, s).
    pub step_time: f64,
    /// When the pelvis crosses the path: the middle of the double support, phase 2 (`t_m`, s).
    pub middle: f64,
}

impl PelvicSway {
    /// Towards the standing foot of the step, at a time (s) since it began; odd when legs exchange their parts, so a walk
    /// joins on:
    ///
    /// ```text
    /// y(t) = A sin(π(t − t_m)/T)
    /// ```
    pub fn at(&self, time: f64) -> f64 {
        self.amplitude * (PI * (time - self.middle) / self.step_time).sin()
    }
}
