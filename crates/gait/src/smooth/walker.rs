//! The walker: it plans a walk that holds.

use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, PlanError};
use crate::request::{STEP_FREQUENCY, WalkRequest};
use crate::smooth::plan_check::PlanCheck;
use crate::smooth::route::Route;
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

/// Plans a walk after another one: from its last style and heading.
pub(crate) fn walk_from(
    figure: &Figure,
    body: &Body,
    before: Option<&WalkPlan>,
    request: &WalkRequest,
) -> Result<WalkPlan, GaitError> {
    let standing = before.map(WalkPlan::last_style);
    let heading = before.map_or(0.0, |before| before.destination().1);
    let route = Route::of(request, body, heading)?;
    let plan = |route: &Route| {
        let plan = route.plan(body, standing, &request.parameters, request.left_first, request.resolution)?;
        PlanCheck { figure, route }.check(&plan)?;
        Ok(plan)
    };
    let plan = plan(&route).map_err(|error| match &request.path {
        Some(_) => advise_on_path(error, &route, |step_frequency| {
            let speed = None;
            let slower = WalkRequest {
                step_frequency: Some(step_frequency),
                step_length: None,
                speed,
                ..request.clone()
            };
            Route::of(&slower, body, heading).and_then(|route| plan(&route)).is_ok()
        }),
        None => advise(error, &route, |route| plan(route).is_ok()),
    })?;
    Ok(if request.left_first { plan.mirrored() } else { plan })
}

/// Says where on a path the walk does not hold, and the next slower step frequency at which it does.
fn advise_on_path(error: GaitError, route: &Route, holds: impl Fn(f64) -> bool) -> GaitError {
    let GaitError::Plan(PlanError::AbruptChange { step, time, what, .. }) = error else { return error };
    let Some([x, z]) = route.place_of(step) else {
        return PlanError::AbruptChange { part: step, step, time, what }.into();
    };
    let asked = route.pace().step_frequency;
    let slower =
        (1..=10).map(|k| asked - 5.0 * f64::from(k)).take_while(|&slower| slower >= STEP_FREQUENCY.0);
    let nearest = slower.into_iter().find(|&slower| holds(slower)).map_or_else(
        || "; give its bends more room".to_owned(),
        |slower| format!("; it holds at {slower:.0} steps/min with people's steps"),
    );
    PlanError::OnPath { step, x, z, time, what, nearest }.into()
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
