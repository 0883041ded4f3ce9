//! Leg and foot.

use super::sizes::Sizes;
use super::{Side, solid};
use crate::field::{Form, Loft, Section, Solid};
use nalgebra::{UnitQuaternion, Vector3};

/// Sections: thigh (0) or shank (1), share of its length from the joint, reaches to the outside, inside, front, back (m).
#[rustfmt::skip]
const SECTIONS: [(usize, f64, [f64; 4]); 17] = [
    (0, -0.16, [0.051, 0.051, 0.051, 0.061]),
    (0, -0.05, [0.079, 0.067, 0.075, 0.086]),
    (0, 0.06, [0.090, 0.080, 0.089, 0.096]),
    (0, 0.20, [0.092, 0.084, 0.093, 0.093]),
    (0, 0.40, [0.085, 0.079, 0.089, 0.086]),
    (0, 0.62, [0.073, 0.068, 0.079, 0.072]),
    (0, 0.84, [0.058, 0.056, 0.061, 0.057]),
    (0, 0.97, [0.054, 0.055, 0.058, 0.051]),
    (1, 0.06, [0.052, 0.053, 0.054, 0.051]),
    (1, 0.16, [0.053, 0.053, 0.047, 0.061]),
    (1, 0.30, [0.055, 0.056, 0.045, 0.068]),
    (1, 0.46, [0.051, 0.050, 0.043, 0.061]),
    (1, 0.64, [0.042, 0.040, 0.039, 0.048]),
    (1, 0.80, [0.036, 0.034, 0.036, 0.040]),
    (1, 0.92, [0.035, 0.033, 0.036, 0.038]),
    (1, 0.99, [0.035, 0.034, 0.036, 0.037]),
    (1, 1.00, [0.035, 0.034, 0.036, 0.037]),
];

/// Sections of the shoe from the heel to the toes: place before the ankle, how high over the sole its widest is, reaches to the
/// outside, inside and up (m).
#[rustfmt::skip]
const SHOE: [(f64, [f64; 3]); 9] = [
    (-0.036, [0.026, 0.026, 0.040]),
    (-0.012, [0.033, 0.032, 0.062]),
    (0.020, [0.035, 0.034, 0.070]),
    (0.060, [0.038, 0.036, 0.058]),
    (0.100, [0.045, 0.041, 0.040]),
    (0.140, [0.050, 0.046, 0.028]),
    (0.170, [0.048, 0.045, 0.021]),
    (0.190, [0.040, 0.040, 0.017]),
    (0.200, [0.031, 0.034, 0.015]),
];
/// Height of the shoe's widest line over the sole (m).
const WELT: f64 = 0.020;

/// Sections along two links that hang straight below each other, in the order of their places; each as thick as the links are there.
pub(super) fn along(
    sizes: &Sizes<'_>,
    side: Side,
    links: &[String; 2],
    sections: &[(usize, f64, [f64; 4])],
) -> Vec<Section> {
    let lengths = [sizes.length(&links[0]), sizes.length(&links[1])];
    let thick = [0, 1].map(|i| sizes.thick(&links[i]).0);
    let place =
        |segment: usize, share: f64| share * lengths[segment] + if segment == 0 { 0.0 } else { lengths[0] };
    let (upper, lower) = (place(0, 0.5), place(1, 0.5));
    let section = |&(segment, share, reach): &(usize, f64, [f64; 4])| {
        let y = place(segment, share);
        let t = ((y - upper) / (lower - upper)).clamp(0.0, 1.0);
        let factor = thick[0] + (thick[1] - thick[0]) * t;
        Section(-y, side.reach(reach.map(|reach| reach * factor)))
    };
    sections.iter().rev().map(section).collect()
}

/// The turn, in the frame of the first link, after which −y points to the last one's joint.
pub(super) fn hang(sizes: &Sizes<'_>, first: &str, last: &str) -> UnitQuaternion<f64> {
    let way = sizes.place(first).inverse_transform_point(&sizes.joint(last).into()).coords;
    UnitQuaternion::rotation_between(&-Vector3::y(), &way).unwrap_or_default()
}

pub(super) fn solids(sizes: &Sizes<'_>, side: Side) -> Vec<Solid> {
    let links = ["thigh", "shank"].map(|link| side.name(link));
    let sections = along(sizes, side, &links, &SECTIONS);
    let loft = Loft::new(sections, [0.02 * sizes.tall, 0.05 * sizes.tall], 0.12);
    let foot = side.name("foot");
    let turn = hang(sizes, &links[0], &foot);
    let leg = solid(sizes, &links[0], Form::Loft(loft), Vector3::zeros(), turn, 0.01);
    vec![leg, shoe(sizes, side, &foot)]
}

fn shoe(sizes: &Sizes<'_>, side: Side, foot: &str) -> Solid {
    let scale = sizes.long(foot);
    let sole = sizes.joint(foot).y + sizes.sole(foot);
    // The sections follow each other along z: their y is turned to it, and their z downwards.
    let forward = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::FRAC_PI_2);
    let section = |(at, [out, inwards, up]): (f64, [f64; 3])| {
        Section(at * scale, side.reach([out, inwards, WELT * 1.25, up]).map(|reach| reach * scale))
    };
    let loft = Loft::new(SHOE.map(section).to_vec(), [0.016 * scale, 0.012 * scale], 0.45);
    let at = Vector3::new(0.0, sizes.sole(foot) + WELT * scale, 0.0);
    let shoe = solid(sizes, foot, Form::Loft(loft), at, forward, 0.022);
    let mut ground = sizes.joint(foot);
    ground.y = sole;
    shoe.cut(ground, -Vector3::y())
}
