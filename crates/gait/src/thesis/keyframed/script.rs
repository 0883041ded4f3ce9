//! The script of a keyframed walk, and its phases laid out in time and along the ground.

use super::options::KeyframedOptions;
use super::phase::Phase;
use crate::error::{GaitError, PostureError, RequestError};
use crate::thesis::determinants::{KeyPhase, KeyPosture, Proportions};
use solaris_profiles::step;
use std::f64::consts::PI;

/// The phases of a cycle, and how long each lasts.
#[derive(Clone, Debug, PartialEq)]
pub struct ScriptCycle {
    /// Its phases.
    pub phases: Vec<KeyPhase>,
    /// Parts of a step's time, one a phase.
    pub parts: Vec<f64>,
}

/// A walk's cycles and steps.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyScript {
    /// From standing; then as often as needed from step to step; to standing.
    pub cycles: [ScriptCycle; 3],
    /// Number of steps, without the closing one.
    pub steps: usize,
    /// From one heel print to the other foot's next (m).
    pub step_length: f64,
    /// Duration of a step (s).
    pub step_time: f64,
}

impl KeyScript {
    pub(super) fn check(&self, options: &KeyframedOptions, leg: f64) -> Result<(), GaitError> {
        let fits = |cycle: &ScriptCycle| cycle.phases.len() == cycle.parts.len() && !cycle.phases.is_empty();
        if self.steps == 0 || !self.cycles.iter().all(fits) {
            return Err(PostureError::EmptyScript.into());
        }
        let parts = self.cycles.iter().flat_map(|cycle| cycle.parts.iter().map(|part| ("part", *part)));
        let rest = [
            ("step length", self.step_length),
            ("step time", self.step_time),
            ("step width", options.step_width.unwrap_or(1.0)),
        ];
        let bad = parts.chain(rest).find(|(_, value)| !(value.is_finite() && *value > 0.0));
        let swings = [("sway", options.sway), ("clearance", options.clearance)];
        let bad = bad.or(swings.into_iter().find(|(_, value)| !(value.is_finite() && *value >= 0.0)));
        if let Some((name, value)) = bad {
            return Err(PostureError::ScriptNumber { name, value }.into());
        }
        let wide =
            [("sway", options.sway, 0.25 * leg), ("step width", options.step_width.unwrap_or(0.0), leg)];
        match wide.into_iter().find(|(_, value, upper)| value > upper) {
            Some((parameter, value, upper)) => {
                let (lower, why) = (0.0, "; farther to the side no leg reaches its foot".to_owned());
                let upper = (1e3 * upper).floor() / 1e3;
                Err(RequestError::Range { parameter, value, unit: " m", lower, upper, why }.into())
            }
            None => Ok(()),
        }
    }
}

/// All phases, from `start` (s) on, and the heel prints that they make (m).
///
/// Both feet stand with their heels at 0 first.
pub(super) fn laid_out(
    p: &Proportions,
    script: &KeyScript,
    options: &KeyframedOptions,
    start: f64,
) -> (Vec<Phase>, Vec<f64>) {
    let (mut phases, mut prints) = (Vec::new(), Vec::with_capacity(script.steps + 1));
    let (mut stance, mut heels, mut time) = (usize::from(options.left_first), [0.0; 2], start);
    let mut from = KeyPosture { name: "standing", ..KeyPosture::default() };
    for cycle in 0..=script.steps {
        let kind = if cycle == 0 { 0 } else { 1 + usize::from(cycle == script.steps) };
        if cycle > 0 {
            // The foot that swung stands from now on, a step ahead of the other.
            stance = 1 - stance;
            heels[stance] = cycle as f64 * script.step_length;
            prints.push(heels[stance]);
            from = from.exchanged();
        }
        let ScriptCycle { phases: of, parts } = &script.cycles[kind];
        for (phase, part) in of.iter().zip(parts) {
            let duration = part * script.step_time;
            let span = (time, duration);
            phases.push(Phase::new(p, options, span, stance, heels, phase.root, (from, phase.end)));
            time += duration;
            from = phase.end;
        }
    }
    prints.push(heels[stance]);
    (phases, prints)
}

/// The pelvis' way to the sides: the sixth determinant.
///
/// ```text
/// x(t) = ± A·sin(π (t − t_m)/T)      towards the standing foot; t_m in the middle of a double support
/// ```
#[derive(Clone, Copy, Debug)]
pub(super) struct Sway {
    amplitude: f64,
    middle: f64,
    step_time: f64,
    span: (f64, f64),
}

impl Sway {
    pub(super) fn new(options: &KeyframedOptions, script: &KeyScript, phases: &[Phase]) -> Self {
        let (first, last) = (&phases[0], &phases[phases.len() - 1]);
        // The first after the starting cycle.
        let later = &phases[script.cycles[0].phases.len()..];
        let double = later.iter().find(|phase| phase.is_double_support()).unwrap_or(last);
        let left_stands = double.stance == 0;
        Self {
            amplitude: if left_stands { options.sway } else { -options.sway },
            middle: double.start + 0.5 * double.duration,
            step_time: script.step_time,
            span: (first.start, last.start + last.duration),
        }
    }

    /// To the left (m): it grows over the first step and dies away over the last.
    pub(super) fn at(&self, t: f64) -> f64 {
        let envelope = |x: f64| step::quintic((x / self.step_time).clamp(0.0, 1.0)).position;
        let swing = (PI * (t - self.middle) / self.step_time).sin();
        self.amplitude * swing * envelope(t - self.span.0) * envelope(self.span.1 - t)
    }
}
