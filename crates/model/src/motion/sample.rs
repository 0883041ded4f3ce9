//! From a curve that can be evaluated at any time to samples with their derivatives.

use super::{Motion, MotionError, MotionInfo};
use crate::figure::Figure;

/// A planned motion: positions at any time. Sampling is the last thing that happens to it.
pub trait Trajectory {
    /// How long it lasts (s); before 0 and after this it rests.
    fn duration(&self) -> f64;

    /// Writes the positions at time `t` (s) to `q` (length `nq`).
    fn configuration(&self, t: f64, q: &mut [f64]);
}

/// The longest step of the difference formulas (s): what a person's joints do in less has no meaning.
const LONGEST_STEP: f64 = 1.0 / 120.0;

/// First derivative from seven equally spaced values, divided by the step: error `h⁶ x⁽⁷⁾/140`.
const FIRST: [f64; 7] = [-1.0 / 60.0, 9.0 / 60.0, -45.0 / 60.0, 0.0, 45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];
/// Second derivative from seven equally spaced values, divided by the step's square: error `h⁶ x⁽⁸⁾/560`.
#[rustfmt::skip]
const SECOND: [f64; 7] =
    [2.0 / 180.0, -27.0 / 180.0, 270.0 / 180.0, -490.0 / 180.0, 270.0 / 180.0, -27.0 / 180.0, 2.0 / 180.0];

impl Motion {
    /// Samples a trajectory `info.rate` times a second, from 0 to the first sample at or after its end.
    ///
    /// Velocities and accelerations are the sixth-order central differences of the positions, at a step of one frame or
    /// the longest fraction of it that is at most 1/120 s. So they are the derivatives of what is written, they add up to
    /// the change in position, and a kink of the curve is spread over three steps instead of being missed or infinite.
    ///
    /// # Errors
    ///
    /// A rate that is not positive, a duration that is not finite, and positions that are not finite.
    pub fn sample(figure: &Figure, trajectory: &impl Trajectory, info: MotionInfo) -> Result<Self, MotionError> {
        let rate = info.rate;
        if !(rate > 0.0 && rate <= 1e5) {
            return Err(MotionError::Rate { rate });
        }
        let nq = figure.layout().nq();
        let substeps = (1.0 / (rate * LONGEST_STEP)).ceil().max(1.0) as usize;
        let step = 1.0 / (rate * substeps as f64);
        let duration = trajectory.duration();
        let frames = duration * rate;
        if !(frames * substeps as f64 <= Self::MOST_SAMPLES as f64) {
            return Err(MotionError::Duration { duration, rate });
        }
        let last = (frames - 1e-9).ceil().max(0.0) as usize;
        // Substep k stands at (k − 3)·step.
        let fine: Vec<f64> = {
            let count = last * substeps + 7;
            let mut rows = vec![0.0; count * nq];
            for (k, row) in rows.chunks_exact_mut(nq.max(1)).enumerate() {
                trajectory.configuration((k as f64 - 3.0) * step, row);
            }
            rows
        };
        let samples = last + 1;
        let mut columns = [Vec::new(), Vec::new(), Vec::new()].map(|mut c: Vec<f64>| {
            c.reserve_exact(samples * nq);
            c
        });
        for sample in 0..samples {
            let at = |k: usize, i: usize| fine[(sample * substeps + k) * nq + i];
            for i in 0..nq {
                let value = at(3, i);
                // Differences from the middle keep a coordinate at rest exactly at rest.
                let sum = |weights: &[f64; 7]| (0..7).map(|k| weights[k] * (at(k, i) - value)).sum::<f64>();
                columns[0].push(value);
                columns[1].push(sum(&FIRST) / step);
                columns[2].push(sum(&SECOND) / (step * step));
            }
        }
        let time = (0..samples).map(|sample| sample as f64 / rate).collect();
        Self::new(figure, info, time, columns)
    }
}
