//! The six matrices of the thesis's appendix C, put right, and what is wrong with those printed.

use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::prelude::*;
use solaris_dynamics::denavit_hartenberg::about_fixed_axes;
use solaris_model::EulerOrder;

/// Sines and cosines of χ about x, φ about y, θ about z.
struct Parts {
    sx: f64,
    cx: f64,
    sf: f64,
    cf: f64,
    st: f64,
    ct: f64,
}

/// The entries that are printed otherwise: order, row and column from 1, what is printed.
type Misprint = (EulerOrder, usize, usize, fn(&Parts) -> f64);

const MISPRINTS: [Misprint; 6] = [
    (EulerOrder::Zyx, 2, 3, |p| p.sx * p.cf),
    (EulerOrder::Yxz, 2, 1, |p| p.st * p.cf),
    (EulerOrder::Yzx, 3, 1, |p| p.sx * p.st * p.ct - p.sf * p.cx),
    (EulerOrder::Xyz, 2, 3, |p| p.ct * p.sf * p.cx + p.st * p.sx),
    (EulerOrder::Xzy, 3, 2, |p| p.sf * p.st * p.cx + p.ct * p.sx),
    (EulerOrder::Xzy, 3, 3, |p| p.cf * p.ct - p.sf * p.st * p.sx),
];

/// Turns about axes that stay, the first one applied first.
fn product(order: EulerOrder, angles: [f64; 3]) -> Matrix3<f64> {
    order.axes().into_iter().zip(angles).fold(Matrix3::identity(), |before, (axis, angle)| {
        Rotation3::from_axis_angle(&Vector3::ith_axis(axis), angle).matrix() * before
    })
}

fn printed(order: EulerOrder, angles: [f64; 3]) -> Matrix3<f64> {
    let mut by_axis = [0.0; 3];
    for (axis, angle) in order.axes().into_iter().zip(angles) {
        by_axis[axis] = angle;
    }
    let [(sx, cx), (sf, cf), (st, ct)] = by_axis.map(f64::sin_cos);
    let mut matrix = about_fixed_axes(order, angles);
    for (of, row, column, entry) in MISPRINTS {
        if of == order {
            matrix[(row - 1, column - 1)] = entry(&Parts { sx, cx, sf, cf, st, ct });
        }
    }
    matrix
}

proptest! {
    #[test]
    fn the_matrices_are_products_of_turns(angles in prop::array::uniform3(-3.2..3.2)) {
        for order in EulerOrder::ALL {
            let error = (about_fixed_axes(order, angles) - product(order, angles)).amax();
            prop_assert!(error < 1e-15, "{} is off by {:e}", order, error);
        }
    }
}

/// Each of the six misprints is off at a plain triple of angles, and no other entry of the five matrices is.
#[test]
fn six_entries_of_five_matrices_are_misprinted() {
    let angles = [0.3, 0.5, 0.7];
    let mut wrong = Vec::new();
    for order in EulerOrder::ALL {
        let difference = printed(order, angles) - product(order, angles);
        for row in 0..3 {
            for column in 0..3 {
                if difference[(row, column)].abs() > 1e-15 {
                    wrong.push(format!(
                        "{order} ({},{}) is off by {:.2}",
                        row + 1,
                        column + 1,
                        difference[(row, column)]
                    ));
                }
            }
        }
        // A rotation with a wrong entry is none.
        let misprinted = MISPRINTS.iter().any(|(of, ..)| *of == order);
        let matrix = printed(order, angles);
        assert_eq!((matrix.transpose() * matrix - Matrix3::identity()).amax() > 1e-2, misprinted, "{order}");
    }
    insta::assert_snapshot!(wrong.join("\n"), @"
    X-Y-Z (2,3) is off by 0.47
    X-Z-Y (3,2) is off by 0.03
    X-Z-Y (3,3) is off by -0.06
    Y-X-Z (2,1) is off by -0.11
    Y-Z-X (3,1) is off by -0.02
    Z-Y-X (2,3) is off by 1.13
    ");
}

/// The order trap: the chain Z-Y-X of a joint is not the matrix that is called z, y, x.
#[test]
fn a_joint_turns_by_the_matrix_of_the_reversed_order() {
    let angles = [0.9, -0.8, 0.7];
    let joint = EulerOrder::Zyx.rotation(&angles).to_rotation_matrix();
    let [z, y, x] = angles;
    assert!((about_fixed_axes(EulerOrder::Xyz, [x, y, z]) - joint.matrix()).amax() < 1e-15);
    let called_alike = Rotation3::from_matrix_unchecked(about_fixed_axes(EulerOrder::Zyx, angles));
    assert!(joint.angle_to(&called_alike) > 1.0);
}
