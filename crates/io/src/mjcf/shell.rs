//! Solids whose mass is on their surface.

use solaris_model::{ShapeKind, Vector3};
use std::f64::consts::PI;

/// The area of a surface (m²) and its squared radii of gyration (m²), along MuJoCo's axes: those of cylinders and capsules
/// along z. None for an ellipsoid, of which neither is known in closed form.
pub(super) fn surface(kind: &ShapeKind) -> Option<(f64, Vector3<f64>)> {
    // Areas with the mean squares of x, y, z on them.
    let parts: Vec<(f64, [f64; 3])> = match *kind {
        ShapeKind::Sphere { radius } => vec![(4.0 * PI * radius * radius, [radius * radius / 3.0; 3])],
        ShapeKind::Box { size } => {
            let squares = size.map(|side| side * side / 4.0);
            let face = |i: usize| {
                let spread: [f64; 3] = [0, 1, 2].map(|j| if i == j { squares[j] } else { squares[j] / 3.0 });
                (2.0 * size[(i + 1) % 3] * size[(i + 2) % 3], spread)
            };
            vec![face(0), face(1), face(2)]
        }
        ShapeKind::Cylinder { radius, length } => {
            let (across, along) = (radius * radius, length * length / 4.0);
            vec![
                (2.0 * PI * radius * length, [across / 2.0, across / 2.0, along / 3.0]),
                (2.0 * PI * across, [across / 4.0, across / 4.0, along]),
            ]
        }
        ShapeKind::Capsule { radius, length } => {
            let (across, half) = (radius * radius, length / 2.0);
            vec![
                (2.0 * PI * radius * length, [across / 2.0, across / 2.0, half * half / 3.0]),
                (4.0 * PI * across, [across / 3.0, across / 3.0, half * half + half * radius + across / 3.0]),
            ]
        }
        ShapeKind::Ellipsoid { .. } => return None,
    };
    let area: f64 = parts.iter().map(|(area, _)| area).sum();
    let mean = |i: usize| parts.iter().map(|(part, squares)| part * squares[i]).sum::<f64>() / area;
    let squares = Vector3::new(mean(0), mean(1), mean(2));
    Some((area, squares.map(|own| squares.sum() - own)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hollow sphere: I = 2/3·m·r²; a cylinder without length: a disc of two sides, I = m·r²/2 about its axis.
    #[test]
    fn hollow_spheres_and_discs_are_those_of_textbooks() {
        let (area, squares) = surface(&ShapeKind::Sphere { radius: 3.0 }).expect("a surface");
        assert!((area - 36.0 * PI).abs() < 1e-12 && (squares - Vector3::repeat(6.0)).norm() < 1e-12);
        let (area, squares) = surface(&ShapeKind::Cylinder { radius: 2.0, length: 0.0 }).expect("a surface");
        assert!((area - 8.0 * PI).abs() < 1e-12 && (squares - Vector3::new(1.0, 1.0, 2.0)).norm() < 1e-12);
    }

    /// A capsule without a straight part is a sphere, and one with thin caps is nearly a tube.
    #[test]
    fn a_capsule_lies_between_a_sphere_and_a_tube() {
        let [capsule, sphere] =
            [ShapeKind::Capsule { radius: 2.0, length: 0.0 }, ShapeKind::Sphere { radius: 2.0 }]
                .map(|kind| surface(&kind).expect("a surface"));
        assert!((capsule.0 - sphere.0).abs() < 1e-12 && (capsule.1 - sphere.1).norm() < 1e-12);
        let tube = surface(&ShapeKind::Capsule { radius: 1e-6, length: 3.0 }).expect("a surface").1;
        assert!((tube - Vector3::new(0.75, 0.75, 0.0)).norm() < 1e-5);
    }
}
