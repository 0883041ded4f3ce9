//! A person's segment lengths and marker places, found together with the motion.
//!
//! Of all frames `f` and markers `i`, with `s` the factors of the links' axes and `d` how far each marker is off its place on the
//! link (before it was put there), the smallest
//!
//! ```text
//! Σ_f Σ_i |x_i(q_f, s, d_i) − m_fi|² / (2σ²)  +  Σ_i (ν+3)/2·ln(1 + |d_i|²/(ν·σ_d²))  +  ½·(ln s)ᵀ·C⁻¹·ln s
//! ```
//!
//! with ν = 2: most markers sit near their place, and some anywhere.
//!
//! Each frame's pose is solved for given lengths; the lengths then take a Gauss-Newton step with the poses eliminated (their
//! Schur complement), which is the projection of G. H. Golub and V. Pereyra (1973) without its second term. `C` says that people
//! differ in size, that segments differ from the whole, and that a segment's axes differ from each other. The inverse of the
//! matrix at the end is the covariance of the result.

mod normal;
mod unknowns;

use super::options::{IkError, IkOptions};
use super::problem::Problem;
use super::solve::Solver;
use super::start;
use nalgebra::{DVector, Vector3};
use normal::Normal;
use solaris_model::{Figure, Marker, MarkerTrial, ScaleError};
use unknowns::Unknowns;

/// What a fit takes for granted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// How far a marker is seen from where it should be, once everything fits (m): skin, cameras, a model that is none.
    pub noise: f64,
    /// How far a marker sits from where the model has it (m); a fixed one a quarter of that.
    pub placing: f64,
    /// How much people's sizes differ from the model's (1 is as large again, in logarithms).
    pub size: f64,
    /// How much a segment differs from the whole person's size.
    pub segment: f64,
    /// How much the breadth and depth of a segment differ from its length.
    pub axis: f64,
    /// How many frames are looked at, evenly chosen out of all trials.
    pub frames: usize,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { noise: 0.01, placing: 0.02, size: 0.2, segment: 0.06, axis: 0.04, frames: 40 }
    }
}

/// The lengths and markers of a person.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectFit {
    /// Factors of the links' axes, for [`Figure::stretched`].
    pub factors: Vec<Vector3<f64>>,
    /// The markers on the figure that these factors make.
    pub markers: Vec<Marker>,
    /// How long the segments are.
    pub lengths: Vec<SegmentFit>,
    /// How far each marker was moved on its link (m), in the order of the figure's markers that the trials have.
    pub moved: Vec<(String, f64)>,
    /// Root mean square distance of all markers before (m): the figure as it was, in its best poses.
    pub rms_before: f64,
    /// The same after (m).
    pub rms: f64,
    /// How many frames were looked at.
    pub frames: usize,
    /// Steps of the fit.
    pub steps: usize,
}

/// The length of a segment: from a link's joint to the farthest joint of its children.
#[derive(Clone, Debug, PartialEq)]
pub struct SegmentFit {
    /// The link.
    pub link: String,
    /// Its length before (m).
    pub before: f64,
    /// Its length (m).
    pub length: f64,
    /// The length's standard error (m).
    pub error: f64,
}

/// Why a person cannot be found in trials.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// The poses cannot be found.
    #[error(transparent)]
    Pose(#[from] IkError),
    /// The figure cannot be stretched.
    #[error(transparent)]
    Scale(#[from] ScaleError),
    /// Nothing to look at.
    #[error("there is no trial; give at least one")]
    NoTrials,
    /// An option that is no number above zero.
    #[error("the {name} of a fit is {value}; give a number above 0")]
    Option {
        /// Which.
        name: &'static str,
        /// What it is.
        value: f64,
    },
}

const MOST_STEPS: usize = 30;
/// Lengths that change by less than this part, and markers by less than this (m), are found.
const DONE: f64 = 1e-6;
/// Frames of one trial are alike: their errors are those of the skin and the model, which stay. So many count as independent.
const INDEPENDENT: f64 = 4.0;

/// Finds the lengths of a figure's segments and the places of its markers that fit `trials` of one person.
///
/// Left and right limbs of the same name are scaled alike. `ik` says what to weigh and hold; markers without weight are scaled
/// with their links and stay.
///
/// # Errors
///
/// [`FitError`]: those of [`super::inverse_kinematics`], and lengths beyond all reason.
#[doc(alias = "AddBiomechanics")]
#[doc(alias = "scale")]
pub fn fit_subject(
    figure: &Figure,
    markers: &[Marker],
    trials: &[MarkerTrial],
    ik: &IkOptions,
    options: &FitOptions,
) -> Result<SubjectFit, FitError> {
    check(options)?;
    if trials.is_empty() {
        return Err(FitError::NoTrials);
    }
    let task = Task {
        figure,
        markers,
        trials: relabelled(figure, markers, trials, ik)?,
        chosen: chosen(trials, options.frames),
        ik,
        unknowns: Unknowns::of(figure, markers, options),
        noise: options.noise,
    };
    let mut state = task.unknowns.start();
    let mut here = Normal::of(&task, &state, &[])?;
    let (rms_before, mut steps) = (here.rms, 0);
    while let Some((next, there)) = lower(&task, &state, &here)? {
        (state, here) = (next, there);
        steps += 1;
        if steps == MOST_STEPS {
            break;
        }
    }
    let unknowns = &task.unknowns;
    Ok(SubjectFit {
        factors: unknowns.factors(&state),
        lengths: unknowns.lengths(figure, &state, &here.covariance()),
        moved: unknowns.moved(markers, &state),
        markers: unknowns.apply(figure, markers, &state)?.1,
        rms_before,
        rms: here.rms,
        frames: task.chosen.len(),
        steps,
    })
}

/// What is fitted to what.
struct Task<'a> {
    figure: &'a Figure,
    markers: &'a [Marker],
    trials: Vec<MarkerTrial>,
    /// Trial and frame of those that are looked at.
    chosen: Vec<(usize, usize)>,
    ik: &'a IkOptions,
    unknowns: Unknowns,
    noise: f64,
}

/// The state that the Gauss-Newton step leads to, or the first of its halves that lowers the objective; `None` where what is left
/// of it is nothing.
fn lower(
    task: &Task,
    state: &DVector<f64>,
    here: &Normal,
) -> Result<Option<(DVector<f64>, Normal)>, FitError> {
    let mut step = here.step();
    while step.amax() > DONE {
        let next = state + &step;
        match Normal::of(task, &next, &here.poses) {
            Ok(there) if there.cost < here.cost => return Ok(Some((next, there))),
            // Lengths beyond all reason are too far, as well.
            Ok(_) | Err(FitError::Scale(_)) => step *= 0.5,
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

fn check(options: &FitOptions) -> Result<(), FitError> {
    let FitOptions { noise, placing, size, segment, axis, frames } = *options;
    let all = [("noise", noise), ("placing", placing), ("size", size), ("segment", segment), ("axis", axis)];
    let bad = all.into_iter().chain([("number of frames", frames as f64)]);
    match bad.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
        Some((name, value)) => Err(FitError::Option { name, value }),
        None => Ok(()),
    }
}

/// The trials with exchanged labels changed back, as far as the figure tells before it fits.
fn relabelled(
    figure: &Figure,
    markers: &[Marker],
    trials: &[MarkerTrial],
    ik: &IkOptions,
) -> Result<Vec<MarkerTrial>, FitError> {
    let mended = |trial: &MarkerTrial| {
        let mut trial = trial.clone();
        if !ik.keep_labels {
            for swap in super::inverse_kinematics(figure, markers, &trial, ik)?.swaps {
                let [a, b] = swap.names.each_ref().map(|name| trial.marker(name));
                if let (Some(a), Some(b)) = (a, b) {
                    trial.exchange([a, b], swap.first..=swap.last);
                }
            }
        }
        Ok(trial)
    };
    trials.iter().map(mended).collect()
}

/// Trial and frame of the frames that are looked at: as many of each trial as of the others, evenly chosen.
fn chosen(trials: &[MarkerTrial], frames: usize) -> Vec<(usize, usize)> {
    let share = (frames / trials.len().max(1)).max(1);
    let of = trials.iter().enumerate().flat_map(|(i, trial)| {
        let (len, count) = (trial.len(), share.min(trial.len()));
        (0..count).map(move |k| (i, (2 * k + 1) * len / (2 * count)))
    });
    of.collect()
}

/// The pose of a frame: from the one before, or from rest.
fn pose(problem: &Problem, frame: usize, known: Option<&Vec<f64>>) -> Result<Vec<f64>, IkError> {
    let mut solver = Solver::new(problem);
    let points = problem.trial.frame(frame);
    let mut q = known.cloned().unwrap_or_else(|| problem.rest.clone());
    if known.is_some() {
        solver.solve(&mut q, points, |_| true)?;
    } else {
        start::solve(&mut solver, &mut q, points)?;
    }
    Ok(q)
}
