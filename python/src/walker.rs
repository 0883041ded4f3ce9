//! A walker that is steered while it walks.

use crate::arrays::fixed;
use crate::errors::plain;
use crate::figure::{Figure, human};
use numpy::PyArray1;
use pyo3::prelude::*;
use solaris::gait::{self, Command};

/// A figure that walks as it is told while it walks: `step(dt, …)` frame after frame, planted feet exact at each.
///
/// Its figure must have the segments of a human and a root that turns by its heading first
/// (`solaris.human(…, heading_first=True)`).
///
/// >>> import solaris
/// >>> walker = solaris.Walker()
/// >>> for _ in range(120):
/// ...     q = walker.step(1 / 60, velocity=(0.0, 1.2))
/// >>> walker.place[1] > 1.0
/// True
#[pyclass(module = "solaris")]
pub(crate) struct Walker {
    figure: Figure,
    walker: gait::Walker,
}

#[pymethods]
impl Walker {
    #[new]
    #[pyo3(signature = (figure=None))]
    fn new(py: Python<'_>, figure: Option<&Figure>) -> PyResult<Self> {
        let figure =
            figure.map_or_else(|| human(1.75, None, None, true, None, None), |figure| Ok(figure.clone()))?;
        let walker = py.detach(|| gait::Walker::new(figure.figure())).map_err(crate::errors::gait)?;
        Ok(Self { figure, walker })
    }

    /// Goes on by `dt` (s, up to a quarter), and gives the configuration there.
    ///
    /// Where to: a `velocity` (x left, z forward, m/s, in the world), an `own_velocity` (left, forward, of the way it faces), or a point
    /// `to` (x, z, m) with a `speed` (m/s), where it stops; with none of them it comes to a stand. It turns to where it goes, unless
    /// it is to face a `heading` (rad, to the left of z) or a point `facing` (x, z, m).
    #[pyo3(signature = (dt, *, velocity=None, own_velocity=None, to=None, speed=1.2, heading=None, facing=None))]
    fn step<'py>(
        &mut self,
        py: Python<'py>,
        dt: f64,
        velocity: Option<&Bound<'py, PyAny>>,
        own_velocity: Option<&Bound<'py, PyAny>>,
        to: Option<&Bound<'py, PyAny>>,
        speed: f64,
        heading: Option<f64>,
        facing: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let two = |name: &str, given: &Bound<'py, PyAny>| match given.extract::<(f64, f64)>() {
            Ok((x, z)) => Ok([x, z]),
            Err(_) => fixed::<2>(name, given),
        };
        let command = match (velocity, own_velocity, to) {
            (None, None, None) => Command::stop(),
            (Some(given), None, None) => {
                let [x, z] = two("velocity", given)?;
                Command::velocity(x, z)
            }
            (None, Some(given), None) => {
                let [left, forward] = two("own_velocity", given)?;
                Command::own_velocity(left, forward)
            }
            (None, None, Some(given)) => {
                let [x, z] = two("to", given)?;
                Command::to_point(x, z, speed)
            }
            _ => return Err(crate::errors::value("give one of velocity, own_velocity and to")),
        };
        let command = match (heading, facing) {
            (None, None) => command,
            (Some(heading), None) => command.facing(heading),
            (None, Some(given)) => {
                let [x, z] = two("facing", given)?;
                command.facing_point(x, z)
            }
            _ => return Err(crate::errors::value("give one of heading and facing")),
        };
        let q = self.walker.step(dt, &command).map_err(|error| plain("WalkError")(&error))?;
        Ok(PyArray1::from_slice(py, q))
    }

    /// Who walks.
    #[getter]
    fn figure(&self) -> Figure {
        self.figure.clone()
    }

    /// The configuration.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.walker.configuration())
    }

    /// Velocities and accelerations of the coordinates.
    fn derivatives<'py>(&mut self, py: Python<'py>) -> PyResult<[Bound<'py, PyArray1<f64>>; 2]> {
        let nv = self.figure.figure().layout().nv();
        let (mut v, mut a) = (vec![0.0; nv], vec![0.0; nv]);
        self.walker.derivatives(&mut v, &mut a).map_err(|error| plain("WalkError")(&error))?;
        Ok([PyArray1::from_vec(py, v), PyArray1::from_vec(py, a)])
    }

    /// Where it is (x, z, m).
    #[getter]
    fn place(&self) -> (f64, f64) {
        self.walker.place().into()
    }

    /// Which way it faces (rad, to the left of z, not wrapped).
    #[getter]
    fn heading(&self) -> f64 {
        self.walker.heading()
    }

    /// The velocity that the present step makes (x, z, m/s).
    #[getter]
    fn velocity(&self) -> (f64, f64) {
        self.walker.velocity().into()
    }

    /// Whether both feet stand and no step has begun.
    #[getter]
    fn is_standing(&self) -> bool {
        self.walker.is_standing()
    }

    /// In what the command was bent to what can be walked.
    #[getter]
    fn bent(&self) -> Vec<String> {
        self.walker.bent().map(|bent| format!("{bent:?}").to_lowercase()).collect()
    }

    /// Frees a coordinate for `set`, over a fifth of a second; `hold` takes it back.
    fn free(&mut self, dof: &str) -> PyResult<()> {
        self.walker.free(dof).map_err(|error| plain("WalkError")(&error))
    }

    /// Takes a coordinate back into the walk.
    fn hold(&mut self, dof: &str) -> PyResult<()> {
        self.walker.hold(dof).map_err(|error| plain("WalkError")(&error))
    }

    /// Gives a freed coordinate its value (rad).
    fn set(&mut self, dof: &str, value: f64) -> PyResult<()> {
        self.walker.set_freed(dof, value).map_err(|error| plain("WalkError")(&error))
    }

    /// A walker that goes on from here by itself; from the same commands it goes on to the same bits.
    fn copy(&self) -> Self {
        Self { figure: self.figure.clone(), walker: self.walker.clone() }
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __repr__(&self) -> String {
        let [x, z] = self.walker.place();
        format!("<Walker at ({x:.3}, {z:.3}) m, heading {:.3} rad>", self.walker.heading())
    }
}
