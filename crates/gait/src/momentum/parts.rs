//! Sums over segments that make a momentum.

use crate::body::Segment;
use nalgebra::{Matrix3, Vector3};

/// Sums over some segments, against the pelvis' origin.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Parts {
    /// `Σ m r`
    pub(crate) first: Vector3<f64>,
    /// `Σ m ṙ`
    pub(crate) rate: Vector3<f64>,
    /// `Σ (I ω + m r × ṙ)`
    pub(crate) angular: Vector3<f64>,
}

impl Parts {
    /// Adds a segment: its orientation and centre of mass, and their rates. The spin is `ω = ½ Σ eᵢ × ėᵢ` over the axes.
    pub(crate) fn add(
        &mut self,
        segment: &Segment,
        rotation: &Matrix3<f64>,
        rotation_rate: &Matrix3<f64>,
        com: &Vector3<f64>,
        com_rate: &Vector3<f64>,
    ) {
        let spin: Vector3<f64> =
            (0..3).map(|i| rotation.column(i).cross(&rotation_rate.column(i))).sum::<Vector3<f64>>() * 0.5;
        self.first += com * segment.mass;
        self.rate += com_rate * segment.mass;
        self.angular +=
            rotation * (segment.inertia * rotation.tr_mul(&spin)) + com.cross(com_rate) * segment.mass;
    }

    pub(crate) fn join(&mut self, other: &Self) {
        self.first += other.first;
        self.rate += other.rate;
        self.angular += other.angular;
    }
}

/// The angular momentum `I e + m r × (e × r)` of a segment, against the pelvis' origin, in a turn at 1 rad/s about the second axis.
pub(crate) fn turning(segment: &Segment, rotation: &Matrix3<f64>, com: &Vector3<f64>) -> Vector3<f64> {
    let about = segment.inertia * rotation.row(1).transpose();
    rotation * about
        + Vector3::new(-com.x * com.y, com.x * com.x + com.z * com.z, -com.z * com.y) * segment.mass
}
