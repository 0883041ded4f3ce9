//! Shapes as the capsules that fill them.

use nalgebra::Vector3;
use solaris_model::{Shape, ShapeKind};
use std::f64::consts::TAU;

/// How near (m) two ends and radii count as one.
const ONE: f64 = 1e-9;
/// Corners of a ring.
const CORNERS: usize = 16;
/// Rings of a disc.
const RINGS: usize = 5;
/// The most capsules beside each other in a box.
const MOST_BESIDE: usize = 9;

/// A capsule by its ends, in some frame, and its radius (m); a sphere where the ends are one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Capsule {
    pub(super) ends: [Vector3<f64>; 2],
    pub(super) radius: f64,
}

/// What fills a shape, in the link's frame.
///
/// Capsules and spheres are themselves. The others are filled from inside:
///
/// | shape | filled by |
/// |---|---|
/// | ellipsoid `a ≥ b ≥ c` | spheres about points of its medial disc, joined to rings of capsules (below) |
/// | box | its least half edge as radius: capsules along the longest edge, at most a radius apart (nine at most) |
/// | cylinder | a capsule; one that is flatter than it is wide, rings of capsules |
///
/// An ellipsoid is the union of the spheres about the points `x, y` of a disc in the plane of its longer axes, with the
/// radius `r`:
///
/// ```text
/// x = ρ cos θ (a² − c²)/a      y = ρ sin θ (b² − c²)/b      r² = c² [1 − ρ² (cos²θ (1 − c²/a²) + sin²θ (1 − c²/b²))]
/// ```
///
/// Neighbours on a ring are joined by a capsule of the smaller radius of both: it lies inside, for the ellipsoid is convex.
pub(super) fn fill(shape: &Shape) -> Vec<Capsule> {
    let placed = |capsule: Capsule| {
        let ends = capsule.ends.map(|end| shape.placement.transform_point(&end.into()).coords);
        Capsule { ends, ..capsule }
    };
    of_kind(&shape.kind).into_iter().map(placed).collect()
}

/// In the shape's own frame.
fn of_kind(kind: &ShapeKind) -> Vec<Capsule> {
    let upright = |half: f64, radius| vec![Capsule { ends: [-half, half].map(|y| Vector3::y() * y), radius }];
    match *kind {
        ShapeKind::Sphere { radius } => upright(0.0, radius),
        ShapeKind::Capsule { radius, length } => upright(length / 2.0, radius),
        ShapeKind::Cylinder { radius, length } if length >= 2.0 * radius => {
            upright(length / 2.0 - radius, radius)
        }
        ShapeKind::Cylinder { radius, length } => {
            let (thick, wide) = (length / 2.0, radius - length / 2.0);
            disc([Vector3::x() * wide, Vector3::z() * wide], |_, _| thick)
        }
        ShapeKind::Box { size } => of_box(&(size / 2.0)),
        ShapeKind::Ellipsoid { radii } => {
            let [long, wide, thin] = sorted(&radii);
            let c = radii[thin];
            let semi = |axis: usize| Vector3::ith(axis, (radii[axis] - c) * (radii[axis] + c) / radii[axis]);
            let flat = [long, wide].map(|axis| 1.0 - (c / radii[axis]).powi(2));
            disc([semi(long), semi(wide)], |part, [cos, sin]| {
                c * (1.0 - part * part * (cos * cos * flat[0] + sin * sin * flat[1])).sqrt()
            })
        }
    }
}

/// Axes by their lengths, the longest first.
fn sorted(lengths: &Vector3<f64>) -> [usize; 3] {
    let mut axes = [0, 1, 2];
    axes.sort_by(|a, b| lengths[*b].total_cmp(&lengths[*a]));
    axes
}

fn of_box(half: &Vector3<f64>) -> Vec<Capsule> {
    let [long, wide, thin] = sorted(half);
    let radius = half[thin];
    let (along, across) = (Vector3::ith(long, half[long] - radius), half[wide] - radius);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a positive number, bounded")]
    let gaps = ((2.0 * across / radius).ceil() as usize).min(MOST_BESIDE - 1);
    let line = |k: usize| {
        let part = if gaps == 0 { 0.0 } else { 2.0 * k as f64 / gaps as f64 - 1.0 };
        let middle = Vector3::ith(wide, part * across);
        Capsule { ends: [middle - along, middle + along], radius }
    };
    (0..=gaps).map(line).collect()
}

/// Spheres about the points of an elliptic disc, by its semi-axes; their radius by the part of the way from the middle to
/// the rim, and cosine and sine of the angle. What is there already is left out.
fn disc(semi: [Vector3<f64>; 2], radius: impl Fn(f64, [f64; 2]) -> f64) -> Vec<Capsule> {
    let mut capsules = vec![Capsule { ends: [Vector3::zeros(); 2], radius: radius(0.0, [1.0, 0.0]) }];
    let mut push = |new: Capsule| {
        let near = |a: &Vector3<f64>, b: &Vector3<f64>| (a - b).norm() < ONE;
        let is_like = |old: &Capsule| {
            let ([a, b], [c, d]) = (&old.ends, &new.ends);
            (old.radius - new.radius).abs() < ONE && (near(a, c) && near(b, d) || near(a, d) && near(b, c))
        };
        if !capsules.iter().any(is_like) {
            capsules.push(new);
        }
    };
    for ring in 1..=RINGS {
        // Closer towards the rim, where an ellipsoid's radii change faster.
        let part = (TAU / 4.0 * ring as f64 / RINGS as f64).sin();
        let corner = |k: usize| {
            let (sin, cos) = (TAU * (k % CORNERS) as f64 / CORNERS as f64).sin_cos();
            ((semi[0] * cos + semi[1] * sin) * part, radius(part, [cos, sin]))
        };
        for k in 0..CORNERS {
            let [before, (at, radius), after] = [corner(k + CORNERS - 1), corner(k), corner(k + 1)];
            push(Capsule { ends: [at, after.0], radius: radius.min(after.1) });
            if radius > before.1 && radius > after.1 {
                push(Capsule { ends: [at, at], radius });
            }
        }
    }
    capsules
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nearness::segment;
    use crate::random::Random;
    use approx::assert_relative_eq;
    use solaris_model::human;

    /// From a point to what fills (m), negative inside.
    fn outside(capsules: &[Capsule], point: Vector3<f64>) -> f64 {
        let to =
            |capsule: &Capsule| segment::shortest(&capsule.ends, &[point, point]).norm() - capsule.radius;
        capsules.iter().map(to).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn an_ellipsoid_is_filled_from_inside_to_the_ends_of_its_axes() {
        let random = &mut Random(3);
        for _ in 0..100 {
            let radii = Vector3::from_fn(|_, _| random.between(0.02, 0.3));
            let filled = of_kind(&ShapeKind::Ellipsoid { radii });
            for capsule in &filled {
                for _ in 0..20 {
                    let (part, turned) = (random.next(), random.vector(1.0).normalize());
                    let [a, b] = capsule.ends;
                    let at = a + (b - a) * part + turned * capsule.radius;
                    assert!(at.component_div(&radii).norm() <= 1.0 + 1e-12, "{radii}: {capsule:?}");
                }
            }
            for axis in 0..3 {
                for side in [-1.0, 1.0] {
                    let end = Vector3::ith(axis, side * radii[axis]);
                    assert!(outside(&filled, end).abs() < 1e-9, "{radii}: axis {axis}");
                }
            }
        }
        assert_eq!(of_kind(&ShapeKind::Ellipsoid { radii: Vector3::repeat(0.1) }).len(), 1);
    }

    /// docs/scenes.md says so.
    #[test]
    fn a_person_is_filled_to_within_millimetres() {
        let figure = human(1.75, 73.0).expect("within range");
        let (random, mut worst) = (&mut Random(4), (0.0_f64, String::new(), 0));
        for link in figure.links() {
            let shape = link.shape().expect("every link has one");
            let ShapeKind::Ellipsoid { radii } = shape.kind else { continue };
            let filled = of_kind(&shape.kind);
            for _ in 0..20_000 {
                let gap = outside(&filled, random.vector(1.0).normalize().component_mul(&radii));
                assert!(gap > -1e-12, "{}", link.name());
                if gap > worst.0 {
                    worst = (gap, link.name().to_owned(), filled.len());
                }
            }
        }
        assert!((1e-3..4e-3).contains(&worst.0), "{worst:?}");
    }

    #[test]
    fn a_box_and_a_cylinder_lose_their_edges_only() {
        let filled = of_kind(&ShapeKind::Box { size: Vector3::new(0.2, 0.1, 0.6) });
        assert!(filled.iter().all(|capsule| (capsule.radius - 0.05).abs() < 1e-15));
        for (face, most) in [([0.1, 0.0, 0.0], 1e-15), ([0.0, 0.0, 0.3], 0.007), ([0.03, 0.05, 0.1], 0.007)] {
            let gap = outside(&filled, face.into());
            assert!((-1e-15..=most).contains(&gap), "{face:?}: {gap}");
        }
        let corner = outside(&filled, Vector3::new(0.1, 0.05, 0.3));
        assert_relative_eq!(corner, (3.0_f64.sqrt() - 1.0) * 0.05, max_relative = 1e-12);

        let rod = of_kind(&ShapeKind::Cylinder { radius: 0.1, length: 0.5 });
        assert_eq!(rod, [Capsule { ends: [-0.15, 0.15].map(|y| Vector3::y() * y), radius: 0.1 }]);
        let plate = of_kind(&ShapeKind::Cylinder { radius: 0.3, length: 0.1 });
        for at in [[0.3, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, -0.3]] {
            assert!(outside(&plate, at.into()).abs() < 1e-12, "{at:?}");
        }
    }

    /// To the bit, so that nothing lies between the last capsule of a ring and its first.
    #[test]
    fn every_capsule_of_a_ring_begins_where_another_ends() {
        let plate = of_kind(&ShapeKind::Cylinder { radius: 0.3, length: 0.1 });
        assert_eq!(plate.len(), 1 + RINGS * CORNERS);
        for ring in plate[1..].chunks(CORNERS) {
            for k in 0..CORNERS {
                assert_eq!(ring[k].ends[1], ring[(k + 1) % CORNERS].ends[0], "corner {k}");
            }
        }
    }
}
