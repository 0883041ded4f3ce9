//! From a curve that can be evaluated at any time to samples with their derivatives.

use super::{Motion, MotionError, MotionInfo};
use crate::figure::Figure;

/// A planned motion: positions at any time. Sampling is the last thing that happens to it.
pub trait Trajectory {
    /// How long it lasts (s); before 0 and after this it rests.
    fn duration(&self) -> f64;

    /// Writes the positions at time `t` (s) to `q` (length `nq`).
    fn configuration(&self, t: f64, q: &mut [f64]);

    /// The time (s) below which the curve has nothing to say: derivatives are taken over about so long. A planner that
    /// works on nodes gives their distance.
    fn resolution(&self) -> f64 {
        1.0 / 120.0
    }
}

/// First derivative from seven equally spaced values, divided by the step: error `h⁶ x⁽⁷⁾/140`.
const FIRST: [f64; 7] = [-1.0 / 60.0, 9.0 / 60.0, -45.0 / 60.0, 0.0, 45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];
/// Second derivative from seven equally spaced values, divided by the step's square: error `h⁶ x⁽⁸⁾/560`.
#[rustfmt::skip]
const SECOND: [f64; 7] =
    [2.0 / 180.0, -27.0 / 180.0, 270.0 / 180.0, -490.0 / 180.0, 270.0 / 180.0, -27.0 / 180.0, 2.0 / 180.0];

/// The steps of the difference formulas for a curve's resolution and a frame rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceStep {
    /// Frames a step; more than one where frames are finer than the curve.
    frames: usize,
    /// Steps a frame; more than one where frames are coarser than the curve.
    per_frame: usize,
    /// Length of a step (s).
    pub length: f64,
}

impl DifferenceStep {
    /// The shortest multiple of a frame that is not below `resolution` (s), or the shortest fraction of one that is not.
    pub fn new(resolution: f64, rate: f64) -> Self {
        let ratio = resolution * rate;
        let frames = (ratio - 1e-6).ceil().clamp(1.0, 1e6) as usize;
        let per_frame = (1.0 / ratio + 1e-6).floor().clamp(1.0, 1e6) as usize;
        Self { frames, per_frame, length: frames as f64 / (rate * per_frame as f64) }
    }

    /// The second derivative of a quantity from its values at −3, −2, … 3 steps; differences from the middle value keep
    /// what rests exactly at rest.
    pub fn second(&self, value: impl Fn(usize) -> f64) -> f64 {
        weighted(&SECOND, value) / (self.length * self.length)
    }

    fn first(&self, value: impl Fn(usize) -> f64) -> f64 {
        weighted(&FIRST, value) / self.length
    }
}

fn weighted(weights: &[f64; 7], value: impl Fn(usize) -> f64) -> f64 {
    let middle = value(3);
    (0..7).map(|k| weights[k] * (value(k) - middle)).sum()
}

impl Motion {
    /// Samples a trajectory `info.rate` times a second, from 0 to the first sample at or after its end.
    ///
    /// Velocities and accelerations are the sixth-order central differences of the positions, at the [`DifferenceStep`] of
    /// the trajectory's [`Trajectory::resolution`]. So they are the derivatives of what is written, whatever the rate; over
    /// whole frames they add up to the change in position; and a kink of the curve is spread over a few steps instead of
    /// being missed or infinite.
    ///
    /// # Errors
    ///
    /// A figure that the information is not for, a rate that is not positive, a duration that is not finite, and positions
    /// that are not finite.
    pub fn sample(
        figure: &Figure,
        trajectory: &impl Trajectory,
        info: MotionInfo,
    ) -> Result<Self, MotionError> {
        info.check_figure(figure)?;
        let rate = info.rate;
        if !(rate > 0.0 && rate <= 1e5) {
            return Err(MotionError::Rate { rate });
        }
        let nq = figure.layout().nq();
        let step = DifferenceStep::new(trajectory.resolution(), rate);
        let (stride, substeps) = (step.frames, step.per_frame);
        let fine_step = 1.0 / (rate * substeps as f64);
        let duration = trajectory.duration();
        let frames = duration * rate;
        if (frames * substeps as f64).is_nan() || frames * substeps as f64 > Self::MOST_SAMPLES as f64 {
            return Err(MotionError::Duration { duration, rate });
        }
        let samples = (frames - 1e-9).ceil().max(0.0) as usize + 1;
        // Fine sample k stands at (k − margin)·fine_step.
        let margin = 3 * stride;
        let mut fine = vec![0.0; ((samples - 1) * substeps + 2 * margin + 1) * nq];
        for (k, row) in fine.chunks_exact_mut(nq.max(1)).enumerate() {
            trajectory.configuration((k as f64 - margin as f64) * fine_step, row);
        }
        // Every coordinate is that of a one-axis degree of freedom; balls will need differences of their own.
        let mut columns = [(); 3].map(|()| Vec::with_capacity(samples * nq));
        for sample in 0..samples {
            let at = |k: usize, i: usize| fine[(sample * substeps + k * stride) * nq + i];
            for i in 0..nq {
                columns[0].push(at(3, i));
                columns[1].push(step.first(|k| at(k, i)));
                columns[2].push(step.second(|k| at(k, i)));
            }
        }
        let time = (0..samples).map(|sample| sample as f64 / rate).collect();
        Self::new(figure, info, time, columns)
    }
}
