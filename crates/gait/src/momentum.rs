//! Centre of mass and angular momentum of the body over the nodes of a plan.
//!
//! Everything is found against the pelvis' origin, which moves too: sums of `m r`, `m ṙ` and the angular momentum about
//! it give the angular momentum about the centre of mass, `L_c = L_o − M c × ċ`.

mod legs;
mod parts;
pub(crate) mod upper;

use crate::body::foot::{FootPlane, mirror, turned};
use crate::body::leg::LegPose;
use crate::body::{Body, Segment};
use crate::grid::Grid;
use legs::{LEG_SHAPE, LegMotion, Tilt};
use nalgebra::{Matrix3, Vector3};
use parts::Parts;
use upper::UpperBody;

/// The hips against the pelvis' origin at one node, each in its foot's plane (the right one mirrored), and their rates.
#[derive(Clone, Copy, Debug)]
struct Hips([(Vector3<f64>, Vector3<f64>); 2]);

/// What finds the momentum of the whole body, pass after pass.
#[derive(Clone, Debug)]
pub(crate) struct MomentumKernel {
    grid: Grid,
    /// The left foot's plane against the way the foot points.
    plane: FootPlane,
    /// Which way each foot points, and its rate, at every node; none where all feet point along z.
    headings: Vec<[(f64, f64); 2]>,
    /// The ground that each foot is turned in, at every node; none where all is level.
    tilts: Vec<[Tilt; 2]>,
    legs: [LegMotion; 2],
    mass: f64,
    hips: Vec<Hips>,
    shapes: Vec<[[f64; LEG_SHAPE]; 2]>,
}

/// Centre of mass against the pelvis' origin, and angular momentum about the centre of mass, at every node.
pub(crate) struct Momentum {
    pub(crate) com: Vec<Vector3<f64>>,
    pub(crate) angular: Vec<Vector3<f64>>,
}

impl MomentumKernel {
    /// `heading` is which way a side's foot points at a node, `tilt` the pitch of the ground that it is turned in.
    pub(crate) fn new(
        body: &Body,
        grid: &Grid,
        upper: &UpperBody,
        plane: FootPlane,
        heading: impl Fn(usize, usize) -> f64,
        tilt: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let headings: Vec<[f64; 2]> = (0..grid.count).map(|i| [0, 1].map(|side| heading(i, side))).collect();
        let hip = |node: usize, side: usize| {
            let hip = upper.pelvis(node) * body.legs[side][0].offset;
            let hip = turned(-headings[node][side], &hip);
            plane.split_vector(&if side == 0 { hip } else { mirror(&hip) })
        };
        let hips = (0..grid.count)
            .map(|i| Hips([0, 1].map(|side| (hip(i, side), grid.first(i, |j| hip(j, side))))))
            .collect();
        let legs = [LegMotion::new(&body.legs[0]), LegMotion::new(&body.legs[1].map(Segment::mirrored))];
        let shapes = vec![[[0.0; LEG_SHAPE]; 2]; grid.count];
        let headings = if headings.iter().flatten().all(|&heading| heading == 0.0) {
            Vec::new()
        } else {
            let rate = |i: usize, side: usize| grid.first(i, |j| headings[j][side]);
            (0..grid.count).map(|i| [0, 1].map(|side| (headings[i][side], rate(i, side)))).collect()
        };
        let tilts: Vec<[f64; 2]> = (0..grid.count).map(|i| [0, 1].map(|side| tilt(i, side))).collect();
        let tilts = if tilts.iter().flatten().all(|&tilt| tilt == 0.0) {
            Vec::new()
        } else {
            let axes: Vec<[Matrix3<f64>; 2]> =
                tilts.iter().map(|sides| sides.map(|tilt| plane.tilted_within(tilt))).collect();
            let of =
                |i: usize, side: usize| Tilt { axes: axes[i][side], rates: grid.first(i, |j| axes[j][side]) };
            (0..grid.count).map(|i| [of(i, 0), of(i, 1)]).collect()
        };
        Self { grid: *grid, plane, headings, tilts, legs, mass: body.mass, hips, shapes }
    }

    /// Of the whole body, for the legs' poses at every node (left, right).
    pub(crate) fn momentum(&mut self, upper: &UpperBody, poses: impl Fn(usize) -> [LegPose; 2]) -> Momentum {
        for (i, shapes) in self.shapes.iter_mut().enumerate() {
            for (shape, pose) in shapes.iter_mut().zip(&poses(i)) {
                *shape = LegMotion::shape(pose);
            }
        }
        let (mut coms, mut angular) =
            (Vec::with_capacity(self.grid.count), Vec::with_capacity(self.grid.count));
        for i in 0..self.grid.count {
            let mut parts = *upper.parts(i);
            for side in [0, 1] {
                let rate = self.grid.first_of(i, |j| &self.shapes[j][side]);
                let (hip, hip_rate) = &self.hips[i].0[side];
                let tilt = self.tilts.get(i).map(|sides| &sides[side]);
                let leg = self.legs[side].parts(&self.shapes[i][side], &rate, hip, hip_rate, tilt);
                let turning = || self.legs[side].turning(&self.shapes[i][side], hip, tilt);
                parts.join(&self.to_world(&leg, turning, side, i));
            }
            let com = parts.first / self.mass;
            angular.push(parts.angular - com.cross(&parts.rate));
            coms.push(com);
        }
        Momentum { com: coms, angular }
    }

    /// From a foot's plane to the world; the mirror turns an axial vector the other way. A plane that turns at the rate ψ̇ adds
    /// `ψ̇ e × Σ m r` and `ψ̇ Σ (I e + m r × (e × r))`, which is `turning` for 1 rad/s, with the vertical e.
    fn to_world(&self, parts: &Parts, turning: impl Fn() -> Vector3<f64>, side: usize, node: usize) -> Parts {
        let world = |v: &Vector3<f64>| self.plane.left * v.x + Vector3::y() * v.y + self.plane.forward * v.z;
        let mut seen =
            Parts { first: world(&parts.first), rate: world(&parts.rate), angular: world(&parts.angular) };
        if side == 1 {
            let Parts { first, rate, angular } = seen;
            seen = Parts { first: mirror(&first), rate: mirror(&rate), angular: -mirror(&angular) };
        }
        let Some(&(heading, rate)) = self.headings.get(node).map(|sides| &sides[side]) else { return seen };
        seen.rate += Vector3::y().cross(&seen.first) * rate;
        // In the mirror a turn goes the other way, and so does its momentum: it is the same for the same turn.
        let turning = world(&turning());
        seen.angular += if side == 0 { turning } else { mirror(&turning) } * rate;
        Parts {
            first: turned(heading, &seen.first),
            rate: turned(heading, &seen.rate),
            angular: turned(heading, &seen.angular),
        }
    }
}
