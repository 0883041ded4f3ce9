//! Refusals of values that can be read.

use crate::args::{BODY_MASS_INDICES, HEIGHTS};
use crate::words::{at_least, at_most, ranges};
use solaris::model::HumanError;
use solaris::profiles::Ranges;

/// Why a value is refused. Bounds are rounded inwards: typed as they are read, they are taken.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Refusal {
    /// The unit has a space before it, where it has one.
    #[error("it must be {} to {}{unit}{more}", at_least(*lower), at_most(*upper))]
    Range { lower: f64, upper: f64, unit: &'static str, more: String },
    /// A step length or a speed that people do not take at a step frequency.
    #[error("this figure walks with {} to {}{unit} {at}{more}", up(*lower), down(*upper))]
    Pace { lower: f64, upper: f64, unit: &'static str, at: String, more: String },
    #[error("{}", person(.0))]
    Person(HumanError),
    #[error("it must be {}", ranges(.0.as_slice()))]
    Ranges(Ranges),
    #[error("{why}; {}", instead(what, among))]
    Infeasible { what: &'static str, why: &'static str, among: Ranges },
    #[error("it must be a finite number")]
    NotFinite,
    #[error("it must be a whole number")]
    NotWhole,
    #[error("it must be more than zero")]
    NotPositive,
    #[error("{0}")]
    Because(String),
}

impl From<String> for Refusal {
    fn from(why: String) -> Self {
        Self::Because(why)
    }
}

impl From<&str> for Refusal {
    fn from(why: &str) -> Self {
        Self::Because(why.to_owned())
    }
}

/// In millimetres, rounded up.
fn up(x: f64) -> String {
    format!("{:.3}", (x * 1e3 - 1e-9).ceil() / 1e3)
}

/// In millimetres, rounded down.
fn down(x: f64) -> String {
    format!("{:.3}", (x * 1e3 + 1e-9).floor() / 1e3)
}

fn instead(what: &str, among: &Ranges) -> String {
    if among.is_empty() {
        format!("no {what} would do")
    } else {
        format!("it may be {}", ranges(among.as_slice()))
    }
}

/// What a person may be like.
fn person(error: &HumanError) -> String {
    match error {
        HumanError::Height { .. } => format!("a human figure is {} to {} m tall", HEIGHTS.0, HEIGHTS.1),
        HumanError::Mass { height, lower, upper, .. } => format!(
            "at a height of {height} m a human figure has {} to {} kg (body mass index {} to {} kg/m²)",
            (lower * 100.0 - 1e-6).ceil() / 100.0,
            (upper * 100.0 + 1e-6).floor() / 100.0,
            BODY_MASS_INDICES.0,
            BODY_MASS_INDICES.1
        ),
        HumanError::Age { .. } => "a child's proportions are known from 6 years on".to_owned(),
        other => other.to_string(),
    }
}
