//! Motions on a ground that are known in closed form.

use crate::report::simulation::solutions::{Solution, pendulum};
use std::f64::consts::PI;

/// A slip that smooth friction slows down, `u̇ = −a·u/√(u² + s²)` from `u₀`: velocity and way at a time.
///
/// ```text
/// a·t = F(u₀) − F(u)    F(u) = √(u² + s²) − s·asinh(s/u)        a·x = W(u₀) − W(u)    W(u) = ½·(u·√(u² + s²) + s²·asinh(u/s))
/// ```
fn slowed(start: f64, slowing: f64, slip: f64, time: f64) -> (f64, f64) {
    let spent = |u: f64| u.hypot(slip) - slip * (slip / u).asinh();
    let way = |u: f64| 0.5 * (u * u.hypot(slip) + slip * slip * (u / slip).asinh());
    // By its logarithm: it dies out and never ends.
    let (mut low, mut high) = (-600.0, start.ln());
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if spent(start) - spent(middle.exp()) > slowing * time { low = middle } else { high = middle }
    }
    let u = high.exp();
    (u, (way(start) - way(u)) / slowing)
}

/// A block that slides at the height `y` (m): position along and up.
pub(super) fn sliding(speed: f64, slowing: f64, slip: f64, y: f64) -> Solution {
    Box::new(move |t, q, v| {
        let (u, x) = slowed(speed, slowing, slip, t);
        q.copy_from_slice(&[x, y]);
        v.copy_from_slice(&[u, 0.0]);
    })
}

/// A solid ball thrown along the ground without spin: it slides, and then rolls. What its slip loses is 7/2 of what its
/// velocity loses, and `v − ⅖·r·ω = v₀` stays.
pub(super) fn rolling(speed: f64, slowing: f64, slip: f64, radius: f64, y: f64) -> Solution {
    Box::new(move |t, q, v| {
        let (u, slid) = slowed(speed, 3.5 * slowing, slip, t);
        let (lost, behind) = (2.0 / 7.0 * (speed - u), 2.0 / 7.0 * (speed * t - slid));
        q.copy_from_slice(&[speed * t - behind, y, -2.5 * behind / radius]);
        v.copy_from_slice(&[speed - lost, 0.0, -2.5 * lost / radius]);
    })
}

/// A mass that falls from `height` (m) on a spring without damping, `rate` (rad/s) its frequency there: it comes back for ever.
///
/// ```text
/// y = −(g/ω²)·(1 − cos ωt) − (u/ω)·sin ωt  on the spring, for ωT = 2·(π − atan(u·ω/g)), after it met it with u
/// ```
pub(super) fn springing(height: f64, rate: f64, gravity: f64) -> Solution {
    Box::new(move |t, q, v| {
        let speed = (2.0 * gravity * height).sqrt();
        let (fall, pressed) = (speed / gravity, 2.0 * (PI - (speed * rate / gravity).atan()) / rate);
        let since = t % (2.0 * fall + pressed);
        let on = since - fall;
        if (0.0..pressed).contains(&on) {
            let (sin, cos) = (rate * on).sin_cos();
            q[0] = -gravity / (rate * rate) * (1.0 - cos) - speed / rate * sin;
            v[0] = -gravity / rate * sin - speed * cos;
        } else {
            // From one highest point to the next.
            let free = if on < 0.0 { since } else { on - pressed - fall };
            q[0] = height - 0.5 * gravity * free * free;
            v[0] = -gravity * free;
        }
    })
}

/// A box that falls by `height` (m) and stays, its middle `half` (m) above the ground then.
pub(super) fn dropping(height: f64, half: f64, gravity: f64) -> Solution {
    Box::new(move |t, q, v| {
        let falls = 0.5 * gravity * t * t < height;
        q.copy_from_slice(&[0.0, half + if falls { height - 0.5 * gravity * t * t } else { 0.0 }, 0.0]);
        v.copy_from_slice(&[0.0, if falls { -gravity * t } else { 0.0 }, 0.0]);
    })
}

/// An uniform rod of the half length `l` (m) on a point that holds it, let go `tilt` (rad) off the vertical: a pendulum that begins
/// near its upper end.
pub(super) fn tipping(l: f64, tilt: f64, gravity: f64) -> Solution {
    let swing = pendulum(PI - tilt, (0.75 * gravity / l).sqrt());
    Box::new(move |t, q, v| {
        let (mut hanging, mut turning) = ([0.0], [0.0]);
        swing(t, &mut hanging, &mut turning);
        let (theta, turning) = (PI - hanging[0], -turning[0]);
        q.copy_from_slice(&[l * theta.sin(), l * theta.cos(), -theta]);
        v.copy_from_slice(&[l * theta.cos() * turning, -l * theta.sin() * turning, -turning]);
    })
}

/// G. W. Housner's block (1963) of the half width `b` and half height `h` (m), let go on its right corner, `tilt` (rad) to the right:
/// each flight is that of a pendulum upside down, `ψ̈ = ω²·sin ψ` with `ψ = α − tilt`, and each impact leaves `1 − (3/2)·sin²α` of its
/// velocity.
pub(super) fn rocking(b: f64, h: f64, tilt: f64, gravity: f64) -> Solution {
    let (alpha, r) = (b.atan2(h), b.hypot(h));
    let rate = (0.75 * gravity / r).sqrt();
    let left = 1.0 - 1.5 * alpha.sin().powi(2);
    Box::new(move |t, q, v| {
        let (mut turn, mut highest, mut side) = (0.0, alpha - tilt, 1.0);
        let mut half = until(highest, alpha, rate);
        while t > turn + half {
            highest = (alpha.cos() + left * left * (highest.cos() - alpha.cos())).acos();
            side = -side;
            let next = until(highest, alpha, rate);
            (turn, half) = (turn + half + next, next);
        }
        let (mut hanging, mut turning) = ([0.0], [0.0]);
        pendulum(PI - highest, rate)((t - turn).abs(), &mut hanging, &mut turning);
        let (psi, turning) = (PI - hanging[0], -turning[0] * (t - turn).signum());
        // The right corner is at 0, the left one at −2·b.
        let pivot = b * (side - 1.0);
        q.copy_from_slice(&[pivot - side * r * psi.sin(), r * psi.cos(), side * (psi - alpha)]);
        v.copy_from_slice(&[-side * r * psi.cos() * turning, -r * psi.sin() * turning, side * turning]);
    })
}

/// The time (s) from rest at `ψ` = `highest` until `alpha` (rad).
fn until(highest: f64, alpha: f64, rate: f64) -> f64 {
    let swing = pendulum(PI - highest, rate);
    // More than any flight of a block that is not balanced on its corner.
    let (mut low, mut high) = (0.0, 2.0 / rate);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        let (mut hanging, mut turning) = ([0.0], [0.0]);
        swing(middle, &mut hanging, &mut turning);
        if PI - hanging[0] < alpha { low = middle } else { high = middle }
    }
    low
}

/// A body that comes down on a leg, `length` (m) to begin with and with the velocity −`speed` (m/s), whose foot stays: a spring
/// of the frequency `rate` (rad/s) and the decay `decay` (1/s) about `rest` (m). Length and velocity after `t` (s).
pub(super) fn landed([length, speed, rest]: [f64; 3], rate: f64, decay: f64, t: f64) -> (f64, f64) {
    let (x, swing) = (length - rest, (rate * rate - decay * decay).sqrt());
    let b = (decay * x - speed) / swing;
    let (sin, cos) = (swing * t).sin_cos();
    let fades = (-decay * t).exp();
    let velocity = fades * ((b * swing - decay * x) * cos - (x * swing + decay * b) * sin);
    (rest + fades * (x * cos + b * sin), velocity)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Velocities are the derivatives of positions, and what starts, starts where it is said to.
    #[test]
    fn answers_begin_where_they_should_and_move_as_they_say() {
        let g = 9.81;
        let all: [(&str, usize, Solution); 6] = [
            ("sliding", 2, sliding(2.0, 0.4 * g, 1e-2, -1e-3)),
            ("rolling", 3, rolling(2.0, 0.3 * g, 1e-2, 0.1, 0.1)),
            ("springing", 1, springing(0.05, 100.0, g)),
            ("dropping", 3, dropping(0.3, 0.1, g)),
            ("tipping", 3, tipping(0.5, 0.2, g)),
            ("rocking", 3, rocking(0.15, 0.5, 0.14, g)),
        ];
        for (name, n, solution) in all {
            let at = |t: f64| {
                let (mut q, mut v) = (vec![0.0; n], vec![0.0; n]);
                solution(t, &mut q, &mut v);
                (q, v)
            };
            // Beside the jumps of dropping and rocking.
            for t in [0.05, 0.12, 0.2, 0.31, 0.45, 0.6] {
                let ((before, _), (_, v), (after, _)) = (at(t - 1e-6), at(t), at(t + 1e-6));
                for i in 0..n {
                    let slope = (after[i] - before[i]) / 2e-6;
                    assert!(
                        (slope - v[i]).abs() < 1e-6 * (1.0 + v[i].abs()),
                        "{name}, {t}, {i}: {slope} {}",
                        v[i]
                    );
                }
            }
        }
    }

    /// A block keeps where its corner is, through the first impact.
    #[test]
    fn a_rocking_block_jumps_nowhere() {
        let solution = rocking(0.15, 0.5, 0.14, 9.81);
        let mut last: Option<[f64; 3]> = None;
        for i in 0..20_000 {
            let (mut q, mut v) = ([0.0; 3], [0.0; 3]);
            solution(f64::from(i) * 1e-4, &mut q, &mut v);
            if let Some(last) = last {
                assert!(q.iter().zip(&last).all(|(a, b)| (a - b).abs() < 1e-3), "{i}: {last:?} {q:?}");
            }
            last = Some(q);
        }
    }
}
