//! The fit of the laws: of the least jerk, with the feet pressed where they are to be once the seat is left.

use super::forces::{SEATED_PRESSURE, pressed, totals};
use super::laws::{At, FITTED, Laws, SEAT_OFF};
use super::sitter::Sitter;
use crate::error::GaitError;
use nalgebra::{SMatrix, SVector};
use solaris_dynamics::Tree;
use solaris_model::{Figure, Motion, MotionInfo, Trajectory};
use solaris_profiles::Clip;
use solaris_profiles::spline::CubicSpline;

/// Where the feet are pressed once the seat is left, over the time: parts of it, and of the feet's length from the heel.
const PRESSURE: [(f64, f64); 5] = [(SEAT_OFF, 0.27), (0.48, 0.42), (0.64, 0.48), (0.84, 0.42), (1.0, 0.37)];
/// Part of the weight that stays on the feet before.
const ON_FEET: f64 = 0.1;
/// How near the pressure is to come (m, at a height of 1.75 m), how near the knees are to come to straight (the same), and joints to their ranges (rad).
const NEAR: f64 = 0.006;
const NEAR_STRAIGHT: f64 = 0.0003;
const NEAR_RANGE: f64 = 0.1 * std::f64::consts::PI / 180.0;
/// What jerks are held against: of the trunk (rad), of the hips along and up (m, at a height of 1.75 m), a rise's time cubed. Smooth ways as far as people's have some 200 rad and
/// 40 m; the trunk's is less, for it leans no farther than it must.
const JERK: [f64; 3] = [80.0, 42.0, 45.0];

/// Samples of a rise that are looked at.
const SAMPLES: u32 = 96;
/// Steps of the fit, and how often each is tried with a damping that is so many times as strong.
const STEPS: usize = 10;
const TRIES: usize = 6;
const DAMPING: f64 = 1e-2;
const STRONGER: f64 = 8.0;
const WEAKER: f64 = 0.2;
/// What a number is changed by for its differences (rad, m), and a gain that is none.
const CHANGE: f64 = 2e-5;
const SETTLED: f64 = 1e-5;

/// One rise of a person, with laws that are tried.
struct Rise<'a> {
    sitter: &'a Sitter,
    laws: &'a Laws,
    duration: f64,
}

impl Trajectory for Rise<'_> {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.sitter.write(&self.laws.at(t / self.duration), q);
    }

    fn resolution(&self) -> f64 {
        self.duration / f64::from(SAMPLES)
    }
}

/// What is fitted, to whom.
pub(super) struct Fit<'a> {
    pub(super) figure: &'a Figure,
    pub(super) tree: &'a Tree<f64>,
    pub(super) sitter: &'a Sitter,
    /// Of a rise (s).
    pub(super) duration: f64,
}

impl Fit<'_> {
    /// The laws nearest to what is asked of them, by steps of Gauss and Newton that are damped:
    ///
    /// ```text
    /// min Σ [((P − P_law)/σ)² + (d/σ_d)² + (ρ/σ_ρ)² + |jerk/j|²]/n      (JᵀJ + λ diag JᵀJ) s = −Jᵀr
    /// ```
    ///
    /// Before the seat is left, `P − P_law` is what the pressure is behind of where a part of the weight is on the feet, or nothing; `d` is by how much knees are too
    /// straight, `ρ` what joints are beyond their ranges.
    pub(super) fn fitted(&self, mut laws: Laws) -> Result<Laws, GaitError> {
        let pressure = CubicSpline::monotone(&PRESSURE)?.into_clip();
        let cost = |missed: &[f64]| missed.iter().map(|x| x * x).sum::<f64>();
        let mut missed = self.missed(&laws, &pressure)?;
        let mut damping = DAMPING;
        for _ in 0..STEPS {
            let (normal, down) = self.normal(&laws, &missed, &pressure)?;
            let before = cost(&missed);
            for _ in 0..TRIES {
                let mut damped = normal;
                (0..FITTED).for_each(|k| damped[(k, k)] *= 1.0 + damping);
                let Some(found) = damped.cholesky() else { break };
                let step = found.solve(&down);
                let tried =
                    Laws { fitted: std::array::from_fn(|k| laws.fitted[k] + step[k]), ..laws.clone() };
                let left = self.missed(&tried, &pressure)?;
                if cost(&left) < before {
                    (laws, missed) = (tried, left);
                    damping *= WEAKER;
                    break;
                }
                damping *= STRONGER;
            }
            if before - cost(&missed) <= SETTLED * before {
                break;
            }
        }
        Ok(laws)
    }

    /// `JᵀJ` and `−Jᵀr`, by differences.
    fn normal(
        &self,
        laws: &Laws,
        missed: &[f64],
        pressure: &Clip<CubicSpline>,
    ) -> Result<(SMatrix<f64, FITTED, FITTED>, SVector<f64, FITTED>), GaitError> {
        let column = |k: usize| -> Result<Vec<f64>, GaitError> {
            let mut tried = laws.clone();
            tried.fitted[k] += CHANGE;
            let left = self.missed(&tried, pressure)?;
            Ok(left.iter().zip(missed).map(|(a, b)| (a - b) / CHANGE).collect())
        };
        let columns = (0..FITTED).map(column).collect::<Result<Vec<_>, _>>()?;
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        Ok((
            SMatrix::from_fn(|i, j| dot(&columns[i], &columns[j])),
            SVector::from_fn(|i, _| -dot(&columns[i], missed)),
        ))
    }

    /// How far everything is from what is asked of it, each over what it may be.
    fn missed(&self, laws: &Laws, pressure: &Clip<CubicSpline>) -> Result<Vec<f64>, GaitError> {
        let Self { figure, tree, sitter, duration } = *self;
        let info = MotionInfo::on_earth(figure, f64::from(SAMPLES) / duration);
        let motion = Motion::sample(figure, &Rise { sitter, laws, duration }, info)?;
        let [near, straight] = [NEAR, NEAR_STRAIGHT].map(|near| sitter.scaled(near));
        let seat = sitter.on_seat(&laws.seated);
        let least = seat + ON_FEET * (sitter.sole(SEATED_PRESSURE) - seat);
        let mut missed: Vec<f64> = Vec::with_capacity(6 * motion.len());
        for (i, total) in totals(tree, &motion)?.iter().enumerate() {
            let u = motion.time()[i] / duration;
            let at = pressed(total);
            let from =
                if u < SEAT_OFF { (at - least).min(0.0) } else { at - sitter.sole(pressure.at(u).position) };
            let beyond: f64 = figure.limit_excess(motion.q(i)).iter().map(|excess| excess.by).sum();
            missed.extend([from / near, sitter.too_far(&laws.at(u).hips) / straight, beyond / NEAR_RANGE]);
        }
        let step = 1.0 / f64::from(SAMPLES);
        let of = |i: u32| {
            let At { hips, lean, .. } = laws.at((f64::from(i) - 1.5) * step);
            [lean / JERK[0], hips.along / sitter.scaled(JERK[1]), hips.height / sitter.scaled(JERK[2])]
        };
        let ways: Vec<[f64; 3]> = (0..SAMPLES + 4).map(of).collect();
        let cubed = step.powi(3);
        for four in ways.windows(4) {
            missed
                .extend((0..3).map(|k| (four[3][k] - 3.0 * (four[2][k] - four[1][k]) - four[0][k]) / cubed));
        }
        let each = f64::from(SAMPLES).sqrt();
        Ok(missed.into_iter().map(|missed| missed / each).collect())
    }
}
