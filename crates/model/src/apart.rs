//! The pairs of links that can come to each other.

use crate::figure::Figure;
use crate::link::Link;

impl Figure {
    /// Pairs of links with a shape, the smaller index first, that are neither neighbours nor parts of one body: what can touch without
    /// being joined.
    ///
    /// Neighbours are links on whose way through the tree, from one to the other, every link in between is without a shape: a
    /// joint alone is such a way. A root that stands still without mass and shape is the world, which joins nothing. Links without
    /// a degree of freedom between them are one body.
    #[doc(alias = "collision")]
    #[doc(alias = "self-collision")]
    pub fn pairs_apart(&self) -> Vec<[usize; 2]> {
        let links = self.links();
        let (bodies, world) = (bodies(links), is_world(&links[0]));
        let shaped: Vec<usize> = (0..links.len()).filter(|i| links[*i].shape().is_some()).collect();
        let mut pairs = Vec::new();
        for (k, &first) in shaped.iter().enumerate() {
            let others = shaped[k + 1..].iter().filter(|second| {
                bodies[first] != bodies[**second] && !are_neighbours(links, first, **second, world)
            });
            pairs.extend(others.map(|second| [first, *second]));
        }
        pairs
    }
}

/// Whether a root only says where the world is.
fn is_world(root: &Link) -> bool {
    root.joint().kind().nv() == 0 && root.mass() <= 0.0 && root.shape().is_none()
}

/// Of each link, the first of those that it moves as one with.
fn bodies(links: &[Link]) -> Vec<usize> {
    let mut bodies: Vec<usize> = Vec::with_capacity(links.len());
    for (i, link) in links.iter().enumerate() {
        let with = link.parent().filter(|_| link.joint().kind().nv() == 0);
        bodies.push(with.map_or(i, |parent| bodies[parent]));
    }
    bodies
}

fn are_neighbours(links: &[Link], first: usize, second: usize, world: bool) -> bool {
    // Parents have smaller indices: the greater of both is never above the other.
    let (mut low, mut high) = (first, second);
    while low != high {
        if low > high {
            (low, high) = (high, low);
        }
        let Some(parent) = links[high].parent().filter(|parent| !world || *parent != 0) else { return false };
        high = parent;
        if high != first && high != second && links[high].shape().is_some() {
            return false;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use crate::{FigureBuilder, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind};

    /// Links by name, parent, and whether they turn and have a shape.
    fn named(links: &[(&str, &str, bool, bool)]) -> Vec<String> {
        let mut builder = FigureBuilder::new("tree");
        for (name, parent, turns, has_shape) in links {
            let joint = Joint::new(format!("{name}_joint"));
            let joint = if *turns { joint.rx() } else { joint };
            let mut link = match *parent {
                "" => LinkSpec::root(*name, joint),
                parent => LinkSpec::child(*name, parent, joint),
            };
            if *has_shape {
                let kind = ShapeKind::Sphere { radius: 0.1 };
                link = link.shape(Shape { kind, placement: Placement::identity() });
            }
            builder = builder.link(link.mass(1.0));
        }
        let figure = builder.build().expect("valid");
        let name = |i: usize| figure.links()[i].name();
        figure.pairs_apart().into_iter().map(|[a, b]| format!("{}-{}", name(a), name(b))).collect()
    }

    #[test]
    fn neighbours_are_left_out_and_siblings_are_not() {
        let found = named(&[
            ("a", "", true, true),
            ("b", "a", true, true),
            ("c", "b", true, true),
            ("d", "a", true, true),
        ]);
        assert_eq!(found, ["a-c", "b-d", "c-d"]);
    }

    #[test]
    fn a_link_without_a_shape_joins_what_it_stands_between() {
        let found = named(&[
            ("a", "", true, true),
            ("none", "a", true, false),
            ("b", "none", true, true),
            ("c", "none", true, true),
            ("d", "b", true, true),
        ]);
        assert_eq!(found, ["a-d", "c-d"]);
        assert_eq!(
            named(&[("none", "", true, false), ("a", "none", true, true), ("b", "none", true, true)]),
            [""; 0]
        );
    }

    #[test]
    fn figures_in_one_world_are_no_neighbours() {
        let world = LinkSpec::root("world", Joint::new("world")).inertia(Inertia::Point);
        let ball = |name: &str| {
            let shape = Shape { kind: ShapeKind::Sphere { radius: 0.1 }, placement: Placement::identity() };
            LinkSpec::child(name, "world", Joint::new(name).tx()).mass(1.0).shape(shape)
        };
        let figure = FigureBuilder::new("balls").link(world).link(ball("a")).link(ball("b"));
        assert_eq!(figure.build().expect("valid").pairs_apart(), [[1, 2]]);
    }

    #[test]
    fn what_is_one_body_is_not_measured_against_itself() {
        let found = named(&[
            ("a", "", true, true),
            ("b", "a", false, true),
            ("c", "b", false, true),
            ("d", "c", true, true),
        ]);
        assert_eq!(found, ["a-d", "b-d"]);
    }
}
