//! Arm and hand.

use super::sizes::Sizes;
use super::{Side, solid};
use crate::field::{Cone, Form, Loft, Section, Solid};
use nalgebra::{UnitQuaternion, Vector3};

/// Sections: upper arm (0) or forearm (1), share of its length from the joint, reaches to the outside, inside, front, back (m).
#[rustfmt::skip]
const SECTIONS: [(usize, f64, [f64; 4]); 13] = [
    (0, 0.00, [0.046, 0.046, 0.046, 0.048]),
    (0, 0.12, [0.053, 0.046, 0.051, 0.052]),
    (0, 0.30, [0.051, 0.044, 0.050, 0.051]),
    (0, 0.55, [0.044, 0.042, 0.048, 0.046]),
    (0, 0.80, [0.040, 0.039, 0.041, 0.041]),
    (0, 1.00, [0.040, 0.039, 0.038, 0.040]),
    (1, 0.10, [0.042, 0.039, 0.042, 0.040]),
    (1, 0.24, [0.042, 0.038, 0.043, 0.041]),
    (1, 0.45, [0.036, 0.034, 0.039, 0.036]),
    (1, 0.65, [0.029, 0.028, 0.033, 0.031]),
    (1, 0.85, [0.022, 0.022, 0.029, 0.027]),
    (1, 0.97, [0.0195, 0.0195, 0.028, 0.026]),
    (1, 1.00, [0.0195, 0.0195, 0.028, 0.026]),
];

/// Fingers from the index on: where they begin across the palm and along it, and the lengths of their bones (m).
#[rustfmt::skip]
const FINGERS: [(f64, f64, [f64; 3]); 4] = [
    (0.0285, -0.092, [0.038, 0.023, 0.019]),
    (0.0098, -0.096, [0.042, 0.027, 0.019]),
    (-0.0088, -0.093, [0.039, 0.025, 0.019]),
    (-0.0262, -0.086, [0.031, 0.019, 0.017]),
];
/// How far fingers bend towards the palm at each joint, as they do at rest (rad).
const CURL: [f64; 3] = [0.24, 0.38, 0.26];
/// Radii of fingers at their joints (m).
const FINGER: [f64; 4] = [0.0099, 0.0094, 0.0085, 0.0072];

pub(super) fn solids(sizes: &Sizes<'_>, side: Side) -> Vec<Solid> {
    let links = ["upper_arm", "forearm"].map(|link| side.name(link));
    let sections = super::leg::along(sizes, side, &links, &SECTIONS);
    let loft = Loft::new(sections, [0.015 * sizes.tall, 0.040 * sizes.tall], 0.15);
    let hang = super::leg::hang(sizes, &links[0], &side.name("hand"));
    let mut solids = vec![solid(sizes, &links[0], Form::Loft(loft), Vector3::zeros(), hang, 0.01)];
    solids.extend(hand(sizes, side));
    solids
}

fn hand(sizes: &Sizes<'_>, side: Side) -> Vec<Solid> {
    let link = side.name("hand");
    let scale = sizes.long(&link);
    let upright = UnitQuaternion::identity();
    // The palm looks inwards.
    let palm = [
        (-0.102, [0.0085, 0.0100, 0.038, 0.034]),
        (-0.086, [0.0125, 0.0135, 0.0405, 0.0375]),
        (-0.055, [0.0140, 0.0155, 0.0375, 0.0375]),
        (-0.028, [0.0155, 0.0175, 0.0310, 0.0320]),
        (-0.006, [0.0175, 0.0180, 0.0270, 0.0260]),
        (0.012, [0.0185, 0.0185, 0.0270, 0.0255]),
    ];
    let section = |(y, reach): (f64, [f64; 4])| Section(y * scale, side.reach(reach.map(|r| r * scale)));
    let loft = Loft::new(palm.map(section).to_vec(), [0.008 * scale, 0.012 * scale], 0.25);
    let mut solids = vec![solid(sizes, &link, Form::Loft(loft), Vector3::zeros(), upright, 0.012)];
    let mut bone = |from: Vector3<f64>, to: Vector3<f64>, radii: [f64; 2], blend: f64| {
        let turn = UnitQuaternion::rotation_between(&Vector3::y(), &(to - from));
        let turn =
            turn.unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
        let form = Cone::new(radii[0] * scale, radii[1] * scale, (to - from).norm());
        solids.push(solid(sizes, &link, Form::Cone(form), from, turn, blend));
    };
    for (across, along, lengths) in FINGERS {
        let mut at = side.vector([-0.001, along, across], scale);
        let mut bent = 0.06;
        for (k, length) in lengths.into_iter().enumerate() {
            bent += CURL[k];
            // Fingers lean together a little.
            let way = side.vector([-f64::sin(bent), -f64::cos(bent), -across * 0.9], 1.0).normalize();
            let next = at + way * (length * scale);
            bone(at, next, [FINGER[k], FINGER[k + 1]], if k == 0 { 0.006 } else { 0.0025 });
            at = next;
        }
    }
    let thumb =
        [[-0.006, -0.022, 0.022], [-0.019, -0.058, 0.045], [-0.026, -0.086, 0.054], [-0.030, -0.110, 0.053]];
    let radii = [0.0150, 0.0128, 0.0104, 0.0085];
    for k in 0..3 {
        let [from, to] = [thumb[k], thumb[k + 1]].map(|p| side.vector(p, scale));
        bone(from, to, [radii[k], radii[k + 1]], if k == 0 { 0.014 } else { 0.004 });
    }
    solids
}
