//! Trunk and arms over the nodes of a plan, found once: they do not change from pass to pass, but where an arm follows a cane.

use super::parts::Parts;
use crate::body::Cane;
use crate::body::posture::ArmCarriage;
use crate::body::rotations;
use crate::body::{Body, Segment};
use crate::grid::Grid;
use nalgebra::{Matrix3, Vector3};

/// Trunk and arms over the nodes.
#[derive(Clone, Debug)]
pub(crate) struct UpperBody {
    pelvis: Vec<Matrix3<f64>>,
    parts: Vec<Parts>,
}

impl UpperBody {
    /// Over the nodes of a grid, from how arms hang, the angles of trunk and arms and which way the body faces at each of them.
    pub(crate) fn new(
        body: &Body,
        grid: &Grid,
        carriage: impl Fn(usize) -> ArmCarriage,
        angles: impl Fn(usize) -> ([rotations::Euler; 5], [[f64; 2]; 2], f64),
    ) -> Self {
        Self::holding(body, grid, carriage, angles, |_| [0.0; 2])
    }

    /// The same with how a cane is turned in the fist, if a hand holds one.
    pub(crate) fn holding(
        body: &Body,
        grid: &Grid,
        carriage: impl Fn(usize) -> ArmCarriage,
        angles: impl Fn(usize) -> ([rotations::Euler; 5], [[f64; 2]; 2], f64),
        cane: impl Fn(usize) -> [f64; 2],
    ) -> Self {
        let postures = (0..grid.count).map(|i| {
            let (trunk, arms, heading) = angles(i);
            let ahead = posture(body, &trunk, &arms, cane(i), carriage(i));
            if heading == 0.0 {
                return ahead;
            }
            let turn = rotations::about_y(heading);
            ahead.map(|(rotation, com)| (turn * rotation, turn * com))
        });
        Self::of(body, grid, &postures.collect::<Vec<_>>())
    }

    /// The same of postures, compiled once for all who have them.
    fn of(body: &Body, grid: &Grid, postures: &[Parted]) -> Self {
        let segments = segments(body);
        let parts = (0..grid.count).map(|i| {
            let mut sum = Parts::default();
            for (s, segment) in segments.iter().enumerate() {
                let (rotation, com) = postures[i][s];
                let rotation_rate = grid.first(i, |j| postures[j][s].0);
                let com_rate = grid.first(i, |j| postures[j][s].1);
                sum.add(segment, &rotation, &rotation_rate, &com, &com_rate);
            }
            sum
        });
        Self { parts: parts.collect(), pelvis: postures.iter().map(|posture| posture[0].0).collect() }
    }

    /// The pelvis' orientation at a node.
    pub(crate) fn pelvis(&self, node: usize) -> &Matrix3<f64> {
        &self.pelvis[node]
    }

    /// Momentum of trunk and arms at a node.
    pub(crate) fn parts(&self, node: usize) -> &Parts {
        &self.parts[node]
    }
}

/// First moment of trunk, head and arms to the left of the pelvis' origin (kg m).
pub(crate) fn beside(
    body: &Body,
    trunk: &[rotations::Euler; 5],
    arms: &[[f64; 2]; 2],
    carriage: ArmCarriage,
) -> f64 {
    segments(body)
        .iter()
        .zip(posture(body, trunk, arms, [0.0; 2], carriage))
        .map(|(segment, (_, com))| segment.mass * com.x)
        .sum()
}

/// Trunk, arms, and what a hand holds.
fn segments(body: &Body) -> Vec<&Segment> {
    let cane = body.cane.iter().map(|cane| &cane.segment);
    body.middle.iter().chain(body.arms.iter().flatten()).chain(cane).collect()
}

/// Rotations and centres of mass of what [`posture`] tells of.
type Parted = [(Matrix3<f64>, Vector3<f64>); 14];

/// Rotations of pelvis … head, of both arms and of a cane, and their centres of mass against the pelvis' origin, facing along z.
fn posture(
    body: &Body,
    trunk: &[rotations::Euler; 5],
    arms: &[[f64; 2]; 2],
    cane: [f64; 2],
    carriage: ArmCarriage,
) -> Parted {
    let mut parts = [(Matrix3::zeros(), Vector3::zeros()); 14];
    let rotations = trunk.map(rotations::matrix);
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
    for (side, (arm, angles)) in body.arms.iter().zip(arms).enumerate() {
        let chain = carriage.chain(side, &rotations[2], *angles);
        let mut origin = thorax_origin + rotations[2] * arm[0].offset;
        for (i, (segment, rotation)) in arm.iter().zip(&chain).enumerate() {
            if i > 0 {
                origin += chain[i - 1] * segment.offset;
            }
            parts[5 + 4 * side + i] = (*rotation, origin + rotation * segment.com);
        }
        if let Some(held) = body.cane.filter(|held| held.side == side) {
            let rotation = chain[3] * Cane::rotation(cane);
            parts[13] = (rotation, origin + chain[3] * held.segment.offset + rotation * held.segment.com);
        }
    }
    parts
}
