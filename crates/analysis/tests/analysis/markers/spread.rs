//! How well markers tell of an angle: a hinge, in closed form.

use super::{changed, seen, solve};
use approx::assert_relative_eq;
use solaris_analysis::markers::IkOptions;
use solaris_model::{FigureBuilder, Joint, LinkSpec, Marker, Vector3};

/// Of `n` markers at the distance `r` from a hinge, each coordinate with the standard error `σ`, it is `σ/(r √n)`: errors along the axis leave the
/// angle as it is, and `σ² = Σ e²/(3 n − 1)`.
#[test]
fn an_angle_is_as_uncertain_as_its_markers_are_and_as_they_are_few() {
    let arm = LinkSpec::root("arm", Joint::new("hinge").rz()).mass(1.0);
    let figure = FigureBuilder::new("one").link(arm).build().expect("valid");
    let (error, poses) = (2e-3, [vec![0.3], vec![0.5], vec![-0.2]]);
    for (count, distance) in [(1, 0.5), (2, 0.5), (5, 0.5), (5, 0.1)] {
        let markers: Vec<Marker> = (0..count)
            .map(|i| {
                let angle = 1.1 * f64::from(i);
                let position = Vector3::new(angle.cos(), angle.sin(), 0.0) * distance;
                Marker { name: format!("m{i}"), link: 0, position, is_fixed: false }
            })
            .collect();
        let exact = seen(&figure, &markers, &poses);
        let off = |m: usize| Vector3::z() * if m.is_multiple_of(2) { error } else { -error };
        let trial = changed(&exact, |_, marker, point| point + off(marker));
        let found = solve(&figure, &markers, &trial, &IkOptions::default());
        let n = f64::from(count);
        let one = error * (n / (3.0 * n - 1.0)).sqrt();
        assert_relative_eq!(found.q[1], 0.5, epsilon = 1e-9);
        assert_relative_eq!(found.dofs[0].spread, one / (distance * n.sqrt()), max_relative = 1e-6);

        // A hidden one tells nothing.
        let hidden =
            changed(&trial, |_, marker, point| if marker == 0 { Vector3::repeat(f64::NAN) } else { point });
        if count > 1 {
            let (found, n) = (solve(&figure, &markers, &hidden, &IkOptions::default()), n - 1.0);
            let one = error * (n / (3.0 * n - 1.0)).sqrt();
            assert_relative_eq!(found.dofs[0].spread, one / (distance * n.sqrt()), max_relative = 1e-6);
        }
    }
}
