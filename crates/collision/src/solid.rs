//! Convex bodies as the crate parry sees them, which only this file knows.

use nalgebra::{Isometry3, Vector3};
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query::{ContactManifold, TrackedContact};
use parry3d_f64::query::details::{contact_manifold_cuboid_cuboid, contact_manifold_pfm_pfm};
use parry3d_f64::shape::{Cuboid, Cylinder, PolygonalFeature, PolygonalFeatureMap, Segment, SupportMap};
use solaris_model::ShapeKind;

/// The part of its least semi-axis that an ellipsoid has as a skin, and of its least half thickness a cylinder.
const SKIN: f64 = 1.0 / 16.0;

/// How near boxes are close, in parts of the least half edge of both.
const CLOSE: f64 = 1e-5;

/// A convex body: all points within a distance, its skin, of a core.
///
/// Overlaps less deep than the skins are found from the nearest points of both cores, which are apart. Spheres and capsules are points
/// and segments with a skin, boxes have none and a pair of them is worked out by itself. A cylinder's skin rounds its edges, by 1/16
/// of its radius or half its length, whichever is less. An ellipsoid with semi-axes `rᵢ` is one with `rᵢ − m` and the skin
/// `m = min(rᵢ)/16`: it ends where the ellipsoid ends along each axis, and lies outside of it elsewhere, for by Kantorovich's inequality
///
/// ```text
/// 0 ≤ √(Σ (rᵢ − m)²dᵢ²) + m − √(Σ rᵢ²dᵢ²) ≤ m·(1 − 2√k/(1 + k))        k = (max(rᵢ) − m)/(min(rᵢ) − m)
/// ```
///
/// which is 1/110 of the least semi-axis where the longest is three times as long.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    core: Core,
    skin: f64,
}

#[derive(Clone, Debug)]
enum Core {
    Point,
    Segment(Segment),
    Box(Cuboid),
    Cylinder(Cylinder),
    /// Semi-axes.
    Ellipsoid(Vector),
}

/// Room for the points in which two bodies touch.
#[derive(Clone)]
pub(crate) struct Manifold(ContactManifold<(), ()>);

/// A point in which two bodies touch, or are about to, in the first one's frame.
pub(crate) struct Point {
    /// Half way between both (m).
    pub(crate) middle: Vector3<f64>,
    /// Out of the first into the second.
    pub(crate) out: Vector3<f64>,
    /// How far apart (m), negative for the depth of an overlap.
    pub(crate) gap: f64,
}

impl Solid {
    pub(crate) fn of(kind: &ShapeKind) -> Self {
        let segment = |half: f64| Core::Segment(Segment::new(Vector::Y * -half, Vector::Y * half));
        let (core, skin) = match *kind {
            ShapeKind::Sphere { radius } => (Core::Point, radius),
            ShapeKind::Capsule { radius, length } => (segment(0.5 * length), radius),
            ShapeKind::Box { size } => (Core::Box(Cuboid::new(vector(&(size / 2.0)))), 0.0),
            ShapeKind::Cylinder { radius, length } => {
                let skin = SKIN * radius.min(0.5 * length);
                (Core::Cylinder(Cylinder::new(0.5 * length - skin, radius - skin)), skin)
            }
            ShapeKind::Ellipsoid { radii } => {
                let skin = SKIN * radii.min();
                (Core::Ellipsoid(vector(&radii.add_scalar(-skin))), skin)
            }
        };
        Self { core, skin }
    }

    /// The points in which this body and another touch, or that are no farther apart than `reach` (m); `other` is that one's pose
    /// in the frame of this one.
    ///
    /// Bodies whose cores overlap, all spheres and capsules that are in each other by their whole radii, may have none.
    pub(crate) fn touches<'a>(
        &'a self,
        other: &'a Self,
        pose: &Isometry3<f64>,
        reach: f64,
        room: &'a mut Manifold,
    ) -> impl Iterator<Item = Point> + 'a {
        let Manifold(manifold) = room;
        // What was found before must not change what is found now.
        manifold.clear();
        manifold.local_n1 = Vector::ZERO;
        let pose = placed(pose);
        let (a, b) = (&self.core, &other.core);
        if let (Core::Box(a), Core::Box(b)) = (a, b) {
            // Without skins nearest points tell little of a way out: by the axes that can part boxes, where these overlap or nearly do.
            let close = CLOSE * a.half_extents.min_element().min(b.half_extents.min_element());
            contact_manifold_cuboid_cuboid(&pose, a, b, close.min(reach), manifold);
        }
        if manifold.points.is_empty() {
            manifold.local_n1 = Vector::ZERO;
            contact_manifold_pfm_pfm(&pose, a, self.skin, None, b, other.skin, None, reach, manifold);
        }
        let (normal, skins) = (manifold.local_n1, [self.skin, other.skin]);
        let point = move |point: &TrackedContact<()>| {
            let [a, b] = [point.local_p1, pose.transform_point(point.local_p2)];
            // Of edges that cross at a small angle, the ends are matched too: each has its own way across.
            let cores = [a - normal * skins[0], b + normal * skins[1]];
            let across = cores[1] - cores[0];
            let length = across.length();
            let thick = skins[0] + skins[1];
            let (out, gap) = if across.dot(normal) > 0.5 * thick {
                (across / length, length - thick)
            } else {
                (normal, point.dist)
            };
            let middle = 0.5 * (cores[0] + out * skins[0] + cores[1] - out * skins[1]);
            Point { middle: back(middle), out: back(out), gap }
        };
        // Middles in one place leave no way out.
        let is_one = normal.is_normalized();
        let points = manifold.points.iter().filter(move |_| is_one).map(point);
        points.filter(move |point| point.gap <= reach)
    }
}

impl Manifold {
    pub(crate) fn new() -> Self {
        Self(ContactManifold::new())
    }
}

impl SupportMap for Core {
    fn local_support_point(&self, direction: Vector) -> Vector {
        match self {
            Self::Point => Vector::ZERO,
            Self::Segment(segment) => segment.local_support_point(direction),
            Self::Box(cuboid) => cuboid.local_support_point(direction),
            Self::Cylinder(cylinder) => cylinder.local_support_point(direction),
            Self::Ellipsoid(radii) => {
                // ∇ of the support function √(Σ rᵢ²dᵢ²).
                let scaled = *radii * direction;
                *radii * scaled.try_normalize().unwrap_or(Vector::ZERO)
            }
        }
    }
}

impl PolygonalFeatureMap for Core {
    fn local_support_feature(&self, direction: Vector, feature: &mut PolygonalFeature) {
        match self {
            Self::Segment(segment) => segment.local_support_feature(direction, feature),
            Self::Box(cuboid) => cuboid.local_support_feature(direction, feature),
            Self::Cylinder(cylinder) => cylinder.local_support_feature(direction, feature),
            // Round: a point, which makes no polygon.
            Self::Point | Self::Ellipsoid(_) => feature.num_vertices = 0,
        }
    }

    fn local_support_feature_toward(&self, direction: Vector, hint: Vector, feature: &mut PolygonalFeature) {
        match self {
            Self::Cylinder(cylinder) => cylinder.local_support_feature_toward(direction, hint, feature),
            _ => self.local_support_feature(direction, feature),
        }
    }
}

fn vector(v: &Vector3<f64>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

fn back(v: Vector) -> Vector3<f64> {
    Vector3::new(v.x, v.y, v.z)
}

fn placed(pose: &Isometry3<f64>) -> Pose {
    let [x, y, z, w]: [f64; 4] = pose.rotation.coords.into();
    Pose::from_parts(vector(&pose.translation.vector), Rotation::from_xyzw(x, y, z, w))
}
