//! Joints that hang loose from the walk.

use crate::body::Body;
use crate::error::{GaitError, LiveError};
use crate::walking::G;
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::Figure;
use solaris_modes::{Hanging, SetupError};
use solaris_profiles::step;
use std::sync::Arc;

/// How long a joint takes to come back into the walk (s).
const EASES: f64 = 0.5;
/// Accelerations are those over no less than this (s).
const LEAST_FRAME: f64 = 1e-6;

/// A joint that may be loosened.
#[derive(Clone)]
struct Joint {
    name: String,
    /// Its degrees of freedom: coordinate, and index among the velocities.
    dofs: Vec<(usize, usize)>,
}

/// What hangs loose from a walk.
///
/// A joint that is loosened swings at once, from where it is and as fast as it moves. One that is tightened goes on swinging, while what is shown goes over to the
/// walk: so neither position nor velocity jumps.
#[derive(Clone)]
pub(super) struct Limbs {
    joints: Arc<[Joint]>,
    /// For each: whether it is loose, and how far it is (0 to 1).
    states: Vec<(bool, f64)>,
    hanging: Hanging,
    /// The walk's configuration, and what hangs in it; its velocities and accelerations, and the velocities with what hangs.
    q: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) a: Vec<f64>,
    moved: Vec<f64>,
    /// Velocity and acceleration of what is shown, of what is loose.
    rates: Vec<[f64; 2]>,
}

impl Limbs {
    /// All joints but those of the root and the legs, none of them loose.
    pub(super) fn new(figure: &Figure, body: &Body) -> Result<Self, GaitError> {
        let layout = figure.layout();
        let upper = body.middle[1..].iter().chain(body.arms.iter().flatten());
        let joint = |first: usize| {
            let index = layout.joints().partition_point(|at| at.q + at.nq <= first);
            let at = layout.joints()[index];
            let dofs = (0..at.nv).map(|i| (at.q + i, at.v + i)).collect();
            Joint { name: figure.links()[index].joint().name().to_owned(), dofs }
        };
        let joints: Vec<Joint> = upper.map(|segment| joint(segment.q)).collect();
        let (nq, nv) = (layout.nq(), layout.nv());
        let hanging = Hanging::new(figure, Vector3::new(0.0, -G, 0.0)).map_err(|error| match error {
            SetupError::Dynamics(error) => GaitError::Dynamics(error),
            error => LiveError::Loose { why: error.to_string() }.into(),
        })?;
        Ok(Self {
            states: vec![(false, 0.0); joints.len()],
            joints: joints.into(),
            hanging,
            q: vec![0.0; nq],
            v: vec![0.0; nv],
            a: vec![0.0; nv],
            moved: vec![0.0; nv],
            rates: vec![[0.0; 2]; nv],
        })
    }

    pub(super) fn find(&self, joint: &str) -> Result<usize, LiveError> {
        let found = self.joints.iter().position(|known| known.name == joint);
        found.ok_or_else(|| LiveError::NotLoose { joint: joint.to_owned() })
    }

    /// Whether a joint is loose, or on its way back.
    pub(super) fn moves(&self) -> bool {
        self.states.iter().any(|(_, part)| *part > 0.0)
    }

    /// A joint hangs loose from now on, from a configuration that is shown, with the velocities in `v` where it was not loose before.
    pub(super) fn loosen(&mut self, joint: &str, q: &[f64]) -> Result<(), LiveError> {
        let i = self.find(joint)?;
        let (is_loose, part) = self.states[i];
        if is_loose {
            return Ok(());
        }
        for &(_, dof) in &self.joints[i].dofs {
            if part > 0.0 {
                self.v[dof] = self.rates[dof][0];
            }
            self.rates[dof] = [self.v[dof], 0.0];
        }
        let begun = self.hanging.loosen(joint, q, &self.v);
        begun.map_err(|error| LiveError::Loose { why: error.to_string() })?;
        self.states[i] = (true, 1.0);
        Ok(())
    }

    /// A joint comes back into the walk.
    pub(super) fn tighten(&mut self, joint: &str) -> Result<(), LiveError> {
        let i = self.find(joint)?;
        self.states[i].0 = false;
        Ok(())
    }

    /// Goes on by `dt` (s) with a walk whose velocities and accelerations are in `v` and `a`, and writes what is loose into its
    /// configuration. What pushes a link is felt.
    pub(super) fn step(&mut self, dt: f64, pushed: Option<(usize, Wrench<f64>)>, q: &mut [f64]) {
        self.q.copy_from_slice(q);
        self.moved.copy_from_slice(&self.v);
        let is_felt = self.hanging.push(pushed);
        if is_felt.and_then(|()| self.hanging.step(dt, &mut self.q, &mut self.moved, &self.a)).is_err() {
            // Frames are short and a walk's numbers finite: should it be refused all the same, the walk is shown.
            return;
        }
        for ((is_loose, part), joint) in self.states.iter_mut().zip(self.joints.iter()) {
            if *part <= 0.0 {
                continue;
            }
            if !*is_loose {
                *part = (*part - dt / EASES).max(0.0);
                if *part <= 0.0 {
                    // Its name is known.
                    let _known = self.hanging.tighten(&joint.name);
                    continue;
                }
            }
            let weight = step::quintic(*part);
            let rate = if *is_loose { 0.0 } else { -weight.velocity / EASES };
            for &(coordinate, dof) in &joint.dofs {
                let apart = self.q[coordinate] - q[coordinate];
                q[coordinate] += apart * weight.position;
                let walk = self.v[dof];
                let velocity = walk + (self.moved[dof] - walk) * weight.position + apart * rate;
                self.rates[dof] = [velocity, (velocity - self.rates[dof][0]) / dt.max(LEAST_FRAME)];
            }
        }
    }

    /// Writes velocities and accelerations of what is loose in place of the walk's.
    pub(super) fn write_derivatives(&self, v: &mut [f64], a: &mut [f64]) {
        for ((_, part), joint) in self.states.iter().zip(self.joints.iter()) {
            for &(_, dof) in joint.dofs.iter().filter(|_| *part > 0.0) {
                [v[dof], a[dof]] = self.rates[dof];
            }
        }
    }
}
