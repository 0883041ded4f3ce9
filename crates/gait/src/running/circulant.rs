//! Linear operators on nodes that repeat, the same at each of them: the inverses of the grid's differences.
//!
//! A periodic difference divides each harmonic by nothing but a number of its own, so its inverse is exact but for the mean,
//! which no difference sees. (A Fourier transform there and back would do the same; at these numbers of nodes the plain sums are
//! as quick.)

use std::f64::consts::{PI, TAU};

/// Harmonics from this part of the shortest one (of two nodes) on are left out where the inverse of the **first** difference would
/// magnify them: that one cannot see the shortest at all.
const HARMONICS: f64 = 0.8;

/// `y_i = Σ_j c_{i−j} x_j`, indices modulo their number.
#[derive(Clone, Debug)]
pub(super) struct Circulant {
    /// `c_{−k}` twice over, so that each row is a slice.
    rows: Vec<f64>,
}

impl Circulant {
    /// The periodic integral of mean 0, `D₁⁻¹`: the inverse of the grid's first difference.
    ///
    /// ```text
    /// D₁ exp(ikj) = iσ exp(ikj)      σ = (90 sin k − 18 sin 2k + 2 sin 3k)/(60 h)
    /// ```
    pub(super) fn integral(count: usize, step: f64) -> Self {
        Self::of(count, |k| if seen(k) { (0.0, -1.0 / first(k, step)) } else { (0.0, 0.0) })
    }

    /// The same twice.
    pub(super) fn double_integral(count: usize, step: f64) -> Self {
        Self::of(count, |k| if seen(k) { (-first(k, step).powi(-2), 0.0) } else { (0.0, 0.0) })
    }

    /// What has a given second difference and the mean 0, `D₂⁻¹`:
    ///
    /// ```text
    /// D₂ exp(ikj) = (4 cos 3k − 54 cos 2k + 540 cos k − 490)/(180 h²) exp(ikj)
    /// ```
    pub(super) fn of_second(count: usize, step: f64) -> Self {
        Self::of(count, |k| {
            let sum = 4.0 * (3.0 * k).cos() - 54.0 * (2.0 * k).cos() + 540.0 * k.cos() - 490.0;
            (180.0 * step * step / sum, 0.0)
        })
    }

    /// The operator that multiplies the harmonic `exp(ikj)` by the complex number (real, imaginary) that `factor` gives for k; the
    /// mean by nothing. `count` is even.
    fn of(count: usize, factor: impl Fn(f64) -> (f64, f64)) -> Self {
        let turn = |m: usize| TAU * m as f64 / count as f64;
        let waves: Vec<(f64, f64)> = (0..count).map(|m| turn(m).sin_cos()).collect();
        let factors: Vec<(f64, f64)> = (1..=count / 2).map(|m| factor(turn(m))).collect();
        let column = |j: usize| {
            let harmonics = factors.iter().enumerate().map(|(i, (real, imaginary))| {
                let (sin, cos) = waves[(i + 1) * j % count];
                // The shortest harmonic is its own mirror image.
                let twice = if 2 * (i + 1) == count { 1.0 } else { 2.0 };
                twice * (real * cos - imaginary * sin)
            });
            harmonics.sum::<f64>() / count as f64
        };
        let once: Vec<f64> = (0..count).map(|k| column((count - k) % count)).collect();
        Self { rows: [&once[..], &once[..]].concat() }
    }

    /// Applied to the values at all nodes.
    pub(super) fn apply(&self, values: &[f64]) -> Vec<f64> {
        let count = values.len();
        (0..count).map(|i| dot(&self.rows[count - i..2 * count - i], values)).collect()
    }
}

/// Whether the first difference sees a harmonic well enough.
fn seen(k: f64) -> bool {
    k < HARMONICS * PI
}

/// What the first difference multiplies a harmonic by, over the imaginary unit.
fn first(k: f64, step: f64) -> f64 {
    (90.0 * k.sin() - 18.0 * (2.0 * k).sin() + 2.0 * (3.0 * k).sin()) / (60.0 * step)
}

/// The inner product, in four sums that do not wait for each other.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a, b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; 4];
    for (a, b) in a.zip(b) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Ends, Grid, SECOND};

    /// Two harmonics of mean 0.
    fn wave(count: usize) -> Vec<f64> {
        let at = |i: usize| TAU * i as f64 / count as f64;
        (0..count).map(|i| at(i).sin() + 0.3 * (5.0 * at(i) + 0.4).cos()).collect()
    }

    #[test]
    fn they_undo_the_grids_differences() {
        let (count, step) = (40, 0.017);
        let (grid, wave) = (Grid { count, step, ends: Ends::Periodic }, wave(count));
        let once = Circulant::integral(count, step).apply(&wave);
        let twice = Circulant::double_integral(count, step).apply(&wave);
        let curved = Circulant::of_second(count, step).apply(&wave);
        let unit = 1.0 / (180.0 * step * step);
        for i in 0..count {
            assert!((grid.first(i, |j| once[j]) - wave[i]).abs() < 1e-12);
            assert!((grid.first(i, |j| twice[j]) - once[i]).abs() < 1e-12);
            let second: f64 = (0..7).map(|k| SECOND[k] * unit * curved[(i + k + count - 3) % count]).sum();
            assert!((second - wave[i]).abs() < 1e-11);
        }
    }

    #[test]
    fn a_mean_has_no_integral() {
        for operator in [Circulant::integral(10, 0.1), Circulant::of_second(10, 0.1)] {
            assert!(operator.apply(&[3.0; 10]).iter().all(|x| x.abs() < 1e-12));
        }
    }
}
