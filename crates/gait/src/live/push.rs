//! Somebody who is pushed: trunk and head give way at once, and the next steps go along.
//!
//! A force of the horizontal part `F` adds to the velocity that is wished, and is forgotten again,
//!
//! ```text
//! ḋ = F/m − d/T
//! ```
//!
//! so that feet land by it as by any other command. Meanwhile each joint of trunk and head, on which the force has the moment `τ = Jᵀ F`, gives by an angle `x` that
//! a damped spring draws to where it holds the moment, never farther than `g`:
//!
//! ```text
//! ẍ = ω² (g tanh(τ/(k g)) − x) − 2 ζ ω ẋ
//! ```
//!
//! These are laws of ours, chosen by eye: no measurement of people says how they give way.

use crate::body::{Body, REFERENCE_HEIGHT};
use crate::error::{GaitError, LiveError};
use crate::walking::G;
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, Wrench, forward_kinematics, inverse_dynamics};
use solaris_model::{Figure, nearest};
use std::sync::Arc;

/// How long somebody goes along with a push (s).
const FORGETS: f64 = 0.8;
/// The fastest that anybody is pushed along (m/s, for the reference height), and the greatest acceleration to it (m/s²): harder pushes move nobody faster.
const FASTEST: f64 = 0.7;
const HARDEST: f64 = 1.2;
/// The greatest force (weights), and the farthest place from its link (m).
const MOST: f64 = 1.0;
const FARTHEST: f64 = 1e3;
/// How stiff a joint of the trunk is, and one of neck and head (weight times height, a radian).
const STIFFNESS: [f64; 2] = [0.2, 0.035];
/// How far a joint gives at most (rad), how quickly (1/s), and how much it is damped.
const GIVES: f64 = 0.16;
const QUICK: f64 = 9.0;
const DAMPED: f64 = 0.8;

/// What pushes: a force of the world (N) on a point of a link (m, in its frame).
#[derive(Clone, Copy)]
struct Push {
    link: usize,
    at: Vector3<f64>,
    force: Vector3<f64>,
}

/// A degree of freedom that gives.
#[derive(Clone, Copy)]
struct Give {
    /// The coordinate, which is its index among the velocities, too.
    q: usize,
    /// What a moment of one turns it by (rad/(N m)).
    compliance: f64,
    /// By how much it has given, how fast it does, and how that changes.
    angle: f64,
    rate: f64,
    change: f64,
}

/// What pushes somebody, and how he gives way.
#[derive(Clone)]
pub(super) struct Pushed {
    links: Arc<[String]>,
    /// Without gravity, so that only the force is felt.
    tree: Arc<Tree<f64>>,
    workspace: Workspace<f64>,
    rest: Vec<f64>,
    tau: Vec<f64>,
    mass: f64,
    scale: f64,
    push: Option<Push>,
    /// The same about the world's origin, as it was last.
    wrench: Option<(usize, Wrench<f64>)>,
    /// What was added to the velocity: x and z (m/s).
    drift: [f64; 2],
    gives: Vec<Give>,
}

impl Pushed {
    /// Nobody who is pushed.
    pub(super) fn new(figure: &Figure, body: &Body) -> Result<Self, GaitError> {
        let tree: Tree<f64> = Tree::new(figure, Vector3::zeros())?;
        let height = body.scale() * REFERENCE_HEIGHT;
        let (mass, nv) = (figure.mass(), figure.layout().nv());
        let give = |(i, q): (usize, usize)| {
            let stiffness = STIFFNESS[usize::from(i >= 2)] * mass * G * height;
            Give { q, compliance: 1.0 / stiffness, angle: 0.0, rate: 0.0, change: 0.0 }
        };
        let upper = body.middle[1..].iter().enumerate();
        Ok(Self {
            links: figure.links().iter().map(|link| link.name().to_owned()).collect(),
            workspace: Workspace::new(&tree),
            tree: Arc::new(tree),
            rest: vec![0.0; nv],
            tau: vec![0.0; nv],
            mass,
            scale: body.scale(),
            push: None,
            wrench: None,
            drift: [0.0; 2],
            gives: upper
                .flat_map(|(i, segment)| (segment.q..segment.q + 3).map(move |q| (i, q)))
                .map(give)
                .collect(),
        })
    }

    /// A force on a link from now on, or none.
    pub(super) fn push(
        &mut self,
        link: &str,
        at: Vector3<f64>,
        force: Vector3<f64>,
    ) -> Result<(), LiveError> {
        let Some(index) = self.links.iter().position(|known| known == link) else {
            let nearest = nearest(link, self.links.iter().map(String::as_str));
            return Err(LiveError::NoLink { link: link.to_owned(), nearest });
        };
        let most = MOST * self.mass * G;
        let newtons = force.norm();
        if newtons.is_nan() || newtons > most {
            return Err(LiveError::Push { force: newtons, most });
        }
        if let Some(value) = at.iter().copied().find(|x| x.is_nan() || x.abs() > FARTHEST) {
            return Err(LiveError::NotFinite { what: "place of a push", value });
        }
        self.push = Some(Push { link: index, at, force });
        Ok(())
    }

    pub(super) fn let_go(&mut self) {
        self.push = None;
        self.wrench = None;
    }

    /// Whether anything is left of a push.
    pub(super) fn is_felt(&self) -> bool {
        self.push.is_some()
            || self.drift[0].hypot(self.drift[1]) > 1e-5
            || self.gives.iter().any(|give| give.angle.abs().max(give.rate.abs()) > 1e-7)
    }

    /// What it adds to the velocity that is wished: x and z (m/s).
    pub(super) fn drift(&self) -> [f64; 2] {
        self.drift
    }

    /// The force and its moment about the world's origin, and the link that they push.
    pub(super) fn wrench(&self) -> Option<(usize, Wrench<f64>)> {
        self.wrench
    }

    /// Goes on by `dt` (s), from a configuration.
    pub(super) fn step(&mut self, dt: f64, q: &[f64]) {
        self.feel(q);
        let force = self.push.map_or_else(Vector3::zeros, |push| push.force);
        let kept = (-dt / FORGETS).exp();
        let level = [force.x, force.z].map(|f| f / self.mass);
        let hard = (level[0].hypot(level[1]) / HARDEST).max(1.0);
        let steady = level.map(|a| a / hard * FORGETS);
        let drift = [0, 1].map(|i| steady[i] + (self.drift[i] - steady[i]) * kept);
        let over = (drift[0].hypot(drift[1]) / (FASTEST * self.scale.sqrt())).max(1.0);
        self.drift = drift.map(|v| v / over);
        for give in &mut self.gives {
            let to = GIVES * (self.tau[give.q] * give.compliance / GIVES).tanh();
            give.go_on(dt, to);
        }
    }

    /// The moments of the force about the joints.
    fn feel(&mut self, q: &[f64]) {
        self.tau.fill(0.0);
        self.wrench = None;
        let Some(Push { link, at, force }) = self.push else { return };
        // Frames are finite, and the figure was built: neither is refused.
        if forward_kinematics(&self.tree, &mut self.workspace, q).is_err() {
            return;
        }
        let pose = self.workspace.pose(link);
        let place = pose.translation + pose.rotation * at;
        let wrench = Wrench::at(&place, force, Vector3::zeros());
        let acts = [(link, wrench)];
        let Self { tree, workspace, rest, tau, .. } = self;
        // What holds it without gravity and at rest is what it does, with the other sign.
        if inverse_dynamics(tree, workspace, q, rest, rest, &acts, tau).is_err() {
            self.tau.fill(0.0);
        }
        self.tau.iter_mut().for_each(|tau| *tau = -*tau);
        self.wrench = Some((link, wrench));
    }

    /// Adds by how much the joints have given to a configuration.
    pub(super) fn write(&self, q: &mut [f64]) {
        for give in &self.gives {
            q[give.q] += give.angle;
        }
    }

    /// The same for velocities and accelerations.
    pub(super) fn write_derivatives(&self, v: &mut [f64], a: &mut [f64]) {
        for give in &self.gives {
            v[give.q] += give.rate;
            a[give.q] += give.change;
        }
    }
}

impl Give {
    /// The damped spring in closed form, over a time in which it is drawn to one place.
    fn go_on(&mut self, dt: f64, to: f64) {
        let (fall, turn) = (DAMPED * QUICK, QUICK * (1.0 - DAMPED * DAMPED).sqrt());
        let from = self.angle - to;
        let other = (self.rate + fall * from) / turn;
        let (sin, cos) = (turn * dt).sin_cos();
        let kept = (-fall * dt).exp();
        let apart = kept * (from * cos + other * sin);
        self.rate = kept * turn * (other * cos - from * sin) - fall * apart;
        self.angle = to + apart;
        self.change = -QUICK * QUICK * apart - 2.0 * fall * self.rate;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_gives_obeys_its_spring() {
        let mut give = Give { q: 0, compliance: 1.0, angle: 0.02, rate: -0.3, change: 0.0 };
        let (to, h) = (0.1, 1e-4);
        let angles: Vec<f64> = (0..3000)
            .map(|_| {
                give.go_on(h, to);
                give.angle
            })
            .collect();
        for x in angles.windows(3).step_by(200) {
            let (v, a) = ((x[2] - x[0]) / (2.0 * h), (x[2] - 2.0 * x[1] + x[0]) / (h * h));
            let law = QUICK * QUICK * (to - x[1]) - 2.0 * DAMPED * QUICK * v;
            assert!((a - law).abs() < 1e-4, "{a} {law}");
        }
        // Two halves are the whole.
        let (mut halves, mut whole) = (give, give);
        halves.go_on(0.05, to);
        halves.go_on(0.05, to);
        whole.go_on(0.1, to);
        assert!((halves.angle - whole.angle).abs() < 1e-15 && (halves.rate - whole.rate).abs() < 1e-14);
    }
}
