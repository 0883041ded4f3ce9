//! Walking backward: a walk forward in reversed time.
//!
//! Newton's and Euler's laws do not know which way time runs: with `q(T − t)` velocities turn round, accelerations stay, and what is
//! quadratic in velocities stays with them, so that the same joint moments and the same ground reactions go with the same postures. What
//! a planned walk forward keeps (no slide, friction, pressure inside the soles, ranges) it keeps backward, to the bit. People do nearly
//! that: their joints' courses are almost identical to those of reversed time, the ankle's moment too (M. Lee et al., *Gait & Posture*
//! 38 (2013) 674–678, from its abstract).

use crate::error::{GaitError, PlanError, RequestError};
use crate::request::{Stairs, WalkGround, WalkRequest};
use crate::smooth::parameter::{PARAMETERS, Parameter};
use crate::smooth::walk::WalkPlan;

/// Parameters of the style that a standing posture depends on.
const STANDING: [&str; 4] = ["step-width", "foot-yaw", "thorax-lean", "anterior-tilt"];

/// Plans a request by `forward`; one that goes backward as the walk forward that it is in reversed time. After another walk all of it
/// stands as that one has ended, where it is not asked for otherwise: it begins as a walk forward ends, which is by its last step.
pub(super) fn either_way(
    request: &WalkRequest,
    before: Option<&WalkPlan>,
    forward: impl Fn(&WalkRequest) -> Result<WalkPlan, GaitError>,
) -> Result<WalkPlan, GaitError> {
    if !request.backward {
        return forward(request);
    }
    let refused = |why| match why {
        GaitError::Plan(why @ PlanError::OnlyPart { .. }) => why.into(),
        GaitError::Plan(why) => PlanError::Backward { why: Box::new(why) }.into(),
        why => why,
    };
    let mut reversed = reversed(request)?;
    if let Some(before) = before {
        let stands = |parameter: &&Parameter| STANDING.contains(&parameter.name);
        let open =
            |parameter: &&Parameter| request.parameters.iter().all(|(name, _)| *name != parameter.name);
        let kept = PARAMETERS.iter().filter(stands).filter(open);
        reversed
            .parameters
            .extend(kept.map(|parameter| (parameter.name, parameter.get(before.last_style()))));
    }
    let mut plan = forward(&reversed).map_err(refused)?;
    // The foot that would have closed goes first: of an even number of steps the one that would have begun.
    if plan.steps() % 2 == 1 {
        reversed.left_first = !reversed.left_first;
        plan = forward(&reversed).map_err(refused)?;
    }
    Ok(plan.reversed())
}

/// The walk forward that goes the same way in reversed time.
fn reversed(request: &WalkRequest) -> Result<WalkRequest, RequestError> {
    let refused = |what| Err(RequestError::NotBackward { what });
    if request.path.is_some() {
        return refused("a path");
    }
    if !request.then.is_empty() {
        return refused("steps of another pace or direction on the way");
    }
    let ground = match &request.ground {
        WalkGround::Level => WalkGround::Level,
        WalkGround::Slope(rise) => WalkGround::Slope(-rise),
        WalkGround::Stairs(stairs) => WalkGround::Stairs(Stairs { rise: -stairs.rise, ..*stairs }),
        WalkGround::Relief(_) => return refused("ground of any shape"),
        WalkGround::Footholds(_) => return refused("footholds"),
    };
    Ok(WalkRequest { ground, turn: -request.turn, ..request.clone() })
}
