//! From where markers were seen to the positions of a figure.
//!
//! [`inverse_kinematics`] finds, frame by frame, the positions in which a figure's markers come nearest to where cameras saw
//! them:
//!
//! ```text
//! J(q) = ½·Σ wᵢ·|xᵢ(q) − mᵢ|² / Σ wᵢ + ½·Σ w_c·(q_c − q_c*)²
//! ```
//!
//! over the markers that the frame has, with `q` within its bounds. It is the objective of OpenSim's tool of that name; what is
//! found here is its minimum to rounding.

mod blind;
mod chain;
mod errors;
mod fit;
mod matched;
mod measure;
mod options;
mod place;
mod problem;
mod report;
mod solve;
mod start;
mod swaps;
mod unseen;

pub use errors::position_errors;
pub use fit::{FitError, FitOptions, SegmentFit, SubjectFit, fit_subject};
pub use matched::Matched;
pub use measure::{MeasureError, MeasuredFactor, PairRatio, measured_factor};
pub use options::{CoordinateTask, IkError, IkOptions};
pub use place::{place_markers, places};
pub use report::{DofSight, FrameFit, MarkerFit, MarkerMotion};
pub use swaps::Swap;

use problem::Problem;
use solaris_model::{Figure, Marker, MarkerTrial};

/// Finds the positions in which a figure's `markers` come nearest to where a `trial` saw them, in every frame.
///
/// Frames are solved in chains of a fixed length, each frame from the one before it, so the result does not depend on how many
/// cores there are. What a frame lacks is left out of its sum. Degrees of freedom that no marker tells of stay at rest; those that
/// some frames do not tell of are led from where they were seen last to where they are seen next (see [`MarkerMotion::dofs`]). The trial's points are in the
/// axes of the figure's world (m).
///
/// # Errors
///
/// [`IkError`] where no marker of the figure is in the trial, where options name what is not there or are no numbers, and for a
/// figure that cannot be computed with.
///
/// # Examples
///
/// A rod with a marker on its tip, seen a quarter turn from where it rests:
///
/// ```
/// use solaris_analysis::markers::{IkOptions, inverse_kinematics};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Marker, MarkerTrial, Vector3};
///
/// let rod = LinkSpec::root("rod", Joint::new("pivot").rz()).mass(1.0);
/// let figure = FigureBuilder::new("lever").link(rod).build()?;
/// let tip = Marker { name: "tip".into(), link: 0, position: Vector3::x(), is_fixed: false };
/// let trial = MarkerTrial::new(vec!["tip".into()], vec![0.0], vec![Vector3::new(0.0, 1.02, 0.0)])?;
/// let found = inverse_kinematics(&figure, &[tip], &trial, &IkOptions::default())?;
/// assert!((found.q[0] - std::f64::consts::FRAC_PI_2).abs() < 1e-9);
/// assert!((found.frames[0].rms - 0.02).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "InverseKinematicsTool")]
#[doc(alias = "motion capture")]
pub fn inverse_kinematics(
    figure: &Figure,
    markers: &[Marker],
    trial: &MarkerTrial,
    options: &IkOptions,
) -> Result<MarkerMotion, IkError> {
    let problem = Problem::new(figure, markers, trial, options)?;
    let mut points = (0..trial.len()).flat_map(|frame| trial.frame(frame)).copied().collect::<Vec<_>>();
    let mut solved = chain::solve(&problem, &points)?;
    let swaps =
        if options.keep_labels { Vec::new() } else { swaps::mend(&problem, &mut points, &mut solved)? };
    let telling = unseen::fill(&problem, &points, &mut solved)?;
    report::of(&problem, &points, solved, &telling, swaps)
}
