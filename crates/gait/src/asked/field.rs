//! One number of the options, by its name: where it stands, in which range, and what it is where it is left out.

use super::judge::Judge;
use super::options::{GaitKind, GaitOptions};
use super::request::unknown;
use crate::error::RequestError;
use crate::request::{
    CANE_LOAD, CANE_LOADS, DEFAULT_RUN_SPEED, MOST_VARIABILITY, RUN_SPEED, STEP_FREQUENCY, Stairs, TURN,
    WalkRequest,
};
use crate::smooth::{PARAMETERS, Parameter, step_length_on_slope};
use crate::thesis::THESIS_STEP_FREQUENCY;
use crate::thesis::determinants::Determinants;

/// Slopes, risers and treads that are looked at (rad, m): steeper ground than a foot finds a place on.
const SLOPES: [f64; 2] = [-0.35, 0.35];
const RISES: [f64; 2] = [-0.3, 0.3];
const TREADS: [f64; 2] = [0.15, 0.6];
/// Step lengths (m) and speeds (m/s) that are looked at.
const LENGTHS: [f64; 2] = [0.01, 2.0];
const SPEEDS: [f64; 2] = [0.01, 3.0];

/// A number of the options.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Field {
    StepFrequency,
    StepLength,
    Speed,
    Turn,
    Slope,
    Variability,
    CaneLoad,
    Rise,
    Tread,
    /// A number of the style.
    Style(&'static str),
}

/// The names of those that are no numbers of the style.
const NAMES: [(&str, Field); 9] = [
    ("step-frequency", Field::StepFrequency),
    ("step-length", Field::StepLength),
    ("speed", Field::Speed),
    ("turn", Field::Turn),
    ("slope", Field::Slope),
    ("variability", Field::Variability),
    ("cane-load", Field::CaneLoad),
    ("stairs.rise", Field::Rise),
    ("stairs.tread", Field::Tread),
];

impl Field {
    /// By its name, with `_` or `-`; numbers of the style also as `style.arm_swing`.
    pub(super) fn named(name: &str, judge: &Judge<'_>, options: &GaitOptions) -> Result<Self, RequestError> {
        let dashed = name.replace('_', "-");
        if let Some((_, field)) = NAMES.iter().find(|(known, _)| *known == dashed) {
            return Ok(*field);
        }
        let style = style_names(judge, options);
        let bare = dashed.strip_prefix("style.").unwrap_or(&dashed);
        let found = style.iter().find(|(known, _)| *known == bare);
        let known = || NAMES.iter().map(|(known, _)| *known).chain(style.iter().map(|(known, _)| *known));
        found
            .map(|(known, _)| Self::Style(known))
            .ok_or_else(|| unknown("number of the options", name, &known()))
    }

    /// Its value, where it is given.
    pub(super) fn given(self, options: &GaitOptions) -> Option<f64> {
        match self {
            Self::StepFrequency => options.step_frequency,
            Self::StepLength => options.step_length,
            Self::Speed => options.speed,
            Self::Turn => Some(options.turn),
            Self::Slope => options.slope,
            Self::Variability => options.variability,
            Self::CaneLoad => options.cane_load,
            Self::Rise => options.stairs?.rise,
            Self::Tread => options.stairs?.tread,
            Self::Style(name) => options
                .style
                .iter()
                .find(|(known, _)| known.replace('_', "-") == name)
                .map(|(_, value)| *value),
        }
    }

    /// The same options with this value of it.
    pub(super) fn set(self, options: &GaitOptions, value: f64) -> GaitOptions {
        let mut options = options.clone();
        match self {
            Self::StepFrequency => options.step_frequency = Some(value),
            Self::StepLength => options.step_length = Some(value),
            Self::Speed => options.speed = Some(value),
            Self::Turn => options.turn = value,
            Self::Slope => options.slope = Some(value),
            Self::Variability => options.variability = Some(value),
            Self::CaneLoad => options.cane_load = Some(value),
            Self::Rise => options.stairs.get_or_insert_default().rise = Some(value),
            Self::Tread => options.stairs.get_or_insert_default().tread = Some(value),
            Self::Style(name) => {
                options.style.retain(|known, _| known.replace('_', "-") != name);
                options.style.insert(name.to_owned(), value);
            }
        }
        options
    }

    /// Least and greatest value that there may be of it, whoever walks how.
    pub(super) fn declared(self, judge: &Judge<'_>, options: &GaitOptions) -> [f64; 2] {
        let is_thesis = options.determinants.is_some();
        match self {
            Self::StepFrequency if is_thesis => THESIS_STEP_FREQUENCY.into(),
            Self::StepFrequency => {
                let tempo = Judge::population(options).tempo(judge.body.height);
                [STEP_FREQUENCY.0 * tempo, STEP_FREQUENCY.1 * tempo]
            }
            Self::StepLength => LENGTHS,
            Self::Speed if options.gait == GaitKind::Run => RUN_SPEED.into(),
            Self::Speed => SPEEDS,
            Self::Turn => [-TURN, TURN],
            Self::Slope => SLOPES,
            Self::Variability => [0.0, MOST_VARIABILITY],
            Self::CaneLoad => CANE_LOADS.into(),
            Self::Rise => RISES,
            Self::Tread => TREADS,
            Self::Style(name) => {
                let all = style_names(judge, options);
                let found = all.iter().find(|(known, _)| *known == name);
                found.map_or([0.0, 0.0], |(_, (lower, upper))| [*lower, *upper])
            }
        }
    }

    /// What it is where it is left out; none where that follows from more than the request's numbers.
    pub(super) fn usual(self, judge: &Judge<'_>, options: &GaitOptions) -> Option<f64> {
        let stairs = Stairs::default();
        match self {
            Self::Turn | Self::Slope | Self::Variability => Some(0.0),
            Self::CaneLoad => judge.body.cane.map(|_| CANE_LOAD),
            Self::Rise => Some(stairs.rise),
            Self::Tread => Some(stairs.tread),
            Self::Speed if options.gait == GaitKind::Run => Some(DEFAULT_RUN_SPEED),
            Self::StepFrequency | Self::StepLength | Self::Speed | Self::Style(_) => {
                let style = judge.style(options, &WalkRequest::default())?;
                let on_slope = options.slope.map_or(1.0, step_length_on_slope);
                Some(match self {
                    Self::StepFrequency => style.step_frequency,
                    Self::StepLength => on_slope * style.step_length,
                    Self::Speed => on_slope * style.step_length * style.step_frequency / 60.0,
                    Self::Style(name) => Parameter::named(name)?.get(&style),
                    _ => return None,
                })
            }
        }
    }
}

/// The numbers of the style that the options may have, with their ranges.
fn style_names(judge: &Judge<'_>, options: &GaitOptions) -> Vec<(&'static str, (f64, f64))> {
    let known =
        options.determinants.and_then(|count| Determinants::ALL.into_iter().find(|d| d.count() == count));
    match known {
        Some(determinants) => {
            let all = determinants.parameters(&judge.proportions());
            all.iter().map(|parameter| (parameter.name, parameter.range)).collect()
        }
        None => PARAMETERS.iter().map(|parameter| (parameter.name, parameter.range)).collect(),
    }
}
