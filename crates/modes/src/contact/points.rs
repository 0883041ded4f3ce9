//! Where a figure can touch the ground.

use super::ContactPoint;
use nalgebra::Vector3;
use solaris_model::{Figure, Link, Shape, ShapeKind};

/// How near (m) two centres count as one.
const ONE_POINT: f64 = 1e-9;

/// Where a figure can touch the ground, by what its links say of themselves:
///
/// | link with | touches with |
/// |---|---|
/// | a sole | its points; where it has a line of them and a shape, with the two corners that the shape's width gives each of them |
/// | a capsule, a sphere | the spheres at its ends, the sphere |
/// | an ellipsoid | at both ends of each semi-axis `a`, the sphere of radius `min(a, b²/a, c²/a)` that touches it there from inside |
/// | a box, a cylinder | its corners, four points of each rim |
/// | a tip, and nothing of the above | its tip |
///
/// What a link has of a higher row it does not have of a lower one. Links without any of these touch nothing.
pub fn contact_points(figure: &Figure) -> Vec<ContactPoint> {
    let links = figure.links().iter().enumerate();
    links
        .flat_map(|(i, link)| {
            of_link(link).into_iter().map(move |(center, radius)| ContactPoint { link: i, center, radius })
        })
        .collect()
}

/// Centres in the link's frame, and radii (m).
fn of_link(link: &Link) -> Vec<(Vector3<f64>, f64)> {
    if !link.sole().is_empty() {
        return of_sole(link).into_iter().map(|point| (point, 0.0)).collect();
    }
    if let Some(shape) = link.shape() {
        let placed = |(center, radius): (Vector3<f64>, f64)| {
            (shape.placement.transform_point(&center.into()).coords, radius)
        };
        return of_shape(&shape.kind).into_iter().map(placed).collect();
    }
    link.tip().map(|tip| (*tip, 0.0)).into_iter().collect()
}

/// The points of a sole, or the corners beside them.
fn of_sole(link: &Link) -> Vec<Vector3<f64>> {
    let points: Vec<Vector3<f64>> = link.sole().iter().map(|point| point.position).collect();
    match link.shape().and_then(|shape| half_width(&points, shape)) {
        Some(side) => points.iter().flat_map(|point| [point - side, point + side]).collect(),
        None => points,
    }
}

/// From the line of a sole's points to the edge of the link's shape: square to the line and to the way down from the shape's
/// middle. None where the points do not make a line, or nothing is above it.
fn half_width(points: &[Vector3<f64>], shape: &Shape) -> Option<Vector3<f64>> {
    let (first, last) = (points.first()?, points.last()?);
    let line = last - first;
    let across =
        line.cross(&(shape.placement.translation.vector - first)).try_normalize(ONE_POINT * ONE_POINT)?;
    let along = shape.placement.rotation.inverse() * across;
    Some(across * shape.kind.reach(&along))
}

/// Centres in the shape's own frame, and radii (m).
fn of_shape(kind: &ShapeKind) -> Vec<(Vector3<f64>, f64)> {
    const SIGNS: &[f64] = &[-1.0, 1.0];
    let both = |signs: [&[f64]; 3], [x, y, z]: [f64; 3]| {
        let mut points = Vec::new();
        for a in signs[0] {
            for b in signs[1] {
                points.extend(signs[2].iter().map(|c| (Vector3::new(a * x, b * y, c * z), 0.0)));
            }
        }
        points
    };
    match *kind {
        ShapeKind::Sphere { radius } => vec![(Vector3::zeros(), radius)],
        ShapeKind::Capsule { radius, length } => {
            [-0.5, 0.5].map(|part| (Vector3::y() * (part * length), radius)).to_vec()
        }
        ShapeKind::Box { size } => both([SIGNS; 3], (size / 2.0).into()),
        ShapeKind::Cylinder { radius, length } => {
            let mut points = both([SIGNS, SIGNS, &[0.0]], [radius, length / 2.0, 0.0]);
            points.extend(both([&[0.0], SIGNS, SIGNS], [0.0, length / 2.0, radius]));
            points
        }
        ShapeKind::Ellipsoid { radii } => of_ellipsoid(&radii),
    }
}

fn of_ellipsoid(radii: &Vector3<f64>) -> Vec<(Vector3<f64>, f64)> {
    let mut spheres: Vec<(Vector3<f64>, f64)> = Vec::new();
    for axis in 0..3 {
        let own = radii[axis];
        // The least radius of curvature at the end of the axis; a sphere larger than the semi-axis would stand out behind.
        let radius = radii.iter().fold(own, |least, other| least.min(other * other / own));
        for side in [-1.0, 1.0] {
            let center = Vector3::ith(axis, side * (own - radius));
            if spheres.iter().all(|(other, _)| (other - center).norm() > ONE_POINT) {
                spheres.push((center, radius));
            }
        }
    }
    spheres
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use solaris_model::human;

    /// Of random ellipsoids: every point of every sphere is inside, and the end of every axis is touched.
    #[test]
    fn spheres_fill_an_ellipsoid_to_the_ends_of_its_axes() {
        let random = &mut crate::body::random::Random(5);
        for _ in 0..200 {
            let radii = Vector3::from_fn(|_, _| random.between(0.02, 0.3));
            let spheres = of_ellipsoid(&radii);
            assert!((1..=6).contains(&spheres.len()));
            for (center, radius) in &spheres {
                for _ in 0..50 {
                    let direction = random.vector(1.0).normalize();
                    let at = (center + direction * *radius).component_div(&radii);
                    assert!(at.norm() <= 1.0 + 1e-12, "{radii}: {center} {radius}");
                }
            }
            for axis in 0..3 {
                let reach = spheres.iter().map(|(center, radius)| center[axis] + radius);
                assert_relative_eq!(reach.fold(0.0, f64::max), radii[axis], max_relative = 1e-14);
            }
        }
        assert_eq!(of_ellipsoid(&Vector3::repeat(0.1)), [(Vector3::zeros(), 0.1)]);
    }

    #[test]
    fn a_person_stands_on_the_corners_of_both_soles_and_touches_with_all_links() {
        let figure = human(1.75, 73.0).expect("within range");
        let contact_points = contact_points(&figure);
        for (i, link) in figure.links().iter().enumerate() {
            assert!(contact_points.iter().any(|touch| touch.link == i), "{}", link.name());
        }
        let foot = figure.link_index("left_foot").expect("a link");
        let corners: Vec<Vector3<f64>> =
            contact_points.iter().filter(|touch| touch.link == foot).map(|touch| touch.center).collect();
        assert_eq!(corners.len(), 4);
        // The row of the table: 4 cm to each side, for 1.741 m; all as deep as the sole.
        let sole = figure.links()[foot].sole()[0].position;
        for corner in corners {
            assert_relative_eq!(corner.x.abs(), 0.04 * 1.75 / 1.741, max_relative = 1e-12);
            assert_relative_eq!(corner.y, sole.y, max_relative = 1e-12);
        }
    }

    #[test]
    fn a_box_touches_with_its_corners_and_a_cylinder_with_its_rims() {
        let size = Vector3::new(0.2, 0.4, 0.6);
        let corners = of_shape(&ShapeKind::Box { size });
        assert_eq!(corners.len(), 8);
        assert!(corners.iter().all(|(at, radius)| at.abs() == size / 2.0 && *radius == 0.0));
        let rims = of_shape(&ShapeKind::Cylinder { radius: 0.1, length: 0.5 });
        assert_eq!(rims.len(), 8);
        assert!(
            rims.iter()
                .all(|(at, _)| (at.y.abs() - 0.25).abs() < 1e-15 && (at.x.hypot(at.z) - 0.1).abs() < 1e-15)
        );
    }
}
