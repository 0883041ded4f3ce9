//! The shapes of a figure that can touch each other.

use crate::solid::{Manifold, Solid};
use nalgebra::{Isometry3, Vector3};
use solaris_model::{Figure, Shape, ShapeKind};

/// Shapes on links, and the pairs of them that can touch; with room for what is found.
///
/// | shape | is |
/// |---|---|
/// | box, capsule, sphere | itself |
/// | ellipsoid | itself at the ends of its axes, elsewhere outside of it, by 1/110 of its least semi-axis where the longest is three times as long |
/// | cylinder | itself with its edges rounded, by 1/16 of its radius or half its length, whichever is less |
///
/// What touches with a face has up to eight points, and round shapes one.
#[doc(alias = "self-collision")]
#[doc(alias = "narrow phase")]
#[derive(Clone)]
pub struct Colliders {
    solids: Vec<Placed>,
    /// By index in `solids`.
    pairs: Vec<[usize; 2]>,
    room: Manifold,
}

/// A solid on a link.
#[derive(Clone)]
struct Placed {
    link: usize,
    solid: Solid,
    /// In the link's frame.
    placement: Isometry3<f64>,
    /// In the world.
    pose: Isometry3<f64>,
    /// Of the sphere about the shape's own origin that holds it (m).
    radius: f64,
}

/// Where two shapes touch, or are about to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Which pair, by its index among those that the colliders were made of.
    pub pair: usize,
    /// The links.
    pub links: [usize; 2],
    /// Half way between both (m, world axes).
    pub point: Vector3<f64>,
    /// Out of the second into the first, of length 1 (world axes).
    pub normal: Vector3<f64>,
    /// How far apart (m), negative for the depth of an overlap.
    pub gap: f64,
}

/// What is wrong with pairs of shapes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CollisionError {
    /// A link that the figure does not have.
    #[error("a pair names the link number {link}, and figure '{figure}' has {links} links, numbered from 0")]
    NoLink {
        /// The figure.
        figure: String,
        /// What was asked.
        link: usize,
        /// How many it has.
        links: usize,
    },
    /// A link that nothing can touch.
    #[error(
        "link '{link}' of figure '{figure}' has no shape that could touch another; give it one (a box, capsule, cylinder, ellipsoid or \
         sphere), or leave it out of the pairs"
    )]
    NoShape {
        /// The figure.
        figure: String,
        /// The link.
        link: String,
    },
    /// One link twice.
    #[error("link '{link}' of figure '{figure}' cannot touch itself; a pair has two links")]
    Itself {
        /// The figure.
        figure: String,
        /// The link.
        link: String,
    },
}

impl Colliders {
    /// The shapes of these pairs of links: [`Figure::pairs_apart`] for all that can come to each other.
    ///
    /// # Errors
    ///
    /// [`CollisionError`] for links that are not there, have no shape, or are one.
    pub fn of(figure: &Figure, pairs: &[[usize; 2]]) -> Result<Self, CollisionError> {
        let name = || figure.name().to_owned();
        let mut shapes: Vec<(usize, Shape)> = Vec::new();
        let mut index = vec![None; figure.links().len()];
        let mut of_shapes = Vec::with_capacity(pairs.len());
        for pair in pairs {
            let mut ends = [0; 2];
            for (end, &link) in ends.iter_mut().zip(pair) {
                let links = figure.links().len();
                let found = figure.links().get(link).ok_or_else(|| CollisionError::NoLink {
                    figure: name(),
                    link,
                    links,
                })?;
                let link_name = || found.name().to_owned();
                let shape = found
                    .shape()
                    .ok_or_else(|| CollisionError::NoShape { figure: name(), link: link_name() })?;
                if pair[0] == pair[1] {
                    return Err(CollisionError::Itself { figure: name(), link: link_name() });
                }
                *end = *index[link].get_or_insert_with(|| {
                    shapes.push((link, *shape));
                    shapes.len() - 1
                });
            }
            of_shapes.push(ends);
        }
        Ok(Self::new(&shapes, of_shapes))
    }

    /// Shapes with the index of a link each, whatever that is the index of, and pairs of indices of shapes; a pair that does not fit
    /// is left out.
    pub fn new(shapes: &[(usize, Shape)], mut pairs: Vec<[usize; 2]>) -> Self {
        pairs.retain(|[a, b]| a != b && *a < shapes.len() && *b < shapes.len());
        let placed = |&(link, Shape { kind, placement }): &(usize, Shape)| Placed {
            link,
            solid: Solid::of(&kind),
            placement,
            pose: placement,
            radius: radius(&kind),
        };
        Self { solids: shapes.iter().map(placed).collect(), pairs, room: Manifold::new() }
    }

    /// How many pairs of shapes can touch.
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Whether nothing can.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// The links of a pair, and the radii (m) about their frames' origins within which their shapes are.
    pub fn pair(&self, pair: usize) -> [(usize, f64); 2] {
        self.pairs[pair].map(|index| {
            let placed = &self.solids[index];
            (placed.link, placed.placement.translation.vector.norm() + placed.radius)
        })
    }

    /// Visits the points in which shapes touch, or that are no farther apart than the `reach` (m) of their pair, pair by pair; `pose`
    /// places a link in the world.
    ///
    /// Nothing is kept from call to call. Overlaps are found down to the axes of capsules and the middles of spheres; what is deeper
    /// in each other may not touch at all.
    pub fn touches(
        &mut self,
        pose: impl Fn(usize) -> Isometry3<f64>,
        reach: impl Fn(usize) -> f64,
        mut visit: impl FnMut(&Touch),
    ) {
        let Self { solids, pairs, room } = self;
        for solid in solids.iter_mut() {
            solid.pose = pose(solid.link) * solid.placement;
        }
        for (pair, &[a, b]) in pairs.iter().enumerate() {
            let (a, b) = (&solids[a], &solids[b]);
            let (reach, apart) = (reach(pair), a.pose.translation.vector - b.pose.translation.vector);
            // Bounding spheres first; not a number is never near.
            let least = a.radius + b.radius + reach;
            let is_near = apart.norm_squared() <= least * least;
            if !is_near {
                continue;
            }
            let other = a.pose.inv_mul(&b.pose);
            for point in a.solid.touches(&b.solid, &other, reach, room) {
                let normal = -(a.pose.rotation * point.out);
                let place = a.pose.transform_point(&point.middle.into()).coords;
                visit(&Touch { pair, links: [a.link, b.link], point: place, normal, gap: point.gap });
            }
        }
    }
}

/// The radius (m) of the sphere about a shape's origin that holds it.
fn radius(kind: &ShapeKind) -> f64 {
    match *kind {
        ShapeKind::Box { size } => 0.5 * size.norm(),
        ShapeKind::Cylinder { radius, length } => radius.hypot(0.5 * length),
        ShapeKind::Ellipsoid { radii } => radii.max(),
        ShapeKind::Capsule { radius, length } => radius + 0.5 * length,
        ShapeKind::Sphere { radius } => radius,
    }
}
