//! Walks and runs by keyword.

use crate::arrays::contiguous;
use crate::errors::{self, plain, value};
use crate::figure::{Figure, human};
use crate::motion::Motion;
use crate::report::dictionary;
use numpy::PyUntypedArrayMethods;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Map, Value};
use solaris::gait::determinants::Determinants;
use solaris::gait::{
    Extent, Foothold, GaitError, MANNERS, PARAMETERS, PlanError, Population, RequestError, RunEnd, RunPart,
    RunPlan, RunRequest, SIDE_MANNERS, ShippedManner, Stairs, StyleSheet, StyledPlan, StyledRequest,
    ThesisRequest, Variability, WalkGround, WalkPart, WalkPath, WalkRequest, measure, measure_run,
    on_the_spot, sheet_of, side_sheet_of,
};
use solaris::model::{Relief, Trajectory as _, nearest};
use std::path::PathBuf;

/// Steps of which one in the middle is taken where a stride is to repeat itself.
const LOOPED: usize = 42;

/// A planned walk or run: its motion, what it was planned as, and its measures.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Walk {
    figure: Figure,
    plan: StyledPlan,
    motion: Motion,
    report: Value,
}

/// Plans a walk, and finds the forces of the ground and of every joint.
///
/// Who: a `figure` with the segments of a human, or a person of this `height` (m), `mass` (kg) and `age` (years).
///
/// How fast: of `step_frequency` (steps/min), `step_length` (m) and `speed` (m/s) any one, or two. How far: `steps`, or at
/// least a `distance` (m). `turn` is by how much each step turns to the left (rad); `path` are points (x left, z forward, m)
/// to walk along; `then` is a list of dictionaries of more steps, with the keys `steps`, `step_frequency`, `step_length`,
/// `speed` and `turn`.
///
/// On what: `slope` (rad, uphill), `stairs` (a dictionary with `count`, `rise` and `tread` in m), `ground` (points z, height in
/// m), or `footholds` (rows of z, height, and where known pitch and heading).
///
/// In which manner: `population` (`"adult"`, `"treadmill"`, `"child"`, `"older"`), `manner` (such as `"sad:0.6,heavy:0.3"`), `left` and
/// `right` (manners of one side), `variability` (over people's, with a `seed`), and `style`, numbers by name
/// (`solaris.style_parameters()` lists them). With `determinants` (3 or 5) it is a walk through the thesis's key postures.
///
/// `loop` makes one stride that repeats itself, `"moving"` or `"in_place"`. `rate` is in samples a second.
///
/// >>> import solaris
/// >>> walk = solaris.walk(height=1.65, mass=58.0, step_frequency=105, steps=6)
/// >>> motion = walk.motion
/// >>> motion.q.shape[1], sorted(motion.contacts)[0]
/// (66, 'left_foot')
#[pyfunction]
#[pyo3(signature = (
    figure=None, *, height=1.75, mass=None, age=None, step_frequency=None, step_length=None, speed=None, steps=None,
    distance=None, turn=0.0, path=None, then=None, slope=None, stairs=None, ground=None, footholds=None,
    population=None, manner=None, left=None, right=None, variability=None, seed=0, style=None, left_first=None,
    determinants=None, r#loop=None, rate=120.0
))]
pub(crate) fn walk(
    py: Python<'_>,
    figure: Option<&Figure>,
    height: f64,
    mass: Option<f64>,
    age: Option<f64>,
    step_frequency: Option<f64>,
    step_length: Option<f64>,
    speed: Option<f64>,
    steps: Option<usize>,
    distance: Option<f64>,
    turn: f64,
    path: Option<&Bound<'_, PyAny>>,
    then: Option<Vec<Bound<'_, PyDict>>>,
    slope: Option<f64>,
    stairs: Option<&Bound<'_, PyDict>>,
    ground: Option<&Bound<'_, PyAny>>,
    footholds: Option<&Bound<'_, PyAny>>,
    population: Option<&str>,
    manner: Option<&str>,
    left: Option<&str>,
    right: Option<&str>,
    variability: Option<f64>,
    seed: u64,
    style: Option<&Bound<'_, PyDict>>,
    left_first: Option<bool>,
    determinants: Option<u8>,
    r#loop: Option<&str>,
    rate: f64,
) -> PyResult<Walk> {
    let repeats = looped(r#loop)?;
    let extent = extent(steps, distance, if repeats.is_some() { LOOPED } else { 10 })?;
    let who = figure.map_or_else(|| human(height, mass, age, false), |figure| Ok(figure.clone()))?;
    if let Some(count) = determinants {
        let known = Determinants::ALL.into_iter().find(|known| known.count() == usize::from(count));
        let determinants =
            known.ok_or_else(|| value(format!("determinants is {count}; it must be 3 or 5")))?;
        let parameters = match style {
            Some(style) => numbers(style, || {
                let proportions =
                    solaris::gait::determinants::Proportions::of(who.figure()).map_err(value)?;
                Ok(determinants.parameters(&proportions).iter().map(|parameter| parameter.name).collect())
            })?,
            None => Vec::new(),
        };
        let request = ThesisRequest {
            determinants,
            step_frequency,
            step_length,
            speed,
            extent,
            parameters,
            left_first: left_first.unwrap_or(false),
            ..ThesisRequest::default()
        };
        return Walk::of(
            py,
            who,
            figure.is_none(),
            &StyledRequest::Thesis(request),
            (repeats, rate),
            (height, mass, age),
        );
    }
    let open = step_frequency.or(step_length).or(speed).is_none();
    let ground = on(slope, stairs, ground, footholds)?;
    let usual = ground.usual_step_frequency();
    let path = path.map(|points| WalkPath::through(&pairs("path", points)?).map_err(request)).transpose()?;
    let inner = turn > 0.0 || path.as_ref().is_some_and(|path| path.begins() > 0.0);
    let sheet = |blend: Option<&str>| {
        blend.map_or(Ok(StyleSheet::default()), |blend| sheet_of(blend).map_err(request))
    };
    let side = |blend: Option<&str>| {
        blend.map_or(Ok(StyleSheet::default()), |blend| side_sheet_of(blend).map_err(request))
    };
    let population = match population {
        None => Population::default(),
        Some(name) => Population::ALL.into_iter().find(|known| known.name() == name).ok_or_else(|| {
            value(format!("population is '{name}'; it must be 'adult', 'treadmill', 'child' or 'older'"))
        })?,
    };
    let parameters = match style {
        Some(style) => numbers(style, || Ok(PARAMETERS.iter().map(|parameter| parameter.name).collect()))?,
        None => Vec::new(),
    };
    let asked = WalkRequest {
        step_frequency: step_frequency.or(usual.filter(|_| open)),
        step_length,
        speed,
        extent,
        turn,
        then: then.unwrap_or_default().iter().map(part).collect::<PyResult<_>>()?,
        ground,
        path,
        left_first: left_first.unwrap_or(inner),
        parameters,
        population,
        sheet: sheet(manner)?,
        sides: [side(left)?, side(right)?],
        variability: variability.map(|scale| Variability { scale, seed }),
        ..WalkRequest::default()
    };
    Walk::of(py, who, figure.is_none(), &StyledRequest::Smooth(asked), (repeats, rate), (height, mass, age))
}

/// Plans a run of 2.2 to 6 m/s, with its forces.
///
/// `start` and `end` are `"running"` or `"standing"`; `then` is a list of dictionaries with the keys `steps` and `speed`. The rest is as
/// for `walk`.
///
/// >>> import solaris
/// >>> run = solaris.run_gait(speed=3.5, steps=6)
/// >>> flights = [event for event in run.motion.events if event[1] == "lift_off"]
/// >>> len(flights) > 0
/// True
#[pyfunction]
#[pyo3(signature = (
    figure=None, *, height=1.75, mass=None, age=None, speed=3.0, steps=None, distance=None, then=None, start="running",
    end="running", left_first=false, r#loop=None, rate=120.0
))]
pub(crate) fn run_gait(
    py: Python<'_>,
    figure: Option<&Figure>,
    height: f64,
    mass: Option<f64>,
    age: Option<f64>,
    speed: f64,
    steps: Option<usize>,
    distance: Option<f64>,
    then: Option<Vec<Bound<'_, PyDict>>>,
    start: &str,
    end: &str,
    left_first: bool,
    r#loop: Option<&str>,
    rate: f64,
) -> PyResult<Walk> {
    let bound = |name: &str, given: &str| match given {
        "running" => Ok(RunEnd::Running),
        "standing" => Ok(RunEnd::Standing),
        other => Err(value(format!("{name} is '{other}'; it must be 'running' or 'standing'"))),
    };
    let repeats = looped(r#loop)?;
    let who = figure.map_or_else(|| human(height, mass, age, false), |figure| Ok(figure.clone()))?;
    let part = |given: &Bound<'_, PyDict>| -> PyResult<RunPart> {
        keys("then", given, &["steps", "speed"])?;
        let (steps, speed) = (get(given, "steps")?, get(given, "speed")?);
        match (steps, speed) {
            (Some(steps), Some(speed)) => Ok(RunPart { steps, speed }),
            _ => Err(value("each of then needs 'steps' and 'speed'")),
        }
    };
    let (from, to) = (bound("start", start)?, bound("end", end)?);
    let then: Vec<RunPart> = then.unwrap_or_default().iter().map(part).collect::<PyResult<_>>()?;
    let least =
        solaris::gait::least_run_steps(speed, from, if then.is_empty() { to } else { RunEnd::Running });
    let usual = if repeats.is_some() { 2 } else { least.max(10) };
    let request = RunRequest {
        speed,
        extent: extent(steps, distance, usual)?,
        then,
        from,
        to,
        left_first,
        ..RunRequest::default()
    };
    Walk::of(py, who, figure.is_none(), &StyledRequest::Run(request), (repeats, rate), (height, mass, age))
}

/// The numbers of `walk(style=…)`: by name what it is, its unit and its least and greatest value.
///
/// >>> import solaris
/// >>> solaris.style_parameters()["arm_swing"]["unit"]
/// '°'
#[pyfunction]
pub(crate) fn style_parameters(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    for parameter in PARAMETERS {
        let one = PyDict::new(py);
        one.set_item("help", parameter.help)?;
        one.set_item("unit", parameter.unit.symbol().trim())?;
        one.set_item("range", parameter.range)?;
        all.set_item(parameter.name.replace('-', "_"), one)?;
    }
    Ok(all)
}

/// Names of the manners that ship: those of the whole body, and those of one side.
///
/// >>> import solaris
/// >>> "sad" in solaris.manners()[0], "limp" in solaris.manners()[1]
/// (True, True)
#[pyfunction]
pub(crate) fn manners() -> (Vec<&'static str>, Vec<&'static str>) {
    let names = |all: &[ShippedManner]| all.iter().map(|manner| manner.name).collect();
    (names(MANNERS), names(SIDE_MANNERS))
}

/// Whether a stride that repeats itself stays in its place.
fn looped(given: Option<&str>) -> PyResult<Option<bool>> {
    match given {
        None => Ok(None),
        Some("moving") => Ok(Some(false)),
        Some("in_place") => Ok(Some(true)),
        Some(other) => Err(value(format!("loop is '{other}'; it must be 'moving' or 'in_place'"))),
    }
}

fn extent(steps: Option<usize>, distance: Option<f64>, usual: usize) -> PyResult<Extent> {
    match (steps, distance) {
        (Some(_), Some(_)) => Err(value("give steps or distance, not both")),
        (None, Some(distance)) => Ok(Extent::Distance(distance)),
        (steps, None) => Ok(Extent::Steps(steps.unwrap_or(usual))),
    }
}

fn request(error: RequestError) -> PyErr {
    errors::gait(GaitError::Request(error))
}

/// Numbers by name, as `arm_swing` or `arm-swing`.
fn numbers(
    style: &Bound<'_, PyDict>,
    known: impl FnOnce() -> PyResult<Vec<&'static str>>,
) -> PyResult<Vec<(&'static str, f64)>> {
    let known = known()?;
    let one = |(name, number): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract()?;
        let dashed = name.replace('_', "-");
        let found = known.iter().find(|known| **known == dashed).ok_or_else(|| {
            let near = nearest(&dashed, known.iter().copied());
            let hint =
                near.map_or_else(String::new, |near| format!("; did you mean '{}'?", near.replace('-', "_")));
            value(format!("style has no number '{name}'{hint}"))
        })?;
        Ok((*found, number.extract()?))
    };
    style.iter().map(one).collect()
}

fn get<'py, T: pyo3::conversion::FromPyObjectOwned<'py>>(
    of: &Bound<'py, PyDict>,
    key: &str,
) -> PyResult<Option<T>> {
    of.get_item(key)?.map(|found| found.extract().map_err(Into::into)).transpose()
}

/// Refuses keys that mean nothing.
fn keys(name: &str, given: &Bound<'_, PyDict>, known: &[&str]) -> PyResult<()> {
    for key in given.keys() {
        let key: String = key.extract()?;
        if !known.contains(&key.as_str()) {
            return Err(value(format!("{name} has no '{key}'; its keys are {}", known.join(", "))));
        }
    }
    Ok(())
}

fn part(given: &Bound<'_, PyDict>) -> PyResult<WalkPart> {
    keys("then", given, &["steps", "step_frequency", "step_length", "speed", "turn"])?;
    Ok(WalkPart {
        steps: get(given, "steps")?.ok_or_else(|| value("each of then needs 'steps'"))?,
        step_frequency: get(given, "step_frequency")?,
        step_length: get(given, "step_length")?,
        speed: get(given, "speed")?,
        turn: get(given, "turn")?.unwrap_or_default(),
    })
}

/// Rows of two numbers.
fn pairs(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 2]>> {
    let rows = rows(name, given, 2, 2)?;
    Ok(rows.iter().map(|row| [row[0], row[1]]).collect())
}

fn rows(name: &str, given: &Bound<'_, PyAny>, least: usize, most: usize) -> PyResult<Vec<Vec<f64>>> {
    let array = contiguous(name, given)?;
    match *array.shape() {
        [_, width] if (least..=most).contains(&width) => {
            Ok(array.as_slice().unwrap_or_default().chunks_exact(width).map(<[f64]>::to_vec).collect())
        }
        ref found => {
            let width = if least == most { least.to_string() } else { format!("{least} to {most}") };
            Err(value(format!(
                "{name} has the shape {}; it must be rows of {width}",
                crate::arrays::shape(found)
            )))
        }
    }
}

/// The ground.
fn on(
    slope: Option<f64>,
    stairs: Option<&Bound<'_, PyDict>>,
    ground: Option<&Bound<'_, PyAny>>,
    footholds: Option<&Bound<'_, PyAny>>,
) -> PyResult<WalkGround> {
    Ok(match (slope, stairs, ground, footholds) {
        (None, None, None, None) => WalkGround::Level,
        (Some(slope), None, None, None) => WalkGround::Slope(slope),
        (None, Some(given), None, None) => {
            keys("stairs", given, &["count", "rise", "tread"])?;
            let usual = Stairs::default();
            WalkGround::Stairs(Stairs {
                count: get(given, "count")?.unwrap_or(usual.count),
                rise: get(given, "rise")?.unwrap_or(usual.rise),
                tread: get(given, "tread")?.unwrap_or(usual.tread),
            })
        }
        (None, None, Some(points), None) => {
            let relief = Relief::new(pairs("ground", points)?).map_err(|error| plain("WalkError")(&error))?;
            WalkGround::Relief(relief)
        }
        (None, None, None, Some(given)) => {
            let foothold = |row: Vec<f64>| {
                let at = |i: usize| row.get(i).copied().unwrap_or_default();
                Foothold { x: None, z: at(0), height: at(1), pitch: at(2), heading: at(3) }
            };
            let all = rows("footholds", given, 2, 4)?.into_iter().map(foothold).collect();
            WalkGround::Footholds(all)
        }
        _ => return Err(value("give one of slope, stairs, ground and footholds")),
    })
}

impl Walk {
    fn of(
        py: Python<'_>,
        mut figure: Figure,
        is_ours: bool,
        asked: &StyledRequest,
        (repeats, rate): (Option<bool>, f64),
        (height, mass, age): (f64, Option<f64>, Option<f64>),
    ) -> PyResult<Self> {
        let plan =
            |figure: &Figure, asked: &StyledRequest| py.detach(|| StyledPlan::of(figure.figure(), asked));
        let mut notes = Vec::new();
        let mut found = plan(&figure, asked);
        if is_ours && found.as_ref().is_err_and(GaitError::turns_too_far) {
            // Turning round needs a root that turns by its heading first.
            figure = human(height, mass, age, true)?;
            found = plan(&figure, asked);
        }
        if let (Err(GaitError::Plan(PlanError::OnlyPart { part, why })), StyledRequest::Smooth(walk)) =
            (&found, asked)
        {
            notes.push(format!(
                "{part} of the manner and of the variability is walked, for all of it would not hold: {why}"
            ));
            found = plan(&figure, &StyledRequest::Smooth(walk.in_part(*part)));
        }
        let plan = found.map_err(errors::gait)?;
        let (motion, report) = py
            .detach(|| -> Result<_, GaitError> {
                let body = figure.figure();
                let (mut motion, forces) = match repeats {
                    None => plan.loaded(body, rate)?,
                    Some(_) => plan.loaded_stride(body, rate)?,
                };
                let mut report = Map::new();
                report.insert("forces".to_owned(), forces_of(&forces));
                if let StyledPlan::Run(run) = &plan {
                    let stride = StyledPlan::Run(Box::new(RunPlan::new(run.stride().clone(), 2, true)));
                    let (stride, _) = stride.loaded_stride(body, 1.0 / run.resolution())?;
                    report.insert("run".to_owned(), json(&measure_run(body, &stride)?));
                }
                report.insert("measures".to_owned(), json(&measure(body, &motion)?));
                if repeats == Some(true) {
                    motion = on_the_spot(body, &motion)?;
                }
                Ok((motion, report))
            })
            .map_err(errors::gait)?;
        let mut report = report;
        report.insert("notes".to_owned(), Value::from(notes));
        let title = format!(
            "{} at {:.0} steps/min, {:.2} m a step",
            if matches!(plan, StyledPlan::Run(_)) { "A run" } else { "A walk" },
            plan.step_frequency(),
            plan.step_length()
        );
        let motion = Motion::new(&figure, motion, title);
        Ok(Self { figure, plan, motion, report: Value::Object(report) })
    }
}

fn json(of: &impl serde::Serialize) -> Value {
    serde_json::to_value(of).unwrap_or_default()
}

fn forces_of(forces: &solaris::gait::WalkForces) -> Value {
    match forces {
        solaris::gait::WalkForces::Prescribed(report) => json(report),
        solaris::gait::WalkForces::Needed(report, residual) => {
            serde_json::json!({ "ground": json(report), "residual": json(residual) })
        }
        solaris::gait::WalkForces::Law(residual) => json(residual),
    }
}

#[pymethods]
impl Walk {
    /// Who walks.
    #[getter]
    fn figure(&self) -> Figure {
        self.figure.clone()
    }

    /// The motion, with velocities, accelerations, the joints' forces and the ground's.
    #[getter]
    fn motion(&self) -> Motion {
        self.motion.clone()
    }

    /// Steps a minute of the steady part.
    #[getter]
    fn step_frequency(&self) -> f64 {
        self.plan.step_frequency()
    }

    /// Length of a step of the steady part (m).
    #[getter]
    fn step_length(&self) -> f64 {
        self.plan.step_length()
    }

    /// Speed of the steady part (m/s).
    #[getter]
    fn speed(&self) -> f64 {
        self.plan.step_length() * self.plan.step_frequency() / 60.0
    }

    /// How long it lasts (s).
    #[getter]
    fn duration(&self) -> f64 {
        self.plan.duration()
    }

    /// What was measured of the motion: a dictionary with its steady stride, extremes and peaks; names end in their units.
    #[getter]
    fn measures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        dictionary(py, &self.report)
    }

    /// The configuration at any time (s).
    fn configuration<'py>(&self, py: Python<'py>, time: f64) -> PyResult<Bound<'py, numpy::PyArray1<f64>>> {
        if !time.is_finite() {
            return Err(value(format!("time is {time}; it must be a finite number of seconds")));
        }
        let mut q = vec![0.0; self.figure.figure().layout().nq()];
        match &self.plan {
            StyledPlan::Smooth(plan) => plan.configuration(time, &mut q),
            StyledPlan::Sequence(plan) => plan.configuration(time, &mut q),
            StyledPlan::Thesis(plan) => plan.walk.configuration(time, &mut q),
            StyledPlan::Run(plan) => plan.configuration(time, &mut q),
        }
        Ok(numpy::PyArray1::from_vec(py, q))
    }

    /// Writes the motion; see `Motion.save`.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        py.detach(|| crate::written::save(&self.motion, &path))
    }

    /// A page inside a notebook.
    fn _repr_html_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let page = py.detach(|| crate::written::page(&self.motion))?;
        py.import("solaris._shown")?.call_method1("frame", (page,))
    }

    fn __repr__(&self) -> String {
        format!(
            "<Walk: {:.1} steps/min, {:.3} m a step, {:.2} m/s, {:.2} s>",
            self.step_frequency(),
            self.step_length(),
            self.speed(),
            self.duration()
        )
    }
}
