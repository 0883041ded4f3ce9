//! Where a walk and a chain of running steps join: one foot stands flat, the other one swings.

use crate::body::Body;
use crate::body::foot::{FootPlane, mirror};
use crate::body::posture::Posture;
use crate::body::rotations;
use crate::grid::{Ends, Grid};
use crate::limbs::jet::{LegJet, jets};
use crate::limbs::stance::Stance;
use crate::momentum::MomentumKernel;
use crate::momentum::upper::UpperBody;
use crate::smooth::WalkPlan;
use crate::walking::G;
use nalgebra::Vector3;
use solaris_profiles::{ProfileError, UniformSpline};
use std::fmt;
use std::sync::Arc;

/// Nodes of the chain on the walk's side of the seam: for the differences at the seam and after it.
pub(super) const LEAD: usize = 16;
/// The node among them, counted from the outermost one, at which chain and walk are told to agree: far from either end of the differences.
pub(super) const MET: usize = 8;
/// Nodes beyond what is asked for, where splines and differences settle.
const MARGIN: usize = 20;
/// Distance of the instants that a swinging leg's derivatives come from (s).
const APART: f64 = 2e-3;

/// What carries the walking body, in body weights, metres and N m: force, where it acts on the sole of the foot that stands, as a part of the
/// foot's length from the heel and to the outside of the foot's axis, and free moment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Carrying {
    pub(super) force: Vector3<f64>,
    pub(super) pressure: f64,
    pub(super) outward: f64,
    pub(super) twist: f64,
}

/// A walk at its seam with a chain.
#[derive(Clone)]
pub(in crate::running) struct Seam {
    walk: Arc<WalkPlan>,
    /// Time of the walk when it is 0 in the chain (s).
    offset: f64,
    /// When the seam is (s).
    pub(super) at: f64,
    /// Left 0, right 1: the foot that stands.
    pub(super) side: usize,
    /// Where its heel stands, as that of a left foot (m).
    pub(super) print: Vector3<f64>,
    /// How it stands, and when its foot landed in the walk, by the chain's time, and how long a stride of it lasts (s).
    pub(super) stance: Stance,
    pub(super) landed: f64,
    pub(super) stride_time: f64,
    carrying: UniformSpline<6>,
    /// Of the centre of mass: where it is (m), and its rate.
    com: UniformSpline<3>,
}

impl fmt::Debug for Seam {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Seam").field("at", &self.at).field("side", &self.side).finish_non_exhaustive()
    }
}

impl Seam {
    /// Of a walk whose time is `walked` at the seam, `at` in the chain, and what carries it from `span.0` to `span.1` in the chain, on nodes `step`
    /// apart (s); the foot on `side` stands, in a step of this number.
    pub(super) fn new(
        body: &Body,
        walk: &Arc<WalkPlan>,
        (step_number, side): (usize, usize),
        (walked, at): (f64, f64),
        span: (f64, f64),
        step: f64,
    ) -> Result<Self, ProfileError> {
        let offset = walked - at;
        let first = ((span.0 - at) / step).floor() - MARGIN as f64;
        let last = ((span.1 - at) / step).ceil() + MARGIN as f64;
        let start = at + first * step;
        let count = (last - first) as usize + 1;
        let grid = Grid { count, step, ends: Ends::Open };
        let postures: Vec<Posture> =
            (0..count).map(|i| walk.posture(walk.clock_at(start + step * i as f64 + offset))).collect();
        let plane = walk.plane();
        let upper = UpperBody::new(
            body,
            &grid,
            |i| postures[i].carriage,
            |i| (postures[i].trunk, postures[i].arms, 0.0),
        );
        let mut kernel = MomentumKernel::new(body, &grid, &upper, plane, |_, _| 0.0, |_, _| 0.0);
        let momentum = kernel.momentum(&upper, |i| postures[i].legs);
        let com: Vec<Vector3<f64>> = (0..count).map(|i| postures[i].pelvis + momentum.com[i]).collect();
        let stood = &postures[(-first) as usize];
        let print = heel(body, &plane, side, stood);
        let foot = body.leg.foot_length();
        let seen = |v: &Vector3<f64>| if side == 0 { *v } else { mirror(v) };
        let carrying = |i: usize| {
            // The ends' differences are none.
            let i = i.clamp(3, count - 4);
            let force = (grid.second(i, |j| com[j]) + Vector3::y() * G) * body.mass;
            let rate = grid.first(i, |j| momentum.angular[j]);
            let c = com[i];
            // (P − c) × F + T = Ḣ with P on the ground.
            let cop = Vector3::new(
                c.x + (rate.z - c.y * force.x) / force.y,
                0.0,
                c.z - (rate.x + c.y * force.z) / force.y,
            );
            let twist = rate.y - (cop - c).cross(&force).y;
            let [outward, _, along] = plane.split(&(seen(&cop) - print));
            let force = force / (body.mass * G);
            [force.x, force.y, force.z, along / foot, outward, twist]
        };
        let carrying: Vec<[f64; 6]> = (0..count).map(carrying).collect();
        let com: Vec<[f64; 3]> = com.iter().map(|&com| com.into()).collect();
        Ok(Self {
            walk: Arc::clone(walk),
            offset,
            at,
            side,
            print,
            stance: walk.stance(step_number).clone(),
            landed: walk.lands(step_number) - offset,
            stride_time: walk.style_of_step(step_number).stride_time,
            carrying: UniformSpline::resting(start, step, &carrying)?,
            com: UniformSpline::resting(start, step, &com)?,
        })
    }

    /// The walk's time at a time of the chain (s).
    pub(super) fn walked(&self, time: f64) -> f64 {
        time + self.offset
    }

    /// The walk's posture at a time of the chain.
    pub(super) fn posture(&self, time: f64) -> Posture {
        self.walk.posture(self.walk.clock_at(self.walked(time)))
    }

    pub(super) fn carrying(&self, time: f64) -> Carrying {
        let [x, y, z, pressure, outward, twist] = self.carrying.position(time);
        Carrying { force: Vector3::new(x, y, z), pressure, outward, twist }
    }

    /// Where the centre of mass is and how fast it moves.
    pub(super) fn com(&self, time: f64) -> (Vector3<f64>, Vector3<f64>) {
        let [at, rate, _] = self.com.jet(time);
        (at.into(), rate.into())
    }

    /// The angles of the leg that swings, at the seam, with their derivatives in seconds.
    pub(super) fn swinging(&self) -> LegJet {
        let [side, thigh, knee, pitch, toes] = jets(self.at, APART, |time| {
            let pose = self.posture(time).legs[1 - self.side];
            [pose.side, pose.thigh, pose.knee, pose.pitch, pose.toes]
        });
        LegJet { side, thigh, knee, pitch, toes }
    }
}

/// Where the heel of a flat foot stands, as that of a left foot.
fn heel(body: &Body, plane: &FootPlane, side: usize, posture: &Posture) -> Vector3<f64> {
    let hip = posture.pelvis + rotations::matrix(posture.trunk[0]) * body.legs[side][0].offset;
    let hip = if side == 0 { hip } else { mirror(&hip) };
    let (leg, pose) = (&body.leg, &posture.legs[side]);
    let (sin, cos) = pose.side.sin_cos();
    let up = Vector3::y() * cos + plane.left * sin;
    let ankle = hip + plane.forward * leg.ankle_ahead_of_hip(pose) - up * leg.ankle_below_hip(pose);
    let heel = ankle - plane.forward * leg.heel_behind;
    Vector3::new(heel.x, 0.0, heel.z)
}
