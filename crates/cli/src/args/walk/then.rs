//! `--then`: what comes next in a walk.

use crate::args::value::number;
use solaris::gait::{Next, STEPS, WalkPart};
use solaris::model::nearest;

/// What comes next, and how it was typed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Then {
    pub(crate) what: Next,
    pub(crate) typed: String,
}

/// What is wrong with a `--then`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum ThenError {
    #[error("'{item}' is no KEY=NUMBER; write it such as steps=4,step-frequency=95 or stand=2")]
    NotAPair { item: String },
    #[error("there is no '{key}'{hint}; there are {} and {BACKWARD}", KEYS.join(", "))]
    UnknownKey { key: String, hint: String },
    #[error("{key}={value}: '{value}' is no number; between one KEY=NUMBER and the next stands a comma")]
    NotANumber { key: &'static str, value: String },
    #[error("{key} is given twice; give each once, and what comes later a --then of its own")]
    Twice { key: &'static str },
    #[error("stand goes alone; give the rest a --then of its own: --then stand={stand} --then {rest}")]
    StandWithOthers { stand: f64, rest: String },
    #[error("it does not say how far: add steps=N, as in steps=4,{given}")]
    NoExtent { given: String },
    #[error("it says nothing; write it such as steps=4,step-frequency=95 or stand=2")]
    Nothing,
    #[error("steps and distance say the same twice; drop one")]
    StepsAndDistance,
    #[error("steps={steps}: it must be a whole number, {} to {}", STEPS.0, STEPS.1)]
    Steps { steps: String },
}

const KEYS: [&str; 7] = ["steps", "distance", "stand", "step-frequency", "step-length", "speed", "turn"];

/// Says which way it goes, and has no number.
const BACKWARD: &str = "backward";

/// `stand=2`, or `steps=4,step-frequency=95,turn=15`.
pub(super) fn parse(text: &str) -> Result<Then, ThenError> {
    let mut values: [Option<(f64, &str)>; KEYS.len()] = [None; KEYS.len()];
    let items: Vec<&str> = text.split([',', ' ']).filter(|item| !item.is_empty()).collect();
    let mut backward = false;
    for item in &items {
        if *item == BACKWARD {
            backward = true;
            continue;
        }
        let (key, value) = item.split_once('=').ok_or(ThenError::NotAPair { item: (*item).to_owned() })?;
        // As the option is called, too.
        let said = if key == "cadence" { "step-frequency" } else { key };
        let index = KEYS.iter().position(|known| *known == said).ok_or_else(|| {
            let near = nearest(key, KEYS.into_iter().chain([BACKWARD]));
            let hint = near.map_or_else(String::new, |near| format!(" (did you mean '{near}'?)"));
            ThenError::UnknownKey { key: key.to_owned(), hint }
        })?;
        let key = KEYS[index];
        let number = number(value).map_err(|_| ThenError::NotANumber { key, value: value.to_owned() })?;
        if values[index].replace((number, value)).is_some() {
            return Err(ThenError::Twice { key });
        }
    }
    let what = travel(values, backward, &items)?;
    Ok(Then { what, typed: text.to_owned() })
}

fn travel(
    values: [Option<(f64, &str)>; KEYS.len()],
    backward: bool,
    items: &[&str],
) -> Result<Next, ThenError> {
    let [steps, distance, stand, step_frequency, step_length, speed, turn] = values;
    if let Some((stand, _)) = stand {
        if items.len() == 1 {
            return Ok(Next::Stand(stand));
        }
        let rest: Vec<&str> = items.iter().copied().filter(|item| !item.starts_with("stand=")).collect();
        return Err(ThenError::StandWithOthers { stand, rest: rest.join(",") });
    }
    let value = |given: Option<(f64, &str)>| given.map(|(value, _)| value);
    let part = WalkPart {
        steps: 0,
        step_frequency: value(step_frequency),
        step_length: value(step_length),
        speed: value(speed),
        turn: value(turn).unwrap_or_default().to_radians(),
        backward,
    };
    match (steps, distance) {
        (Some((steps, _)), None) if steps.fract() == 0.0 && (1.0..=STEPS.1 as f64).contains(&steps) => {
            Ok(Next::Steps(WalkPart { steps: steps as usize, ..part }))
        }
        (Some((_, typed)), None) => Err(ThenError::Steps { steps: typed.to_owned() }),
        (None, Some((distance, _))) => Ok(Next::Distance(distance, part)),
        (None, None) if items.is_empty() => Err(ThenError::Nothing),
        (None, None) => Err(ThenError::NoExtent { given: items.join(",") }),
        (Some(_), Some(_)) => Err(ThenError::StepsAndDistance),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_said_so_that_it_can_be_followed() {
        let said = |text: &str| parse(text).map(|then| then.what).map_err(|error| error.to_string());
        assert_eq!(said("stand=2"), Ok(Next::Stand(2.0)));
        assert_eq!(said("cadence=95,steps=4"), said("steps=4 step-frequency=95"));
        let refused = [
            ("3", "'3' is no KEY=NUMBER; write it such as steps=4,step-frequency=95 or stand=2"),
            ("stand=2,backward", "--then stand=2 --then backward"),
            ("backward", "add steps=N, as in steps=4,backward"),
            ("step=3", "there is no 'step' (did you mean 'steps'?); there are"),
            ("steps=3;turn=20", "steps=3;turn=20: '3;turn=20' is no number; between one"),
            ("speed=nan,steps=2", "speed=nan: 'nan' is no number"),
            ("stand=2,steps=3,turn=5", "--then stand=2 --then steps=3,turn=5"),
            ("turn=15", "add steps=N, as in steps=4,turn=15"),
            ("steps=2.5", "steps=2.5: it must be a whole number, 1 to 10000"),
            ("steps=0", "it must be a whole number"),
            ("", "it says nothing"),
        ];
        for (text, why) in refused {
            let found = said(text).expect_err(text);
            assert!(found.contains(why), "{text}: {found}");
        }
    }
}
