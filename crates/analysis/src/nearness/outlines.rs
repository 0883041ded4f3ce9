//! What fills the links of a figure, where they stand, and which of them are the nearest.

use super::fill::{Capsule, fill};
use super::flyers::Flyers;
use super::{Near, segment};
use nalgebra::{Matrix3, Vector3};
use solaris_dynamics::{Pose, Workspace};
use solaris_model::{Figure, Link, Placement, ShapeKind};

/// What rounding may take off a bound (m).
const SLACK: f64 = 1e-9;

/// Two links, the smaller index first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) links: [usize; 2],
    /// A part of each, and a direction from one to the other: of those that were the nearest when they were measured last. They
    /// only save work.
    parts: [usize; 2],
    toward: Vector3<f64>,
}

impl Pair {
    /// The first part of a link is in its middle, or at its side.
    pub(super) fn new(links: [usize; 2]) -> Self {
        Self { links, parts: [0; 2], toward: Vector3::x() }
    }
}

/// A sphere.
#[derive(Clone, Copy)]
struct Ball {
    center: Vector3<f64>,
    radius: f64,
}

impl Ball {
    /// What lies in the two is not nearer than this (m), and no deeper in each other.
    fn apart(&self, other: &Self) -> f64 {
        (self.center - other.center).norm() - self.radius - other.radius
    }
}

/// What fills a link, in its own frame.
struct Outline {
    parts: Vec<Capsule>,
    /// About all of them; without a meaning where there are none.
    around: Ball,
    /// The ellipsoid or box that they lie in: its middle, its semi-axes as rows, whether it is round.
    middle: Vector3<f64>,
    semi_axes: Matrix3<f64>,
    is_round: bool,
}

impl Outline {
    fn of(link: &Link) -> Self {
        let parts = link.shape().map(fill).unwrap_or_default();
        let placement = link.shape().map_or_else(Placement::identity, |shape| shape.placement);
        let (center, mut radius) = (placement.translation.vector, 0.0_f64);
        let [mut lower, mut upper] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector3::repeat);
        for capsule in &parts {
            for end in &capsule.ends {
                radius = radius.max((end - center).norm() + capsule.radius);
                lower = lower.inf(&end.add_scalar(-capsule.radius));
                upper = upper.sup(&end.add_scalar(capsule.radius));
            }
        }
        let round = link.shape().and_then(|shape| match shape.kind {
            ShapeKind::Ellipsoid { radii } => Some(radii),
            _ => None,
        });
        let (middle, semi_axes) = match &round {
            Some(radii) => {
                let turned = placement.rotation.to_rotation_matrix();
                (center, Matrix3::from_diagonal(radii) * turned.matrix().transpose())
            }
            None => ((lower + upper) / 2.0, Matrix3::from_diagonal(&((upper - lower) / 2.0))),
        };
        Self { parts, around: Ball { center, radius }, middle, semi_axes, is_round: round.is_some() }
    }

    /// How far each part reaches from the link's origin in a direction of the link, and the farthest of them.
    fn reaches(&self, direction: &Vector3<f64>, reaches: &mut Vec<f64>) -> f64 {
        reaches.clear();
        let mut most = f64::NEG_INFINITY;
        for Capsule { ends: [a, b], radius } in &self.parts {
            let reach = direction.dot(a).max(direction.dot(b)) + radius;
            most = most.max(reach);
            reaches.push(reach);
        }
        most
    }

    /// What no part reaches beyond.
    fn reach(&self, direction: &Vector3<f64>) -> f64 {
        let along = self.semi_axes * direction;
        direction.dot(&self.middle) + if self.is_round { along.norm() } else { along.abs().sum() }
    }
}

/// What fills the links, and where they stand.
pub(super) struct Outlines {
    own: Vec<Outline>,
    poses: Vec<Pose<f64>>,
    around: Vec<Ball>,
    pub(super) flyers: Flyers,
    /// About all that flies together.
    about: Vec<Ball>,
    /// How far each part of two links reaches towards the other one.
    reaches: [Vec<f64>; 2],
}

impl Outlines {
    pub(super) fn new(figure: &Figure, flyers: Flyers) -> Self {
        let own: Vec<Outline> = figure.links().iter().map(Outline::of).collect();
        let most = own.iter().map(|outline| outline.parts.len()).max().unwrap_or(0);
        let about = vec![Ball { center: Vector3::zeros(), radius: 0.0 }; flyers.groups().len()];
        Self {
            poses: vec![Pose::identity(); own.len()],
            around: own.iter().map(|outline| outline.around).collect(),
            reaches: [Vec::with_capacity(most), Vec::with_capacity(most)],
            about,
            flyers,
            own,
        }
    }

    /// Puts all where the workspace says that the links are.
    pub(super) fn place(&mut self, workspace: &Workspace<f64>) {
        for (link, own) in self.own.iter().enumerate().filter(|(_, own)| !own.parts.is_empty()) {
            let pose = workspace.pose(link);
            self.poses[link] = *pose;
            self.around[link].center = pose.transform(&own.around.center);
        }
        for (about, links) in self.about.iter_mut().zip(self.flyers.groups()) {
            let balls = || links.iter().map(|link| &self.around[*link]);
            about.center = balls().map(|ball| ball.center).sum::<Vector3<f64>>() / links.len() as f64;
            let reach = |ball: &Ball| (ball.center - about.center).norm() + ball.radius;
            about.radius = balls().map(reach).fold(0.0, f64::max);
        }
    }

    /// The nearest of these pairs and of those of what flies apart. That of the links that are measured `first` only saves work: the
    /// result is the same.
    pub(super) fn nearest(&mut self, pairs: &mut [Pair], first: Option<[usize; 2]>) -> Near {
        let mut near = Near { distance: f64::INFINITY, links: [usize::MAX; 2] };
        if let Some(links) = first
            && let Some(distance) = self.between(&mut Pair::new(links), f64::INFINITY)
        {
            near = Near { distance, links };
        }
        for pair in pairs {
            self.compare(pair, &mut near);
        }
        for one in 0..self.about.len() {
            for other in one + 1..self.about.len() {
                if self.about[one].apart(&self.about[other]) <= near.distance + SLACK {
                    self.compare_flyers([one, other], &mut near);
                }
            }
        }
        near
    }

    /// Measures a pair if it may be nearer.
    fn compare(&mut self, pair: &mut Pair, near: &mut Near) {
        if let Some(distance) = self.between(pair, near.distance)
            && (distance < near.distance || pair.links < near.links)
        {
            *near = Near { distance, links: pair.links };
        }
    }

    /// Measures the pairs of links of two that fly apart.
    fn compare_flyers(&mut self, [one, other]: [usize; 2], near: &mut Near) {
        let of = |outlines: &Self, group: usize, k: usize| outlines.flyers.links(group).get(k).copied();
        let mut i = 0;
        while let Some(first) = of(self, one, i) {
            i += 1;
            if self.around[first].apart(&self.about[other]) > near.distance + SLACK {
                continue;
            }
            let mut j = 0;
            while let Some(second) = of(self, other, j) {
                j += 1;
                let links = [first.min(second), first.max(second)];
                if self.around[first].apart(&self.around[second]) > near.distance + SLACK
                    || self.flyers.are_joined(links)
                {
                    continue;
                }
                let [from, to] = links.map(|link| self.around[link].center);
                let mut pair = Pair::new(links);
                pair.toward = (to - from).try_normalize(0.0).unwrap_or(pair.toward);
                self.compare(&mut pair, near);
            }
        }
    }

    /// How far two links are apart (m); `None` where it is more than `limit`.
    pub(super) fn between(&mut self, pair: &mut Pair, limit: f64) -> Option<f64> {
        let [first, second] = pair.links;
        if self.around[first].apart(&self.around[second]) > limit + SLACK || self.is_kept_apart(pair, limit) {
            return None;
        }
        let distance = self.measure(pair, limit);
        (distance <= limit).then_some(distance)
    }

    /// Whether a plane across the pair's direction keeps its links farther apart than `limit` (m).
    fn is_kept_apart(&self, pair: &Pair, limit: f64) -> bool {
        let [first, second] = pair.links;
        let reaches = self.own[first].reach(&self.of_link(first, &pair.toward))
            + self.own[second].reach(&self.of_link(second, &-pair.toward));
        self.along(pair) - reaches > limit + SLACK
    }

    /// The distance of two links (m), or one that is more than `limit` where theirs is.
    ///
    /// The parts that were the nearest before tell a distance that occurs, and with the shortest way between them, of direction
    /// `e`, which others cannot be nearer:
    ///
    /// ```text
    /// distance ≥ e·(x₂ − x₁) − h₁ − h₂      h = how far a part reaches from its link's origin x: the first along e, the second along −e
    /// ```
    fn measure(&mut self, pair: &mut Pair, limit: f64) -> f64 {
        let [first, second] = pair.links;
        let (one, other) = (self.part(first, pair.parts[0]), self.part(second, pair.parts[1]));
        let way = segment::shortest(&one.ends, &other.ends);
        let mut nearest = way.norm() - one.radius - other.radius;
        pair.toward = way.try_normalize(0.0).unwrap_or(pair.toward);
        let along = self.along(pair);
        let directions = [self.of_link(first, &pair.toward), self.of_link(second, &-pair.toward)];
        let [reaches, others] = &mut self.reaches;
        self.own[first].reaches(&directions[0], reaches);
        let others_most = self.own[second].reaches(&directions[1], others);
        let [reaches, others] = &self.reaches;
        for (i, reach) in reaches.iter().enumerate() {
            if along - reach - others_most > nearest.min(limit) + SLACK {
                continue;
            }
            let one = self.part(first, i);
            for (j, others_reach) in others.iter().enumerate() {
                if along - reach - others_reach > nearest.min(limit) + SLACK {
                    continue;
                }
                let other = self.part(second, j);
                let distance = segment::shortest(&one.ends, &other.ends).norm() - one.radius - other.radius;
                if distance < nearest {
                    (nearest, pair.parts) = (distance, [i, j]);
                }
            }
        }
        nearest
    }

    /// How far the second link's origin is from the first one's along the pair's direction (m).
    fn along(&self, pair: &Pair) -> f64 {
        let [first, second] = pair.links;
        pair.toward.dot(&(self.poses[second].translation - self.poses[first].translation))
    }

    /// A direction of the world as a link has it.
    fn of_link(&self, link: usize, direction: &Vector3<f64>) -> Vector3<f64> {
        self.poses[link].rotation.tr_mul(direction)
    }

    /// A part of a link, in the world.
    fn part(&self, link: usize, part: usize) -> Capsule {
        let (own, pose) = (&self.own[link].parts[part], &self.poses[link]);
        Capsule { ends: own.ends.map(|end| pose.transform(&end)), radius: own.radius }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use solaris_dynamics::{Tree, forward_kinematics};
    use solaris_model::human;

    /// What is passed over is not nearer: every part against every part gives the same, to the bit, whatever pair is
    /// measured first.
    #[test]
    fn pruning_changes_nothing() {
        let figure = human(1.75, 73.0).expect("within range");
        let random = &mut Random(11);
        let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("a tree");
        let (mut workspace, mut outlines) =
            (Workspace::new(&tree), Outlines::new(&figure, Flyers::of(&figure, &[])));
        let mut pairs: Vec<Pair> = figure.pairs_apart().into_iter().map(Pair::new).collect();
        let mut q = vec![0.0; tree.nq()];
        for _ in 0..20 {
            figure.random(&mut q, || random.next()).expect("a valid source");
            forward_kinematics(&tree, &mut workspace, &q).expect("within reach");
            outlines.place(&workspace);
            let whole = |[first, second]: [usize; 2]| {
                let parts = |link: usize| (0..outlines.own[link].parts.len()).map(move |part| (link, part));
                let placed = |(link, part): (usize, usize)| outlines.part(link, part);
                let others: Vec<Capsule> = parts(second).map(placed).collect();
                let all =
                    parts(first).map(placed).flat_map(|one| others.iter().map(move |other| (one, *other)));
                let apart = |(one, other): (Capsule, Capsule)| {
                    segment::shortest(&one.ends, &other.ends).norm() - one.radius - other.radius
                };
                all.map(apart).fold(f64::INFINITY, f64::min)
            };
            let all = pairs.iter().map(|pair| (pair.links, whole(pair.links)));
            let (links, distance) = all.min_by(|a, b| a.1.total_cmp(&b.1)).expect("some pairs");
            for first in [0, random.below(pairs.len()), pairs.len() - 1] {
                let first = Some(pairs[first].links);
                assert_eq!(outlines.nearest(&mut pairs, first), Near { distance, links });
            }
            assert_eq!(outlines.nearest(&mut pairs, None), Near { distance, links });
        }
    }
}
