//! Prescribed motions, and forces of drives on what dynamics move.

use super::Role;
use crate::drive::force::Force;
use crate::drive::path::Path;
use crate::push::Thrust;
use nalgebra::Vector3;
use solaris_model::{Figure, Follower};

/// The motion of the degrees of freedom that have one of their own, of those that follow them, where the others stand, and the
/// forces of drives on what dynamics move.
#[derive(Clone)]
pub(super) struct Prescribed {
    /// By degree of freedom of the full figure.
    motions: Vec<Motion>,
    /// Where everything stood when the phase began: the full `q`, followers where their leaders put them.
    standing: Vec<f64>,
    /// The degrees of freedom that follow others, which none of these do.
    followers: Vec<Follower>,
    /// By degree of freedom, its coordinate in the full `q`.
    coordinates: Vec<Option<usize>>,
    /// For each degree of freedom that dynamics move, in their order.
    forces: Vec<Force>,
    /// What each push of the world does, where it does anything.
    pushes: Vec<Option<Thrust>>,
}

#[derive(Clone)]
enum Motion {
    /// Dynamics move it.
    None,
    /// It stands.
    Still,
    Along(Path),
    /// It follows another, by its place in the list.
    Following(usize),
}

impl Prescribed {
    /// Everything stands at `q`, and there are no forces, and of so many pushes of the world none.
    pub(super) fn new(figure: &Figure, roles: &[Role], q: &[f64], pushes: usize) -> Self {
        let (layout, followers) = (figure.layout(), figure.followers().to_vec());
        let role = |role: &Role| if *role == Role::Dynamic { Motion::None } else { Motion::Still };
        let (mut motions, mut standing): (Vec<Motion>, _) = (roles.iter().map(role).collect(), q.to_vec());
        for (i, follower) in followers.iter().enumerate() {
            standing[follower.coordinate] = follower.curve.at(standing[follower.leader_coordinate])[0];
            motions[follower.dof] = Motion::Following(i);
        }
        let coordinates = (0..layout.nv()).map(|dof| layout.coordinate(dof)).collect();
        let dynamic = roles.iter().filter(|role| **role == Role::Dynamic).count();
        Self {
            motions,
            standing,
            followers,
            coordinates,
            forces: vec![Force::Constant(0.0); dynamic],
            pushes: vec![None; pushes],
        }
    }

    /// Where everything stood when the phase began.
    pub(super) fn standing(&self) -> &[f64] {
        &self.standing
    }

    /// Sets the motion of a degree of freedom; one that follows another has none of its own.
    pub(super) fn set(&mut self, dof: usize, path: Path) {
        if let Motion::Still | Motion::Along(_) = self.motions[dof] {
            self.motions[dof] = Motion::Along(path);
        }
    }

    /// Sets the force on a degree of freedom, by its place among those that dynamics move.
    pub(super) fn set_force(&mut self, index: usize, force: Force) {
        self.forces[index] = force;
    }

    /// Sets what a push of the world does, by its index.
    pub(super) fn set_push(&mut self, push: usize, thrust: Option<Thrust>) {
        self.pushes[push] = thrust;
    }

    /// What a push of the world does (N) at a time of the run.
    pub(super) fn push(&self, push: usize, t: f64) -> Vector3<f64> {
        self.pushes[push].as_ref().map_or_else(Vector3::zeros, |thrust| thrust.at(t))
    }

    /// The force on a degree of freedom, by its place among those that dynamics move.
    pub(super) fn force(&self, index: usize) -> &Force {
        &self.forces[index]
    }

    /// The same, to be changed.
    pub(super) fn force_mut(&mut self, index: usize) -> &mut Force {
        &mut self.forces[index]
    }

    /// Position, velocity and acceleration of a degree of freedom that dynamics do not move; of a ball or free joint's, no
    /// position.
    pub(super) fn at(&self, dof: usize, t: f64) -> [f64; 3] {
        match &self.motions[dof] {
            Motion::Along(path) => {
                let sample = path.at(t);
                [sample.position, sample.velocity, sample.acceleration]
            }
            Motion::Following(i) => {
                let follower = &self.followers[*i];
                let [x, rate, change] = self.at(follower.leader, t);
                let [y, first, second] = follower.curve.at(x);
                [y, first * rate, first * change + second * rate * rate]
            }
            Motion::None | Motion::Still => {
                [self.coordinates[dof].map_or(f64::NAN, |coordinate| self.standing[coordinate]), 0.0, 0.0]
            }
        }
    }

    /// The first time (s) after `t` at which a motion goes on by another piece of its curve.
    pub(super) fn smooth_until(&self, t: f64) -> f64 {
        let paths = self.motions.iter().filter_map(|motion| match motion {
            Motion::Along(path) => Some(path.smooth_until(t)),
            _ => None,
        });
        paths.fold(f64::INFINITY, f64::min)
    }

    /// Whether a degree of freedom moves, or may.
    pub(super) fn moves(&self, dof: usize) -> bool {
        matches!(self.motions[dof], Motion::Along(_) | Motion::Following(_))
    }

    /// Writes the full `q`, `v`; what dynamics move stands still in them.
    pub(super) fn write(&self, t: f64, q: &mut [f64], v: &mut [f64]) {
        q.copy_from_slice(&self.standing);
        v.fill(0.0);
        for dof in (0..self.motions.len()).filter(|dof| self.moves(*dof)) {
            let [position, velocity, _] = self.at(dof, t);
            if let Some(coordinate) = self.coordinates[dof] {
                (q[coordinate], v[dof]) = (position, velocity);
            }
        }
    }

    /// Writes the full `a`; what dynamics move has none in it.
    pub(super) fn write_accelerations(&self, t: f64, a: &mut [f64]) {
        a.fill(0.0);
        for dof in (0..self.motions.len()).filter(|dof| self.moves(*dof)) {
            a[dof] = self.at(dof, t)[2];
        }
    }
}
