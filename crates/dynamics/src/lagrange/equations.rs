//! The equations of §4.4, one function each, in the thesis's order.
//!
//! Numbers are those of Vasilonikolidakis (1991); coordinates here are (x y z 1)ᵀ, the thesis's (1 x y z)ᵀ. The base `B_j` of
//! a branch or of the root stands before `A_j`: with it `W_{j−1}` below is `W_{j−1}·B_j`, and likewise for Ẇ and Ẅ. "Slip n" is row n of the table of
//! slips in `docs/sources.md`.

use super::constants::Link;
use super::products::{
    Placement, Products, Transform, TurnDerivative, add_scaled, by_inertial, by_moment, by_transposed,
    component, product, trace_of_product,
};
use crate::scalar::Scalar;
use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};

/// Where a degree of freedom stands and how it moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coordinate<T> {
    /// sin(θ⁰ + θ)
    pub(super) sine: T,
    /// cos(θ⁰ + θ)
    pub(super) cosine: T,
    /// s⁰ + s
    pub(super) s: T,
    /// q̇
    pub(super) rate: T,
    /// q̈
    pub(super) acceleration: T,
}

/// How the frame of a rationalised link stands and moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion<T> {
    /// `A_j`
    pub(super) transform: Matrix4<T>,
    /// `W_j`: from the frame to the world.
    pub(super) w: Matrix4<T>,
    /// `Ẇ_j`
    pub(super) rate: Matrix4<T>,
    /// `Ẅ_j`
    pub(super) acceleration: Matrix4<T>,
    /// `∂W_j/∂q_j`
    pub(super) by_coordinate: Matrix4<T>,
}

/// `W_{j−1}`, `Ẇ_{j−1}` and `Ẅ_{j−1}`, where they are not the world's, 1, 0 and 0.
#[derive(Clone, Copy)]
struct Before<T> {
    w: Option<Matrix4<T>>,
    rates: Option<(Matrix4<T>, Matrix4<T>)>,
}

/// Step 3 of §4.6 for one rationalised link: (4.1) to (4.9), and the boundary conditions of §3.8 for the first of a chain.
#[inline]
pub(super) fn advance<P: Products, T: Scalar>(
    link: &Link<T>,
    coordinate: &Coordinate<T>,
    base: Option<&Matrix4<T>>,
    parent: Option<&Motion<T>>,
) -> Motion<T> {
    let before = before::<P, T>(base, parent);
    let a = transform(link, coordinate);
    let (first, second) = (first_derivative(link, &a), second_derivative(link, &a));
    let w = before.w.map_or(a, |w| product::<P, Transform, T>(&w, &a));
    let by_coordinate = before.w.map_or(first, |w| times_first_derivative::<P, T>(link, &w, &first));
    let rate = rate::<P, T>(link, coordinate, &before, &a, &by_coordinate);
    let acceleration = acceleration::<P, T>(link, coordinate, &before, [&a, &first, &second], &by_coordinate);
    Motion { transform: a, w, rate, acceleration, by_coordinate }
}

/// The frame before the axis: that of the parent, moved by the base.
#[inline]
fn before<P: Products, T: Scalar>(base: Option<&Matrix4<T>>, parent: Option<&Motion<T>>) -> Before<T> {
    match (parent, base) {
        (None, base) => Before { w: base.copied(), rates: None },
        (Some(parent), None) => Before { w: Some(parent.w), rates: Some((parent.rate, parent.acceleration)) },
        (Some(parent), Some(base)) => {
            let moved = |matrix| product::<P, Placement, T>(matrix, base);
            Before {
                w: Some(moved(&parent.w)),
                rates: Some((moved(&parent.rate), moved(&parent.acceleration))),
            }
        }
    }
}

/// (4.1), with θ = θ⁰ + θ and s = s⁰ + s:
///
/// ```text
///     | cθ  −sθ·cα   sθ·sα  a·cθ |
/// A = | sθ   cθ·cα  −cθ·sα  a·sθ |
///     |  0      sα      cα     s |
///     |  0       0       0     1 |
/// ```
#[inline]
fn transform<T: Scalar>(link: &Link<T>, coordinate: &Coordinate<T>) -> Matrix4<T> {
    let (st, ct, s) = (coordinate.sine, coordinate.cosine, coordinate.s);
    let (sa, ca, a) = (link.sine_alpha, link.cosine_alpha, link.a);
    let (zero, one) = (T::zero(), T::one());
    #[rustfmt::skip]
    let transform = Matrix4::new(
        ct,   -(st * ca), st * sa,    a * ct,
        st,   ct * ca,    -(ct * sa), a * st,
        zero, sa,         ca,         s,
        zero, zero,       zero,       one,
    );
    transform
}

/// (4.3): the rows of `A` turned by a right angle, or for a slide a single one, along the z axis before `A`. (Slip
/// 14: in `A_2` and `A_3` of §4.7 it stands elsewhere.)
///
/// ```text
///                  | −sθ  −cθ·cα   cθ·sα  −a·sθ |                   | 0 0 0 0 |
/// A' of a turn  =  |  cθ  −sθ·cα   sθ·sα   a·cθ |   A' of a slide = | 0 0 0 0 |
///                  |   0       0       0      0 |                   | 0 0 0 1 |
///                  |   0       0       0      0 |                   | 0 0 0 0 |
/// ```
#[inline]
fn first_derivative<T: Scalar>(link: &Link<T>, a: &Matrix4<T>) -> Matrix4<T> {
    let mut derivative = Matrix4::zeros();
    if link.slides {
        derivative.m34 = T::one();
    } else {
        for column in 0..4 {
            derivative[(0, column)] = -a[(1, column)];
            derivative[(1, column)] = a[(0, column)];
        }
    }
    derivative
}

/// (4.4) (slip 13): the first two rows of `−A`; for a slide zero.
#[inline]
fn second_derivative<T: Scalar>(link: &Link<T>, a: &Matrix4<T>) -> Matrix4<T> {
    let mut derivative = Matrix4::zeros();
    if !link.slides {
        for column in 0..4 {
            derivative[(0, column)] = -a[(0, column)];
            derivative[(1, column)] = -a[(1, column)];
        }
    }
    derivative
}

/// `M·A'`, as in (4.9). For a slide: `M`'s z axis in the last column.
#[inline]
fn times_first_derivative<P: Products, T: Scalar>(
    link: &Link<T>,
    m: &Matrix4<T>,
    first: &Matrix4<T>,
) -> Matrix4<T> {
    if link.slides && !P::FULL {
        let mut out = Matrix4::zeros();
        out.set_column(3, &m.column(2));
        return out;
    }
    product::<P, TurnDerivative, T>(m, first)
}

/// (4.7), after §3.8 with `Ẇ_0 = 0`:
///
/// ```text
/// Ẇ_j = Ẇ_{j−1}·A_j + ∂W_j/∂q_j·q̇_j
/// ```
#[inline]
fn rate<P: Products, T: Scalar>(
    link: &Link<T>,
    coordinate: &Coordinate<T>,
    before: &Before<T>,
    a: &Matrix4<T>,
    by_coordinate: &Matrix4<T>,
) -> Matrix4<T> {
    let mut out = before.rates.map_or_else(Matrix4::zeros, |(rate, _)| product::<P, Transform, T>(&rate, a));
    add_scaled::<P, T>(&mut out, coordinate.rate, by_coordinate, link.first_column);
    out
}

/// (4.8) (slips 3 and 4), after §3.8 with `Ẇ_0 = Ẅ_0 = 0`; given `[A, A', A'']`:
///
/// ```text
/// Ẅ_j = Ẅ_{j−1}·A_j + 2·Ẇ_{j−1}·A'_j·q̇_j + W_{j−1}·A''_j·q̇_j² + ∂W_j/∂q_j·q̈_j
/// ```
#[inline]
fn acceleration<P: Products, T: Scalar>(
    link: &Link<T>,
    coordinate: &Coordinate<T>,
    before: &Before<T>,
    [a, first, second]: [&Matrix4<T>; 3],
    by_coordinate: &Matrix4<T>,
) -> Matrix4<T> {
    let v = coordinate.rate;
    let mut out = Matrix4::zeros();
    if let Some((rate, acceleration)) = &before.rates {
        out = product::<P, Transform, T>(acceleration, a);
        let coriolis = times_first_derivative::<P, T>(link, rate, first);
        add_scaled::<P, T>(&mut out, v + v, &coriolis, link.first_column);
    }
    if P::FULL || !link.slides {
        let centripetal = before.w.map_or(*second, |w| product::<P, TurnDerivative, T>(&w, second));
        add_scaled::<P, T>(&mut out, v * v, &centripetal, 0);
    }
    add_scaled::<P, T>(&mut out, coordinate.acceleration, by_coordinate, link.first_column);
    out
}

/// What a rationalised link passes on to those before it, in its own frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Balance<T> {
    /// `c_i`: first moment, with the mass as its last entry.
    pub(super) c: Vector4<T>,
    /// `D_i`
    pub(super) d: Matrix4<T>,
}

impl<T: Scalar> Balance<T> {
    /// The own terms of (4.10) and (4.11) (slip 1), `m_i·r_i`, the last column of `J_i`, and `J_i·Ẅ_iᵀ`.
    #[inline]
    pub(super) fn own<P: Products>(inertia: &Matrix4<T>, motion: &Motion<T>) -> Self {
        Self { c: inertia.column(3).into_owned(), d: by_transposed::<P, T>(inertia, &motion.acceleration) }
    }

    /// What a wrench from outside adds to `D_i`, so that (4.12) takes its generalised force off: with force `f` and moment `n`
    /// about the frame's origin, in world axes, and `R` the rotation in `W_i`,
    ///
    /// ```text
    ///      | ½·Rᵀ·[n]×  0 |        tr(∂W_i/∂q_i·D) = −(f·ẋ + n·ω)  in the motion  ∂W_i/∂q_i = | [ω]×·R  ẋ |
    /// D =  |    −fᵀ     0 |                                                                   |    0    0 |
    /// ```
    ///
    /// since `tr([ω]×·[n]×) = −2·ω·n`. For a force through a point `x` it is `−(W_i⁻¹·x)·fᵀ` less a symmetric part, that does no
    /// work.
    #[inline]
    pub(super) fn external(motion: &Motion<T>, force: &Vector3<T>, moment: &Vector3<T>) -> Self {
        let rotation = motion.w.fixed_view::<3, 3>(0, 0);
        let n = moment * T::from_f64(0.5);
        let zero = T::zero();
        #[rustfmt::skip]
        let cross = Matrix3::new(
            zero, -n.z, n.y,
            n.z,  zero, -n.x,
            -n.y, n.x,  zero,
        );
        let mut d = Matrix4::zeros();
        d.fixed_view_mut::<3, 3>(0, 0).copy_from(&(rotation.transpose() * cross));
        d.fixed_view_mut::<1, 3>(3, 0).copy_from(&(-force.transpose()));
        Self { c: Vector4::zeros(), d }
    }

    /// The second terms of (4.10) and (4.11), `A_{i+1}·c_{i+1}` and `A_{i+1}·D_{i+1}`, from the balance of the link after.
    #[inline]
    pub(super) fn carried<P: Products>(&self, a: &Matrix4<T>, base: Option<&Matrix4<T>>) -> Self {
        let (c, d) = (by_moment::<P, Transform, T>(a, &self.c), by_inertial::<P, Transform, T>(a, &self.d));
        match base {
            None => Self { c, d },
            Some(base) => Self {
                c: by_moment::<P, Placement, T>(base, &c),
                d: by_inertial::<P, Placement, T>(base, &d),
            },
        }
    }

    /// The sum of two balances, the first of which may be missing.
    #[inline]
    pub(super) fn plus<P: Products>(self, other: Option<Self>) -> Self {
        let Some(other) = other else { return self };
        let (mut c, mut d) = (self.c, self.d);
        for row in 0..4 {
            c[row] += other.c[row];
            for column in 0..if P::FULL { 4 } else { 3 } {
                d[(row, column)] += other.d[(row, column)];
            }
        }
        Self { c, d }
    }

    /// (4.12) (slip 5):
    ///
    /// ```text
    /// F_i = tr(∂W_i/∂q_i·D_i) − gᵀ·∂W_i/∂q_i·c_i
    /// ```
    #[inline]
    pub(super) fn force<P: Products>(&self, link: &Link<T>, gravity: &Vector3<T>, by: &Matrix4<T>) -> T {
        trace_of_product::<P, T>(by, &self.d, link.first_column)
            - component::<P, T>(gravity, by, &self.c, link.first_column)
    }
}
