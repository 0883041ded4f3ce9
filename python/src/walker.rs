//! A walker that is steered while it walks.

use crate::analysis::{complete, contact};
use crate::arrays::fixed;
use crate::errors::{argument, plain, value};
use crate::figure::{Figure, human};
use crate::motion::Motion;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use solaris::analysis::Goal;
use solaris::gait::{self, Command};
use solaris::model::{Quaternion, Unit, UnitQuaternion, Vector3};
use solaris::modes::RecordedMotion;
use std::sync::Arc;

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
        let figure = figure
            .map_or_else(|| human(1.75, None, None, true, None, None, None), |figure| Ok(figure.clone()))?;
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

    /// What the last frame asks of the ground and of the joints: `tau` (N m, N), and of each foot, `left_foot` and `right_foot`, `force` (N), `moment` about the
    /// world's origin (N m) and `cop`, where it is pressed (m).
    ///
    /// >>> import solaris
    /// >>> walker = solaris.Walker()
    /// >>> _ = walker.step(1 / 60)
    /// >>> forces = walker.forces()
    /// >>> float(forces["left_foot"]["force"][1] + forces["right_foot"]["force"][1]) / walker.figure.mass > 9.7
    /// True
    fn forces<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mut tau = vec![0.0; self.figure.figure().layout().nv()];
        let feet = self.walker.forces(&mut tau).map_err(|error| plain("WalkError")(&error))?;
        let forces = PyDict::new(py);
        forces.set_item("tau", PyArray1::from_vec(py, tau))?;
        for (name, foot) in gait::FEET.into_iter().zip(&feet) {
            forces.set_item(name, contact(py, foot)?)?;
        }
        Ok(forces)
    }

    /// A point of a link (`at`, m, in its frame) reaches for a place (`to`, m), its `axis` (its z, which is forward) looks at one (`look`, m), or it is turned as a
    /// quaternion says (`turned`, x, y, z, w), from now on: by the coordinates or joints `by`, or those of its arm, or of neck and head. Told again each frame it follows what
    /// moves. `reached` tells what is missing, `withdraw` ends it.
    ///
    /// >>> import solaris
    /// >>> walker = solaris.Walker()
    /// >>> walker.reach("right_hand", to=(-0.3, 1.1, 0.35), at=(0, -0.08, 0))
    /// >>> for _ in range(30):
    /// ...     q = walker.step(1 / 60)
    /// >>> walker.reached("right_hand") < 1e-9
    /// True
    #[pyo3(signature = (link, *, to=None, look=None, turned=None, at=None, axis=None, by=Vec::new()))]
    fn reach(
        &mut self,
        link: &str,
        to: Option<&Bound<'_, PyAny>>,
        look: Option<&Bound<'_, PyAny>>,
        turned: Option<&Bound<'_, PyAny>>,
        at: Option<&Bound<'_, PyAny>>,
        axis: Option<&Bound<'_, PyAny>>,
        by: Vec<String>,
    ) -> PyResult<()> {
        let point = vector("at", at)?.unwrap_or_else(Vector3::zeros);
        let axis = match vector("axis", axis)? {
            None => Vector3::z_axis(),
            Some(axis) => Unit::try_new(axis, 0.0)
                .ok_or_else(|| argument("axis", "axis has no direction; give it a length"))?,
        };
        let turned = turned.map(|turned| quaternion("turned", turned)).transpose()?;
        let goal = match (vector("to", to)?, vector("look", look)?, turned) {
            (Some(place), None, None) => Goal::Place(place),
            (None, Some(at), None) => Goal::Look { axis, at },
            (None, None, Some(turned)) => Goal::Turned(turned),
            _ => return Err(value("give one of to, look and turned")),
        };
        let by: Vec<&str> = by.iter().map(String::as_str).collect();
        self.walker.reach(link, point, &by, goal).map_err(|error| plain("WalkError")(&error))
    }

    /// What is missing to where a link reaches (m, rad); `None` for one that does not reach.
    fn reached(&self, link: &str) -> Option<f64> {
        self.walker.reached(link)
    }

    /// A link that reaches comes back into the walk.
    fn withdraw(&mut self, link: &str) -> PyResult<()> {
        self.walker.withdraw(link).map_err(|error| plain("WalkError")(&error))
    }

    /// Plays a motion of this figure over the walk, once: its coordinates or joints `by`, or all of trunk, head and arms.
    #[pyo3(signature = (motion, *, by=Vec::new()))]
    fn play(&mut self, motion: &Motion, by: Vec<String>) -> PyResult<()> {
        let known = complete(motion, None, 2)?.motion;
        let clip = RecordedMotion::new(known.as_ref().clone()).map_err(|error| plain("WalkError")(&error))?;
        let by: Vec<&str> = by.iter().map(String::as_str).collect();
        self.walker.play(&Arc::new(clip), &by).map_err(|error| plain("WalkError")(&error))
    }

    /// Whether a motion is played.
    #[getter]
    fn plays(&self) -> bool {
        self.walker.plays()
    }

    /// Ends all motions that are played.
    fn end_clips(&mut self) {
        self.walker.end_clips();
    }

    /// Pushes a point of a link (`at`, m, in its frame) with a force of the world (N) from now on, until `let_go`.
    #[pyo3(signature = (link, force, *, at=None))]
    fn push(&mut self, link: &str, force: &Bound<'_, PyAny>, at: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let at = vector("at", at)?.unwrap_or_else(Vector3::zeros);
        let force = fixed::<3>("force", force)?.into();
        self.walker.push(link, at, force).map_err(|error| plain("WalkError")(&error))
    }

    /// Pushes no more.
    fn let_go(&mut self) {
        self.walker.let_go();
    }

    /// Lets a joint of trunk, head or arms hang loose; `tighten` takes it back.
    fn loosen(&mut self, joint: &str) -> PyResult<()> {
        self.walker.loosen(joint).map_err(|error| plain("WalkError")(&error))
    }

    /// Takes a loose joint back into the walk.
    fn tighten(&mut self, joint: &str) -> PyResult<()> {
        self.walker.tighten(joint).map_err(|error| plain("WalkError")(&error))
    }

    /// Frees a coordinate for `set`; `hold` takes it back.
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

fn vector(name: &str, given: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Vector3<f64>>> {
    given.map(|given| Ok(fixed::<3>(name, given)?.into())).transpose()
}

fn quaternion(name: &str, given: &Bound<'_, PyAny>) -> PyResult<UnitQuaternion<f64>> {
    let [x, y, z, w] = fixed::<4>(name, given)?;
    let turned = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 0.0);
    turned.ok_or_else(|| argument(name, format!("{name} is no rotation; a quaternion has a length")))
}
