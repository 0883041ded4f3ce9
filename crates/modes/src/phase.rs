//! A stretch of time in which every degree of freedom keeps its role: the equations of motion of what is left of the figure.

use crate::drive::force::Force;
use crate::drive::path::Path;
use crate::report::{Energy, PhaseReport};
use crate::simulation::Simulation;
use crate::time::{RateError, System};
use crate::trouble::SetupError;
use nalgebra::DMatrix;
use solaris_dynamics::DynamicsError;

/// What a degree of freedom is to the dynamics of a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Role {
    /// Dynamics move it.
    Dynamic,
    /// It has a motion of its own.
    Prescribed,
    /// It stands still, and is fused away.
    Still,
}

/// What is watched for: an event is where the function passes through zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Watched {
    /// `q[coordinate] − value`, of the full figure.
    Position { dof: usize, value: f64 },
    /// `v[dof] − value`, of the full figure.
    Velocity { dof: usize, value: f64 },
    /// The force that holds a prescribed degree of freedom, less that of its drive: where it passes through zero a limit lets go.
    Hold { dof: usize, drive: f64 },
}

/// The equations of motion of one stretch. The state is positions and velocities of what dynamics move, then the work of the
/// drives and the heat of dampers since the beginning (J).
pub(crate) struct Phase {
    pub(crate) report: PhaseReport,
}

impl Phase {
    /// `roles` by degree of freedom of the full figure; `q` is the full configuration, of which what stands still keeps its values.
    pub(crate) fn new(simulation: &Simulation, roles: &[Role], q: &[f64]) -> Result<Self, SetupError> {
        let _ = (simulation, roles, q);
        unimplemented!()
    }

    /// The force of a drive on a degree of freedom that dynamics move; none where nothing was said.
    pub(crate) fn set_force(&mut self, dof: usize, force: Force) {
        let _ = (dof, force);
    }

    /// The motion of a prescribed degree of freedom; where nothing was said it stands where it stood.
    pub(crate) fn set_path(&mut self, dof: usize, path: Path) {
        let _ = (dof, path);
    }

    /// What is watched for from here on.
    pub(crate) fn watch(&mut self, watched: Vec<Watched>) {
        let _ = watched;
    }

    /// Whether dynamics move anything.
    pub(crate) fn is_dynamic(&self) -> bool {
        unimplemented!()
    }

    /// The state of the full `q`, `v`, with work and heat (J).
    pub(crate) fn pack(&self, q: &[f64], v: &[f64], work: f64, heat: f64) -> Vec<f64> {
        let _ = (q, v, work, heat);
        unimplemented!()
    }

    /// The full `q`, `v` at a time of the run: dynamic from the state, prescribed from their paths, what stands still.
    pub(crate) fn unpack(&self, t: f64, y: &[f64], q: &mut [f64], v: &mut [f64]) {
        let _ = (t, y, q, v);
    }

    /// The full accelerations at a time of the run.
    pub(crate) fn accelerations(&mut self, t: f64, y: &[f64], a: &mut [f64]) -> Result<(), RateError> {
        let _ = (t, y, a);
        unimplemented!()
    }

    /// Energy of what is left of the figure.
    pub(crate) fn energy(&mut self, t: f64, y: &[f64]) -> Result<Energy, DynamicsError> {
        let _ = (t, y);
        unimplemented!()
    }

    /// The condition of the mass matrix of what dynamics move, each degree of freedom in units in which its own inertia is 1, and
    /// the degree of freedom of the full figure where it shows most.
    pub(crate) fn condition(&mut self, t: f64, y: &[f64]) -> Result<(f64, usize), DynamicsError> {
        let _ = (t, y);
        unimplemented!()
    }

    /// The degree of freedom of the full figure that an entry of the state belongs to; none for work and heat.
    pub(crate) fn dof_of(&self, entry: usize) -> Option<usize> {
        let _ = entry;
        unimplemented!()
    }
}

impl System for Phase {
    fn len(&self) -> usize {
        unimplemented!()
    }

    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        let _ = (t, y, rate);
        unimplemented!()
    }

    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError> {
        let _ = (t, y, jacobian);
        unimplemented!()
    }
}
