//! Eyes: balls that look ahead out of the openings that the lids leave.

use super::sizes::Sizes;
use super::{SIDES, Side};
use crate::Detail;
use crate::mesh::{Influence, Part, Skin};
use crate::palette::{IRIS, PUPIL, WHITE, within};
use nalgebra::{Point3, Vector3};
use std::f64::consts::{PI, TAU};

/// Where the middle of an eye is in the head's frame, x outwards, and its radius (m): pupils are 64 mm apart and eyes 24 mm wide, as about
/// those of people.
pub(super) const CENTRE: [f64; 3] = [0.032, 0.066, 0.0905];
pub(super) const RADIUS: f64 = 0.012;

/// Rings from the way that the eye looks to its back: angle (rad) and place in the strip. Pupil and iris are 4.5 and 11.7 mm wide.
const RINGS: [(f64, f32); 6] = [
    (0.188, within(PUPIL, 0.0)),
    (0.340, within(IRIS, 0.5)),
    (0.509, within(IRIS, 0.0)),
    (0.85, within(WHITE, 0.5)),
    (1.35, within(WHITE, 0.3)),
    (2.20, within(WHITE, 0.3)),
];

/// Adds the eyes to a skin that has them as parts, each closed by itself.
pub(super) fn add(skin: &mut Skin, sizes: &Sizes<'_>, detail: Detail) {
    let sectors = match detail {
        Detail::Rough => 8,
        Detail::Coarse => 12,
        Detail::Fine => 16,
    };
    // Parts end with them.
    for part in skin.parts.len() - SIDES.len()..skin.parts.len() {
        eye(skin, sizes, part, sectors);
    }
}

/// An eye as a part.
pub(super) fn part(sizes: &Sizes<'_>, side: Side) -> Part {
    let at = side.vector(CENTRE, 1.0).component_mul(&sizes.head());
    Part { name: side.name("eye"), link: sizes.index("head"), parent: None, at }
}

fn eye(skin: &mut Skin, sizes: &Sizes<'_>, part: usize, sectors: u32) {
    let (radius, place) = (RADIUS * sizes.head().x, sizes.place("head"));
    let (link, centre) = (skin.parts[part].link, skin.parts[part].at);
    let first = skin.points.len() as u32;
    let part = (skin.bind.len() + part) as u16;
    let mut vertex = |way: Vector3<f64>, colour: f32| {
        let goes = |link: u16| {
            let mut all = [Influence::default(); 4];
            all[0] = Influence { link, share: 1.0 };
            all
        };
        skin.fine.push((skin.points.len() as u32, goes(part)));
        skin.points.push((place * Point3::from(centre + way * radius)).coords);
        skin.normals.push(place.rotation * way);
        skin.colours.push(colour);
        skin.influences.push(goes(link as u16));
    };
    vertex(Vector3::z(), within(PUPIL, 0.5));
    for (angle, colour) in RINGS {
        for sector in 0..sectors {
            let (sin, cos) = (TAU * f64::from(sector) / f64::from(sectors)).sin_cos();
            vertex(Vector3::new(angle.sin() * cos, angle.sin() * sin, angle.cos()), colour);
        }
    }
    vertex(Vector3::new(0.0, 0.0, PI.cos()), within(WHITE, 0.3));
    let at = |ring: u32, sector: u32| first + 1 + ring * sectors + sector % sectors;
    let rings = RINGS.len() as u32;
    for sector in 0..sectors {
        skin.triangles.push([first, at(0, sector), at(0, sector + 1)]);
        for ring in 1..rings {
            let [a, b] = [sector, sector + 1].map(|sector| at(ring - 1, sector));
            let [c, d] = [sector, sector + 1].map(|sector| at(ring, sector));
            skin.triangles.extend([[a, c, d], [a, d, b]]);
        }
        skin.triangles.push([first + 1 + rings * sectors, at(rings - 1, sector + 1), at(rings - 1, sector)]);
    }
}
