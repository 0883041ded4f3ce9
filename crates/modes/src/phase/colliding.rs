//! Links of the small figure that can touch each other.

use super::reduction::Source;
use crate::body::Body;
use crate::collision::{Colliders, placed};
use nalgebra::Vector3;
use solaris_model::LinkPlace;
#[cfg(feature = "collide")]
use solaris_model::Shape;

/// Pairs as near as this (m) may touch within a step, whatever their velocities.
const CLOSE: f64 = 2e-3;

/// Links that can touch each other, as far as dynamics move one of them.
#[derive(Clone)]
pub(super) struct Colliding {
    pub(super) friction: f64,
    colliders: Colliders,
    /// The links of each pair in the full figure, and in the small one.
    links: Vec<[(usize, usize); 2]>,
    /// How far each pair may come within the step (m).
    reach: Vec<f64>,
    /// What touches, or may within the step.
    pub(super) met: Vec<Met>,
    /// Where the links of which pair pushed each other in the step before, and how (N s).
    before: Vec<(usize, Vector3<f64>, f64)>,
}

/// Where two links touch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Met {
    pub(super) pair: usize,
    /// In the full figure, and in the small one.
    pub(super) links: [(usize, usize); 2],
    /// In the world (m).
    pub(super) point: Vector3<f64>,
    /// Two directions along the surfaces, and that out of the second link into the first.
    pub(super) axes: [Vector3<f64>; 3],
    /// How far apart (m), negative where they overlap.
    pub(super) gap: f64,
}

impl Colliding {
    /// Those with a link that is `moved`; `place` says which link of the small figure carries one of the full figure, and where.
    #[cfg(feature = "collide")]
    pub(super) fn of(
        source: &Source,
        moved: &[bool],
        place: impl Fn(usize) -> Option<LinkPlace>,
    ) -> Option<Self> {
        let collisions = source.collisions.as_ref()?;
        let (mut shapes, mut pairs, mut links) = (Vec::<(usize, Shape)>::new(), Vec::new(), Vec::new());
        let mut index = vec![None; moved.len()];
        // What a loop holds together is joined.
        let is_joined = |pair: &[usize; 2]| {
            source.closed.iter().any(|(_, closed)| {
                let ends = closed.between.map(|anchor| anchor.link);
                ends == pair.map(Some) || ends == [pair[1], pair[0]].map(Some)
            })
        };
        let can_touch = |pair: &&[usize; 2]| pair.iter().any(|link| moved[*link]) && !is_joined(pair);
        for pair in collisions.pairs.iter().filter(can_touch) {
            let ends = pair.map(|link| {
                let LinkPlace { link: small, placement } = place(link)?;
                let shape = source.figure.links()[link].shape()?;
                let shape = Shape { placement: placement * shape.placement, ..*shape };
                let index = *index[link].get_or_insert_with(|| {
                    shapes.push((small, shape));
                    shapes.len() - 1
                });
                Some((index, (link, small)))
            });
            if let [Some((a, first)), Some((b, second))] = ends
                && first.1 != second.1
            {
                pairs.push([a, b]);
                links.push([first, second]);
            }
        }
        let count = pairs.len();
        (count > 0).then(|| Self {
            friction: collisions.friction,
            colliders: Colliders::new(&shapes, pairs),
            links,
            reach: vec![0.0; count],
            met: Vec::with_capacity(4 * count),
            before: Vec::with_capacity(4 * count),
        })
    }

    #[cfg(not(feature = "collide"))]
    pub(super) fn of(_: &Source, _: &[bool], _: impl Fn(usize) -> Option<LinkPlace>) -> Option<Self> {
        None
    }

    /// Keeps where links push each other, and how (N s), in the order of what [met](Self::met).
    pub(super) fn remember(&mut self, pushes: impl Iterator<Item = f64>) {
        self.before.clear();
        let pushed = self.met.iter().zip(pushes).filter(|(_, push)| *push > 0.0);
        self.before.extend(pushed.map(|(met, push)| (met.pair, met.point, push)));
    }

    /// How links pushed each other in the step before (N s), nearest to where they touch now; 0 where they did not.
    pub(super) fn pushed_before(&self, met: &Met) -> f64 {
        let own = self.before.iter().filter(|(pair, ..)| *pair == met.pair);
        let nearest = own.min_by(|a, b| (a.1 - met.point).norm().total_cmp(&(b.1 - met.point).norm()));
        nearest.map_or(0.0, |(.., push)| *push)
    }

    /// How many pairs there are.
    pub(super) fn len(&self) -> usize {
        self.links.len()
    }

    /// Finds what touches within a time `within` (s), at the poses and velocities of links that `body` has.
    pub(super) fn find(&mut self, body: &Body<f64>, within: f64) {
        let Self { colliders, links, reach, met, .. } = self;
        for (pair, reach) in reach.iter_mut().enumerate() {
            let speed = |(link, radius)| {
                let twist = body.velocity(link);
                twist.linear.norm() + twist.angular.norm() * radius
            };
            *reach = CLOSE + within * colliders.pair(pair).map(speed).iter().sum::<f64>();
        }
        met.clear();
        colliders.touches(
            |link| placed(body.pose(link)),
            |pair| reach[pair],
            |touch| {
                let out = touch.normal;
                let aside = out.cross(&Vector3::ith(out.iamin(), 1.0)).normalize();
                let axes = [aside, out.cross(&aside), out];
                let links = links[touch.pair];
                met.push(Met { pair: touch.pair, links, point: touch.point, axes, gap: touch.gap });
            },
        );
    }
}
