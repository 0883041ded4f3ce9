//! Vertices put on a surface and spread evenly over it.

use crate::contour::Polygons;
use crate::field::{Bounds, Field, Near};
use nalgebra::Vector3;
use rayon::prelude::*;
use std::collections::{HashMap, HashSet};

/// Steps of Newton's iteration along the gradient, from within a cell of the surface.
const STEPS: usize = 3;
/// Times that vertices are spread.
const ROUNDS: usize = 3;

/// Neighbours of each vertex along edges of polygons.
pub(crate) fn neighbours(polygons: &Polygons) -> Vec<Vec<u32>> {
    let mut found = vec![Vec::with_capacity(6); polygons.points.len()];
    for face in &polygons.faces {
        for k in 0..4 {
            let (a, b) = (face[k], face[(k + 1) % 4]);
            // Each edge is seen from both its sides, once each way.
            if a != b {
                found[a as usize].push(b);
            }
        }
    }
    found
}

/// Puts the vertices on the surface, and spreads them; the normals, and the groups of solids that vertices belong to.
pub(crate) fn settle(
    polygons: &mut Polygons,
    neighbours: &[Vec<u32>],
    field: &Field,
) -> (Vec<Vector3<f64>>, Vec<usize>) {
    let near = Nearby::new(field, &polygons.points);
    let points = &mut polygons.points;
    points.par_iter_mut().enumerate().for_each(|(i, p)| onto(field, near.of(i), p, STEPS));
    for round in 0..ROUNDS {
        let spread = |(i, around): (usize, &Vec<u32>)| {
            let p = points[i];
            let mean = around.iter().map(|j| points[*j as usize]).sum::<Vector3<f64>>() / around.len() as f64;
            let normal = field.sample(&p, near.of(i)).1.try_normalize(1e-9).unwrap_or_default();
            let along = mean - p;
            let mut moved = p + (along - normal * along.dot(&normal)) * 0.6;
            onto(field, near.of(i), &mut moved, if round + 1 == ROUNDS { 3 } else { 1 });
            moved
        };
        *points = neighbours.par_iter().enumerate().map(spread).collect();
    }
    let normal = |(i, p): (usize, &Vector3<f64>)| {
        field.sample(p, near.of(i)).1.try_normalize(1e-9).unwrap_or_else(Vector3::y)
    };
    let group = |(i, p): (usize, &Vector3<f64>)| field.nearest(p, near.of(i));
    let points = points.par_iter().enumerate();
    (points.clone().map(normal).collect(), points.map(group).collect())
}

/// Moves a point onto the surface: `p ← p − f·∇f/|∇f|²`, never far at once.
fn onto(field: &Field, near: &Near, p: &mut Vector3<f64>, steps: usize) {
    for _ in 0..steps {
        let (value, gradient) = field.sample(p, near);
        let square = gradient.norm_squared();
        if square < 1e-6 {
            return;
        }
        let step = gradient * (value / square);
        let length = step.norm();
        *p -= if length > LONGEST { step * (LONGEST / length) } else { step };
    }
}

/// Longest step (m).
const LONGEST: f64 = 0.02;

/// For each vertex the solids that have a say around it, found once for all vertices of a block of space.
struct Nearby {
    lists: Vec<Near>,
    of: Vec<u32>,
}

/// Edge of a block (m), and how far beyond it a vertex may move.
const BLOCK: f64 = 0.06;
const BEYOND: f64 = 0.03;

impl Nearby {
    fn new(field: &Field, points: &[Vector3<f64>]) -> Self {
        let mut index: HashMap<[i32; 3], u32> = HashMap::new();
        let (mut keys, mut of) = (Vec::new(), Vec::with_capacity(points.len()));
        for p in points {
            let key = [p.x, p.y, p.z].map(|x| (x / BLOCK).floor() as i32);
            of.push(*index.entry(key).or_insert_with(|| {
                keys.push(key);
                keys.len() as u32 - 1
            }));
        }
        let all = field.all();
        let list = |key: &[i32; 3]| {
            let low = Vector3::from(key.map(|i| f64::from(i) * BLOCK));
            field.near(&all, &Bounds::around([low, low.add_scalar(BLOCK)], BEYOND))
        };
        Self { lists: keys.par_iter().map(list).collect(), of }
    }

    fn of(&self, vertex: usize) -> &Near {
        &self.lists[self.of[vertex] as usize]
    }
}

/// Triangles of the polygons: quadrangles are halved along the shorter diagonal, or along the other where the shorter one's ends are
/// joined already.
pub(crate) fn triangles(polygons: &Polygons) -> Vec<[u32; 3]> {
    let mut triangles = Vec::with_capacity(2 * polygons.faces.len());
    let length = |a: u32, b: u32| (polygons.points[a as usize] - polygons.points[b as usize]).norm_squared();
    let edge = |a: u32, b: u32| (a.min(b), a.max(b));
    let sides = polygons.faces.iter().flat_map(|face| (0..4).map(move |k| edge(face[k], face[(k + 1) % 4])));
    let mut joined: HashSet<(u32, u32)> = sides.collect();
    for &[a, b, c, d] in &polygons.faces {
        if c == d {
            triangles.push([a, b, c]);
            continue;
        }
        let shorter = length(a, c) <= length(b, d);
        let (first, second) = if shorter { (edge(a, c), edge(b, d)) } else { (edge(b, d), edge(a, c)) };
        let diagonal = if joined.contains(&first) { second } else { first };
        joined.insert(diagonal);
        if diagonal == edge(a, c) {
            triangles.extend([[a, b, c], [a, c, d]]);
        } else {
            triangles.extend([[a, b, d], [b, c, d]]);
        }
    }
    triangles
}
