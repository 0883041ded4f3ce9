//! The laws of standing up: how trunk and hips move over the time.

use std::f64::consts::PI;

const DEGREE: f64 = PI / 180.0;

/// When the seat is left, as a part of the time.
pub(super) const SEAT_OFF: f64 = 0.36;
/// When the hips begin to move: they roll forward over the seat before they leave it, and what is soft below them lets them rise.
const HIPS_FROM: f64 = 0.22;
/// How far the trunk leans forward in sitting, more than in standing.
const SEATED_LEAN: f64 = 3.0 * DEGREE;
/// How far it leans more before it is fitted, when most, and for how long before and after, in parts of the time.
const FIRST_LEAN: f64 = 40.0 * DEGREE;
const LEANS_AT: (f64, f64) = (0.40, 0.42);

/// Intervals of the splines that are fitted: of the trunk's lean over all of the time, of the hips' way from where it begins.
const TRUNK: usize = 18;
const HIPS: usize = 15;
/// Of a quintic spline of so many intervals, how many of its parts are nothing with four derivatives at both ends.
const fn free(intervals: usize) -> usize {
    intervals - 5
}
/// How many numbers are fitted: of the trunk's lean (rad), of the hips' way along and up (m).
pub(super) const FITTED: usize = free(TRUNK) + 2 * free(HIPS);

/// Hips in sitting or standing: height and place along z (m).
#[derive(Clone, Copy, Debug)]
pub(super) struct Hips {
    pub(super) height: f64,
    pub(super) along: f64,
}

/// What the laws say at one time.
#[derive(Clone, Copy, Debug)]
pub(super) struct At {
    pub(super) hips: Hips,
    /// Forward lean of the thorax, more than in standing (rad).
    pub(super) lean: f64,
    /// 0 in sitting, 1 in standing.
    pub(super) risen: f64,
}

/// The laws of one person and seat.
#[derive(Clone, Debug)]
pub(super) struct Laws {
    pub(super) seated: Hips,
    pub(super) standing: Hips,
    pub(super) fitted: [f64; FITTED],
}

impl Laws {
    /// Those that a fit begins with: the trunk leans forward and back once.
    pub(super) fn new(seated: Hips, standing: Hips) -> Self {
        let (middle, half) = LEANS_AT;
        let fitted = std::array::from_fn(|k| {
            // Part k is greatest in the middle of its six intervals.
            let x = (k as f64 + 3.0) / TRUNK as f64 - middle;
            if k < free(TRUNK) {
                FIRST_LEAN * 0.5 * (1.0 + (PI * (x / half).clamp(-1.0, 1.0)).cos())
            } else {
                0.0
            }
        });
        Self { seated, standing, fitted }
    }

    /// At a part of the time: 0 and before it in sitting, 1 and after it in standing.
    ///
    /// ```text
    /// φ = φ₀ (1 − S₇(u)) + Σ c B₅      h = h₀ + (h₁ − h₀) S₇((u − u₀)/(1 − u₀)) + Σ c B₅
    /// ```
    pub(super) fn at(&self, u: f64) -> At {
        let (trunk, rest) = self.fitted.split_at(free(TRUNK));
        let (along, up) = rest.split_at(free(HIPS));
        let hips = (u - HIPS_FROM) / (1.0 - HIPS_FROM);
        let risen = septic(hips);
        let between = |from: f64, to: f64| from + (to - from) * risen;
        At {
            hips: Hips {
                height: between(self.seated.height, self.standing.height) + spline(up, hips),
                along: between(self.seated.along, self.standing.along) + spline(along, hips),
            },
            lean: SEATED_LEAN * (1.0 - septic(u)) + spline(trunk, u),
            risen,
        }
    }
}

/// A spline of equal intervals from 0 to 1, of its free parts; nothing outside.
fn spline(parts: &[f64], u: f64) -> f64 {
    if !(0.0..1.0).contains(&u) {
        return 0.0;
    }
    let at = u * (parts.len() + 5) as f64;
    let first = (at as usize).saturating_sub(5);
    parts.iter().enumerate().skip(first).take(6).map(|(k, part)| part * quintic_part(at - k as f64)).sum()
}

/// The quintic B-spline on the six unit intervals from 0 on:
///
/// ```text
/// B₅(x) = Σ (−1)ᵏ (6 over k) (x − k)₊⁵ / 5!
/// ```
fn quintic_part(x: f64) -> f64 {
    const SIGNED: [f64; 4] = [1.0, -6.0, 15.0, -20.0];
    // It is symmetric about 3, and fewer powers cancel before it.
    let x = 3.0 - (x - 3.0).abs();
    SIGNED.iter().enumerate().map(|(k, n)| n * (x - k as f64).max(0.0).powi(5)).sum::<f64>() / 120.0
}

/// From 0 to 1 with three derivatives of nothing at both ends.
///
/// ```text
/// S₇ = 35 t⁴ − 84 t⁵ + 70 t⁶ − 20 t⁷
/// ```
fn septic(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t.powi(4) * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn so_many_numbers_are_fitted() {
        assert_eq!(FITTED, 33);
    }

    #[test]
    fn the_parts_of_a_spline_sum_to_one_and_end_in_nothing() {
        for x in [0.0, 0.25, 0.5, 0.999] {
            let sum: f64 = (0..6).map(|k| quintic_part(x + f64::from(k))).sum();
            assert!((sum - 1.0).abs() < 1e-14, "{x}: {sum}");
        }
        let parts = [1.0, -2.0, 0.5, 3.0];
        for end in [1e-4, 1.0 - 1e-4] {
            assert!(spline(&parts, end).abs() < 1e-12);
        }
        assert!([-0.1, 0.0, 1.0, 1.1].iter().all(|u| spline(&parts, *u).abs() < 1e-15));
        // Nine intervals; the second part alone bears all in the middle of the fourth one but for its neighbours.
        let alone = [0.0, 1.0, 0.0, 0.0];
        assert!((spline(&alone, 4.0 / 9.0) - 66.0 / 120.0).abs() < 1e-14);
    }
}
