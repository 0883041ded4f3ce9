//! The pairs of links that can come to each other.

use crate::figure::Figure;
use crate::link::Link;

impl Figure {
    /// Pairs of links with a shape, the smaller index first, that are neither neighbours nor parts of one body: what can touch without
    /// being joined.
    ///
    /// Neighbours are links on whose way through the tree, from one to the other, every link in between is without a shape: a
    /// joint alone is such a way. What [flies apart](Self::fly_apart) is not joined, nor is what only hangs from one world, a root that
    /// stands still without mass and shape. Links without a degree of freedom between them are one body.
    #[doc(alias = "collision")]
    #[doc(alias = "self-collision")]
    pub fn pairs_apart(&self) -> Vec<[usize; 2]> {
        self.pairs_apart_among(&(0..self.links().len()).collect::<Vec<_>>())
    }

    /// Those of [`pairs_apart`](Self::pairs_apart) that are of these links (indices, which rise).
    pub fn pairs_apart_among(&self, among: &[usize]) -> Vec<[usize; 2]> {
        let links = self.links();
        let bodies = bodies(links);
        let shaped: Vec<usize> = among.iter().copied().filter(|i| links[*i].shape().is_some()).collect();
        let mut pairs = Vec::new();
        for (k, &first) in shaped.iter().enumerate() {
            let others = shaped[k + 1..].iter().map(|second| [first, *second]);
            pairs.extend(others.filter(|[a, b]| bodies[*a] != bodies[*b] && !self.are_neighbours([*a, *b])));
        }
        pairs
    }

    /// The links whose joints are on the way from one link to another: all of both chains down to what carries both.
    pub fn way(&self, pair: [usize; 2]) -> impl Iterator<Item = usize> {
        way(self.links(), pair)
    }

    /// Of each link, the first that flies on the way to it from the root, itself included: by a free joint, or three slides of its own. Two
    /// of which these are not the same [fly apart](Self::fly_apart): in a scene, those of two figures.
    pub fn flyers(&self) -> Vec<Option<usize>> {
        let mut flyers: Vec<Option<usize>> = Vec::with_capacity(self.links().len());
        for (i, link) in self.links().iter().enumerate() {
            let carrier = link.parent().and_then(|parent| flyers[parent]);
            flyers.push(carrier.or_else(|| (link.joint().kind().slides().count() >= 3).then_some(i)));
        }
        flyers
    }

    /// Whether nothing keeps the places of two links together: three slides, or a free joint, are on the way from one to the other.
    pub fn fly_apart(&self, pair: [usize; 2]) -> bool {
        let slides = way(self.links(), pair).map(|link| self.links()[link].joint().kind().slides().count());
        slides.sum::<usize>() >= 3
    }

    fn are_neighbours(&self, pair: [usize; 2]) -> bool {
        let links = self.links();
        let root = &links[0];
        let is_world = root.joint().kind().nv() == 0 && root.mass() <= 0.0 && root.shape().is_none();
        let mut parents = way(links, pair).filter_map(|link| links[link].parent());
        let is_between = |link: usize| !pair.contains(&link);
        !parents.any(|link| is_between(link) && (links[link].shape().is_some() || (is_world && link == 0)))
            && !self.fly_apart(pair)
    }
}

/// The links whose joints are on the way from one link to another: all of both chains down to what carries both.
fn way(links: &[Link], [mut low, mut high]: [usize; 2]) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        if low > high {
            (low, high) = (high, low);
        }
        // Parents have smaller indices: the greater of both is never above the other.
        let link = (low != high).then_some(high)?;
        high = links[high].parent()?;
        Some(link)
    })
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
    fn what_flies_by_itself_is_joined_to_nothing() {
        let shape = Shape { kind: ShapeKind::Sphere { radius: 0.1 }, placement: Placement::identity() };
        let free = |name: &str, joint: Joint| LinkSpec::child(name, "floor", joint).mass(1.0).shape(shape);
        let figure = FigureBuilder::new("scene")
            .link(LinkSpec::root("floor", Joint::new("floor")).mass(1.0).shape(shape))
            .link(free("free", Joint::free("free")))
            .link(free("slides", Joint::new("slides").tx().ty().tz()))
            .link(free("turns", Joint::new("turns").tx().ty().rz()));
        let figure = figure.build().expect("valid");
        assert_eq!(figure.pairs_apart(), [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
        assert!(figure.fly_apart([0, 2]) && !figure.fly_apart([0, 3]) && figure.fly_apart([1, 3]));
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
