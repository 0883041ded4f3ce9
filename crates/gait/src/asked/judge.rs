//! Whether the planners accept options: their own judgement, without the advice that a refusal comes with.

use super::options::GaitOptions;
use super::stages::Staged;
use crate::body::{Body, missing};
use crate::error::{GaitError, RequestError};
use crate::request::{Population, WalkRequest};
use crate::running::judged_run;
use crate::smooth::{Style, WalkSegment, WalkSequence, has_more_steps, judged, styled};
use crate::styled::StyledRequest;
use crate::thesis::determinants::Proportions;
use crate::thesis::thesis_judged;
use solaris_model::Figure;

/// Judges options for a figure.
pub(super) struct Judge<'a> {
    figure: &'a Figure,
    pub(super) body: Body,
    /// Whether all of a manner and of a variability has to hold.
    pub(super) whole: bool,
}

impl<'a> Judge<'a> {
    pub(super) fn new(figure: &'a Figure) -> Result<Self, GaitError> {
        missing::check_for_walk(figure)?;
        Ok(Self { figure, body: Body::of(figure)?, whole: false })
    }

    pub(super) fn proportions(&self) -> Proportions {
        Proportions::of_leg(&self.body.leg, self.body.height)
    }

    /// Who walks; who is not known is refused elsewhere.
    pub(super) fn population(options: &GaitOptions) -> Population {
        let named = |known: &Population| options.population.as_deref() == Some(known.name());
        Population::ALL.into_iter().find(named).unwrap_or_default()
    }

    /// The style of the steady part of a walk that forces are planned of first, where its numbers are in range, or of another one.
    pub(super) fn style(&self, options: &GaitOptions, other: &WalkRequest) -> Option<Style> {
        let request = match options.request(self.figure).ok()?.request {
            StyledRequest::Smooth(walk) => walk,
            StyledRequest::Sequence(segments) => segments.into_iter().find_map(|segment| match segment {
                WalkSegment::Walk(walk) => Some(walk),
                WalkSegment::Stand(_) => None,
            })?,
            StyledRequest::Thesis(_) | StyledRequest::Run(_) => return None,
        };
        let style = |request: &WalkRequest| styled(self.figure, &self.body, request).ok();
        style(&request).or_else(|| style(other))
    }

    /// Whether steps that decide are fewer than all of them.
    pub(super) fn shortens(&self, options: &GaitOptions) -> bool {
        match options.request(self.figure) {
            Ok(Staged { request: StyledRequest::Smooth(walk), .. }) => {
                has_more_steps(self.figure, &self.body, &walk)
            }
            _ => false,
        }
    }

    /// Whether the numbers are in range, as far as that is known without a plan.
    pub(super) fn is_in_range(&self, options: &GaitOptions) -> Result<bool, GaitError> {
        match options.request(self.figure)?.request {
            StyledRequest::Smooth(walk) => accepted(styled(self.figure, &self.body, &walk)),
            StyledRequest::Sequence(_) | StyledRequest::Thesis(_) | StyledRequest::Run(_) => Ok(true),
        }
    }

    /// Whether there is a plan that holds; of many steps of one pace by some that decide, where it is `short`.
    pub(super) fn accepts(&self, options: &GaitOptions, short: bool) -> Result<bool, GaitError> {
        let how = (self.whole, short);
        match options.request(self.figure)?.request {
            StyledRequest::Smooth(walk) => accepted(judged(self.figure, &self.body, None, &walk, how)),
            StyledRequest::Sequence(segments) => {
                // Of a sequence all of a manner has to hold.
                let planned = |before: Option<&_>, request: &_| {
                    judged(self.figure, &self.body, before, request, (true, false))
                };
                accepted(WalkSequence::with(&self.body, &segments, planned))
            }
            StyledRequest::Thesis(walk) => accepted(thesis_judged(self.figure, &walk)),
            StyledRequest::Run(run) => accepted(judged_run(self.figure, &self.body, &run)),
        }
    }
}

/// Whether something was planned. What is wrong with a request whatever its numbers are is an error.
fn accepted<T>(found: Result<T, GaitError>) -> Result<bool, GaitError> {
    match found {
        Ok(_) => Ok(true),
        Err(error) if is_of_numbers(&error) => Ok(false),
        Err(error) => Err(error),
    }
}

/// Whether other numbers may do.
fn is_of_numbers(error: &GaitError) -> bool {
    match error {
        GaitError::InSegment { why, .. }
        | GaitError::InPart { why, .. }
        | GaitError::BesideRun { why, .. } => is_of_numbers(why),
        GaitError::Request(error) => matches!(
            error,
            RequestError::Range { .. }
                | RequestError::StepLength { .. }
                | RequestError::TurnInAll { .. }
                | RequestError::PathTooLong { .. }
                | RequestError::PathBends { .. }
                | RequestError::PathAndMore { .. }
                | RequestError::FeetWouldTurn { .. }
                | RequestError::RunChange { .. }
                | RequestError::RunSteps { .. }
                | RequestError::RunWalkSteps { .. }
                | RequestError::RunWalkSpeed { .. }
                | RequestError::RunSlowerThanWalk { .. }
                | RequestError::RunTooLong { .. }
                | RequestError::StyleNotFinite { .. }
                | RequestError::Foothold { .. }
                | RequestError::NotOnTerrain { .. }
        ),
        GaitError::Plan(_)
        | GaitError::Posture(_)
        | GaitError::Planted(_)
        | GaitError::Reaction(_)
        | GaitError::Profile(_) => true,
        _ => false,
    }
}
