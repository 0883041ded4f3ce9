//! The kernel: dynamics, matrices and derivatives of one state, or of many at once.

use crate::arrays::{States, contiguous, count, fixed, matrix, shape, shaped};
use crate::errors::{self, argument, value};
use crate::figure::Figure;
use numpy::{PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use pyo3::types::PyDict;
use solaris::dynamics::batch::{Batch, BatchPartials};
use solaris::dynamics::{
    self as kernel, DMatrix, Derivatives, Frame, JacobianAxes, Partials, Tree, Workspace, Wrench,
};
use solaris::model::{self, Vector3};
use std::sync::Mutex;

/// The dynamics of a figure under gravity.
///
/// Arguments are `q` (rad, m; `nq` numbers), `v`, `a` and `tau` (`nv`), of one state, or of many states in rows, which are
/// solved together: with `threads`, on so many cores (0: all). `external` is a dictionary of link names to wrenches
/// `[fx, fy, fz, mx, my, mz]` (N, N m; world axes, about the world's origin), one, or one a row.
///
/// >>> import numpy as np, solaris
/// >>> human = solaris.human(1.75, 73.0)
/// >>> dynamics = solaris.Dynamics(human)
/// >>> still = np.zeros(human.nv)
/// >>> tau = dynamics.inverse(human.neutral(), still, still)
/// >>> round(float(tau[1]) / (73.0 * 9.80665), 9)  # the root carries the weight
/// 1.0
///
/// It keeps scratch memory; calls from several threads wait for each other. One object a thread does not wait.
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Dynamics {
    figure: model::Figure,
    tree: Tree<f64>,
    gravity: Vector3<f64>,
    threads: usize,
    scratch: Mutex<Scratch>,
}

/// What is written to.
struct Scratch {
    workspace: Workspace<f64>,
    batch: Option<Batch<f64>>,
    derivatives: Option<Box<Derivatives>>,
    external: Vec<(usize, Wrench<f64>)>,
}

/// Wrenches on one link, of one state or of each.
type Tracks = Vec<(usize, Vec<Wrench<f64>>)>;

fn wrench(six: &[f64]) -> Wrench<f64> {
    let [force, moment] = [0, 3].map(|at| Vector3::new(six[at], six[at + 1], six[at + 2]));
    Wrench { force, moment }
}

impl Dynamics {
    fn link(&self, name: &str) -> PyResult<usize> {
        self.figure.link_index(name).ok_or_else(|| {
            let names = self.figure.links().iter().map(model::Link::name);
            let hint = model::nearest(name, names)
                .map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
            errors::no_link(name, &format!("the figure has no link called '{name}'{hint}"))
        })
    }

    fn tracks(&self, external: Option<&Bound<'_, PyDict>>, rows: Option<usize>) -> PyResult<Tracks> {
        let Some(external) = external else { return Ok(Vec::new()) };
        let mut tracks = Vec::with_capacity(external.len());
        for (name, wrenches) in external {
            let name: String = name.extract()?;
            let given = contiguous(&format!("external['{name}']"), &wrenches)?;
            let numbers = given.as_slice().unwrap_or_default();
            let states = rows.unwrap_or(1);
            let of_states = match *given.shape() {
                [6] => vec![wrench(numbers); states],
                [found, 6] if Some(found) == rows => numbers.chunks_exact(6).map(wrench).collect(),
                ref found => {
                    let (argued, shape) = (format!("external['{name}']"), shape(found));
                    return Err(argument(
                        &argued,
                        format!("{argued} has the shape {shape}; it must be (6,), or (states, 6)"),
                    ));
                }
            };
            tracks.push((self.link(&name)?, of_states));
        }
        Ok(tracks)
    }

    /// `operation` of one state, or its batch of many; the result goes to `out`, or to a new array.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        [q, v, given]: [&Bound<'py, PyAny>; 3],
        (third, result): (&'static str, &'static str),
        external: Option<&Bound<'py, PyDict>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (nq, nv) = (self.tree.nq(), self.tree.nv());
        let q = States::of("q", q, nq)?;
        let (v, given) = (States::of("v", v, nv)?, States::of(third, given, nv)?);
        v.check_rows("v", q.rows)?;
        given.check_rows(third, q.rows)?;
        let tracks = self.tracks(external, q.rows)?;
        let inverse = result == "tau";
        let (rows, q, v, given) = (q.rows, q.numbers(), v.numbers(), given.numbers());
        let run = |out: &mut [f64]| {
            if rows.is_none() {
                let mut scratch = self.lock(py);
                let Scratch { workspace, external, .. } = &mut *scratch;
                external.clear();
                external.extend(tracks.iter().map(|(link, of_states)| (*link, of_states[0])));
                let solve = if inverse { kernel::inverse_dynamics } else { kernel::forward_dynamics };
                let solved = self.compute(py, || solve(&self.tree, workspace, q, v, given, external, out));
                return solved.map_err(errors::dynamics);
            }
            let external: Vec<(usize, &[Wrench<f64>])> =
                tracks.iter().map(|(link, wrenches)| (*link, wrenches.as_slice())).collect();
            let solved = py.detach(|| {
                let mut scratch = self.wait();
                let batch = self.batch(&mut scratch)?;
                if inverse {
                    batch.inverse_dynamics(q, v, given, &external, out)
                } else {
                    batch.forward_dynamics(q, v, given, &external, out)
                }
            });
            solved.map_err(errors::batch)
        };
        if let Some(out) = out {
            let array = out
                .cast::<PyArrayDyn<f64>>()
                .map_err(|_| argument("out", "out must be an array of float64"))?;
            let expected = rows.map_or_else(|| vec![nv], |rows| vec![rows, nv]);
            if *array.shape() != *expected || !array.is_c_contiguous() {
                let (found, expected) = (shape(array.shape()), shape(&expected));
                return Err(argument(
                    "out",
                    format!("out has the shape {found}; it must be {expected}, in C order"),
                ));
            }
            let mut writing = array
                .try_readwrite()
                .map_err(|_| argument("out", "out overlaps an argument, or cannot be written"))?;
            run(writing.as_slice_mut().map_err(value)?)?;
            return Ok(out.clone());
        }
        let mut found = vec![0.0; nv * rows.unwrap_or(1)];
        run(&mut found)?;
        shaped(py, found, rows, nv)
    }

    /// The scratch memory, waited for without holding up Python.
    fn lock(&self, py: Python<'_>) -> std::sync::MutexGuard<'_, Scratch> {
        self.scratch.lock_py_attached(py).unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    /// The same where Python is let go already.
    fn wait(&self) -> std::sync::MutexGuard<'_, Scratch> {
        self.scratch.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn batch<'a>(
        &self,
        scratch: &'a mut Scratch,
    ) -> Result<&'a mut Batch<f64>, solaris::dynamics::batch::BatchError> {
        if scratch.batch.is_none() {
            let batch = Batch::new(&self.figure, self.gravity)
                .map_err(solaris::dynamics::batch::BatchError::Figure)?;
            scratch.batch = Some(batch.threads(self.threads));
        }
        Ok(scratch.batch.as_mut().expect("it was made"))
    }

    /// Computes, without Python where that takes longer than to let go of it.
    fn compute<R: Send>(&self, py: Python<'_>, run: impl FnOnce() -> R + Send) -> R {
        if self.tree.nv() > SMALL { py.detach(run) } else { run() }
    }

    /// What one state gives, `q` alone asked for.
    fn at<'py, R: Send>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        run: impl FnOnce(&Tree<f64>, &mut Workspace<f64>, &[f64]) -> Result<R, kernel::DynamicsError> + Send,
    ) -> PyResult<R> {
        let q = States::of("q", q, self.tree.nq())?;
        one(&q)?;
        let (q, mut scratch) = (q.numbers(), self.lock(py));
        let workspace = &mut scratch.workspace;
        self.compute(py, || run(&self.tree, workspace, q)).map_err(errors::dynamics)
    }

    /// What one state gives, with its velocity.
    fn moving<'py, R: Send>(
        &self,
        py: Python<'py>,
        [q, v]: [&Bound<'py, PyAny>; 2],
        run: impl FnOnce(&Tree<f64>, &mut Workspace<f64>, [&[f64]; 2]) -> Result<R, kernel::DynamicsError> + Send,
    ) -> PyResult<R> {
        let (q, v) = (States::of("q", q, self.tree.nq())?, States::of("v", v, self.tree.nv())?);
        one(&q)?;
        v.check_rows("v", None)?;
        let (states, mut scratch) = ([q.numbers(), v.numbers()], self.lock(py));
        let workspace = &mut scratch.workspace;
        self.compute(py, || run(&self.tree, workspace, states)).map_err(errors::dynamics)
    }

    fn square(&self) -> DMatrix<f64> {
        DMatrix::zeros(self.tree.nv(), self.tree.nv())
    }

    /// A frame or link of this name, at a point of it (m) where one is given.
    fn frame(&self, name: &str, point: Option<&Bound<'_, PyAny>>) -> PyResult<Frame<f64>> {
        let mut frame = Frame::named(&self.figure, name).map_err(errors::dynamics)?;
        if let Some(point) = point {
            let point: Vector3<f64> = fixed::<3>("point", point)?.into();
            frame.placement.translation += frame.placement.rotation * point;
        }
        Ok(frame)
    }
}

/// Up to so many degrees of freedom the kernel takes microseconds.
const SMALL: usize = 100;

fn one(q: &States<'_>) -> PyResult<()> {
    match q.rows {
        None => Ok(()),
        Some(_) => Err(argument("q", "this takes one state at a time: give q as a vector")),
    }
}

fn axes(name: &str) -> PyResult<JacobianAxes> {
    match name {
        "world" => Ok(JacobianAxes::World),
        "frame" => Ok(JacobianAxes::Frame),
        other => Err(argument("axes", format!("axes is '{other}'; it must be 'world' or 'frame'"))),
    }
}

/// An output with its derivatives, as a dictionary would say it: value, by q, by v, by the input.
fn partials<'py>(py: Python<'py>, found: &Partials) -> PyResult<[Bound<'py, PyAny>; 4]> {
    Ok([
        PyArray1::from_slice(py, &found.value).into_any(),
        matrix(py, &found.by_q)?.into_any(),
        matrix(py, &found.by_v)?.into_any(),
        matrix(py, &found.by_input)?.into_any(),
    ])
}

/// A pose as a 4 × 4 matrix, row by row.
fn homogeneous(pose: &kernel::Pose<f64>) -> [f64; 16] {
    let (r, p) = (&pose.rotation, &pose.translation);
    let row = |i: usize| [r[(i, 0)], r[(i, 1)], r[(i, 2)], p[i]];
    let rows = [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]];
    std::array::from_fn(|i| rows[i / 4][i % 4])
}

#[pymethods]
impl Dynamics {
    #[new]
    #[pyo3(signature = (figure, gravity=None, *, threads=1))]
    fn new(figure: &Figure, gravity: Option<&Bound<'_, PyAny>>, threads: i64) -> PyResult<Self> {
        let threads = count("threads", threads)?;
        let gravity = match gravity {
            Some(given) => fixed::<3>("gravity", given)?.into(),
            None => figure.body.gravity,
        };
        let figure = figure.body.marked();
        let tree = Tree::new(&figure, gravity).map_err(errors::dynamics)?;
        let workspace = Workspace::new(&tree);
        let scratch = Scratch { workspace, batch: None, derivatives: None, external: Vec::new() };
        Ok(Self { figure, tree, gravity, threads, scratch: Mutex::new(scratch) })
    }

    /// Length of `q`.
    #[getter]
    fn nq(&self) -> usize {
        self.tree.nq()
    }

    /// Length of `v`, `a` and `tau`.
    #[getter]
    fn nv(&self) -> usize {
        self.tree.nv()
    }

    /// Inverse dynamics: the generalized forces `tau` (N m, N) of a motion.
    #[pyo3(signature = (q, v, a, external=None, *, out=None))]
    fn inverse<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        a: &Bound<'py, PyAny>,
        external: Option<&Bound<'py, PyDict>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.solve(py, [q, v, a], ("a", "tau"), external, out)
    }

    /// Forward dynamics: the accelerations `a` that forces bring about.
    #[pyo3(signature = (q, v, tau, external=None, *, out=None))]
    fn forward<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        tau: &Bound<'py, PyAny>,
        external: Option<&Bound<'py, PyDict>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.solve(py, [q, v, tau], ("tau", "a"), external, out)
    }

    /// The mass matrix, `(nv, nv)`.
    fn mass_matrix<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut m = self.square();
        self.at(py, q, |tree, ws, q| kernel::mass_matrix(tree, ws, q, &mut m))?;
        matrix(py, &m)
    }

    /// Its inverse, `(nv, nv)`.
    fn inverse_mass_matrix<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut m = self.square();
        self.at(py, q, |tree, ws, q| kernel::inverse_mass_matrix(tree, ws, q, &mut m))?;
        matrix(py, &m)
    }

    /// The Coriolis matrix `C`, `(nv, nv)`: `C v` are the forces of velocity, and `dM/dt - 2C` is skew.
    fn coriolis_matrix<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut m = self.square();
        self.moving(py, [q, v], |tree, ws, [q, v]| kernel::coriolis_matrix(tree, ws, q, v, &mut m))?;
        matrix(py, &m)
    }

    /// The forces that hold the figure still against gravity.
    fn gravity_torques<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let mut tau = vec![0.0; self.tree.nv()];
        self.at(py, q, |tree, ws, q| kernel::gravity_torques(tree, ws, q, &mut tau))?;
        Ok(PyArray1::from_vec(py, tau))
    }

    /// The Jacobian of a link or frame, `(6, nv)`: linear rows, then angular ones, along `axes` `"world"` or `"frame"`.
    #[pyo3(signature = (q, frame, point=None, *, axes="world"))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        frame: &str,
        point: Option<&Bound<'py, PyAny>>,
        axes: &str,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (frame, axes) = (self.frame(frame, point)?, self::axes(axes)?);
        let mut j = DMatrix::zeros(6, self.tree.nv());
        self.at(py, q, |tree, ws, q| kernel::jacobian(tree, ws, q, &frame, axes, &mut j))?;
        matrix(py, &j)
    }

    /// Its rate, `(6, nv)`.
    #[pyo3(signature = (q, v, frame, point=None, *, axes="world"))]
    fn jacobian_rate<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        frame: &str,
        point: Option<&Bound<'py, PyAny>>,
        axes: &str,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (frame, axes) = (self.frame(frame, point)?, self::axes(axes)?);
        let mut j = DMatrix::zeros(6, self.tree.nv());
        self.moving(py, [q, v], |tree, ws, [q, v]| {
            kernel::jacobian_rate(tree, ws, q, v, &frame, axes, &mut j)
        })?;
        matrix(py, &j)
    }

    /// Where all links stand, `(links, 4, 4)` (m, world axes).
    fn poses<'py>(&self, py: Python<'py>, q: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let links = self.tree.link_count();
        let numbers: Vec<f64> = self.at(py, q, |tree, ws, q| {
            kernel::forward_kinematics(tree, ws, q)?;
            Ok((0..links).flat_map(|link| homogeneous(ws.pose(link))).collect())
        })?;
        Ok(PyArray1::from_vec(py, numbers).reshape([links, 4, 4])?.into_any())
    }

    /// Where a link or frame, or a point of it (m), stands, `(4, 4)`.
    #[pyo3(signature = (q, frame, point=None))]
    fn pose<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        frame: &str,
        point: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let frame = self.frame(frame, point)?;
        let pose = self.at(py, q, |tree, ws, q| {
            kernel::forward_kinematics(tree, ws, q)?;
            Ok(homogeneous(&frame.pose(ws)))
        })?;
        PyArray1::from_slice(py, &pose).reshape([4, 4])
    }

    /// Velocities of all links, `(links, 6)`: of their origins (m/s), then angular (rad/s), world axes.
    fn velocities<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let links = self.tree.link_count();
        let numbers: Vec<f64> = self.moving(py, [q, v], |tree, ws, [q, v]| {
            kernel::velocities(tree, ws, q, v)?;
            let six = |link: usize| {
                let twist = ws.velocity(link);
                twist.linear.iter().chain(twist.angular.iter()).copied().collect::<Vec<_>>()
            };
            Ok((0..links).flat_map(six).collect())
        })?;
        PyArray1::from_vec(py, numbers).reshape([links, 6])
    }

    /// Centre of mass (m).
    fn center_of_mass<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let com = self.at(py, q, kernel::center_of_mass)?;
        Ok(PyArray1::from_slice(py, com.as_slice()))
    }

    /// Momentum about the centre of mass: linear (kg m/s), then angular (kg m²/s).
    fn momentum<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let found =
            self.moving(py, [q, v], |tree, ws, [q, v]| kernel::centroidal_momentum(tree, ws, q, v))?;
        let six: Vec<f64> = found.linear.iter().chain(found.angular.iter()).copied().collect();
        Ok(PyArray1::from_vec(py, six))
    }

    /// Kinetic energy (J).
    fn kinetic_energy(&self, py: Python<'_>, q: &Bound<'_, PyAny>, v: &Bound<'_, PyAny>) -> PyResult<f64> {
        self.moving(py, [q, v], |tree, ws, [q, v]| kernel::kinetic_energy(tree, ws, q, v))
    }

    /// Potential energy of gravity (J), zero where the centre of mass is at the world's origin.
    fn potential_energy(&self, py: Python<'_>, q: &Bound<'_, PyAny>) -> PyResult<f64> {
        self.at(py, q, kernel::potential_energy)
    }

    /// Inverse dynamics with its derivatives: `(tau, by_q, by_v, by_a)`, the last three `(nv, nv)`; of many states each with
    /// a first axis more. `by_a` is the mass matrix.
    #[pyo3(signature = (q, v, a, external=None))]
    fn inverse_derivatives<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        a: &Bound<'py, PyAny>,
        external: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<[Bound<'py, PyAny>; 4]> {
        let (nq, nv) = (self.tree.nq(), self.tree.nv());
        let (q, v, a) = (States::of("q", q, nq)?, States::of("v", v, nv)?, States::of("a", a, nv)?);
        v.check_rows("v", q.rows)?;
        a.check_rows("a", q.rows)?;
        let tracks = self.tracks(external, q.rows)?;
        let (q_rows, q, v, a) = (q.rows, q.numbers(), v.numbers(), a.numbers());
        let Some(rows) = q_rows else {
            return self.derive(py, &tracks, |derivatives, external| {
                derivatives.inverse_dynamics(q, v, a, external)
            });
        };
        let external: Vec<(usize, &[Wrench<f64>])> =
            tracks.iter().map(|(link, wrenches)| (*link, wrenches.as_slice())).collect();
        let mut out = [vec![0.0; rows * nv], vec![], vec![], vec![]];
        out[1..].iter_mut().for_each(|block| block.resize(rows * nv * nv, 0.0));
        let [value, by_q, by_v, by_input] = &mut out;
        py.detach(|| {
            let mut scratch = self.wait();
            let mut partials = BatchPartials { value, by_q, by_v, by_input };
            self.batch(&mut scratch)?.inverse_dynamics_derivatives(q, v, a, &external, &mut partials)?;
            // Column by column in each state, row by row in Python.
            for block in [by_q, by_v, by_input] {
                block.chunks_exact_mut(nv * nv).for_each(|state| transpose(state, nv));
            }
            Ok(())
        })
        .map_err(errors::batch)?;
        let [value, by_q, by_v, by_input] = out;
        let cube = |numbers: Vec<f64>| -> PyResult<Bound<'py, PyAny>> {
            Ok(PyArray1::from_vec(py, numbers).reshape([rows, nv, nv])?.into_any())
        };
        Ok([shaped(py, value, Some(rows), nv)?, cube(by_q)?, cube(by_v)?, cube(by_input)?])
    }

    /// Forward dynamics with its derivatives, of one state: `(a, by_q, by_v, by_tau)`; `by_tau` is the inverse mass matrix.
    #[pyo3(signature = (q, v, tau, external=None))]
    fn forward_derivatives<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        tau: &Bound<'py, PyAny>,
        external: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<[Bound<'py, PyAny>; 4]> {
        let (nq, nv) = (self.tree.nq(), self.tree.nv());
        let (q, v, tau) = (States::of("q", q, nq)?, States::of("v", v, nv)?, States::of("tau", tau, nv)?);
        one(&q)?;
        v.check_rows("v", None)?;
        tau.check_rows("tau", None)?;
        let tracks = self.tracks(external, None)?;
        let (q, v, tau) = (q.numbers(), v.numbers(), tau.numbers());
        self.derive(py, &tracks, |derivatives, external| derivatives.forward_dynamics(q, v, tau, external))
    }

    fn __repr__(&self) -> String {
        let [x, y, z]: [f64; 3] = self.gravity.into();
        format!("<Dynamics of '{}' under gravity ({x}, {y}, {z})>", self.figure.name().escape_debug())
    }
}

impl Dynamics {
    fn derive<'py>(
        &self,
        py: Python<'py>,
        tracks: &Tracks,
        run: impl Send
        + for<'a> FnOnce(
            &'a mut Derivatives,
            &[(usize, Wrench<f64>)],
        ) -> Result<&'a Partials, kernel::DynamicsError>,
    ) -> PyResult<[Bound<'py, PyAny>; 4]> {
        let mut scratch = self.lock(py);
        let Scratch { derivatives, external, .. } = &mut *scratch;
        external.clear();
        external.extend(tracks.iter().map(|(link, of_states)| (*link, of_states[0])));
        if derivatives.is_none() {
            let made = Derivatives::new(&self.figure, self.gravity).map_err(errors::dynamics)?;
            *derivatives = Some(Box::new(made));
        }
        let derivatives = derivatives.as_mut().expect("they were made");
        let found = py.detach(|| run(derivatives, external)).map_err(errors::dynamics)?;
        partials(py, found)
    }
}

/// A square matrix of `n` rows, turned over in its place.
fn transpose(matrix: &mut [f64], n: usize) {
    for i in 0..n {
        for j in 0..i {
            matrix.swap(i * n + j, j * n + i);
        }
    }
}
