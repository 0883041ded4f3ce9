//! The joint forces of a motion that is known, with what acts on it from outside.

use crate::differentiate::Completed;
use crate::loads::{LoadError, Loads};
use nalgebra::Vector3;
use solaris_dynamics::{
    DynamicsError, Tree, Workspace, Wrench, add_passive_forces, forward_kinematics, inverse_dynamics,
};
use solaris_model::{Figure, ForceRecord};

/// Frames between two reports of progress; enough to keep all cores busy.
const CHUNK: usize = 2048;

/// How inverse dynamics is to be done.
#[derive(Default)]
pub struct InverseOptions<'a> {
    /// Whether armature, springs, dampers and friction of the joints take part.
    pub passive: bool,
    /// Called now and then with the number of frames done.
    pub progress: Option<&'a mut dyn FnMut(usize)>,
}

/// The joint forces of a motion, and what they are like.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InverseReport {
    /// Generalized forces (N m or N), `nv` a row, in the order of the figure.
    pub tau: Vec<f64>,
    /// Of each degree of freedom, how great its force is; those of the root's joint are residuals where nothing in the
    /// world holds the root.
    pub dofs: Vec<DofLoad>,
    /// What is missing for the whole figure's balance of momentum: what acts through the root's joint.
    pub residual: Residual,
}

/// How great the force of a degree of freedom is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DofLoad {
    /// Root of the mean square (N m or N).
    pub rms: f64,
    /// Of greatest magnitude (N m or N), with its sign.
    pub greatest: f64,
    /// When (s).
    pub time: f64,
}

/// What must act on the whole figure besides gravity and the given forces, in magnitude.
///
/// Zero would say that motion, masses and measured forces agree; what is left over is the error of one of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residual {
    /// Root of the mean square of the force (N).
    pub force_rms: f64,
    /// Greatest force (N).
    pub force: f64,
    /// When (s).
    pub force_time: f64,
    /// Root of the mean square of the moment about the root link's origin (N m).
    pub moment_rms: f64,
    /// Greatest moment about the root link's origin (N m).
    pub moment: f64,
    /// When (s).
    pub moment_time: f64,
}

/// Why there are no joint forces.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InverseError {
    /// The motion is not one of this figure.
    #[error("{what} of the motion has {found} numbers; {rows} rows of figure '{figure}' have {expected}")]
    Length {
        /// Which column.
        what: &'static str,
        /// Numbers that it has.
        found: usize,
        /// Rows of the motion.
        rows: usize,
        /// The figure.
        figure: String,
        /// Numbers that it must have.
        expected: usize,
    },
    /// The forces do not fit the motion.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The figure or its gravity cannot be computed with.
    #[error(transparent)]
    Tree(DynamicsError),
    /// A state that cannot be computed with.
    #[error("at {time} s: {source}")]
    State {
        /// When (s).
        time: f64,
        /// Why.
        source: DynamicsError,
    },
}

/// The generalized forces that move `figure` through `motion` under `gravity` (m/s², world axes), with `loads` on its
/// links.
///
/// What degrees of freedom that follow others would need is asked of their leaders ([`Figure::fold_forces`]), and theirs
/// is zero. Frames are independent of each other and solved on all cores where the feature `parallel` is on; the results
/// do not depend on it.
///
/// # Errors
///
/// A motion that does not fit the figure, loads that do not fit the motion ([`Loads::at_times`]), and the first state
/// that the kernel refuses.
///
/// # Examples
///
/// Held level, a pendulum of 2 kg at half a metre needs 2 · 9.81 · 0.5 N m:
///
/// ```
/// use solaris_analysis::{InverseOptions, complete, inverse_motion};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Record, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// let q = vec![-std::f64::consts::FRAC_PI_2; 2];
/// let record = Record { time: vec![0.0, 0.1], q, v: vec![0.0; 2], a: vec![0.0; 2], known_v: vec![false], known_a: vec![false] };
/// let motion = complete(&figure, &record, None)?;
/// let gravity = Vector3::new(0.0, -9.81, 0.0);
/// let report = inverse_motion(&figure, gravity, &motion, &[], InverseOptions::default())?;
/// assert!((report.tau[1] - -9.81).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn inverse_motion(
    figure: &Figure,
    gravity: Vector3<f64>,
    motion: &Completed,
    loads: &[ForceRecord],
    options: InverseOptions<'_>,
) -> Result<InverseReport, InverseError> {
    let (nq, nv, rows) = (figure.layout().nq(), figure.layout().nv(), motion.time.len());
    let lengths = [("q", motion.q.len(), nq), ("v", motion.v.len(), nv), ("a", motion.a.len(), nv)];
    if let Some((what, found, width)) = lengths.into_iter().find(|(_, found, width)| *found != rows * width) {
        let (figure, expected) = (figure.name().to_owned(), rows * width);
        return Err(InverseError::Length { what, found, rows, figure, expected });
    }
    let tree = Tree::<f64>::new(figure, gravity).map_err(InverseError::Tree)?;
    let loads = Loads::at_times(figure, loads, &motion.time)?;
    let scene = Scene { figure, tree: &tree, motion, loads: &loads, passive: options.passive };
    let mut report = InverseReport { tau: Vec::with_capacity(rows * nv), ..InverseReport::default() };
    let mut wrenches = Vec::with_capacity(rows);
    let mut progress = options.progress;
    for start in (0..rows).step_by(CHUNK) {
        let end = rows.min(start + CHUNK);
        for (frame, &time) in scene.solve(start..end).into_iter().zip(&motion.time[start..end]) {
            let frame = frame.map_err(|source| InverseError::State { time, source })?;
            report.tau.extend(frame.tau);
            wrenches.push([frame.force, frame.moment]);
        }
        if let Some(progress) = &mut progress {
            progress(end);
        }
    }
    let column = |dof: usize| report.tau.iter().skip(dof).step_by(nv.max(1)).copied();
    report.dofs = (0..nv).map(|dof| extent(&motion.time, column(dof))).collect();
    let [force, moment] = [0, 1].map(|part| extent(&motion.time, wrenches.iter().map(|wrench| wrench[part])));
    report.residual = Residual {
        force_rms: force.rms,
        force: force.greatest,
        force_time: force.time,
        moment_rms: moment.rms,
        moment: moment.greatest,
        moment_time: moment.time,
    };
    Ok(report)
}

/// Root mean square and greatest of a column.
fn extent(time: &[f64], column: impl Iterator<Item = f64>) -> DofLoad {
    let mut load = DofLoad::default();
    let mut squares = 0.0;
    for (value, &time) in column.zip(time) {
        squares += value * value;
        if value.abs() > load.greatest.abs() {
            (load.greatest, load.time) = (value, time);
        }
    }
    load.rms = (squares / time.len().max(1) as f64).sqrt();
    load
}

/// What one frame came to.
struct Frame {
    tau: Vec<f64>,
    /// Magnitude of the residual force (N) and of its moment about the root link's origin (N m).
    force: f64,
    moment: f64,
}

/// What all frames share.
struct Scene<'a> {
    figure: &'a Figure,
    tree: &'a Tree<f64>,
    motion: &'a Completed,
    loads: &'a Loads,
    passive: bool,
}

/// What a core needs for itself.
struct Scratch {
    workspace: Workspace<f64>,
    external: Vec<(usize, Wrench<f64>)>,
}

impl Scene<'_> {
    fn scratch(&self) -> Scratch {
        Scratch { workspace: Workspace::new(self.tree), external: Vec::new() }
    }

    #[cfg(feature = "parallel")]
    fn solve(&self, rows: std::ops::Range<usize>) -> Vec<Result<Frame, DynamicsError>> {
        use rayon::prelude::*;
        rows.into_par_iter().map_init(|| self.scratch(), |scratch, row| self.frame(scratch, row)).collect()
    }

    #[cfg(not(feature = "parallel"))]
    fn solve(&self, rows: std::ops::Range<usize>) -> Vec<Result<Frame, DynamicsError>> {
        let mut scratch = self.scratch();
        rows.map(|row| self.frame(&mut scratch, row)).collect()
    }

    fn frame(&self, scratch: &mut Scratch, row: usize) -> Result<Frame, DynamicsError> {
        let Scratch { workspace, external } = scratch;
        let (nq, nv) = (self.tree.nq(), self.tree.nv());
        let q = &self.motion.q[row * nq..][..nq];
        let [v, a] = [&self.motion.v, &self.motion.a].map(|column| &column[row * nv..][..nv]);
        let mut tau = vec![0.0; nv];
        if self.loads.move_over_links() {
            forward_kinematics(self.tree, workspace, q)?;
        }
        self.loads.wrenches(workspace, row, external);
        inverse_dynamics(self.tree, workspace, q, v, a, external, &mut tau)?;
        let base = workspace.base_wrench();
        if external.is_empty() {
            // The links are placed only where something acts on them.
            forward_kinematics(self.tree, workspace, q)?;
        }
        let origin = workspace.pose(0).translation;
        let moment = base.moment_about(&origin).norm();
        if self.passive {
            add_passive_forces(self.figure, q, v, &mut tau);
        } else {
            self.take_armature_out(a, &mut tau);
        }
        self.figure.fold_forces(q, &mut tau);
        Ok(Frame { tau, force: base.force.norm(), moment })
    }

    /// Armature adds `armature·a` to each force and does nothing else.
    fn take_armature_out(&self, a: &[f64], tau: &mut [f64]) {
        for (link, at) in self.figure.links().iter().zip(self.figure.layout().joints()) {
            for i in 0..at.nv {
                tau[at.v + i] -= link.joint().kind().armature(i) * a[at.v + i];
            }
        }
    }
}
