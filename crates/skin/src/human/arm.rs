//! Arm and hand.

use super::digits::digits;
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

pub(super) fn solids(sizes: &Sizes<'_>, side: Side) -> Vec<Solid> {
    let links = ["upper_arm", "forearm"].map(|link| side.name(link));
    let mut sections = super::leg::along(sizes, side, &links, &SECTIONS);
    // Wrists are between as thick as the forearm and as broad as the hand.
    let slim = (sizes.long(&side.name("hand")) / sizes.thick(&links[1]).0).sqrt();
    for (section, (link, share, _)) in sections.iter_mut().zip(SECTIONS.iter().rev()) {
        let near = if *link == 1 { ((share - 0.45) / 0.45).clamp(0.0, 1.0) } else { 0.0 };
        section.1 = section.1.map(|reach| reach * (1.0 + (slim - 1.0) * near));
    }
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
        (-0.087, [0.0092, 0.0110, 0.0372, 0.0325]),
        (-0.080, [0.0120, 0.0135, 0.0400, 0.0365]),
        (-0.055, [0.0140, 0.0155, 0.0375, 0.0375]),
        (-0.028, [0.0155, 0.0175, 0.0310, 0.0320]),
        (-0.006, [0.0170, 0.0178, 0.0262, 0.0252]),
        (0.012, [0.0165, 0.0170, 0.0245, 0.0232]),
    ];
    let section = |(y, reach): (f64, [f64; 4])| Section(y * scale, side.reach(reach.map(|r| r * scale)));
    let loft = Loft::new(palm.map(section).to_vec(), [0.009 * scale, 0.012 * scale], 0.25);
    let mut solids = vec![solid(sizes, &link, Form::Loft(loft), Vector3::zeros(), upright, 0.012)];
    // The ball of the thumb, along its metacarpal.
    let [from, to] = [[-0.006, -0.022, 0.022], [-0.019, -0.058, 0.045]].map(|p| side.vector(p, scale));
    let turn = UnitQuaternion::rotation_between(&Vector3::y(), &(to - from)).unwrap_or(upright);
    let ball = Cone::new(0.0150 * scale, 0.0104 * scale, (to - from).norm());
    solids.push(solid(sizes, &link, Form::Cone(ball), from, turn, 0.014));
    solids.extend(digits(sizes, side).iter().map(|digit| digit.solid(sizes, side)));
    solids
}
