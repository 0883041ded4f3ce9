//! Whose postures are asked for, and with which parameters.

use crate::args::{HEIGHT, key_options};
use crate::error::{CliError, typed};
use clap::ArgMatches;
use solaris::gait::determinants::{Determinants, KeyParameter, Proportions};
use solaris::gait::{KeyChoice, ThesisRequest};
use solaris::model::human;

/// Mass of the person whose lengths are asked: it changes none (kg/m²).
const BODY_MASS_INDEX: f64 = 23.8;

/// What the options come to.
pub(super) struct Asked {
    pub(super) determinants: Determinants,
    pub(super) proportions: Proportions,
    pub(super) parameters: Vec<KeyParameter>,
    pub(super) choice: KeyChoice,
    /// What a length is in.
    pub(super) unit: &'static str,
}

impl Asked {
    pub(super) fn of(matches: &ArgMatches) -> Result<Self, CliError> {
        let word = |name: &str| matches.get_one::<String>(name).map(String::as_str);
        let number = |name: &str| matches.get_one::<f64>(name).copied();
        let determinants =
            if word("determinants") == Some("3") { Determinants::Three } else { Determinants::Five };
        let height = number("height");
        let proportions = match word("body") {
            Some("fit") if height.is_some() => {
                let why = "the fitted proportions are in units of the leg and have no height; leave --height or --body fit out";
                return Err(option(matches, "height", why));
            }
            Some("fit") => Proportions::FIT,
            Some("thesis") => Proportions::drillis_contini(height.unwrap_or(HEIGHT)),
            _ => {
                let height = height.unwrap_or(HEIGHT);
                let person = human(height, BODY_MASS_INDEX * height * height);
                let person = person.map_err(|error| CliError::of_human(error, matches))?;
                Proportions::of(&person).map_err(|error| CliError::of_gait(error, matches))?
            }
        };
        let parameters = determinants.parameters(&proportions);
        let own = |name: &&str| parameters.iter().any(|parameter| parameter.name == *name);
        let given = || key_options().into_iter().filter(|name| typed(matches, name).is_some());
        if let Some(name) = given().find(|name| !own(name)) {
            let why = format!("{} determinants have no such parameter", determinants.count());
            return Err(option(matches, name, &why));
        }
        let others = given().filter(|name| *name != "step-length");
        let request = ThesisRequest {
            determinants,
            step_frequency: number("step-frequency"),
            step_length: number("step-length"),
            speed: number("speed"),
            parameters: others.filter_map(|name| Some((name, number(name)?))).collect(),
            ..ThesisRequest::default()
        };
        let choice =
            KeyChoice::of(&proportions, &request).map_err(|error| CliError::of_gait(error, matches))?;
        let unit = if word("body") == Some("fit") { "leg lengths" } else { "m" };
        Ok(Self { determinants, proportions, parameters, choice, unit })
    }

    /// What is to be said of lengths that are not in metres.
    pub(super) fn note(&self) -> String {
        if self.unit == "m" {
            String::new()
        } else {
            format!("\nnote: what is written in m is in {}: L₁ + L₂ is 1\n", self.unit)
        }
    }

    /// Speed of the walk, in the unit of length a second.
    pub(super) fn speed(&self) -> f64 {
        self.choice.step_length * self.choice.step_frequency / 60.0
    }

    /// The same in m/s: of lengths without a size, for a person of usual height.
    pub(super) fn metres_per_second(&self) -> f64 {
        self.speed() * self.proportions.unit
    }

    /// The speed as it is written, with its unit.
    pub(super) fn pace(&self) -> String {
        let metric = self.metres_per_second();
        if self.unit == "m" {
            return format!("{metric:.4} m/s");
        }
        let height = self.proportions.height * self.proportions.unit;
        let trunk = if self.determinants == Determinants::Five { ", by which the trunk moves" } else { "" };
        let speed = self.speed();
        format!("{speed:.4} {} a second: {metric:.4} m/s for a person of {height:.2} m{trunk}", self.unit)
    }

    /// In a few words.
    pub(super) fn title(&self) -> String {
        let frequency = (self.choice.step_frequency * 100.0).round() / 100.0;
        format!(
            "{} determinants at {frequency} steps/min",
            if self.determinants == Determinants::Three { "Three" } else { "Five" }
        )
    }
}

fn option(matches: &ArgMatches, option: &str, why: &str) -> CliError {
    let value = typed(matches, option).unwrap_or_default();
    CliError::Option { option: option.to_owned(), value, why: why.to_owned() }
}

/// A parameter and its value.
pub(super) fn value(parameter: &KeyParameter, value: f64) -> String {
    let decimals = if parameter.unit == "°" { 2 } else { 4 };
    format!("{:<20} {:<2} {value:>9.decimals$}{}", parameter.name, parameter.symbol, parameter.unit)
}
