//! When an animation has keys, and what the positions are there.

use solaris_model::{EventKind, Figure, Motion};

/// A key: when (s, from the motion's own zero), after which sample, and how far on to the next one (0 to 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Key {
    pub(crate) time: f64,
    pub(crate) sample: usize,
    pub(crate) on: f64,
}

/// How near to a sample or to another event an event needs no key of its own, of the time between two samples.
const NEAR: f64 = 0.02;

/// The samples, and the contacts' events between them, in order.
pub(crate) fn times(motion: &Motion) -> Vec<Key> {
    let time = motion.time();
    let mut keys = samples(motion);
    for event in &motion.events {
        if !matches!(event.kind, EventKind::TouchDown { .. } | EventKind::LiftOff { .. }) {
            continue;
        }
        let after = time.partition_point(|t| *t <= event.time);
        if after == 0 || after == time.len() {
            continue;
        }
        let sample = after - 1;
        let on = (event.time - time[sample]) / (time[after] - time[sample]);
        if (NEAR..=1.0 - NEAR).contains(&on) {
            keys.push(Key { time: event.time, sample, on });
        }
    }
    keys.sort_by(|a, b| a.time.total_cmp(&b.time));
    // Samples stay.
    keys.dedup_by(|next, last| next.sample == last.sample && next.on - last.on < NEAR);
    keys
}

/// The samples alone.
pub(crate) fn samples(motion: &Motion) -> Vec<Key> {
    let keys = motion.time().iter().enumerate();
    keys.map(|(sample, time)| Key { time: *time, sample, on: 0.0 }).collect()
}

/// Of keys that the numbers of a file, of seven digits from `start` (s) on, do not tell apart one: a sample before an event, the last of samples.
pub(crate) fn told_apart(keys: Vec<Key>, start: f64) -> Vec<Key> {
    let told = |key: &Key| (key.time - start) as f32;
    let mut apart: Vec<Key> = Vec::with_capacity(keys.len());
    for key in keys {
        match apart.last_mut().filter(|last| told(last) >= told(&key)) {
            None => apart.push(key),
            Some(last) if key.on <= 0.0 => *last = key,
            Some(_) => {}
        }
    }
    apart
}

/// The positions at a key. Between samples each coordinate goes along the polynomial that has the positions of both, and their
/// velocities and accelerations where they are known; quaternions turn evenly.
pub(crate) fn positions(figure: &Figure, motion: &Motion, key: &Key) -> Vec<f64> {
    let from = motion.q(key.sample).to_vec();
    if key.on <= 0.0 {
        return from;
    }
    let after = key.sample + 1;
    let to = motion.q(after);
    let mut q = from.clone();
    // Both are positions of the figure.
    if figure.interpolate(&from, to, key.on, &mut q).is_err() {
        return from;
    }
    let width = motion.time()[after] - motion.time()[key.sample];
    let known = motion.known();
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        for i in 0..link.joint().kind().axes().len() {
            let (k, d) = (at.q + i, at.v + i);
            if !known.v[d] {
                continue;
            }
            let rates = [motion.v(key.sample)[d] * width, motion.v(after)[d] * width];
            let bends = [motion.a(key.sample)[d] * width * width, motion.a(after)[d] * width * width];
            q[k] = between([from[k], to[k]], rates, known.a[d].then_some(bends), key.on);
        }
    }
    q
}

/// The value at `s` of the cubic that has `values` and `rates` at 0 and 1; with `bends`, the quintic that has these second
/// derivatives, too (Hermite).
fn between(values: [f64; 2], rates: [f64; 2], bends: Option<[f64; 2]>, s: f64) -> f64 {
    let [p, q] = values;
    let [m, n] = rates;
    let (s2, s3) = (s * s, s * s * s);
    let Some([b, c]) = bends else {
        return p + (q - p) * (3.0 * s2 - 2.0 * s3) + m * (s3 - 2.0 * s2 + s) + n * (s3 - s2);
    };
    let (s4, s5) = (s2 * s2, s2 * s3);
    p + (q - p) * (10.0 * s3 - 15.0 * s4 + 6.0 * s5)
        + m * (s - 6.0 * s3 + 8.0 * s4 - 3.0 * s5)
        + n * (-4.0 * s3 + 7.0 * s4 - 3.0 * s5)
        + b * (0.5 * s2 - 1.5 * s3 + 1.5 * s4 - 0.5 * s5)
        + c * (0.5 * s3 - s4 + 0.5 * s5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_of_third_and_fifth_order_come_back() {
        let cubic = |s: f64| 1.0 + s * (2.0 + s * (-3.0 + s * 4.0));
        let found = between([cubic(0.0), cubic(1.0)], [2.0, 8.0], None, 0.3);
        assert!((found - cubic(0.3)).abs() < 1e-14);
        let quintic = |s: f64| s.powi(5) - 2.0 * s.powi(4) + s.powi(2);
        let found = between([0.0, 0.0], [0.0, -1.0], Some([2.0, -2.0]), 0.3);
        assert!((found - quintic(0.3)).abs() < 1e-14, "{found} and {}", quintic(0.3));
    }
}
