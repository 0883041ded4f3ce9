//! What the markers' errors do to the positions that are found from them, by drawing such errors anew.

use super::options::{IkError, IkOptions};
use super::problem::Problem;
use super::report::MarkerMotion;
use super::solve::Solver;
use crate::prepared::each;
use crate::random::Random;
use nalgebra::{Cholesky, DMatrix, DVector, Matrix3, UnitQuaternion, Vector3};
use solaris_dynamics::DynamicsError;
use solaris_model::{Figure, Marker, MarkerTrial};

/// How far (rad or m) positions are off, at one standard deviation, before any marker is seen: what no marker tells of has no more.
const BEFORE: f64 = 0.5;
/// The least part of a marker's error that is taken to be left over.
const LEAST_LEFT: f64 = 1e-3;

/// Draws `samples` errors of the positions that were [`found`](super::inverse_kinematics) with the same figure, markers, trial and
/// options: displacements along the degrees of freedom (`nv` a frame), as [`Figure::integrate`] takes them.
///
/// What the markers leave over is all that is known of their errors: of noise, of skin that slides and of markers that sit elsewhere
/// than the figure has them, each with its own course in time. Each sample gives every marker the course of one that was left over,
/// in its link's frame, turned and mirrored at random and as a whole, and asks which positions would have been found with it, to
/// first order: `δq = (Σ w·Jᵀ·J)⁻¹·Σ w·Jᵀ·e`.
///
/// The positions follow the markers, so less is left over than the errors were: of one that alone decides where its link is, nothing.
/// With the leverage `h = w·tr(J·(Σ w·Jᵀ·J)⁻¹·Jᵀ)/3` of a marker its own course is drawn with probability `1 − h`, enlarged by
/// `1/√(1 − h)`, else that of another. This is the bootstrap of modified residuals (A. C. Davison, D. V. Hinkley, "Bootstrap Methods and
/// their Application", 1997, 6.2), with courses in place of numbers.
///
/// The same input gives the same samples, on any number of cores.
///
/// # Errors
///
/// Those of [`super::inverse_kinematics`].
///
/// # Panics
///
/// If `found` is of another trial or of other markers.
#[doc(alias = "bootstrap")]
#[doc(alias = "uncertainty")]
pub fn position_errors(
    figure: &Figure,
    markers: &[Marker],
    trial: &MarkerTrial,
    options: &IkOptions,
    found: &MarkerMotion,
    samples: usize,
) -> Result<Vec<Vec<f64>>, IkError> {
    let problem = Problem::new(figure, markers, trial, options)?;
    let (frames, width) = (trial.len(), problem.sights.len());
    assert!(found.offsets.len() == frames * width, "the motion was found from other markers");
    let gains = Gains { problem: &problem, found, prior: prior(found, problem.unknowns.len()) };
    let rows = each(0..frames, || Solver::new(&problem), |solver, frame| gains.left(solver, frame))?;
    let courses = Courses::of(&rows, width);
    let draws: Vec<Vec<Draw>> = (0..samples as u64).map(|seed| courses.draw(seed)).collect();
    let moved = each(
        0..frames,
        || Solver::new(&problem),
        |solver, frame| gains.displacements(solver, frame, &courses, &draws),
    )?;
    let nv = figure.layout().nv();
    let mut errors = vec![Vec::with_capacity(frames * nv); samples];
    for row in &moved {
        for (sample, error) in errors.iter_mut().enumerate() {
            error.extend(&row[sample * nv..][..nv]);
        }
    }
    Ok(errors)
}

/// What is added to the diagonal of the information so that what no marker tells of stays where it is: the square of the markers'
/// error over that of [`BEFORE`], a marker.
fn prior(found: &MarkerMotion, unknowns: usize) -> f64 {
    let seen = found.offsets.iter().filter(|offset| !offset.x.is_nan());
    let (squares, count) = seen.fold((0.0, 0_usize), |(sum, n), offset| (sum + offset.norm_squared(), n + 1));
    let told = (3 * count).saturating_sub(unknowns * found.frames.len()).max(1);
    let a_frame = count as f64 / found.frames.len() as f64;
    squares / told as f64 / (BEFORE * BEFORE) / a_frame.max(1.0)
}

/// What one frame leaves over.
struct Left {
    /// Of each marker, in its link's frame (m); NaN where it was hidden.
    offset: Vec<Vector3<f64>>,
    /// Of each marker.
    leverage: Vec<f64>,
}

/// How positions answer to errors, frame by frame.
struct Gains<'p> {
    problem: &'p Problem<'p>,
    found: &'p MarkerMotion,
    prior: f64,
}

/// One frame, linear in the markers' errors.
struct Linear {
    /// Of each marker its weight over the sum of all that are seen; 0 where it is hidden.
    shares: Vec<f64>,
    /// Of each marker its derivatives by the unknowns, 3 rows a marker, times its share; zero for unknowns that a bound holds.
    pulls: DMatrix<f64>,
    information: Cholesky<f64, nalgebra::Dyn>,
    /// How each marker's link is turned.
    turned: Vec<Matrix3<f64>>,
}

impl Gains<'_> {
    fn offsets(&self, frame: usize) -> &[Vector3<f64>] {
        let width = self.problem.sights.len();
        &self.found.offsets[frame * width..][..width]
    }

    fn linear(&self, solver: &mut Solver, frame: usize) -> Result<Option<Linear>, DynamicsError> {
        let (problem, offsets) = (self.problem, self.offsets(frame));
        let nq = problem.figure.layout().nq();
        let q = &self.found.q[frame * nq..][..nq];
        let poses = solver.poses(q)?;
        let n = problem.unknowns.len();
        let is_stuck = |unknown: &super::problem::Unknown| {
            let at_bound = unknown.coordinate.zip(unknown.bounds);
            at_bound.is_some_and(|(at, (lower, upper))| q[at] <= lower || q[at] >= upper)
        };
        let stuck: Vec<bool> = problem.unknowns.iter().map(is_stuck).collect();
        let mut shares: Vec<f64> = problem.sights.iter().map(|sight| sight.weight).collect();
        for (share, offset) in shares.iter_mut().zip(offsets) {
            if offset.x.is_nan() {
                *share = 0.0;
            }
        }
        let weights: f64 = shares.iter().sum();
        for share in &mut shares {
            *share /= weights.max(f64::MIN_POSITIVE);
        }
        let mut information = DMatrix::zeros(n, n);
        let mut pulls = DMatrix::zeros(3 * problem.sights.len(), n);
        for (i, (sight, &share)) in
            problem.sights.iter().zip(&shares).enumerate().filter(|(_, (_, share))| **share > 0.0)
        {
            let mut columns = DMatrix::<f64>::zeros(3, n);
            solver.columns(q, sight, |unknown, column| {
                if !stuck[unknown] {
                    let mut own = columns.column_mut(unknown);
                    own += column;
                }
            });
            information.gemm_tr(share, &columns, &columns, 1.0);
            pulls.rows_mut(3 * i, 3).copy_from(&(columns * share));
        }
        for (u, unknown) in problem.unknowns.iter().enumerate() {
            let drawn = unknown.task.map_or(0.0, |(_, weight)| weight);
            information[(u, u)] += drawn + self.prior + f64::from(u8::from(stuck[u]));
        }
        let turned = problem.sights.iter().map(|sight| poses[problem.markers[sight.marker].link].rotation);
        let turned = turned.collect();
        Ok(Cholesky::new(information).map(|information| Linear { shares, pulls, information, turned }))
    }

    /// What this frame leaves over, and each marker's leverage.
    fn left(&self, solver: &mut Solver, frame: usize) -> Result<Left, DynamicsError> {
        let offsets = self.offsets(frame);
        let Some(Linear { pulls, shares, information, turned }) = self.linear(solver, frame)? else {
            let nothing = vec![Vector3::repeat(f64::NAN); offsets.len()];
            return Ok(Left { leverage: vec![0.0; nothing.len()], offset: nothing });
        };
        let answered = information.solve(&pulls.transpose());
        let leverage = shares.iter().enumerate().map(|(i, share)| {
            let trace: f64 =
                (3 * i..3 * i + 3).map(|row| pulls.row(row).transpose().dot(&answered.column(row))).sum();
            // Both factors hold the share.
            if *share > 0.0 { trace / share / 3.0 } else { 0.0 }
        });
        let leverage = leverage.collect();
        let offset = offsets.iter().zip(&turned).map(|(offset, turned)| turned.tr_mul(offset)).collect();
        Ok(Left { offset, leverage })
    }

    /// What each draw does to this frame's positions, one after the other, `nv` each.
    fn displacements(
        &self,
        solver: &mut Solver,
        frame: usize,
        courses: &Courses,
        draws: &[Vec<Draw>],
    ) -> Result<Vec<f64>, DynamicsError> {
        let problem = self.problem;
        let nv = problem.figure.layout().nv();
        let mut moved = vec![0.0; draws.len() * nv];
        let Some(Linear { pulls, information, turned, .. }) = self.linear(solver, frame)? else {
            return Ok(moved);
        };
        for (draw, moved) in draws.iter().zip(moved.chunks_exact_mut(nv.max(1))) {
            let mut errors = DVector::zeros(pulls.nrows());
            for (i, Draw { course, turn }) in draw.iter().enumerate() {
                let error = turned[i] * (turn * courses.at(frame, *course));
                errors.fixed_rows_mut::<3>(3 * i).copy_from(&error);
            }
            let step = information.solve(&pulls.tr_mul(&errors));
            for (unknown, step) in problem.unknowns.iter().zip(&step) {
                moved[unknown.dof] = *step;
            }
        }
        Ok(moved)
    }
}

/// What markers leave over in the course of a trial.
struct Courses {
    /// How many markers there are.
    width: usize,
    /// Marker by marker in every frame (m, the link's frame), enlarged by what the positions took away; where a marker was hidden,
    /// straight between what was there before and after.
    offsets: Vec<Vector3<f64>>,
    /// Of each marker the part of its errors that is left over; 0 of one that was never seen.
    left: Vec<f64>,
}

/// The error of a marker in one sample.
struct Draw {
    /// Whose course it has.
    course: usize,
    /// How that is turned and mirrored.
    turn: Matrix3<f64>,
}

impl Courses {
    fn of(rows: &[Left], width: usize) -> Self {
        let mut courses =
            Self { width, offsets: vec![Vector3::zeros(); rows.len() * width], left: Vec::new() };
        for marker in 0..width {
            let seen: Vec<usize> =
                (0..rows.len()).filter(|row| !rows[*row].offset[marker].x.is_nan()).collect();
            let leverage: f64 =
                seen.iter().map(|row| rows[*row].leverage[marker]).sum::<f64>() / seen.len().max(1) as f64;
            let left = (1.0 - leverage).clamp(LEAST_LEFT, 1.0);
            courses.left.push(if seen.is_empty() { 0.0 } else { left });
            let at = |row: usize| rows[row].offset[marker] / left.sqrt();
            for row in 0..rows.len() {
                let after = seen.partition_point(|seen| *seen < row);
                let value = match (after.checked_sub(1).map(|i| seen[i]), seen.get(after)) {
                    (_, Some(&same)) if same == row => at(row),
                    (Some(before), Some(&after)) => {
                        let s = (row - before) as f64 / (after - before) as f64;
                        at(before) * (1.0 - s) + at(after) * s
                    }
                    (Some(end), None) => at(end),
                    (None, Some(&begin)) => at(begin),
                    (None, None) => Vector3::zeros(),
                };
                courses.offsets[row * width + marker] = value;
            }
        }
        courses
    }

    fn at(&self, frame: usize, marker: usize) -> Vector3<f64> {
        self.offsets[frame * self.width + marker]
    }

    /// One error for every marker.
    fn draw(&self, seed: u64) -> Vec<Draw> {
        let mut random = Random(seed);
        let all: f64 = self.left.iter().sum();
        let one = |marker: usize| {
            let own = random.next() < self.left[marker];
            let course = if own { marker } else { self.other(random.next() * all) };
            Draw { course, turn: turn(&mut random) }
        };
        (0..self.width).map(one).collect()
    }

    /// The marker at which the parts that are left over add up to this.
    fn other(&self, mut part: f64) -> usize {
        for (marker, left) in self.left.iter().enumerate() {
            part -= left;
            if part < 0.0 {
                return marker;
            }
        }
        self.width - 1
    }
}

/// A rotation, uniform over all of them (K. Shoemake, "Uniform random rotations", Graphics Gems III, 1992), or its mirror image.
fn turn(random: &mut Random) -> Matrix3<f64> {
    let [u, a, b] = [(); 3].map(|()| random.next());
    let ((sa, ca), (sb, cb)) = ((a * std::f64::consts::TAU).sin_cos(), (b * std::f64::consts::TAU).sin_cos());
    let (one, two) = ((1.0 - u).sqrt(), u.sqrt());
    let quaternion = nalgebra::Quaternion::new(one * sa, one * ca, two * sb, two * cb);
    let turn = UnitQuaternion::new_normalize(quaternion).to_rotation_matrix().into_inner();
    if random.next() < 0.5 { -turn } else { turn }
}
