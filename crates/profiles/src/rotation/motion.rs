//! Quaternions with their first two derivatives by time.

use crate::{Elementary, Scalar};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A quaternion, its rate and the rate of that.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion(pub(super) [Quaternion<f64>; 3]);

impl Motion {
    /// q·e^(s·v) for a fixed q and v and a number s that changes: as fast as `s` says.
    pub(super) fn along(q: UnitQuaternion<f64>, v: Vector3<f64>, s: [f64; 3]) -> Self {
        let p = q.into_inner() * exp(v * s[0]);
        let (rate, pure) = (p * Quaternion::from_imag(v), -v.norm_squared());
        // (e^(s·v))″ = (s″·v + s′²·v²)·e^(s·v), and v² = −|v|².
        Self([p, rate * s[1], rate * s[2] + p * (pure * s[1] * s[1])])
    }

    pub(super) fn conjugate(self) -> Self {
        Self(self.0.map(|q| q.conjugate()))
    }

    pub(super) fn product(self, other: Self) -> Self {
        let ([p, dp, ddp], [q, dq, ddq]) = (self.0, other.0);
        Self([p * q, dp * q + p * dq, ddp * q + dp * dq * 2.0 + p * ddq])
    }

    /// The vector v with e^v = q, and its derivatives. Not for q = −1, where there is none.
    pub(super) fn log(self) -> [Vector3<f64>; 3] {
        let [w, dw, ddw] = self.0.map(|q| q.w);
        let [v, dv, ddv] = self.0.map(|q| q.imag());
        let k = over_sine(v, [w, dw, ddw], [dv, ddv]);
        scaled(k, [v, dv, ddv])
    }
}

/// e^v of a changing vector: cos |v| + v·sin |v|/|v|.
pub(super) fn exp_of(v: [Vector3<f64>; 3]) -> Motion {
    let s = v[0].norm_squared();
    let (ds, dds) = (2.0 * v[0].dot(&v[1]), 2.0 * (v[1].norm_squared() + v[0].dot(&v[2])));
    // With c(s) = cos √s and k(s) = sin √s/√s: c′ = −k/2, k′ = (c − k)/(2s), k″ = −(k/2 + 3·k′)/(2s).
    let [c, k, k1, k2] = if s < 0.04 {
        series(s)
    } else {
        let angle = Elementary::sqrt(s);
        let (sine, c) = Scalar::sin_cos(angle);
        let k = sine / angle;
        let k1 = (c - k) / (2.0 * s);
        [c, k, k1, -(0.5 * k + 3.0 * k1) / (2.0 * s)]
    };
    let cosine = [c, -0.5 * k * ds, -0.5 * (k1 * ds * ds + k * dds)];
    let vector = scaled([k, k1 * ds, k2 * ds * ds + k1 * dds], v);
    Motion(core::array::from_fn(|i| Quaternion::from_parts(cosine[i], vector[i])))
}

/// e^v.
pub(super) fn exp(v: Vector3<f64>) -> Quaternion<f64> {
    exp_of([v, Vector3::zeros(), Vector3::zeros()]).0[0]
}

/// The vector v with e^v = q, at most π long: half the angle of the rotation along its axis. Of −1, which has many, one.
pub(super) fn log(q: Quaternion<f64>) -> Vector3<f64> {
    // The largest coordinate is taken out, since squares of small ones underflow.
    let v = q.imag();
    let largest = v.amax();
    if largest <= 0.0 {
        return if q.w < 0.0 { Vector3::x() * core::f64::consts::PI } else { Vector3::zeros() };
    }
    let sine = (v / largest).norm() * largest;
    // Below the last digits of the angle, sine and angle are the same.
    let angle = if q.w > 0.0 && sine < 1e-8 { sine } else { half_angle(sine, q.w) };
    v / largest * (angle / (sine / largest))
}

/// The vector v of the shortest way from one orientation to another; where both ways are the same, the one whose first
/// coordinate that is not zero is positive.
pub(super) fn shortest(from: &UnitQuaternion<f64>, to: &UnitQuaternion<f64>) -> Vector3<f64> {
    let q = from.into_inner().conjugate() * to.into_inner();
    let v = q.imag();
    let first = v.iter().copied().find(|x| x.abs() > 0.0).unwrap_or(0.0);
    if q.w < 0.0 || (q.w <= 0.0 && first < 0.0) { log(-q) } else { log(q) }
}

/// The angle in [0, π] with this sine and cosine.
fn half_angle(sine: f64, cosine: f64) -> f64 {
    // tan(φ/2) = sin φ/(1 + cos φ) = (1 − cos φ)/sin φ.
    if cosine >= 0.0 {
        2.0 * Elementary::atan(sine / (1.0 + cosine))
    } else {
        2.0 * Elementary::atan((1.0 - cosine) / sine)
    }
}

/// φ/sin φ, with its derivatives by time, where w = cos φ and |v| = sin φ.
fn over_sine(v: Vector3<f64>, [w, dw, ddw]: [f64; 3], [dv, ddv]: [Vector3<f64>; 2]) -> [f64; 3] {
    let s = v.norm_squared();
    if w > 0.0 && s < 0.01 {
        // asin(x)/x = Σ cₙ·x²ⁿ.
        const C: [f64; 8] = [
            1.0,
            1.0 / 6.0,
            3.0 / 40.0,
            5.0 / 112.0,
            35.0 / 1152.0,
            63.0 / 2816.0,
            231.0 / 13312.0,
            143.0 / 10240.0,
        ];
        let (ds, dds) = (2.0 * v.dot(&dv), 2.0 * (dv.norm_squared() + v.dot(&ddv)));
        let [k, k1, k2] = polynomial(&C, s);
        return [k, k1 * ds, k2 * ds * ds + k1 * dds];
    }
    // n = |v|: φ = atan2(n, w), φ′ = w·n′ − n·w′, φ″ = w·n″ − n·w″.
    let n = Elementary::sqrt(s);
    let dn = v.dot(&dv) / n;
    let ddn = (dv.norm_squared() + v.dot(&ddv) - dn * dn) / n;
    let (angle, rate, second) = (half_angle(n, w), w * dn - n * dw, w * ddn - n * ddw);
    let k = angle / n;
    let dk = (rate - k * dn) / n;
    [k, dk, (second - 2.0 * dk * dn - k * ddn) / n]
}

/// cos √s, sin √s/√s and the first two derivatives of that by s.
fn series(s: f64) -> [f64; 4] {
    const C: [f64; 7] = [
        1.0,
        -1.0 / 6.0,
        1.0 / 120.0,
        -1.0 / 5040.0,
        1.0 / 362_880.0,
        -1.0 / 39_916_800.0,
        1.0 / 6_227_020_800.0,
    ];
    let [k, k1, k2] = polynomial(&C, s);
    [Elementary::cos(Elementary::sqrt(s)), k, k1, k2]
}

/// A polynomial with its first two derivatives.
fn polynomial(coefficients: &[f64], x: f64) -> [f64; 3] {
    coefficients.iter().rev().fold([0.0; 3], |[p, d, h], c| [p * x + c, d * x + p, h * x + 2.0 * d])
}

/// k·v, by the product rule.
fn scaled([k, dk, ddk]: [f64; 3], [v, dv, ddv]: [Vector3<f64>; 3]) -> [Vector3<f64>; 3] {
    [v * k, v * dk + dv * k, v * ddk + dv * (2.0 * dk) + ddv * k]
}
