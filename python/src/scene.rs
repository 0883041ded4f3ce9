//! Scenes: the motion script, run.

use crate::errors::{self, plain};
use crate::figure::Figure;
use crate::motion::Motion;
use crate::report::dictionary;
use crate::running::Running;
use pyo3::prelude::*;
use serde_json::Value;
use solaris::files;
use solaris::modes::Observer;
use solaris::scene::{self, NoFiles};
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// How often it is asked whether somebody wants to stop.
const OFTEN: Duration = Duration::from_millis(50);

/// A scene that was run: its motion, and how far to trust it.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Run {
    motion: Motion,
    report: Value,
    notes: Vec<String>,
}

/// Runs a scene: a file (`.ron`), or its text with `text=`.
///
/// `duration` (s) and `rate` (1/s) take the place of the scene's own. The files that it names are beside it; a text names none.
/// Raises `SceneError` with every fault and its place, and `RunError` where it does not come to its end; `KeyboardInterrupt` stops it.
///
/// >>> import solaris
/// >>> rod = 'Link(name: "rod", joint: Joint(name: "pivot", axes: [rx]), mass: 1.0, com: (0, 0, 0.5))'
/// >>> run = solaris.run(text=f'Scene(version: 1, figures: {{"it": Figure(links: [{rod}])}}, duration: 1.0)')
/// >>> run.motion.q.shape[1]
/// 1
#[pyfunction]
#[pyo3(signature = (path=None, *, text=None, duration=None, rate=None, forces=true))]
pub(crate) fn run(
    py: Python<'_>,
    path: Option<PathBuf>,
    text: Option<&str>,
    duration: Option<f64>,
    rate: Option<f64>,
    forces: bool,
) -> PyResult<Run> {
    simulate(py, read(py, path, text)?, duration, rate, forces)
}

/// A scene: a figure and what drives it, read and not yet run.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Scene {
    scene: scene::Scene,
}

/// Reads a scene: a file (`.ron`), or its text with `text=`. The files that it names are beside it; a text names none.
///
/// >>> import solaris
/// >>> scene = solaris.read_scene("fixtures/scenes/pendulum.ron")
/// >>> running = scene.start()
/// >>> running.step(0.1)
/// >>> round(running.time, 9)
/// 0.1
#[pyfunction]
#[pyo3(signature = (path=None, *, text=None))]
pub(crate) fn read_scene(py: Python<'_>, path: Option<PathBuf>, text: Option<&str>) -> PyResult<Scene> {
    Ok(Scene { scene: read(py, path, text)? })
}

fn read(py: Python<'_>, path: Option<PathBuf>, text: Option<&str>) -> PyResult<scene::Scene> {
    match (path, text) {
        (Some(path), None) => {
            Ok(py.detach(|| files::scene(&path)).map_err(errors::file("SceneError"))?.scene)
        }
        (None, Some(text)) => scene::read(text, &mut NoFiles)
            .map_err(|faults| errors::text("SceneError", "", &faults.to_string(), &[("", &faults)])),
        _ => Err(errors::value("give the path of a scene, or its text")),
    }
}

fn simulate(
    py: Python<'_>,
    mut scene: scene::Scene,
    duration: Option<f64>,
    rate: Option<f64>,
    forces: bool,
) -> PyResult<Run> {
    let settings = scene.settings_mut();
    settings.duration = duration.unwrap_or(settings.duration);
    settings.rate = rate.unwrap_or(settings.rate);
    settings.forces = forces;
    let mut watch = Interrupts { asked: Mutex::new(Instant::now()), raised: Mutex::new(None) };
    let done = py.detach(|| scene.simulate(&mut watch));
    if let Ok(Some(raised)) = watch.raised.into_inner() {
        return Err(raised);
    }
    let done = done.map_err(errors::scene_run)?;
    let report = serde_json::to_value(&done.report).map_err(errors::value)?;
    let figure = Figure::own(scene.figure().clone());
    let notes = scene.notes().to_vec();
    let several = py.detach(|| scene.several(&done.motion)).map_err(|error| plain("RunError")(&error))?;
    let motion = Motion::new(&figure, done.motion, scene.name().to_owned());
    Ok(Run { motion: Motion { several: several.into(), ..motion }, report, notes })
}

#[pymethods]
impl Scene {
    /// What it calls its figure.
    #[getter]
    fn name(&self) -> &str {
        self.scene.name()
    }

    /// Who moves: of several figures one with all of their links.
    #[getter]
    fn figure(&self) -> Figure {
        Figure::own(self.scene.figure().clone())
    }

    /// How long it is to run (s).
    #[getter]
    fn duration(&self) -> f64 {
        self.scene.settings().duration
    }

    /// What its reader had to say.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.scene.notes().to_vec()
    }

    /// Runs all of it, as `solaris.run` does.
    #[pyo3(signature = (*, duration=None, rate=None, forces=true))]
    fn run(&self, py: Python<'_>, duration: Option<f64>, rate: Option<f64>, forces: bool) -> PyResult<Run> {
        simulate(py, self.scene.clone(), duration, rate, forces)
    }

    /// Begins it, to be taken further step by step.
    ///
    /// By the scene's own method, or by `method`: `"rk4"`, `"euler"`, `"semi-implicit-euler"`, `"constant-acceleration"` or `"impulses"` in steps of at most
    /// `step` (s), or `"adaptive"` to a `tolerance`. A scene that leaves the method open is stepped at a
    /// millisecond, by `"impulses"` over ground or where links touch or are held together, else by `"rk4"`.
    #[pyo3(signature = (*, method=None, step=None, tolerance=None))]
    fn start(
        &self,
        py: Python<'_>,
        method: Option<&str>,
        step: Option<f64>,
        tolerance: Option<f64>,
    ) -> PyResult<Running> {
        py.detach(|| Running::begin(&self.scene, method, step, tolerance))
    }

    fn __repr__(&self) -> String {
        format!("<Scene '{}' of {} s>", self.scene.name().escape_debug(), self.duration())
    }
}

/// Stops a run where Ctrl-C was typed.
struct Interrupts {
    asked: Mutex<Instant>,
    raised: Mutex<Option<PyErr>>,
}

impl Observer for Interrupts {
    fn is_cancelled(&self) -> bool {
        let Ok(mut asked) = self.asked.lock() else { return true };
        if asked.elapsed() < OFTEN {
            return false;
        }
        *asked = Instant::now();
        #[allow(clippy::redundant_closure_for_method_calls, reason = "the method is of one lifetime")]
        let raised = Python::attach(|py| py.check_signals()).err();
        let stops = raised.is_some();
        if let Ok(mut kept) = self.raised.lock() {
            *kept = raised;
        }
        stops
    }
}

#[pymethods]
impl Run {
    /// The motion.
    #[getter]
    fn motion(&self) -> Motion {
        self.motion.clone()
    }

    /// Who moves: of several figures one with all of their links.
    #[getter]
    fn figure(&self) -> Figure {
        self.motion.figure.clone()
    }

    /// How it was found and how far it can be trusted: method, error estimate, cost, energy, events.
    #[getter]
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        dictionary(py, &self.report)
    }

    /// What the scene's reader had to say.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
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
        let method = self.report.get("method").and_then(Value::as_str).unwrap_or_default();
        format!("<Run of '{}' by {method}>", self.motion.title.escape_debug())
    }
}
