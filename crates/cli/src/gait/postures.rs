//! Whose postures are asked for, and with which parameters.

use crate::args::{HEIGHT, Number, PosturesArgs, Whose, key_options};
use crate::error::{CliError, Typed};
use solaris::gait::determinants::{Determinants, KeyParameter, KeySolution, Proportions};
use solaris::gait::{GaitError, KeyChoice, ThesisRequest};
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
    request: ThesisRequest,
}

impl Asked {
    pub(super) fn of(args: &PosturesArgs) -> Result<Self, CliError> {
        let determinants: Determinants = args.determinants.count.into();
        let proportions = proportions(args)?;
        let parameters = determinants.parameters(&proportions);
        let own = |name: &str| parameters.iter().any(|parameter| parameter.name == name);
        let given = || args.parameters.0.iter();
        let length = args.step_length.as_ref().filter(|_| key_options().contains(&"step-length"));
        let mut all = given().chain(length.map(|length| ("step-length", length)));
        if let Some((name, number)) = all.find(|(name, _)| !own(name)) {
            let why = format!("{} determinants have no such parameter", determinants.count());
            return Err(CliError::option(name, &number.typed, why));
        }
        let value = |number: &Option<Number>| number.as_ref().map(|number| number.value);
        let request = ThesisRequest {
            determinants,
            step_frequency: value(&args.step_frequency),
            step_length: value(&args.step_length),
            speed: value(&args.speed),
            parameters: given().map(|(name, number)| (name, number.value)).collect(),
            ..ThesisRequest::default()
        };
        let refuse = |error| CliError::of_gait(error, args);
        // Of what is refused, the values beside it that would do are tried.
        let choice = KeyChoice::of(&proportions, &request)
            .or_else(|_| KeyChoice::solve(&proportions, &request).map(|(choice, _)| choice))
            .map_err(refuse)?;
        let unit = if args.body == Whose::Fit { "leg lengths" } else { "m" };
        Ok(Self { determinants, proportions, parameters, choice, unit, request })
    }

    /// The postures, or why there are none.
    pub(super) fn solution(&self) -> Result<KeySolution, GaitError> {
        KeyChoice::solve(&self.proportions, &self.request).map(|(_, solution)| solution)
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

/// Whose postures.
fn proportions(args: &PosturesArgs) -> Result<Proportions, CliError> {
    let height = args.height.as_ref().map_or(HEIGHT, |height| height.value);
    match (args.body, &args.height) {
        (Whose::Fit, Some(height)) => {
            let why = "the fitted proportions are in units of the leg and have no height; leave --height or --body fit out";
            Err(CliError::option("height", &height.typed, why))
        }
        (Whose::Fit, None) => Ok(Proportions::FIT),
        (Whose::Thesis, _) => Ok(Proportions::drillis_contini(height)),
        (Whose::Human, _) => {
            let person = human(height, BODY_MASS_INDEX * height * height);
            let person = person.map_err(|error| CliError::of_human(error, args))?;
            Proportions::of(&person).map_err(|error| CliError::of_gait(error, args))
        }
    }
}

impl Typed for PosturesArgs {
    fn typed(&self, name: &str) -> Option<&str> {
        let number = match name {
            "height" => &self.height,
            "step frequency" => &self.step_frequency,
            "step length" | "step-length" => &self.step_length,
            "speed" => &self.speed,
            other => return Some(&self.parameters.0.get(other)?.typed),
        };
        number.as_ref().map(|number| number.typed.as_str())
    }

    fn pace(&self) -> Vec<(&'static str, &Number)> {
        let Self { step_frequency, step_length, speed, .. } = self;
        let all = [("step-frequency", step_frequency), ("step-length", step_length), ("speed", speed)];
        all.into_iter().filter_map(|(name, number)| Some((name, number.as_ref()?))).collect()
    }
}

/// A parameter and its value.
pub(super) fn value(parameter: &KeyParameter, value: f64) -> String {
    let decimals = if parameter.unit == "°" { 2 } else { 4 };
    format!("{:<20} {:<2} {value:>9.decimals$}{}", parameter.name, parameter.symbol, parameter.unit)
}
