//! What comes after the first part of a walk: more steps, or standing still and another walk.

use crate::error::RequestError;
use crate::request::{Extent, WalkPart, WalkRequest};
use crate::smooth::WalkSegment;
use crate::styled::StyledRequest;

/// What comes next in a walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Next {
    /// Stop, and stand so long (s).
    Stand(f64),
    /// Some steps.
    Steps(WalkPart),
    /// As many steps as reach so far (m), from standing.
    Distance(f64, WalkPart),
}

/// A walk in parts and stages.
#[derive(Clone, Debug, PartialEq)]
pub struct Staged {
    /// One walk, or several with standing still in between.
    pub request: StyledRequest,
    /// For each stage, and each part of it, which of what comes next asked for it; none of what stands before the first.
    pub origins: Vec<Vec<Option<usize>>>,
}

impl Staged {
    /// Which of what comes next asked for the part of a stage.
    pub fn origin(&self, stage: usize, part: usize) -> Option<usize> {
        *self.origins.get(stage)?.get(part)?
    }
}

/// A walk and what comes next: one walk, or several with standing still in between. What is left out of a pace stays as it was.
///
/// # Errors
///
/// [`RequestError::DistanceOnTheWay`]: how far it goes is said before it stands; [`RequestError::BackwardOnTheWay`]: nobody turns round
/// in the middle of a step.
pub fn stages(first: &WalkRequest, next: &[Next]) -> Result<Staged, RequestError> {
    let WalkRequest { step_frequency, step_length, speed, .. } = *first;
    let mut pace = WalkPart { step_frequency, step_length, speed, ..WalkPart::default() };
    let anew = |extent: Extent, part: &WalkPart, pace: &WalkPart| {
        let WalkPart { step_frequency, step_length, speed, .. } = *pace;
        let WalkPart { turn, backward, .. } = *part;
        Some(WalkRequest { step_frequency, step_length, speed, extent, turn, backward, ..first.clone() })
    };
    let (mut stages, mut walk) = (Vec::new(), Some(first.clone()));
    let mut origins = vec![vec![None]];
    for (number, what) in next.iter().enumerate() {
        if let Next::Steps(part) | Next::Distance(_, part) = *what
            && part.step_frequency.or(part.step_length).or(part.speed).is_some()
        {
            pace = part;
        }
        let origin = Some(number);
        match (*what, &mut walk) {
            (Next::Stand(time), _) => {
                stages.extend(walk.take().map(WalkSegment::Walk));
                stages.push(WalkSegment::Stand(time));
                origins.push(vec![origin]);
            }
            (Next::Steps(part), Some(walk)) => {
                if part.backward {
                    return Err(RequestError::BackwardOnTheWay { number: number + 1 });
                }
                walk.then.push(part);
                if let Some(parts) = origins.last_mut() {
                    parts.push(origin);
                }
            }
            (Next::Steps(part), None) => {
                walk = anew(Extent::Steps(part.steps), &part, &pace);
                origins.push(vec![origin]);
            }
            (Next::Distance(distance, part), None) => {
                walk = anew(Extent::Distance(distance), &part, &pace);
                origins.push(vec![origin]);
            }
            (Next::Distance(distance, _), Some(_)) => {
                return Err(RequestError::DistanceOnTheWay { number: number + 1, distance });
            }
        }
    }
    stages.extend(walk.map(WalkSegment::Walk));
    let request = match stages.pop() {
        Some(WalkSegment::Walk(walk)) if stages.is_empty() => StyledRequest::Smooth(walk),
        last => StyledRequest::Sequence(stages.into_iter().chain(last).collect()),
    };
    Ok(Staged { request, origins })
}
