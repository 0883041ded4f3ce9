//! Standing up from a seat and sitting down, by keyword.

use crate::arrays::count;
use crate::errors::{self, argument};
use crate::figure::{Figure, human};
use crate::motion::Motion;
use crate::report::dictionary;
use pyo3::prelude::*;
use serde_json::Value;
use solaris::gait::{
    ChairMotion, ChairPlan, ChairRequest, DEFAULT_RATE, GaitError, chair as plan_chair, measure_chair,
};
use solaris::model::Trajectory as _;
use std::path::PathBuf;

/// Somebody who stands up from a seat or sits down: the motion, and its measures.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Chair {
    figure: Figure,
    plan: ChairPlan,
    motion: Motion,
    report: Value,
}

/// Plans how somebody stands up from a seat or sits down, and finds the forces of ground, seat and every joint.
///
/// Who: a `figure` with the segments of a human, or a person of this `height` (m), `mass` (kg) and `age` (years).
///
/// `motion` is `"rise"`, `"sit"` or `"rise_and_sit"`, the last so many `times`. `seat_height` (m) is 0.257 of the standing height where it is left out,
/// `duration` how long one way takes (s, 1.9 at 1.75 m; 0.4 s go by at rest before, between and after), `shank` how far the shanks lean forward in sitting (rad, 15°). `rate` is in samples a
/// second (120).
///
/// >>> import solaris
/// >>> rise = solaris.chair(seat_height=0.45)
/// >>> seat = rise.motion.contacts["pelvis"]["force"][:, 1]
/// >>> bool(seat[0] > 400), seat[-1].item()
/// (True, 0.0)
#[pyfunction]
#[pyo3(signature = (
    figure=None, *, height=1.75, mass=None, age=None, motion="rise", times=1, seat_height=None, duration=None, shank=None,
    rate=None
))]
pub(crate) fn chair(
    py: Python<'_>,
    figure: Option<&Figure>,
    height: f64,
    mass: Option<f64>,
    age: Option<f64>,
    motion: &str,
    times: i64,
    seat_height: Option<f64>,
    duration: Option<f64>,
    shank: Option<f64>,
    rate: Option<f64>,
) -> PyResult<Chair> {
    let times = count("times", times)?;
    let motion = match motion {
        "rise_and_sit" => ChairMotion::RiseAndSit(times),
        _ if times != 1 => {
            return Err(argument(
                "times",
                format!("times is {times}, which is of motion 'rise_and_sit' alone"),
            ));
        }
        "rise" => ChairMotion::Rise,
        "sit" => ChairMotion::Sit,
        other => {
            let why = format!("motion is '{other}'; it must be 'rise', 'sit' or 'rise_and_sit'");
            return Err(argument("motion", why));
        }
    };
    let usual = ChairRequest::default();
    let request = ChairRequest { motion, seat: seat_height, duration, shank: shank.unwrap_or(usual.shank) };
    let figure = figure
        .map_or_else(|| human(height, mass, age, false, None, None, None), |figure| Ok(figure.clone()))?;
    let made = py.detach(|| {
        let who = figure.figure();
        let plan = plan_chair(who, &request)?;
        let (motion, _) = plan.loaded(who, rate.unwrap_or(DEFAULT_RATE))?;
        let measures = measure_chair(who, &motion)?;
        Ok::<_, GaitError>((plan, motion, measures))
    });
    let (plan, motion, measures) = made.map_err(errors::gait)?;
    let motion = Motion::new(&figure, motion, format!("A seat, {:.2} m high", plan.seat()));
    Ok(Chair { figure, plan, motion, report: serde_json::to_value(&measures).unwrap_or_default() })
}

#[pymethods]
impl Chair {
    /// Who stands up or sits down.
    #[getter]
    fn figure(&self) -> Figure {
        self.figure.clone()
    }

    /// The motion, with velocities, accelerations, the joints' forces and those of ground and seat, which is the pelvis' contact.
    #[getter]
    fn motion(&self) -> Motion {
        self.motion.clone()
    }

    /// Height of the seat (m).
    #[getter]
    fn seat_height(&self) -> f64 {
        self.plan.seat()
    }

    /// How long one way takes, up or down (s).
    #[getter]
    fn one_way(&self) -> f64 {
        self.plan.one_way()
    }

    /// How long it lasts, with the moments of rest (s).
    #[getter]
    fn duration(&self) -> f64 {
        self.plan.duration()
    }

    /// What was measured of the motion: a dictionary; names end in their units.
    #[getter]
    fn measures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        dictionary(py, &self.report)
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
        format!("<Chair: seat {:.3} m, {:.2} s>", self.seat_height(), self.duration())
    }
}
