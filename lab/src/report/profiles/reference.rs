//! The reference numbers of `fixtures/reference/profiles_hard.json`.

use crate::workspace::read;
use num_traits::Zero;
use serde::Deserialize;
use solaris_dynamics::scalar::DoubleDouble;

/// Parameters by the names of the file; those that a profile does not have are zero.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Parameters<F> {
    #[serde(rename = "T")]
    pub(super) duration: F,
    #[serde(rename = "th0")]
    pub(super) from: F,
    #[serde(rename = "th1")]
    pub(super) to: F,
    pub(super) v0: F,
    pub(super) v1: F,
    /// The exponent.
    pub(super) n: u16,
    /// The shape of the exponential.
    pub(super) s: F,
    #[serde(rename = "k")]
    pub(super) stiffness: F,
    #[serde(rename = "am")]
    pub(super) middle: F,
    #[serde(rename = "T1")]
    pub(super) third_time: F,
    #[serde(rename = "vm")]
    pub(super) third_velocity: F,
    #[serde(rename = "t0")]
    pub(super) start: F,
    #[serde(rename = "t1")]
    pub(super) end: F,
}

impl Parameters<f64> {
    /// In another kind of number, with `cast`.
    pub(super) fn map<F>(&self, cast: impl Fn(f64) -> F) -> Parameters<F> {
        Parameters {
            duration: cast(self.duration),
            from: cast(self.from),
            to: cast(self.to),
            v0: cast(self.v0),
            v1: cast(self.v1),
            n: self.n,
            s: cast(self.s),
            stiffness: cast(self.stiffness),
            middle: cast(self.middle),
            third_time: cast(self.third_time),
            third_velocity: cast(self.third_velocity),
            start: cast(self.start),
            end: cast(self.end),
        }
    }
}

/// A curve, times, and where it is at them.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Truth {
    name: String,
    profile: String,
    widths: Vec<u32>,
    #[serde(rename = "params")]
    pub(super) parameters: Parameters<f64>,
    #[serde(rename = "t")]
    pub(super) times: Vec<f64>,
    theta: Vec<String>,
    scale: Option<f64>,
}

/// All of the file.
#[derive(Debug, Deserialize)]
pub(super) struct Reference {
    cases: Vec<Truth>,
}

impl Reference {
    pub(super) fn read() -> Result<Self, String> {
        const PATH: &str = "fixtures/reference/profiles_hard.json";
        serde_json::from_str(&read(PATH)?).map_err(|error| format!("{PATH}: {error}"))
    }

    /// What is known of a case of a profile in numbers of so many bits.
    pub(super) fn get(&self, name: &str, profile: &str, width: u32) -> Option<&Truth> {
        let is_it =
            |case: &&Truth| case.name == name && case.profile == profile && case.widths.contains(&width);
        self.cases.iter().find(is_it)
    }

    /// The names of all cases, each once.
    #[cfg(test)]
    pub(super) fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = self.cases.iter().map(|case| case.name.as_str()).collect();
        names.dedup();
        names
    }
}

impl Truth {
    /// The worst error of what `found` gives at the times, as a share of the scale; infinite where it gives no number.
    pub(super) fn error(&self, found: impl Fn(f64) -> f64) -> f64 {
        let shares = self.times.iter().zip(&self.theta).map(|(t, theta)| {
            let [found, right, scale] =
                [enlarged(found(*t)), digits(theta), self.scale.map_or_else(|| digits(theta), enlarged)];
            ((found - right) / scale).abs().to_f64()
        });
        shares.fold(0.0, |worst, share| if share.is_finite() { share.max(worst) } else { f64::INFINITY })
    }
}

/// Times 2⁴⁰⁰, so that a number near the least one still has its digits.
fn enlarged(x: f64) -> DoubleDouble {
    let factor = DoubleDouble::from_f64(2.0_f64.powi(400));
    DoubleDouble::from_f64(x) * factor
}

/// A number written in decimal digits, such as `-1.25e-7`, times 2⁴⁰⁰.
fn digits(text: &str) -> DoubleDouble {
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let ten = DoubleDouble::from_f64(10.0);
    let mut value = DoubleDouble::zero();
    for digit in whole.chars().chain(fraction.chars()).filter_map(|c| c.to_digit(10)) {
        value = value * ten + DoubleDouble::from_f64(f64::from(digit));
    }
    value *= DoubleDouble::from_f64(2.0_f64.powi(400));
    let exponent = exponent.parse::<i32>().unwrap_or(0) - fraction.len() as i32;
    for _ in 0..exponent.abs() {
        value = if exponent < 0 { value / ten } else { value * ten };
    }
    if text.starts_with('-') { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_read_to_the_last() {
        for (text, right) in [("-1.25e-7", -1.25e-7), ("5.0", 5.0), ("2.5e+3", 2500.0)] {
            let relative = ((digits(text) - enlarged(right)) / enlarged(right)).abs().to_f64();
            assert!(relative < 1e-16, "{text}: {relative:e}");
        }
        // 0.1 as a double is 5.55e-18 more than 0.1.
        let difference = ((enlarged(0.1) - digits("0.1")) / digits("1")).to_f64();
        assert!((difference - 5.551_115_123_125_783e-18).abs() < 1e-30, "{difference:e}");
    }

    #[test]
    fn an_error_is_a_share_of_the_scale_and_infinite_where_there_is_no_number() {
        let truth = |scale| Truth {
            name: String::new(),
            profile: String::new(),
            widths: vec![64],
            parameters: Parameters::default(),
            times: vec![0.0, 1.0],
            theta: vec!["1.0".into(), "2.0".into()],
            scale,
        };
        assert!((truth(Some(4.0)).error(|t| t + 1.5) - 0.125).abs() < 1e-16);
        assert!((truth(None).error(|t| t + 1.5) - 0.5).abs() < 1e-16);
        assert!(truth(None).error(|t| if t > 0.0 { f64::NAN } else { 1.0 }).is_infinite());
    }
}
