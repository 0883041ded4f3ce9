//! A figure that is brought to a person's size by their markers.

use crate::analysis::length_unit;
use crate::errors::{self, argument, value};
use crate::figure::Figure;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use solaris::analysis::markers::{FitOptions, IkOptions, SubjectFit, fit_subject};
use solaris::files::{self, Body, Language};
use solaris::io::opensim::{self, MarkerPlace, Rescaling};
use solaris::model::{MassShares, Stretching, Vector3};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A figure of a person's size, with markers where the person wears them; `scale` makes it.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Subject {
    figure: Figure,
    /// The model's own text, of one of OpenSim's.
    model: Option<String>,
    found: SubjectFit,
    factors: Vec<(String, Vector3<f64>)>,
}

/// Brings a model to the size of a person whose markers were recorded: lengths of segments and places of markers are fitted to all frames of the
/// `trials` (`.trc`, `.c3d`: the person standing, and moving where there is such a trial) together.
///
/// `mass` (kg) is met exactly; without it the model's mass stays. Each segment keeps its share. `unit` is that of the files' lengths where they do
/// not say it: `"mm"`, `"cm"` or `"m"`. This is `solaris scale` without a setup of OpenSim's ScaleTool; with one, use the program.
///
/// >>> import solaris
/// >>> subject = solaris.scale("fixtures/markers/leg.osim", ["fixtures/markers/static.trc"], mass=26.0)
/// >>> round(subject.figure.mass, 9), subject.rms < subject.rms_before
/// (26.0, True)
/// >>> found = solaris.inverse_kinematics(subject.figure, "fixtures/markers/swing.trc")
#[pyfunction]
#[pyo3(signature = (path, trials, *, mass=None, unit=None))]
pub(crate) fn scale(
    py: Python<'_>,
    path: PathBuf,
    trials: Vec<PathBuf>,
    mass: Option<f64>,
    unit: Option<&str>,
) -> PyResult<Subject> {
    let unit = length_unit(unit)?;
    if trials.is_empty() {
        return Err(argument(
            "trials",
            "trials are empty; name a recording of the person standing still at least",
        ));
    }
    if let Some(mass) = mass
        && !(mass > 0.0 && mass.is_finite())
    {
        return Err(argument("mass", format!("mass is {mass} kg; it must be a finite number above 0")));
    }
    py.detach(|| {
        let mut body = files::body_in(&path, None).map_err(errors::file("FigureError"))?;
        if body.markers.markers.is_empty() {
            body.markers.markers = body.frames_as_markers();
        }
        let read = |trial: &PathBuf| {
            let read = files::in_world(trial, body.gravity, unit, None).map_err(errors::file("FileError"))?;
            Ok::<_, PyErr>(read.recording.markers)
        };
        let recorded = trials.iter().map(read).collect::<PyResult<Vec<_>>>()?;
        let options = IkOptions {
            held: body.locked(),
            bounds: body.clamped(),
            rest: Some(body.rest()),
            ..IkOptions::default()
        };
        let refuse =
            |error: &dyn std::fmt::Display| errors::of_path(&path, &format!("{}: {error}", path.display()));
        let markers = &body.markers.markers;
        let found = fit_subject(&body.figure, markers, &recorded, &options, &FitOptions::default())
            .map_err(|error| refuse(&error))?;
        let factors = of_bodies(&body, &found.factors);
        let mut model = None;
        if body.language == Language::OpenSim {
            // Through the model's text: a link there may be several bodies.
            let text = resized(&path, &body, &found, &factors, mass)?;
            let import = opensim::read(&text).map_err(|faults| refuse(&faults))?;
            body.figure = import.figure.with_gravity(body.gravity).map_err(|error| refuse(&error))?;
            model = Some(text);
        } else {
            let stretching = Stretching { factors: found.factors.clone(), mass, shares: MassShares::Kept };
            body.figure = body.figure.stretched(&stretching).map_err(|error| refuse(&error))?;
        }
        body.markers.markers.clone_from(&found.markers);
        Ok(Subject { figure: Figure::of(body), model, found, factors })
    })
}

/// The factors of links, and with each those of what is welded to it.
fn of_bodies(body: &Body, factors: &[Vector3<f64>]) -> Vec<(String, Vector3<f64>)> {
    let mut bodies: Vec<(String, Vector3<f64>)> = Vec::new();
    for (link, by) in body.figure.links().iter().zip(factors) {
        let frames = link.frames().iter().map(|frame| frame.name.as_str());
        for name in std::iter::once(link.name()).chain(frames) {
            if bodies.iter().all(|(known, _)| known != name) {
                bodies.push((name.to_owned(), *by));
            }
        }
    }
    bodies
}

/// The text of a model of OpenSim, scaled, with the markers where they were found.
fn resized(
    path: &Path,
    body: &Body,
    found: &SubjectFit,
    factors: &[(String, Vector3<f64>)],
    mass: Option<f64>,
) -> PyResult<String> {
    let text = files::decoded(path).map_err(errors::file("FileError"))?;
    let is_body = |name: &str| text.contains(&format!("<Body name=\"{name}\""));
    let factors = factors.iter().filter(|(name, _)| is_body(name)).cloned().collect();
    let place = |marker: &solaris::model::Marker| {
        let own = body.figure.links()[marker.link].name();
        let (_, placement) = body.figure.locate(own).unwrap_or_default();
        let position = placement.inverse_transform_point(&marker.position.into()).coords;
        MarkerPlace { name: marker.name.clone(), body: own.to_owned(), position, is_fixed: marker.is_fixed }
    };
    let markers = found.markers.iter().map(place).collect();
    let mass = Some(mass.unwrap_or_else(|| body.figure.mass()));
    let rescaling = Rescaling { factors, mass, shares: MassShares::Kept, markers, removed: Vec::new() };
    let shown = path.display().to_string();
    let faulty = |faults: solaris::model::TextError| {
        errors::text("FigureError", &shown, &format!("{shown}: {faults}"), &[(&shown, &faults)])
    };
    opensim::rescale(&text, &rescaling).map(|(text, _)| text).map_err(faulty)
}

#[pymethods]
impl Subject {
    /// The figure, which knows its markers: `inverse_kinematics` takes it.
    #[getter]
    fn figure(&self) -> Figure {
        self.figure.clone()
    }

    /// The factors of each body along its own x, y and z.
    #[getter]
    fn factors(&self) -> BTreeMap<String, [f64; 3]> {
        self.factors.iter().map(|(name, by)| (name.clone(), (*by).into())).collect()
    }

    /// The segments' lengths (m), each a dictionary: `segment`, `before`, `length` and its `standard_error`.
    #[getter]
    fn lengths<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let one = |fit: &solaris::analysis::markers::SegmentFit| {
            let one = PyDict::new(py);
            one.set_item("segment", &fit.link)?;
            one.set_item("before", fit.before)?;
            one.set_item("length", fit.length)?;
            one.set_item("standard_error", fit.error)?;
            Ok(one)
        };
        self.found.lengths.iter().map(one).collect()
    }

    /// How far each marker was moved on its link (m).
    #[getter]
    fn moved(&self) -> BTreeMap<String, f64> {
        self.found.moved.iter().cloned().collect()
    }

    /// The root mean square distance of all markers from where they were seen (m).
    #[getter]
    fn rms(&self) -> f64 {
        self.found.rms
    }

    /// The same of the model as it was, in its best poses (m).
    #[getter]
    fn rms_before(&self) -> f64 {
        self.found.rms_before
    }

    /// Writes it: `.osim`, the model's own text scaled, or `.ron`, its markers as named frames.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        let extension = files::extension(&path);
        let text = match (&*extension, &self.model) {
            ("ron", _) => solaris::model::text::write(&self.figure.body.marked()),
            ("osim", Some(model)) => model.clone(),
            ("osim", None) => {
                return Err(value("only a model of OpenSim is written as one; write a figure's text: .ron"));
            }
            _ => return Err(value(format!("'{}' must end in .osim or .ron", path.display()))),
        };
        std::fs::write(&path, text)
            .map_err(|error| errors::of_path(&path, &format!("{}: {error}", path.display())))
    }

    fn __repr__(&self) -> String {
        let (name, mass) = (self.figure.figure().name().escape_debug(), self.figure.figure().mass());
        format!("<Subject '{name}': {mass:.3} kg, markers {:.1} mm rms>", 1e3 * self.found.rms)
    }
}
