//! What is known of a given motion: derivatives, joint forces, the ground's forces; positions from markers.

use crate::arrays::{contiguous, count, shape, shaped};
use crate::errors::{self, argument, plain, value};
use crate::figure::Figure;
use crate::motion::Motion;
use crate::report::dictionary;
use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::Value;
use solaris::analysis::ground::{
    self, GroundForces, GroundOptions, PlacedFeet, Sole, Split, guessed_soles, soles,
};
use solaris::analysis::markers::{IkOptions, MarkerMotion};
use solaris::analysis::{
    Filter, InverseOptions, InverseReport, Loads, PreparedMotion, differentiate as derive, inverse_motion,
};
use solaris::files;
use solaris::io::markers::LengthUnit;
use solaris::io::{opensim, record};
use solaris::model::{self, Contact, ContactTrack, Known, MeasuredForce, MotionInfo, Vector3, nearest};
use solaris::scene::read_soles;
use std::path::{Path, PathBuf};

/// The motion with velocities and accelerations, found where they are not known.
///
/// `filter` is the cut-off (Hz) of a zero-phase Butterworth low-pass of `order` there and back, for positions that were measured;
/// OpenSim's is 6 Hz and 3.
///
/// >>> import numpy as np, solaris
/// >>> human = solaris.human()
/// >>> time = np.linspace(0, 1, 101)
/// >>> q = np.zeros((101, human.nq))
/// >>> q[:, 1] = 0.5 * time**2
/// >>> motion = solaris.differentiate(solaris.Motion(human, time, q))
/// >>> bool(abs(motion.a[50, 1] - 1.0) < 1e-6)
/// True
#[pyfunction]
#[pyo3(signature = (motion, filter=None, order=2))]
pub(crate) fn differentiate(
    py: Python<'_>,
    motion: &Motion,
    filter: Option<f64>,
    order: i64,
) -> PyResult<Motion> {
    let filter = low_pass(filter, order)?;
    let found = py.detach(|| derive(motion.figure.figure(), &motion.motion, filter));
    let found = found.map_err(|error| plain("MotionError")(&error))?;
    Ok(Motion::new(&motion.figure, found.motion, motion.title.clone()))
}

fn low_pass(filter: Option<f64>, order: i64) -> PyResult<Option<Filter>> {
    let order = count("order", order)?;
    Ok(filter.map(|cutoff| Filter { cutoff, order }))
}

/// A motion of which everything is known: itself, or differentiated.
pub(crate) fn complete(motion: &Motion, filter: Option<f64>, order: i64) -> PyResult<Motion> {
    if motion.motion.known().is_all() {
        return Ok(motion.clone());
    }
    let filter = low_pass(filter, order)?;
    let found = derive(motion.figure.figure(), &motion.motion, filter)
        .map_err(|error| plain("MotionError")(&error))?;
    Ok(Motion::new(&motion.figure, found.motion, motion.title.clone()))
}

/// The ground's forces of a motion, found without plates.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Ground {
    motion: Motion,
    forces: GroundForces,
    report: Value,
}

/// Finds the ground's forces from the motion alone: the laws of motion give the whole wrench, and `split` shares it between feet
/// that stand together (`"transition"`, `"pivot"` or `"effort"`).
///
/// `soles` is the path of a file that says where the feet meet the ground; without it they are the figure's own, or guessed by the
/// names of OpenSim's bodies. `filter` and `order` are those of `differentiate`, for a motion whose velocities are not known.
///
/// >>> import solaris
/// >>> walk = solaris.walk(steps=4)
/// >>> ground = solaris.ground_forces(walk.motion)
/// >>> sorted(ground.contacts)
/// ['left_foot', 'right_foot']
#[pyfunction]
#[pyo3(signature = (motion, *, split="pivot", soles=None, filter=None, order=2))]
pub(crate) fn ground_forces(
    py: Python<'_>,
    motion: &Motion,
    split: &str,
    soles: Option<PathBuf>,
    filter: Option<f64>,
    order: i64,
) -> PyResult<Ground> {
    let split = Split::named(split).ok_or_else(|| {
        let known: Vec<String> = Split::ALL.iter().map(|known| format!("'{}'", known.name())).collect();
        argument("split", format!("split is '{split}'; it must be one of {}", known.join(", ")))
    })?;
    py.detach(|| {
        let motion = complete(motion, filter, order)?;
        let figure = motion.figure.figure();
        let soles = feet(figure, soles.as_deref())?;
        let prepared =
            PreparedMotion::new(figure, &motion.motion).map_err(|error| plain("MotionError")(&error))?;
        let refuse = |error: ground::GroundError| plain("MotionError")(&error);
        let feet = PlacedFeet::new(&prepared, soles).map_err(refuse)?;
        let options = GroundOptions { split, ..GroundOptions::default() };
        let forces = ground::ground_forces(&feet, &options).map_err(refuse)?;
        let report = serde_json::to_value(&forces.report).map_err(value)?;
        Ok(Ground { motion: motion.clone(), forces, report })
    })
}

/// Where the feet meet the ground: in a file, of the figure's own, or guessed.
fn feet(figure: &model::Figure, path: Option<&Path>) -> PyResult<Vec<Sole>> {
    if let Some(path) = path {
        let text = files::text(path).map_err(errors::file("FileError"))?;
        return read_soles(&text, figure).map_err(|faults| {
            let shown = path.display().to_string();
            errors::text("FigureError", &shown, &format!("{shown}: {faults}"), &[(&shown, &faults)])
        });
    }
    let own = soles(figure);
    let known = if own.is_empty() { guessed_soles(figure) } else { own };
    if known.is_empty() {
        return Err(plain("MotionError")(&format!(
            "figure '{}' has no soles, and no bodies calcn_r and toes_r, calcn_l and toes_l to guess them by; write them into a \
             file, and name it by soles=",
            figure.name()
        )));
    }
    Ok(known)
}

/// Contacts by link, as arrays.
pub(crate) fn contacts_of<'py>(py: Python<'py>, tracks: &[ContactTrack]) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    for track in tracks {
        let of = |pick: fn(&Contact) -> [f64; 3]| -> PyResult<_> {
            let numbers: Vec<f64> = track.samples.iter().flat_map(pick).collect();
            PyArray1::from_vec(py, numbers).reshape([track.samples.len(), 3])
        };
        let one = PyDict::new(py);
        one.set_item("force", of(|contact| contact.force.into())?)?;
        one.set_item("moment", of(|contact| contact.moment.into())?)?;
        one.set_item("cop", of(|contact| contact.cop.into())?)?;
        all.set_item(&track.link, one)?;
    }
    Ok(all)
}

/// One contact at an instant.
pub(crate) fn contact<'py>(py: Python<'py>, contact: &Contact) -> PyResult<Bound<'py, PyDict>> {
    let one = PyDict::new(py);
    for (name, numbers) in [("force", contact.force), ("moment", contact.moment), ("cop", contact.cop)] {
        one.set_item(name, PyArray1::from_slice(py, numbers.as_slice()))?;
    }
    Ok(one)
}

#[pymethods]
impl Ground {
    /// What the ground does to each foot, as `Motion.contacts` has it.
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        contacts_of(py, &self.forces.contacts)
    }

    /// What is to be said of them: what is irregular, unsupported, carried elsewhere.
    #[getter]
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        dictionary(py, &self.report)
    }

    /// The motion that they were found of, everything known.
    #[getter]
    fn motion(&self) -> Motion {
        self.motion.clone()
    }

    fn __repr__(&self) -> String {
        format!(
            "<Ground: forces of {} feet over {} samples>",
            self.forces.contacts.len(),
            self.motion.motion.len()
        )
    }
}

/// The joints' forces of a motion.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Inverse {
    motion: Motion,
    report: InverseReport,
}

/// The generalized forces that move a figure through its motion.
///
/// What acts from outside is one of: `ground`, what `ground_forces` found; `plates`, a dictionary of link names to prefixes of columns,
/// in the table `external` (`.mot`, `.sto`, `.csv`); `external_loads`, OpenSim's description (`.xml`) with the table that it names; or
/// `wrenches`, a dictionary of link names to arrays `(samples, 6)`, `[fx, fy, fz, mx, my, mz]` in world axes about the world's origin.
/// With none of them a motion that has contacts, as a walk has, is taken with these; `contacts=False` leaves them out.
///
/// `passive` counts armature, springs, dampers and friction of the joints in. `filter` and `order` are those of `differentiate`.
///
/// >>> import solaris
/// >>> walk = solaris.walk(steps=4)
/// >>> found = solaris.inverse_dynamics(walk.motion)
/// >>> bool(abs(found.tau - walk.motion.tau).max() < 1e-6)
/// True
/// >>> found.residual["force_greatest_n"] < 1e-3
/// True
#[pyfunction]
#[pyo3(signature = (
    motion, ground=None, *, external=None, plates=None, external_loads=None, wrenches=None, contacts=true, passive=false,
    filter=None, order=2
))]
pub(crate) fn inverse_dynamics(
    py: Python<'_>,
    motion: &Motion,
    ground: Option<&Ground>,
    external: Option<PathBuf>,
    plates: Option<&Bound<'_, PyDict>>,
    external_loads: Option<PathBuf>,
    wrenches: Option<&Bound<'_, PyDict>>,
    contacts: bool,
    passive: bool,
    filter: Option<f64>,
    order: i64,
) -> PyResult<Inverse> {
    let given = [ground.is_some(), external.is_some(), external_loads.is_some(), wrenches.is_some()];
    if given.iter().filter(|given| **given).count() > 1 {
        return Err(value("give one of ground, external, external_loads and wrenches"));
    }
    let plates: Vec<(String, String)> = match plates {
        Some(plates) => plates
            .iter()
            .map(|(link, prefix)| Ok((link.extract()?, prefix.extract()?)))
            .collect::<PyResult<_>>()?,
        None => Vec::new(),
    };
    if external.is_some() == plates.is_empty() {
        return Err(value(
            "external= names a table of forces and plates= which of its columns push which link: give both or none, as \
             plates={'calcn_r': '', 'calcn_l': '1_'}",
        ));
    }
    let wrenches = match wrenches {
        Some(wrenches) => Some(wrenches_of(motion, wrenches)?),
        None => None,
    };
    py.detach(|| {
        let motion = complete(motion, filter, order)?;
        let figure = motion.figure.figure();
        let mut records = Vec::new();
        if let Some(path) = &external {
            let table = forces_of(path)?;
            for (link, prefix) in &plates {
                let link = located(figure, link)?;
                let record = record::forces(&table, &[link], prefix)
                    .map_err(|error| errors::of_path(path, &format!("{}: {error}", path.display())))?;
                records.push(record);
            }
        }
        if let Some(path) = &external_loads {
            records = loads_of(figure, path)?;
        }
        if let Some(wrenches) = wrenches {
            records = wrenches;
        }
        let none = given.iter().all(|given| !given);
        if none && contacts {
            let soles = soles(figure);
            records = motion.motion.contacts.iter().map(|track| measured(&motion, &soles, track)).collect();
        }
        let mut loads = Loads::at_times(figure, &records, motion.motion.time())
            .map_err(|error| plain("MotionError")(&error))?;
        if let Some(ground) = ground {
            loads = loads.and(ground.forces.loads());
        }
        let prepared =
            PreparedMotion::new(figure, &motion.motion).map_err(|error| plain("MotionError")(&error))?;
        let report = inverse_motion(&prepared, &loads, InverseOptions { passive, progress: None })
            .map_err(|error| plain("DynamicsError")(&error))?;
        let mut done = model::Motion::clone(&motion.motion);
        done.set_tau(report.tau.clone()).map_err(|error| plain("MotionError")(&error))?;
        done.contacts = loads.contacts(figure);
        Ok(Inverse { motion: Motion::new(&motion.figure, done, motion.title.clone()), report })
    })
}

/// A contact of the motion as a force that was measured with it; where a foot has toes, it passes on to them.
fn measured(motion: &Motion, soles: &[Sole], track: &ContactTrack) -> MeasuredForce {
    let links = motion.figure.figure().links();
    let toes = soles.iter().filter(|sole| links[sole.foot].name() == track.link).find_map(|sole| sole.toes);
    let toes = toes.map(|toes| links[toes].name().to_owned());
    MeasuredForce {
        links: std::iter::once(track.link.clone()).chain(toes).collect(),
        ball_and_tip: None,
        time: motion.motion.time().to_vec(),
        samples: track.samples.clone(),
    }
}

/// A table of forces, rows that repeat a time left out.
fn forces_of(path: &Path) -> PyResult<solaris::io::Table> {
    Ok(files::table(path).map_err(errors::file("FileError"))?.without_repeated_times().into_owned())
}

/// The link of a name of a link or frame.
fn located(figure: &model::Figure, name: &str) -> PyResult<String> {
    let found = figure.locate(name).map(|(index, _)| figure.links()[index].name().to_owned());
    found.ok_or_else(|| {
        let near = nearest(name, figure.links().iter().map(model::Link::name));
        let hint = near.map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
        plain("MotionError")(&format!(
            "figure '{}' has no link and no frame '{name}' to push{hint}",
            figure.name()
        ))
    })
}

/// The forces that OpenSim's description names.
fn loads_of(figure: &model::Figure, path: &Path) -> PyResult<Vec<MeasuredForce>> {
    let shown = path.display().to_string();
    let text = files::decoded(path).map_err(errors::file("FileError"))?;
    let loads = opensim::external_loads(&text).map_err(|faults| {
        errors::text("FigureError", &shown, &format!("{shown}: {faults}"), &[(&shown, &faults)])
    })?;
    let data = loads.data_file.as_deref().ok_or_else(|| {
        errors::of_path(
            path,
            &format!("{shown}: it names no data file: <datafile> must hold the path of the forces"),
        )
    })?;
    let data = path.parent().unwrap_or_else(|| Path::new("")).join(data.trim());
    let mut records = loads
        .records(&forces_of(&data)?)
        .map_err(|error| errors::of_path(&data, &format!("{}: {error}", data.display())))?;
    for link in records.iter_mut().flat_map(|record| &mut record.links) {
        *link = located(figure, link)?;
    }
    Ok(records)
}

/// Wrenches at the motion's own times.
fn wrenches_of(motion: &Motion, given: &Bound<'_, PyDict>) -> PyResult<Vec<MeasuredForce>> {
    let rows = motion.motion.len();
    let one = |(link, numbers): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let link: String = link.extract()?;
        let name = format!("wrenches['{link}']");
        let array = contiguous(&name, &numbers)?;
        if *array.shape() != [rows, 6] {
            let found = shape(array.shape());
            return Err(argument(&name, format!("{name} has the shape {found}; it must be ({rows}, 6)")));
        }
        let wrench = |six: &[f64]| {
            let [force, moment] = [0, 3].map(|at| Vector3::new(six[at], six[at + 1], six[at + 2]));
            Contact { force, moment, ..Contact::default() }
        };
        let samples = array.as_slice().unwrap_or_default().chunks_exact(6).map(wrench).collect();
        let time = motion.motion.time().to_vec();
        Ok(MeasuredForce {
            links: vec![located(motion.figure.figure(), &link)?],
            ball_and_tip: None,
            time,
            samples,
        })
    };
    given.iter().map(one).collect()
}

#[pymethods]
impl Inverse {
    /// Generalized forces (N m, N), a row a sample, in the order of `figure.v_names`.
    #[getter]
    fn tau<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let nv = self.motion.figure.figure().layout().nv();
        shaped(py, self.report.tau.clone(), Some(self.motion.motion.len()), nv)
    }

    /// What is missing for the balance of the whole figure, of each sample: force (N) and moment about the root's origin (N m),
    /// `(samples, 2)`.
    #[getter]
    fn residuals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let numbers: Vec<f64> = self.report.residuals.iter().flatten().copied().collect();
        shaped(py, numbers, Some(self.report.residuals.len()), 2)
    }

    /// The same in short: root mean squares and greatest values; the names end in their units.
    #[getter]
    fn residual<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        dictionary(py, &self.report.residual)
    }

    /// Of each degree of freedom how great its force is: a list of dictionaries.
    #[getter]
    fn joints<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        dictionary(py, &self.report.dofs)
    }

    /// The motion with these forces, and with what acted from outside as its contacts.
    #[getter]
    fn motion(&self) -> Motion {
        self.motion.clone()
    }

    /// Writes the motion with its forces; see `Motion.save`.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        py.detach(|| crate::written::save(&self.motion, &path, false))
    }

    fn __repr__(&self) -> String {
        let residual = &self.report.residual;
        format!(
            "<Inverse: {} samples, residual {:.3} N and {:.3} N m rms>",
            self.motion.motion.len(),
            residual.force_rms,
            residual.moment_rms
        )
    }
}

/// Positions that were found from markers.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Kinematics {
    motion: Motion,
    found: MarkerMotion,
}

/// The unit of a recording's lengths, by its name.
pub(crate) fn length_unit(name: Option<&str>) -> PyResult<Option<LengthUnit>> {
    match name {
        None => Ok(None),
        Some("mm") => Ok(Some(LengthUnit::Millimetres)),
        Some("cm") => Ok(Some(LengthUnit::Centimetres)),
        Some("m") => Ok(Some(LengthUnit::Metres)),
        Some(other) => Err(argument("unit", format!("unit is '{other}'; it must be 'mm', 'cm' or 'm'"))),
    }
}

/// Finds the positions in which a figure's markers come nearest to where a recording (`.c3d`, `.trc`) saw them.
///
/// The markers are the model's, or its named frames. `unit` is that of the file's lengths where the file does not say it: `"mm"`, `"cm"` or
/// `"m"`. `weights` are by marker; those not named weigh nothing.
#[pyfunction]
#[pyo3(signature = (figure, path, *, unit=None, weights=None))]
pub(crate) fn inverse_kinematics(
    py: Python<'_>,
    figure: &Figure,
    path: PathBuf,
    unit: Option<&str>,
    weights: Option<&Bound<'_, PyDict>>,
) -> PyResult<Kinematics> {
    let unit = length_unit(unit)?;
    let weights: Option<Vec<(String, f64)>> = match weights {
        Some(given) => Some(
            given
                .iter()
                .map(|(name, weight)| Ok((name.extract()?, weight.extract()?)))
                .collect::<PyResult<_>>()?,
        ),
        None => None,
    };
    py.detach(|| {
        let body = &figure.body;
        let read = files::in_world(&path, body.gravity, unit, None).map_err(errors::file("FileError"))?;
        let trial = &read.recording.markers;
        let markers = if body.markers.markers.is_empty() {
            body.frames_as_markers()
        } else {
            body.markers.markers.clone()
        };
        let options = IkOptions {
            weights,
            held: body.locked(),
            bounds: body.clamped(),
            rest: Some(body.rest()),
            ..IkOptions::default()
        };
        let found = solaris::analysis::markers::inverse_kinematics(&body.figure, &markers, trial, &options)
            .map_err(|error| errors::of_path(&path, &format!("{}: {error}", path.display())))?;
        let (time, nv) = (trial.time().to_vec(), body.figure.layout().nv());
        let info = MotionInfo::recorded(&body.figure, body.gravity, &time);
        let still = vec![0.0; time.len() * nv];
        let states = [found.q.clone(), still.clone(), still];
        let motion = model::Motion::recorded(&body.figure, info, time, states, Known::none(nv))
            .map_err(|error| plain("MotionError")(&error))?;
        Ok(Kinematics { motion: Motion::new(figure, motion, String::new()), found })
    })
}

#[pymethods]
impl Kinematics {
    /// The motion: positions alone, which `inverse_dynamics` differentiates.
    #[getter]
    fn motion(&self) -> Motion {
        self.motion.clone()
    }

    /// Root of the mean square of all distances of markers (m).
    #[getter]
    fn rms(&self) -> f64 {
        self.found.rms()
    }

    /// The same of each sample (m); NaN where no marker was seen.
    #[getter]
    fn frame_rms<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.found.frames.iter().map(|frame| frame.rms).collect())
    }

    /// The same of each marker (m), by name; NaN of one that was never seen.
    #[getter]
    fn marker_rms(&self) -> std::collections::BTreeMap<String, f64> {
        self.found.markers.iter().map(|marker| (marker.name.clone(), marker.rms)).collect()
    }

    /// In how many samples the solver came to a minimum.
    #[getter]
    fn converged(&self) -> usize {
        self.found.frames.iter().filter(|frame| frame.converged).count()
    }

    fn __repr__(&self) -> String {
        format!(
            "<Kinematics: {} samples, markers off by {:.1} mm rms>",
            self.motion.motion.len(),
            1e3 * self.rms()
        )
    }
}
