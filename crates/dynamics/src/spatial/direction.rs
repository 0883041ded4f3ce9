//! Axes of single degrees of freedom: a formula is written once in terms of `e` and costs what the axis costs.

use crate::scalar::Scalar;
use crate::spatial::symmetric::Symmetric;
use nalgebra::{Matrix3, Vector3};

/// What one degree of freedom has done: kept from the way out for the way back.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moved<T> {
    /// Sine of the angle, or the distance slid, along the (positive) axis.
    pub(crate) s: T,
    /// Cosine of the angle.
    pub(crate) c: T,
}

/// A unit vector `e`, the axis of a degree of freedom.
pub(crate) trait Direction<T: Scalar>: Copy {
    /// `e·v`
    fn dot(self, v: &Vector3<T>) -> T;

    /// `v + k·e`
    fn add(self, v: Vector3<T>, k: T) -> Vector3<T>;

    /// `v × (k·e)`
    fn crossed(self, v: &Vector3<T>, k: T) -> Vector3<T>;

    /// `Rᵀ·v`: from the frame before a turn about `e` to the one after it.
    fn enter(self, v: Vector3<T>, turn: Moved<T>) -> Vector3<T>;

    /// `R·v`: from the frame after a turn about `e` to the one before it.
    fn leave(self, v: Vector3<T>, turn: Moved<T>) -> Vector3<T>;

    /// `frame·e`
    fn of(self, frame: &Matrix3<T>) -> Vector3<T>;

    /// `Mᵀ·e`
    fn of_transposed(self, matrix: &Matrix3<T>) -> Vector3<T>;

    /// `S·e`
    fn of_symmetric(self, matrix: &Symmetric<T>) -> Vector3<T>;

    /// How much of `e·S·e` can be rounding, where `S` has no negative eigenvalue.
    fn rounding(self, matrix: &Symmetric<T>) -> T;

    /// `R·S·Rᵀ`: from the frame after a turn about `e` to the one before it.
    fn leave_symmetric(self, matrix: &Symmetric<T>, turn: Moved<T>) -> Symmetric<T>;

    /// `R·M·Rᵀ`: from the frame after a turn about `e` to the one before it.
    fn leave_matrix(self, matrix: &Matrix3<T>, turn: Moved<T>) -> Matrix3<T>;

    /// `frame·R`: the axes of a frame, turned about `e` of that frame.
    fn turned(self, frame: &Matrix3<T>, turn: Moved<T>) -> Matrix3<T>;
}

/// The coordinate axis x (0), y (1) or z (2).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Along<const A: usize>;

impl<const A: usize> Along<A> {
    /// The two axes that follow in cyclic order: `A × B = C`.
    const B: usize = (A + 1) % 3;
    const C: usize = (A + 2) % 3;
}

impl<T: Scalar, const A: usize> Direction<T> for Along<A> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn dot(self, v: &Vector3<T>) -> T {
        v[A]
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn add(self, mut v: Vector3<T>, k: T) -> Vector3<T> {
        v[A] += k;
        v
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn crossed(self, v: &Vector3<T>, k: T) -> Vector3<T> {
        let mut out = Vector3::zeros();
        out[Self::B] = v[Self::C] * k;
        out[Self::C] = -(v[Self::B] * k);
        out
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn enter(self, mut v: Vector3<T>, turn: Moved<T>) -> Vector3<T> {
        let (b, c) = (v[Self::B], v[Self::C]);
        v[Self::B] = turn.s.times_plus(c, turn.c * b);
        v[Self::C] = turn.s.times_from(b, turn.c * c);
        v
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn leave(self, mut v: Vector3<T>, turn: Moved<T>) -> Vector3<T> {
        let (b, c) = (v[Self::B], v[Self::C]);
        v[Self::B] = turn.s.times_from(c, turn.c * b);
        v[Self::C] = turn.s.times_plus(b, turn.c * c);
        v
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn of(self, frame: &Matrix3<T>) -> Vector3<T> {
        Vector3::new(frame[(0, A)], frame[(1, A)], frame[(2, A)])
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn of_transposed(self, matrix: &Matrix3<T>) -> Vector3<T> {
        Vector3::new(matrix[(A, 0)], matrix[(A, 1)], matrix[(A, 2)])
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn of_symmetric(self, matrix: &Symmetric<T>) -> Vector3<T> {
        Vector3::new(matrix.at(0, A), matrix.at(1, A), matrix.at(2, A))
    }

    /// None: it is an entry of the matrix.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn rounding(self, _: &Symmetric<T>) -> T {
        T::zero()
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn leave_symmetric(self, matrix: &Symmetric<T>, turn: Moved<T>) -> Symmetric<T> {
        let (s, c) = (turn.s, turn.c);
        let (ab, ac) = (matrix.at(A, Self::B), matrix.at(A, Self::C));
        let (bb, cc, bc) =
            (matrix.at(Self::B, Self::B), matrix.at(Self::C, Self::C), matrix.at(Self::B, Self::C));
        // Rows first, then columns.
        let (b_of_b, b_of_c) = (s.times_from(bc, c * bb), s.times_from(cc, c * bc));
        let (c_of_b, c_of_c) = (s.times_plus(bb, c * bc), s.times_plus(bc, c * cc));
        let mut out = *matrix;
        out.set(A, Self::B, s.times_from(ac, c * ab));
        out.set(A, Self::C, s.times_plus(ab, c * ac));
        out.set(Self::B, Self::B, s.times_from(b_of_c, c * b_of_b));
        out.set(Self::B, Self::C, s.times_plus(b_of_b, c * b_of_c));
        out.set(Self::C, Self::C, s.times_plus(c_of_b, c * c_of_c));
        out
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn leave_matrix(self, matrix: &Matrix3<T>, turn: Moved<T>) -> Matrix3<T> {
        let (s, c) = (turn.s, turn.c);
        let mut out = *matrix;
        for column in 0..3 {
            let (b, d) = (matrix[(Self::B, column)], matrix[(Self::C, column)]);
            out[(Self::B, column)] = s.times_from(d, c * b);
            out[(Self::C, column)] = s.times_plus(b, c * d);
        }
        for row in 0..3 {
            let (b, d) = (out[(row, Self::B)], out[(row, Self::C)]);
            out[(row, Self::B)] = s.times_from(d, c * b);
            out[(row, Self::C)] = s.times_plus(b, c * d);
        }
        out
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn turned(self, frame: &Matrix3<T>, turn: Moved<T>) -> Matrix3<T> {
        let mut out = *frame;
        for row in 0..3 {
            let (b, c) = (frame[(row, Self::B)], frame[(row, Self::C)]);
            out[(row, Self::B)] = turn.s.times_plus(c, turn.c * b);
            out[(row, Self::C)] = turn.s.times_from(b, turn.c * c);
        }
        out
    }
}

/// An axis that is none of the coordinate axes, with the rotation about it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GeneralAxis<'a, T> {
    /// The unit vector.
    pub(crate) axis: &'a Vector3<T>,
    /// `R`; anything for a degree of freedom that slides.
    pub(crate) rotation: &'a Matrix3<T>,
}

impl<T: Scalar> Direction<T> for GeneralAxis<'_, T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn dot(self, v: &Vector3<T>) -> T {
        dot(self.axis, v)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn add(self, v: Vector3<T>, k: T) -> Vector3<T> {
        v + self.axis * k
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn crossed(self, v: &Vector3<T>, k: T) -> Vector3<T> {
        cross(v, &(self.axis * k))
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn enter(self, v: Vector3<T>, _: Moved<T>) -> Vector3<T> {
        apply_transposed(self.rotation, &v)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn leave(self, v: Vector3<T>, _: Moved<T>) -> Vector3<T> {
        apply(self.rotation, &v)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn of(self, frame: &Matrix3<T>) -> Vector3<T> {
        apply(frame, self.axis)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn of_transposed(self, matrix: &Matrix3<T>) -> Vector3<T> {
        apply_transposed(matrix, self.axis)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn of_symmetric(self, matrix: &Symmetric<T>) -> Vector3<T> {
        matrix.times(self.axis)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn rounding(self, matrix: &Symmetric<T>) -> T {
        (matrix.xx + matrix.yy + matrix.zz) * T::from_f64(4.0 * T::EPSILON)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn leave_symmetric(self, matrix: &Symmetric<T>, _: Moved<T>) -> Symmetric<T> {
        matrix.rotated(self.rotation)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn leave_matrix(self, matrix: &Matrix3<T>, _: Moved<T>) -> Matrix3<T> {
        conjugated(matrix, self.rotation)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn turned(self, frame: &Matrix3<T>, _: Moved<T>) -> Matrix3<T> {
        product(frame, self.rotation)
    }
}

/// The rotation of the quaternion `(u, w)` of length `|q|`, whatever the length:
///
/// ```text
/// R = 1 + s·(w·[u]× + [u]×²)          s = 2/|q|²
/// ```
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn quaternion_rotation<T: Scalar>([x, y, z, w]: [T; 4], squared_length: T) -> Matrix3<T> {
    let s = (T::one() + T::one()) / squared_length;
    let (sx, sy, sz) = (s * x, s * y, s * z);
    let (xx, yy, zz) = (sx * x, sy * y, sz * z);
    let (xy, xz, yz) = (sx * y, sx * z, sy * z);
    let (wx, wy, wz) = (sx * w, sy * w, sz * w);
    #[rustfmt::skip]
    let rotation = Matrix3::new(
        T::one() - (yy + zz), xy - wz,              xz + wy,
        xy + wz,              T::one() - (xx + zz), yz - wx,
        xz - wy,              yz + wx,              T::one() - (xx + yy),
    );
    rotation
}

/// The rotation about the unit vector `e` by an angle of sine `s` and cosine `c` (Rodrigues):
///
/// ```text
/// R = c·1 + s·[e]× + (1 − c)·e·eᵀ
/// ```
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn rodrigues<T: Scalar>(e: &Vector3<T>, s: T, c: T) -> Matrix3<T> {
    let k = T::one() - c;
    let (x, y, z) = (e.x, e.y, e.z);
    let (kx, ky, kz) = (k * x, k * y, k * z);
    #[rustfmt::skip]
    let rotation = Matrix3::new(
        kx * x + c,     kx * y - s * z, kx * z + s * y,
        kx * y + s * z, ky * y + c,     ky * z - s * x,
        kx * z - s * y, ky * z + s * x, kz * z + c,
    );
    rotation
}

/// `A·B`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn product<T: Scalar>(a: &Matrix3<T>, b: &Matrix3<T>) -> Matrix3<T> {
    let b = columns(b);
    let (x, y, z) = (apply(a, &b[0]), apply(a, &b[1]), apply(a, &b[2]));
    of_columns(&x, &y, &z)
}

/// The rows of a matrix.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn rows<T: Scalar>(m: &Matrix3<T>) -> [Vector3<T>; 3] {
    [Vector3::new(m.m11, m.m12, m.m13), Vector3::new(m.m21, m.m22, m.m23), Vector3::new(m.m31, m.m32, m.m33)]
}

/// Its columns.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn columns<T: Scalar>(m: &Matrix3<T>) -> [Vector3<T>; 3] {
    [Vector3::new(m.m11, m.m21, m.m31), Vector3::new(m.m12, m.m22, m.m32), Vector3::new(m.m13, m.m23, m.m33)]
}

/// The matrix of these columns.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn of_columns<T: Scalar>(x: &Vector3<T>, y: &Vector3<T>, z: &Vector3<T>) -> Matrix3<T> {
    Matrix3::new(x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z)
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn transposed<T: Scalar>(m: &Matrix3<T>) -> Matrix3<T> {
    Matrix3::new(m.m11, m.m21, m.m31, m.m12, m.m22, m.m32, m.m13, m.m23, m.m33)
}

/// `R·M·Rᵀ`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn conjugated<T: Scalar>(m: &Matrix3<T>, r: &Matrix3<T>) -> Matrix3<T> {
    product(r, &product(m, &transposed(r)))
}

/// `a₀·b₀ + a₁·b₁ + a₂·b₂`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn sum_of_products<T: Scalar>(a: [T; 3], b: [T; 3]) -> T {
    a[2].times_plus(b[2], a[1].times_plus(b[1], a[0] * b[0]))
}

/// `a·b`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn dot<T: Scalar>(a: &Vector3<T>, b: &Vector3<T>) -> T {
    sum_of_products([a.x, a.y, a.z], [b.x, b.y, b.z])
}

/// `a × b`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn cross<T: Scalar>(a: &Vector3<T>, b: &Vector3<T>) -> Vector3<T> {
    Vector3::new(
        a.z.times_from(b.y, a.y * b.z),
        a.x.times_from(b.z, a.z * b.x),
        a.y.times_from(b.x, a.x * b.y),
    )
}

/// `m·v`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn apply<T: Scalar>(m: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
    let v = [v.x, v.y, v.z];
    Vector3::new(
        sum_of_products([m.m11, m.m12, m.m13], v),
        sum_of_products([m.m21, m.m22, m.m23], v),
        sum_of_products([m.m31, m.m32, m.m33], v),
    )
}

/// `mᵀ·v`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn apply_transposed<T: Scalar>(m: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
    let v = [v.x, v.y, v.z];
    Vector3::new(
        sum_of_products([m.m11, m.m21, m.m31], v),
        sum_of_products([m.m12, m.m22, m.m32], v),
        sum_of_products([m.m13, m.m23, m.m33], v),
    )
}
