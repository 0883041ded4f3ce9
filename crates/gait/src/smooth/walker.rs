//! The walker: it plans a walk that holds.

use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, PlanError};
use crate::request::{Extent, STEP_FREQUENCY, Variability, WalkGround, WalkRequest};
use crate::smooth::options;
use crate::smooth::plan_check::PlanCheck;
use crate::smooth::route::Route;
use crate::smooth::styling::Styling;
use crate::smooth::walk::{WalkNumbers, WalkPlan};
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
    let planned_with =
        |request: &WalkRequest, part: f64, route: &Route, numbers: &WalkNumbers, has_steady: bool| {
            let mut styling = Styling::of(request, body, part);
            styling.has_steady = has_steady;
            let planned = |route: &Route| {
                route.plan(body, standing, &styling, numbers, request.left_first, request.resolution)
            };
            let plan = planned(route)?;
            let (deviates, tempo, nearest) = (styling.deviates(), styling.law.tempo, route.easier());
            let has_steady = has_steady && route.is_level();
            let check = PlanCheck { figure, route, nearest, deviates, tempo, has_steady };
            check.check(&plan)?;
            if deviates || !route.is_even() || !route.is_level() {
                check.check_motion(&plan)?;
            } else if !request.parameters.is_empty() {
                // A few of many steps decide.
                let short = if route.is_long() { Some(planned(&route.shortened())?) } else { None };
                check.check_motion(short.as_ref().unwrap_or(&plan))?;
            }
            Ok(plan)
        };
    let planned_on = |request: &WalkRequest, part: f64, route: &Route| -> Result<WalkPlan, GaitError> {
        if !route.is_level() {
            let on = |numbers: WalkNumbers| planned_with(request, part, route, &numbers, true);
            return match on(WalkNumbers::on_ground()) {
                Err(error @ GaitError::Plan(_)) => on(WalkNumbers::low_on_ground()).map_err(|_| error),
                found => found,
            };
        }
        let turns = route.ends_in_a_turn();
        let numbers = if turns { WalkNumbers::by_contact() } else { WalkNumbers::default() };
        let steady = planned_with(request, part, route, &numbers, true);
        if !matches!(steady, Err(GaitError::Plan(_))) {
            return steady;
        }
        // What does not hold in the style of a steady gait may do so in that of first and last steps throughout.
        let found = planned_with(request, part, route, &numbers, false);
        let coarser = !turns && request.parameters.is_empty();
        match found {
            // Between a start and a stop that are near to each other knots may hold a leg too straight.
            Err(error @ GaitError::Plan(_)) if coarser => {
                planned_with(request, part, route, &WalkNumbers::by_contact(), false).map_err(|_| error)
            }
            found => found,
        }
    };
    let planned = |request: &WalkRequest, part: f64| -> Result<WalkPlan, GaitError> {
        let law = Styling::of(request, body, part).law;
        let route = Route::of(request, body, &law, heading)?;
        let found = match planned_on(request, part, &route) {
            Err(error @ GaitError::Plan(_)) if may_step_otherwise(request) => {
                let usual = route.pace().step_length;
                let other = OTHER_STEPS.iter().map(|part| route.with_step_length(part * usual, usize::MAX));
                let mut plans = other.map(|route| planned_on(request, part, &route));
                plans.find_map(Result::ok).ok_or(error)
            }
            found => found,
        };
        if request.deviates() || request.path.is_some() || request.ground != WalkGround::Level {
            return found;
        }
        let holds = |route: &Route, options: &[(&'static str, f64)]| {
            let request = WalkRequest { parameters: options.to_vec(), ..request.clone() };
            planned_on(&request, part, route).is_ok()
        };
        found.map_err(|error| match options::advise(error, &route, body, &request.parameters, holds) {
            error @ GaitError::Plan(PlanError::Options { .. }) => error,
            error => advise(error, &route, |route| planned_on(request, part, route).is_ok()),
        })
    };
    let plan = planned(request, 1.0).map_err(|error| {
        if request.path.is_none() {
            let error = nearest_part(error, request, |part| planned(request, part));
            return advise_on_ground(error, request, |request| planned(request, 1.0).is_ok());
        }
        let law = Styling::of(request, body, 1.0).law;
        match Route::of(request, body, &law, heading) {
            Ok(route) => advise_on_path(error, &route, |step_frequency| {
                let speed = None;
                let slower = WalkRequest {
                    step_frequency: Some(step_frequency),
                    step_length: None,
                    speed,
                    ..request.clone()
                };
                planned(&slower, 1.0).is_ok()
            }),
            Err(_) => error,
        }
    })?;
    Ok(if request.left_first { plan.mirrored() } else { plan })
}

/// Parts of the usual step length with which ground is tried again on which a walk does not hold: feet come to stand elsewhere against its edges.
const OTHER_STEPS: [f64; 6] = [0.97, 0.94, 0.91, 0.88, 1.03, 0.85];
/// By how much a slope is made gentler (rad), and a pace slower or faster (steps/min), to find one that holds, and how often.
const GENTLER: (f64, i32) = (std::f64::consts::PI / 180.0, 6);
const OTHER_PACE: (f64, i32) = (5.0, 4);

/// Whether the feet of a walk may be set down elsewhere: over ground of any shape, if neither its steps nor its way are told.
fn may_step_otherwise(request: &WalkRequest) -> bool {
    matches!(request.ground, WalkGround::Relief(_))
        && matches!(request.extent, Extent::Steps(_))
        && request.step_length.is_none()
        && request.speed.is_none()
}

/// Says which gentler slope holds, or at which pace other ground does, where the ground asks too much.
fn advise_on_ground(
    error: GaitError,
    request: &WalkRequest,
    holds: impl Fn(&WalkRequest) -> bool,
) -> GaitError {
    let GaitError::Plan(PlanError::TooSteep { step, time, what, nearest }) = error else { return error };
    let gentler = || match request.ground {
        WalkGround::Slope(slope) => (1..=GENTLER.1).find_map(|k| {
            let gentler = slope.signum() * (slope.abs() - f64::from(k) * GENTLER.0).max(0.0);
            let tried = WalkRequest { ground: WalkGround::Slope(gentler), ..request.clone() };
            holds(&tried).then(|| format!("the nearest slope that holds is {:.1}°", gentler.to_degrees()))
        }),
        _ => None,
    };
    let paced = || {
        let asked =
            request.step_frequency.filter(|_| request.step_length.is_none() && request.speed.is_none())?;
        let paces = (1..=OTHER_PACE.1).flat_map(|k| [-k, k]).map(|k| asked + f64::from(k) * OTHER_PACE.0);
        let mut paces = paces.filter(|pace| (STEP_FREQUENCY.0..=STEP_FREQUENCY.1).contains(pace));
        let found =
            paces.find(|&pace| holds(&WalkRequest { step_frequency: Some(pace), ..request.clone() }))?;
        Some(format!("it holds at {found:.0} steps/min"))
    };
    let nearest = gentler().or_else(paced).unwrap_or(nearest);
    PlanError::TooSteep { step, time, what, nearest }.into()
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
