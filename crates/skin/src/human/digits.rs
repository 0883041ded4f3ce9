//! Thumb and fingers: where they are, how thick, how bent.
//!
//! They are made straight, spread and short, so that cells of the octree come between them and are longer along them than across; then
//! their bones bring them to where they hang. Lengths of bones are those of V. Buryanov, V. Kotiuk, "Proportions of hand segments",
//! International Journal of Morphology 28 (2010) 755–758, breadths about those of S. Pheasant, *Bodyspace*, 2nd ed. (1996), both of women and men
//! together.

use super::sizes::Sizes;
use super::{Side, solid};
use crate::field::{Bounds, Form, Loft, Section, Solid};
use crate::mesh::Part;
use crate::weights::ramp;
use nalgebra::{Isometry3, Matrix3, Rotation3, UnitQuaternion, Vector3};

/// How much longer fingers are than they are made.
const STRETCH: f64 = 2.0;

/// A digit of the reference (m), in the frame of a hand whose x is the back, −y to the fingers, z to the thumb.
struct Drawn {
    name: &'static str,
    /// Where the metacarpal begins, and the first joint that the digit bends at.
    base: [f64; 3],
    at: [f64; 3],
    /// Lengths of bones from there on, the last one with the tip's flesh.
    bones: &'static [f64],
    /// Sections by the bone (and a share of its length): half the breadth, to the back and to the palm.
    sections: &'static [(usize, f64, [f64; 3])],
    thick: f64,
    /// Angle to the thumb's side as it is made and as it hangs, and how far it bends at each joint (rad).
    spread: [f64; 2],
    bent: &'static [f64],
}

#[rustfmt::skip]
const FINGER: &[(usize, f64, [f64; 3])] = &[
    (0, 0.00, [0.0098, 0.0105, 0.0100]),
    (0, 0.50, [0.0091, 0.0090, 0.0100]),
    (0, 1.00, [0.0095, 0.0090, 0.0088]),
    (1, 0.50, [0.0085, 0.0077, 0.0090]),
    (1, 1.00, [0.0085, 0.0074, 0.0078]),
    (2, 0.30, [0.0083, 0.0068, 0.0086]),
    (2, 0.56, [0.0079, 0.0060, 0.0085]),
];

#[rustfmt::skip]
const THUMB: &[(usize, f64, [f64; 3])] = &[
    (0, 0.00, [0.0108, 0.0106, 0.0108]),
    (0, 0.50, [0.0098, 0.0096, 0.0106]),
    (0, 1.00, [0.0103, 0.0094, 0.0097]),
    (1, 0.35, [0.0104, 0.0078, 0.0102]),
    (1, 0.64, [0.0098, 0.0064, 0.0096]),
];

#[rustfmt::skip]
const DIGITS: [Drawn; 5] = [
    Drawn { name: "thumb", base: [-0.006, -0.022, 0.022], at: [-0.019, -0.058, 0.045], bones: &[0.0316, 0.0274],
        sections: THUMB, thick: 1.0, spread: [0.0, 0.0], bent: &[0.0, 0.15] },
    Drawn { name: "index", base: [0.0, -0.022, 0.016], at: [0.0, -0.0875, 0.0290], bones: &[0.0398, 0.0224, 0.0196],
        sections: FINGER, thick: 1.0, spread: [0.42, 0.055], bent: &[0.26, 0.42, 0.22] },
    Drawn { name: "middle", base: [0.0, -0.022, 0.004], at: [0.0005, -0.0895, 0.0095], bones: &[0.0446, 0.0263, 0.0214],
        sections: FINGER, thick: 1.02, spread: [0.14, 0.008], bent: &[0.32, 0.48, 0.25] },
    Drawn { name: "ring", base: [0.0, -0.022, -0.008], at: [-0.0005, -0.0855, -0.0095], bones: &[0.0414, 0.0257, 0.0213],
        sections: FINGER, thick: 0.95, spread: [-0.14, -0.044], bent: &[0.38, 0.52, 0.27] },
    Drawn { name: "little", base: [0.0, -0.022, -0.016], at: [-0.002, -0.0785, -0.0280], bones: &[0.0327, 0.0181, 0.0197],
        sections: FINGER, thick: 0.85, spread: [-0.50, -0.110], bent: &[0.42, 0.50, 0.27] },
];

/// The way along the thumb, and its back.
const THUMB_WAY: [f64; 3] = [-0.22, -0.92, 0.30];
const THUMB_BACK: [f64; 3] = [0.62, 0.10, 0.78];

/// A bone as it is made and as it hangs: where its joint is, and axes of which x is its back and y runs along it.
struct Bone {
    made: (Vector3<f64>, Matrix3<f64>),
    hangs: (Vector3<f64>, Matrix3<f64>),
}

/// From where something is made to where it hangs: its linear part, its shift (m), and how normals turn.
pub(super) type Move = (Matrix3<f64>, Vector3<f64>, Matrix3<f64>);

/// A digit of a figure, in the frame of its hand (m).
pub(super) struct Digit {
    pub(super) name: &'static str,
    /// The beginning of its metacarpal and the joint after it.
    base: Vector3<f64>,
    bones: Vec<Bone>,
    /// Places of the bones' joints along the digit as it is made, and that of its tip.
    along: Vec<f64>,
    /// How thick it is.
    radius: f64,
    loft: Loft,
}

fn axes(back: Vector3<f64>, way: Vector3<f64>) -> Matrix3<f64> {
    let way = way.normalize();
    let back = (back - way * way.dot(&back)).normalize();
    Matrix3::from_columns(&[back, way, back.cross(&way)])
}

/// `axes` bent to the palm by an angle (rad).
fn bent(axes: &Matrix3<f64>, angle: f64) -> Matrix3<f64> {
    axes * Rotation3::from_scaled_axis(Vector3::z() * angle).into_inner()
}

pub(super) fn digits(sizes: &Sizes<'_>, side: Side) -> Vec<Digit> {
    let scale = sizes.long(&side.name("hand"));
    DIGITS.iter().map(|drawn| digit(drawn, side, scale)).collect()
}

fn digit(drawn: &Drawn, side: Side, scale: f64) -> Digit {
    let at = side.vector(drawn.at, scale);
    let [made, mut hangs] = drawn.spread.map(|spread| {
        if drawn.name == "thumb" {
            axes(side.vector(THUMB_BACK, 1.0), side.vector(THUMB_WAY, 1.0))
        } else {
            axes(side.vector([1.0, 0.0, 0.0], 1.0), side.vector([0.0, -spread.cos(), spread.sin()], 1.0))
        }
    });
    let mut place = at;
    let mut along = vec![0.0];
    let mut bones = Vec::new();
    for (length, angle) in drawn.bones.iter().zip(drawn.bent) {
        hangs = bent(&hangs, *angle);
        let begins = along[along.len() - 1];
        bones.push(Bone { made: (at + made.column(1) * begins, made), hangs: (place, hangs) });
        place += hangs.column(1) * (length * scale);
        along.push(begins + length * scale / STRETCH);
    }
    let total = along[along.len() - 1];
    let section = |&(bone, share, [wide, back, palm]): &(usize, f64, [f64; 3])| {
        let y = along[bone] + share * (along[bone + 1] - along[bone]);
        Section(y, [back, palm, wide, wide].map(|reach| reach * scale * drawn.thick))
    };
    let sections: Vec<Section> = drawn.sections.iter().map(section).collect();
    let cap = total - sections[sections.len() - 1].0;
    Digit {
        name: drawn.name,
        base: side.vector(drawn.base, scale),
        bones,
        along,
        radius: 0.009 * drawn.thick * scale,
        loft: Loft::new(sections, [0.008 * scale, cap], 0.12),
    }
}

impl Digit {
    /// As a solid of the body.
    pub(super) fn solid(&self, sizes: &Sizes<'_>, side: Side) -> Solid {
        let (at, axes) = self.bones[0].made;
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
        solid(sizes, &side.name("hand"), Form::Loft(self.loft.clone()), at, turn, 0.0045)
    }

    /// The box around what is seen of it, as it is made, where its hand is at `place`.
    pub(super) fn bounds(&self, place: &Isometry3<f64>) -> Bounds {
        let (at, axes) = self.bones[0].made;
        let total = self.along[self.along.len() - 1];
        let ends =
            [0.3, 0.9].map(|share| place * nalgebra::Point3::from(at + axes.column(1) * (share * total)));
        Bounds::around(ends.map(|end| end.coords), 1.15 * self.radius)
    }

    /// How far a point in the hand's frame is from the digit and its metacarpal (m).
    pub(super) fn distance(&self, p: &Vector3<f64>) -> f64 {
        let (at, axes) = self.bones[0].made;
        let tip = at + axes.column(1) * self.along[self.along.len() - 1];
        let from = |a: Vector3<f64>, b: Vector3<f64>| {
            let way = b - a;
            let t = ((p - a).dot(&way) / way.norm_squared()).clamp(0.0, 1.0);
            (p - a - way * t).norm()
        };
        from(self.base, at).min(from(at, tip)) - self.radius
    }
}

// A thumb has a metacarpal that bends on its own, and two bones; a finger has three.
impl Digit {
    /// How far a point has passed each of its three joints, from 0 to 1; `half` is over what length (m).
    pub(super) fn passed(&self, p: &Vector3<f64>, half: [f64; 3], scale: f64) -> [f64; 3] {
        let (at, axes) = self.bones[0].made;
        let along = STRETCH * axes.column(1).dot(&(p - at));
        let joint = |k: usize, half: f64| ramp((along - STRETCH * self.along[k]) / half);
        if self.bones.len() == 3 {
            return [0, 1, 2].map(|k| joint(k, half[k]));
        }
        let way = self.base - at;
        let along = (p - self.base).dot(&-way.normalize());
        [ramp((along - 0.012 * scale) / half[0]), joint(0, half[0]), joint(1, half[1])]
    }

    /// How its three bones bring what goes with them from where it is made to where it hangs: `turn`, `at` and the turn of normals.
    pub(super) fn moves(&self) -> [Option<Move>; 3] {
        let long = Matrix3::from_diagonal(&Vector3::new(1.0, STRETCH, 1.0));
        let short = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0 / STRETCH, 1.0));
        let of = |bone: &Bone| {
            let turn = bone.hangs.1 * long * bone.made.1.transpose();
            (turn, bone.hangs.0 - turn * bone.made.0, bone.hangs.1 * short * bone.made.1.transpose())
        };
        let first = 3 - self.bones.len();
        std::array::from_fn(|k| k.checked_sub(first).map(|k| of(&self.bones[k])))
    }

    /// Adds its three bones.
    pub(super) fn parts(&self, side: Side, link: usize, parts: &mut Vec<Part>) {
        let metacarpal = (self.bones.len() == 2).then_some(self.base);
        let joints = metacarpal.into_iter().chain(self.bones.iter().map(|bone| bone.hangs.0));
        for (k, at) in joints.enumerate() {
            let parent = (k > 0).then(|| parts.len() - 1);
            parts.push(Part { name: format!("{}{}_{}", side.prefix, self.name, k + 1), link, parent, at });
        }
    }
}
