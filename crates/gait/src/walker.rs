//! The checked request: what may be asked of a figure, and whether the plan holds.

use crate::body::Body;
use crate::error::GaitError;
use crate::lacks;
use crate::pace;
use crate::parameter::Parameter;
use crate::prescribed::friction;
use crate::stride::{Resolution, StridePlan};
use crate::style::{Style, WALK_RATIO};
use crate::walk::{WalkPlan, steps};
use solaris_model::Figure;

/// Step frequencies that the walk was tried at (steps/min).
pub const STEP_FREQUENCY: (f64, f64) = (60.0, 118.0);
/// Numbers of steps.
pub const STEPS: (usize, usize) = (1, 10_000);
/// Shortest distance (m).
pub const SHORTEST_DISTANCE: f64 = 0.1;
/// Part of people's step length by which it may be longer or shorter.
const STEP_LENGTH_MARGIN: f64 = 0.12;
/// Friction that a plan may need: in total, and of one foot that bears more than 5 % of the weight.
pub const FRICTION: (f64, f64) = (0.5, 0.6);
/// The most by which a knee may be hyperextended before a walk is refused (rad).
const HYPEREXTENSION: f64 = 1.0 * std::f64::consts::PI / 180.0;

/// How far to walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// So many steps; the other foot then closes beside.
    Steps(usize),
    /// So far (m), met exactly, in as few steps as people's step length allows.
    Distance(f64),
}

/// What is asked. Of step frequency, step length and speed any two decide the third; what is left open is people's.
///
/// ```
/// use solaris_gait::{Extent, WalkRequest, walk};
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let request = WalkRequest { step_frequency: Some(100.0), extent: Extent::Distance(5.0), ..WalkRequest::default() };
/// let plan = walk(&ann, &request)?;
/// assert!((plan.prints().last().unwrap() - 5.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WalkRequest {
    /// Steps a minute.
    pub step_frequency: Option<f64>,
    /// Length of a step (m): the distance of the heel prints of one foot and then the other, which the thesis calls a
    /// stride. People's is 0.0037·height·frequency.
    pub step_length: Option<f64>,
    /// Speed of the steady part (m/s).
    pub speed: Option<f64>,
    /// How far.
    pub extent: Extent,
    /// Whether the left foot makes the first step; else the right one.
    pub left_first: bool,
    /// Parameters of the style by name (see [`crate::PARAMETERS`]), in their units.
    pub parameters: Vec<(&'static str, f64)>,
    /// How finely to plan.
    pub resolution: Resolution,
}

impl Default for WalkRequest {
    fn default() -> Self {
        Self {
            step_frequency: None,
            step_length: None,
            speed: None,
            extent: Extent::Steps(10),
            left_first: false,
            parameters: Vec::new(),
            resolution: Resolution::default(),
        }
    }
}

/// Plans a walk, from standing to standing.
///
/// # Errors
///
/// [`GaitError`] for a figure that the walker does not know, for values out of range (with the range), for a walk that
/// needs more friction than soles have (with the longest step that holds), and for one that the legs cannot do.
pub fn walk(figure: &Figure, request: &WalkRequest) -> Result<WalkPlan, GaitError> {
    lacks::check(figure)?;
    let body = Body::of(figure)?;
    let pace = Pace::of(request, body.height)?;
    let plan = pace.plan(&body, request)?;
    pace.check(&plan).map_err(|error| pace.advise(error, &body, request))?;
    Ok(if request.left_first { plan.mirrored() } else { plan })
}

/// Step frequency, step length and number of steps.
#[derive(Clone, Copy, Debug)]
struct Pace {
    step_frequency: f64,
    step_length: f64,
    steps: usize,
}

impl Pace {
    fn of(request: &WalkRequest, height: f64) -> Result<Self, GaitError> {
        let (step_frequency, step_length) = settle(request, height)?;
        range("step frequency", step_frequency, " steps/min", STEP_FREQUENCY, || {
            "; slower and faster gaits are not this walk: the forces leave people's range".to_owned()
        })?;
        let default = WALK_RATIO * height * step_frequency;
        let longer = longest_over_default(step_frequency);
        let (lower, upper) = (default * (1.0 - STEP_LENGTH_MARGIN), default * (1.0 + longer));
        if !(lower * (1.0 - 1e-9)..=upper * (1.0 + 1e-9)).contains(&step_length) {
            let at = format!("at {} steps/min", tidy(step_frequency));
            let why = format!(
                " (people of {height} m take {default:.3} m; shorter or longer, forces and knees leave people's range)"
            );
            // The parameter that was given is the one to name.
            return Err(match (request.step_length, request.speed) {
                (None, Some(value)) => {
                    let (lower, upper) = (lower * step_frequency / 60.0, upper * step_frequency / 60.0);
                    GaitError::StepLength { parameter: "speed", value, unit: " m/s", lower, upper, at, why }
                }
                _ => GaitError::StepLength {
                    parameter: "step length",
                    value: step_length,
                    unit: " m",
                    lower,
                    upper,
                    at,
                    why,
                },
            });
        }
        let (steps, step_length) = match request.extent {
            Extent::Steps(steps) => (steps, step_length),
            Extent::Distance(distance) => {
                let longest = STEPS.1 as f64 * step_length;
                range("distance", distance, " m", (SHORTEST_DISTANCE, longest.floor()), || {
                    format!(", {} steps at most", STEPS.1)
                })?;
                steps::for_distance(distance, step_length)
            }
        };
        let (lower, upper) = (STEPS.0 as f64, STEPS.1 as f64);
        range("steps", steps as f64, "", (lower, upper), String::new)?;
        Ok(Self { step_frequency, step_length, steps })
    }

    fn plan(&self, body: &Body, request: &WalkRequest) -> Result<WalkPlan, GaitError> {
        let mut style = Style::of(&body.leg, body.height, self.step_frequency, self.step_length);
        for (name, value) in &request.parameters {
            let parameter = Parameter::named(name).ok_or_else(|| {
                let known = crate::PARAMETERS.iter().map(|p| p.name).collect::<Vec<_>>().join(", ");
                GaitError::UnknownParameter { name: (*name).to_owned(), known }
            })?;
            parameter.set(&mut style, *value)?;
        }
        let stride = StridePlan::plan(body.clone(), &style, request.resolution)?;
        WalkPlan::new(&stride, self.steps, request.resolution)
    }

    /// Whether soles and legs can do what the plan asks of them.
    fn check(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        self.check_forces(plan)?;
        self.check_legs(plan)
    }

    /// The prescribed forces press, and need no more friction than soles have.
    fn check_forces(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        let (_, (first, last)) = plan.nodes();
        let (mut total, mut single) = (0.0_f64, 0.0_f64);
        for node in first..=last {
            let feet = plan.forces(node);
            let force = feet[0].force + feet[1].force;
            if force.y.is_nan() || force.y <= 0.0 {
                return Err(self.not_walkable("the ground would have to pull at the feet".to_owned()));
            }
            total = total.max(friction(&force));
            for foot in feet.iter().filter(|foot| foot.force.y > 0.05 * plan.weight()) {
                single = single.max(friction(&foot.force));
            }
        }
        for (whose, friction, limit) in [("the", total, FRICTION.0), ("a foot's", single, FRICTION.1)] {
            if friction.is_nan() || friction > limit {
                return Err(GaitError::Friction {
                    step_length: self.step_length,
                    step_frequency: tidy(self.step_frequency),
                    whose,
                    friction,
                    limit,
                    longest: String::new(),
                });
            }
        }
        Ok(())
    }

    /// The legs reach their feet, the knees bend the right way, the feet stay above the ground.
    fn check_legs(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        let legs = plan.legs();
        let fails = |bad: bool, what: String| if bad { Err(self.not_walkable(what)) } else { Ok(()) };
        let (knee, lowest, short) = (legs.least_knee, legs.lowest, legs.short);
        fails(
            knee.is_nan() || knee < -HYPEREXTENSION,
            format!("a knee would be hyperextended by {:.1}°", -knee.to_degrees()),
        )?;
        fails(
            lowest.is_nan() || lowest < -1e-3,
            format!("a foot would sink {:.1} mm into the ground", -lowest * 1e3),
        )?;
        fails(
            short.is_nan() || short > 1e-4,
            format!("a leg is {:.1} mm too short to reach its foot on the ground", short * 1e3),
        )
    }

    fn not_walkable(&self, what: String) -> GaitError {
        let (step_length, step_frequency) = (self.step_length, tidy(self.step_frequency));
        GaitError::NotWalkable { step_length, step_frequency, what }
    }

    /// Says how long a step may be where friction is the reason: the longest that holds, by ten bisections.
    fn advise(&self, error: GaitError, body: &Body, request: &WalkRequest) -> GaitError {
        let GaitError::Friction { step_length, step_frequency, whose, friction, limit, .. } = error else {
            return error;
        };
        let holds = |length: f64| {
            // A few steps decide: the shifts at the ends are the worst.
            let pace = Self { step_length: length, steps: self.steps.min(10), ..*self };
            pace.plan(body, request).and_then(|plan| pace.check(&plan)).is_ok()
        };
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
        GaitError::Friction { step_length, step_frequency, whose, friction, limit, longest }
    }
}

/// Step frequency and step length from what was given; positive and finite.
fn settle(request: &WalkRequest, height: f64) -> Result<(f64, f64), GaitError> {
    let given = [
        ("step frequency", request.step_frequency, " steps/min", STEP_FREQUENCY),
        ("step length", request.step_length, " m", (0.01, 2.0)),
        ("speed", request.speed, " m/s", (0.01, 3.0)),
    ];
    for (name, value, unit, limits) in given {
        if let Some(value) = value {
            range(name, value, unit, limits, String::new)?;
        }
    }
    pace::settle(request.step_frequency, request.step_length, request.speed, WALK_RATIO * height)
}

/// A number for people: four decimals at most.
fn tidy(number: f64) -> f64 {
    (number * 1e4).round() / 1e4
}

/// How much longer than people's a step may be: 12 %, falling to 6 % from 115 to 118 steps/min, where ten steps would
/// need friction that no sole has.
fn longest_over_default(step_frequency: f64) -> f64 {
    let past = ((step_frequency - 115.0) / 3.0).clamp(0.0, 1.0);
    STEP_LENGTH_MARGIN * (1.0 - 0.5 * past)
}

fn range(
    parameter: &'static str,
    value: f64,
    unit: &'static str,
    (lower, upper): (f64, f64),
    why: impl Fn() -> String,
) -> Result<(), GaitError> {
    if (lower..=upper).contains(&value) {
        Ok(())
    } else {
        Err(GaitError::Range { parameter, value, unit, lower, upper, why: why() })
    }
}
