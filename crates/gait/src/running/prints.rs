//! Where the feet press over a periodic stride, and the moments of their vertical forces.

use super::laws::{ForceLaws, StanceLaws, on_ground};
use super::style::RunStyle;
use crate::body::foot::{FootPlane, mirror};
use nalgebra::Vector3;

/// Centre of pressure of the left foot at the part `part` of its stance, whose print's heel stands at z = 0 (m).
pub(super) fn left_pressure(style: &RunStyle, laws: &ForceLaws, foot_length: f64, part: f64) -> Vector3<f64> {
    let along = FootPlane::new(style.foot_yaw).forward * (laws.pressure(part) * foot_length);
    Vector3::new(style.step_width / 2.0, 0.0, 0.0) + along
}

/// A foot at a node of the stride.
#[derive(Clone, Copy, Debug)]
pub(super) struct Print {
    /// Its laws.
    pub(super) laws: StanceLaws,
    pub(super) stands: bool,
    /// Its centre of pressure in the frame that moves with the run (m).
    pub(super) pressure: Vector3<f64>,
}

/// Left and right foot at the nodes of a stride: left contact at u = 0, right at u = ½ one step ahead.
pub(super) fn prints(style: &RunStyle, laws: &ForceLaws, foot_length: f64, nodes: usize) -> Vec<[Print; 2]> {
    let (half, step) = (nodes / 2, style.step_length);
    let clock = |node: usize| node as f64 / nodes as f64;
    let left = |node: usize| {
        let part = clock(node) / style.duty;
        (laws.at(part), on_ground(part), left_pressure(style, laws, foot_length, part))
    };
    let node = |node: usize| {
        let moved = Vector3::z() * (2.0 * step * clock(node));
        let ((laws, stands, pressure), other) = (left(node), left((node + half) % nodes));
        let ahead = Vector3::z() * if clock(node) < 0.5 { -step } else { step };
        [
            Print { laws, stands, pressure: pressure - moved },
            Print { laws: other.0, stands: other.1, pressure: mirror(&other.2) + ahead - moved },
        ]
    };
    (0..nodes).map(node).collect()
}
