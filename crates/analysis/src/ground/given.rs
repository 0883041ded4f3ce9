//! A motion of a figure under gravity, checked, and what is asked of each of its frames.

use crate::differentiate::Completed;
use crate::ground::{GroundError, Sole};
use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, Tree, Workspace};
use solaris_model::Figure;

/// What all questions share.
pub(crate) struct Given<'a> {
    pub(crate) figure: &'a Figure,
    pub(crate) tree: Tree<f64>,
    /// Against gravity, of length 1.
    pub(crate) up: Vector3<f64>,
    /// The figure's weight (N), more than zero.
    pub(crate) weight: f64,
    pub(crate) states: &'a Completed,
}

impl<'a> Given<'a> {
    pub(crate) fn new(
        figure: &'a Figure,
        gravity: Vector3<f64>,
        states: &'a Completed,
    ) -> Result<Self, GroundError> {
        let strength = gravity.norm();
        if !(strength.is_finite() && strength > 1e-9) {
            return Err(GroundError::NoGravity { gravity: gravity.into() });
        }
        let tree = Tree::<f64>::new(figure, gravity).map_err(GroundError::Tree)?;
        let weight = tree.mass() * strength;
        if weight <= 0.0 {
            return Err(GroundError::NoMass { figure: figure.name().to_owned() });
        }
        let rows = states.time.len();
        let columns = [("q", &states.q, tree.nq()), ("v", &states.v, tree.nv()), ("a", &states.a, tree.nv())];
        for (what, column, width) in columns {
            if column.len() != rows * width {
                let (figure, expected) = (figure.name().to_owned(), rows * width);
                return Err(GroundError::Length { what, found: column.len(), rows, figure, expected });
            }
        }
        if rows == 0 {
            return Err(GroundError::Empty);
        }
        let time = &states.time;
        let bad = |i: &usize| !(time[*i].is_finite() && (*i == 0 || time[*i] > time[*i - 1]));
        if let Some(frame) = (0..rows).find(bad) {
            return Err(GroundError::Time { frame, time: time[frame] });
        }
        Ok(Self { figure, tree, up: -gravity / strength, weight, states })
    }

    /// Refuses soles that are none of the figure's.
    pub(crate) fn check_soles(&self, soles: &[Sole]) -> Result<(), GroundError> {
        if soles.is_empty() {
            return Err(GroundError::NoSoles { figure: self.figure.name().to_owned() });
        }
        for (i, sole) in soles.iter().enumerate() {
            sole.check(self.figure)?;
            if soles[..i].iter().any(|other| other.name == sole.name) {
                let (sole, value) = (sole.name.clone(), "that of another sole".to_owned());
                let (what, remedy) = ("the name", "give each sole its own");
                return Err(GroundError::Sole { sole, what, value, remedy });
            }
        }
        Ok(())
    }

    /// Positions of a frame.
    pub(crate) fn q(&self, row: usize) -> &[f64] {
        &self.states.q[row * self.tree.nq()..][..self.tree.nq()]
    }

    /// Velocities of a frame.
    pub(crate) fn v(&self, row: usize) -> &[f64] {
        &self.states.v[row * self.tree.nv()..][..self.tree.nv()]
    }

    /// Accelerations of a frame.
    pub(crate) fn a(&self, row: usize) -> &[f64] {
        &self.states.a[row * self.tree.nv()..][..self.tree.nv()]
    }

    /// What `ask` finds in every frame, in order; frames are independent of each other and asked on all cores where the
    /// feature `parallel` is on.
    pub(crate) fn frames<R: Send>(
        &self,
        ask: impl Fn(&mut Workspace<f64>, usize) -> Result<R, DynamicsError> + Sync,
    ) -> Result<Vec<R>, GroundError> {
        let rows = 0..self.states.time.len();
        let at = |workspace: &mut Workspace<f64>, row: usize| {
            ask(workspace, row).map_err(|source| GroundError::State { time: self.states.time[row], source })
        };
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            rows.into_par_iter().map_init(|| Workspace::new(&self.tree), at).collect()
        }
        #[cfg(not(feature = "parallel"))]
        {
            let mut workspace = Workspace::new(&self.tree);
            rows.map(|row| at(&mut workspace, row)).collect()
        }
    }
}
