//! The joint forces of a motion that is known, with what acts on it from outside.

use crate::loads::Loads;
use crate::peak::Peak;
use crate::prepared::{PreparedMotion, StateError, each};
use solaris_dynamics::{
    DynamicsError, Workspace, Wrench, add_passive_forces, forward_kinematics, inverse_dynamics,
};
use solaris_model::AxisKind;

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
///
/// With the feature `serde` its keys are `joints` and `residual`; the forces themselves are a table for other formats.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct InverseReport {
    /// Generalized forces (N m or N), `nv` a row, in the order of the figure.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub tau: Vec<f64>,
    /// Of each frame, the magnitude of what is missing: the force (N) and its moment about the root link's origin (N m).
    #[cfg_attr(feature = "serde", serde(skip))]
    pub residuals: Vec<[f64; 2]>,
    /// Of each degree of freedom, how great its force is; those of the root's joint are residuals where nothing in the
    /// world holds the root.
    #[cfg_attr(feature = "serde", serde(rename = "joints"))]
    pub dofs: Vec<DofLoad>,
    /// What is missing for the whole figure's balance of momentum: what acts through the root's joint.
    pub residual: Residual,
}

/// How great the force of a degree of freedom is.
///
/// With the feature `serde` its keys are `dof`, `unit`, `rms`, `greatest`, `at_s` and `root`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct DofLoad {
    /// The degree of freedom's name.
    pub dof: String,
    /// What its force is in: `N` where it slides, else `N m`.
    pub unit: &'static str,
    /// Root of the mean square (N m or N).
    pub rms: f64,
    /// Of greatest magnitude (N m or N), with its sign.
    pub greatest: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
    /// Whether it belongs to a [root that is free](solaris_model::Figure::root_is_free), so that its force is a residual.
    #[cfg_attr(feature = "serde", serde(rename = "root"))]
    pub is_residual: bool,
}

/// What must act on the whole figure besides gravity and the given forces, in magnitude.
///
/// Zero would say that motion, masses and measured forces agree; what is left over is the error of one of them. It is the whole wrench: of a root
/// that is held in a plane, or that slides and turns in fewer ways than six, what holds it there is in it too, which is no degree of freedom's force.
///
/// With the feature `serde` its keys are `force_rms_n`, `force_greatest_n`, `force_at_s`, and with `moment` and `nm` the same.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Residual {
    /// Root of the mean square of the force (N).
    #[cfg_attr(feature = "serde", serde(rename = "force_rms_n"))]
    pub force_rms: f64,
    /// Greatest force (N).
    #[cfg_attr(feature = "serde", serde(rename = "force_greatest_n"))]
    pub force: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "force_at_s"))]
    pub force_time: f64,
    /// Root of the mean square of the moment about the root link's origin (N m).
    #[cfg_attr(feature = "serde", serde(rename = "moment_rms_nm"))]
    pub moment_rms: f64,
    /// Greatest moment about the root link's origin (N m).
    #[cfg_attr(feature = "serde", serde(rename = "moment_greatest_nm"))]
    pub moment: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "moment_at_s"))]
    pub moment_time: f64,
}

/// Why there are no joint forces.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InverseError {
    /// The loads were prepared for another motion.
    #[error(
        "the loads are known at {found} times, the motion has {samples} samples; prepare them at its times"
    )]
    Loads {
        /// Times of the loads.
        found: usize,
        /// Samples of the motion.
        samples: usize,
    },
    /// A state that cannot be computed with.
    #[error("at {time} s: {source}")]
    State {
        /// When (s).
        time: f64,
        /// Why.
        source: DynamicsError,
    },
}

impl From<StateError> for InverseError {
    fn from(StateError { time, source }: StateError) -> Self {
        Self::State { time, source }
    }
}

/// The generalized forces that move a figure through its motion, with `loads` on its links.
///
/// What degrees of freedom that follow others would need is asked of their leaders ([`solaris_model::Figure::fold_forces`]), and
/// theirs is zero. Frames are independent of each other and solved on all cores where the feature `parallel` is on; the results
/// do not depend on it.
///
/// # Errors
///
/// Loads of another motion, and the first state that the kernel refuses.
///
/// # Examples
///
/// Held level, a pendulum of 2 kg at half a metre needs 2 · 9.81 · 0.5 N m:
///
/// ```
/// use solaris_analysis::{InverseOptions, Loads, PreparedMotion, differentiate, inverse_motion};
/// use solaris_model::{FigureBuilder, Joint, Known, LinkSpec, Motion, MotionInfo, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// let (time, q) = (vec![0.0, 0.1], vec![-std::f64::consts::FRAC_PI_2; 2]);
/// let info = MotionInfo::recorded(&figure, Vector3::new(0.0, -9.81, 0.0), &time);
/// let recorded = Motion::recorded(&figure, info, time, [q, vec![0.0; 2], vec![0.0; 2]], Known::none(1))?;
/// let motion = differentiate(&figure, &recorded, None)?.motion;
/// let report = inverse_motion(&PreparedMotion::new(&figure, &motion)?, &Loads::none(), InverseOptions::default())?;
/// assert!((report.tau[1] - -9.81).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "rnea")]
#[doc(alias = "id")]
pub fn inverse_motion(
    prepared: &PreparedMotion<'_>,
    loads: &Loads,
    options: InverseOptions<'_>,
) -> Result<InverseReport, InverseError> {
    let (nv, samples, time) = (prepared.tree.nv(), prepared.motion.len(), prepared.time());
    if let Some(found) = loads.samples().filter(|found| *found != samples) {
        return Err(InverseError::Loads { found, samples });
    }
    let scene = Scene { prepared, loads, passive: options.passive };
    let mut report = InverseReport { tau: Vec::with_capacity(samples * nv), ..InverseReport::default() };
    let mut wrenches = Vec::with_capacity(samples);
    let mut progress = options.progress;
    for start in (0..samples).step_by(CHUNK) {
        let end = samples.min(start + CHUNK);
        let frames = each(start..end, || scene.scratch(), |scratch, row| scene.frame(scratch, row))?;
        for frame in frames {
            report.tau.extend(frame.tau);
            wrenches.push([frame.force, frame.moment]);
        }
        if let Some(progress) = &mut progress {
            progress(end);
        }
    }
    let column = |dof: usize| report.tau.iter().skip(dof).step_by(nv.max(1)).copied();
    let layout = prepared.figure.layout();
    let root = if prepared.figure.root_is_free() { layout.joints()[0].nv } else { 0 };
    let load = |dof: usize| {
        let (rms, greatest) = extent(time, column(dof));
        DofLoad {
            dof: layout.v_names()[dof].clone(),
            unit: if layout.axis_kind(dof) == AxisKind::Translation { "N" } else { "N m" },
            rms,
            greatest: greatest.value,
            time: greatest.time,
            is_residual: dof < root,
        }
    };
    report.dofs = (0..nv).map(load).collect();
    let [force, moment] = [0, 1].map(|part| extent(time, wrenches.iter().map(|wrench| wrench[part])));
    report.residual = Residual {
        force_rms: force.0,
        force: force.1.value,
        force_time: force.1.time,
        moment_rms: moment.0,
        moment: moment.1.value,
        moment_time: moment.1.time,
    };
    report.residuals = wrenches;
    Ok(report)
}

/// Root mean square and greatest of a column.
fn extent(time: &[f64], column: impl Iterator<Item = f64>) -> (f64, Peak) {
    let (mut squares, mut greatest) = (0.0, Peak::default());
    for (value, &time) in column.zip(time) {
        squares += value * value;
        if value.abs() > greatest.value.abs() {
            greatest = Peak { value, time };
        }
    }
    ((squares / time.len().max(1) as f64).sqrt(), greatest)
}

/// The forces of one frame.
struct Frame {
    tau: Vec<f64>,
    /// Magnitude of the residual force (N) and of its moment about the root link's origin (N m).
    force: f64,
    moment: f64,
}

/// What all frames share.
struct Scene<'a> {
    prepared: &'a PreparedMotion<'a>,
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
        Scratch { workspace: Workspace::new(&self.prepared.tree), external: Vec::new() }
    }

    fn frame(&self, scratch: &mut Scratch, row: usize) -> Result<Frame, StateError> {
        self.solve(scratch, row).map_err(|source| StateError { time: self.prepared.time()[row], source })
    }

    fn solve(&self, scratch: &mut Scratch, row: usize) -> Result<Frame, DynamicsError> {
        let Scratch { workspace, external } = scratch;
        let PreparedMotion { figure, tree, .. } = self.prepared;
        let (q, v, a) = (self.prepared.q(row), self.prepared.v(row), self.prepared.a(row));
        let mut tau = vec![0.0; tree.nv()];
        if self.loads.move_over_links() {
            forward_kinematics(tree, workspace, q)?;
        }
        self.loads.wrenches(workspace, row, external);
        inverse_dynamics(tree, workspace, q, v, a, external, &mut tau)?;
        let base = workspace.base_wrench();
        if external.is_empty() {
            // The links are placed only where something acts on them.
            forward_kinematics(tree, workspace, q)?;
        }
        let origin = workspace.pose(0).translation;
        let moment = base.moment_about(&origin).norm();
        if self.passive {
            add_passive_forces(figure, q, v, &mut tau);
        } else {
            self.take_armature_out(a, &mut tau);
        }
        figure.fold_forces(q, &mut tau);
        Ok(Frame { tau, force: base.force.norm(), moment })
    }

    /// Armature adds `armature·a` to each force and does nothing else.
    fn take_armature_out(&self, a: &[f64], tau: &mut [f64]) {
        let figure = self.prepared.figure;
        for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
            for i in 0..at.nv {
                tau[at.v + i] -= link.joint().kind().armature(i) * a[at.v + i];
            }
        }
    }
}
