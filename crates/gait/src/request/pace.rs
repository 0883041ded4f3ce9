//! The pace, of step frequency, step length and speed: any two decide the third.

use crate::error::RequestError;

/// Step length of people over height and step frequency, `S / (H · sf)` (min): `S = 0.0037·H·sf`. The thesis's law has
/// 0.004.
#[doc(alias = "walk ratio")]
#[doc(alias = "step length over cadence")]
pub const WALK_RATIO: f64 = 0.0037;

/// Step frequencies that the walk was tried at (steps/min).
#[doc(alias = "cadence")]
pub const STEP_FREQUENCY: (f64, f64) = (60.0, 130.0);
/// Part of people's step length by which it may be longer or shorter.
pub(crate) const STEP_LENGTH_MARGIN: f64 = 0.12;
/// Shortest step of a later part of a walk, as a part of people's.
pub(crate) const SHORTEST_STEP: f64 = 0.3;

/// The step frequency when nothing else is asked (steps/min).
#[doc(alias = "cadence")]
pub const DEFAULT_STEP_FREQUENCY: f64 = 110.0;

/// Step frequency (steps/min) and step length (m) from what was given of them and of the speed (m/s). What is left open follows
/// from `S = ratio·sf`, and with nothing given the frequency is the usual one.
///
/// # Errors
///
/// All three given.
pub(crate) fn settle(
    step_frequency: Option<f64>,
    step_length: Option<f64>,
    speed: Option<f64>,
    ratio: f64,
) -> Result<(f64, f64), RequestError> {
    Ok(match (step_frequency, step_length, speed) {
        (Some(step_frequency), Some(step_length), Some(speed)) => {
            return Err(RequestError::Overdetermined { step_frequency, step_length, speed });
        }
        (Some(frequency), Some(length), None) => (frequency, length),
        (Some(frequency), None, Some(speed)) => (frequency, 60.0 * speed / frequency),
        (None, Some(length), Some(speed)) => (60.0 * speed / length, length),
        (Some(frequency), None, None) => (frequency, ratio * frequency),
        (None, Some(length), None) => (length / ratio, length),
        // S = r·sf and v = S·sf/60.
        (None, None, Some(speed)) => {
            let frequency = (60.0 * speed / ratio).sqrt();
            (frequency, ratio * frequency)
        }
        (None, None, None) => (DEFAULT_STEP_FREQUENCY, ratio * DEFAULT_STEP_FREQUENCY),
    })
}

/// Step frequency (1/min) and step length (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pace {
    pub(crate) step_frequency: f64,
    pub(crate) step_length: f64,
}

/// How the step length follows the step frequency, for one person.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepLaw {
    /// Standing height (m).
    pub(crate) height: f64,
    /// Step length over step frequency (m min): of this person, and of adults overground of this tempo.
    pub(crate) ratio: f64,
    pub(crate) adult_ratio: f64,
    /// Step frequencies over those of adults.
    pub(crate) tempo: f64,
    /// Where no pace is asked for (steps/min).
    pub(crate) step_frequency: f64,
}

impl StepLaw {
    /// Of steps so many times as long.
    pub(crate) fn times(&self, factor: f64) -> Self {
        Self { ratio: self.ratio * factor, adult_ratio: self.adult_ratio * factor, ..*self }
    }
}

/// What is given of a pace.
pub(crate) struct Given {
    pub(crate) step_frequency: Option<f64>,
    pub(crate) step_length: Option<f64>,
    pub(crate) speed: Option<f64>,
}

impl Given {
    pub(crate) fn nothing(&self) -> bool {
        self.step_frequency.is_none() && self.step_length.is_none() && self.speed.is_none()
    }

    /// Step frequency and step length, in range; steps may be as short as `shortest` of people's.
    pub(crate) fn settle(&self, law: &StepLaw, shortest: f64) -> Result<Pace, RequestError> {
        let frequencies = (STEP_FREQUENCY.0 * law.tempo, STEP_FREQUENCY.1 * law.tempo);
        let given = [
            ("step frequency", self.step_frequency, " steps/min", frequencies),
            ("step length", self.step_length, " m", (0.01, 2.0)),
            ("speed", self.speed, " m/s", (0.01, 3.0)),
        ];
        for (name, value, unit, limits) in given {
            if let Some(value) = value {
                range(name, value, unit, limits, String::new)?;
            }
        }
        let StepLaw { height, ratio, adult_ratio, tempo, .. } = *law;
        let asked = if self.nothing() { Some(law.step_frequency) } else { self.step_frequency };
        let (step_frequency, step_length) = settle(asked, self.step_length, self.speed, ratio)?;
        range("step frequency", step_frequency, " steps/min", frequencies, || {
            "; slower and faster gaits are not this walk: the forces leave people's range".to_owned()
        })?;
        let default = ratio * step_frequency;
        // Steps that are longer than this person's are those of adults for longer.
        let longest = adult_ratio.max(ratio) * step_frequency;
        let (lower, upper) =
            (default * shortest, longest * (1.0 + longest_over_default(step_frequency / tempo)));
        if (lower * (1.0 - 1e-9)..=upper * (1.0 + 1e-9)).contains(&step_length) {
            return Ok(Pace { step_frequency, step_length });
        }
        let at = format!("at {} steps/min", tidy(step_frequency));
        let why = format!(
            " (people of {height} m take {default:.3} m; shorter or longer, forces and knees leave people's range)"
        );
        // The parameter that was given is the one to name.
        Err(match (self.step_length, self.speed) {
            (None, Some(value)) => {
                let (lower, upper) = (lower * step_frequency / 60.0, upper * step_frequency / 60.0);
                RequestError::StepLength { parameter: "speed", value, unit: " m/s", lower, upper, at, why }
            }
            _ => RequestError::StepLength {
                parameter: "step length",
                value: step_length,
                unit: " m",
                lower,
                upper,
                at,
                why,
            },
        })
    }
}

/// How much longer than people's a step may be: 12 %, falling to 2 % from 115 to 130 steps/min, where ten longer steps would
/// need friction that no sole has.
fn longest_over_default(step_frequency: f64) -> f64 {
    let (from, to) = (115.0, STEP_FREQUENCY.1);
    let past = ((step_frequency - from) / (to - from)).clamp(0.0, 1.0);
    STEP_LENGTH_MARGIN + (0.02 - STEP_LENGTH_MARGIN) * past
}

/// A number for people: four decimals at most.
pub(crate) fn tidy(number: f64) -> f64 {
    (number * 1e4).round() / 1e4
}

pub(crate) fn range(
    parameter: &'static str,
    value: f64,
    unit: &'static str,
    (lower, upper): (f64, f64),
    why: impl Fn() -> String,
) -> Result<(), RequestError> {
    if (lower..=upper).contains(&value) {
        Ok(())
    } else {
        // What a manner makes of a number has a dozen digits more; one just beyond the range keeps them.
        let short = tidy(value);
        let value = if short.is_finite() && !(lower..=upper).contains(&short) { short } else { value };
        Err(RequestError::Range { parameter, value, unit, lower, upper, why: why() })
    }
}
