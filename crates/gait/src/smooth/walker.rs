//! The walker: it plans a walk that holds.

use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, PlanError};
use crate::request::{Extent, STEP_FREQUENCY, Variability, WalkGround, WalkRequest};
use crate::smooth::backward::either_way;
use crate::smooth::lopsided::is_lopsided;
use crate::smooth::options;
use crate::smooth::plan_check::PlanCheck;
use crate::smooth::planner::{Planner, is_unusual};
use crate::smooth::route::{DECIDE, Route, leave_few_stairs};
use crate::smooth::style::Style;
use crate::smooth::walk::WalkPlan;
use solaris_model::Figure;
use std::borrow::Cow;

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
    missing::check_for_walk(figure)?;
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

/// Plans a walk after another one: from its last style and heading. What does not hold is refused with the nearest that does.
pub(crate) fn walk_from(
    figure: &Figure,
    body: &Body,
    before: Option<&WalkPlan>,
    request: &WalkRequest,
) -> Result<WalkPlan, GaitError> {
    request.variability.map_or(Ok(()), Variability::check)?;
    either_way(request, before, |request| forward_from(figure, body, before, request))
}

/// The same of a walk forward.
fn forward_from(
    figure: &Figure,
    body: &Body,
    before: Option<&WalkPlan>,
    request: &WalkRequest,
) -> Result<WalkPlan, GaitError> {
    let body = &as_planned(body, request);
    let planner = Planner::after(figure, body, before);
    let planned = |request: &WalkRequest, part: f64| -> Result<WalkPlan, GaitError> {
        let error = match planner.planned(request, part) {
            Err(error) => error,
            found => return found,
        };
        if request.deviates() || request.path.is_some() || request.ground != WalkGround::Level {
            return Err(error);
        }
        let route = planner.route(request, part)?;
        let holds = |route: &Route, options: &[(&'static str, f64)]| {
            let request = WalkRequest { parameters: options.to_vec(), ..request.clone() };
            planner.planned_on(&request, part, route).is_ok()
        };
        let error = options::advise(error, &route, body, &request.parameters, holds);
        // A pace that holds is told below.
        if has_other_paces(body, request) {
            return Err(error);
        }
        Err(advise(error, &route, |route| planner.planned_on(request, part, route).is_ok()))
    };
    let plan = planned(request, 1.0).map_err(|error| {
        if request.path.is_none() {
            let error = nearest_part(error, request, |part| planned(&shortened(request), part));
            let error = advise_on_ground(error, request, &|request| planner.holds(&shortened(request)));
            if !has_other_paces(body, request) {
                return error;
            }
            let holds = |other: &WalkRequest| planner.planned(other, 1.0).is_ok();
            return advise_on_pace(error, body.height, request, &holds);
        }
        match planner.route(request, 1.0) {
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

/// A request for as many steps on a slope, or stairs, as decide whether it holds.
fn shortened(request: &WalkRequest) -> WalkRequest {
    let mut request = request.clone();
    if let (WalkGround::Slope(_), Extent::Steps(steps)) = (&request.ground, &mut request.extent) {
        *steps = DECIDE.min(*steps);
    }
    leave_few_stairs(&mut request.ground);
    request
}

/// The body as a walk is planned, right foot first: of one that is heavier on one side the mirror image, where the left foot goes first.
fn as_planned<'a>(body: &'a Body, request: &WalkRequest) -> Cow<'a, Body> {
    if request.left_first && is_lopsided(body) { Cow::Owned(body.mirrored()) } else { Cow::Borrowed(body) }
}

/// Plans a walk after another one, as [`walk_from`] does but for the advice, which takes many plans: as much of its manner as holds, or all of it, or
/// nothing, where it is to be `whole`; where it is `short`, of many steps of one pace some that decide.
pub(crate) fn judged(
    figure: &Figure,
    body: &Body,
    before: Option<&WalkPlan>,
    request: &WalkRequest,
    (whole, short): (bool, bool),
) -> Result<WalkPlan, GaitError> {
    request.variability.map_or(Ok(()), Variability::check)?;
    either_way(request, before, |request| {
        let body = &as_planned(body, request);
        let planner = Planner::after(figure, body, before);
        let planned = |part: f64| {
            let route = planner.route(request, part)?;
            if short && route.is_long() && route.is_level() {
                return planner.planned_on(request, part, &route.shortened());
            }
            planner.planned(request, part)
        };
        let plan = match planned(1.0) {
            Err(GaitError::Plan(_)) if request.deviates() && !whole => planned(0.0),
            found => found,
        }?;
        Ok(if request.left_first { plan.mirrored() } else { plan })
    })
}

/// Whether it has more steps than decide whether it holds, see [`judged`].
pub(crate) fn has_more_steps(figure: &Figure, body: &Body, request: &WalkRequest) -> bool {
    let route = Planner::after(figure, body, None).route(request, 1.0);
    route.is_ok_and(|route| route.is_long() && route.is_level())
}

/// The style of the steady part of a request, by its numbers alone.
///
/// # Errors
///
/// Numbers out of range; nothing is planned.
pub(crate) fn styled(figure: &Figure, body: &Body, request: &WalkRequest) -> Result<Style, GaitError> {
    request.variability.map_or(Ok(()), Variability::check)?;
    Planner::after(figure, body, None).style(request)
}

/// The style in which somebody stands before a walk at people's pace.
///
/// # Errors
///
/// As [`styled`].
pub(crate) fn standing_style(figure: &Figure, body: &Body) -> Result<Style, GaitError> {
    let planner = Planner::after(figure, body, None);
    planner.standing_style(&WalkRequest::default()).or_else(|_| {
        // Who carries much would walk more slowly than there are walks.
        let slowest = Some(STEP_FREQUENCY.0);
        planner.standing_style(&WalkRequest { step_frequency: slowest, ..WalkRequest::default() })
    })
}

/// By how much a slope is made gentler (rad), and a pace slower or faster (steps/min), to find one that holds, and how often.
const GENTLER: (f64, i32) = (std::f64::consts::PI / 180.0, 6);
const OTHER_PACE: (f64, i32) = (5.0, 4);

/// Says which gentler slope holds, or at which pace other ground does, where the ground asks too much.
fn advise_on_ground(
    error: GaitError,
    request: &WalkRequest,
    holds: &dyn Fn(&WalkRequest) -> bool,
) -> GaitError {
    let GaitError::Plan(PlanError::TooSteep { step, time, what, nearest }) = error else { return error };
    let gentler = || match request.ground {
        WalkGround::Slope(slope) => (1..=GENTLER.1).find_map(|k| {
            let gentler = slope.signum() * (slope.abs() - f64::from(k) * GENTLER.0).max(0.0);
            let tried = WalkRequest { ground: WalkGround::Slope(gentler), ..request.clone() };
            // Backward it rises the other way round.
            let told = if request.backward { -gentler } else { gentler };
            holds(&tried).then(|| format!("the nearest slope that holds is {:.1}°", told.to_degrees()))
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

/// Whether somebody is of unusual height, and other paces may hold on level ground.
fn has_other_paces(body: &Body, request: &WalkRequest) -> bool {
    is_unusual(body)
        && request.step_length.is_none()
        && request.path.is_none()
        && request.ground == WalkGround::Level
}

/// How far from the pace that was asked for others are tried for somebody of unusual height (steps/min).
const OTHER_PACES: u32 = 60;

/// Says at which pace the walk of somebody of unusual height (m) holds; one that is out of range does not.
fn advise_on_pace(
    error: GaitError,
    height: f64,
    request: &WalkRequest,
    holds: &dyn Fn(&WalkRequest) -> bool,
) -> GaitError {
    let (step_length, step_frequency, what) = match &error {
        GaitError::Plan(PlanError::NotWalkable { step_length, step_frequency, what }) => {
            (*step_length, *step_frequency, what.clone())
        }
        GaitError::Plan(PlanError::Friction {
            step_length, step_frequency, whose, friction, limit, ..
        }) => (*step_length, *step_frequency, PlanCheck::friction(whose, *friction, *limit)),
        _ => return error,
    };
    let mut other = WalkRequest { step_length: None, speed: None, ..request.clone() };
    if matches!(other.extent, Extent::Steps(steps) if steps > DECIDE) {
        other.extent = Extent::Steps(DECIDE);
    }
    let found = (2..2 * OTHER_PACES).find_map(|k| {
        let away = f64::from(k / 2);
        let pace = step_frequency.round() + if k % 2 == 0 { -away } else { away };
        other.step_frequency = Some(pace);
        holds(&other).then_some(pace)
    });
    let Some(pace) = found else { return error };
    let (options, nearest) = (format!("a height of {height} m"), format!("{pace} steps/min"));
    PlanError::Options { options, step_length, step_frequency, what, nearest }.into()
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
