//! The skeleton of a BVH file: offsets, and for each joint its channels.

use solaris_model::{
    AxisKind, EulerOrder, Figure, Joint, JointKind, Link, Placement, UnitQuaternion, Vector3,
};
use std::collections::BTreeSet;

/// The order in which a joint is written that BVH does not know: the most common in BVH.
pub(super) const ORDER: EulerOrder = EulerOrder::Zyx;

/// Length of the stub at the end of a link without a tip (m).
const STUB: f64 = 0.05;

/// A figure as BVH sees it: one node a link, in the figure's order.
pub(super) struct Skeleton {
    pub(super) nodes: Vec<Node>,
}

/// One `ROOT` or `JOINT`.
pub(super) struct Node {
    pub(super) name: String,
    pub(super) children: Vec<usize>,
    /// From the parent's origin (m), with all coordinates at zero.
    pub(super) offset: Vector3<f64>,
    /// Where the link ends (m), for a node without children.
    pub(super) end: Vector3<f64>,
    /// Whether its position is a channel: the root's, and that of a joint that slides.
    pub(super) is_placed: bool,
    /// Whether it is free to go anywhere.
    pub(super) is_free: bool,
    /// How its channels follow from the coordinates.
    pub(super) channels: Channels,
}

/// How the channels of a joint follow from its coordinates.
pub(super) enum Channels {
    /// The joint is one of BVH: it slides, then turns about x, y, z in some order.
    Own {
        /// Index in q and direction of each slide.
        slides: Vec<(usize, Vector3<f64>)>,
        /// The rotations in order, three of them.
        turns: Vec<Turn>,
    },
    /// By where the joint takes its link: position and three angles in [`ORDER`].
    Place {
        /// The joint's frame, seen from a world in which y is up.
        placement: Placement,
        joint: Joint,
        /// Where its coordinates begin in q.
        first: usize,
    },
}

/// One rotation channel.
pub(super) struct Turn {
    /// 0, 1, 2 for x, y, z.
    pub(super) axis: usize,
    /// Index in q and the sign of the coordinate; nothing where the joint lacks this axis.
    pub(super) source: Option<(usize, f64)>,
}

impl Skeleton {
    /// The figure in a world that is turned by `world`.
    pub(super) fn of(figure: &Figure, world: UnitQuaternion<f64>) -> Self {
        let mut nodes: Vec<Node> = Vec::new();
        // Names that are one word stay; the others make way.
        let words = figure.links().iter().map(|link| link.name().to_owned());
        let mut taken: BTreeSet<String> = words.filter(|name| word(name) == *name).collect();
        for (i, (link, at)) in figure.links().iter().zip(figure.layout().joints()).enumerate() {
            let placement = *link.joint().placement();
            let placement = if i == 0 { world * placement } else { placement };
            let channels = channels(link.joint(), placement, at.q);
            let slides = link.joint().kind().slides().next().is_some();
            nodes.push(Node {
                name: unique(link.name(), &mut taken),
                children: Vec::new(),
                offset: placement.translation.vector,
                end: end(link),
                is_placed: i == 0 || slides,
                is_free: i == 0 || link.joint().kind().is_floating(),
                channels,
            });
            if let Some(parent) = link.parent() {
                nodes[parent].children.push(i);
            }
        }
        Self { nodes }
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

/// How a joint's channels follow from its coordinates, which start at `first` in q.
fn channels(joint: &Joint, placement: Placement, first: usize) -> Channels {
    // The angle's sine is the vector part's norm: turns below rounding are no turns.
    let is_parallel = placement.rotation.imag().norm() <= 1e-12;
    let own = if is_parallel { own(joint.kind(), first) } else { None };
    own.unwrap_or_else(|| Channels::Place { placement, joint: joint.clone(), first })
}

/// The channels of a joint that slides, and then turns at most once about each of x, y, z.
fn own(kind: &JointKind, first: usize) -> Option<Channels> {
    let JointKind::Axes(dofs) = kind else { return None };
    let (mut slides, mut turns) = (Vec::new(), Vec::<Turn>::new());
    for (i, dof) in dofs.iter().enumerate() {
        let direction = dof.axis.direction;
        match dof.axis.kind {
            AxisKind::Translation if turns.is_empty() => slides.push((first + i, direction)),
            AxisKind::Translation => return None,
            AxisKind::Rotation => {
                let axis = direction.iamax();
                // A unit vector along an axis has this component ±1 and the others zero, to rounding.
                let is_oblique = (direction.abs() - Vector3::ith(axis, 1.0)).amax() > 1e-12;
                if is_oblique || turns.iter().any(|turn| turn.axis == axis) {
                    return None;
                }
                turns.push(Turn { axis, source: Some((first + i, direction[axis].signum())) });
            }
        }
    }
    for axis in [2, 1, 0] {
        if turns.iter().all(|turn| turn.axis != axis) {
            turns.push(Turn { axis, source: None });
        }
    }
    Some(Channels::Own { slides, turns })
}

fn end(link: &Link) -> Vector3<f64> {
    let stub = || link.com().try_normalize(1e-9).unwrap_or_else(Vector3::y) * STUB;
    link.tip().copied().unwrap_or_else(stub)
}

/// A name as one word.
fn word(name: &str) -> String {
    name.replace(|c: char| c.is_whitespace() || c.is_control() || matches!(c, '{' | '}'), "_")
}

/// A name of one word that no other bone has: `a_b`, `a_b_2`.
fn unique(name: &str, taken: &mut BTreeSet<String>) -> String {
    let made = word(name);
    if made == name {
        return made;
    }
    let numbered = (2..).map(|number| format!("{made}_{number}"));
    let mut all = std::iter::once(made.clone()).chain(numbered);
    // They do not end.
    all.find(|name| taken.insert(name.clone())).unwrap_or_default()
}
