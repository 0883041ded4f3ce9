//! The runner: it plans a run that holds.

use super::chain::{Bound, Chain, Schedule, Walked};
use super::extremes::RunExtremes;
use super::plan::RunPlan;
use super::stride::RunStride;
use super::style::RunStyle;
use super::tempo;
use crate::body::{Body, missing};
use crate::error::{GaitError, PlanError, RequestError};
use crate::request::pace::range;
use crate::request::{
    Extent, FOREFOOT_SPEED, RUN_SPEED, RunEnd, RunRequest, RunWalk, SHORTEST_DISTANCE, SOLE_GIVE, STEPS,
    WalkRequest,
};
use crate::smooth::{is_lopsided, walk};
use solaris_model::Figure;
use std::sync::Arc;

/// Friction that a run may need.
#[doc(alias = "friction coefficient")]
pub const RUN_FRICTION: f64 = 0.5;
/// Least flexion of a knee (rad), greatest depth of a sole and shortage of a leg (m).
const LEAST_KNEE: f64 = 0.0;
const SINK: f64 = 1e-3;
const SHORT: f64 = 1e-4;
/// The most by which the rate of the angular momentum may miss the law's, over weight times height.
const EXCESS: f64 = 1e-2;
/// The same of a run that changes.
const MORE_EXCESS: f64 = 3e-2;
/// The most by which the force that the body needs may miss the law's, over the weight.
const FORCE_EXCESS: f64 = 0.08;
/// Parts of a run's flight that the one out of a walk and the one into a walk last: the passes of a few requests in a hundred do not settle with the first
/// ones.
const FLIGHTS: [[f64; 2]; 4] = [[0.5, 0.3], [0.5, 0.45], [0.7, 0.6], [0.35, 0.45]];
/// Steps that a walk is planned on after the one that a run leaves: its last ones differ from the others.
const WALKED_ON: usize = 5;
/// Instants of a stride that are looked at.
const INSTANTS: usize = 400;
/// By how much speeds are tried apart where one does not hold (m/s), and how often the way between is halved.
const TRIED: f64 = 0.25;
const HALVED: usize = 5;

/// Plans a run: some steps of a steady stride, from a contact to a contact, in full run at both ends; or a chain of steps that changes its
/// speed, or begins or ends in standing or in a walk.
///
/// # Errors
///
/// [`GaitError`] for a figure that the planner does not know, for values out of range (with the range), and for a run that soles or
/// legs cannot do, with the nearest speed that holds.
#[doc(alias = "jog")]
#[doc(alias = "locomotion")]
pub fn run(figure: &Figure, request: &RunRequest) -> Result<RunPlan, GaitError> {
    missing::check(figure)?;
    let body = Body::of(figure)?.with_legs_alike()?;
    judged(figure, &body, request).map_err(|error| match error {
        GaitError::Plan(PlanError::NotRunnable { speed, what, nearest: advice }) if advice.is_empty() => {
            let nearest = nearest(&body, speed, request);
            PlanError::NotRunnable { speed, what, nearest }.into()
        }
        error => error,
    })
}

/// The same without the nearest speed that holds, which takes many plans.
pub(crate) fn judged(figure: &Figure, body: &Body, request: &RunRequest) -> Result<RunPlan, GaitError> {
    let speed = request.speed;
    range("speed", speed, " m/s", RUN_SPEED, String::new)?;
    let lopsided = is_lopsided(body);
    let changes = !request.then.is_empty()
        || (request.from, request.to) != (RunEnd::Running, RunEnd::Running)
        || lopsided;
    let (lower, upper) = SOLE_GIVE;
    range("give", request.give, " m", (lower, upper), String::new)?;
    let of_full_runs = [("forefoot", request.forefoot), ("give", request.give > 0.0)];
    if let Some((option, _)) = of_full_runs.into_iter().find(|(_, asked)| changes && *asked) {
        let of = "a run that changes its speed, begins or ends otherwise than in full run, or of somebody with a load in one hand";
        return Err(RequestError::NotOf { option, of }.into());
    }
    if request.forefoot {
        range("speed", speed, " m/s", (RUN_SPEED.0, FOREFOOT_SPEED), || " on the forefoot".to_owned())?;
    }
    let style = style(body, speed, request);
    let steps = steps(request.extent, style.step_length)?;
    let stride = RunStride::plan(body.clone(), &style, request.resolution)?;
    // A stride that repeats itself is one of two sides that are alike; of others each step is planned.
    if let Some(what) = fault(&stride.extremes(INSTANTS), EXCESS, body).filter(|_| !lopsided) {
        let nearest = String::new();
        return Err(PlanError::NotRunnable { speed, what, nearest }.into());
    }
    let ends = (request.from, request.to);
    if !changes {
        return Ok(RunPlan::new(stride, steps, request.left_first));
    }
    if let Extent::Distance(distance) = request.extent {
        return Err(RequestError::RunDistance { distance }.into());
    }
    let from = match request.from {
        RunEnd::Running => Bound::Running,
        RunEnd::Standing => Bound::Standing,
        RunEnd::Walking(part) => {
            Bound::Walking(walked(figure, body, (part, true), part.steps, request.left_first)?)
        }
    };
    let left_first = match &from {
        Bound::Walking(walked) => walked.next_left(),
        _ => request.left_first,
    };
    // Which foot lands after the last of its steps.
    let count = steps + request.then.iter().map(|part| part.steps).sum::<usize>();
    let left_last = count.is_multiple_of(2) == left_first;
    let to = match request.to {
        RunEnd::Running => Bound::Running,
        RunEnd::Standing => Bound::Standing,
        RunEnd::Walking(part) => {
            let left_first = (WALKED_ON % 2 == 1) == left_last;
            Bound::Walking(walked(figure, body, (part, false), WALKED_ON, left_first)?)
        }
    };
    let all = tempo::tempo(speed, steps, &request.then, ends, [from.walks_at(), to.walks_at()])?;
    let beside = [&from, &to].into_iter().any(|bound| matches!(bound, Bound::Walking(_)));
    let mut planned = None;
    for flights in &FLIGHTS[..if beside { FLIGHTS.len() } else { 1 }] {
        let schedule = Schedule::new(body, &all, (&from, &to), left_first, *flights, request.resolution)?;
        let chain = Chain::plan(body.clone(), schedule, request.resolution, stride.com(0).y)?;
        let what = fault(&chain.extremes(), MORE_EXCESS, body);
        let holds = what.is_none();
        planned = Some((chain, what));
        if holds {
            break;
        }
    }
    let Some((chain, what)) = planned else { unreachable!("at least once") };
    if let Some(what) = what {
        return Err(PlanError::NotRunnable {
            speed,
            what,
            nearest: if request.then.is_empty() {
                "run slower or faster, or let it take more steps"
            } else {
                "change the speed by less, or more slowly"
            }
            .to_owned(),
        }
        .into());
    }
    let walks = chain.walks(&from, &to)?;
    // One more lands in the walk; in full run the first one begins with a contact.
    let more = usize::from(!matches!(from, Bound::Running) && matches!(to, Bound::Walking(_)));
    Ok(RunPlan::changing(stride, chain, all.len() + more, request.left_first, walks))
}

/// The style at a speed (m/s).
fn style(body: &Body, speed: f64, request: &RunRequest) -> RunStyle {
    let style = RunStyle { give: request.give, ..RunStyle::of(body.height, speed) };
    if request.forefoot { style.on_forefoot() } else { style }
}

/// A walk before a run, which comes out of it in its step `step`, or after one, which goes over into it in that step.
fn walked(
    figure: &Figure,
    body: &Body,
    (part, before): (RunWalk, bool),
    step: usize,
    left_first: bool,
) -> Result<Walked, GaitError> {
    let of_the_walk = |why: GaitError| GaitError::BesideRun { before, why: Box::new(why) };
    part.check(body.height).map_err(|why| of_the_walk(why.into()))?;
    let request = WalkRequest {
        speed: part.speed,
        extent: Extent::Steps(part.steps + WALKED_ON),
        left_first,
        ..WalkRequest::default()
    };
    let planned = walk(figure, &request).map_err(of_the_walk)?;
    Ok(Walked { walk: Arc::new(planned), step })
}

/// The number of steps that is asked for.
fn steps(extent: Extent, step_length: f64) -> Result<usize, RequestError> {
    let (fewest, most) = STEPS;
    match extent {
        Extent::Steps(steps) => {
            range("steps", steps as f64, "", (fewest as f64, most as f64), String::new)?;
            Ok(steps)
        }
        Extent::Distance(distance) => {
            range("distance", distance, " m", (SHORTEST_DISTANCE, most as f64 * step_length), String::new)?;
            // A distance that is a number of steps is so many, whatever the rounding.
            Ok((distance / step_length - 1e-9).ceil().max(1.0) as usize)
        }
    }
}

/// What soles or legs cannot do.
fn fault(found: &RunExtremes, excess: f64, body: &Body) -> Option<String> {
    let RunExtremes { friction, least_knee, sink, short, force_excess, momentum_excess } = *found;
    let excess = excess * body.mass * crate::walking::G * body.height;
    // Written so that no number is a fault.
    let within = |value: f64, limit: f64| value <= limit;
    if !within(friction, RUN_FRICTION) {
        Some(format!("its friction would have to be {friction:.2}, and soles hold {RUN_FRICTION}"))
    } else if !within(-least_knee, -LEAST_KNEE) {
        Some(format!("a knee would be hyperextended by {:.1}°", -least_knee.to_degrees()))
    } else if !within(sink, SINK) {
        Some(format!("a foot would sink {:.1} mm into the ground", 1e3 * sink))
    } else if !within(short, SHORT) {
        Some(format!("a leg would be {:.1} mm too short to reach its foot on the ground", 1e3 * short))
    } else if !within(force_excess, FORCE_EXCESS) {
        let percent = 100.0 * force_excess;
        Some(format!("body and forces do not come to agree: they are {percent:.0} % of the weight apart"))
    } else if !within(momentum_excess, excess) {
        Some(format!(
            "body and forces do not come to agree: their moments are {momentum_excess:.1} N m apart"
        ))
    } else {
        None
    }
}

/// The speed nearest to one that does not hold.
fn nearest(body: &Body, speed: f64, request: &RunRequest) -> String {
    let most = if request.forefoot { FOREFOOT_SPEED } else { RUN_SPEED.1 };
    let holds = |speed: f64| {
        (RUN_SPEED.0..=most).contains(&speed)
            && RunStride::plan(body.clone(), &style(body, speed, request), request.resolution)
                .is_ok_and(|stride| fault(&stride.extremes(INSTANTS), EXCESS, body).is_none())
    };
    let tries = ((RUN_SPEED.1 - RUN_SPEED.0) / TRIED).ceil() as usize;
    let away = (1..=tries).flat_map(|k| [-TRIED * k as f64, TRIED * k as f64]);
    let Some(mut good) = away.map(|away| speed + away).find(|&speed| holds(speed)) else {
        return "no speed holds for this figure".to_owned();
    };
    // Between it and its neighbour towards the speed that was asked for.
    let mut bad = good - TRIED.copysign(good - speed);
    for _ in 0..HALVED {
        let middle = 0.5 * (good + bad);
        if holds(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    // Rounded away from what does not hold.
    let shown = if good < speed { (good * 100.0).floor() } else { (good * 100.0).ceil() } / 100.0;
    format!("the nearest speed that holds is {shown} m/s")
}
