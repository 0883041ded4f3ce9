//! Sheets of a surface that share vertices, taken apart.
//!
//! Where two parts of a surface run through one cell they share its vertex, and where through two cells that touch, an edge that four
//! polygons meet in. Each polygon's edge is paired with one of those that run the other way; what is joined around a corner by such pairs gets
//! a vertex of its own. So every edge belongs to two polygons, whatever the cells were.

use super::Polygons;
use nalgebra::Vector3;
use std::collections::HashMap;

/// A corner of a polygon: the edge that begins there.
type Corner = usize;

/// Gives each sheet its own vertices, and keeps the largest connected one.
pub(super) fn sheets(polygons: &mut Polygons) {
    let count = polygons.faces.len() * 4;
    let faces = &polygons.faces;
    let size = |face: usize| if faces[face][2] == faces[face][3] { 3 } else { 4 };
    let next = |c: Corner| c - c % 4 + (c % 4 + 1) % size(c / 4);
    let before = |c: Corner| c - c % 4 + (c % 4 + size(c / 4) - 1) % size(c / 4);
    let start = |c: Corner| faces[c / 4][c % 4];
    let corners = || (0..count).filter(|c| c % 4 < size(c / 4));
    let mut open: HashMap<(u32, u32), Vec<Corner>> = HashMap::with_capacity(count);
    let mut twin = vec![usize::MAX; count];
    for c in corners() {
        let (a, b) = (start(c), start(next(c)));
        let other = open.get_mut(&(b, a)).and_then(Vec::pop);
        match other {
            Some(other) => (twin[c], twin[other]) = (other, c),
            None => open.entry((a, b)).or_default().push(c),
        }
    }
    let mut vertex = vec![u32::MAX; count];
    let mut points: Vec<Vector3<f64>> = Vec::with_capacity(polygons.points.len());
    for first in corners() {
        let mut c = first;
        // Around the corner's vertex until the round is done.
        while vertex[c] == u32::MAX {
            vertex[c] = points.len() as u32;
            c = twin[before(c)];
            debug_assert!(c != usize::MAX, "a surface without a border");
        }
        if c == first && vertex[c] == points.len() as u32 {
            points.push(polygons.points[start(first) as usize]);
        }
    }
    let renumbered = (0..faces.len()).map(|face| {
        let at = |k: usize| vertex[face * 4 + k];
        [at(0), at(1), at(2), at(if size(face) == 3 { 2 } else { 3 })]
    });
    *polygons = largest(&points, renumbered.collect());
    part_twins(polygons);
}

/// Two vertices that are joined twice get a vertex between them, so that edges are told apart by their ends.
fn part_twins(polygons: &mut Polygons) {
    let mut seen: HashMap<(u32, u32), u32> = HashMap::with_capacity(4 * polygons.faces.len());
    // Where an edge comes again: the way back of it, and the vertex between.
    let mut again: HashMap<(u32, u32), Vec<u32>> = HashMap::new();
    let mut at = 0;
    while at < polygons.faces.len() {
        let face = polygons.faces[at];
        let size = if face[2] == face[3] { 3 } else { 4 };
        let twice = (0..size).find_map(|k| {
            let edge = (face[k], face[(k + 1) % size]);
            let way_back = again.get_mut(&edge).and_then(Vec::pop);
            let is_again = seen.get(&edge).is_some_and(|count| *count > 0);
            (way_back.is_some() || is_again).then_some((k, edge, way_back))
        });
        let Some((k, edge, way_back)) = twice else {
            (0..size).for_each(|k| *seen.entry((face[k], face[(k + 1) % size])).or_default() += 1);
            at += 1;
            continue;
        };
        let middle = way_back.unwrap_or_else(|| {
            let points = &mut polygons.points;
            points.push((points[edge.0 as usize] + points[edge.1 as usize]) / 2.0);
            let middle = points.len() as u32 - 1;
            again.entry((edge.1, edge.0)).or_default().push(middle);
            middle
        });
        // The corner before the edge is joined with its middle.
        let (next, before) = (face[(k + 2) % size], face[(k + size - 1) % size]);
        polygons.faces[at] = [edge.0, middle, before, before];
        polygons.faces.push(if size == 3 {
            [middle, edge.1, next, next]
        } else {
            [middle, edge.1, next, before]
        });
    }
}

/// The largest connected part.
fn largest(points: &[Vector3<f64>], faces: Vec<[u32; 4]>) -> Polygons {
    let mut root: Vec<usize> = (0..points.len()).collect();
    let mut find = |mut i: usize, to: Option<usize>| {
        while root[i] != i {
            root[i] = root[root[i]];
            i = root[i];
        }
        root[i] = to.unwrap_or(i);
        i
    };
    for face in &faces {
        for corner in &face[1..] {
            let to = find(face[0] as usize, None);
            find(*corner as usize, Some(to));
        }
    }
    let parts: Vec<usize> = (0..points.len()).map(|i| find(i, None)).collect();
    let mut sizes = vec![0_usize; points.len()];
    for part in &parts {
        sizes[*part] += 1;
    }
    // The first one of those as large.
    let most = (0..sizes.len()).rev().max_by_key(|part| sizes[*part]).unwrap_or(0);
    let mut new = vec![0_u32; points.len()];
    let mut kept = Vec::with_capacity(points.len());
    for i in (0..points.len()).filter(|i| parts[*i] == most) {
        new[i] = kept.len() as u32;
        kept.push(points[i]);
    }
    let faces = faces.into_iter().filter(|face| parts[face[0] as usize] == most);
    Polygons { points: kept, faces: faces.map(|face| face.map(|i| new[i as usize])).collect() }
}
