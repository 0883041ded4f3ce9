//! The page's world: x left, y up, z forward.

use glam::{DMat3, DQuat, DVec3};
use nalgebra::{Matrix3, Vector3};

/// Below this gravity counts as none (m/s²).
const NO_GRAVITY: f64 = 1e-9;
/// Sine of the least angle between forward and up.
const LEAST: f64 = 0.1;

/// The turn from the motion's world to the page's.
#[derive(Clone, Copy, Debug)]
pub(crate) struct World {
    turn: DQuat,
}

impl World {
    /// Up is against `gravity` (m/s²), or y; forward is as told, or z, or x where z is within 45° of the vertical.
    pub(crate) fn new(gravity: &Vector3<f64>, forward: Option<&Vector3<f64>>) -> Self {
        let up = if gravity.norm() > NO_GRAVITY { -vector(gravity).normalize() } else { DVec3::Y };
        let usual = if up.z.abs() > std::f64::consts::FRAC_1_SQRT_2 { DVec3::X } else { DVec3::Z };
        // What points up or nowhere is no way forward.
        let told = forward.map(vector).filter(|told| up.cross(*told).length() > LEAST * told.length());
        let forward = told.unwrap_or(usual);
        let left = up.cross(forward).normalize();
        // The rows are the page's axes in the motion's world.
        let turn = DMat3::from_cols(left, up, left.cross(up)).transpose();
        Self { turn: DQuat::from_mat3(&turn) }
    }

    /// A position (m) or another vector.
    pub(crate) fn vector(&self, v: &Vector3<f64>) -> DVec3 {
        self.turn * vector(v)
    }

    /// A vector of the page's world in the motion's own.
    pub(crate) fn own(&self, shown: [f64; 3]) -> Vector3<f64> {
        let own = self.turn.conjugate() * DVec3::from_array(shown);
        Vector3::new(own.x, own.y, own.z)
    }

    /// An orientation.
    pub(crate) fn rotation(&self, rotation: &Matrix3<f64>) -> DQuat {
        (self.turn * DQuat::from_mat3(&DMat3::from_cols_slice(rotation.as_slice()))).normalize()
    }

    /// Whether up is the motion's y and forward its z, so that numbers are the motion's own.
    pub(crate) fn is_identity(&self) -> bool {
        self.turn.angle_between(DQuat::IDENTITY) < 1e-12
    }
}

fn vector(v: &Vector3<f64>) -> DVec3 {
    DVec3::new(v.x, v.y, v.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_world_of_generated_figures_is_the_page_s() {
        assert!(World::new(&Vector3::new(0.0, -9.81, 0.0), None).is_identity());
        assert!(World::new(&Vector3::zeros(), None).is_identity());
    }

    #[test]
    fn a_world_with_z_up_goes_forward_along_x() {
        let world = World::new(&Vector3::new(0.0, 0.0, -9.81), None);
        let near =
            |a: Vector3<f64>, b: DVec3| assert!(world.vector(&a).distance(b) < 1e-12, "{}", world.vector(&a));
        near(Vector3::x(), DVec3::Z);
        near(Vector3::y(), DVec3::X);
        near(Vector3::z(), DVec3::Y);
        let turned = world.rotation(&Matrix3::identity()) * DVec3::X;
        assert!(turned.distance(DVec3::Z) < 1e-12);
    }

    #[test]
    fn forward_is_as_told_unless_that_is_up() {
        let gravity = Vector3::new(0.0, -9.81, 0.0);
        let world = World::new(&gravity, Some(&Vector3::x()));
        assert!(world.vector(&Vector3::x()).distance(DVec3::Z) < 1e-12);
        assert!(world.vector(&Vector3::z()).distance(-DVec3::X) < 1e-12, "right is -x");
        assert!(World::new(&gravity, Some(&Vector3::y())).is_identity());
        assert!(World::new(&gravity, Some(&Vector3::zeros())).is_identity());
    }

    #[test]
    fn up_stays_up_when_gravity_is_inclined() {
        let gravity = Vector3::new(1.0, -9.0, 2.0);
        let world = World::new(&gravity, None);
        assert!(world.vector(&(-gravity.normalize())).distance(DVec3::Y) < 1e-12);
    }
}
