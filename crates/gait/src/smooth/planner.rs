//! The planner of one walk: tries what may hold, and judges it.

use crate::body::{Body, LegGeometry};
use crate::error::{BodyError, GaitError, PlanError, RequestError};
use crate::request::pace::{Pace, STEP_FREQUENCY, range};
use crate::request::{CANE_LOADS, Extent, STEPS, WalkGround, WalkRequest};
use crate::smooth::distance::to_distance;
use crate::smooth::lopsided::{is_lopsided, legs_differ};
use crate::smooth::plan_check::{FINE_RATE, FINER_RATE, FINEST_RATE, PlanCheck, not_walkable};
use crate::smooth::route::Route;
use crate::smooth::style::Style;
use crate::smooth::styling::{Gone, Styling};
use crate::smooth::variant::StyleVariant;
use crate::smooth::walk::{Easing, Terrain, WalkNumbers, WalkPlan, steps};
use solaris_model::Figure;

/// Parts of the usual step length with which ground is tried again on which a walk does not hold: feet come to stand elsewhere against its edges.
const OTHER_STEPS: [f64; 8] = [0.97, 0.94, 0.91, 0.88, 1.03, 0.85, 1.08, 1.13];
/// The same on slopes, where slow walks need longer ones.
const OTHER_STEPS_ON_SLOPES: [f64; 7] = [1.05, 1.10, 1.15, 0.96, 0.92, 1.20, 0.88];

/// The longest that are tried, over the usual ones.
const LONGEST_OTHER: f64 = 1.25;

/// How many of [`OTHER_STEPS_ON_SLOPES`] are tried in another style, too.
const OTHER_STEPS_VARIED: usize = 4;

/// How far from a distance a walk may end (m) before other steps are tried.
const THERE: f64 = 1e-6;

/// Whether it ends where it is asked to: over a relief steps are fitted to a distance as nearly as feet find places.
fn leads_there(request: &WalkRequest, plan: &WalkPlan) -> bool {
    match (&request.ground, request.extent) {
        (WalkGround::Relief(_), Extent::Distance(distance)) => {
            (plan.destination().0.z - distance).abs() < THERE
        }
        _ => true,
    }
}

fn is_slope(request: &WalkRequest) -> bool {
    matches!(request.ground, WalkGround::Slope(_))
}

/// The usual route, or the second one, with other steps, as far as a request leaves them open: of other lengths, as many as lead to its distance, and at
/// another frequency where a speed alone is asked for on a slope.
fn with_other_steps(
    request: &WalkRequest,
    usual: &Route,
    leg: &LegGeometry,
    tempo: f64,
    (parts, otherwise): (&[f64], bool),
) -> Vec<Route> {
    let slope = if let WalkGround::Slope(slope) = request.ground { Some(slope) } else { None };
    let keeps_speed = request.speed.is_some();
    if request.step_length.is_some() || keeps_speed && (slope.is_none() || request.step_frequency.is_some()) {
        return Vec::new();
    }
    let Pace { step_frequency, step_length } = usual.pace();
    let frequencies = STEP_FREQUENCY.0 * tempo..=STEP_FREQUENCY.1 * tempo;
    let other = |part: &f64| {
        let (steps, length) = match (request.extent, slope) {
            (Extent::Steps(_), _) => (None, part * step_length),
            (Extent::Distance(distance), Some(slope)) => {
                let parts = |n: usize| (0..n).map(move |i| Terrain::part_on_slope(slope, i, n));
                let (n, length) = steps::for_distance(distance, part * step_length, parts);
                (Some(n), length)
            }
            (Extent::Distance(distance), None) => {
                let pace = Pace { step_frequency, step_length: part * step_length };
                let (n, length) = to_distance(distance, (&request.ground, otherwise), leg, pace, tempo);
                (Some(n), length)
            }
        };
        let quicker = if keeps_speed { step_length / length } else { 1.0 };
        let pace = Pace { step_frequency: step_frequency * quicker, step_length: length };
        let fits = steps.is_none_or(|n| n <= STEPS.1) && length <= LONGEST_OTHER * step_length;
        (fits && frequencies.contains(&pace.step_frequency)).then_some((pace, steps))
    };
    // As many steps to a distance are the same ones.
    let mut lengths = if otherwise { Vec::new() } else { vec![step_length] };
    let mut is_other = |length: f64| {
        let is_other = lengths.iter().all(|known| (length / known - 1.0).abs() > 1e-9);
        lengths.push(length);
        is_other
    };
    let others = parts.iter().filter_map(other).filter(|(pace, _)| is_other(pace.step_length));
    let route = |(pace, steps)| {
        let route = usual.with_pace(pace, steps);
        if otherwise { route.otherwise() } else { route }
    };
    others.map(route).collect()
}

/// Other routes over ground on which a walk does not hold on the usual one: with other steps, over footholds in the style of the slope around them, over
/// edges as stairs.
fn other_routes(request: &WalkRequest, usual: &Route, leg: &LegGeometry, tempo: f64) -> Vec<Route> {
    match request.ground {
        WalkGround::Footholds(_) => vec![usual.otherwise()],
        WalkGround::Stairs(stairs) => {
            let up = stairs.rise > 0.0;
            let others = if up { &StyleVariant::UP_STAIRS[..] } else { &StyleVariant::DOWN_STAIRS };
            others.iter().map(|style| usual.varied(style)).collect()
        }
        WalkGround::Slope(_) => with_other_steps(request, usual, leg, tempo, (&OTHER_STEPS_ON_SLOPES, false)),
        WalkGround::Relief(_) => {
            let others = with_other_steps(request, usual, leg, tempo, (&OTHER_STEPS, false));
            let parts: Vec<f64> = std::iter::once(1.0).chain(OTHER_STEPS).collect();
            let over_edges = with_other_steps(request, usual, leg, tempo, (&parts, true));
            others.into_iter().chain(over_edges).collect()
        }
        WalkGround::Level => Vec::new(),
    }
}

/// Statures (m) of which plain walks of every pace were looked at; those of others are judged one by one.
const USUAL: (f64, f64) = (1.45, 2.0);

/// Whether somebody is smaller or taller than those whom the laws were tried with.
pub(super) fn is_unusual(body: &Body) -> bool {
    !(USUAL.0..=USUAL.1).contains(&body.height)
}

/// Plans walks of a body that stands as after another walk; what does not hold is refused without advice.
pub(super) struct Planner<'a> {
    figure: &'a Figure,
    body: &'a Body,
    standing: Option<&'a Style>,
    heading: f64,
}

impl<'a> Planner<'a> {
    /// After another walk: from its last style and heading.
    pub(super) fn after(figure: &'a Figure, body: &'a Body, before: Option<&'a WalkPlan>) -> Self {
        let standing = before.map(WalkPlan::last_style);
        let heading = before.map_or(0.0, |before| before.destination().1);
        Self { figure, body, standing, heading }
    }

    /// The steps of a request with a part of its manner.
    pub(super) fn route(&self, request: &WalkRequest, part: f64) -> Result<Route, GaitError> {
        Route::of(request, self.body, &Styling::of(request, self.body, part).law, self.heading)
    }

    /// The style of its steady steps.
    pub(super) fn style(&self, request: &WalkRequest) -> Result<Style, GaitError> {
        self.style_of(request, true)
    }

    /// That in which its feet stand before it, at no more than [`super::ends::ENDS`].
    pub(super) fn standing_style(&self, request: &WalkRequest) -> Result<Style, GaitError> {
        self.style_of(request, false)
    }

    fn style_of(&self, request: &WalkRequest, steady: bool) -> Result<Style, GaitError> {
        let pace = self.route(request, 1.0)?.level_pace();
        Ok(Styling::of(request, self.body, 1.0).style(self.body, &Gone { pace, steady })?)
    }

    /// A request with a part of its manner.
    pub(super) fn planned(&self, request: &WalkRequest, part: f64) -> Result<WalkPlan, GaitError> {
        match self.planned_at_pace(request, part) {
            Err(GaitError::Plan(error)) => {
                let found = self.eased(request, part, &error).or_else(|| self.varied(request, part));
                found.ok_or(error.into())
            }
            found => found,
        }
    }

    /// Whether a request holds that is only told of: on stairs in the usual style, as others take many plans.
    pub(super) fn holds(&self, request: &WalkRequest) -> bool {
        if !matches!(request.ground, WalkGround::Stairs(_)) {
            return self.planned_at_pace(request, 1.0).is_ok();
        }
        self.route(request, 1.0).is_ok_and(|route| self.planned_on(request, 1.0, &route).is_ok())
    }

    /// The same with steps that all last as long as its pace has them.
    fn planned_at_pace(&self, request: &WalkRequest, part: f64) -> Result<WalkPlan, GaitError> {
        let route = self.route(request, part)?;
        let found = self.planned_on(request, part, &route);
        match &found {
            Err(GaitError::Plan(_)) => {}
            Ok(plan) if !leads_there(request, plan) => {}
            _ => return found,
        }
        let others = self.other_routes(request, part, &route);
        others.iter().find_map(|route| self.planned_elsewhere(request, part, route)).map_or(found, Ok)
    }

    fn other_routes(&self, request: &WalkRequest, part: f64, usual: &Route) -> Vec<Route> {
        other_routes(request, usual, &self.body.leg, Styling::of(request, self.body, part).law.tempo)
    }

    /// The plan on another route, if it holds; of many steps on a slope or many stairs some decide whether it is tried.
    fn planned_elsewhere(&self, request: &WalkRequest, part: f64, route: &Route) -> Option<WalkPlan> {
        let is_alike = matches!(request.ground, WalkGround::Slope(_) | WalkGround::Stairs(_));
        if is_alike && route.is_long() {
            self.planned_on(request, part, &route.shortened()).ok()?;
        }
        self.planned_on(request, part, route).ok().filter(|plan| leads_there(request, plan))
    }

    /// The same, slower at its ends, where it does not hold there.
    fn eased(&self, request: &WalkRequest, part: f64, error: &PlanError) -> Option<WalkPlan> {
        let usual = self.route(request, part).ok()?;
        let mut error = error.clone();
        for easing in &Easing::ALL {
            let PlanError::TooSteep { step, .. } = error else { return None };
            if !usual.may_ease(step, easing) {
                continue;
            }
            let route = usual.eased(*easing);
            match self.planned_on(request, part, &route) {
                Ok(plan) => return Some(plan),
                Err(GaitError::Plan(found)) => error = found,
                Err(_) => return None,
            }
            let most = match request.ground {
                // Other steps and styles are tried at even pace.
                WalkGround::Slope(_) => 0,
                WalkGround::Stairs(_) => 1,
                _ => usize::MAX,
            };
            let other = self.other_routes(request, part, &route);
            let mut other = other.iter().take(most);
            if let Some(plan) = other.find_map(|route| self.planned_elsewhere(request, part, route)) {
                return Some(plan);
            }
        }
        None
    }

    /// The same in another style on a slope, with its own steps and others.
    fn varied(&self, request: &WalkRequest, part: f64) -> Option<WalkPlan> {
        if !is_slope(request) {
            return None;
        }
        let usual = self.route(request, part).ok()?;
        let others = self.other_routes(request, part, &usual);
        let [first, second] = &StyleVariant::ON_SLOPES;
        let tried = |route: &Route, style| self.planned_elsewhere(request, part, &route.varied(style));
        let mut others = std::iter::once(&usual).chain(others.iter().take(OTHER_STEPS_VARIED));
        let found = others.find_map(|route| tried(route, first));
        found.or_else(|| tried(&usual, second))
    }

    /// The same on a route: on level ground in the style of a steady gait, or throughout in that of first and last steps.
    pub(super) fn planned_on(
        &self,
        request: &WalkRequest,
        part: f64,
        route: &Route,
    ) -> Result<WalkPlan, GaitError> {
        let planned_with = |numbers: WalkNumbers, has_steady: bool| {
            self.planned_with(request, part, route, &numbers, has_steady)
        };
        if !route.is_level() {
            return match planned_with(WalkNumbers::on_ground(), true) {
                Err(error @ GaitError::Plan(_)) => {
                    planned_with(WalkNumbers::low_on_ground(), true).map_err(|_| error)
                }
                found => found,
            };
        }
        let turns = route.ends_in_a_turn();
        let numbers = if turns { WalkNumbers::by_contact() } else { WalkNumbers::default() };
        let steady = planned_with(numbers, true);
        if !matches!(steady, Err(GaitError::Plan(_))) {
            return steady;
        }
        // What does not hold in the style of a steady gait may do so in that of first and last steps throughout.
        let found = planned_with(numbers, false);
        let coarser = !turns && request.parameters.is_empty();
        match found {
            // Between a start and a stop that are near to each other knots may hold a leg too straight.
            Err(error @ GaitError::Plan(_)) if coarser => {
                planned_with(WalkNumbers::by_contact(), false).map_err(|_| error)
            }
            found => found,
        }
    }

    /// Refuses ground that nobody with a cane walks on, and what a cane cannot bear.
    fn check_cane(&self, request: &WalkRequest) -> Result<(), GaitError> {
        let holds = cfg!(feature = "cane") && self.body.cane.is_some();
        if holds && request.ground != WalkGround::Level {
            return Err(BodyError::HoldsCane { figure: self.figure.name().to_owned() }.into());
        }
        match request.cane_load {
            Some(_) if !holds => Err(RequestError::NoCane.into()),
            Some(load) => {
                let why = || "; wrists do not bear more".to_owned();
                Ok(range("cane load", load, " of the vertical force", CANE_LOADS, why)?)
            }
            None => Ok(()),
        }
    }

    fn planned_with(
        &self,
        request: &WalkRequest,
        part: f64,
        route: &Route,
        numbers: &WalkNumbers,
        has_steady: bool,
    ) -> Result<WalkPlan, GaitError> {
        let mut styling = Styling::of(request, self.body, part);
        styling.has_steady = has_steady;
        self.check_cane(request)?;
        let planned = |route: &Route| {
            route.plan(self.body, self.standing, &styling, numbers, request.left_first, request.resolution)
        };
        let plan = planned(route).map_err(|error| match error {
            // Laws of people of usual height that leave no room for one another.
            GaitError::Profile(why) if is_unusual(self.body) => {
                not_walkable(route.pace(), why.to_string()).into()
            }
            error => error,
        })?;
        let (deviates, tempo, nearest) = (styling.deviates(), styling.law.tempo, route.easier());
        let has_steady = has_steady && route.is_level();
        let legs_differ = legs_differ(self.body);
        // In reversed time samples fall between those of the walk forward; of a cane not so many walks are known; legs that are nearly straight beside their feet last for some milliseconds.
        let least_rate = if styling.backward && !route.is_level() || self.body.cane.is_some() {
            FINEST_RATE
        } else if is_unusual(self.body) {
            FINER_RATE
        } else if request.parameters.is_empty() {
            0.0
        } else {
            FINE_RATE
        };
        let check = PlanCheck {
            figure: self.figure,
            route,
            nearest,
            deviates,
            tempo,
            has_steady,
            legs_differ,
            least_rate,
        };
        check.check(&plan)?;
        // A body that is heavier on one side is judged as it walks.
        let sided = |plan: WalkPlan| {
            if request.left_first && is_lopsided(self.body) { plan.mirrored() } else { plan }
        };
        let plan = sided(plan);
        if deviates || !route.is_even() || !route.is_level() {
            check.check_motion(&plan)?;
        } else if !request.parameters.is_empty() || is_unusual(self.body) {
            // A few of many steps decide.
            let short = if route.is_long() { Some(sided(planned(&route.shortened())?)) } else { None };
            check.check_motion(short.as_ref().unwrap_or(&plan))?;
        }
        Ok(sided(plan))
    }
}
