//! The walk in the thesis's style, from a request that is checked.

use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, PostureError, RequestError};
use crate::request::pace;
use crate::request::{Extent, SHORTEST_DISTANCE, STEPS};
use crate::thesis::determinants::{
    Determinants, DoubleSupport, KeySolution, Proportions, THESIS_WALK_RATIO, USUAL_HEIGHT,
};
use crate::thesis::keyframed::{InBetween, KeyScript, KeyframedOptions, KeyframedWalk, ScriptCycle};
use crate::walking::G;
use solaris_model::Figure;

/// The parameter that is the step length, too.
const STEP_LENGTH: &str = "step-length";

/// Step frequencies of walks in the thesis's style (steps/min): its double support ends at 181.75. The speed may be
/// √(g·leg) at most, which three determinants with the thesis's step length come to at 161 steps/min for 1.75 m.
pub const THESIS_STEP_FREQUENCY: (f64, f64) = (30.0, 180.0);

/// What is asked of a walk in the thesis's style: key postures of three or five determinants, and profiles between them.
///
/// ```
/// use solaris_gait::{ThesisRequest, thesis_walk};
/// use solaris_model::{Trajectory, human};
///
/// let ann = human(1.65, 58.0)?;
/// let request = ThesisRequest { step_frequency: Some(100.0), ..ThesisRequest::default() };
/// let plan = thesis_walk(&ann, &request)?;
/// // Ten steps of 0.004·H·sf.
/// assert!((plan.walk.prints()[9] - 10.0 * 0.004 * 1.65 * 100.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ThesisRequest {
    /// How many determinants.
    pub determinants: Determinants,
    /// Steps a minute.
    pub step_frequency: Option<f64>,
    /// Length of a step (m); the thesis's is 0.004·height·frequency.
    pub step_length: Option<f64>,
    /// Speed (m/s).
    pub speed: Option<f64>,
    /// How far.
    pub extent: Extent,
    /// Parameters of the key postures by name, in their units ([`Determinants::parameters`]); what is left out is chosen inside
    /// its bounds. A step length among them counts, but for a distance.
    pub parameters: Vec<(&'static str, f64)>,
    /// How long both feet are on the ground; without a law, of five determinants the phases last as long as the pelvis goes.
    pub double_support: Option<DoubleSupport>,
    /// What lies between the postures.
    pub in_between: InBetween,
    /// Distance of the feet's lines (m); that of the hips where none is given.
    pub step_width: Option<f64>,
    /// Amplitude of the pelvis' way to the sides (m).
    pub sway: f64,
    /// Whether the left foot makes the first step.
    pub left_first: bool,
}

impl Default for ThesisRequest {
    fn default() -> Self {
        Self {
            determinants: Determinants::default(),
            step_frequency: None,
            step_length: None,
            speed: None,
            extent: Extent::Steps(10),
            parameters: Vec::new(),
            double_support: Some(DoubleSupport::Thesis),
            in_between: InBetween::Rest,
            step_width: None,
            sway: 0.0,
            left_first: false,
        }
    }
}

/// A walk in the thesis's style.
pub struct ThesisWalk {
    /// The walk.
    pub walk: KeyframedWalk,
    /// The postures that it goes through.
    pub postures: KeySolution,
    /// The proportions they are of.
    pub proportions: Proportions,
    /// How many determinants.
    pub determinants: Determinants,
    /// What lies between the postures.
    pub in_between: InBetween,
    /// Steps a minute.
    pub step_frequency: f64,
    /// Length of a step (m).
    pub step_length: f64,
    /// Number of steps, without the closing one.
    pub steps: usize,
}

/// The postures of a request, without the walk: proportions, step frequency (steps/min), step length and the parameters'
/// values.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyChoice {
    /// Steps a minute.
    pub step_frequency: f64,
    /// Length of a step, in the unit of the proportions.
    pub step_length: f64,
    /// The parameters' values, in their units.
    pub values: Vec<f64>,
}

impl KeyChoice {
    /// The values for proportions: those that were given, the others chosen. Of step frequency, step length and speed any two
    /// decide the third.
    ///
    /// # Errors
    ///
    /// Numbers out of range, parameters that there are not, steps that nothing fits.
    pub fn of(p: &Proportions, request: &ThesisRequest) -> Result<Self, GaitError> {
        let (step_frequency, step_length) = settled(request, p)?;
        let determinants = request.determinants;
        let parameters = determinants.parameters(p);
        let mut given = vec![None; parameters.len()];
        for (name, value) in &request.parameters {
            let index = parameters.iter().position(|parameter| parameter.name == *name).ok_or_else(|| {
                let known = parameters.iter().map(|p| p.name).collect::<Vec<_>>().join(", ");
                RequestError::UnknownParameter { name: (*name).to_owned(), known }
            })?;
            let (lower, upper) = parameters[index].range;
            if !(lower..=upper).contains(value) {
                let (parameter, unit) = (parameters[index].name, parameters[index].unit);
                return Err(RequestError::Range {
                    parameter,
                    value: *value,
                    unit,
                    lower,
                    upper,
                    why: String::new(),
                }
                .into());
            }
            given[index] = Some(*value);
        }
        // The first of all parameters.
        given[0].get_or_insert(step_length);
        let values = if let Some(values) = given.iter().copied().collect::<Option<Vec<f64>>>() {
            values
        } else {
            let automatic = determinants.automatic(p, step_frequency, step_length)?;
            given.into_iter().zip(automatic).map(|(given, automatic)| given.unwrap_or(automatic)).collect()
        };
        Ok(Self { step_frequency, step_length, values })
    }

    /// The values and their postures; what is refused comes with nearest values that are not.
    ///
    /// # Errors
    ///
    /// As [`Self::of`] and [`Determinants::solve`].
    pub fn solve(p: &Proportions, request: &ThesisRequest) -> Result<(Self, KeySolution), GaitError> {
        let solved = |request: &ThesisRequest| -> Result<(Self, KeySolution), GaitError> {
            let choice = Self::of(p, request)?;
            let speed = choice.step_length * choice.step_frequency / 60.0;
            let postures = request.determinants.solve(p, &choice.values, speed)?;
            Ok((choice, postures))
        };
        solved(request).map_err(|error| request.with_hints(error, |changed| solved(changed).is_ok()))
    }
}

impl ThesisRequest {
    /// The error with those nearest values alone that `works` accepts in place of what was asked.
    fn with_hints(&self, error: GaitError, works: impl Fn(&Self) -> bool) -> GaitError {
        let (determinants, why) = match error {
            GaitError::Posture(PostureError::Infeasible { determinants, why }) => (determinants, why),
            other => return other,
        };
        let why = why.checked(|name, value| {
            let mut changed = self.clone();
            changed.parameters.retain(|(known, _)| *known != name);
            if name == STEP_LENGTH {
                changed.step_length = Some(value);
            } else {
                changed.parameters.push((name, value));
            }
            works(&changed)
        });
        PostureError::Infeasible { determinants, why: Box::new(why) }.into()
    }
}

/// Plans a walk in the thesis's style, from standing to standing.
///
/// # Errors
///
/// [`GaitError`] for a figure that the walker does not know, for values out of range, and [`PostureError::Infeasible`] for
/// parameters that no posture fits, with the inequality that fails and the nearest values that do.
pub fn thesis_walk(figure: &Figure, request: &ThesisRequest) -> Result<ThesisWalk, GaitError> {
    let refuse = |error| request.with_hints(error, |changed| planned(figure, changed).is_ok());
    planned(figure, request).map_err(refuse)
}

/// The walk, or why there is none, with nearest values that nobody has tried.
pub(crate) fn planned(figure: &Figure, request: &ThesisRequest) -> Result<ThesisWalk, GaitError> {
    missing::check(figure)?;
    let body = Body::of(figure)?.with_legs_alike()?;
    let proportions = Proportions::of_leg(&body.leg, body.height);
    let mut request = request.clone();
    let steps = match request.extent {
        Extent::Steps(steps) => steps,
        Extent::Distance(distance) => {
            let (frequency, longest) = settled(&request, &proportions)?;
            pace::range(
                "distance",
                distance,
                " m",
                (SHORTEST_DISTANCE, STEPS.1 as f64 * longest),
                String::new,
            )?;
            let steps = ((distance / longest - 1e-9).ceil() as usize).max(1);
            (request.step_frequency, request.speed) = (Some(frequency), None);
            request.parameters.retain(|(name, _)| *name != STEP_LENGTH);
            request.step_length = Some(distance / steps as f64);
            steps
        }
    };
    pace::range("steps", steps as f64, "", (STEPS.0 as f64, STEPS.1 as f64), String::new)?;
    let choice = KeyChoice::of(&proportions, &request)?;
    let KeyChoice { step_frequency, step_length, ref values } = choice;
    let speed = step_length * step_frequency / 60.0;
    check_speed(speed, body.leg.length())?;
    let postures = request.determinants.solve(&proportions, values, speed)?;
    let parts = postures.parts(&proportions, request.double_support, step_frequency);
    let mut parts = parts.into_iter();
    let cycles =
        postures.cycles.clone().map(|phases| ScriptCycle { phases, parts: parts.next().unwrap_or_default() });
    let script = KeyScript { cycles, steps, step_length, step_time: 60.0 / step_frequency };
    let options = KeyframedOptions {
        in_between: request.in_between,
        step_width: request.step_width,
        sway: request.sway,
        clearance: 0.015 * body.height / 1.75,
        left_first: request.left_first,
    };
    let walk = KeyframedWalk::new(figure, &script, options)?;
    let ThesisRequest { determinants, in_between, .. } = request;
    Ok(ThesisWalk {
        walk,
        postures,
        proportions,
        determinants,
        in_between,
        step_frequency,
        step_length,
        steps,
    })
}

/// Refuses speeds at which nobody walks: a body that passes over a straight leg of length l falls round it with v²/l, and where
/// gravity is less than that it flies.
///
/// ```text
/// v² ≤ g·l        (Froude number v²/(g·l) of at most 1)
/// ```
fn check_speed(speed: f64, leg: f64) -> Result<(), GaitError> {
    let most = (G * leg).sqrt();
    if speed <= most {
        return Ok(());
    }
    let why =
        "; faster, a body that passes over a straight leg leaves the ground: take shorter or fewer steps";
    let (lower, upper) = (0.0, (100.0 * most).floor() / 100.0);
    Err(RequestError::Range {
        parameter: "speed",
        value: speed,
        unit: " m/s",
        lower,
        upper,
        why: why.to_owned(),
    }
    .into())
}

/// Step frequency and step length: two of three numbers, or what the thesis's `S = 0.004·H·sf` says.
fn settled(request: &ThesisRequest, p: &Proportions) -> Result<(f64, f64), GaitError> {
    // A length that was given as a parameter is one all the same.
    let parameter = request.parameters.iter().find(|(name, _)| *name == STEP_LENGTH).map(|(_, value)| *value);
    let (frequency, length, speed) =
        (request.step_frequency, parameter.or(request.step_length), request.speed);
    if let Some(length) = length {
        pace::range("step length", length, " m", (1e-3 * p.height, 3.0 * p.height), String::new)?;
    }
    if let Some(value) = speed {
        let (lower, upper) = speeds(p);
        if !(lower..=upper).contains(&value) {
            let (lower, upper) = (pace::tidy(lower), pace::tidy(upper));
            let (parameter, unit, why) = ("speed", " m/s", String::new());
            return Err(RequestError::Range { parameter, value, unit, lower, upper, why }.into());
        }
    }
    let (frequency, length) = pace::settle(frequency, length, speed, THESIS_WALK_RATIO * p.height)?;
    pace::range("step frequency", frequency, " steps/min", THESIS_STEP_FREQUENCY, String::new)?;
    Ok((frequency, length))
}

/// Speeds that are looked at, in the proportions' unit a second: 0.00175 to 5.25 m/s at 1.75 m, and at other heights those of the
/// same Froude number v²/(g·H), 1.8e-7 to 1.6. What can be walked is less ([`check_speed`]), but needs a leg and metres.
fn speeds(p: &Proportions) -> (f64, f64) {
    let scale = (p.height * p.unit / USUAL_HEIGHT).sqrt() / p.unit;
    (1e-3 * USUAL_HEIGHT * scale, 3.0 * USUAL_HEIGHT * scale)
}
