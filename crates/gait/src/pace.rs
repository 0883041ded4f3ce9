//! Step frequency, step length and speed: any two decide the third.

use crate::error::GaitError;

/// The step frequency when nothing else is asked (steps/min).
pub const DEFAULT_STEP_FREQUENCY: f64 = 110.0;

/// Step frequency (steps/min) and step length (m) from what was given of them and of the speed (m/s). What is left open follows
/// from `S = ratio·sf`, and with nothing given the frequency is the usual one.
///
/// # Errors
///
/// All three given.
pub(crate) fn settle(
    step_frequency: Option<f64>,
    step_length: Option<f64>,
    speed: Option<f64>,
    ratio: f64,
) -> Result<(f64, f64), GaitError> {
    Ok(match (step_frequency, step_length, speed) {
        (Some(step_frequency), Some(step_length), Some(speed)) => {
            return Err(GaitError::Overdetermined { step_frequency, step_length, speed });
        }
        (Some(frequency), Some(length), None) => (frequency, length),
        (Some(frequency), None, Some(speed)) => (frequency, 60.0 * speed / frequency),
        (None, Some(length), Some(speed)) => (60.0 * speed / length, length),
        (Some(frequency), None, None) => (frequency, ratio * frequency),
        (None, Some(length), None) => (length / ratio, length),
        // S = r·sf and v = S·sf/60.
        (None, None, Some(speed)) => {
            let frequency = (60.0 * speed / ratio).sqrt();
            (frequency, ratio * frequency)
        }
        (None, None, None) => (DEFAULT_STEP_FREQUENCY, ratio * DEFAULT_STEP_FREQUENCY),
    })
}
