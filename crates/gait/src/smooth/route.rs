//! The route: a request's steps, each with its pace.

use crate::body::{Body, LegGeometry};
use crate::error::{GaitError, RequestError};
use crate::request::Resolution;
use crate::request::pace::{Given, Pace, SHORTEST_STEP, STEP_LENGTH_MARGIN, StepLaw, range, tidy};
use crate::request::{
    CHANGING_STEPS, Extent, SHORTEST_DISTANCE, STAIR_COUNT, STEP_FREQUENCY, STEPS, TURN, WalkGround,
    WalkPath, WalkRequest, check_turned,
};
use crate::smooth::distance::to_distance;
use crate::smooth::ends::{ENDS, eased};
use crate::smooth::laid::{Laid, lay};
use crate::smooth::slope::{SLOPES, step_length_on_slope};
use crate::smooth::stride::StridePlan;
use crate::smooth::style::{Style, StyleTable};
use crate::smooth::styling::{Gone, Styling};
use crate::smooth::variant::StyleVariant;
use crate::smooth::walk::{
    Easing, Grounded, LEAD, Step, StepKind, Steps, Terrain, WalkNumbers, WalkPlan, Way, steps,
};

/// The step frequency of short steps that turn, where none is given (steps/min).
const TURNING_STEP_FREQUENCY: f64 = 90.0;
/// As many steps of one pace as decide whether it holds: the shifts at the ends are the worst, and a fast walk has gained its speed
/// after eight.
pub(super) const DECIDE: usize = 14;

/// As many stairs do.
const DECIDING_STAIRS: usize = 6;

/// Leaves no more stairs than decide whether they hold.
pub(super) fn leave_few_stairs(ground: &mut WalkGround) {
    if let WalkGround::Stairs(stairs) = ground {
        stairs.count = stairs.count.min(DECIDING_STAIRS);
    }
}

/// As many steps begin a walk, and end it, in a style of their own, and as many before and after one that turns; walks of fewer steps than the last
/// have no other.
const FIRST_STEPS: usize = 2;
const LAST_STEPS: usize = 3;
const NEAR_A_TURN: usize = 2;
const LEAST_STEPS: usize = 8;
/// The fastest steps that have the style of a steady gait (steps/min), of steps that are alike and of such that differ: faster ones come to no more
/// facts of people in it and need more friction, or their passes do not come to agree.
const FASTEST_STEADY: [f64; 2] = [119.5, 115.5];

/// Some steps of one pace.
#[derive(Clone, Copy, Debug)]
struct Part {
    steps: usize,
    pace: Pace,
    turn: f64,
    /// Length of its steps (m) where they are shorter than any that a pace has.
    length: Option<f64>,
    /// Which way its step goes on a path (rad), and where to.
    laid: Option<Laid>,
}

/// The parts of a walk, checked for range.
#[derive(Clone, Debug)]
pub(crate) struct Route {
    parts: Vec<Part>,
    ground: WalkGround,
    /// How it goes over ground.
    way: Way,
}

impl Route {
    /// For a body with this law of step length that faces `heading` to the left of z (rad).
    pub(crate) fn of(
        request: &WalkRequest,
        body: &Body,
        law: &StepLaw,
        heading: f64,
    ) -> Result<Self, GaitError> {
        if let WalkGround::Slope(slope) = request.ground {
            let limits = (tidy(SLOPES.0.to_degrees()), tidy(SLOPES.1.to_degrees()));
            range("slope", tidy(slope.to_degrees()), "°", limits, String::new)?;
        }
        let law = &law.times(on_slope(&request.ground));
        let given = Given {
            step_frequency: request.step_frequency,
            step_length: request.step_length,
            speed: request.speed,
        };
        let (mut pace, mut length) = if let Some(found) = turning_short(&given, law, request.turn) {
            found?
        } else {
            let shortest = if request.turn == 0.0 { 1.0 - STEP_LENGTH_MARGIN } else { SHORTEST_STEP };
            (given.settle(law, shortest)?, None)
        };
        if let Some(path) = &request.path {
            return Self::along(path, request, pace, body, heading);
        }
        let mut steps = match request.extent {
            Extent::Steps(steps) => steps,
            Extent::Distance(distance) => {
                let longest = STEPS.1 as f64 * pace.step_length;
                range("distance", distance, " m", (SHORTEST_DISTANCE, longest.floor()), || {
                    format!(", {} steps at most", STEPS.1)
                })?;
                let (steps, length) =
                    to_distance(distance, (&request.ground, false), &body.leg, pace, law.tempo);
                pace.step_length = length;
                steps
            }
        };
        if let (Extent::Distance(distance), false) = (request.extent, request.then.is_empty()) {
            return Err(RequestError::DistanceThenMore { distance }.into());
        }
        if let WalkGround::Stairs(stairs) = &request.ground {
            let (lower, upper) = STAIR_COUNT;
            range("stairs", stairs.count as f64, "", (lower as f64, upper as f64), String::new)?;
        }
        let mut parts = Vec::new();
        let mut turned = heading;
        for (number, next) in std::iter::once(None).chain(request.then.iter().map(Some)).enumerate() {
            let turn = next.map_or(request.turn, |next| next.turn);
            let checked = || -> Result<Part, GaitError> {
                let (mut steps, mut pace, mut length) = (steps, pace, length);
                if let Some(next) = next {
                    let given = Given {
                        step_frequency: next.step_frequency,
                        step_length: next.step_length,
                        speed: next.speed,
                    };
                    steps = next.steps;
                    (pace, length) = match turning_short(&given, law, turn) {
                        _ if given.nothing() => (pace, length),
                        Some(found) => found?,
                        None => (given.settle(law, SHORTEST_STEP)?, None),
                    };
                }
                let (lower, upper) = (STEPS.0 as f64, STEPS.1 as f64);
                range("steps", steps as f64, "", (lower, upper), String::new)?;
                let limit = tidy(TURN.to_degrees());
                range("turn", turn.to_degrees(), "°", (-limit, limit), || " a step".to_owned())?;
                Ok(Part { steps, pace, turn, length, laid: None })
            };
            let part = checked().map_err(|why| match number {
                0 => why,
                _ => GaitError::InPart { number: number + 1, why: Box::new(why) },
            })?;
            (steps, pace, length) = (part.steps, part.pace, part.length);
            turned += part.turn * part.steps as f64;
            check_turned(body.root_order, turned)?;
            parts.push(part);
        }
        let all = parts.iter().fold(0_usize, |all, part| all.saturating_add(part.steps));
        let ground = request.ground.clone();
        let route = Self { parts, ground, way: Way::USUAL };
        if !route.is_level() && (!route.is_even() || request.is_uneven() || heading != 0.0) {
            let what = "turns, changes of pace, steps that differ and a second walk";
            return Err(RequestError::NotOnTerrain { what }.into());
        }
        let most = if route.is_even() && !request.is_uneven() { STEPS.1 } else { CHANGING_STEPS };
        range("steps in all", all as f64, "", (STEPS.0 as f64, most as f64), || {
            " where pace or direction change on the way".to_owned()
        })?;
        Ok(route)
    }

    /// Steps along a way.
    fn along(
        path: &WalkPath,
        request: &WalkRequest,
        pace: Pace,
        body: &Body,
        heading: f64,
    ) -> Result<Self, GaitError> {
        if request.ground != WalkGround::Level {
            return Err(RequestError::NotOnTerrain { what: "a path" }.into());
        }
        let given = [("steps that turn", request.turn != 0.0), ("more steps", !request.then.is_empty())];
        if let Some((what, _)) = given.into_iter().find(|(_, given)| *given) {
            return Err(RequestError::PathAndMore { what }.into());
        }
        range("step frequency", pace.step_frequency, " steps/min", (STEP_FREQUENCY.0, ENDS), || {
            " along a path".to_owned()
        })?;
        check_turned(body.root_order, path.widest().max((heading + path.turns()).abs()))?;
        let parts = lay(path, pace, 0.5 * body.leg.foot_length())?.into_iter().map(|laid| Part {
            steps: 1,
            pace: laid.pace,
            turn: laid.turn,
            length: Some(laid.length),
            laid: Some(laid),
        });
        Ok(Self { parts: parts.collect(), ground: WalkGround::Level, way: Way::USUAL })
    }

    /// Where a step of a path leads (x, z; m); both count from 1.
    pub(crate) fn place_of(&self, step: usize) -> Option<[f64; 2]> {
        Some(self.parts.get(step.checked_sub(1)?)?.laid?.place)
    }

    /// The pace of the first part.
    pub(crate) fn pace(&self) -> Pace {
        self.parts[0].pace
    }

    /// The same on level ground, where steps are longer than down a slope.
    pub(crate) fn level_pace(&self) -> Pace {
        let Pace { step_frequency, step_length } = self.pace();
        Pace { step_frequency, step_length: step_length / on_slope(&self.ground) }
    }

    /// The number of the part that a step belongs to; both count from 1.
    pub(crate) fn part_of(&self, step: usize) -> usize {
        let mut last = 0;
        let ends = self.parts.iter().map(|part| {
            last += part.steps;
            last
        });
        ends.take_while(|&end| end < step).count() + 1
    }

    /// The first part alone, with steps of another length, and no more than `most` of them.
    pub(crate) fn with_step_length(&self, step_length: f64, most: usize) -> Self {
        let steps = self.parts[0].steps.min(most);
        self.with_pace(Pace { step_length, ..self.pace() }, Some(steps))
    }

    /// As many steps of the first part at another pace; its own where no number is told.
    pub(crate) fn with_pace(&self, pace: Pace, steps: Option<usize>) -> Self {
        let first = self.parts[0];
        let parts = vec![Part { pace, steps: steps.unwrap_or(first.steps), length: None, ..first }];
        Self { parts, ground: self.ground.clone(), way: self.way }
    }

    /// The same in the second way to go over ground.
    pub(crate) fn otherwise(&self) -> Self {
        Self { way: Way { otherwise: true, ..self.way }, ..self.clone() }
    }

    /// The same in another style of its slope or its stairs.
    pub(crate) fn varied(&self, style: &'static StyleVariant) -> Self {
        Self { way: Way { style, ..self.way }, ..self.clone() }
    }

    /// The same, slower at its ends.
    pub(crate) fn eased(&self, easing: Easing) -> Self {
        Self { way: Way { easing, ..self.way }, ..self.clone() }
    }

    /// Whether what does not hold at a step, which count from 1, may do so with slower ends: at one of them that is slower, where the ground says how
    /// long steps are.
    pub(crate) fn may_ease(&self, step: usize, easing: &Easing) -> bool {
        let given =
            matches!(self.ground, WalkGround::Stairs(_) | WalkGround::Footholds(_) | WalkGround::Slope(_));
        given && (step + LEAD > self.count() || step <= LEAD && easing.eases_beginnings())
    }

    /// The number of its steps.
    fn count(&self) -> usize {
        match &self.ground {
            WalkGround::Stairs(stairs) => stairs.count + 2 * LEAD,
            WalkGround::Footholds(footholds) => footholds.len(),
            _ => self.parts.iter().map(|part| part.steps).sum(),
        }
    }

    /// The same with no more steps than decide whether it holds: those of its beginning and its end, and some between.
    pub(crate) fn shortened(&self) -> Self {
        let mut shorter = self.clone();
        if let ([first], true) = (&mut shorter.parts[..], self.is_even()) {
            first.steps = first.steps.min(DECIDE);
        }
        leave_few_stairs(&mut shorter.ground);
        shorter
    }

    /// Whether it has more steps than [`Self::shortened`].
    pub(crate) fn is_long(&self) -> bool {
        match &self.ground {
            WalkGround::Stairs(stairs) => stairs.count > DECIDING_STAIRS,
            _ => self.is_even() && self.parts[0].steps > DECIDE,
        }
    }

    /// Whether there is only one part, straight on.
    pub(crate) fn is_even(&self) -> bool {
        matches!(self.parts[..], [Part { turn, .. }] if turn == 0.0)
    }

    /// Whether it begins or ends in a turn, or goes along a path.
    pub(crate) fn ends_in_a_turn(&self) -> bool {
        [self.parts.first(), self.parts.last()]
            .into_iter()
            .flatten()
            .any(|part| part.turn != 0.0 || part.laid.is_some())
    }

    /// Whether all goes over a horizontal plane.
    pub(crate) fn is_level(&self) -> bool {
        self.ground == WalkGround::Level
    }

    /// What to try where the ground asks too much.
    pub(crate) fn easier(&self) -> &'static str {
        match &self.ground {
            WalkGround::Level => "",
            WalkGround::Slope(_) => "take a gentler slope, or walk slower",
            WalkGround::Stairs(_) => "take lower stairs or deeper treads, or walk slower",
            WalkGround::Relief(_) => "smooth the ground there, or walk slower",
            WalkGround::Footholds(_) => "make the footholds there more alike, or walk slower",
        }
    }

    /// Plans the walk over ground that is not level.
    fn plan_on_ground(
        &self,
        body: &Body,
        styling: &Styling<'_>,
        numbers: &WalkNumbers,
        mirrored: bool,
        resolution: Resolution,
    ) -> Result<WalkPlan, GaitError> {
        let pace = self.level_pace();
        let count = self.count();
        let levels = steps::even(count, pace.step_length);
        let table = StyleTable::on_ground();
        // Feet stay as far apart as the pace has them, however long a step is.
        let level = styling.style_from(&table, body, &pace)?;
        let width = level.step_width;
        let usual = (pace.step_length, width);
        let Some(terrain) = Terrain::of(&self.ground, &body.leg, usual, &levels, mirrored, self.way)? else {
            unreachable!("ground that is not level")
        };
        let on_tread =
            |tread: f64| Style::from_table(&table, &body.leg, body.height, pace.step_frequency, tread);
        let style = |kind: StepKind| {
            Ok(match kind {
                StepKind::Slope(slope, step_length) => {
                    let walked = Pace { step_length, ..pace };
                    let style = Style { step_width: width, ..styling.style_from(&table, body, &walked)? };
                    style.on_slope(&body.leg, body.height, slope).varied(self.way.style)
                }
                // Planted feet do not turn: they point as on the level.
                StepKind::Stairs { rise, tread } => Style {
                    foot_yaw: level.foot_yaw,
                    manner: level.manner,
                    ..on_tread(tread).on_stairs(&body.leg, body.height, rise).varied(self.way.style)
                },
            })
        };
        let grounded = Grounded::new(body, &terrain, pace.step_length, &style, resolution)?;
        let stride = StridePlan::plan(body.clone(), &style(terrain.kinds[count / 2])?, resolution)?;
        let steps = Steps {
            strides: std::slice::from_ref(&stride),
            standing: 0,
            steady: 0,
            numbers: *numbers,
            cane_load: styling.cane_load,
            whole: &terrain.steps,
            planned: None,
            ground: Some(&grounded),
        };
        WalkPlan::of_steps(&steps, resolution)
    }

    /// Plans the walk. `standing` is the style in which the feet stand before it, that of the first step where there is none;
    /// `mirrored` turns everything the other way.
    pub(crate) fn plan(
        &self,
        body: &Body,
        standing: Option<&Style>,
        styling: &Styling<'_>,
        numbers: &WalkNumbers,
        mirrored: bool,
        resolution: Resolution,
    ) -> Result<WalkPlan, GaitError> {
        if !self.is_level() {
            return self.plan_on_ground(body, styling, numbers, mirrored, resolution);
        }
        let mut gone = Vec::new();
        let mut steps_of = |parts: &[Part]| steps_of(parts, styling, &body.leg, mirrored, &mut gone);
        let whole = steps_of(&self.parts);
        let repeats = self.is_even() && !styling.is_uneven();
        let planned = Steps::repeated(whole.len()).filter(|_| repeats).map(|steps| {
            let part = Part { steps, ..self.parts[0] };
            steps_of(&[part])
        });
        let mut strides = Vec::new();
        for gone in &gone {
            let style = styling.style(body, gone)?;
            strides.push(StridePlan::plan(body.clone(), &style, resolution)?);
        }
        // The middle of the first part is what it is called after.
        let (first, steady) = (whole[0].pace, whole[(self.parts[0].steps - 1) / 2].pace);
        let standing = match standing {
            Some(before) => {
                let next = strides[first].style;
                let [from, to] = [before.foot_yaw, next.foot_yaw].map(f64::to_degrees);
                if (from - to).abs() > 1e-9 {
                    return Err(RequestError::FeetWouldTurn { from, to }.into());
                }
                // All that a standing posture depends on.
                let (step_width, thorax_lean) = (before.step_width, before.thorax_lean);
                let manner = next.manner.standing_as(&before.manner);
                let anterior_tilt = before.anterior_tilt;
                let style = Style { anterior_tilt, manner, thorax_lean, step_width, ..next };
                strides.push(StridePlan::plan(body.clone(), &style, resolution)?);
                strides.len() - 1
            }
            None => first,
        };
        let (whole, varied) = styling.varied(body, (&whole, &gone), strides.len(), mirrored)?;
        for style in &varied {
            strides.push(StridePlan::plan(body.clone(), style, resolution)?);
        }
        let steps = Steps {
            strides: &strides,
            standing,
            steady,
            numbers: *numbers,
            cane_load: styling.cane_load,
            whole: &whole,
            planned: planned.as_deref(),
            ground: None,
        };
        WalkPlan::of_steps(&steps, resolution)
    }
}

/// The pace of steps that turn and are shorter than any that go straight on, down to none at all: the shortest one's, and their
/// length (m); nothing for others.
fn turning_short(
    given: &Given,
    law: &StepLaw,
    turn: f64,
) -> Option<Result<(Pace, Option<f64>), RequestError>> {
    let length = given.step_length.filter(|_| turn != 0.0 && given.speed.is_none())?;
    let step_frequency = given.step_frequency.unwrap_or(TURNING_STEP_FREQUENCY);
    let shortest = SHORTEST_STEP * law.ratio * step_frequency;
    if !(0.0..shortest).contains(&length) {
        return None;
    }
    let given = Given { step_frequency: Some(step_frequency), step_length: Some(shortest), speed: None };
    Some(given.settle(law, SHORTEST_STEP).map(|pace| (pace, Some(length))))
}

/// The steps of some parts; ways to go one that are new are added to `ways`. Backward, steps shorter than any that tables were fitted to have no style
/// of a steady gait: held at its ends, it would land them on less than their heels, and press beside them.
fn steps_of(
    parts: &[Part],
    styling: &Styling<'_>,
    leg: &LegGeometry,
    mirrored: bool,
    ways: &mut Vec<Gone>,
) -> Vec<Step> {
    let asked: Vec<&Part> = parts.iter().flat_map(|part| std::iter::repeat_n(part, part.steps)).collect();
    let walked = eased(asked.iter().map(|part| part.pace).collect(), styling.law.tempo);
    let fastest = FASTEST_STEADY[usize::from(styling.is_uneven())];
    let steady: Vec<bool> = (0..asked.len())
        .map(|i| {
            styling.has_steady
                && (!styling.backward || StyleTable::covers(leg, walked[i].step_length))
                && walked[i].step_frequency <= fastest * styling.law.tempo
                && is_steady(&asked, &walked, i)
        })
        .collect();
    let steps = asked.iter().zip(walked).zip(steps::factors(asked.len())).zip(steady);
    let steps = steps.map(|(((part, pace), factor), steady)| {
        let gone = Gone { pace, steady };
        let index = ways.iter().position(|known| *known == gone).unwrap_or_else(|| {
            ways.push(gone);
            ways.len() - 1
        });
        let turn = if mirrored { -part.turn } else { part.turn };
        if let Some(Laid { length, bearing, .. }) = part.laid {
            let bearing = if mirrored { -bearing } else { bearing };
            return Step { bearing, ..Step::along_an_arc(index, length, turn) };
        }
        let length = factor * part.length.unwrap_or(pace.step_length);
        Step::along_an_arc(index, length, turn)
    });
    steps.collect()
}

/// How long steps are on this ground over those on level ground.
fn on_slope(ground: &WalkGround) -> f64 {
    if let WalkGround::Slope(slope) = ground { step_length_on_slope(*slope) } else { 1.0 }
}

/// Whether a step, counted from 0, is one of a steady gait: of enough steps, not of the first or last ones, nor near to one that turns or
/// beside one of another pace.
fn is_steady(steps: &[&Part], paces: &[Pace], i: usize) -> bool {
    let turns = |part: &&Part| part.turn != 0.0 || part.laid.is_some();
    let within = |reach: usize| i.saturating_sub(reach)..(i + reach + 1).min(steps.len());
    steps.len() >= LEAST_STEPS
        && i >= FIRST_STEPS
        && i + LAST_STEPS < steps.len()
        && !steps[within(NEAR_A_TURN)].iter().any(turns)
        && paces[within(1)].iter().all(|pace| *pace == paces[i])
}
