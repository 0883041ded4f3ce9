//! The body of a person.
//!
//! Its numbers are those of the figure that [`solaris_model::human()`] makes of 1.741 m and 73 kg, in the frames of its links; any other
//! person's body is as much longer and thicker, link by link, as the links' own lengths and shapes are. Girths and breadths
//! are about those of men and women of that size (ANSUR II), drawn plainly: nobody in particular.

mod arm;
mod colours;
mod digits;
mod eyes;
mod hang;
mod head;
mod joints;
mod leg;
mod sizes;
mod trunk;

use crate::Detail;
use crate::contour::{Zone, contour};
use crate::fair;
use crate::field::{Bounds, Field, Form, Group, Solid};
use crate::links;
use crate::mesh::{Part, Skin};
use crate::weights::influences;
use nalgebra::{Point3, UnitQuaternion, Vector3};
use sizes::Sizes;
use solaris_model::Figure;

/// Groups of solids, whose vertices are the trunk's and the limbs'.
const TRUNK: usize = 0;
const ARMS: [usize; 2] = [1, 2];
const LEGS: [usize; 2] = [3, 4];

/// A side of the body: the names of its links begin so, and x is outwards by this sign.
#[derive(Clone, Copy, Debug)]
struct Side {
    prefix: &'static str,
    out: f64,
}

const SIDES: [Side; 2] = [Side { prefix: "left_", out: 1.0 }, Side { prefix: "right_", out: -1.0 }];

impl Side {
    fn name(self, link: &str) -> String {
        format!("{}{link}", self.prefix)
    }

    /// A vector whose x is outwards, scaled.
    fn vector(self, v: [f64; 3], scale: f64) -> Vector3<f64> {
        Vector3::new(self.out * v[0], v[1], v[2]) * scale
    }

    /// Reaches to the outside, the inside, front and back as those to +x, −x, +z, −z.
    fn reach(self, [out, inwards, front, back]: [f64; 4]) -> [f64; 4] {
        if self.out > 0.0 { [out, inwards, front, back] } else { [inwards, out, front, back] }
    }
}

/// The skin of a figure that is a person of our making.
pub(crate) fn skin(figure: &Figure, detail: Detail) -> Option<Skin> {
    let sizes = Sizes::of(figure)?;
    let field = body(&sizes);
    let cells = match detail {
        Detail::Rough => 40.0,
        Detail::Coarse => 56.0,
        Detail::Fine => 74.0,
    };
    let cell = sizes.stature / cells;
    let mut polygons = contour(&field, cell, &zones(&sizes));
    let neighbours = fair::neighbours(&polygons);
    let (normals, groups) = fair::settle(&mut polygons, &neighbours, &field);
    let triangles = fair::triangles(&polygons);
    let bends = joints::bends(&sizes);
    let influences = influences(&polygons.points, &groups, &bends, figure.links().len(), &neighbours);
    let clothes = colours::Clothes::of(&sizes, cell / 8.0);
    let colours = polygons.points.iter().zip(&groups).map(|(p, group)| clothes.place(p, *group)).collect();
    let points = polygons.points;
    let bind = sizes.bind.clone();
    let mut skin = Skin {
        points,
        normals,
        colours,
        influences,
        triangles,
        bind,
        parts: parts(figure),
        ..Skin::default()
    };
    hang::hang(&mut skin, &groups, &neighbours, &sizes);
    eyes::add(&mut skin, &sizes, detail);
    for (at, link) in sizes.others() {
        links::add(&mut skin, link, at);
    }
    Some(skin)
}

/// The bones of its fingers and its eyes.
pub(crate) fn parts(figure: &Figure) -> Vec<Part> {
    let Some(sizes) = Sizes::of(figure) else { return Vec::new() };
    let mut parts = Vec::new();
    for side in SIDES {
        let link = sizes.index(&side.name("hand"));
        for digit in digits::digits(&sizes, side) {
            digit.parts(side, link, &mut parts);
        }
    }
    parts.extend(SIDES.map(|side| eyes::part(&sizes, side)));
    parts
}

fn body(sizes: &Sizes<'_>) -> Field {
    let flow = |blend: f64| blend * sizes.tall;
    let mut trunk = trunk::solids(sizes);
    trunk.extend(head::solids(sizes));
    let mut groups = vec![Group { solids: trunk, blend: flow(0.03) }];
    groups.extend(SIDES.map(|side| Group { solids: arm::solids(sizes, side), blend: flow(0.05) }));
    groups.extend(SIDES.map(|side| Group { solids: leg::solids(sizes, side), blend: flow(0.04) }));
    Field::new(groups)
}

/// Hands and face are finer, the head and feet a little.
fn zones(sizes: &Sizes<'_>) -> Vec<Zone> {
    let mut zones = Vec::new();
    let mut zone = |link: &str, corners: [[f64; 3]; 2], size: Vector3<f64>, finer: u32| {
        let place = sizes.place(link);
        let corner = |i: usize| {
            let pick = |k: usize| corners[i >> k & 1][k];
            place * Point3::from(Vector3::new(pick(0), pick(1), pick(2)).component_mul(&size))
        };
        zones.push(Zone { bounds: Bounds::around((0..8).map(|i| corner(i).coords), 0.0), finer });
    };
    let head = sizes.head();
    zone("head", [[-0.10, -0.05, -0.10], [0.10, 0.19, 0.16]], head, 1);
    zone("head", [[-0.055, -0.04, 0.07], [0.055, 0.10, 0.16]], head, 2);
    // Mouth.
    zone("head", [[-0.027, -0.004, 0.09], [0.027, 0.018, 0.16]], head, 3);
    for side in SIDES {
        let outwards = Vector3::new(side.out, 1.0, 1.0);
        // Lids and brows; ears.
        zone("head", [[0.009, 0.055, 0.07], [0.054, 0.093, 0.16]], head.component_mul(&outwards), 3);
        zone("head", [[0.066, 0.012, -0.02], [0.10, 0.09, 0.04]], head.component_mul(&outwards), 2);
        let (hand, foot) = (side.name("hand"), side.name("foot"));
        let scale = outwards * sizes.long(&hand);
        zone(&hand, [[-0.06, -0.20, -0.07], [0.06, 0.0, 0.09]], scale, 1);
        zone(&hand, [[-0.05, -0.14, -0.05], [0.03, -0.03, 0.07]], scale, 2);
        zone(&foot, [[-0.07, -0.10, -0.07], [0.07, 0.0, 0.23]], Vector3::repeat(sizes.long(&foot)), 1);
    }
    for side in SIDES {
        let place = sizes.place(&side.name("hand"));
        let digits = digits::digits(sizes, side);
        zones.extend(digits.iter().map(|digit| Zone { bounds: digit.bounds(&place), finer: 3 }));
    }
    zones
}

/// A solid in the axes of a link, `at` in them, turned by `turn`.
fn solid(
    sizes: &Sizes<'_>,
    link: &str,
    form: Form,
    at: Vector3<f64>,
    turn: UnitQuaternion<f64>,
    blend: f64,
) -> Solid {
    let place = sizes.place(link);
    let origin = place.rotation * at + place.translation.vector;
    Solid::new(form, place.rotation * turn, origin, blend * sizes.tall)
}
