//! `--from` and `--to`: how a run begins and ends.

use crate::args::value::number;
use solaris::gait::{RunEnd, RunWalk};
use solaris::model::nearest;

/// How a run begins or ends, and how it was typed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RunBound {
    pub(crate) end: RunEnd,
    pub(crate) typed: String,
}

/// What is wrong with a `--from` or a `--to`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum BoundError {
    #[error("it must be {}{hint}", HOW.join(", "))]
    Unknown { hint: String },
    #[error("'{item}': only walking has more, steps=N and speed=M/S, as in walking,steps=6,speed=1.4")]
    NotOfIt { item: String },
    #[error("{key}={value}: '{value}' is no number; write it such as walking,steps=6,speed=1.4")]
    NotANumber { key: String, value: String },
    #[error("steps={value}: it must be a whole number, 3 to 30")]
    Steps { value: String },
    #[error("{key} is given twice; drop one")]
    Twice { key: String },
}

const HOW: [&str; 3] = ["running", "standing", "walking"];

/// `running`, `standing`, or `walking,steps=6,speed=1.4`.
pub(super) fn parse(text: &str) -> Result<RunBound, BoundError> {
    let mut items = text.split([',', ' ']).filter(|item| !item.is_empty());
    let how = items.next().unwrap_or_default();
    let rest: Vec<&str> = items.collect();
    let end = match how {
        "running" => RunEnd::Running,
        "standing" => RunEnd::Standing,
        "walking" => RunEnd::Walking(walk(&rest)?),
        _ => {
            let begun = HOW.into_iter().find(|known| !how.is_empty() && known.starts_with(how));
            let near = begun.map(str::to_owned).or_else(|| nearest(how, HOW.into_iter()));
            let hint = near.map_or_else(String::new, |near| format!(" (did you mean '{near}'?)"));
            return Err(BoundError::Unknown { hint });
        }
    };
    match (end, rest.first()) {
        (RunEnd::Running | RunEnd::Standing, Some(item)) => {
            Err(BoundError::NotOfIt { item: (*item).to_owned() })
        }
        _ => Ok(RunBound { end, typed: text.to_owned() }),
    }
}

fn walk(items: &[&str]) -> Result<RunWalk, BoundError> {
    let (mut steps, mut speed) = (None, None);
    for item in items {
        let not_of_it = || BoundError::NotOfIt { item: (*item).to_owned() };
        let (key, value) = item.split_once('=').ok_or_else(not_of_it)?;
        let into = match key {
            "steps" => &mut steps,
            "speed" => &mut speed,
            _ => return Err(not_of_it()),
        };
        let number = number(value)
            .map_err(|_| BoundError::NotANumber { key: key.to_owned(), value: value.to_owned() })?;
        if into.replace(number).is_some() {
            return Err(BoundError::Twice { key: key.to_owned() });
        }
    }
    let usual = RunWalk::default();
    let whole = |steps: f64| {
        if steps.fract() == 0.0 && (0.0..1e9).contains(&steps) {
            Ok(steps as usize)
        } else {
            Err(BoundError::Steps { value: steps.to_string() })
        }
    };
    Ok(RunWalk { steps: steps.map_or(Ok(usual.steps), whole)?, speed })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walks_say_how_long_and_how_fast() {
        let of = |text: &str| parse(text).map(|bound| bound.end).map_err(|why| why.to_string());
        assert_eq!(of("running"), Ok(RunEnd::Running));
        assert_eq!(of("standing"), Ok(RunEnd::Standing));
        assert_eq!(of("walking"), Ok(RunEnd::Walking(RunWalk::default())));
        let walk = RunWalk { steps: 4, speed: Some(1.5) };
        assert_eq!(of("walking,speed=1.5,steps=4"), Ok(RunEnd::Walking(walk)));
        for (text, why) in [
            ("walk", "it must be running, standing, walking (did you mean 'walking'?)"),
            ("", "it must be running, standing, walking"),
            ("standing,steps=3", "'steps=3': only walking has more"),
            ("walking,turn=3", "'turn=3': only walking has more"),
            ("walking,6", "'6': only walking has more"),
            ("walking,speed=fast", "'fast' is no number"),
            ("walking,steps=2.5", "steps=2.5: it must be a whole number"),
            ("walking,steps=4,steps=5", "steps is given twice"),
        ] {
            let found = of(text).expect_err(text);
            assert!(found.contains(why), "{text}: {found}");
        }
    }
}
