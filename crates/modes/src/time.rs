//! Steppers: how a state goes on in time, whatever it is the state of.

mod advance;
mod evaluate;
mod explicit;
mod fixed;
mod locate;
#[cfg(feature = "stiff")]
mod solver;
mod stepping;
mod system;

pub use advance::advance;
pub(crate) use fixed::{March, Way};
pub use stepping::{OnFrame, Stepping, Stopped, TimeError};
pub use system::{RateError, System};
