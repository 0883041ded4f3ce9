//! Numbers of a set-up that are out of their range.

use crate::failure::SetupError;

pub(crate) fn check_not_negative(what: impl Fn() -> String, value: f64) -> Result<(), SetupError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    Err(SetupError::Range { what: what(), value, range: "a finite number, zero or more" })
}

pub(crate) fn check_positive(what: impl Fn() -> String, value: f64) -> Result<(), SetupError> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(SetupError::Range { what: what(), value, range: "a finite number above zero" })
}

pub(crate) fn check_finite(what: impl Fn() -> String, value: f64) -> Result<(), SetupError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(SetupError::Range { what: what(), value, range: "a finite number" })
}
