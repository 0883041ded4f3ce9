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

/// Mass (kg), centre of mass (m) and rotational inertia about it (kg m²), along the axes of one frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Matter {
    pub(crate) mass: f64,
    pub(crate) com: Vector3<f64>,
    pub(crate) inertia: Matrix3<f64>,
}

impl Matter {
    /// That of a link, in its own frame.
    pub(crate) fn of(link: &Link) -> Self {
        Self { mass: link.mass, com: link.com, inertia: link.inertia }
    }

    /// The same written in another frame, in which its own stands at `by`; without mass it has no centre.
    pub(crate) fn placed(&self, by: &Placement) -> Self {
        let turn = by.rotation.to_rotation_matrix();
        let inertia = turn.matrix() * self.inertia * turn.matrix().transpose();
        let com = if self.mass > 0.0 { by.transform_point(&self.com.into()).coords } else { self.com };
        Self { com, inertia: (inertia + inertia.transpose()) / 2.0, ..*self }
    }

    /// Both together.
    pub(crate) fn with(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        if self.mass <= 0.0 {
            return Self { mass, com: other.com, inertia: self.inertia + other.inertia };
        }
        let (share, way) = (other.mass / mass, other.com - self.com);
        let spread = Matrix3::identity() * way.norm_squared() - way * way.transpose();
        let (com, inertia) =
            (self.com + way * share, self.inertia + (other.inertia + spread * (self.mass * share)));
        if other.mass > 0.0 {
            Self { mass, com, inertia }
        } else {
            Self { inertia: self.inertia + other.inertia, ..*self }
        }
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
    let matter = Matter::of(&link).placed(by);
    (link.com, link.inertia) = (matter.com, matter.inertia);
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
    let matter = Matter::of(link).with(&Matter::of(&other));
    (link.mass, link.com, link.inertia) = (matter.mass, matter.com, matter.inertia);
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
