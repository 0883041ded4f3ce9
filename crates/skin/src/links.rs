//! The shapes of links as they are: of machines, animals, anything.

use crate::mesh::{Influence, Skin};
use crate::palette::THING;
use nalgebra::{Isometry3, Point3, Vector3};
use solaris_model::{Figure, Link, ShapeKind};
use std::f64::consts::{FRAC_PI_2, PI};

/// Sectors of what is round, and rings from its pole to its equator.
const SECTORS: usize = 24;
const RINGS: usize = 6;

/// The shapes of all links, in the neutral posture.
pub(crate) fn skin(figure: &Figure) -> Skin {
    let mut q = vec![0.0; figure.layout().nq()];
    // The length is the figure's own.
    let _ = figure.neutral(&mut q);
    let mut skin = Skin { bind: figure.places(&q), ..Skin::default() };
    for (link, at) in figure.links().iter().zip(0_u16..) {
        add(&mut skin, link, at);
    }
    skin
}

/// Adds the shape of a link, if it has one, where the skin is bound.
pub(crate) fn add(skin: &mut Skin, link: &Link, at: u16) {
    if let Some(shape) = link.shape() {
        let place = skin.bind[at as usize] * shape.placement;
        match shape.kind {
            ShapeKind::Box { size } => cuboid(skin, &(size / 2.0), &place, at),
            kind => turned(skin, &profile(kind), &place, at),
        }
    }
}

/// A point of a meridian: its distance from the axis and height, and the normal's; stretched along x, y, z afterwards.
type Meridian = (Vec<[f64; 4]>, Vector3<f64>);

fn profile(kind: ShapeKind) -> Meridian {
    let arc = |radius: f64, height: f64, from: f64, to: f64| {
        (0..=RINGS).map(move |i| {
            let angle = from + (to - from) * i as f64 / RINGS as f64;
            let (sin, cos) = angle.sin_cos();
            // On the axis to the bit.
            let cos = if i == 0 && from < -1.0 || i == RINGS && to > 1.0 { 0.0 } else { cos };
            [radius * cos, height + radius * sin, cos, sin]
        })
    };
    let one = Vector3::repeat(1.0);
    match kind {
        ShapeKind::Cylinder { radius: r, length } => {
            let h = length / 2.0;
            let ring = [
                [0.0, -h, 0.0, -1.0],
                [r, -h, 0.0, -1.0],
                [r, -h, 1.0, 0.0],
                [r, h, 1.0, 0.0],
                [r, h, 0.0, 1.0],
                [0.0, h, 0.0, 1.0],
            ];
            (ring.to_vec(), one)
        }
        ShapeKind::Capsule { radius, length } => {
            let low = arc(radius, -length / 2.0, -FRAC_PI_2, 0.0);
            (low.chain(arc(radius, length / 2.0, 0.0, FRAC_PI_2)).collect(), one)
        }
        ShapeKind::Ellipsoid { radii } => {
            (ball(arc(1.0, 0.0, -FRAC_PI_2, 0.0), arc(1.0, 0.0, 0.0, FRAC_PI_2)), radii)
        }
        ShapeKind::Sphere { radius } => {
            (ball(arc(1.0, 0.0, -FRAC_PI_2, 0.0), arc(1.0, 0.0, 0.0, FRAC_PI_2)), Vector3::repeat(radius))
        }
        ShapeKind::Box { .. } => (Vec::new(), one),
    }
}

fn ball(low: impl Iterator<Item = [f64; 4]>, high: impl Iterator<Item = [f64; 4]>) -> Vec<[f64; 4]> {
    low.chain(high.skip(1)).collect()
}

/// A meridian turned about y.
fn turned(skin: &mut Skin, (meridian, stretch): &Meridian, place: &Isometry3<f64>, link: u16) {
    let first = skin.points.len() as u32;
    let count = meridian.len();
    for sector in 0..SECTORS {
        let (sin, cos) = (2.0 * PI * sector as f64 / SECTORS as f64).sin_cos();
        for [radius, height, out, up] in meridian {
            let point = Vector3::new(radius * cos, *height, radius * sin).component_mul(stretch);
            let normal = Vector3::new(out * cos, *up, out * sin).component_div(stretch);
            vertex(skin, &point, &normal, place, link);
        }
    }
    let at = |sector: usize, i: usize| first + ((sector % SECTORS) * count + i) as u32;
    for sector in 0..SECTORS {
        for i in 1..count {
            let [a, b, c, d] = [at(sector, i - 1), at(sector, i), at(sector + 1, i), at(sector + 1, i - 1)];
            // On the axis all sectors meet, and of what has no height nothing is seen.
            let (lower, upper) = (meridian[i - 1], meridian[i]);
            if (lower[0] - upper[0]).abs() + (lower[1] - upper[1]).abs() == 0.0 {
                continue;
            }
            if lower[0] > 0.0 {
                skin.triangles.push([a, c, d]);
            }
            if upper[0] > 0.0 {
                skin.triangles.push([a, b, c]);
            }
        }
    }
}

fn cuboid(skin: &mut Skin, half: &Vector3<f64>, place: &Isometry3<f64>, link: u16) {
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let first = skin.points.len() as u32;
            let normal = Vector3::ith(axis, sign);
            for (u, v) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let mut point = normal;
                // Counter-clockwise seen from outside.
                point[(axis + 1) % 3] = u * sign;
                point[(axis + 2) % 3] = v;
                vertex(skin, &point.component_mul(half), &normal, place, link);
            }
            skin.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
}

fn vertex(skin: &mut Skin, point: &Vector3<f64>, normal: &Vector3<f64>, place: &Isometry3<f64>, link: u16) {
    skin.points.push((place * Point3::from(*point)).coords);
    skin.normals.push(place.rotation * normal.normalize());
    skin.colours.push(THING);
    let mut influences = [Influence::default(); 4];
    influences[0] = Influence { link, share: 1.0 };
    skin.influences.push(influences);
}
