//! The head: skull, jaw, face, ears, hair.

use super::eyes::{CENTRE, RADIUS};
use super::sizes::Sizes;
use super::{SIDES, solid};
use crate::field::{Cone, Form, Loft, Section, Solid};
use nalgebra::{UnitQuaternion, Vector3};

/// Sections from the chin to the crown: height over the head's joint, half the breadth, how far to the front and to the back of
/// [`AXIS`] (m).
#[rustfmt::skip]
const SECTIONS: [[f64; 4]; 8] = [
    [-0.031, 0.027, 0.078, 0.026],
    [-0.014, 0.042, 0.085, 0.044],
    [ 0.010, 0.054, 0.0875, 0.066],
    [ 0.034, 0.0625, 0.088, 0.083],
    [ 0.058, 0.068, 0.0885, 0.093],
    [ 0.084, 0.0715, 0.092, 0.098],
    [ 0.104, 0.0738, 0.0935, 0.100],
    [ 0.114, 0.0742, 0.0935, 0.100],
];
/// How far the axis of the sections is before the head's joint (m).
const AXIS: f64 = 0.022;
/// How thick hair is (m).
const HAIR: f64 = 0.005;

/// A plane under the hair, in the head's frame: a point, and the way out of it. It runs from the forehead to the nape.
pub(super) const HAIRLINE: ([f64; 3], [f64; 3]) = ([0.0, 0.128, 0.104], [0.0, -0.80, 0.60]);

pub(super) fn solids(sizes: &Sizes<'_>) -> Vec<Solid> {
    let size = sizes.head();
    let (long, wide) = (size.y, size.x);
    let at = |p: [f64; 3]| Vector3::from(p).component_mul(&size);
    let upright = UnitQuaternion::identity();
    let loft = |more: f64| {
        let section = |[y, side, front, back]: [f64; 4]| {
            Section(y * long, [side, side, front, back].map(|reach| (reach + more) * wide))
        };
        Form::Loft(Loft::new(SECTIONS.map(section).to_vec(), [0.009 * long, (0.063 + more) * long], 0.18))
    };
    let axis = at([0.0, 0.0, AXIS]);
    let mut solids = vec![solid(sizes, "head", loft(0.0), axis, upright, 0.018)];
    let cone = |from: [f64; 3], to: [f64; 3], radii: [f64; 2], blend: f64| {
        let (from, to) = (at(from), at(to));
        let turn = UnitQuaternion::rotation_between(&Vector3::y(), &(to - from)).unwrap_or(upright);
        let form = Cone::new(radii[0] * wide, radii[1] * wide, (to - from).norm());
        solid(sizes, "head", Form::Cone(form), from, turn, blend)
    };
    // Nose and chin.
    solids.push(cone([0.0, 0.078, 0.108], [0.0, 0.036, 0.126], [0.0062, 0.0088], 0.010));
    solids.push(cone([0.0, -0.024, 0.092], [0.0, -0.018, 0.092], [0.013, 0.013], 0.025));
    for side in SIDES {
        let x = side.out;
        // Nostril, lips.
        solids.push(cone([x * 0.0105, 0.0345, 0.112], [x * 0.0115, 0.036, 0.104], [0.0054, 0.0060], 0.010));
        solids.push(cone([x * 0.003, 0.0132, 0.1080], [x * 0.022, 0.0090, 0.0985], [0.0044, 0.0020], 0.006));
        solids.push(cone([x * 0.003, 0.0022, 0.1065], [x * 0.019, 0.0068, 0.0985], [0.0056, 0.0022], 0.006));
        // Brow, cheekbone, jaw.
        solids.push(cone([x * 0.012, 0.088, 0.108], [x * 0.050, 0.086, 0.086], [0.0060, 0.0055], 0.014));
        solids.push(cone([x * 0.034, 0.045, 0.088], [x * 0.054, 0.054, 0.062], [0.012, 0.011], 0.03));
        solids.push(cone([x * 0.046, 0.004, 0.022], [x * 0.018, -0.023, 0.082], [0.010, 0.011], 0.022));
    }
    for side in SIDES {
        let ball = |[x, y, z]: [f64; 3], radii: [f64; 3], turn: Vector3<f64>, blend: f64| {
            let form = Form::Cone(Cone::ellipsoid(Vector3::from(radii) * wide));
            let turn = UnitQuaternion::from_scaled_axis(turn);
            solid(sizes, "head", form, at([side.out * x, y, z]), turn, blend)
        };
        solids.push(ball([0.033, 0.066, 0.116], [0.016, 0.009, 0.015], Vector3::zeros(), 0.012).carve());
        // Lids, and the opening between them.
        solids.push(ball(CENTRE, [RADIUS + 0.0016; 3], Vector3::zeros(), 0.006));
        let [x, y, z] = CENTRE;
        let slant = Vector3::z() * (side.out * 0.07);
        solids.push(ball([x, y - 0.0007, z + 0.0185], [0.0165, 0.0056, 0.0160], slant, 0.0014).carve());
        let tilt = Vector3::new(-0.20, side.out * 0.35, -side.out * 0.12);
        solids.push(ball([0.075, 0.052, 0.012], [0.007, 0.031, 0.018], tilt, 0.006));
        solids.push(ball([0.0820, 0.058, 0.020], [0.005, 0.015, 0.008], tilt, 0.005).carve());
    }
    // Between the lips.
    for side in SIDES {
        let [from, to] = [[0.0, 0.0082, 0.1168], [side.out * 0.0235, 0.0084, 0.1048]];
        solids.push(cone(from, to, [0.0042, 0.0034], 0.003).carve());
    }
    let place = sizes.place("head");
    let (point, towards) = HAIRLINE;
    let point = place.rotation * at(point) + place.translation.vector;
    let hair = solid(sizes, "head", loft(HAIR), axis, upright, 0.006);
    solids.push(hair.cut(point, Vector3::from(towards)));
    solids
}
