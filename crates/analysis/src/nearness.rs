//! Nearness: the least distance between links of a figure in a motion.

mod clearance;
mod fill;
mod flyers;
mod limbs;
mod outlines;
mod segment;

pub use clearance::Clearance;
pub use limbs::{LimbOverlap, NearSpell, NearestLimbs};

use flyers::Flyers;
use outlines::{Outlines, Pair};
use solaris_dynamics::{DynamicsError, Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, Motion, MotionError};

/// The least distance between two links of a figure, in every frame of a motion.
///
/// Distances are negative where shapes overlap: how deep, by the least way that parts the two capsules (or spheres) that
/// are deepest in each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearness {
    /// The pairs of what is joined that are measured, by indices of links, the smaller first.
    pub pairs: Vec<[usize; 2]>,
    /// How many pairs more are measured: links of what [flies apart](Figure::flyers), one figure from another.
    pub of_others: usize,
    /// The pairs that are not, because they overlap by construction: in the neutral configuration, every joint at zero.
    pub left_out: Vec<[usize; 2]>,
    /// The nearest pair of every frame; that with the first links where several are as near.
    pub frames: Vec<Near>,
    /// Over all frames, the first where several are as near.
    pub nearest: Nearest,
}

/// The nearest pair of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near {
    /// Distance (m), negative for the depth of an overlap.
    pub distance: f64,
    /// Which links (indices), the smaller first.
    pub links: [usize; 2],
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
/// between them, and pairs that overlap in the neutral configuration unless they fly apart.
///
/// Capsules and spheres are exact: the distance of their segments, less both radii. Ellipsoids, boxes and cylinders are
/// filled with capsules from inside. What is measured is thus never nearer than what is there, and an overlap is one: a
/// person's ellipsoids are filled to within 4 mm, boxes and cylinders have their edges rounded by their least half
/// thickness, and wide boxes grooves of 0.13 of it where up to nine capsules are enough.
///
/// Pairs whose bounding spheres are farther apart than what was found are passed over, first those of whole figures, and so are parts of
/// links that a plane between them keeps farther apart. Nothing is allocated for a frame.
///
/// # Errors
///
/// [`NearnessError`]: a motion of another figure, and what the kernel refuses.
#[doc(alias = "self-collision")]
#[doc(alias = "collision")]
#[doc(alias = "minimum distance")]
pub fn nearness(figure: &Figure, motion: &Motion) -> Result<Option<Nearness>, NearnessError> {
    nearness_but(figure, motion, &[])
}

/// The same without these pairs of links (indices), such as those that a loop holds together.
///
/// # Errors
///
/// As for [`nearness`].
pub fn nearness_but(
    figure: &Figure,
    motion: &Motion,
    joined: &[[usize; 2]],
) -> Result<Option<Nearness>, NearnessError> {
    motion.check_figure(figure)?;
    let flyers = Flyers::of(figure, joined);
    let is_joined = |[a, b]: [usize; 2]| joined.contains(&[a, b]) || joined.contains(&[b, a]);
    let candidates = flyers.groups().flat_map(|links| figure.pairs_apart_among(links));
    let candidates: Vec<[usize; 2]> = candidates.filter(|pair| !is_joined(*pair)).collect();
    if (candidates.is_empty() && flyers.pairs() == 0) || motion.is_empty() {
        return Ok(None);
    }
    let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
    let mut workspace = Workspace::new(&tree);
    let mut outlines = Outlines::new(figure, flyers);

    let mut q = vec![0.0; tree.nq()];
    // What is refused is a wrong length.
    let _ = figure.neutral(&mut q);
    forward_kinematics(&tree, &mut workspace, &q)?;
    outlines.place(&workspace);
    let mut pairs: Vec<Pair> = candidates.into_iter().map(Pair::new).collect();
    let mut left_out = Vec::new();
    pairs.retain_mut(|pair| {
        let overlaps = !figure.fly_apart(pair.links)
            && outlines.between(pair, 0.0).is_some_and(|distance| distance < 0.0);
        left_out.extend(overlaps.then_some(pair.links));
        !overlaps
    });
    let of_others = outlines.flyers.pairs();
    if pairs.is_empty() && of_others == 0 {
        return Ok(None);
    }

    let mut frames: Vec<Near> = Vec::with_capacity(motion.len());
    let (mut first, mut worst) = (None, 0);
    for frame in 0..motion.len() {
        forward_kinematics(&tree, &mut workspace, motion.q(frame))?;
        outlines.place(&workspace);
        let near = outlines.nearest(&mut pairs, first);
        if frame == 0 || near.distance < frames[worst].distance {
            worst = frame;
        }
        first = Some(near.links);
        frames.push(near);
    }
    let Near { distance, links } = frames[worst];
    let links = links.map(|link| figure.links()[link].name().to_owned());
    let nearest = Nearest { distance, time: motion.time()[worst], links };
    let pairs = pairs.iter().map(|pair| pair.links).collect();
    Ok(Some(Nearness { pairs, of_others, left_out, frames, nearest }))
}
