//! The octree around a surface.

use crate::field::{Bounds, Field, Near};
use nalgebra::Vector3;
use rayon::prelude::*;
use std::collections::HashMap;

/// No vertex.
pub(super) const NONE: u32 = u32::MAX;

/// A part of space in which cells are halved so many times more.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Zone {
    pub(crate) bounds: Bounds,
    pub(crate) finer: u32,
}

#[derive(Debug)]
pub(super) enum Node {
    Branch(Box<[Node; 8]>),
    Leaf {
        /// Twice how often halved, and one more where the corners were asked.
        depth: u32,
        /// Bit i is whether corner i is inside.
        signs: u8,
        /// Where its vertex begins: on the surface, nearly.
        point: Vector3<f64>,
        vertex: u32,
    },
}

impl Node {
    /// Depth, signs and vertex.
    pub(super) fn leaf(&self) -> (u32, u8, u32) {
        match self {
            Self::Leaf { depth, signs, vertex, .. } => (*depth, *signs, *vertex),
            Self::Branch(_) => (0, 0, NONE),
        }
    }

    /// Numbers the leaves, whose vertices are `points`.
    pub(super) fn number(&mut self, points: &mut Vec<Vector3<f64>>) {
        match self {
            Self::Branch(children) => children.iter_mut().for_each(|child| child.number(points)),
            Self::Leaf { point, vertex, .. } => {
                *vertex = points.len() as u32;
                points.push(*point);
            }
        }
    }
}

/// How far a value may be from zero, in times the distance to a cell's corner, for the surface to be in the cell: no solid's value
/// grows faster.
const STEEP: f64 = 2.0;
/// How often a cell is halved beyond its size where its corners do not say how the surface runs.
const UNSURE: u32 = 1;
/// Depth from which parts are built beside each other.
const APART: u32 = 2;

struct Build<'a> {
    field: &'a Field,
    zones: &'a [Zone],
    origin: Vector3<f64>,
    size: f64,
    depth: u32,
}

/// The tree around the surface of `field`, in cells of `cell` (m), finer in `zones`.
pub(super) fn build(field: &Field, cell: f64, zones: &[Zone]) -> Node {
    let all = field.all();
    let bounds = field.bounds();
    let extent = (bounds.1 - bounds.0).max() + 4.0 * cell;
    let depth = (extent / cell).log2().ceil().max(f64::from(APART)) as u32;
    let size = cell * f64::from(1_u32 << depth);
    // Off the middle, so that no plane of cells lies in the body's own plane of symmetry or on a sole.
    let middle = (bounds.0 + bounds.1) / 2.0;
    let origin = middle - Vector3::repeat(size / 2.0) + Vector3::new(0.371, 0.293, 0.413) * cell;
    Build { field, zones, origin, size, depth }.node([0; 3], 0, &all, &mut Known::new())
}

impl Build<'_> {
    fn edge(&self, depth: u32) -> f64 {
        self.size / f64::from(1_u32 << depth)
    }

    fn corner(&self, at: [u32; 3], depth: u32) -> Vector3<f64> {
        // The same bits for a place at all depths.
        let finest = self.edge(FINEST);
        let steps = at.map(|i| f64::from(i << (FINEST - depth)) * finest);
        self.origin + Vector3::from(steps)
    }

    fn node(&self, at: [u32; 3], depth: u32, near: &Near, known: &mut Known) -> Node {
        let low = self.corner(at, depth);
        let edge = self.edge(depth);
        let bounds = Bounds(low, low.add_scalar(edge));
        let near = self.field.near(near, &bounds);
        let middle = low.add_scalar(edge / 2.0);
        let leaf =
            |signs: u8, point: Vector3<f64>| Node::Leaf { depth: 2 * depth + 1, signs, point, vertex: NONE };
        if near.is_empty() {
            return leaf(0, middle);
        }
        let value = self.field.distance(&middle, &near);
        if depth > APART && value.abs() > STEEP * edge * 0.867 {
            // Should the surface be in it after all, its neighbours know better.
            let signs = if value < 0.0 { u8::MAX } else { 0 };
            return Node::Leaf { depth: 2 * depth, signs, point: middle, vertex: NONE };
        }
        let finer =
            self.zones.iter().filter(|zone| zone.bounds.apart(&bounds) < 0.0).map(|zone| zone.finer).max();
        let wanted = self.depth + finer.unwrap_or(0);
        if depth >= wanted {
            let values: [f64; 8] = std::array::from_fn(|i| self.value(at, i, depth, &near, known));
            let signs = (0..8).fold(0_u8, |signs, i| signs | u8::from(values[i] < 0.0) << i);
            if depth >= wanted + UNSURE || !is_unsure(signs) {
                return leaf(signs, middle_of_crossings(&values, low, edge).unwrap_or(middle));
            }
        }
        let child = |i: usize, known: &mut Known| {
            let child = [0, 1, 2].map(|k| 2 * at[k] + (i >> k & 1) as u32);
            self.node(child, depth + 1, &near, known)
        };
        let children: Vec<Node> = if depth < APART {
            (0..8).into_par_iter().map(|i| child(i, &mut Known::new())).collect()
        } else {
            (0..8).map(|i| child(i, known)).collect()
        };
        // Eight went in.
        children.try_into().map_or_else(|_| leaf(0, middle), |children| Node::Branch(Box::new(children)))
    }

    fn value(&self, at: [u32; 3], i: usize, depth: u32, near: &Near, known: &mut Known) -> f64 {
        let corner = [0, 1, 2].map(|k| at[k] + (i >> k & 1) as u32);
        let key = corner.map(|i| i << (FINEST - depth));
        *known.entry(key).or_insert_with(|| self.field.sample(&self.corner(corner, depth), near).0)
    }
}

/// Values at corners, which up to eight cells share. They are of the place alone, so it does not matter who asked first.
type Known = HashMap<[u32; 3], f64>;

/// Depth by which places are counted.
const FINEST: u32 = 16;

/// The mean of where the surface crosses the cell's edges.
fn middle_of_crossings(values: &[f64; 8], low: Vector3<f64>, edge: f64) -> Option<Vector3<f64>> {
    let (mut sum, mut count) = (Vector3::zeros(), 0.0);
    for axis in 0..3 {
        for i in (0..8).filter(|i| i >> axis & 1 == 0) {
            let (a, b) = (values[i], values[i | 1 << axis]);
            if (a < 0.0) != (b < 0.0) {
                let mut point = Vector3::from([0, 1, 2].map(|k| (i >> k & 1) as f64));
                point[axis] = a / (a - b);
                sum += point;
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| low + sum * (edge / count))
}

/// Whether corners of one sign are not all joined along edges, or lie crosswise on a face: then the surface may run in more than
/// one way.
fn is_unsure(signs: u8) -> bool {
    let joined = |set: u8| {
        if set == 0 {
            return true;
        }
        let mut found = set & set.wrapping_neg();
        loop {
            let wider = (0..8).filter(|i| found >> i & 1 == 1).fold(found, |wider, i| {
                (0..3).fold(wider, |wider, axis| wider | (1_u8 << (i ^ (1 << axis))) & set)
            });
            if wider == found {
                return found == set;
            }
            found = wider;
        }
    };
    let crosswise = |axis: usize, side: usize| {
        let (b, c) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        let base = side << axis;
        let s = |i: usize| signs >> (base | i) & 1;
        s(0) == s(b | c) && s(b) == s(c) && s(0) != s(b)
    };
    !joined(signs) || !joined(!signs) || (0..3).any(|axis| (0..2).any(|side| crosswise(axis, side)))
}
