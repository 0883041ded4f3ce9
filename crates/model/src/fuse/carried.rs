//! Links carried by another: their masses, shapes and points in its frame.

use crate::joint::Placement;
use crate::link::{Link, NamedFrame, SolePoint};
use nalgebra::{Matrix3, Vector3};
use std::collections::HashSet;

/// The place of a link on the link of another figure that carries it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkPlace {
    /// Index of the carrying link.
    pub link: usize,
    /// Where the carried link's frame stands in the carrying link's frame.
    pub placement: Placement,
}

impl LinkPlace {
    /// The frame of `link` itself.
    pub(crate) fn at(link: usize) -> Self {
        Self { link, placement: Placement::identity() }
    }
}

/// The names of all frames, so that a new one can be told from them.
pub(crate) fn frame_names(links: &[Link]) -> HashSet<String> {
    links.iter().flat_map(|link| &link.frames).map(|frame| frame.name.clone()).collect()
}

/// `left * right`, keeping the digits of the one where the other is the identity.
pub(crate) fn compose(left: &Placement, right: &Placement) -> Placement {
    if *left == Placement::identity() {
        *right
    } else if *right == Placement::identity() {
        *left
    } else {
        let mut product = left * right;
        product.rotation.renormalize();
        product
    }
}

/// The link with all that is fixed to it written in another frame, in which its own frame stands at `by`.
///
/// Where the two differ its own frame becomes a named frame, if its name is not among the `taken`.
pub(crate) fn moved(link: &Link, by: &Placement, taken: &mut HashSet<String>) -> Link {
    let mut link = link.clone();
    if *by == Placement::identity() {
        return link;
    }
    let point = |p: &Vector3<f64>| by.transform_point(&(*p).into()).coords;
    let turn = by.rotation.to_rotation_matrix();
    let inertia = turn.matrix() * link.inertia * turn.matrix().transpose();
    link.inertia = (inertia + inertia.transpose()) / 2.0;
    if link.mass > 0.0 {
        link.com = point(&link.com);
    }
    link.tip = link.tip.as_ref().map(point);
    if let Some(shape) = &mut link.shape {
        shape.placement = compose(by, &shape.placement);
    }
    for SolePoint { position, .. } in &mut link.sole {
        *position = point(position);
    }
    for frame in &mut link.frames {
        frame.placement = compose(by, &frame.placement);
    }
    if taken.insert(link.name.clone()) {
        link.frames.push(NamedFrame { name: link.name.clone(), placement: *by });
    }
    link
}

/// Makes `other`, written in the frame of `link`, a part of `link`.
pub(crate) fn absorb(link: &mut Link, other: Link, taken: &mut HashSet<String>) {
    let mass = link.mass + other.mass;
    if link.mass <= 0.0 {
        (link.com, link.inertia) = (other.com, other.inertia);
    } else if other.mass > 0.0 {
        let (share, way) = (other.mass / mass, other.com - link.com);
        let spread = Matrix3::identity() * way.norm_squared() - way * way.transpose();
        link.com += way * share;
        link.inertia += other.inertia + spread * (link.mass * share);
    }
    link.mass = mass;
    link.shape = link.shape.take().or(other.shape);
    link.frames.extend(other.frames);
    for point in other.sole {
        let known = link.sole.iter().any(|own| own.part == point.part && own.position == point.position);
        if !known {
            link.sole.push(point);
        }
    }
    match (link.tip, other.tip) {
        (None, tip) => link.tip = tip,
        (Some(_), Some(tip)) => {
            let name = format!("{}.tip", other.name);
            if taken.insert(name.clone()) {
                let placement = Placement::translation(tip.x, tip.y, tip.z);
                link.frames.push(NamedFrame { name, placement });
            }
        }
        (Some(_), None) => {}
    }
}
