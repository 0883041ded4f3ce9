//! Motions: sampled states of one figure, with what is known of forces.

use crate::arrays::{States, contiguous};
use crate::errors::{self, argument, value};
use crate::figure::Figure;
use crate::{arrow, written};
use numpy::ndarray::{ArrayView, Dimension, IntoDimension};
use numpy::{PyArray, PyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict};
use solaris::files;
use solaris::io::record;
use solaris::model::{self, EventKind, Known, MotionInfo};
use solaris::scene::OneOfSeveral;
use std::path::PathBuf;
use std::sync::Arc;

/// A motion of a figure, sampled: positions, and velocities, accelerations, forces and contacts where they are known.
///
/// Its arrays are views of its own memory and cannot be written. `time` is in s, `q` in rad and m, `tau` in N m and N.
#[pyclass(frozen, module = "solaris")]
#[derive(Clone)]
pub(crate) struct Motion {
    pub(crate) figure: Figure,
    pub(crate) motion: Arc<model::Motion>,
    /// What a page says above it.
    pub(crate) title: String,
    /// Whether its last sample is its first one again.
    pub(crate) repeats: bool,
    /// Of a scene with several figures each with its part of it.
    pub(crate) several: Arc<Vec<OneOfSeveral>>,
}

/// Reads the motion of a figure: `.csv`, `.mot`, `.sto` or `.bvh`, in radians and metres afterwards.
///
/// Coordinates that the file does not name are where an OpenSim model's defaults say. Raises `FileError` and `MotionError`.
#[pyfunction]
pub(crate) fn read_motion(py: Python<'_>, figure: &Figure, path: PathBuf) -> PyResult<Motion> {
    let read = py.detach(|| -> PyResult<model::Motion> {
        let body = &figure.body;
        let (table, _) = files::motion(&path, &body.figure).map_err(errors::file("MotionError"))?;
        record::read_with_defaults(&body.figure, body.gravity, &table, &body.defaults)
            .map(|read| read.motion)
            .map_err(|error| errors::of_table(&path, &error))
    })?;
    Ok(Motion::new(figure, read, String::new()))
}

impl Motion {
    pub(crate) fn new(figure: &Figure, motion: model::Motion, title: String) -> Self {
        let (figure, motion) = (figure.clone(), Arc::new(motion));
        Self { figure, motion, title, repeats: false, several: Arc::default() }
    }

    fn view<'py>(
        of: &Bound<'py, Self>,
        numbers: &[f64],
        width: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rows = of.get().motion.len();
        match width {
            None => view(of, numbers, [rows]),
            Some(width) => view(of, numbers, [rows, width]),
        }
    }
}

/// Numbers of a motion as an array that keeps the motion alive and cannot be written.
#[allow(
    unsafe_code,
    reason = "numpy is shown memory that the motion owns, which never changes while the motion lives"
)]
fn view<'py, D: Dimension>(
    of: &Bound<'py, Motion>,
    numbers: &[f64],
    shape: impl IntoDimension<Dim = D>,
) -> PyResult<Bound<'py, PyAny>> {
    let lies = ArrayView::from_shape(shape.into_dimension(), numbers).map_err(value)?;
    // SAFETY: the motion is behind an `Arc` that nobody writes through, and the array holds the motion.
    let array = unsafe { PyArray::borrow_from_array(&lies, of.clone().into_any()) };
    array.getattr("flags")?.setattr("writeable", false)?;
    Ok(array.into_any())
}

#[pymethods]
impl Motion {
    /// A motion from its numbers: `time` (rising, s), `q` (a row a sample), and `v` and `a` where they are known.
    #[new]
    #[pyo3(signature = (figure, time, q, v=None, a=None))]
    fn make(
        figure: &Figure,
        time: &Bound<'_, PyAny>,
        q: &Bound<'_, PyAny>,
        v: Option<&Bound<'_, PyAny>>,
        a: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let layout = figure.figure().layout();
        let time = contiguous("time", time)?;
        let [rows] = *time.shape() else { return Err(argument("time", "time must be a vector")) };
        let states = |name: &str, given: &Bound<'_, PyAny>, width: usize| {
            let states = States::of(name, given, width)?;
            if states.rows == Some(rows) {
                Ok(states.numbers().to_vec())
            } else {
                Err(argument(
                    name,
                    format!("{name} must have a row for each of the {rows} times: ({rows}, {width})"),
                ))
            }
        };
        let rate = |name, given: Option<&Bound<'_, PyAny>>| match given {
            Some(given) => states(name, given, layout.nv()),
            None => Ok(vec![0.0; rows * layout.nv()]),
        };
        let known = Known { v: vec![v.is_some(); layout.nv()], a: vec![a.is_some(); layout.nv()] };
        let (q, v, a) = (states("q", q, layout.nq())?, rate("v", v)?, rate("a", a)?);
        let time = time.as_slice().unwrap_or_default().to_vec();
        let info = MotionInfo::recorded(figure.figure(), figure.body.gravity, &time);
        let motion =
            model::Motion::recorded(figure.figure(), info, time, [q, v, a], known).map_err(errors::motion)?;
        Ok(Self::new(figure, motion, String::new()))
    }

    /// The figure that moves.
    #[getter]
    fn figure(&self) -> Figure {
        self.figure.clone()
    }

    /// Times (s).
    #[getter]
    fn time<'py>(of: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::view(of, of.get().motion.time(), None)
    }

    /// Positions (rad, m), a row a sample.
    #[getter]
    fn q<'py>(of: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let this = of.get();
        Self::view(of, this.motion.columns()[0], Some(this.figure.figure().layout().nq()))
    }

    /// Velocities (rad/s, m/s), a row a sample; `None` where no coordinate's is known.
    #[getter]
    fn v<'py>(of: &Bound<'py, Self>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let this = of.get();
        let known = this.motion.known().v.iter().any(|known| *known);
        let width = Some(this.figure.figure().layout().nv());
        known.then(|| Self::view(of, this.motion.columns()[1], width)).transpose()
    }

    /// Accelerations (rad/s², m/s²), a row a sample; `None` where no coordinate's is known.
    #[getter]
    fn a<'py>(of: &Bound<'py, Self>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let this = of.get();
        let known = this.motion.known().a.iter().any(|known| *known);
        let width = Some(this.figure.figure().layout().nv());
        known.then(|| Self::view(of, this.motion.columns()[2], width)).transpose()
    }

    /// Generalized forces (N m, N), a row a sample; `None` where nobody asked for them.
    #[getter]
    fn tau<'py>(of: &Bound<'py, Self>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let this = of.get();
        let width = Some(this.figure.figure().layout().nv());
        this.motion.taus().map(|taus| Self::view(of, taus, width)).transpose()
    }

    /// Samples a second (1/s).
    #[getter]
    fn rate(&self) -> f64 {
        self.motion.info.rate
    }

    /// Acceleration of gravity (m/s²).
    #[getter]
    fn gravity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.motion.info.gravity.as_slice())
    }

    /// What the ground does to each link that touches it: `{link: {"force", "moment", "cop"}}`, each `(samples, 3)`; force in N,
    /// its moment about the world's origin in N m, centre of pressure in m.
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        crate::analysis::contacts_of(py, &self.motion.contacts)
    }

    /// What happens when: `(time, kind, name)`, kinds `"touch_down"`, `"lift_off"`, `"root_change"` and `"drive_change"`.
    #[getter]
    fn events(&self) -> Vec<(f64, &'static str, String)> {
        events(&self.motion.events)
    }

    /// Names of the table's columns: `time`, `DOF.q`, `DOF.v`, `DOF.a`, `DOF.tau` where known, `LINK.fx` to `LINK.pz`.
    #[getter]
    fn columns(&self) -> Vec<String> {
        record::headings(self.figure.figure(), &self.motion)
    }

    /// The table as a dictionary of arrays, which `pandas.DataFrame` takes as it is.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (name, numbers) in self.columns().into_iter().zip(py.detach(|| arrow::columns(&self.motion))) {
            all.set_item(name, PyArray1::from_vec(py, numbers))?;
        }
        Ok(all)
    }

    /// The table as a `pandas.DataFrame`; needs pandas.
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("pandas")?.call_method1("DataFrame", (self.to_dict(py)?,))
    }

    /// The table as a `polars.DataFrame`; needs polars.
    fn to_polars<'py>(of: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        of.py().import("polars")?.call_method1("DataFrame", (of,))
    }

    /// The table by the Arrow C interface: what `polars.DataFrame(motion)`, `pyarrow.table(motion)` and DuckDB read.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // Whoever asks for another schema casts what comes.
        let _ = requested_schema;
        arrow::stream(py, self.columns(), &self.motion)
    }

    /// Its columns' types by the Arrow C interface.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        arrow::schema(py, self.columns())
    }

    /// Writes it, as the extension says: `.html` a page, `.glb` or `.usda` a body with its animation, `.bvh` motion capture, `.csv` or `.parquet` a table, `.mot` or
    /// `.sto` positions in degrees for OpenSim, `.svg` a film strip. The file is there whole or not at all. With `arrows` a `.glb` has nodes more: an arrow for each
    /// force of a contact, 1 m for the body's weight, and a ball at the centre of mass. Of a loop, whose last sample is its first one again, tables and `.bvh` have one frame
    /// less; of a scene with several figures a `.glb` has a body for each.
    #[pyo3(signature = (path, *, arrows=false))]
    fn save(&self, py: Python<'_>, path: PathBuf, arrows: bool) -> PyResult<()> {
        py.detach(|| written::save(self, &path, arrows))
    }

    /// The page of the motion, as HTML.
    fn to_html(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| written::page(self))
    }

    /// A page inside a notebook.
    fn _repr_html_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("solaris._shown")?.call_method1("frame", (self.to_html(py)?,))
    }

    /// Draws columns over time with matplotlib, a panel a quantity: `motion.plot("left_knee.rx", "right_knee.rx")`, or `"*knee*"`;
    /// `of` is `"q"`, `"v"`, `"a"` or `"tau"`. Gives the axes.
    #[pyo3(signature = (*names, of="q", axes=None))]
    fn plot<'py>(
        this: &Bound<'py, Self>,
        names: Vec<String>,
        of: &str,
        axes: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        this.py().import("solaris._shown")?.call_method1("plot", (this, names, of, axes))
    }

    fn __len__(&self) -> usize {
        self.motion.len()
    }

    fn __repr__(&self) -> String {
        let time = self.motion.time();
        let lasts = time.last().zip(time.first()).map_or(0.0, |(last, first)| last - first);
        let forces = if self.motion.taus().is_some() { ", forces known" } else { "" };
        let name = self.figure.figure().name().escape_debug().to_string();
        format!("<Motion of '{name}': {} samples over {lasts:.3} s{forces}>", self.motion.len())
    }
}

/// Events: when, what and of which link or drive.
pub(crate) fn events(of: &[model::Event]) -> Vec<(f64, &'static str, String)> {
    let told = |kind: &EventKind| match kind {
        EventKind::TouchDown { link } => ("touch_down", link.clone()),
        EventKind::LiftOff { link } => ("lift_off", link.clone()),
        EventKind::RootChange { link } => ("root_change", link.clone()),
        EventKind::DriveChange { what } => ("drive_change", what.clone()),
        _ => ("other", String::new()),
    };
    let event = |event: &model::Event| {
        let (kind, name) = told(&event.kind);
        (event.time, kind, name)
    };
    of.iter().map(event).collect()
}
