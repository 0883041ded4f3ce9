//! Motions that are known in closed form.

use solaris_model::{UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// Writes position and velocity at a time (s).
pub(super) type Solution = Box<dyn Fn(f64, &mut [f64], &mut [f64])>;

/// A pendulum let go from `start` (rad) at rest, `rate` the frequency of small swings (rad/s).
///
/// ```text
/// sin(θ/2) = k·sn(ω·t + K, k)     θ̇ = 2·k·ω·cn(ω·t + K, k)     k = sin(θ₀/2)
/// ```
pub(super) fn pendulum(start: f64, rate: f64) -> Solution {
    let modulus = (0.5 * start).sin();
    let quarter = quarter_period(modulus);
    Box::new(move |t, q, v| {
        let (sn, cn) = jacobi(rate * t + quarter, modulus);
        q[0] = 2.0 * (modulus * sn).asin();
        v[0] = 2.0 * modulus * rate * cn;
    })
}

/// The arithmetic-geometric mean of 1 and `k′`, with the steps on the way: `(a, c)`.
fn means(modulus: f64) -> Vec<(f64, f64)> {
    let (mut a, mut b) = (1.0_f64, (1.0 - modulus * modulus).sqrt());
    let mut steps = vec![(a, modulus)];
    while steps.len() < 12 && (a - b).abs() > 1e-17 {
        steps.push((0.5 * (a + b), 0.5 * (a - b)));
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    steps
}

/// `K(k)`.
pub(super) fn quarter_period(modulus: f64) -> f64 {
    FRAC_PI_2 / means(modulus).last().map_or(1.0, |(a, _)| *a)
}

/// `sn u` and `cn u` by descending Landen transformations (Abramowitz and Stegun, 16.4).
fn jacobi(u: f64, modulus: f64) -> (f64, f64) {
    let steps = means(modulus);
    let last = steps.len() - 1;
    let mut phi = 2_f64.powi(last as i32) * steps[last].0 * u;
    for (a, c) in steps[1..].iter().rev() {
        phi = 0.5 * (phi + (c / a * phi.sin()).asin());
    }
    phi.sin_cos()
}

/// A body with the moments `a`, `a`, `c` (kg m²) about its axes, on a ball joint at its centre of mass, that begins
/// upright with the angular velocity `spin` (rad/s) and on which nothing acts.
///
/// ```text
/// R(t) = exp(L·t/a)·exp(Ω·e₃·t)     Ω = ω₃·(a − c)/a
/// ```
pub(super) fn top(a: f64, c: f64, spin: Vector3<f64>) -> Solution {
    let momentum = Vector3::new(a * spin.x, a * spin.y, c * spin.z);
    let slip = spin.z * (a - c) / a;
    Box::new(move |t, q, v| {
        let own = UnitQuaternion::from_scaled_axis(Vector3::z() * (slip * t));
        let turned = UnitQuaternion::from_scaled_axis(momentum * (t / a)) * own;
        q.copy_from_slice(turned.coords.as_slice());
        let spin = turned.inverse() * (momentum / a) + Vector3::z() * slip;
        v.copy_from_slice(spin.as_slice());
    })
}

/// A body thrown from the origin with `velocity` (m/s) that spins about its principal axis z.
pub(super) fn thrown(velocity: Vector3<f64>, spin: f64, gravity: Vector3<f64>) -> Solution {
    Box::new(move |t, q, v| {
        let place = velocity * t + gravity * (0.5 * t * t);
        let turned = UnitQuaternion::from_scaled_axis(Vector3::z() * (spin * t));
        let moving = turned.inverse() * (velocity + gravity * t);
        q[..3].copy_from_slice(place.as_slice());
        q[3..].copy_from_slice(turned.coords.as_slice());
        v[..3].copy_from_slice(moving.as_slice());
        v[3..].copy_from_slice(&[0.0, 0.0, spin]);
    })
}

/// A mass on a spring with less than critical damping, let go at `start` (m): `ẍ = −ω²·x − 2·δ·ẋ`.
pub(super) fn damped(start: f64, rate: f64, decay: f64) -> Solution {
    let swing = (rate * rate - decay * decay).sqrt();
    Box::new(move |t, q, v| {
        let (sin, cos) = (swing * t).sin_cos();
        let now = start * (-decay * t).exp();
        q[0] = now * (cos + decay / swing * sin);
        v[0] = -now * rate * rate / swing * sin;
    })
}

/// A mass that falls from `height` (m) and bounces with the restitution `e`.
pub(super) fn bouncing(height: f64, restitution: f64, gravity: f64) -> Solution {
    Box::new(move |t, q, v| {
        let mut speed = (2.0 * gravity * height).sqrt();
        // As if it had been thrown up before the beginning.
        let mut begun = -speed / gravity;
        while begun + 2.0 * speed / gravity <= t {
            begun += 2.0 * speed / gravity;
            speed *= restitution;
        }
        let since = t - begun;
        q[0] = since * (speed - 0.5 * gravity * since);
        v[0] = speed - gravity * since;
    })
}

/// The slowest mode of a chain of `count` equal point masses on threads of `length` (m), of small angles: the joints'
/// angles at its turning point, as large as `size` (rad) in all, and its frequency (rad/s).
///
/// With `x = ω²·l/g`, displacements counted from the free end are Laguerre polynomials `L_j(x)`, and `L_n(x) = 0` at the
/// support.
pub(super) fn chain_mode(count: usize, length: f64, gravity: f64, size: f64) -> (Vec<f64>, f64) {
    let laguerre = |x: f64| {
        let mut all = vec![1.0, 1.0 - x];
        for j in 1..count {
            let n = j as f64;
            all.push(((2.0 * n + 1.0 - x) * all[j] - n * all[j - 1]) / (n + 1.0));
        }
        all
    };
    // The first zero lies below the first of the second polynomial, and above zero, where all are one.
    let (mut low, mut high) = (0.0, 1.5 / count as f64);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if laguerre(middle)[count] > 0.0 { low = middle } else { high = middle }
    }
    let shape = laguerre(low);
    // Angles of the threads from the vertical, the uppermost first.
    let threads: Vec<f64> = (0..count).rev().map(|j| (shape[j] - shape[j + 1]) / length).collect();
    let scale = size / threads.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let joints = (0..count).map(|i| scale * (threads[i] - if i > 0 { threads[i - 1] } else { 0.0 }));
    (joints.collect(), (low * gravity / length).sqrt())
}

/// All joints swing together.
pub(super) fn swinging(joints: Vec<f64>, rate: f64) -> Solution {
    Box::new(move |t, q, v| {
        let (sin, cos) = (rate * t).sin_cos();
        for (i, joint) in joints.iter().enumerate() {
            q[i] = joint * cos;
            v[i] = -joint * rate * sin;
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published with the benchmark: from (−1, 0), in a gravity of 9.81.
    #[test]
    fn the_pendulum_is_that_of_the_benchmark() {
        let rate = 9.81_f64.sqrt();
        let period = 4.0 * quarter_period(0.5_f64.sqrt()) / rate;
        assert!((period - 2.367_841_947_576_237).abs() < 1e-14, "{period}");
        let (mut q, mut v) = ([0.0], [0.0]);
        pendulum(FRAC_PI_2, rate)(10.0, &mut q, &mut v);
        assert!((-q[0].sin() + 0.275_087_462_576_116_9).abs() < 1e-13, "{}", q[0]);
        assert!((-q[0].cos() + 0.961_419_204_099_125_3).abs() < 1e-9, "{}", q[0].cos());
        // Energy: v²/2 = g·cos θ.
        assert!((0.5 * v[0] * v[0] - 9.81 * q[0].cos()).abs() < 1e-12);
    }

    /// The first zero of the tenth Laguerre polynomial.
    #[test]
    fn the_chain_swings_at_a_zero_of_a_laguerre_polynomial() {
        let (_, rate) = chain_mode(10, 1.0, 1.0, 1.0);
        assert!((rate * rate - 0.137_793_470_540_492_4).abs() < 1e-13, "{rate}");
    }
}
