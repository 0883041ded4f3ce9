//! The skeleton of a BVH file: offsets, and for each joint its channels.

use crate::error::{BvhFault, IoError};
use solaris_model::{AxisKind, EulerOrder, Figure, JointKind, Link, Vector3};

/// The order in which a ball or free joint is written: the most common in BVH.
pub(super) const ORDER: EulerOrder = EulerOrder::Zyx;

/// Length of the stub at the end of a link without a tip (m).
const STUB: f64 = 0.05;

/// A figure as BVH sees it: one node a link, in the figure's order.
pub(super) struct Skeleton {
    pub(super) nodes: Vec<Node>,
    /// Root position (m): this, and each of the slides by its coordinate.
    pub(super) origin: Vector3<f64>,
    /// Index in q and direction of each slide of the root.
    pub(super) slides: Vec<(usize, Vector3<f64>)>,
}

/// One `ROOT` or `JOINT`.
pub(super) struct Node {
    pub(super) name: String,
    pub(super) children: Vec<usize>,
    /// From the parent's origin (m); zero for the root, whose position is a channel.
    pub(super) offset: Vector3<f64>,
    /// Where the link ends (m), for a node without children.
    pub(super) end: Vector3<f64>,
    /// The rotations in order, three of them.
    pub(super) turns: Vec<Turn>,
}

/// One rotation channel.
pub(super) struct Turn {
    /// 0, 1, 2 for x, y, z.
    pub(super) axis: usize,
    pub(super) source: Source,
}

/// Where the angle of a rotation channel comes from.
pub(super) enum Source {
    /// The joint lacks this axis.
    Nothing,
    /// Index in q and the sign of the coordinate.
    Coordinate(usize, f64),
    /// Where in q a quaternion begins, and which of its angles in [`ORDER`] this is.
    Quaternion(usize, usize),
}

impl Skeleton {
    /// # Errors
    ///
    /// The first link or joint that BVH cannot hold.
    pub(super) fn of(figure: &Figure) -> Result<Self, IoError> {
        let mut nodes: Vec<Node> = Vec::new();
        let mut slides = Vec::new();
        for (i, link) in figure.links().iter().enumerate() {
            let refuse = |fault| IoError::BvhJoint { joint: link.joint().name().to_owned(), fault };
            if link.name().contains(|c: char| c.is_whitespace() || c == '{' || c == '}') {
                return Err(IoError::BvhName { link: link.name().to_owned() });
            }
            let placement = link.joint().placement();
            // The angle's sine is the vector part's norm: turns below rounding are no turns.
            if placement.rotation.imag().norm() > 1e-12 {
                return Err(refuse(BvhFault::TurnedPlacement));
            }
            let turns = turns(link, figure.layout().joints()[i].q, &mut slides).map_err(refuse)?;
            let is_root = link.parent().is_none();
            let offset = if is_root { Vector3::zeros() } else { placement.translation.vector };
            nodes.push(Node {
                name: link.name().to_owned(),
                children: Vec::new(),
                offset,
                end: end(link),
                turns,
            });
            if let Some(parent) = link.parent() {
                nodes[parent].children.push(i);
            }
        }
        let origin = figure.links()[0].joint().placement().translation.vector;
        Ok(Self { nodes, origin, slides })
    }

    /// Indices of the nodes in the order of the file: every node, then all below it, child by child.
    pub(super) fn order(&self) -> Vec<usize> {
        let (mut order, mut open) = (Vec::new(), vec![0]);
        while let Some(node) = open.pop() {
            order.push(node);
            open.extend(self.nodes[node].children.iter().rev());
        }
        order
    }
}

/// The rotations of a link's joint, whose coordinates start at `first` in q; slides of the root go to `slides`.
fn turns(link: &Link, first: usize, slides: &mut Vec<(usize, Vector3<f64>)>) -> Result<Vec<Turn>, BvhFault> {
    let mut turns: Vec<Turn> = Vec::new();
    let dofs = match link.joint().kind() {
        JointKind::Axes(dofs) => dofs,
        JointKind::Ball { .. } => return Ok(quaternion(first)),
        JointKind::Free { .. } if link.parent().is_some() => return Err(BvhFault::SlidingJoint),
        JointKind::Free { .. } => {
            slides.extend((0..3).map(|axis| (first + axis, Vector3::ith(axis, 1.0))));
            return Ok(quaternion(first + 3));
        }
        _ => return Err(BvhFault::Kind),
    };
    for (i, dof) in dofs.iter().enumerate() {
        let direction = dof.axis.direction;
        match dof.axis.kind {
            AxisKind::Translation if link.parent().is_some() => return Err(BvhFault::SlidingJoint),
            AxisKind::Translation if !turns.is_empty() => {
                return Err(BvhFault::SlidesAfterTurning { dof: i + 1 });
            }
            AxisKind::Translation => slides.push((first + i, direction)),
            AxisKind::Rotation => {
                let axis = direction.iamax();
                // A unit vector along an axis has this component ±1 and the others zero, to rounding.
                if (direction.abs() - Vector3::ith(axis, 1.0)).amax() > 1e-12 {
                    return Err(BvhFault::ObliqueAxis { dof: i + 1 });
                }
                if turns.iter().any(|turn| turn.axis == axis) {
                    return Err(BvhFault::RepeatedAxis { axis: ['x', 'y', 'z'][axis] });
                }
                turns.push(Turn { axis, source: Source::Coordinate(first + i, direction[axis].signum()) });
            }
        }
    }
    for axis in [2, 1, 0] {
        if turns.iter().all(|turn| turn.axis != axis) {
            turns.push(Turn { axis, source: Source::Nothing });
        }
    }
    Ok(turns)
}

/// The three rotations of a quaternion that begins at `first` in q.
fn quaternion(first: usize) -> Vec<Turn> {
    let turn = |(part, axis)| Turn { axis, source: Source::Quaternion(first, part) };
    ORDER.axes().into_iter().enumerate().map(turn).collect()
}

fn end(link: &Link) -> Vector3<f64> {
    let stub = || link.com().try_normalize(1e-9).unwrap_or_else(Vector3::y) * STUB;
    link.tip().copied().unwrap_or_else(stub)
}
