//! A field's surface as quadrangles: dual contouring of an octree.
//!
//! # Source
//!
//! T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual contouring of Hermite data", ACM Transactions on Graphics 21 (2002) 339–346, §3:
//! every least edge whose ends lie on both sides of the surface has a polygon, whose corners are the vertices of the cells around
//! it; so the surface is closed whatever the cells' sizes. The vertices are put on the surface itself afterwards, not
//! where a quadratic error is least: a body has no sharp edges.

mod octree;
mod split;

pub(crate) use octree::Zone;

use crate::field::Field;
use nalgebra::Vector3;
use octree::Node;

/// A surface of polygons with three or four corners; of three the last one comes twice.
#[derive(Clone, Debug, Default)]
pub(crate) struct Polygons {
    pub(crate) points: Vec<Vector3<f64>>,
    pub(crate) faces: Vec<[u32; 4]>,
}

/// The surface of `field`, in cells of about `cell` (m), finer in `zones`.
pub(crate) fn contour(field: &Field, cell: f64, zones: &[Zone]) -> Polygons {
    let mut tree = octree::build(field, cell, zones);
    let mut walk = Walk { faces: Vec::new() };
    let mut points = Vec::new();
    tree.number(&mut points);
    walk.cell(&tree);
    let mut polygons = Polygons { points, faces: walk.faces };
    split::sheets(&mut polygons);
    polygons
}

struct Walk {
    faces: Vec<[u32; 4]>,
}

/// The child on one side of a node, or the node itself where it is a leaf. Bit k of `at` is the upper half along axis k.
fn child(node: &Node, at: usize) -> &Node {
    match node {
        Node::Branch(children) => &children[at],
        Node::Leaf { .. } => node,
    }
}

fn is_branch(node: &Node) -> bool {
    matches!(node, Node::Branch(_))
}

impl Walk {
    /// All that is within a node.
    fn cell(&mut self, node: &Node) {
        let Node::Branch(children) = node else { return };
        for child in children.iter() {
            self.cell(child);
        }
        for axis in 0..3 {
            let bit = 1 << axis;
            for at in (0..8).filter(|at| at & bit == 0) {
                self.face([&children[at], &children[at | bit]], axis);
            }
            // Edges along `axis` in the middle, in both halves.
            let (b, c) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
            for half in [0, bit] {
                let around = [half, half | b, half | b | c, half | c];
                self.edge(around.map(|at| &children[at]), axis);
            }
        }
    }

    /// The face between two nodes, the first one below along `axis`.
    fn face(&mut self, nodes: [&Node; 2], axis: usize) {
        if !nodes.iter().any(|node| is_branch(node)) {
            return;
        }
        let bit = 1 << axis;
        let (b, c) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        let at = |i: usize, quarter: usize| child(nodes[i], quarter | if i == 0 { bit } else { 0 });
        for quarter in [0, b, b | c, c] {
            self.face([at(0, quarter), at(1, quarter)], axis);
        }
        // Edges in the face: along b with what is beside it along c, and the other way.
        for half in [0, b] {
            // Around an edge along b the axes follow each other as c, axis.
            let (low, high) = (half, half | c);
            let around = [at(0, low), at(0, high), at(1, high), at(1, low)];
            self.edge(around, (axis + 1) % 3);
        }
        for half in [0, c] {
            // Around an edge along c: axis, then b.
            let (low, high) = (half, half | b);
            let around = [at(0, low), at(1, low), at(1, high), at(0, high)];
            self.edge(around, (axis + 2) % 3);
        }
    }

    /// The edge along `axis` between four nodes, in the order (−,−), (+,−), (+,+), (−,+) of the two axes after it.
    fn edge(&mut self, nodes: [&Node; 4], axis: usize) {
        let (b, c) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        // Each node touches the edge with its corner opposite of where it lies.
        let corner = [b | c, c, 0, b];
        if nodes.iter().any(|node| is_branch(node)) {
            for half in [0, 1 << axis] {
                self.edge(std::array::from_fn(|i| child(nodes[i], corner[i] | half)), axis);
            }
            return;
        }
        // The smallest leaf's edge is the least one.
        let leaves = nodes.map(Node::leaf);
        let least = (0..4).max_by_key(|i| (leaves[*i].0, 4 - i)).unwrap_or(0);
        let signs = leaves[least].1;
        let inside = |at: usize| signs >> at & 1 == 1;
        let (low, high) = (inside(corner[least]), inside(corner[least] | 1 << axis));
        if low == high {
            return;
        }
        let mut face = leaves.map(|leaf| leaf.2);
        if high {
            face.reverse();
        }
        self.push(face);
    }

    /// A polygon without corners that come twice.
    fn push(&mut self, face: [u32; 4]) {
        let mut corners: Vec<u32> = face.to_vec();
        corners.dedup();
        if corners.len() > 1 && corners[0] == corners[corners.len() - 1] {
            corners.pop();
        }
        match corners[..] {
            [a, b, c] => self.faces.push([a, b, c, c]),
            [a, b, c, d] => self.faces.push([a, b, c, d]),
            // An edge within two cells: what is on both its sides is one.
            _ => {}
        }
    }
}
