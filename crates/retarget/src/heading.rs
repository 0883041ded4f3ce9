//! The frame in which two skeletons stand alike: x left, y up, z forward, as each one's own hips and feet have it.

use crate::error::RetargetError;
use crate::roles::Roles;
use crate::skeleton::Skeleton;
use solaris_model::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// A skeleton that stands within this (rad) of the world's own axes looks along them; hips are rarely measured better.
const NEAR: f64 = 0.17;

/// The turn from a skeleton's world to the frame x left, y up, z forward, at rest.
///
/// Up is the world's axis along which hips are above ankles, left goes from the right hip to the left one.
pub(crate) fn heading(skeleton: &Skeleton, roles: &Roles) -> Result<UnitQuaternion<f64>, RetargetError> {
    let refuse = |why| RetargetError::Rest { skeleton: skeleton.name.clone(), why };
    let at = |bone: usize| skeleton.bones[bone].rest.translation.vector;
    let [left, right] = &roles.sides;
    let legs = at(left.thigh) + at(right.thigh) - at(left.foot) - at(right.foot);
    let axis = legs.iamax();
    if !(legs.amax() > 0.8 * legs.norm() && legs.amax() > 0.0) {
        return Err(refuse("its legs do not point along an axis of its world"));
    }
    let up = Vector3::ith(axis, legs[axis].signum());
    let across = at(left.thigh) - at(right.thigh);
    let across = across - up * across.dot(&up);
    let Some(mut across) = across.try_normalize(1e-9 * legs.norm()) else {
        return Err(refuse("its hips are at one place, or one above the other"));
    };
    let main = Vector3::ith(across.iamax(), across[across.iamax()].signum());
    if across.angle(&main) < NEAR {
        across = main;
    }
    let rows = Matrix3::from_rows(&[across.transpose(), up.transpose(), across.cross(&up).transpose()]);
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rows));
    let forward: f64 = roles
        .sides
        .iter()
        .filter_map(|limbs| limbs.toes.map(|toes| (turn * (at(toes) - at(limbs.foot))).z))
        .sum();
    if forward < -1e-3 * legs.norm() {
        return Err(refuse("its toes point backward, so its left and right are exchanged, or its hips are"));
    }
    Ok(turn)
}
