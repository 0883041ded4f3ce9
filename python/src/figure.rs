//! Figures: made, read, and asked what they are.

use crate::arrays::{States, contiguous, fixed, shape, shaped};
use crate::errors;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use solaris::files::{self, Body};
use solaris::io::{mjcf, opensim, sdf, urdf};
use solaris::model::{self, Human, RootOrder, text};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

/// Body mass index of people of whom no mass is said (kg/m²).
const BODY_MASS_INDEX: f64 = 23.8;

/// An articulated figure: links in a tree, each moved by its joint against its parent. It never changes.
#[pyclass(frozen, module = "solaris")]
#[derive(Clone)]
pub(crate) struct Figure {
    pub(crate) body: Arc<Body>,
}

impl Figure {
    pub(crate) fn own(figure: model::Figure) -> Self {
        Self { body: Arc::new(Body::own(figure)) }
    }

    pub(crate) fn of(body: Body) -> Self {
        Self { body: Arc::new(body) }
    }

    pub(crate) fn figure(&self) -> &model::Figure {
        &self.body.figure
    }

    fn of_text(source: &str, format: &str) -> PyResult<Self> {
        let faulty =
            |faults: model::TextError| errors::text("FigureError", "", &faults.to_string(), &[("", &faults)]);
        let import = match format {
            "ron" => return text::read(source).map(Self::own).map_err(faulty),
            "urdf" => urdf::read(source).map_err(faulty)?,
            "sdf" => sdf::read(source).map_err(faulty)?,
            "osim" => opensim::read(source).map_err(faulty)?,
            "mjcf" => mjcf::read(source).map_err(faulty)?,
            other => {
                let known = "'ron', 'urdf', 'mjcf', 'osim' or 'sdf'";
                return Err(errors::argument("format", format!("format is '{other}'; it must be {known}")));
            }
        };
        let mut body = Body::own(import.figure.clone());
        (body.gravity, body.gravity_is_given, body.findings) =
            (import.gravity, import.gravity_is_given, import.findings);
        body.figure = body.figure.with_gravity(import.gravity).map_err(errors::figure)?;
        if format == "osim" {
            body.defaults = opensim::coordinate_defaults(source);
            body.markers = opensim::markers(source, &body.figure).map_err(faulty)?;
        }
        Ok(Self { body: Arc::new(body) })
    }
}

/// A person of a height (m) and mass (kg): 21 links, 66 degrees of freedom, x left, y up, z forward.
///
/// >>> import solaris
/// >>> ann = solaris.human(1.65, 58.0)
/// >>> ann.nv, round(ann.mass, 9)
/// (66, 58.0)
///
/// `age` (years) below 18 has a child's proportions. `heading_first` makes the root turn by its heading first, which walks
/// that turn round and `Walker` need. Without a mass it is 23.8 times the squared height. `load` is what hands carry (kg),
/// which comes on top of the mass:
///
/// >>> round(solaris.human(1.65, 58.0, load={"right": 6.0}).mass, 9)
/// 64.0
///
/// `shorter_leg` is by how much a leg is shorter (m): `{"left": 0.02}`. `cane`, `"left"` or `"right"`, is the hand that holds a cane.
#[pyfunction]
#[pyo3(signature = (height=1.75, mass=None, *, age=None, heading_first=false, load=None, shorter_leg=None, cane=None))]
pub(crate) fn human(
    height: f64,
    mass: Option<f64>,
    age: Option<f64>,
    heading_first: bool,
    load: Option<BTreeMap<String, f64>>,
    shorter_leg: Option<BTreeMap<String, f64>>,
    cane: Option<String>,
) -> PyResult<Figure> {
    let mass = mass.unwrap_or(BODY_MASS_INDEX * height * height);
    let root = if heading_first { RootOrder::Yzx } else { RootOrder::Zyx };
    let human = Human::new(height, mass).root(root);
    let human = age.map_or_else(|| human.clone(), |age| human.clone().age(age));
    let human = load.into_iter().flatten().fold(human, |human, (hand, load)| human.load(hand, load));
    let human = shorter_leg.into_iter().flatten().fold(human, |human, (leg, by)| human.shorter_leg(leg, by));
    let human = cane.map_or_else(|| human.clone(), |hand| human.clone().cane(hand));
    let figure = human.build().map_err(errors::human)?;
    Ok(Figure::own(figure))
}

/// Reads a figure from a file: `.ron`, `.urdf`, `.sdf`, `.world`, `.xml` or `.mjcf` (MuJoCo), `.osim` (OpenSim), `.bvh`.
///
/// Other files that it names are read in its folder, or in `files`, which holds it, and nowhere else. Raises `FigureError`
/// with every fault and its place, and `FileError` where there is nothing to read.
#[pyfunction]
#[pyo3(signature = (path, *, files=None))]
pub(crate) fn read_figure(py: Python<'_>, path: PathBuf, files: Option<PathBuf>) -> PyResult<Figure> {
    let body = py.detach(|| files::body_in(&path, files.as_deref())).map_err(errors::file("FigureError"))?;
    Ok(Figure { body: Arc::new(body) })
}

#[pymethods]
impl Figure {
    /// Reads a figure from a text: Solaris' own (`"ron"`), `"urdf"`, `"mjcf"`, `"osim"` or `"sdf"`.
    #[staticmethod]
    #[pyo3(signature = (source, format="ron"))]
    fn from_text(py: Python<'_>, source: &str, format: &str) -> PyResult<Self> {
        py.detach(|| Self::of_text(source, format))
    }

    /// Its text, which `Figure.from_text` reads back.
    fn to_text(&self) -> String {
        text::write(self.figure())
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        self.figure().name()
    }

    /// What it was written in, such as `"URDF"`.
    #[getter]
    fn language(&self) -> &'static str {
        self.body.language.name()
    }

    /// Total mass (kg).
    #[getter]
    fn mass(&self) -> f64 {
        self.figure().mass()
    }

    /// Length of a configuration `q`.
    #[getter]
    fn nq(&self) -> usize {
        self.figure().layout().nq()
    }

    /// Number of degrees of freedom: length of `v`, `a` and `tau`.
    #[getter]
    fn nv(&self) -> usize {
        self.figure().layout().nv()
    }

    /// Names of the links, the root first.
    #[getter]
    fn links(&self) -> Vec<&str> {
        self.figure().links().iter().map(model::Link::name).collect()
    }

    /// Names of the named frames (and markers) of its links.
    #[getter]
    fn frames(&self) -> Vec<String> {
        let figure = self.body.marked();
        figure.links().iter().flat_map(model::Link::frames).map(|frame| frame.name.clone()).collect()
    }

    /// Index of each link's parent; -1 of the root's.
    #[getter]
    fn parents(&self) -> Vec<isize> {
        let parent = |link: &model::Link| link.parent().map_or(-1, usize::cast_signed);
        self.figure().links().iter().map(parent).collect()
    }

    /// Name of each link's joint.
    #[getter]
    fn joints(&self) -> Vec<&str> {
        self.figure().links().iter().map(|link| link.joint().name()).collect()
    }

    /// Mass of each link (kg).
    #[getter]
    fn masses<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.figure().links().iter().map(model::Link::mass).collect())
    }

    /// Centre of mass of each link in its own frame (m), `(links, 3)`.
    #[getter]
    fn coms<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let links = self.figure().links();
        let numbers: Vec<f64> = links.iter().flat_map(|link| <[f64; 3]>::from(*link.com())).collect();
        PyArray1::from_vec(py, numbers).reshape([links.len(), 3])
    }

    /// Inertia tensor of each link about its centre of mass, along its own axes (kg m²), `(links, 3, 3)`.
    #[getter]
    fn inertias<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let links = self.figure().links();
        // Symmetric: rows are columns.
        let numbers: Vec<f64> = links.iter().flat_map(|link| link.inertia().iter().copied()).collect();
        Ok(PyArray1::from_vec(py, numbers).reshape([links.len(), 3, 3])?.into_any())
    }

    /// Names of the entries of `q`.
    #[getter]
    fn q_names(&self) -> Vec<&str> {
        self.figure().layout().q_names().iter().map(String::as_str).collect()
    }

    /// Names of the entries of `v`, `a` and `tau`.
    #[getter]
    fn v_names(&self) -> Vec<&str> {
        self.figure().layout().v_names().iter().map(String::as_str).collect()
    }

    /// Acceleration of gravity (m/s²): the file's, or (0, -9.80665, 0).
    #[getter]
    fn gravity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.body.gravity.as_slice())
    }

    /// What its reader had to say: what was left out, guessed or looks wrong.
    #[getter]
    fn findings(&self) -> Vec<String> {
        self.body.findings.iter().map(ToString::to_string).collect()
    }

    /// A configuration, velocities and accelerations with the degrees of freedom that follow others where their leaders put them: copies
    /// of what is given. Without velocities or accelerations these are zero.
    ///
    /// >>> import solaris
    /// >>> subject = solaris.read_figure("fixtures/subject/subject.osim")
    /// >>> q = subject.neutral()
    /// >>> q[subject.q_names.index("knee_angle_r")] = -1.0
    /// >>> q, v, a = subject.follow(q)
    #[pyo3(signature = (q, v=None, a=None))]
    fn follow<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: Option<&Bound<'py, PyAny>>,
        a: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<[Bound<'py, PyArray1<f64>>; 3]> {
        let nv = self.nv();
        let mut q = vector("q", q, self.nq())?;
        let rates = |name, given: Option<&Bound<'py, PyAny>>| {
            given.map_or_else(|| Ok(vec![0.0; nv]), |given| vector(name, given, nv))
        };
        let (mut v, mut a) = (rates("v", v)?, rates("a", a)?);
        self.figure().follow(&mut q, &mut v, &mut a);
        Ok([q, v, a].map(|numbers| PyArray1::from_vec(py, numbers)))
    }

    /// Generalized forces with those of followers passed on to their leaders, which then have what moves both: a copy.
    fn fold_forces<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        tau: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (q, mut tau) = (vector("q", q, self.nq())?, vector("tau", tau, self.nv())?);
        self.figure().fold_forces(&q, &mut tau);
        Ok(PyArray1::from_vec(py, tau))
    }

    /// The names of the degrees of freedom that follow others, each with the name of its leader.
    #[getter]
    fn followers(&self) -> BTreeMap<String, String> {
        let names = self.figure().layout().v_names();
        let followers = self.figure().followers().iter();
        followers.map(|follower| (names[follower.dof].clone(), names[follower.leader].clone())).collect()
    }

    /// A number that differs between figures that differ.
    #[getter]
    fn fingerprint(&self) -> u64 {
        self.figure().fingerprint()
    }

    /// Lower and upper limits of each degree of freedom (rad, m), `(2, nv)`; infinite where there is none.
    #[getter]
    fn limits<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let nv = self.nv();
        let mut limits = [vec![f64::NEG_INFINITY; nv], vec![f64::INFINITY; nv]].concat();
        for (link, joint) in self.figure().links().iter().zip(self.figure().layout().joints()) {
            for (axis, dof) in link.joint().kind().axes().iter().enumerate() {
                if let Some(range) = &dof.limits {
                    limits[joint.v + axis] = range.lower;
                    limits[nv + joint.v + axis] = range.upper;
                }
            }
        }
        PyArray1::from_vec(py, limits).reshape([2, nv])
    }

    /// The configuration in which every joint is at zero.
    fn neutral<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let mut q = vec![0.0; self.nq()];
        self.figure().neutral(&mut q).map_err(errors::value)?;
        Ok(PyArray1::from_vec(py, q))
    }

    /// `q` moved by `step` (a velocity times a time, `nv` a state): what `+` is where a joint has a quaternion.
    fn integrate<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        step: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (nq, nv) = (self.nq(), self.nv());
        let (q, step) = (States::of("q", q, nq)?, States::of("step", step, nv)?);
        step.check_rows("step", q.rows)?;
        let (from, by, figure) = (q.numbers(), step.numbers(), self.figure());
        let mut out = vec![0.0; from.len()];
        let done = py.detach(|| {
            let mut rows = out
                .chunks_exact_mut(nq.max(1))
                .zip(from.chunks_exact(nq.max(1)))
                .zip(by.chunks_exact(nv.max(1)));
            rows.try_for_each(|((out, from), by)| figure.integrate(from, by, out))
        });
        done.map_err(errors::value)?;
        shaped(py, out, q.rows, nq)
    }

    /// The step that leads from a configuration to another (`nv` a state): what `-` is where a joint has a quaternion.
    #[pyo3(signature = (start, end))]
    fn difference<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        end: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (nq, nv) = (self.nq(), self.nv());
        let (from, to) = (States::of("start", start, nq)?, States::of("end", end, nq)?);
        to.check_rows("end", from.rows)?;
        let (starts, ends, figure) = (from.numbers(), to.numbers(), self.figure());
        let mut out = vec![0.0; from.rows.unwrap_or(1) * nv];
        let done = py.detach(|| {
            let mut rows = out
                .chunks_exact_mut(nv.max(1))
                .zip(starts.chunks_exact(nq.max(1)))
                .zip(ends.chunks_exact(nq.max(1)));
            rows.try_for_each(|((out, start), end)| figure.difference(start, end, out))
        });
        done.map_err(errors::value)?;
        shaped(py, out, from.rows, nv)
    }

    /// The same figure under another gravity (m/s²).
    fn with_gravity(&self, gravity: &Bound<'_, PyAny>) -> PyResult<Self> {
        let gravity = fixed::<3>("gravity", gravity)?.into();
        let mut body = Body::clone(&self.body);
        body.figure = body.figure.with_gravity(gravity).map_err(errors::figure)?;
        body.gravity = gravity;
        Ok(Self { body: Arc::new(body) })
    }

    fn __repr__(&self) -> String {
        let figure = self.figure();
        format!(
            "<Figure '{}': {} links, {} degrees of freedom, {:.6} kg>",
            figure.name().escape_debug(),
            figure.links().len(),
            figure.layout().nv(),
            figure.mass()
        )
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().figure().fingerprint() == self.fingerprint())
    }

    fn __hash__(&self) -> u64 {
        self.fingerprint()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String, [f64; 3]))> {
        // Its text holds all of it but what its reader found.
        let make = py.import("solaris")?.getattr("_figure_of")?;
        Ok((make, (self.to_text(), self.body.gravity.into())))
    }
}

/// One vector of finite numbers.
fn vector(name: &str, given: &Bound<'_, PyAny>, width: usize) -> PyResult<Vec<f64>> {
    let array = contiguous(name, given)?;
    if *array.shape() != [width] {
        let found = shape(array.shape());
        return Err(errors::argument(name, format!("{name} has the shape {found}; it must be ({width},)")));
    }
    let numbers = array.as_slice().unwrap_or_default().to_vec();
    match numbers.iter().find(|x| !x.is_finite()) {
        Some(x) => Err(errors::argument(name, format!("{name} holds {x}; it must hold finite numbers"))),
        None => Ok(numbers),
    }
}
