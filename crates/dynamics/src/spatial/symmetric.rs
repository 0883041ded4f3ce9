//! Symmetric 3 × 3 matrices.

use crate::scalar::Scalar;
use crate::spatial::direction::{dot, rows, sum_of_products};
use nalgebra::{Matrix3, Vector3};

/// The six different entries of a symmetric matrix.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Symmetric<T> {
    pub(crate) xx: T,
    pub(crate) yy: T,
    pub(crate) zz: T,
    pub(crate) xy: T,
    pub(crate) xz: T,
    pub(crate) yz: T,
}

impl<T: Scalar> Symmetric<T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn zero() -> Self {
        let o = T::zero();
        Self { xx: o, yy: o, zz: o, xy: o, xz: o, yz: o }
    }

    /// The upper triangle of `m`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn of(m: &Matrix3<T>) -> Self {
        Self { xx: m.m11, yy: m.m22, zz: m.m33, xy: m.m12, xz: m.m13, yz: m.m23 }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn at(&self, row: usize, column: usize) -> T {
        match (row, column) {
            (0, 0) => self.xx,
            (1, 1) => self.yy,
            (2, 2) => self.zz,
            (0, 1) | (1, 0) => self.xy,
            (0, 2) | (2, 0) => self.xz,
            _ => self.yz,
        }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn set(&mut self, row: usize, column: usize, value: T) {
        let entry = match (row, column) {
            (0, 0) => &mut self.xx,
            (1, 1) => &mut self.yy,
            (2, 2) => &mut self.zz,
            (0, 1) | (1, 0) => &mut self.xy,
            (0, 2) | (2, 0) => &mut self.xz,
            _ => &mut self.yz,
        };
        *entry = value;
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn add(&mut self, other: &Self) {
        self.xx += other.xx;
        self.yy += other.yy;
        self.zz += other.zz;
        self.xy += other.xy;
        self.xz += other.xz;
        self.yz += other.yz;
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn trace(&self) -> T {
        self.xx + self.yy + self.zz
    }

    /// `S ← S − u·wᵀ`, where the product is symmetric.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn subtract_outer(&mut self, u: &Vector3<T>, w: &Vector3<T>) {
        self.xx = u.x.times_from(w.x, self.xx);
        self.yy = u.y.times_from(w.y, self.yy);
        self.zz = u.z.times_from(w.z, self.zz);
        self.xy = u.x.times_from(w.y, self.xy);
        self.xz = u.x.times_from(w.z, self.xz);
        self.yz = u.y.times_from(w.z, self.yz);
    }

    /// `S·v`
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn times(&self, v: &Vector3<T>) -> Vector3<T> {
        let v = [v.x, v.y, v.z];
        Vector3::new(
            sum_of_products([self.xx, self.xy, self.xz], v),
            sum_of_products([self.xy, self.yy, self.yz], v),
            sum_of_products([self.xz, self.yz, self.zz], v),
        )
    }

    /// All nine entries.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn full(&self) -> Matrix3<T> {
        #[rustfmt::skip]
        let full = Matrix3::new(
            self.xx, self.xy, self.xz,
            self.xy, self.yy, self.yz,
            self.xz, self.yz, self.zz,
        );
        full
    }

    /// `R·S·Rᵀ`
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn rotated(&self, rotation: &Matrix3<T>) -> Self {
        let rows = rows(rotation);
        let (x, y, z) = (self.times(&rows[0]), self.times(&rows[1]), self.times(&rows[2]));
        Self {
            xx: dot(&rows[0], &x),
            yy: dot(&rows[1], &y),
            zz: dot(&rows[2], &z),
            xy: dot(&rows[0], &y),
            xz: dot(&rows[0], &z),
            yz: dot(&rows[1], &z),
        }
    }
}

/// A symmetric matrix as `L·D·Lᵀ`, `L` with ones on its diagonal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factor<T> {
    /// `1/D`
    pub(crate) pivots: [T; 3],
    yx: T,
    zx: T,
    zy: T,
}

impl<T: Scalar> Factor<T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn zero() -> Self {
        let o = T::zero();
        Self { pivots: [o; 3], yx: o, zx: o, zy: o }
    }

    /// The vector that the matrix takes to `v`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn solve(&self, v: &Vector3<T>) -> Vector3<T> {
        let y = self.yx.times_from(v.x, v.y);
        let z = self.zy.times_from(y, self.zx.times_from(v.x, v.z));
        let z = z * self.pivots[2];
        let y = self.zy.times_from(z, y * self.pivots[1]);
        Vector3::new(self.zx.times_from(z, self.yx.times_from(y, v.x * self.pivots[0])), y, z)
    }
}

impl<T: Scalar> Symmetric<T> {
    /// The `D` of axis 0, 1 or 2, without a look at its sign; those before it must not be zero.
    pub(crate) fn pivot(&self, axis: usize) -> T {
        let (yx, zx) = (self.xy / self.xx, self.xz / self.xx);
        let (y, left) = (self.yy - yx * self.xy, self.yz - yx * self.xz);
        match axis {
            0 => self.xx,
            1 => y,
            _ => self.zz - zx * self.xz - left / y * left,
        }
    }

    /// The factors of a positive definite matrix. A pivot of which nothing but rounding is left makes them NaN.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn factor(&self) -> Factor<T> {
        let rounding = T::from_f64(4.0 * T::EPSILON);
        let x = self.xx.recip_or_nan((self.yy + self.zz) * rounding);
        let (yx, zx) = (self.xy * x, self.xz * x);
        let y = (self.yy - yx * self.xy).recip_or_nan(self.yy * rounding);
        let left = self.yz - yx * self.xz;
        let zy = left * y;
        let z = (self.zz - zx * self.xz - zy * left).recip_or_nan(self.zz * rounding);
        Factor { pivots: [x, y, z], yx, zx, zy }
    }
}
