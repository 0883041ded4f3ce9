//! How bones' own axes lie at rest, where a rig's own characters have them otherwise than along the world's.
//!
//! One axis of a bone goes along it (`along`: that axis, backwards where it has a minus) to the joint of the link that is named by `toward`, to its `tip`, straight `up`,
//! or of a finger to its `next` bone; another one (`side`) lies as near to a direction of the world as it can (`to`).
//!
//! # Source
//!
//! Mixamo: rest rotations of its X Bot, as its FBX has them. Unreal: local rest rotations of the mannequin of UEFN, taken into glTF's axes as
//! Unreal's own exporter takes them ((x, y, z) there is (x, z, y) here, of bones' frames as of the world). Right bones are there the mirror image of
//! left ones with all three axes turned round.

use super::Rig;
use solaris_model::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// The axes of each bone by the link that it is; `left_finger` are all bones of the left hand's fingers.
const AXES: &str = include_str!("axes.csv");

/// Two axes of a bone: where the one goes, and near to what the other one is.
pub(super) struct Axes {
    along: (usize, f64),
    /// The name of the link to whose joint it goes, `tip`, `up` or `next`.
    pub(super) toward: &'static str,
    side: usize,
    to: Vector3<f64>,
}

impl Axes {
    /// Those of a rig's bone that is this link of a person, if they are not the world's.
    pub(super) fn find(rig: Rig, link: &str) -> Option<Self> {
        AXES.lines().skip(1).find_map(|row| {
            let mut cells = row.split(',');
            let mut cell = || cells.next();
            if (cell()?, cell()?) != (rig.name(), link) {
                return None;
            }
            let (along, toward, side, to) = (cell()?, cell()?, cell()?, cell()?);
            let sign = if along.starts_with('-') { -1.0 } else { 1.0 };
            let along = (axis(along.trim_start_matches('-'))?, sign);
            Some(Self { along, toward, side: axis(side)?, to: direction(to)? })
        })
    }

    /// The bone's frame in the world at rest, where it goes along `way`; the world's own where that has no direction of its own.
    pub(super) fn frame(&self, way: Option<Vector3<f64>>) -> UnitQuaternion<f64> {
        let way = if self.toward == "up" { Some(Vector3::y()) } else { way };
        let along = way.and_then(|way| way.try_normalize(1e-9));
        let both = along.and_then(|along| {
            let side = self.to - along * along.dot(&self.to);
            Some((along * self.along.1, side.try_normalize(1e-6)?))
        });
        let Some((along, side)) = both else { return UnitQuaternion::identity() };
        let (first, second) = (self.along.0, self.side);
        let mut columns = [Vector3::zeros(); 3];
        columns[first] = along;
        columns[second] = side;
        let third = if (first + 1) % 3 == second { along.cross(&side) } else { side.cross(&along) };
        columns[3 - first - second] = third;
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(Matrix3::from_columns(
            &columns,
        )))
    }
}

fn axis(name: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|axis| *axis == name)
}

fn direction(name: &str) -> Option<Vector3<f64>> {
    Some(match name {
        "left" => Vector3::x(),
        "right" => -Vector3::x(),
        "up" => Vector3::y(),
        "down" => -Vector3::y(),
        "front" => Vector3::z(),
        "back" => -Vector3::z(),
        _ => return None,
    })
}
