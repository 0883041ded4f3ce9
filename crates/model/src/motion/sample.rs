//! The sampling of trajectories, with derivatives by differences.

use super::{Motion, MotionError, MotionInfo};
use crate::configuration::rotation::{apply, between, log, read, unit};
use crate::figure::Figure;
use crate::joint::JointKind;
use nalgebra::Vector3;

/// A planned motion: positions at any time. Sampling is the last thing that happens to it.
#[doc(alias = "motion")]
#[doc(alias = "curve")]
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
    /// From one row of positions to the next (s), see [`Self::rows`].
    spacing: f64,
}

impl DifferenceStep {
    /// The shortest multiple of a frame that is not below `resolution` (s), or the shortest fraction of one that is not.
    pub fn new(resolution: f64, rate: f64) -> Self {
        let ratio = resolution * rate;
        let frames = (ratio - 1e-6).ceil().clamp(1.0, 1e6) as usize;
        let per_frame = (1.0 / ratio + 1e-6).floor().clamp(1.0, 1e6) as usize;
        let spacing = 1.0 / (rate * per_frame as f64);
        Self { frames, per_frame, length: frames as f64 / (rate * per_frame as f64), spacing }
    }

    /// How many rows of positions, equally spaced in time, so many samples are differenced from. The first one lies before the first
    /// sample, the last one after the last.
    pub fn rows(&self, samples: usize) -> usize {
        samples.saturating_sub(1) * self.per_frame + 2 * self.margin() + 1
    }

    /// Rows before the first sample.
    fn margin(&self) -> usize {
        3 * self.frames
    }

    /// The row that is value `k` of the seven of a sample.
    pub fn row(&self, sample: usize, k: usize) -> usize {
        sample * self.per_frame + k * self.frames
    }

    /// Whether a row is one of any sample's seven.
    pub fn asks_for(&self, row: usize) -> bool {
        row % self.per_frame < 7
    }

    /// The sample that a row lies at, or would beyond the last one; none before the first one or between two.
    pub fn sample(&self, row: usize) -> Option<usize> {
        let since = row.checked_sub(self.margin())?;
        since.is_multiple_of(self.per_frame).then_some(since / self.per_frame)
    }

    /// When a row is (s).
    pub fn time(&self, row: usize) -> f64 {
        (row as f64 - self.margin() as f64) * self.spacing
    }

    /// The second derivative of a quantity from its values at −3, −2, … 3 steps; differences from the middle value keep
    /// what rests exactly at rest.
    pub fn second(&self, value: impl Fn(usize) -> f64) -> f64 {
        weighted(&SECOND, value) / (self.length * self.length)
    }

    fn first(&self, value: impl Fn(usize) -> f64) -> f64 {
        weighted(&FIRST, value) / self.length
    }

    /// First and second derivatives of all coordinates in the middle of seven rows.
    fn of_rows<'a>(&self, row: impl Fn(usize) -> &'a [f64], first: &mut [f64], second: &mut [f64]) {
        first.fill(0.0);
        second.fill(0.0);
        let middle = row(3);
        for (k, (weight, second_weight)) in FIRST.iter().zip(SECOND).enumerate() {
            let value = &row(k)[..middle.len()];
            let (first, second) = (&mut first[..middle.len()], &mut second[..middle.len()]);
            for i in 0..middle.len() {
                let difference = value[i] - middle[i];
                first[i] += weight * difference;
                second[i] += second_weight * difference;
            }
        }
        let square = self.length * self.length;
        for (rate, second) in first.iter_mut().zip(second) {
            *rate /= self.length;
            *second /= square;
        }
    }

    /// Adds the velocities and accelerations of one joint in the middle of seven values of its `q`, to be settled before, whose
    /// derivatives are `first` and `second`.
    fn of_joint<'a>(
        &self,
        kind: &JointKind,
        q: impl Fn(usize) -> &'a [f64],
        [first, second]: [&[f64]; 2],
        v: &mut Vec<f64>,
        a: &mut Vec<f64>,
    ) {
        match kind {
            JointKind::Axes(_) => {
                v.extend_from_slice(first);
                a.extend_from_slice(second);
            }
            JointKind::Ball { .. } => {
                let [velocity, acceleration] = self.of_turn(&q);
                v.extend(velocity.iter());
                a.extend(acceleration.iter());
            }
            JointKind::Free { .. } => {
                let [velocity, acceleration] = self.of_turn(|k| &q(k)[3..]);
                let inwards = read(&q(3)[3..]).conjugate();
                let linear = apply(&inwards, &Vector3::from_column_slice(&first[..3]));
                let second = apply(&inwards, &Vector3::from_column_slice(&second[..3]));
                v.extend(linear.iter().chain(velocity.iter()));
                // The axes of v turn with the link: v = Rᵀẋ, v̇ = Rᵀẍ − ω×v.
                a.extend((second - velocity.cross(&linear)).iter().chain(acceleration.iter()));
            }
        }
    }

    /// Angular velocity and acceleration along the turning axes, from seven unit quaternions without a change of sign.
    ///
    /// With `φ` the turn from the middle, `ω = φ̇ − ½ φ×φ̇ + …`: there, at `φ = 0`, `ω = φ̇` and `ω̇ = φ̈ − ½ φ̇×φ̇ = φ̈`.
    fn of_turn<'a>(&self, q: impl Fn(usize) -> &'a [f64]) -> [Vector3<f64>; 2] {
        let middle = read(q(3));
        let turns: [Vector3<f64>; 7] = std::array::from_fn(|k| log(&between(&middle, &read(q(k)))));
        [
            Vector3::from_fn(|i, _| self.first(|k| turns[k][i])),
            Vector3::from_fn(|i, _| self.second(|k| turns[k][i])),
        ]
    }
}

/// Gives the quaternions of all rows unit length, and each the sign that is nearer to the row before: a rotation has two
/// quaternions, and differences must not see which one a curve takes. Numbers that are not finite are left to be refused.
fn settle(figure: &Figure, rows: &mut [f64], time: impl Fn(usize) -> f64) -> Result<(), MotionError> {
    let nq = figure.layout().nq();
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let Some(first) = link.joint().kind().quaternion() else { continue };
        let mut before = None;
        for (k, row) in rows.chunks_exact_mut(nq).enumerate() {
            let turn = &mut row[at.q + first..][..4];
            if turn.iter().any(|x| !x.is_finite()) {
                continue;
            }
            let Some(mut q) = unit(&read(turn)) else {
                let joint = link.joint().name().to_owned();
                return Err(MotionError::Quaternion { joint, time: time(k), length: 0.0 });
            };
            if before.is_some_and(|before| q.dot(&before) < 0.0) {
                q = -q;
            }
            turn.copy_from_slice(q.coords.as_slice());
            before = Some(q);
        }
    }
    Ok(())
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
    /// **Ball and free joints** are differenced as rotations: with `φ_k` the turn from the middle value to value k along the link's
    /// axes, and `x` the place of a free joint,
    ///
    /// ```text
    /// φ_k = log(R_mᵀ·R_k)      ω = φ̇      ω̇ = φ̈      v = R_mᵀ·ẋ      v̇ = R_mᵀ·ẍ − ω×v
    /// ```
    ///
    /// The turn may pass half a turn, but must stay below a third of one in a step. Quaternions need not have unit length: they
    /// are normalised, and written with the sign that is nearer to the value before.
    ///
    /// # Errors
    ///
    /// A figure that the information is not for, a rate that is not positive, a duration that is not finite, positions
    /// that are not finite, and zero quaternions.
    #[doc(alias = "resample")]
    #[doc(alias = "bake")]
    pub fn sample(
        figure: &Figure,
        trajectory: &(impl Trajectory + ?Sized),
        info: MotionInfo,
    ) -> Result<Self, MotionError> {
        info.check_figure(figure)?;
        let rate = info.rate;
        if !(rate > 0.0 && rate <= MotionInfo::HIGHEST_RATE) {
            return Err(MotionError::Rate { rate });
        }
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let step = DifferenceStep::new(trajectory.resolution(), rate);
        let duration = trajectory.duration();
        let (frames, substeps) = (duration * rate, step.per_frame as f64);
        if (frames * substeps).is_nan() || frames * substeps > Self::MOST_SAMPLES as f64 {
            return Err(MotionError::Duration { duration, rate });
        }
        let samples = (frames - 1e-9).ceil().max(0.0) as usize + 1;
        let mut rows = vec![0.0; step.rows(samples) * nq];
        for (row, q) in rows.chunks_exact_mut(nq.max(1)).enumerate() {
            trajectory.configuration(step.time(row), q);
        }
        settle(figure, &mut rows, |row| step.time(row))?;
        let mut columns = [nq, nv, nv].map(|width| Vec::with_capacity(samples * width));
        let [mut first, mut second] = [0; 2].map(|_| vec![0.0; nq]);
        for sample in 0..samples {
            let row = |k: usize| &rows[step.row(sample, k) * nq..][..nq];
            step.of_rows(row, &mut first, &mut second);
            let [q, v, a] = &mut columns;
            q.extend_from_slice(row(3));
            for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
                let of = at.q..at.q + at.nq;
                let rates = [&first[of.clone()], &second[of.clone()]];
                step.of_joint(link.joint().kind(), |k| &row(k)[of.clone()], rates, v, a);
            }
        }
        let time = (0..samples).map(|sample| sample as f64 / rate).collect();
        Self::new(figure, info, time, columns)
    }
}
