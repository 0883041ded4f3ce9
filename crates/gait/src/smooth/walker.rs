//! The walker: it plans a walk that holds.

use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, PlanError};
use crate::request::WalkRequest;
use crate::smooth::options;
use crate::smooth::plan_check::PlanCheck;
use crate::smooth::route::Route;
use crate::smooth::walk::WalkPlan;
use solaris_model::Figure;

/// Plans a walk, from standing to standing.
///
/// # Errors
///
/// [`GaitError`] for a figure that the walker does not know, for values out of range (with the range), for a walk that
/// needs more friction than soles have (with the longest step that holds), for one that the legs cannot do, for options of the style with which it does not hold (with the
/// nearest that do), and for a change on
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
    let route = Route::of(request, body.height, heading)?;
    let plan = |route: &Route, options: &[(&'static str, f64)]| {
        let planned =
            |route: &Route| route.plan(body, standing, options, request.left_first, request.resolution);
        let plan = planned(route)?;
        let check = PlanCheck { figure, route };
        check.check(&plan)?;
        if !route.is_even() {
            check.check_motion(&plan)?;
        } else if !options.is_empty() {
            // A few of many steps decide.
            let short = if route.is_long() { Some(planned(&route.shortened())?) } else { None };
            check.check_motion(short.as_ref().unwrap_or(&plan))?;
        }
        Ok(plan)
    };
    let options = &request.parameters[..];
    let plan = plan(&route, options).map_err(|error| {
        match options::advise(error, &route, body, options, |route, options| plan(route, options).is_ok()) {
            error @ GaitError::Plan(PlanError::Options { .. }) => error,
            error => advise(error, &route, |route| plan(route, options).is_ok()),
        }
    })?;
    Ok(if request.left_first { plan.mirrored() } else { plan })
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
