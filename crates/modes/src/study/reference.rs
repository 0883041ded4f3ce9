//! The answer that all others are compared with: the finest runs there are.

use super::compare::{Answer, each};
use super::outlook::Outlook;
use super::{StudyOptions, method_name, setting};
use crate::failure::{RunError, SetupError};
use crate::report::ErrorEstimate;
use crate::settings::{Method, Rule, Settings};
use crate::simulation::Simulation;
use solaris_model::{Figure, Motion};

/// Two right motions may be this far apart (rad or m) by rounding alone, and be the same.
const ATTAINABLE: f64 = 1e-9;

/// What the rows of a study are compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// What it is: a closed form, or a method with its step or tolerance.
    pub name: String,
    /// What its uncertainty was found against; empty for a closed form.
    pub beside: String,
    /// How well it is known, over all frames: nothing is off in a closed form, else the difference between the two. Over
    /// frames after [`super::Sensitivity::comparable_until`] it may be anything.
    pub uncertainty: ErrorEstimate,
}

/// The reference with its motion, and the run that it was held against.
pub(super) struct Found {
    pub(super) reference: Reference,
    /// None of a closed form.
    pub(super) motion: Option<Motion>,
    pub(super) beside: Option<Beside>,
    /// The time (s) up to which the two are within a tenth of the wanted error; infinite where they are to the end.
    pub(super) until: f64,
}

/// The second-best run.
pub(super) struct Beside {
    pub(super) method: Method,
    pub(super) motion: Motion,
}

/// A candidate.
struct Candidate {
    method: Method,
    motion: Motion,
}

/// Two candidates, and how far they are from each other.
#[derive(Clone, Copy)]
struct Pair {
    best: usize,
    beside: usize,
    error: ErrorEstimate,
    /// Until when they are together (s).
    until: f64,
}

impl Pair {
    /// Whether they are longer together, or as long and nearer: where motions part for good, how far says nothing.
    fn is_nearer(&self, other: &Self) -> bool {
        let (longer, shorter) = (self.until > other.until, self.until < other.until);
        longer || (!shorter && self.error.position < other.error.position)
    }
}

pub(super) fn find(
    simulation: &Simulation,
    settings: &Settings,
    options: &StudyOptions<'_>,
    observer: &mut Outlook<'_>,
) -> Result<Found, RunError> {
    if options.solution.is_some() {
        let name = "the closed form".to_owned();
        let reference = Reference { name, beside: String::new(), uncertainty: ErrorEstimate::default() };
        return Ok(Found { reference, motion: None, beside: None, until: f64::INFINITY });
    }
    let figure = simulation.figure();
    let mut candidates: Vec<Candidate> = Vec::new();
    let mut nearest: Option<Pair> = None;
    let mut failure = None;
    for ladder in ladders(settings, options) {
        let first = candidates.len();
        let mut last: Option<Pair> = None;
        for method in ladder {
            match simulation.run_observed(&Settings { method, ..settings.clone() }, observer) {
                Ok(run) => candidates.push(Candidate { method, motion: run.motion }),
                Err(RunError::Cancelled) => return Err(RunError::Cancelled),
                Err(RunError::Setup(SetupError::NotBuiltIn { .. })) => break,
                Err(error @ RunError::Setup(_)) => return Err(error),
                Err(error) => {
                    failure = Some(error);
                    continue;
                }
            }
            let newest = candidates.len() - 1;
            let pair =
                |other| pair(figure, &candidates, newest, other, (0.1 * options.wanted).max(ATTAINABLE));
            for found in (0..newest).map(pair) {
                if nearest.is_none_or(|nearest| found.is_nearer(&nearest)) {
                    nearest = Some(found);
                }
            }
            if newest == first {
                continue;
            }
            // Finer steps bring rounding only.
            let within = pair(newest - 1);
            let falls =
                |last: Pair| within.until > last.until || within.error.position < 0.5 * last.error.position;
            if !last.is_none_or(falls) || within.error.position < 1e-14 {
                break;
            }
            last = Some(within);
        }
    }
    let Some(pair) = nearest else {
        // A single run is no reference: nothing says how well it is known.
        let Candidate { method, motion } =
            candidates.pop().ok_or_else(|| failure.unwrap_or(RunError::Cancelled))?;
        let uncertainty = ErrorEstimate { position: f64::INFINITY, velocity: f64::INFINITY };
        let reference = Reference { name: named(method), beside: String::new(), uncertainty };
        return Ok(Found { reference, motion: Some(motion), beside: None, until: f64::INFINITY });
    };
    let [name, beside] = [pair.best, pair.beside].map(|index| named(candidates[index].method));
    let reference = Reference { name, beside, uncertainty: pair.error };
    let mut candidates: Vec<_> = candidates.into_iter().map(Some).collect();
    let beside = candidates[pair.beside].take().map(|Candidate { method, motion }| Beside { method, motion });
    let motion = candidates[pair.best].take().expect("another one than that beside it").motion;
    Ok(Found { reference, motion: Some(motion), beside, until: pair.until })
}

fn named(method: Method) -> String {
    format!("{}, {}", method_name(method), setting(method))
}

/// The runs that may be the reference, each ladder as far as it gets better.
fn ladders(settings: &Settings, options: &StudyOptions<'_>) -> Vec<Vec<Method>> {
    let rule = Rule::RungeKutta4;
    let longest = (1.0 / settings.rate).min(4e-3);
    let affordable =
        |step: f64| settings.duration / step * rule.evaluations() as f64 <= options.evaluations as f64;
    let steps = (0..12).map(|power| longest * 0.25_f64.powi(power)).take_while(|step| affordable(*step));
    vec![
        steps.map(|step| Method::Fixed { rule, step }).collect(),
        [1e-10, 1e-11, 1e-12].map(|tolerance| Method::Adaptive { tolerance }).into(),
        [1e-9, 1e-10, 1e-11].map(|tolerance| Method::Stiff { tolerance }).into(),
    ]
}

/// Two candidates, together as long as their positions are within `near` (rad or m).
fn pair(figure: &Figure, candidates: &[Candidate], best: usize, beside: usize, near: f64) -> Pair {
    let answer = Answer::Motion(&candidates[beside].motion);
    let mut error = ErrorEstimate::default();
    let (mut until, mut last) = (f64::INFINITY, 0.0);
    each(figure, &candidates[best].motion, &answer, |time, position, velocity| {
        if position > near && until.is_infinite() {
            until = last;
        }
        last = time;
        error.position = error.position.max(position);
        error.velocity = error.velocity.max(velocity);
    });
    Pair { best, beside, error, until }
}
