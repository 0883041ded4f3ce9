//! How a walk gains its pace and loses it again: the first and last steps of a fast one are slower.

use crate::request::pace::Pace;

/// The fastest first and last step (steps/min).
pub(super) const ENDS: f64 = 110.0;
/// What a step may gain over the one before: up to the frequency of the ends, and above it (steps/min).
const GAIN: (f64, f64) = (20.0, 5.0);
/// How much longer than the one before a step above the frequency of the ends may be.
const LENGTHENING: f64 = 1.12;
/// What a step above the frequency of the ends may lose to the one after, towards the end (steps/min).
const LOSS: f64 = 10.0;

/// The paces of steps that gain and lose no more than they may, for step frequencies of this `tempo`; a step that is slower is shorter
/// by as much.
pub(super) fn eased(mut steps: Vec<Pace>, tempo: f64) -> Vec<Pace> {
    let (ends, loss, gain) = (ENDS * tempo, LOSS * tempo, (GAIN.0 * tempo, GAIN.1 * tempo));
    let limit = |pace: &mut Pace, most: f64| {
        if pace.step_frequency > most {
            pace.step_length *= most / pace.step_frequency;
            pace.step_frequency = most;
        }
    };
    let (mut most, mut longest) = (ends, f64::INFINITY);
    for pace in &mut steps {
        limit(pace, most);
        if pace.step_frequency > ends {
            pace.step_length = pace.step_length.min(longest);
        }
        most = (pace.step_frequency + gain.0).min(ends).max(pace.step_frequency + gain.1);
        longest = pace.step_length * LENGTHENING;
    }
    for (before_last, pace) in steps.iter_mut().rev().enumerate() {
        limit(pace, ends + loss * before_last as f64);
    }
    steps
}
