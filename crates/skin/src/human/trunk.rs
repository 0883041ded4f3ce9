//! Trunk and neck.

use super::sizes::Sizes;
use super::{SIDES, solid};
use crate::field::{Cone, Form, Loft, Section, Solid};
use nalgebra::{UnitQuaternion, Vector3};

/// Sections from the crotch to under the jaw: height over the pelvis' origin, half the breadth, how far to the front and
/// to the back of [`AXIS`] (m).
#[rustfmt::skip]
const SECTIONS: [[f64; 4]; 16] = [
    [-0.100, 0.100, 0.066, 0.080],
    [-0.070, 0.150, 0.088, 0.098],
    [-0.020, 0.166, 0.100, 0.102],
    [ 0.030, 0.160, 0.106, 0.094],
    [ 0.080, 0.149, 0.109, 0.083],
    [ 0.130, 0.144, 0.109, 0.078],
    [ 0.190, 0.147, 0.109, 0.086],
    [ 0.250, 0.154, 0.112, 0.099],
    [ 0.310, 0.162, 0.114, 0.109],
    [ 0.360, 0.166, 0.108, 0.113],
    [ 0.400, 0.158, 0.088, 0.106],
    [ 0.430, 0.120, 0.064, 0.092],
    [ 0.455, 0.072, 0.046, 0.076],
    [ 0.480, 0.056, 0.041, 0.065],
    [ 0.515, 0.053, 0.042, 0.058],
    [ 0.560, 0.052, 0.045, 0.056],
];
/// How far the axis of the sections is before the pelvis' origin (m).
const AXIS: f64 = -0.015;

pub(super) fn solids(sizes: &Sizes<'_>) -> Vec<Solid> {
    let upright = UnitQuaternion::identity();
    let section = |[y, wide, front, back]: [f64; 4]| {
        let (breadth, depth) = thick(sizes, y);
        Section(sizes.height(y), [wide * breadth, wide * breadth, front * depth, back * depth])
    };
    let caps = [0.05 * sizes.tall, 0.03 * sizes.tall];
    let loft = Loft::new(SECTIONS.map(section).to_vec(), caps, 0.35);
    let axis = Vector3::new(0.0, 0.0, AXIS * sizes.tall);
    let mut solids = vec![solid(sizes, "pelvis", Form::Loft(loft), axis, upright, 0.02)];
    for side in SIDES {
        // A ball of the trunk at a place of the reference, as thick as the trunk is there.
        let ball = |at: [f64; 3], radii: [f64; 3], blend: f64| {
            let (breadth, depth) = thick(sizes, at[1]);
            let radii = Vector3::new(radii[0] * breadth, radii[1] * sizes.tall, radii[2] * depth);
            let at = Vector3::new(
                side.out * at[0] * breadth,
                sizes.height(at[1]),
                axis.z + (at[2] - AXIS) * depth,
            );
            solid(sizes, "pelvis", Form::Cone(Cone::ellipsoid(radii)), at, upright, blend)
        };
        solids.push(ball([0.072, -0.085, -0.070], [0.074, 0.080, 0.062], 0.03));
        solids.push(ball([0.078, 0.330, 0.062], [0.080, 0.058, 0.032], 0.05));
        // Shoulder blades and the slope from the neck to the shoulder.
        solids.push(ball([0.090, 0.345, -0.088], [0.060, 0.085, 0.036], 0.04));
        let (_, depth) = thick(sizes, 0.43);
        let from = Vector3::new(side.out * 0.030 * depth, sizes.height(0.468), -0.042 * sizes.tall);
        let to =
            sizes.joint(&side.name("upper_arm")) + Vector3::new(-side.out * 0.020, 0.004, 0.0) * sizes.tall;
        let along = to - from;
        let turn = UnitQuaternion::rotation_between(&Vector3::y(), &along).unwrap_or(upright);
        let slope = Cone::new(0.038 * depth, 0.036 * depth, along.norm());
        solids.push(solid(sizes, "pelvis", Form::Cone(slope), from, turn, 0.035));
    }
    solids
}

/// Breadth and depth at a height of the reference, over its own: between those of the links there.
pub(super) fn thick(sizes: &Sizes<'_>, y: f64) -> (f64, f64) {
    const MIDDLES: [(f64, &str); 4] =
        [(-0.02, "pelvis"), (0.15, "abdomen"), (0.34, "thorax"), (0.50, "neck")];
    let above = MIDDLES.iter().position(|(middle, _)| *middle >= y).unwrap_or(MIDDLES.len() - 1).max(1);
    let (low, high) = (MIDDLES[above - 1], MIDDLES[above]);
    let t = ((y - low.0) / (high.0 - low.0)).clamp(0.0, 1.0);
    let (a, b) = (sizes.thick(low.1), sizes.thick(high.1));
    (a.0 + (b.0 - a.0) * t, a.1 + (b.1 - a.1) * t)
}
