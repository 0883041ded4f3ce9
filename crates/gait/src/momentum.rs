//! Centre of mass and angular momentum of the body over the nodes of a plan.
//!
//! Everything is found against the pelvis' origin, which moves too: sums of `m r`, `m ṙ` and the angular momentum about
//! it give the angular momentum about the centre of mass, `L_c = L_o − M c × ċ`.

use crate::body::{Body, Segment};
use crate::foot::{FootPlane, mirror};
use crate::grid::Grid;
use crate::leg::LegPose;
use crate::legs::{LEG_SHAPE, LegMotion};
use crate::parts::Parts;
use crate::upper::UpperBody;
use nalgebra::Vector3;

/// The hips against the pelvis' origin at one node, each in its foot's plane (the right one mirrored), and their rates.
#[derive(Clone, Copy, Debug)]
struct Hips([(Vector3<f64>, Vector3<f64>); 2]);

/// What finds the momentum of the whole body, pass after pass.
#[derive(Clone, Debug)]
pub(crate) struct MomentumKernel {
    grid: Grid,
    plane: FootPlane,
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
    pub(crate) fn new(body: &Body, grid: &Grid, upper: &UpperBody, plane: FootPlane) -> Self {
        let hip = |node: usize, side: usize| {
            let hip = upper.pelvis(node) * body.legs[side][0].offset;
            plane.split_vector(&if side == 0 { hip } else { mirror(&hip) })
        };
        let hips = (0..grid.count)
            .map(|i| Hips([0, 1].map(|side| (hip(i, side), grid.first(i, |j| hip(j, side))))))
            .collect();
        let legs = [LegMotion::new(&body.legs[0]), LegMotion::new(&body.legs[1].map(Segment::mirrored))];
        let shapes = vec![[[0.0; LEG_SHAPE]; 2]; grid.count];
        Self { grid: *grid, plane, legs, mass: body.mass, hips, shapes }
    }

    /// Of the whole body, for the legs' poses at every node (left, right).
    pub(crate) fn momentum(&mut self, upper: &UpperBody, poses: impl Fn(usize) -> [LegPose; 2]) -> Momentum {
        for (i, shapes) in self.shapes.iter_mut().enumerate() {
            *shapes = poses(i).map(|pose| LegMotion::shape(&pose));
        }
        let (mut coms, mut angular) =
            (Vec::with_capacity(self.grid.count), Vec::with_capacity(self.grid.count));
        for i in 0..self.grid.count {
            let mut parts = *upper.parts(i);
            for side in [0, 1] {
                let rate = self.grid.first_of(i, |j| &self.shapes[j][side]);
                let (hip, hip_rate) = &self.hips[i].0[side];
                let leg = self.legs[side].parts(&self.shapes[i][side], &rate, hip, hip_rate);
                parts.join(&self.to_world(&leg, side));
            }
            let com = parts.first / self.mass;
            angular.push(parts.angular - com.cross(&parts.rate));
            coms.push(com);
        }
        Momentum { com: coms, angular }
    }

    /// From a foot's plane to the world; the mirror turns an axial vector the other way.
    fn to_world(&self, parts: &Parts, side: usize) -> Parts {
        let world = |v: &Vector3<f64>| self.plane.left * v.x + Vector3::y() * v.y + self.plane.forward * v.z;
        let [first, rate, angular] = [&parts.first, &parts.rate, &parts.angular].map(world);
        if side == 0 {
            Parts { first, rate, angular }
        } else {
            Parts { first: mirror(&first), rate: mirror(&rate), angular: -mirror(&angular) }
        }
    }
}
