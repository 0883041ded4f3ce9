//! A motion of a figure, checked once, on which all questions are asked.

use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, Tree, Workspace};
use solaris_model::{Figure, Motion, MotionError};
use std::ops::Range;

/// A motion of a figure that is ready for questions: it is the figure's, velocities and accelerations are known, and the tree
/// of the figure under the motion's gravity is built.
///
/// [`crate::inverse_motion`] asks it, and everything in [`crate::ground`], most of it by way of feet that are placed in it
/// ([`crate::ground::PlacedFeet`]).
#[derive(Debug)]
pub struct PreparedMotion<'a> {
    pub(crate) figure: &'a Figure,
    pub(crate) motion: &'a Motion,
    pub(crate) tree: Tree<f64>,
    /// Against gravity, of length 1; zero without gravity.
    pub(crate) up: Vector3<f64>,
    /// The figure's weight (N).
    pub(crate) weight: f64,
    /// How often all frames were asked for something.
    #[cfg(test)]
    pub(crate) passes: std::sync::atomic::AtomicUsize,
}

/// Why a motion is not ready for questions.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PrepareError {
    /// The motion is of another figure.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// Velocities or accelerations are missing.
    #[error("the {what} of '{dof}' are not known; differentiate the motion first")]
    Unknown {
        /// Velocities or accelerations.
        what: &'static str,
        /// The first degree of freedom of which they are not.
        dof: String,
    },
    /// The figure or its gravity cannot be computed with.
    #[error(transparent)]
    Tree(#[from] DynamicsError),
}

/// A state that the kernel refuses.
pub(crate) struct StateError {
    pub(crate) time: f64,
    pub(crate) source: DynamicsError,
}

impl<'a> PreparedMotion<'a> {
    /// `motion` of `figure`, under its own gravity.
    ///
    /// # Errors
    ///
    /// A motion of another figure, velocities or accelerations that are not known ([`crate::differentiate`] finds them), a
    /// figure or gravity that the kernel refuses.
    pub fn new(figure: &'a Figure, motion: &'a Motion) -> Result<Self, PrepareError> {
        motion.check_figure(figure)?;
        for (what, known) in [("velocities", &motion.known().v), ("accelerations", &motion.known().a)] {
            if let Some(dof) = known.iter().position(|known| !known) {
                let dof = figure.layout().v_names()[dof].clone();
                return Err(PrepareError::Unknown { what, dof });
            }
        }
        let gravity = motion.info.gravity;
        let tree = Tree::<f64>::new(figure, gravity)?;
        let up = (-gravity).try_normalize(1e-9).unwrap_or_default();
        let weight = tree.mass() * gravity.norm();
        Ok(Self {
            figure,
            motion,
            tree,
            up,
            weight,
            #[cfg(test)]
            passes: 0.into(),
        })
    }

    /// The figure.
    pub fn figure(&self) -> &'a Figure {
        self.figure
    }

    /// The motion.
    pub fn motion(&self) -> &'a Motion {
        self.motion
    }

    /// The tree of the figure under the motion's gravity, as the kernel asks it.
    pub fn tree(&self) -> &Tree<f64> {
        &self.tree
    }

    /// The direction against gravity, of length 1; `None` without gravity.
    pub fn up(&self) -> Option<Vector3<f64>> {
        (self.up.norm_squared() > 0.0).then_some(self.up)
    }

    /// Times of the samples (s).
    pub(crate) fn time(&self) -> &'a [f64] {
        self.motion.time()
    }

    /// Positions of a sample.
    pub(crate) fn q(&self, row: usize) -> &'a [f64] {
        self.motion.q(row)
    }

    /// Velocities of a sample.
    pub(crate) fn v(&self, row: usize) -> &'a [f64] {
        self.motion.v(row)
    }

    /// Accelerations of a sample.
    pub(crate) fn a(&self, row: usize) -> &'a [f64] {
        self.motion.a(row)
    }

    /// What the kernel answers to `ask` in every sample, in order.
    pub(crate) fn frames<R: Send>(
        &self,
        ask: impl Fn(&mut Workspace<f64>, usize) -> Result<R, DynamicsError> + Sync,
    ) -> Result<Vec<R>, StateError> {
        #[cfg(test)]
        self.passes.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        let at = |workspace: &mut Workspace<f64>, row: usize| {
            ask(workspace, row).map_err(|source| StateError { time: self.time()[row], source })
        };
        each(0..self.motion.len(), || Workspace::new(&self.tree), at)
    }
}

/// What `ask` finds in each of these rows, in order; the first error in that order is the answer where there is one.
///
/// Rows are independent of each other and asked on all cores where the feature `parallel` is on, each core with a `scratch` of
/// its own; the results do not depend on it.
pub(crate) fn each<S, R: Send, E: Send>(
    rows: Range<usize>,
    scratch: impl Fn() -> S + Sync + Send,
    ask: impl Fn(&mut S, usize) -> Result<R, E> + Sync + Send,
) -> Result<Vec<R>, E> {
    #[cfg(feature = "parallel")]
    let found: Vec<Result<R, E>> = {
        use rayon::prelude::*;
        rows.into_par_iter().map_init(scratch, ask).collect()
    };
    #[cfg(not(feature = "parallel"))]
    let found: Vec<Result<R, E>> = {
        let mut scratch = scratch();
        rows.map(|row| ask(&mut scratch, row)).collect()
    };
    // rayon's own way to collect results would give any of the errors.
    found.into_iter().collect()
}
