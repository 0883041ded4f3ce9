//! The thesis's tables of α and θ⁰ and its matrices of three turns, for the six orders of turns about x, y, z.

use super::rule::{Row, rows};
use nalgebra::{Matrix3, Vector3};
use solaris_model::EulerOrder;

/// The rows of two joints of one order at the start of a chain; every further joint repeats the last three.
///
/// ```
/// use solaris_dynamics::denavit_hartenberg::homogeneous;
/// use solaris_model::EulerOrder;
/// let degrees = homogeneous(EulerOrder::Zyx).map(|row| (row.alpha.to_degrees(), row.theta.to_degrees()));
/// assert_eq!(degrees[..3], [(0.0, 0.0), (-90.0, 0.0), (-90.0, -90.0)]);
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), appendix B.1; see [`rows`] for how they are read and `docs/sources.md` for what is wrong there.
pub fn homogeneous(order: EulerOrder) -> [Row; 6] {
    let rows = rows(&[word(order), word(order)].concat());
    std::array::from_fn(|i| rows[i])
}

/// The rows of a joint of the order `to` behind one of the order `from`.
///
/// # Source
///
/// Vasilonikolidakis (1991), appendix B.2, as [`homogeneous`].
pub fn heterogeneous(from: EulerOrder, to: EulerOrder) -> [Row; 3] {
    let rows = rows(&[word(from), word(to)].concat());
    std::array::from_fn(|i| rows[3 + i])
}

fn word(order: EulerOrder) -> [Vector3<f64>; 3] {
    order.axes().map(|axis| Vector3::ith(axis, 1.0))
}

/// The turn by `angles` (rad) about the coordinate axes of a frame that **stays**, one after the other in this order: the
/// matrices of appendix C, put right.
///
/// With θ, φ, χ about z, y, x, the order z, y, x gives `Rx(χ)·Ry(φ)·Rz(θ)`. A joint turns about axes that move along: its
/// chain Z-Y-X is `Rz(θ)·Ry(φ)·Rx(χ)`, the matrix of the order x, y, z
///
/// ```text
/// | cθ·cφ   cθ·sφ·sχ − sθ·cχ   cθ·sφ·cχ + sθ·sχ |
/// | sθ·cφ   sθ·sφ·sχ + cθ·cχ   sθ·sφ·cχ − cθ·sχ |
/// |   −sφ              cφ·sχ              cφ·cχ |
/// ```
///
/// ([`EulerOrder::rotation`] is a joint's).
///
/// ```
/// use solaris_dynamics::denavit_hartenberg::about_fixed_axes;
/// use solaris_model::EulerOrder;
/// let fixed = about_fixed_axes(EulerOrder::Xyz, [0.3, 0.2, 0.1]);
/// let joint = EulerOrder::Zyx.rotation(&[0.1, 0.2, 0.3]).to_rotation_matrix();
/// assert!((fixed - joint.matrix()).amax() < 1e-15);
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), appendix C. Six of its 54 entries are wrong; see `docs/sources.md`.
pub fn about_fixed_axes(order: EulerOrder, angles: [f64; 3]) -> Matrix3<f64> {
    // By axis, x first.
    let mut by_axis = [0.0; 3];
    for (axis, angle) in order.axes().into_iter().zip(angles) {
        by_axis[axis] = angle;
    }
    let [(sx, cx), (sf, cf), (st, ct)] = by_axis.map(f64::sin_cos);
    #[rustfmt::skip]
    let matrix = match order {
        EulerOrder::Zyx => Matrix3::new(
            cf * ct,                 -cf * st,                 sf,
            cx * st + sx * sf * ct,   cx * ct - sx * sf * st, -sx * cf,
            sx * st - sf * ct * cx,   sx * ct + cx * sf * st,  cx * cf,
        ),
        EulerOrder::Zxy => Matrix3::new(
             cf * ct + st * sf * sx, -cf * st + sf * sx * ct,  sf * cx,
             cx * st,                 cx * ct,                -sx,
            -sf * ct + cf * sx * st,  sf * st + cf * sx * ct,  cf * cx,
        ),
        EulerOrder::Yxz => Matrix3::new(
            ct * cf - st * sx * sf, -st * cx, ct * sf + st * sx * cf,
            st * cf + ct * sx * sf,  ct * cx, st * sf - ct * sx * cf,
            -sf * cx,                sx,      cx * cf,
        ),
        EulerOrder::Yzx => Matrix3::new(
            ct * cf,                -st,      ct * sf,
            cx * st * cf + sx * sf,  cx * ct, cx * st * sf - sx * cf,
            sx * st * cf - sf * cx,  sx * ct, sx * st * sf + cx * cf,
        ),
        EulerOrder::Xyz => Matrix3::new(
            ct * cf, ct * sf * sx - st * cx, ct * sf * cx + st * sx,
            st * cf, st * sf * sx + ct * cx, st * sf * cx - ct * sx,
            -sf,     cf * sx,                cf * cx,
        ),
        EulerOrder::Xzy => Matrix3::new(
             cf * ct, -cf * st * cx + sf * sx,  cf * st * sx + sf * cx,
             st,       ct * cx,                -sx * ct,
            -sf * ct,  sf * st * cx + cf * sx,  cf * cx - sf * st * sx,
        ),
    };
    matrix
}
