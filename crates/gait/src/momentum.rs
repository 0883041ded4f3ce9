//! Centre of mass and angular momentum of the body over the nodes of a plan.
//!
//! Trunk and arms do not change from pass to pass, so their part against the pelvis is computed once.

use crate::body::{Body, Segment};
use crate::foot::{FootPlane, LegPose, mirror_rotation};
use crate::grid::Grid;
use crate::laws;
use nalgebra::{Matrix3, Vector3};

/// Trunk and arms at one node: orientations of the pelvis, and what hangs on it.
#[derive(Clone, Copy, Debug)]
struct UpperNode {
    pelvis: Matrix3<f64>,
    /// Centre of mass against the pelvis' origin.
    com: Vector3<f64>,
    /// Angular momentum about that centre of mass.
    momentum: Vector3<f64>,
}

/// Trunk and arms over the nodes.
#[derive(Clone, Debug)]
pub(crate) struct UpperBody {
    mass: f64,
    nodes: Vec<UpperNode>,
}

/// World rotations of pelvis … head and of both arms, and their centres of mass against the pelvis' origin.
fn upper_posture(
    body: &Body,
    trunk: &[laws::Euler; 5],
    arms: &[[f64; 2]; 2],
) -> [(Matrix3<f64>, Vector3<f64>); 13] {
    let mut parts = [(Matrix3::zeros(), Vector3::zeros()); 13];
    let rotations = trunk.map(laws::rotation);
    let mut origin = Vector3::zeros();
    let mut thorax_origin = origin;
    for (i, (segment, rotation)) in body.middle.iter().zip(&rotations).enumerate() {
        if i > 0 {
            origin += rotations[i - 1] * segment.offset;
        }
        if i == 2 {
            thorax_origin = origin;
        }
        parts[i] = (*rotation, origin + rotation * segment.com);
    }
    for (side, (arm, [shoulder, elbow])) in body.arms.iter().zip(arms).enumerate() {
        let abduction = if side == 0 { laws::ARM_ABDUCTION } else { -laws::ARM_ABDUCTION };
        let clavicle = rotations[2];
        let upper = clavicle * laws::about_z(abduction) * laws::about_x(*shoulder);
        let forearm = upper * laws::about_x(*elbow);
        let chain = [clavicle, upper, forearm, forearm * laws::about_x(laws::HAND)];
        let mut origin = thorax_origin + rotations[2] * arm[0].offset;
        for (i, (segment, rotation)) in arm.iter().zip(&chain).enumerate() {
            if i > 0 {
                origin += chain[i - 1] * segment.offset;
            }
            parts[5 + 4 * side + i] = (*rotation, origin + rotation * segment.com);
        }
    }
    parts
}

impl UpperBody {
    /// Over the nodes of a grid, from the angles of trunk and arms at each of them.
    pub(crate) fn new(
        body: &Body,
        grid: &Grid,
        angles: impl Fn(usize) -> ([laws::Euler; 5], [[f64; 2]; 2]),
    ) -> Self {
        let segments: Vec<&Segment> = body.middle.iter().chain(body.arms.iter().flatten()).collect();
        let mass: f64 = segments.iter().map(|segment| segment.mass).sum();
        let parts: Vec<[(Matrix3<f64>, Vector3<f64>); 13]> = (0..grid.count)
            .map(|i| {
                let (trunk, arms) = angles(i);
                upper_posture(body, &trunk, &arms)
            })
            .collect();
        let centre = |i: usize| -> Vector3<f64> {
            segments.iter().zip(&parts[i]).map(|(segment, (_, com))| com * segment.mass).sum::<Vector3<f64>>()
                / mass
        };
        let coms: Vec<Vector3<f64>> = (0..grid.count).map(centre).collect();
        let nodes = (0..grid.count)
            .map(|i| {
                let com_rate = grid.first(i, |j| coms[j]);
                let momentum = segments
                    .iter()
                    .enumerate()
                    .map(|(s, segment)| {
                        let (rotation, com) = parts[i][s];
                        let rates = (grid.first(i, |j| parts[j][s].0), grid.first(i, |j| parts[j][s].1));
                        momentum_about(segment, &rotation, &rates.0, com - coms[i], rates.1 - com_rate)
                    })
                    .sum();
                UpperNode { pelvis: parts[i][0].0, com: coms[i], momentum }
            })
            .collect();
        Self { mass, nodes }
    }

    /// The pelvis' orientation at a node.
    pub(crate) fn pelvis(&self, node: usize) -> &Matrix3<f64> {
        &self.nodes[node].pelvis
    }
}

/// Angular momentum of a segment about a point: spin from the rate of the rotation, `ω× = Ṙ Rᵀ`, and orbit.
fn momentum_about(
    segment: &Segment,
    rotation: &Matrix3<f64>,
    rate: &Matrix3<f64>,
    arm: Vector3<f64>,
    velocity: Vector3<f64>,
) -> Vector3<f64> {
    let w = rate * rotation.transpose();
    let spin = Vector3::new(w[(2, 1)] - w[(1, 2)], w[(0, 2)] - w[(2, 0)], w[(1, 0)] - w[(0, 1)]) * 0.5;
    rotation * (segment.inertia * (rotation.transpose() * spin)) + arm.cross(&velocity) * segment.mass
}

/// Both legs at one node: rotations and centres of mass against the pelvis' origin, left then right.
type LegsNode = [(Matrix3<f64>, Vector3<f64>); 8];

/// Centre of mass against the pelvis' origin, and angular momentum about the centre of mass, at every node.
pub(crate) struct Momentum {
    pub(crate) com: Vec<Vector3<f64>>,
    pub(crate) angular: Vec<Vector3<f64>>,
}

impl Momentum {
    /// Of the whole body, for the legs' poses at every node (left, right).
    pub(crate) fn new(
        body: &Body,
        grid: &Grid,
        upper: &UpperBody,
        plane: &FootPlane,
        poses: impl Fn(usize) -> [LegPose; 2],
    ) -> Self {
        let segments: Vec<&Segment> = body.legs.iter().flatten().collect();
        let parts: Vec<LegsNode> =
            (0..grid.count).map(|i| legs_posture(body, &upper.nodes[i].pelvis, plane, &poses(i))).collect();
        let com: Vec<Vector3<f64>> = upper
            .nodes
            .iter()
            .zip(&parts)
            .map(|(upper_node, legs)| {
                let legs: Vector3<f64> = segments.iter().zip(legs).map(|(s, (_, com))| com * s.mass).sum();
                (upper_node.com * upper.mass + legs) / body.mass
            })
            .collect();
        let angular = (0..grid.count)
            .map(|i| {
                let com_rate = grid.first(i, |j| com[j]);
                let node = &upper.nodes[i];
                let upper_rate = grid.first(i, |j| upper.nodes[j].com) - com_rate;
                let trunk = node.momentum + (node.com - com[i]).cross(&upper_rate) * upper.mass;
                let legs: Vector3<f64> = segments
                    .iter()
                    .enumerate()
                    .map(|(s, segment)| {
                        let (rotation, at) = parts[i][s];
                        let rates = (grid.first(i, |j| parts[j][s].0), grid.first(i, |j| parts[j][s].1));
                        momentum_about(segment, &rotation, &rates.0, at - com[i], rates.1 - com_rate)
                    })
                    .sum();
                trunk + legs
            })
            .collect();
        Self { com, angular }
    }
}

fn legs_posture(body: &Body, pelvis: &Matrix3<f64>, plane: &FootPlane, poses: &[LegPose; 2]) -> LegsNode {
    let mut parts = [(Matrix3::zeros(), Vector3::zeros()); 8];
    for (side, (leg, pose)) in body.legs.iter().zip(poses).enumerate() {
        let mut frames = plane.frames(pose);
        if side == 1 {
            frames = frames.map(|frame| mirror_rotation(&frame));
        }
        let mut origin = pelvis * leg[0].offset;
        for (i, (segment, frame)) in leg.iter().zip(&frames).enumerate() {
            if i > 0 {
                origin += frames[i - 1] * segment.offset;
            }
            parts[4 * side + i] = (*frame, origin + frame * segment.com);
        }
    }
    parts
}
