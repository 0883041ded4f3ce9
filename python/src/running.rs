//! A scene on its way, taken further step by step.

use crate::arrays::contiguous;
use crate::errors::{self, argument, value};
use crate::figure::Figure;
use crate::motion::events;
use crate::profile::Profile;
use crate::report::dictionary;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use solaris::model::nearest;
use solaris::modes::time::Stepping;
use solaris::modes::{self, Drive, Rule, Shape};
use solaris::scene::Scene;

/// The step of scenes that leave the method to be chosen (s).
const STEP: f64 = 1e-3;

/// A scene on its way, which `Scene.start` begins: `step(dt)` or `advance_to(time)` take it further, and in between its drives and forces, or its state,
/// may be changed.
///
/// What is found at a time is the same, to the bit, as in a run by the same method with frames at the times that are stepped to. `copy()` is a snapshot: it goes on
/// to the same bits.
///
/// >>> import solaris
/// >>> rod = 'Link(name: "rod", joint: Joint(name: "hinge", axes: [rx]), mass: 1.0, com: (0, -0.5, 0))'
/// >>> scene = solaris.read_scene(text=f'Scene(version: 1, figures: {{"it": Figure(links: [{rod}])}}, duration: 1.0)')
/// >>> running = scene.start(method="rk4", step=1e-3)
/// >>> running.set_force("hinge", 2.0)  # N m, until something else is said
/// >>> for _ in range(60):
/// ...     running.step(1 / 60)
/// >>> snapshot = running.copy()
/// >>> running.drive("hinge", freeze=True)
/// >>> running.step(0.5)
/// >>> float(running.v[0]), bool(snapshot.v[0] != 0)
/// (0.0, True)
#[pyclass(module = "solaris")]
pub(crate) struct Running {
    running: modes::Running,
}

impl Running {
    /// Begins by the scene's own method, or by another one.
    pub(crate) fn begin(
        scene: &Scene,
        method: Option<&str>,
        step: Option<f64>,
        tolerance: Option<f64>,
    ) -> PyResult<Self> {
        let fixed = |rule| Stepping::Fixed { rule, step: STEP };
        let stepping = match method {
            None => scene.simulation().stepping_for(scene.settings().method),
            Some("rk4") => fixed(Rule::RungeKutta4),
            Some("euler") => fixed(Rule::ExplicitEuler),
            Some("semi-implicit-euler") => fixed(Rule::SemiImplicitEuler),
            Some("constant-acceleration") => fixed(Rule::ConstantAcceleration),
            Some("impulses") => Stepping::Impulses { step: STEP },
            Some("adaptive") => Stepping::Adaptive { tolerance: 1e-6 },
            Some(other) => {
                return Err(argument(
                    "method",
                    format!(
                        "method is '{other}'; it must be 'rk4', 'euler', 'semi-implicit-euler', 'constant-acceleration', 'impulses' or \
                     'adaptive'"
                    ),
                ));
            }
        };
        let stepping = match (stepping, step, tolerance) {
            (stepping, None, None) => stepping,
            (Stepping::Fixed { rule, .. }, Some(step), None) => Stepping::Fixed { rule, step },
            (Stepping::Impulses { .. }, Some(step), None) => Stepping::Impulses { step },
            (Stepping::Adaptive { .. }, None, Some(tolerance)) => Stepping::Adaptive { tolerance },
            (Stepping::Adaptive { .. } | Stepping::Stiff { .. }, Some(_), _) => {
                return Err(value("this method chooses its steps: give a tolerance in place of a step"));
            }
            _ => return Err(value("this method has a fixed step: give a step in place of a tolerance")),
        };
        scene.simulation().start(stepping).map(|running| Self { running }).map_err(errors::run)
    }

    /// The index in `v` of a degree of freedom, or of the only one of a joint.
    fn dof(&self, name: &str) -> PyResult<usize> {
        let names = self.running.simulation().figure().layout().v_names();
        let of_joint = |known: &str| known.strip_prefix(name).is_some_and(|rest| rest.starts_with('.'));
        let only = || {
            let mut all = names.iter().enumerate().filter(|(_, known)| of_joint(known));
            all.next().filter(|_| all.next().is_none()).map(|(dof, _)| dof)
        };
        names.iter().position(|known| known == name).or_else(only).ok_or_else(|| {
            let near = nearest(name, names.iter().map(String::as_str));
            let hint = near.map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
            argument("name", format!("the figure has no degree of freedom '{name}'{hint}"))
        })
    }
}

#[pymethods]
impl Running {
    /// Goes on by `dt` (s). A `dt` that is none changes nothing; where the run fails it stays at the last instant that was reached.
    fn step(&mut self, py: Python<'_>, dt: f64) -> PyResult<()> {
        py.detach(|| self.running.step(dt)).map_err(errors::run)
    }

    /// Goes on to a time (s); where it is there already nothing happens.
    fn advance_to(&mut self, py: Python<'_>, time: f64) -> PyResult<()> {
        py.detach(|| self.running.advance_to(time)).map_err(errors::run)
    }

    /// Who moves: of several figures one with all of their links.
    #[getter]
    fn figure(&self) -> Figure {
        Figure::own(self.running.simulation().figure().clone())
    }

    /// How long it has run (s).
    #[getter]
    fn time(&self) -> f64 {
        self.running.time()
    }

    /// The configuration.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.running.q())
    }

    /// The velocities.
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.running.v())
    }

    /// The accelerations, which are found when they are asked for.
    fn accelerations<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let a = py.detach(|| self.running.accelerations().map(<[f64]>::to_vec)).map_err(errors::run)?;
        Ok(PyArray1::from_vec(py, a))
    }

    /// Energy of the figure with its springs (J): `kinetic`, `in_gravity`, `in_springs`, `total`.
    fn energy<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let energy = self.running.energy().map_err(errors::run)?;
        dictionary(py, &energy)
    }

    /// What happened in the last call that stepped or changed something: `events` as those of a motion, and `impacts`, `landings` and `outcomes`
    /// as in the report of a run.
    fn happened<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let happened = self.running.happened();
        let all = PyDict::new(py);
        all.set_item("events", events(happened.events))?;
        all.set_item("impacts", dictionary(py, &happened.impacts)?)?;
        all.set_item("landings", dictionary(py, &happened.landings)?)?;
        all.set_item("outcomes", dictionary(py, &happened.outcomes)?)?;
        Ok(all)
    }

    /// A constant force (N m, N) on a degree of freedom, or on a joint that has but one, that is free or that a constant force drives, until
    /// something else is said.
    fn set_force(&mut self, dof: &str, force: f64) -> PyResult<()> {
        let dof = self.dof(dof)?;
        self.running.set_force(dof, force).map_err(errors::run)
    }

    /// Another drive for a degree of freedom, or for all of a joint, from now on; with none of them it is free.
    ///
    /// One of: `freeze`, it stands where it is, as if it were grasped; `to` (rad, m), it moves there in `over` (s) by the least jerk;
    /// `follow`, a profile of positions that begins where it is, with the velocity it has; `torque`, a profile of forces (N m, N).
    #[pyo3(signature = (name, *, freeze=false, to=None, over=1.0, follow=None, torque=None))]
    fn drive(
        &mut self,
        py: Python<'_>,
        name: &str,
        freeze: bool,
        to: Option<f64>,
        over: f64,
        follow: Option<&Profile>,
        torque: Option<&Profile>,
    ) -> PyResult<()> {
        let drive = match (freeze, to, follow, torque) {
            (false, None, None, None) => Drive::Free,
            (true, None, None, None) => Drive::Frozen,
            (false, Some(to), None, None) => Drive::Move { to, over, along: Shape::MinimumJerk },
            (false, None, Some(follow), None) => Drive::Kinematic(follow.profile.clone()),
            (false, None, None, Some(torque)) => Drive::Torque(torque.profile.clone()),
            _ => return Err(value("give one of freeze, to, follow and torque")),
        };
        py.detach(|| self.running.drive(name, [drive])).map_err(errors::run)
    }

    /// Puts the figure somewhere else, with other velocities; what is not given stays.
    #[pyo3(signature = (q=None, v=None))]
    fn set_state(&mut self, q: Option<&Bound<'_, PyAny>>, v: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let of = |name: &str, given: Option<&Bound<'_, PyAny>>, own: &[f64]| match given {
            None => Ok(own.to_vec()),
            Some(given) => Ok::<_, PyErr>(contiguous(name, given)?.as_slice().unwrap_or_default().to_vec()),
        };
        let (q, v) = (of("q", q, self.running.q())?, of("v", v, self.running.v())?);
        self.running.set_state(&q, &v).map_err(errors::run)
    }

    /// A snapshot, which goes on from here by itself, to the same bits.
    fn copy(&self) -> Self {
        Self { running: self.running.clone() }
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __repr__(&self) -> String {
        format!("<Running at {:.6} s>", self.running.time())
    }
}
