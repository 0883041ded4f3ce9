//! Where a foot stands.

use crate::body::foot::{mirror, turned};
use nalgebra::Vector3;

/// A foot's print on level ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Print {
    /// Its heel (m).
    pub(super) heel: Vector3<f64>,
    /// Which way it points, without the outward turn that feet have straight on (rad, to the left of z).
    pub(super) heading: f64,
}

impl Print {
    /// A point of the world as a left foot on this print has it, its heel at the origin; a right foot's is mirrored.
    #[inline]
    pub(super) fn local(&self, side: usize, point: &Vector3<f64>) -> Vector3<f64> {
        seen(side, &turned(-self.heading, &(point - self.heel)))
    }

    /// The point of the world.
    #[inline]
    pub(super) fn world(&self, side: usize, local: &Vector3<f64>) -> Vector3<f64> {
        self.heel + turned(self.heading, &seen(side, local))
    }
}

/// A vector of a side as one of the left side, and back.
#[inline]
pub(super) fn seen(side: usize, v: &Vector3<f64>) -> Vector3<f64> {
    if side == 0 { *v } else { mirror(v) }
}

/// 1 to the left, −1 to the right.
#[inline]
pub(super) fn sign(side: usize) -> f64 {
    if side == 0 { 1.0 } else { -1.0 }
}
