//! Nearness: the least distance between links of a figure in a motion.

mod fill;
mod limbs;
mod pairs;
mod segment;

pub use limbs::{LimbOverlap, NearSpell, NearestLimbs};

use fill::{Capsule, fill};
use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, Motion, MotionError};

/// The least distance between two links of a figure, in every frame of a motion.
///
/// Distances are negative where shapes overlap: how deep, by the least way that parts the two capsules (or spheres) that
/// are deepest in each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearness {
    /// The pairs that are measured, by indices of links, the smaller first.
    pub pairs: Vec<[usize; 2]>,
    /// The pairs that are not, because they overlap by construction: in the neutral configuration, every joint at zero.
    pub left_out: Vec<[usize; 2]>,
    /// The nearest pair of every frame; the first of [`Self::pairs`] where several are as near.
    pub frames: Vec<Near>,
    /// Over all frames, the first where several are as near.
    pub nearest: Nearest,
}

/// The nearest pair of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near {
    /// Distance (m), negative for the depth of an overlap.
    pub distance: f64,
    /// Which pair, an index into [`Nearness::pairs`].
    pub pair: usize,
}

/// The nearest pair of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest {
    /// Distance (m), negative for the depth of an overlap.
    pub distance: f64,
    /// When (s).
    pub time: f64,
    /// The names of both links, in the order of the figure.
    pub links: [String; 2],
}

/// Why a motion cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NearnessError {
    /// The kernel refused.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// The motion is not one of this figure.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// Measures in every frame how near links come to each other that are not neighbours; `None` where there is no such pair
/// of links with shapes, or no frame.
///
/// Left out are neighbours (links joined by a joint, or through links without a shape), links without a degree of freedom
/// between them, and pairs that overlap in the neutral configuration.
///
/// Capsules and spheres are exact: the distance of their segments, less both radii. Ellipsoids, boxes and cylinders are
/// filled with capsules from inside. What is measured is thus never nearer than what is there, and an overlap is one: a
/// person's ellipsoids are filled to within 4 mm, boxes and cylinders have their edges rounded by their least half
/// thickness, and wide boxes grooves of 0.13 of it where up to nine capsules are enough.
///
/// Pairs whose bounding spheres are farther apart than what was found are passed over. Nothing is allocated for a frame.
///
/// # Errors
///
/// [`NearnessError`]: a motion of another figure, and what the kernel refuses.
#[doc(alias = "self-collision")]
#[doc(alias = "collision")]
#[doc(alias = "minimum distance")]
pub fn nearness(figure: &Figure, motion: &Motion) -> Result<Option<Nearness>, NearnessError> {
    motion.check_figure(figure)?;
    let candidates = pairs::pairs(figure.links());
    if candidates.is_empty() || motion.is_empty() {
        return Ok(None);
    }
    let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
    let mut workspace = Workspace::new(&tree);
    let mut outlines = Outlines::new(figure);

    let mut q = vec![0.0; tree.nq()];
    // What is refused is a wrong length.
    let _ = figure.neutral(&mut q);
    forward_kinematics(&tree, &mut workspace, &q)?;
    outlines.place(&workspace);
    let overlaps = |pair: &[usize; 2]| outlines.between(*pair, 0.0).is_some_and(|distance| distance < 0.0);
    let (left_out, pairs): (Vec<_>, Vec<_>) = candidates.into_iter().partition(overlaps);
    if pairs.is_empty() {
        return Ok(None);
    }

    let mut frames: Vec<Near> = Vec::with_capacity(motion.len());
    let (mut first, mut worst) = (0, 0);
    for frame in 0..motion.len() {
        forward_kinematics(&tree, &mut workspace, motion.q(frame))?;
        outlines.place(&workspace);
        let near = outlines.nearest(&pairs, first);
        if frame == 0 || near.distance < frames[worst].distance {
            worst = frame;
        }
        first = near.pair;
        frames.push(near);
    }
    let Near { distance, pair } = frames[worst];
    let links = pairs[pair].map(|link| figure.links()[link].name().to_owned());
    let nearest = Nearest { distance, time: motion.time()[worst], links };
    Ok(Some(Nearness { pairs, left_out, frames, nearest }))
}

/// What fills the links, in their own frames and in the world.
struct Outlines {
    /// Of each link, where its parts begin and end.
    parts: Vec<std::ops::Range<usize>>,
    own: Vec<Capsule>,
    placed: Vec<Part>,
    /// About all parts of a link, in its frame and in the world; without a meaning for a link without parts.
    around: Vec<Ball>,
    placed_around: Vec<Ball>,
}

/// A capsule in the world, and the sphere about it.
#[derive(Clone, Copy)]
struct Part {
    capsule: Capsule,
    around: Ball,
}

#[derive(Clone, Copy)]
struct Ball {
    center: Vector3<f64>,
    radius: f64,
}

impl Ball {
    fn about(Capsule { ends: [a, b], radius }: &Capsule) -> Self {
        Self { center: (a + b) / 2.0, radius: (b - a).norm() / 2.0 + radius }
    }

    /// What lies in the two is not nearer than this (m), and no deeper in each other.
    fn apart(&self, other: &Self) -> f64 {
        (self.center - other.center).norm() - self.radius - other.radius
    }
}

impl Outlines {
    fn new(figure: &Figure) -> Self {
        let (mut parts, mut own, mut around) = (Vec::new(), Vec::new(), Vec::new());
        for link in figure.links() {
            let (begin, center) = (own.len(), link.shape().map(|shape| shape.placement.translation.vector));
            own.extend(link.shape().map(fill).unwrap_or_default());
            parts.push(begin..own.len());
            let center = center.unwrap_or_default();
            let reach = |capsule: &Capsule| {
                let far = capsule.ends.map(|end| (end - center).norm());
                far[0].max(far[1]) + capsule.radius
            };
            let radius = own[begin..].iter().map(reach).fold(0.0, f64::max);
            around.push(Ball { center, radius });
        }
        let placed = own.iter().map(|capsule| Part { capsule: *capsule, around: Ball::about(capsule) });
        Self { placed: placed.collect(), placed_around: around.clone(), parts, own, around }
    }

    /// Puts all where the workspace says that the links are.
    fn place(&mut self, workspace: &Workspace<f64>) {
        for (link, parts) in self.parts.iter().enumerate().filter(|(_, parts)| !parts.is_empty()) {
            let pose = workspace.pose(link);
            let Ball { center, radius } = self.around[link];
            self.placed_around[link] = Ball { center: pose.transform(&center), radius };
            for (placed, own) in self.placed[parts.clone()].iter_mut().zip(&self.own[parts.clone()]) {
                placed.capsule.ends = own.ends.map(|end| pose.transform(&end));
                placed.around.center = (placed.capsule.ends[0] + placed.capsule.ends[1]) / 2.0;
            }
        }
    }

    /// How far two links are apart (m); `None` where it is more than `limit`.
    fn between(&self, [first, second]: [usize; 2], limit: f64) -> Option<f64> {
        let (first_around, second_around) = (&self.placed_around[first], &self.placed_around[second]);
        if first_around.apart(second_around) > limit {
            return None;
        }
        let (mut least, mut found) = (limit, None);
        for one in &self.placed[self.parts[first].clone()] {
            if one.around.apart(second_around) > least {
                continue;
            }
            for other in &self.placed[self.parts[second].clone()] {
                if one.around.apart(&other.around) > least {
                    continue;
                }
                let (one, other) = (&one.capsule, &other.capsule);
                let distance = segment::distance(&one.ends, &other.ends) - one.radius - other.radius;
                if distance <= least {
                    (least, found) = (distance, Some(distance));
                }
            }
        }
        found
    }

    /// The nearest of these pairs. The one that is measured `first` only saves work: the result is the same.
    fn nearest(&self, pairs: &[[usize; 2]], first: usize) -> Near {
        let distance = self.between(pairs[first], f64::INFINITY).unwrap_or(f64::INFINITY);
        let mut near = Near { distance, pair: first };
        for (pair, links) in pairs.iter().enumerate() {
            if let Some(distance) = self.between(*links, near.distance)
                && (distance < near.distance || pair < near.pair)
            {
                near = Near { distance, pair };
            }
        }
        near
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use solaris_model::human;

    /// What is passed over is not nearer: every part against every part gives the same, to the bit, whatever pair is
    /// measured first.
    #[test]
    fn pruning_changes_nothing() {
        let figure = human(1.75, 73.0).expect("within range");
        let random = &mut Random(11);
        let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("a tree");
        let (mut workspace, mut outlines) = (Workspace::new(&tree), Outlines::new(&figure));
        let pairs = pairs::pairs(figure.links());
        let mut q = vec![0.0; tree.nq()];
        for _ in 0..20 {
            figure.random(&mut q, || random.next()).expect("a valid source");
            forward_kinematics(&tree, &mut workspace, &q).expect("within reach");
            outlines.place(&workspace);
            let whole = |[first, second]: [usize; 2]| {
                let parts = |link: usize| outlines.placed[outlines.parts[link].clone()].iter();
                let all =
                    parts(first).flat_map(|one| parts(second).map(move |other| (one.capsule, other.capsule)));
                let apart = |(one, other): (Capsule, Capsule)| {
                    segment::distance(&one.ends, &other.ends) - one.radius - other.radius
                };
                all.map(apart).fold(f64::INFINITY, f64::min)
            };
            let all = pairs.iter().map(|pair| whole(*pair)).enumerate();
            let (pair, distance) = all.min_by(|a, b| a.1.total_cmp(&b.1)).expect("some pairs");
            for first in [0, random.below(pairs.len()), pairs.len() - 1] {
                assert_eq!(outlines.nearest(&pairs, first), Near { distance, pair });
            }
        }
    }
}
