//! The walker: it plans a walk that holds.

use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, PlanError};
use crate::request::{Variability, WalkRequest};
use crate::smooth::plan_check::PlanCheck;
use crate::smooth::route::Route;
use crate::smooth::styling::Styling;
use crate::smooth::walk::WalkPlan;
use solaris_model::Figure;

/// Plans a walk, from standing to standing.
///
/// # Errors
///
/// [`GaitError`] for a figure that the walker does not know, for values out of range (with the range), for a walk that
/// needs more friction than soles have (with the longest step that holds), for one that the legs cannot do, and for a change on
/// the way that is too sudden (with where and why).
#[doc(alias = "gait")]
#[doc(alias = "locomotion")]
#[doc(alias = "walk cycle")]
pub fn walk(figure: &Figure, request: &WalkRequest) -> Result<WalkPlan, GaitError> {
    missing::check(figure)?;
    walk_from(figure, &Body::of(figure)?, None, request)
}

/// Plans a walk with as much of its manner and of its variability as holds, and says how much that is: 1 is all.
///
/// # Errors
///
/// Those of [`walk`], but for [`PlanError::OnlyPart`].
pub fn walk_in_part(figure: &Figure, request: &WalkRequest) -> Result<(WalkPlan, f64), GaitError> {
    match walk(figure, request) {
        Err(GaitError::Plan(PlanError::OnlyPart { part, .. })) => {
            Ok((walk(figure, &request.in_part(part))?, part))
        }
        found => Ok((found?, 1.0)),
    }
}

/// Plans a walk after another one: from its last style and heading.
pub(crate) fn walk_from(
    figure: &Figure,
    body: &Body,
    before: Option<&WalkPlan>,
    request: &WalkRequest,
) -> Result<WalkPlan, GaitError> {
    let standing = before.map(WalkPlan::last_style);
    let heading = before.map_or(0.0, |before| before.destination().1);
    request.variability.map_or(Ok(()), Variability::check)?;
    let planned = |part: f64| -> Result<WalkPlan, GaitError> {
        let styling = Styling::of(request, body, part);
        let route = Route::of(request, &styling.law, heading)?;
        let plan = |route: &Route| {
            let plan = route.plan(body, standing, &styling, request.left_first, request.resolution)?;
            PlanCheck { figure, route, deviates: styling.deviates(), tempo: styling.law.tempo }
                .check(&plan)?;
            Ok(plan)
        };
        let found = plan(&route);
        if !request.deviates() {
            return found.map_err(|error| advise(error, &route, |route| plan(route).is_ok()));
        }
        found
    };
    let plan = planned(1.0).map_err(|error| nearest_part(error, request, planned))?;
    Ok(if request.left_first { plan.mirrored() } else { plan })
}

/// Says how much of a manner and of a variability holds where all of it does not, by six bisections; why there is no walk at all
/// where none of it does.
fn nearest_part(
    why: GaitError,
    request: &WalkRequest,
    planned: impl Fn(f64) -> Result<WalkPlan, GaitError>,
) -> GaitError {
    if !request.deviates() {
        return why;
    }
    if let Err(plain) = planned(0.0) {
        return plain;
    }
    let (mut lower, mut upper) = (0.0, 1.0);
    for _ in 0..6 {
        let middle = 0.5 * (lower + upper);
        if planned(middle).is_ok() {
            lower = middle;
        } else {
            upper = middle;
        }
    }
    PlanError::OnlyPart { part: lower, why: Box::new(why) }.into()
}

/// Says how long a step may be where friction is the reason: the longest that `holds`, by ten bisections.
fn advise(error: GaitError, route: &Route, holds: impl Fn(&Route) -> bool) -> GaitError {
    let GaitError::Plan(PlanError::Friction { step_length, step_frequency, whose, friction, limit, .. }) =
        error
    else {
        return error;
    };
    // A few steps decide: the shifts at the ends are the worst.
    let holds = |length: f64| holds(&route.with_step_length(length, 10));
    let (mut lower, mut upper) = (0.5 * step_length, step_length);
    let longest = if holds(lower) {
        for _ in 0..10 {
            let middle = 0.5 * (lower + upper);
            if holds(middle) {
                lower = middle;
            } else {
                upper = middle;
            }
        }
        format!("; the longest step that holds is {:.3} m", (lower * 1e3).floor() / 1e3)
    } else {
        "; go back to the default style or walk slower".to_owned()
    };
    PlanError::Friction { step_length, step_frequency, whose, friction, limit, longest }.into()
}
