//! A walk in either style, or a run, with its forces.

mod forces;

pub use forces::{Pull, WalkForces};

use crate::body::FEET;
use crate::error::{GaitError, PlanError};
use crate::measure::{SteadyRun, measure_run};
use crate::request::{RunRequest, STEP_FREQUENCY, WalkRequest};
use crate::running::{RunPlan, run};
use crate::smooth::{WalkPlan, WalkSegment, WalkSequence, walk};
use crate::thesis::{THESIS_STEP_FREQUENCY, ThesisRequest, ThesisWalk, thesis_walk};
use crate::walking::Prescribing;
use solaris_analysis::ground::{Split, reactions_of_planted};
use solaris_analysis::{SupportLaw, ground_reactions, prescribed_reactions};
use solaris_model::{Figure, Motion, Trajectory as _};

/// A request in one of the two styles, or of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum StyledRequest {
    /// Forces first, as people walk.
    Smooth(WalkRequest),
    /// The same, with standing still in between.
    Sequence(Vec<WalkSegment>),
    /// Through key postures.
    Thesis(ThesisRequest),
    /// A run.
    Run(RunRequest),
}

impl StyledRequest {
    /// See [`WalkRequest::helped_foot_first`].
    #[must_use]
    pub fn helped_foot_first(self, figure: &Figure) -> Self {
        match self {
            Self::Smooth(request) => Self::Smooth(request.helped_foot_first(figure)),
            Self::Sequence(segments) => Self::Sequence(
                segments.into_iter().map(|segment| segment.helped_foot_first(figure)).collect(),
            ),
            other => other,
        }
    }

    /// The request of somebody of this stature (m) at the step frequency (steps/min) next to its own at which a stride lasts a whole number of frames of `rate` a second;
    /// none where it does so already, and of a run, whose step frequency follows from its speed.
    ///
    /// ```text
    /// N = 120·rate/f frames a stride of two steps, rounded;  f = 120·rate/N
    /// ```
    pub fn in_step(&self, stature: f64, step_frequency: f64, rate: f64) -> Option<Self> {
        let (lower, upper) = match self {
            Self::Smooth(walk) => {
                let tempo = walk.population.tempo(stature);
                (STEP_FREQUENCY.0 * tempo, STEP_FREQUENCY.1 * tempo)
            }
            Self::Thesis(_) => THESIS_STEP_FREQUENCY,
            // A run's step frequency follows from its speed.
            Self::Sequence(_) | Self::Run(_) => return None,
        };
        let frames = (120.0 * rate / step_frequency).round();
        let mut fitted = [frames, frames + 1.0, frames - 1.0].into_iter().map(|count| 120.0 * rate / count);
        let fitted = fitted.find(|fitted| (lower..=upper).contains(fitted))?;
        if (fitted - step_frequency).abs() <= 1e-9 * step_frequency {
            return None;
        }
        let mut request = self.clone();
        let (frequency, length, speed) = match &mut request {
            Self::Smooth(walk) => (&mut walk.step_frequency, &walk.step_length, &mut walk.speed),
            Self::Thesis(walk) => (&mut walk.step_frequency, &walk.step_length, &mut walk.speed),
            Self::Sequence(_) | Self::Run(_) => return None,
        };
        // Two of the three decide: of length and speed, the length stays.
        if length.is_some() {
            *speed = None;
        }
        *frequency = Some(fitted);
        Some(request)
    }
}

/// A plan in one of the two styles, or of a run.
pub enum StyledPlan {
    /// Forces first.
    Smooth(Box<WalkPlan>),
    /// The same, with standing still in between.
    Sequence(Box<WalkSequence>),
    /// Through key postures.
    Thesis(Box<ThesisWalk>),
    /// A run.
    Run(Box<RunPlan>),
}

impl StyledPlan {
    /// Plans a walk.
    ///
    /// # Errors
    ///
    /// Those of [`walk`], [`thesis_walk`] and [`run`].
    pub fn of(figure: &Figure, request: &StyledRequest) -> Result<Self, GaitError> {
        Ok(match request {
            StyledRequest::Smooth(request) => Self::Smooth(Box::new(walk(figure, request)?)),
            StyledRequest::Sequence(segments) => {
                Self::Sequence(Box::new(WalkSequence::new(figure, segments)?))
            }
            StyledRequest::Thesis(request) => Self::Thesis(Box::new(thesis_walk(figure, request)?)),
            StyledRequest::Run(request) => Self::Run(Box::new(run(figure, request)?)),
        })
    }

    /// The same, with so much of its manner and of its variability as holds: how much that is and why, where it is not all.
    ///
    /// # Errors
    ///
    /// Those of [`Self::of`], but for [`PlanError::OnlyPart`].
    #[expect(clippy::type_complexity, reason = "a plan, and a part with its reason")]
    pub fn as_far_as_it_holds(
        figure: &Figure,
        request: &StyledRequest,
    ) -> Result<(Self, Option<(f64, Box<GaitError>)>), GaitError> {
        match (Self::of(figure, request), request) {
            (Err(GaitError::Plan(PlanError::OnlyPart { part, why })), StyledRequest::Smooth(walk)) => {
                let plan = Self::of(figure, &StyledRequest::Smooth(walk.in_part(part)))?;
                Ok((plan, Some((part, why))))
            }
            (found, _) => Ok((found?, None)),
        }
    }

    /// What it is called: `smooth`, `thesis` or `run`.
    pub fn style_name(&self) -> &'static str {
        match self {
            Self::Smooth(_) | Self::Sequence(_) => "smooth",
            Self::Thesis(_) => "thesis",
            Self::Run(_) => "run",
        }
    }

    /// The first walk that is smooth.
    pub fn smooth(&self) -> Option<&WalkPlan> {
        match self {
            Self::Smooth(plan) => Some(plan),
            Self::Sequence(sequence) => Some(sequence.first()),
            Self::Thesis(_) | Self::Run(_) => None,
        }
    }

    /// Which way it points at its end, to the left of z (rad).
    pub fn heading(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.destination().1,
            Self::Sequence(sequence) => sequence.destination().1,
            Self::Thesis(_) | Self::Run(_) => 0.0,
        }
    }

    /// Steps a minute of the steady part, of the first walk of a sequence.
    pub fn step_frequency(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.style().step_frequency,
            Self::Sequence(sequence) => sequence.first().style().step_frequency,
            Self::Thesis(plan) => plan.step_frequency,
            Self::Run(plan) => plan.style().step_frequency(),
        }
    }

    /// Length of a step of the steady part, of the first walk of a sequence (m).
    pub fn step_length(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.style().step_length,
            Self::Sequence(sequence) => sequence.first().style().step_length,
            Self::Thesis(plan) => plan.step_length,
            Self::Run(plan) => plan.style().step_length,
        }
    }

    /// The standing height that the laws scale with (m).
    pub fn stature(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.stature(),
            Self::Sequence(sequence) => sequence.first().stature(),
            Self::Thesis(plan) => plan.proportions.height,
            Self::Run(plan) => plan.stature(),
        }
    }

    /// How long it lasts (s).
    pub fn duration(&self) -> f64 {
        match self {
            Self::Smooth(plan) => plan.duration(),
            Self::Sequence(sequence) => sequence.duration(),
            Self::Thesis(plan) => plan.walk.duration(),
            Self::Run(plan) => plan.duration(),
        }
    }

    /// The walk or run sampled `rate` times a second, with the ground's and the joints' forces.
    ///
    /// # Errors
    ///
    /// A rate that is none, another figure than the plan's, and what the kernel refuses.
    pub fn loaded(&self, figure: &Figure, rate: f64) -> Result<(Motion, WalkForces), GaitError> {
        match self {
            Self::Smooth(plan) => prescribed(figure, plan.motion(figure, rate)?, plan.as_ref()),
            Self::Sequence(plan) => prescribed(figure, plan.motion(figure, rate)?, plan.as_ref()),
            Self::Thesis(plan) => needed(figure, plan.walk.motion(figure, rate)?),
            Self::Run(plan) => lawful(figure, plan.motion(figure, rate)?, plan.as_ref()),
        }
    }

    /// A steady stride of a run, from a left contact on, measured; none of a walk.
    ///
    /// # Errors
    ///
    /// As [`Self::loaded`].
    pub fn steady_run(&self, figure: &Figure) -> Result<Option<SteadyRun>, GaitError> {
        let Self::Run(run) = self else { return Ok(None) };
        let stride = Self::Run(Box::new(RunPlan::new(run.stride().clone(), 2, true)));
        let (stride, _) = stride.loaded_stride(figure, 1.0 / run.resolution())?;
        measure_run(figure, &stride).map(Some)
    }

    /// One stride of it that repeats itself, sampled at the rate next to `rate` that has a whole number of frames, with forces.
    ///
    /// # Errors
    ///
    /// As [`Self::loaded`], and [`PlanError::NoStride`] for a walk that is too short: 42 steps, six, or two of a run.
    pub fn loaded_stride(&self, figure: &Figure, rate: f64) -> Result<(Motion, WalkForces), GaitError> {
        match self {
            Self::Smooth(plan) => {
                let stride = plan.stride_loop().ok_or(PlanError::NoStride { least: 42 })?;
                prescribed(figure, stride.balanced_motion(figure, rate)?, &stride)
            }
            Self::Sequence(_) => Err(PlanError::NoStride { least: 42 }.into()),
            Self::Thesis(plan) => {
                let stride = plan.walk.stride_loop().ok_or(PlanError::NoStride { least: 6 })?;
                needed(figure, stride.motion(figure, rate)?)
            }
            Self::Run(plan) => {
                let none =
                    if plan.changes() { PlanError::StepsDiffer } else { PlanError::NoStride { least: 2 } };
                let stride = plan.stride_loop().ok_or(none)?;
                lawful(figure, stride.balanced_motion(figure, rate)?, &stride)
            }
        }
    }
}

fn prescribed(
    figure: &Figure,
    mut motion: Motion,
    law: &impl SupportLaw,
) -> Result<(Motion, WalkForces), GaitError> {
    let report = ground_reactions(figure, &mut motion, FEET, law)?;
    Ok((motion, WalkForces::Prescribed(report)))
}

fn lawful(
    figure: &Figure,
    mut motion: Motion,
    law: &impl Prescribing,
) -> Result<(Motion, WalkForces), GaitError> {
    let residual = prescribed_reactions(figure, &mut motion, FEET, |time| law.contacts(time))?;
    Ok((motion, WalkForces::Law(residual)))
}

fn needed(figure: &Figure, mut motion: Motion) -> Result<(Motion, WalkForces), GaitError> {
    let (report, residual) = reactions_of_planted(figure, &mut motion, Split::default())?;
    Ok((motion, WalkForces::Needed(Box::new(report), residual)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stride_is_a_whole_number_of_frames() {
        for (frequency, rate) in [(110.0, 30.0), (95.0, 24.0), (130.0, 30.0), (60.0, 25.0), (111.3, 60.0)] {
            let request = StyledRequest::Smooth(WalkRequest { speed: Some(1.2), ..WalkRequest::default() });
            let Some(StyledRequest::Smooth(walk)) = request.in_step(1.75, frequency, rate) else { continue };
            let fitted = walk.step_frequency.expect("a step frequency");
            let frames = 120.0 * rate / fitted;
            assert!((frames - frames.round()).abs() < 1e-9, "{frequency} {rate}: {frames}");
            assert!((60.0..=130.0).contains(&fitted) && (fitted / frequency - 1.0).abs() < 0.04, "{fitted}");
            assert_eq!(walk.speed, Some(1.2));
        }
    }

    #[test]
    fn a_stride_that_fits_stays() {
        let request = StyledRequest::Smooth(WalkRequest::default());
        assert!(request.in_step(1.75, 120.0, 30.0).is_none());
    }

    #[test]
    fn a_quick_child_is_fitted_too() {
        let population = crate::Population::Child;
        let request = StyledRequest::Smooth(WalkRequest { population, ..WalkRequest::default() });
        let Some(StyledRequest::Smooth(walk)) = request.in_step(1.25, 142.8, 60.0) else { panic!("fitted") };
        let frames = 120.0 * 60.0 / walk.step_frequency.expect("a step frequency");
        assert!((frames - 50.0).abs() < 1e-9, "{frames}");
    }
}
