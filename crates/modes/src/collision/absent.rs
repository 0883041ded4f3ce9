//! What stands where the feature `collide` is not built in: shapes that there are none of.

use nalgebra::{Isometry3, Vector3};

#[derive(Clone)]
pub(crate) enum Colliders {}

/// As in `solaris-collision`.
pub(crate) struct Touch {
    pub(crate) pair: usize,
    pub(crate) point: Vector3<f64>,
    pub(crate) normal: Vector3<f64>,
    pub(crate) gap: f64,
}

impl Colliders {
    pub(crate) fn touches(
        &mut self,
        _: impl Fn(usize) -> Isometry3<f64>,
        _: impl Fn(usize) -> f64,
        _: impl FnMut(&Touch),
    ) {
        match *self {}
    }

    pub(crate) fn pair(&self, _: usize) -> [(usize, f64); 2] {
        match *self {}
    }
}
