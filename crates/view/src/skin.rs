//! Common skins of links, so that a trunk of several ellipsoids is one body.

use nalgebra::UnitQuaternion;
use serde::Serialize;
use solaris_model::{Figure, Link, ShapeKind};

/// A skin between two ellipsoids that follow each other, such as those of the trunk.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Skin {
    pub(crate) parent: usize,
    pub(crate) child: usize,
    /// The child's joint in the parent's frame (m).
    offset: [f64; 3],
}

/// The skins: wherever an ellipsoid's joint hangs, unturned, on another ellipsoid.
pub(crate) fn skins(figure: &Figure) -> Vec<Skin> {
    let links = figure.links();
    let unturned = |rotation: &UnitQuaternion<f64>| rotation.angle() < 1e-9;
    let smooth = |link: &Link| {
        let shape = link.shape().filter(|shape| matches!(shape.kind, ShapeKind::Ellipsoid { .. }));
        shape.is_some_and(|shape| unturned(&shape.placement.rotation))
    };
    let skin = |(child, link): (usize, &Link)| {
        let parent = link.parent()?;
        let placement = link.joint().placement();
        let joined = smooth(link) && smooth(&links[parent]) && unturned(&placement.rotation);
        joined.then(|| Skin { parent, child, offset: placement.translation.vector.into() })
    };
    links.iter().enumerate().filter_map(skin).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::human;

    #[test]
    fn the_trunk_and_the_feet_have_skins() {
        let figure = human(1.75, 73.0).expect("a person");
        let names: Vec<&str> = skins(&figure).iter().map(|skin| figure.links()[skin.child].name()).collect();
        assert_eq!(names, ["abdomen", "thorax", "left_toes", "right_toes"]);
    }
}
