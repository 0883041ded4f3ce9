//! Mass distributions: as numbers, or from a shape.

use crate::joint::Placement;
use nalgebra::{Matrix3, Vector3};

/// A uniform solid or a limb's outline, with the placement of its own frame in the link's frame.
#[doc(alias = "geometry")]
#[doc(alias = "collision")]
#[doc(alias = "visual")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// What it is.
    pub kind: ShapeKind,
    /// Its centre and axes in the link's frame.
    pub placement: Placement,
}

/// The shapes of a link. Lengths are in m; every shape is centred on its own origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShapeKind {
    /// A box with these full edge lengths along x, y, z.
    Box {
        /// Full edge lengths.
        size: Vector3<f64>,
    },
    /// A cylinder along y.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Height along y.
        length: f64,
    },
    /// An ellipsoid with these semi-axes along x, y, z.
    Ellipsoid {
        /// Semi-axes.
        radii: Vector3<f64>,
    },
    /// A cylinder along y closed by two half spheres.
    Capsule {
        /// Radius.
        radius: f64,
        /// Length along y between the centres of the half spheres.
        length: f64,
    },
    /// A sphere.
    Sphere {
        /// Radius.
        radius: f64,
    },
}

impl ShapeKind {
    /// Lengths that must be positive, each with its name.
    pub(crate) fn lengths(&self) -> Vec<(&'static str, f64)> {
        match *self {
            Self::Box { size: s } => vec![("size x", s.x), ("size y", s.y), ("size z", s.z)],
            Self::Cylinder { radius, length } | Self::Capsule { radius, length } => {
                vec![("radius", radius), ("length", length)]
            }
            Self::Ellipsoid { radii: r } => vec![("radius x", r.x), ("radius y", r.y), ("radius z", r.z)],
            Self::Sphere { radius } => vec![("radius", radius)],
        }
    }

    /// Volume (m³).
    pub fn volume(&self) -> f64 {
        use std::f64::consts::PI;
        match *self {
            Self::Box { size } => size.product(),
            Self::Cylinder { radius: r, length: l } => PI * r * r * l,
            Self::Ellipsoid { radii } => 4.0 / 3.0 * PI * radii.product(),
            Self::Capsule { radius: r, length: l } => PI * r * r * (l + 4.0 / 3.0 * r),
            Self::Sphere { radius: r } => 4.0 / 3.0 * PI * r * r * r,
        }
    }

    /// Half of what it measures along its own x, y, z (m).
    pub(crate) fn half_extents(&self) -> Vector3<f64> {
        match *self {
            Self::Box { size } => size / 2.0,
            Self::Cylinder { radius: r, length: l } => Vector3::new(r, l / 2.0, r),
            Self::Ellipsoid { radii } => radii,
            Self::Capsule { radius: r, length: l } => Vector3::new(r, l / 2.0 + r, r),
            Self::Sphere { radius: r } => Vector3::repeat(r),
        }
    }

    /// How far it reaches from its centre along a unit vector in its own axes (m).
    pub fn reach(&self, along: &Vector3<f64>) -> f64 {
        match *self {
            Self::Box { size } => along.abs().dot(&size) / 2.0,
            Self::Cylinder { radius: r, length: l } => r * along.xz().norm() + l / 2.0 * along.y.abs(),
            Self::Ellipsoid { radii } => along.component_mul(&radii).norm(),
            Self::Capsule { radius: r, length: l } => r + l / 2.0 * along.y.abs(),
            Self::Sphere { radius: r } => r,
        }
    }

    /// Principal moments of inertia per unit of mass about the centre, shape axes (m²).
    ///
    /// A uniform solid has **no** products of inertia about its own axes; the thesis's §3.7 gives a box some, and an
    /// inertia that is not physical (see `docs/sources.md`).
    pub fn gyration_squared(&self) -> Vector3<f64> {
        match *self {
            Self::Box { size: s } => {
                let q = s.component_mul(&s) / 12.0;
                Vector3::new(q.y + q.z, q.z + q.x, q.x + q.y)
            }
            Self::Cylinder { radius: r, length: l } => {
                let across = r * r / 4.0 + l * l / 12.0;
                Vector3::new(across, r * r / 2.0, across)
            }
            Self::Ellipsoid { radii: s } => {
                let q = s.component_mul(&s) / 5.0;
                Vector3::new(q.y + q.z, q.z + q.x, q.x + q.y)
            }
            Self::Capsule { radius: r, length: l } => {
                // Cylinder and the two half spheres by their share of the volume; a half sphere's centre lies 3r/8
                // above its base.
                let (cylinder, sphere) = (l, 4.0 * r / 3.0);
                let (mc, ms) = (cylinder / (cylinder + sphere), sphere / (cylinder + sphere));
                let along = mc * r * r / 2.0 + ms * 2.0 * r * r / 5.0;
                let across = mc * (r * r / 4.0 + l * l / 12.0)
                    + ms * (2.0 * r * r / 5.0 + l * l / 4.0 + 3.0 * l * r / 8.0);
                Vector3::new(across, along, across)
            }
            Self::Sphere { radius: r } => Vector3::repeat(2.0 * r * r / 5.0),
        }
    }
}

/// The rotational inertia of a link, as it is given.
#[doc(alias = "inertia tensor")]
#[doc(alias = "moment of inertia")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inertia {
    /// None: a point mass at the centre of mass, or no mass at all.
    Point,
    /// The 3×3 tensor about the centre of mass, along the link's axes (kg m²).
    Tensor(Matrix3<f64>),
    /// That of a uniform solid of the link's mass; its centre is then also the link's centre of mass.
    Uniform(Shape),
}

impl Inertia {
    /// Principal moments along the link's axes (kg m²).
    pub fn diagonal(x: f64, y: f64, z: f64) -> Self {
        Self::Tensor(Matrix3::from_diagonal(&Vector3::new(x, y, z)))
    }
}

/// The second moments `S = ½ tr(I)·1 − I` of a rotational inertia: a mass distribution exists only if none of their
/// principal values is negative (the triangle inequality of the principal moments).
pub(crate) fn second_moments(inertia: &Matrix3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let eigen = (Matrix3::identity() * (inertia.trace() / 2.0) - inertia).symmetric_eigen();
    (eigen.eigenvalues, eigen.eigenvectors)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_capsule_lies_between_its_cylinder_and_its_sphere() {
        let sphere = ShapeKind::Sphere { radius: 0.2 }.gyration_squared();
        assert_relative_eq!(
            ShapeKind::Capsule { radius: 0.2, length: 1e-12 }.gyration_squared(),
            sphere,
            epsilon = 1e-12
        );
        let thin = ShapeKind::Capsule { radius: 1e-9, length: 3.0 }.gyration_squared();
        assert_relative_eq!(thin.x, 0.75, epsilon = 1e-8);
    }

    #[test]
    fn a_box_of_unit_edges_has_one_sixth() {
        let unit = ShapeKind::Box { size: Vector3::repeat(1.0) }.gyration_squared();
        assert_relative_eq!(unit, Vector3::repeat(1.0 / 6.0), epsilon = 1e-15);
    }

    /// Every shape against a sum over small cubes.
    #[test]
    fn shapes_agree_with_quadrature() {
        let shapes = [
            ShapeKind::Box { size: Vector3::new(0.6, 0.8, 1.0) },
            ShapeKind::Cylinder { radius: 0.4, length: 0.9 },
            ShapeKind::Ellipsoid { radii: Vector3::new(0.3, 0.5, 0.4) },
            ShapeKind::Capsule { radius: 0.25, length: 0.5 },
            ShapeKind::Sphere { radius: 0.45 },
        ];
        for shape in shapes {
            let inside = |p: Vector3<f64>| match shape {
                ShapeKind::Box { size } => (0..3).all(|i| p[i].abs() <= size[i] / 2.0),
                ShapeKind::Cylinder { radius, length } => {
                    p.xz().norm() <= radius && p.y.abs() <= length / 2.0
                }
                ShapeKind::Ellipsoid { radii } => p.component_div(&radii).norm() <= 1.0,
                ShapeKind::Capsule { radius, length } => {
                    let q = Vector3::new(p.x, (p.y.abs() - length / 2.0).max(0.0), p.z);
                    q.norm() <= radius
                }
                ShapeKind::Sphere { radius } => p.norm() <= radius,
            };
            let (n, mut mass, mut sum) = (120, 0.0, Vector3::zeros());
            for i in 0..n * n * n {
                let at = |k: i32| (f64::from(k) + 0.5) / f64::from(n) - 0.5;
                let p = Vector3::new(at(i % n), at(i / n % n), at(i / (n * n)));
                if inside(p) {
                    mass += 1.0;
                    sum += Vector3::new(p.yz().norm_squared(), p.xz().norm_squared(), p.xy().norm_squared());
                }
            }
            assert_relative_eq!(shape.gyration_squared(), sum / mass, max_relative = 0.01);
            assert_relative_eq!(shape.volume(), mass / f64::from(n).powi(3), max_relative = 0.01);
        }
    }
}
