//! The lint of left and right sides that are not mirror images.

use super::neutral::Neutral;
use super::sides::{Mates, mates, singles};
use super::{digits, note, short, suspect};
use crate::figure::Figure;
use crate::joint::Placement;
use nalgebra::{Matrix3, Vector3};
use solaris_text::Finding;

/// How far from mirror images left and right may be: of the figure's size, the mass, the inertia.
const TOLERANCE: f64 = 1e-6;
/// How far up the tree the link that carries both is looked for; beyond, the root serves.
const FARTHEST: usize = 1000;

pub(super) fn check(figure: &Figure, neutral: &Neutral, findings: &mut Vec<Finding>) {
    let pairs = mates(&figure.links);
    let sides = Sides::of(figure, neutral, &pairs);
    let plane = sides.plane();
    for pair in &sides.pairs {
        let (left, right) = (&figure.links[pair.left], &figure.links[pair.right]);
        let (differences, about) = match plane {
            Some(plane) => {
                let about = format!(
                    "the plane {} = {} m of '{}'",
                    AXES[plane.axis],
                    short(plane.at),
                    figure.links[0].name
                );
                (sides.differences(pair, plane, &figure.links[0].name), about)
            }
            None => sides.differences_anywhere(pair),
        };
        if !differences.is_empty() {
            let (differences, right) = (differences.join("; "), &right.name);
            let message = format!("it is no mirror image of '{right}' in {about}: {differences}");
            findings.push(suspect(&left.name, message));
        }
    }
    for (link, other) in singles(&figure.links, &pairs) {
        let message = format!("its name has a side, but there is no '{other}'");
        findings.push(note(&figure.links[link].name, message));
    }
}

const AXES: [char; 3] = ['x', 'y', 'z'];

/// A plane square to an axis of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plane {
    /// Which axis.
    axis: usize,
    /// Where it stands on that axis (m).
    at: f64,
}

impl Plane {
    fn vector(self, v: &Vector3<f64>) -> Vector3<f64> {
        let mut v = *v;
        v[self.axis] = -v[self.axis];
        v
    }

    fn point(self, p: &Vector3<f64>) -> Vector3<f64> {
        let mut p = *p;
        p[self.axis] = 2.0 * self.at - p[self.axis];
        p
    }

    fn tensor(self, tensor: &Matrix3<f64>) -> Matrix3<f64> {
        Matrix3::from_fn(|i, j| {
            let flips = (i == self.axis) != (j == self.axis);
            if flips { -tensor[(i, j)] } else { tensor[(i, j)] }
        })
    }
}

/// A pair with its joint origins: from the parents' origins where the parents are a pair too, so that one that stands wrong
/// is told once.
struct Pair {
    left: usize,
    right: usize,
    /// Whether origins are measured from those of the parents.
    by_parents: bool,
    /// The link that carries both.
    common: usize,
}

struct Sides<'a> {
    figure: &'a Figure,
    neutral: &'a Neutral,
    pairs: Vec<Pair>,
    /// The root's axes, and its origin.
    root: Placement,
    /// What is small compared with the figure (m).
    length: f64,
}

impl<'a> Sides<'a> {
    fn of(figure: &'a Figure, neutral: &'a Neutral, mates: &[Mates]) -> Self {
        let links = &figure.links;
        let mut right_of = vec![usize::MAX; links.len()];
        for pair in mates {
            right_of[pair.left] = pair.right;
        }
        let mut common = vec![0; links.len()];
        let pairs = mates.iter().map(|&Mates { left, right, .. }| {
            let parents = links[left].parent.zip(links[right].parent);
            let on_pair = parents.filter(|(l, r)| right_of[*l] == *r);
            common[left] = on_pair.map_or_else(|| carrier(figure, left, right), |(l, _)| common[l]);
            Pair { left, right, by_parents: on_pair.is_some(), common: common[left] }
        });
        let pairs = pairs.collect();
        let root = neutral.places[0];
        let far = |i: usize| {
            let from_root = |point: Vector3<f64>| (point - root.translation.vector).norm();
            from_root(neutral.places[i].translation.vector).max(from_root(neutral.point(i, &links[i].com)))
        };
        let length = TOLERANCE * (0..links.len()).map(far).fold(0.0, f64::max);
        Self { figure, neutral, pairs, root, length }
    }

    /// The joint origins of a pair in `frame`.
    fn origins(&self, pair: &Pair, frame: &Placement) -> [Vector3<f64>; 2] {
        [pair.left, pair.right].map(|link| {
            let at = self.neutral.places[link].translation.vector;
            match self.figure.links[link].parent.filter(|_| pair.by_parents) {
                Some(parent) => {
                    frame.rotation.inverse() * (at - self.neutral.places[parent].translation.vector)
                }
                None => frame.inverse_transform_point(&at.into()).coords,
            }
        })
    }

    /// The plane square to one of the root's axes in which most pairs' joints are mirror images, if that are most of
    /// those that lie apart.
    fn plane(&self) -> Option<Plane> {
        let mut middles: [Vec<f64>; 3] = Default::default();
        let mut apart = 0;
        for pair in &self.pairs {
            let [left, right] = self.origins(pair, &self.root);
            let [sum, difference] = [left + right, left - right];
            apart += usize::from(difference.amax() > self.length);
            for (axis, middles) in middles.iter_mut().enumerate() {
                let others = (0..3).filter(|other| *other != axis).map(|other| difference[other].abs());
                let is_mirrored = others.fold(0.0, f64::max) <= self.length
                    && difference[axis].abs() > self.length
                    && !(pair.by_parents && sum[axis].abs() > self.length);
                if is_mirrored {
                    let both = [pair.left, pair.right].map(|link| {
                        self.root
                            .inverse_transform_point(&self.neutral.places[link].translation.vector.into())
                            [axis]
                    });
                    middles.push(f64::midpoint(both[0], both[1]));
                }
            }
        }
        // The first of those with most.
        let axis = (0..3).rev().max_by_key(|&axis| middles[axis].len())?;
        let middles = &mut middles[axis];
        if middles.is_empty() || 2 * middles.len() < apart {
            return None;
        }
        middles.sort_by(f64::total_cmp);
        let middle = middles[middles.len() / 2];
        // Rounding does not move a plane through the root's origin.
        Some(Plane { axis, at: if middle.abs() > self.length { middle } else { 0.0 } })
    }

    /// What differs between the left link and the mirror image of the right one, in a plane of the root.
    fn differences(&self, pair: &Pair, plane: Plane, of: &str) -> Vec<String> {
        self.differences_in(pair, plane, &self.root, of)
    }

    /// The same in that plane through the common carrier in which the fewest things differ, and which that is.
    fn differences_anywhere(&self, pair: &Pair) -> (Vec<String>, String) {
        let (frame, of) = (&self.neutral.places[pair.common], &self.figure.links[pair.common].name);
        let mut least: Option<(Vec<String>, usize)> = None;
        for axis in 0..3 {
            let found = self.differences_in(pair, Plane { axis, at: 0.0 }, frame, of);
            if least.as_ref().is_none_or(|(least, _)| found.len() < least.len()) {
                least = Some((found, axis));
            }
        }
        let (found, axis) = least.unwrap_or_default();
        (found, format!("the plane {} = 0 of '{of}', nor in the others", AXES[axis]))
    }

    fn differences_in(&self, pair: &Pair, plane: Plane, frame: &Placement, of: &str) -> Vec<String> {
        let [left, right] = [pair.left, pair.right].map(|link| &self.figure.links[link]);
        let mut found = Vec::new();
        let heavier = left.mass.max(right.mass);
        if (left.mass - right.mass).abs() > TOLERANCE * heavier {
            found.push(format!("masses {} and {} kg", exact(left.mass), exact(right.mass)));
        }
        let mut compare = |what: &str, from: &str, left: &Vector3<f64>, image: &Vector3<f64>| {
            let by = (left - image).amax();
            if by > self.length {
                let (left, image) = (vector(left), vector(image));
                found.push(format!(
                    "{what} at {left} m from {from}, the image at {image} m, {} m apart",
                    short(by)
                ));
            }
        };
        let [at_left, at_right] = self.origins(pair, frame);
        if pair.by_parents {
            compare("joint origin", "the parent's", &at_left, &plane.vector(&at_right));
        } else {
            compare("joint origin", &format!("'{of}'"), &at_left, &plane.point(&at_right));
        }
        let turned = |link: usize| {
            let turn = frame.rotation.inverse() * self.neutral.places[link].rotation;
            turn * self.figure.links[link].com
        };
        if left.mass > 0.0 && right.mass > 0.0 {
            compare("centre of mass", "its joint", &turned(pair.left), &plane.vector(&turned(pair.right)));
        }
        let tensor = |link: usize| {
            let turn = frame.rotation.to_rotation_matrix();
            let world = self.neutral.tensor(link, &self.figure.links[link].inertia);
            turn.matrix().transpose() * world * turn.matrix()
        };
        let [left, right] = [pair.left, pair.right].map(tensor);
        let difference = left - plane.tensor(&right);
        if difference.amax() > TOLERANCE * left.amax().max(right.amax()) {
            found.push(entry(&left, &plane.tensor(&right), &difference));
        }
        found
    }
}

/// The entry of two tensors that differs most.
fn entry(left: &Matrix3<f64>, image: &Matrix3<f64>, difference: &Matrix3<f64>) -> String {
    let (i, j) = difference.map(f64::abs).iamax_full();
    let (row, column) = (AXES[i.min(j)], AXES[i.max(j)]);
    // What is left of rounding is zero.
    let least = 1e-12 * left.amax().max(image.amax());
    let [left, image] = [left[(i, j)], image[(i, j)]].map(|x| exact(if x.abs() < least { 0.0 } else { x }));
    format!("inertias {row}{column} {left} and {image} kg m²")
}

/// A number with enough digits to see what differs.
fn exact(x: f64) -> String {
    digits(x, 10)
}

fn vector(v: &Vector3<f64>) -> String {
    format!("({:.7}, {:.7}, {:.7})", v.x, v.y, v.z)
}

/// The link nearest to both that carries both.
fn carrier(figure: &Figure, left: usize, right: usize) -> usize {
    let (mut left, mut right) = (left, right);
    for _ in 0..FARTHEST {
        // Parents have smaller indices.
        match left.cmp(&right) {
            std::cmp::Ordering::Equal => return left,
            std::cmp::Ordering::Less => right = figure.links[right].parent.unwrap_or_default(),
            std::cmp::Ordering::Greater => left = figure.links[left].parent.unwrap_or_default(),
        }
    }
    0
}
