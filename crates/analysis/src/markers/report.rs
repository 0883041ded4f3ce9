//! What inverse kinematics found, and how well the markers fit.

use super::blind::is_blind;
use super::chain::Frame;
use super::matched::Matched;
use super::options::IkError;
use super::problem::{Problem, Sight, Unknown};
use super::solve::Solver;
use super::swaps::Swap;
use super::unseen::Telling;
use crate::prepared::each;
use nalgebra::Vector3;
use solaris_dynamics::DynamicsError;

/// The positions of a figure that fit a trial of markers.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkerMotion {
    /// Positions, `nq` a frame (rad, m).
    pub q: Vec<f64>,
    /// Each frame's fit.
    pub frames: Vec<FrameFit>,
    /// Each used marker's fit, in the order of the figure's.
    pub markers: Vec<MarkerFit>,
    /// From each used marker of the figure to where it was seen (m, world axes), marker by marker in every frame; NaN where it was
    /// hidden.
    pub offsets: Vec<Vector3<f64>>,
    /// What the markers tell of each degree of freedom that is neither held nor follows another.
    pub dofs: Vec<DofSight>,
    /// Which markers the figure and the trial have in common, and which only one of them has.
    pub matched: Matched,
    /// Labels that were exchanged and are changed back.
    pub swaps: Vec<Swap>,
}

/// How well one frame fits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameFit {
    /// When (s).
    pub time: f64,
    /// The objective (m²).
    pub cost: f64,
    /// Root of the mean square of the distances, all markers alike (m); NaN of a frame without markers.
    pub rms: f64,
    /// The farthest marker, as an index in [`MarkerMotion::markers`], and its distance (m).
    pub worst: Option<(usize, f64)>,
    /// How many markers were seen.
    pub seen: usize,
    /// Steps of the solver.
    pub steps: usize,
    /// Whether the solver came to a minimum.
    pub converged: bool,
    /// How many degrees of freedom no marker tells of.
    pub blind: usize,
    /// Whether the markers tell where the root is.
    pub is_placed: bool,
}

/// How well one marker fits over all frames.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkerFit {
    /// Its name in the figure.
    pub name: String,
    /// Its weight.
    pub weight: f64,
    /// Root of the mean square of its distances (m); NaN if it was never seen.
    pub rms: f64,
    /// The greatest distance (m), and its frame.
    pub worst: Option<(f64, usize)>,
    /// In how many frames it was seen.
    pub seen: usize,
}

/// What the markers tell of a degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DofSight {
    /// Index in `v`.
    pub dof: usize,
    /// Its standard error in the median frame (rad or m), if the markers' errors are independent of each other and as large as
    /// those left over; infinite where nothing tells of it.
    pub spread: f64,
    /// In how many frames no marker tells of it.
    pub blind: usize,
}

impl MarkerMotion {
    /// Root of the mean square of all distances (m).
    pub fn rms(&self) -> f64 {
        rms(self.offsets.iter().map(Vector3::norm))
    }

    /// The mean of the frames' objectives (m²).
    pub fn mean_cost(&self) -> f64 {
        self.frames.iter().map(|frame| frame.cost).sum::<f64>() / self.frames.len() as f64
    }
}

pub(super) fn of(
    problem: &Problem,
    points: &[Vector3<f64>],
    solved: Vec<Frame>,
    telling: &Telling,
    swaps: Vec<Swap>,
) -> Result<MarkerMotion, IkError> {
    let Telling { levers, told } = telling;
    let offsets = each(
        0..solved.len(),
        || Solver::new(problem),
        |solver, row| {
            let (q, points) = (&solved[row].q, problem.row(points, row));
            let places = solver.places(q)?;
            let offset = |(sight, place): (&Sight, &Vector3<f64>)| points[sight.column] - place;
            Ok::<_, DynamicsError>(problem.sights.iter().zip(&places).map(offset).collect::<Vec<_>>())
        },
    )?;
    let norms = |row: &Vec<Vector3<f64>>| row.iter().map(Vector3::norm).collect();
    let distances: Vec<Vec<f64>> = offsets.iter().map(norms).collect();
    let frames = distances.iter().zip(&solved).zip(problem.trial.time());
    let frames = frames.zip(told).map(|(((distances, frame), time), told)| {
        let is_root = |u: usize| problem.unknowns[u].is_root;
        frame_fit(*time, distances, frame, told, is_root)
    });
    let frames = frames.collect();
    Ok(MarkerMotion {
        frames,
        markers: marker_fits(problem, &distances),
        dofs: dof_sights(problem, &distances, levers, told),
        offsets: offsets.concat(),
        q: solved.into_iter().flat_map(|frame| frame.q).collect(),
        matched: problem.matched.clone(),
        swaps,
    })
}

fn frame_fit(
    time: f64,
    distances: &[f64],
    frame: &Frame,
    told: &[bool],
    is_root: impl Fn(usize) -> bool,
) -> FrameFit {
    let seen = || distances.iter().copied().enumerate().filter(|(_, distance)| !distance.is_nan());
    FrameFit {
        time,
        cost: frame.solved.cost,
        rms: rms(distances.iter().copied()),
        worst: seen().max_by(|a, b| a.1.total_cmp(&b.1)),
        seen: seen().count(),
        steps: frame.solved.steps,
        converged: frame.solved.converged,
        blind: told.iter().filter(|told| !**told).count(),
        is_placed: told.iter().enumerate().all(|(u, told)| *told || !is_root(u)),
    }
}

fn marker_fits(problem: &Problem, distances: &[Vec<f64>]) -> Vec<MarkerFit> {
    let fit = |(i, sight): (usize, &Sight)| {
        let column = || distances.iter().map(|row| row[i]);
        let seen = || column().enumerate().filter(|(_, distance)| !distance.is_nan());
        MarkerFit {
            name: problem.markers[sight.marker].name.clone(),
            weight: sight.weight,
            rms: rms(column()),
            worst: seen().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(frame, distance)| (distance, frame)),
            seen: seen().count(),
        }
    };
    problem.sights.iter().enumerate().map(fit).collect()
}

fn dof_sights(
    problem: &Problem,
    distances: &[Vec<f64>],
    levers: &[Vec<f64>],
    told: &[Vec<bool>],
) -> Vec<DofSight> {
    let unknowns = problem.unknowns.len();
    let errors: Vec<f64> = distances.iter().map(|row| error(row, unknowns)).collect();
    let sight = |(u, unknown): (usize, &Unknown)| {
        let mut spreads: Vec<f64> =
            levers.iter().zip(&errors).map(|(levers, error)| spread(levers[u], *error)).collect();
        spreads.sort_by(f64::total_cmp);
        DofSight {
            dof: unknown.dof,
            spread: spreads[spreads.len() / 2],
            blind: told.iter().filter(|told| !told[u]).count(),
        }
    };
    problem.unknowns.iter().enumerate().map(sight).collect()
}

fn spread(lever: f64, error: f64) -> f64 {
    if is_blind(lever) { f64::INFINITY } else { lever * error }
}

/// The standard error of one coordinate of one marker (m), as what is left over tells: `Σ r² / (3·n − p)` with `p` unknowns.
fn error(distances: &[f64], unknowns: usize) -> f64 {
    let seen = distances.iter().filter(|distance| !distance.is_nan());
    let (squares, count) = seen.fold((0.0, 0_usize), |(sum, count), r| (sum + r * r, count + 1));
    (squares / (3 * count).saturating_sub(unknowns).max(1) as f64).sqrt()
}

/// Root of the mean square of what is a number.
fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) =
        values.filter(|x| !x.is_nan()).fold((0.0, 0_usize), |(sum, n), x| (sum + x * x, n + 1));
    (sum / count as f64).sqrt()
}
