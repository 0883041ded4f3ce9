//! Rotations by three angles about z, y and x, the order of the figure's joints.

use nalgebra::Matrix3;

/// Rotations about z, y, x (rad), in this order.
pub(crate) type Euler = [f64; 3];

/// R = Rz Ry Rx.
pub(crate) fn matrix([z, y, x]: Euler) -> Matrix3<f64> {
    let ((sz, cz), (sy, cy), (sx, cx)) = (z.sin_cos(), y.sin_cos(), x.sin_cos());
    #[rustfmt::skip]
    let r = Matrix3::new(
        cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx,
        sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx,
        -sy,     cy * sx,                cy * cx,
    );
    r
}

/// The angles of R = Rz Ry Rx.
pub(crate) fn euler(r: &Matrix3<f64>) -> Euler {
    [r[(1, 0)].atan2(r[(0, 0)]), (-r[(2, 0)]).clamp(-1.0, 1.0).asin(), r[(2, 1)].atan2(r[(2, 2)])]
}

/// The angles `[y, z, x]` of R = Ry Rz Rx.
pub(crate) fn heading_first(r: &Matrix3<f64>) -> [f64; 3] {
    [(-r[(2, 0)]).atan2(r[(0, 0)]), r[(1, 0)].clamp(-1.0, 1.0).asin(), (-r[(1, 2)]).atan2(r[(1, 1)])]
}

/// Rotation about x.
pub(crate) fn about_x(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

/// Rotation about y.
pub(crate) fn about_y(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c)
}

/// Rotation about z.
pub(crate) fn about_z(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_orders_give_their_rotation_back() {
        for angles in [[0.2, -0.4, 1.1], [-2.9, 0.9, -2.2], [0.0, 0.0, 0.0]] {
            let r = matrix(angles);
            assert!((matrix(euler(&r)) - r).norm() < 1e-15 * 4.0);
            let [y, z, x] = heading_first(&r);
            assert!((about_y(y) * about_z(z) * about_x(x) - r).norm() < 1e-15 * 4.0);
        }
    }
}
