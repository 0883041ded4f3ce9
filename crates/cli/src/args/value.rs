//! Values of options: numbers as they were typed, and what is wrong with them.

use crate::words::{at_least, at_most};
use std::str::FromStr;

/// A number, and how it was typed. NaN is none; infinite ones are numbers, and out of most ranges.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Number {
    pub(crate) value: f64,
    pub(crate) typed: String,
}

/// What is wrong with a value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum ValueError {
    #[error("it must be a number")]
    NotANumber,
    #[error("it must be a whole number")]
    NotWhole,
    /// A number that can be read, and is not one of those that the option takes.
    #[error("it must be {} to {}{unit}", at_least(*lower), at_most(*upper))]
    OutOfRange {
        option: &'static str,
        typed: String,
        lower: f64,
        upper: f64,
        /// With a space before it, or nothing.
        unit: &'static str,
    },
}

impl FromStr for Number {
    type Err = ValueError;

    fn from_str(text: &str) -> Result<Self, ValueError> {
        Ok(Self { value: number(text)?, typed: text.to_owned() })
    }
}

/// A number; NaN is none.
pub(super) fn number(text: &str) -> Result<f64, ValueError> {
    text.parse().ok().filter(|number: &f64| !number.is_nan()).ok_or(ValueError::NotANumber)
}

/// Reads numbers of a range, in a unit.
pub(super) fn within(
    option: &'static str,
    lower: f64,
    upper: f64,
    unit: &'static str,
) -> impl Fn(&str) -> Result<f64, ValueError> + Clone + Send + Sync + 'static {
    move |text| {
        let value = number(text)?;
        if (lower..=upper).contains(&value) {
            return Ok(value);
        }
        Err(ValueError::OutOfRange { option, typed: text.to_owned(), lower, upper, unit })
    }
}

/// Reads whole numbers of a range; one that is too large to be held is out of it.
pub(super) fn count(
    option: &'static str,
    lower: usize,
    upper: usize,
) -> impl Fn(&str) -> Result<usize, ValueError> + Clone + Send + Sync + 'static {
    move |text| {
        let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(ValueError::NotWhole);
        }
        let value: Option<usize> = text.parse().ok().filter(|value| (lower..=upper).contains(value));
        let (typed, lower, upper) = (text.to_owned(), lower as f64, upper as f64);
        value.ok_or(ValueError::OutOfRange { option, typed, lower, upper, unit: "" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_kept_as_they_were_typed() {
        let read = |text: &str| text.parse::<Number>();
        assert_eq!(read("1e400").map(|number| number.typed), Ok("1e400".to_owned()));
        assert_eq!(read("-1.50").map(|number| number.value), Ok(-1.5));
        assert_eq!([read("nan"), read("1,75"), read("")].map(Result::ok), [None, None, None]);
    }

    #[test]
    fn counts_beyond_any_integer_are_out_of_range() {
        let steps = count("steps", 1, 10_000);
        assert_eq!(steps("10000"), Ok(10_000));
        assert_eq!(steps("1.5"), Err(ValueError::NotWhole));
        for text in ["0", "-3", "10001", "99999999999999999999"] {
            let said = steps(text).map_err(|error| error.to_string());
            assert_eq!(said, Err("it must be 1 to 10000".to_owned()), "{text}");
        }
    }
}
