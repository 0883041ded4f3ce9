//! Walks and runs by keyword.

use crate::arrays::{contiguous, count};
use crate::errors::{self, argument};
use crate::figure::{Figure, human};
use crate::motion::Motion;
use crate::report::dictionary;
use numpy::{PyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::Value;
use solaris::gait::people::{PACES, curves};
use solaris::gait::{
    GaitError, GaitKind, GaitOptions, MANNERS, PARAMETERS, PartOptions, Repeats, RunEndOptions,
    RunWalkOptions, SIDE_MANNERS, ShippedManner, StairOptions, StyledPlan,
};
use solaris::model::Trajectory as _;
use std::collections::BTreeMap;
use std::path::PathBuf;

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
/// `speed` and `turn`; `{"stand": 2.0}` stops for so many seconds. `backward` walks backward; what is in `then` after standing may
/// have it too.
///
/// On what: `slope` (rad, uphill), `stairs` (a dictionary with `count`, `rise` and `tread` in m), `ground` (points z, height in
/// m), or `footholds` (rows of z, height, and where known pitch and heading).
///
/// In which manner: `population` (`"adult"`, `"treadmill"`, `"child"`, `"older"`), `manner` (such as `"sad:0.6,heavy:0.3"`), `left` and
/// `right` (manners of one side), `variability` (over people's, with a `seed`), and `style`, numbers by name
/// (`solaris.style_parameters()` lists them); `cane_load` is the part of the whole vertical force that the cane of a figure with one bears at most. With `determinants` (3 or 5) it is a walk through the thesis's key postures.
///
/// `loop` makes one stride that repeats itself, `"moving"` or `"in_place"`. `rate` is in samples a second (120): where it is
/// given, the step frequency of a loop is fitted to whole frames.
///
/// >>> import solaris
/// >>> walk = solaris.walk(height=1.65, mass=58.0, step_frequency=105, steps=6)
/// >>> motion = walk.motion
/// >>> motion.q.shape[1], sorted(motion.contacts)[0]
/// (66, 'left_foot')
#[pyfunction]
#[pyo3(signature = (
    figure=None, *, height=1.75, mass=None, age=None, step_frequency=None, step_length=None, speed=None, steps=None,
    distance=None, turn=0.0, backward=false, path=None, then=None, slope=None, stairs=None, ground=None, footholds=None,
    population=None, manner=None, left=None, right=None, variability=None, seed=0, style=None, left_first=None,
    cane_load=None, determinants=None, r#loop=None, rate=None
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
    steps: Option<i64>,
    distance: Option<f64>,
    turn: f64,
    backward: bool,
    path: Option<&Bound<'_, PyAny>>,
    then: Option<Vec<Bound<'_, PyDict>>>,
    slope: Option<f64>,
    stairs: Option<&Bound<'_, PyDict>>,
    ground: Option<&Bound<'_, PyAny>>,
    footholds: Option<&Bound<'_, PyAny>>,
    population: Option<String>,
    manner: Option<String>,
    left: Option<String>,
    right: Option<String>,
    variability: Option<f64>,
    seed: i128,
    style: Option<BTreeMap<String, f64>>,
    left_first: Option<bool>,
    cane_load: Option<f64>,
    determinants: Option<i64>,
    r#loop: Option<&str>,
    rate: Option<f64>,
) -> PyResult<Walk> {
    let options = GaitOptions {
        determinants: determinants.map(|number| count("determinants", number)).transpose()?,
        step_frequency,
        step_length,
        speed,
        steps: steps.map(|steps| count("steps", steps)).transpose()?,
        distance,
        turn,
        backward,
        path: path.map(|points| pairs("path", points)).transpose()?,
        then: then.unwrap_or_default().iter().map(part).collect::<PyResult<_>>()?,
        slope,
        stairs: stairs.map(flight).transpose()?,
        ground: ground.map(|points| pairs("ground", points)).transpose()?,
        footholds: footholds.map(|given| rows("footholds", given, 2, 4)).transpose()?,
        population,
        manner,
        left,
        right,
        variability,
        seed: u64::try_from(seed).map_err(|_| {
            argument("seed", format!("seed is {seed}; it must be a whole number, 0 to {}", u64::MAX))
        })?,
        style: style.unwrap_or_default(),
        left_first,
        cane_load,
        repeats: looped(r#loop)?,
        rate,
        ..GaitOptions::default()
    };
    Walk::of(py, figure, &options, (height, mass, age))
}

/// How a run begins or ends.
#[derive(FromPyObject)]
pub(crate) enum End<'py> {
    How(String),
    Walk(Bound<'py, PyDict>),
}

/// Plans a run of 1 to 6 m/s, with its forces.
///
/// `start` and `end` are `"running"` (the default), `"standing"`, `"walking"`, or a dictionary with the walk's `steps` and `speed`; `then` is a list of dictionaries with the keys `steps` and `speed`. `forefoot` lands on the ball of the
/// foot, up to 3.5 m/s and in full run alone; `give` is by how much its soles give (m, up to 0.015), in full run alone. The rest is as for `walk`.
///
/// >>> import solaris
/// >>> run = solaris.run_gait(speed=3.5, steps=6)
/// >>> flights = [event for event in run.motion.events if event[1] == "lift_off"]
/// >>> len(flights) > 0
/// True
/// >>> walk = {"steps": 4, "speed": 1.5}
/// >>> solaris.run_gait(speed=2.2, steps=6, start=walk, end=walk).measures["measures"]["steps"]
/// 15
#[pyfunction]
#[pyo3(signature = (
    figure=None, *, height=1.75, mass=None, age=None, speed=3.0, steps=None, distance=None, then=None, start=None,
    end=None, forefoot=false, give=None, left_first=false, r#loop=None, rate=None
))]
pub(crate) fn run_gait(
    py: Python<'_>,
    figure: Option<&Figure>,
    height: f64,
    mass: Option<f64>,
    age: Option<f64>,
    speed: f64,
    steps: Option<i64>,
    distance: Option<f64>,
    then: Option<Vec<Bound<'_, PyDict>>>,
    start: Option<End<'_>>,
    end: Option<End<'_>>,
    forefoot: bool,
    give: Option<f64>,
    left_first: bool,
    r#loop: Option<&str>,
    rate: Option<f64>,
) -> PyResult<Walk> {
    let bound = |name: &str, given: Option<End<'_>>| match given {
        None => Ok(RunEndOptions::Running),
        Some(End::How(how)) => match how.as_str() {
            "running" => Ok(RunEndOptions::Running),
            "standing" => Ok(RunEndOptions::Standing),
            "walking" => Ok(RunEndOptions::Walking(RunWalkOptions::default())),
            other => {
                let why = format!(
                    "{name} is '{other}'; it must be 'running', 'standing' or 'walking', or a dictionary of a walk's steps and speed"
                );
                Err(argument(name, why))
            }
        },
        Some(End::Walk(given)) => {
            keys(name, &given, &["steps", "speed"])?;
            let (steps, speed) = (counted(name, &given, "steps")?, get(&given, "speed")?);
            Ok(RunEndOptions::Walking(RunWalkOptions { steps, speed }))
        }
    };
    let options = GaitOptions {
        gait: GaitKind::Run,
        speed: Some(speed),
        steps: steps.map(|steps| count("steps", steps)).transpose()?,
        distance,
        then: then.unwrap_or_default().iter().map(part).collect::<PyResult<_>>()?,
        forefoot,
        give,
        from: bound("start", start)?,
        to: bound("end", end)?,
        left_first: Some(left_first),
        repeats: looped(r#loop)?,
        rate,
        ..GaitOptions::default()
    };
    Walk::of(py, figure, &options, (height, mass, age))
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

/// What people do over a stride at a pace, by name: unit, mean and standard deviation at 0, 4, … 100 % from one strike of the foot to its next
/// (Schwartz, Rozumalski and Trost 2008). Paces are "very slow", "slow", "free", "fast" and "very fast".
///
/// >>> import solaris
/// >>> knee = solaris.people_curves("free")["Knee flexion"]
/// >>> knee["unit"], knee["mean"].max().item()
/// ('°', 59.1)
#[pyfunction]
#[pyo3(signature = (pace = "free"))]
pub(crate) fn people_curves<'py>(py: Python<'py>, pace: &str) -> PyResult<Bound<'py, PyDict>> {
    let Some(known) = PACES.iter().find(|known| known.name == pace) else {
        let names = PACES.map(|known| format!("'{}'", known.name)).join(", ");
        return Err(argument("pace", format!("pace is '{pace}'; it must be one of {names}")));
    };
    let all = PyDict::new(py);
    for curve in curves(known) {
        let one = PyDict::new(py);
        one.set_item("unit", curve.unit)?;
        one.set_item("mean", PyArray1::from_slice(py, &curve.mean))?;
        one.set_item("deviation", PyArray1::from_slice(py, &curve.deviation))?;
        all.set_item(curve.name, one)?;
    }
    Ok(all)
}

/// Where a stride that repeats itself goes.
fn looped(given: Option<&str>) -> PyResult<Option<Repeats>> {
    match given {
        None => Ok(None),
        Some("moving") => Ok(Some(Repeats::Moving)),
        Some("in_place") => Ok(Some(Repeats::InPlace)),
        Some(other) => Err(argument("loop", format!("loop is '{other}'; it must be 'moving' or 'in_place'"))),
    }
}

fn get<'py, T: pyo3::conversion::FromPyObjectOwned<'py>>(
    of: &Bound<'py, PyDict>,
    key: &str,
) -> PyResult<Option<T>> {
    of.get_item(key)?.map(|found| found.extract().map_err(Into::into)).transpose()
}

/// How many a key of a dictionary says there are.
fn counted(name: &str, given: &Bound<'_, PyDict>, key: &str) -> PyResult<Option<usize>> {
    get(given, key)?.map(|number| count(&format!("{name}['{key}']"), number)).transpose()
}

/// Refuses keys that mean nothing.
fn keys(name: &str, given: &Bound<'_, PyDict>, known: &[&str]) -> PyResult<()> {
    for key in given.keys() {
        let key: String = key.extract()?;
        if !known.contains(&key.as_str()) {
            return Err(argument(name, format!("{name} has no '{key}'; its keys are {}", known.join(", "))));
        }
    }
    Ok(())
}

fn part(given: &Bound<'_, PyDict>) -> PyResult<PartOptions> {
    let known = ["steps", "distance", "stand", "step_frequency", "step_length", "speed", "turn", "backward"];
    keys("then", given, &known)?;
    Ok(PartOptions {
        steps: counted("then", given, "steps")?,
        distance: get(given, "distance")?,
        stand: get(given, "stand")?,
        step_frequency: get(given, "step_frequency")?,
        step_length: get(given, "step_length")?,
        speed: get(given, "speed")?,
        turn: get(given, "turn")?.unwrap_or_default(),
        backward: get(given, "backward")?.unwrap_or_default(),
    })
}

fn flight(given: &Bound<'_, PyDict>) -> PyResult<StairOptions> {
    keys("stairs", given, &["count", "rise", "tread"])?;
    Ok(StairOptions {
        count: counted("stairs", given, "count")?,
        rise: get(given, "rise")?,
        tread: get(given, "tread")?,
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
            Err(argument(
                name,
                format!("{name} has the shape {}; it must be rows of {width}", crate::arrays::shape(found)),
            ))
        }
    }
}

impl Walk {
    /// Plans it for a figure, or for a person of a height, mass and age, who gets a root that turns by its heading first where the walk
    /// needs one.
    fn of(
        py: Python<'_>,
        figure: Option<&Figure>,
        options: &GaitOptions,
        (height, mass, age): (f64, Option<f64>, Option<f64>),
    ) -> PyResult<Self> {
        let mut who = figure
            .map_or_else(|| human(height, mass, age, false, None, None, None), |figure| Ok(figure.clone()))?;
        let make = |who: &Figure| py.detach(|| options.make(who.figure()));
        let mut made = make(&who);
        if figure.is_none() && made.as_ref().is_err_and(GaitError::turns_too_far) {
            who = human(height, mass, age, true, None, None, None)?;
            made = make(&who);
        }
        let made = made.map_err(errors::gait)?;
        let report = serde_json::to_value(&made).unwrap_or_default();
        let title = format!(
            "{} at {:.0} steps/min, {:.2} m a step",
            if matches!(made.plan, StyledPlan::Run(_)) { "A run" } else { "A walk" },
            made.plan.step_frequency(),
            made.plan.step_length()
        );
        let motion = Motion { repeats: options.repeats.is_some(), ..Motion::new(&who, made.motion, title) };
        Ok(Self { figure: who, plan: made.plan, motion, report })
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
            return Err(argument("time", format!("time is {time}; it must be a finite number of seconds")));
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
    #[pyo3(signature = (path, *, arrows=false))]
    fn save(&self, py: Python<'_>, path: PathBuf, arrows: bool) -> PyResult<()> {
        py.detach(|| crate::written::save(&self.motion, &path, arrows))
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
