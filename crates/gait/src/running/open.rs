//! Integrals over nodes that do not repeat, the inverses of the grid's differences but for two constants each.

use std::f64::consts::TAU;

/// Taps on either side of what makes a double sum the inverse of the grid's second difference: they fall to a tenth from one to the next.
const TAPS: usize = 14;
/// Nodes of the circle on which they are found.
const CIRCLE: usize = 64;

/// Integrals over nodes a `step` apart.
#[derive(Clone, Debug)]
pub(super) struct Open {
    step: f64,
    taps: [f64; TAPS],
}

impl Open {
    /// The grid's second difference is that of neighbours after a filter of five nodes,
    ///
    /// ```text
    /// D₂ = δ²·Q/h²      Q exp(ikj) = (222 − 46 cos k + 4 cos 2k)/180 exp(ikj)
    /// ```
    ///
    /// so its inverse is the double sum of `Q⁻¹`, whose taps are found on a circle.
    pub(super) fn new(step: f64) -> Self {
        let tap = |j: usize| {
            let wave = |m: usize| {
                let k = TAU * m as f64 / CIRCLE as f64;
                180.0 * (k * j as f64).cos() / (222.0 - 46.0 * k.cos() + 4.0 * (2.0 * k).cos())
            };
            (0..CIRCLE).map(wave).sum::<f64>() / CIRCLE as f64
        };
        Self { step, taps: std::array::from_fn(tap) }
    }

    /// From 0 at the first node on, by the quintic through six nodes between each two:
    ///
    /// ```text
    /// ∫ = h/1440 (11 f₋₂ − 93 f₋₁ + 802 f₀ + 802 f₁ − 93 f₂ + 11 f₃)
    /// ```
    pub(super) fn integral(&self, values: &[f64]) -> Vec<f64> {
        let last = values.len() as isize - 1;
        let at = |i: isize| values[i.clamp(0, last) as usize];
        let mut sum = 0.0;
        let mut sums = Vec::with_capacity(values.len());
        for i in 0..=last {
            sums.push(sum);
            let near = 802.0 * (at(i) + at(i + 1)) - 93.0 * (at(i - 1) + at(i + 2));
            sum += self.step / 1440.0 * (near + 11.0 * (at(i - 2) + at(i + 3)));
        }
        sums
    }

    /// What has these second differences, and at the first node the value 0 and no rate.
    pub(super) fn of_second(&self, values: &[f64]) -> Vec<f64> {
        let last = values.len() as isize - 1;
        let at = |i: isize| values[i.clamp(0, last) as usize];
        let filtered = |i: isize| {
            let around = (1..TAPS).map(|j| self.taps[j] * (at(i + j as isize) + at(i - j as isize)));
            self.taps[0] * at(i) + around.sum::<f64>()
        };
        let (mut value, mut rise) = (0.0, 0.0);
        let mut sums = Vec::with_capacity(values.len());
        for i in 0..=last {
            sums.push(value);
            // Half of the first one: from the node on, not from half a step before it.
            rise += if i == 0 { 0.5 * filtered(i) } else { filtered(i) } * self.step * self.step;
            value += rise;
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Ends, Grid, SECOND};

    #[test]
    fn they_undo_the_grids_differences() {
        let (count, step) = (200, 0.01);
        let open = Open::new(step);
        let grid = Grid { count, step, ends: Ends::Open };
        // A wave of k rad a node: the differences of sixth order miss k⁶/140 of its rate, the quintic's integral 191 k⁶/60480.
        let k: f64 = 0.12;
        let wave = |i: usize| (k * i as f64).sin();
        let missed = 1.01 * k.powi(6) * (1.0 / 140.0 + 191.0 / 60480.0);
        let values: Vec<f64> = (0..count).map(wave).collect();
        let (once, twice) = (open.integral(&values), open.of_second(&values));
        for i in 20..count - 20 {
            assert!((grid.first(i, |j| once[j]) - wave(i)).abs() < missed);
            let second: f64 = (0..7).map(|k| SECOND[k] / (180.0 * step * step) * twice[i + k - 3]).sum();
            assert!((second - wave(i)).abs() < 1e-11);
        }
        // From 0 without a rate: of a constant it is the parabola.
        let parabola = open.of_second(&[2.0; 30]);
        assert!((parabola[29] - (29.0 * step).powi(2)).abs() < 1e-12);
    }
}
