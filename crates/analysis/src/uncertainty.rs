//! How far the positions and forces of a given motion may be off.
//!
//! Three things are known to be uncertain, and each is asked by itself: markers ([`crate::markers::position_errors`],
//! [`position_spread`]), the filter's cut-off ([`filter_spread`]), and what motion, masses and measured forces disagree by
//! ([`residual_spread`]). They are independent of each other, so that their squares add up ([`Uncertainty::of`]).

use crate::differentiate::Filter;
use crate::inverse::InverseError;
use crate::prepared::{PreparedMotion, each};
use nalgebra::{DMatrix, DVector};
use solaris_dynamics::{DynamicsError, mass_matrix};
use solaris_model::{ConfigurationError, Figure, Motion, MotionError};
use solaris_profiles::Butterworth;

/// By which factor a cut-off may as well be greater or smaller: 6 Hz may be 4.8 or 7.5 Hz.
pub const CUTOFF_FACTOR: f64 = 1.25;
/// Samples that are in memory at once.
const GROUP: usize = 8;

/// What makes a force uncertain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum ErrorSource {
    /// Where markers were seen, and where they sit on the figure.
    Markers,
    /// The cut-off of the filter.
    Filter,
    /// What motion, masses and measured forces disagree by.
    Residual,
}

/// Standard errors of a motion's positions and forces, in the order of its figure's degrees of freedom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spread {
    /// Of the positions, along the degrees of freedom (rad or m), `nv` a sample.
    pub positions: Vec<f64>,
    /// Of the generalized forces (N m or N), `nv` a sample.
    pub forces: Vec<f64>,
}

/// Why positions cannot be displaced.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpreadError {
    /// A sample of errors that is not the motion's.
    #[error(
        "sample {sample} of the positions' errors has {found} numbers, the motion needs {expected}: one a degree of freedom and frame"
    )]
    Length {
        /// Which of the samples.
        sample: usize,
        /// Its numbers.
        found: usize,
        /// What the motion needs.
        expected: usize,
    },
    /// An error that is no number, or leads beyond all numbers.
    #[error("at {time} s: {source}")]
    Displaced {
        /// When (s).
        time: f64,
        /// Why.
        source: ConfigurationError,
    },
    /// The motion is of another figure.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// What is computed from recorded positions.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The motion, of which everything is known.
    pub motion: Motion,
    /// Its generalized forces (N m or N), `nv` a sample.
    pub forces: Vec<f64>,
}

/// Standard errors by what they come from, and all together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uncertainty {
    /// All together.
    pub total: Spread,
    /// What each source does by itself.
    pub parts: Vec<(ErrorSource, Spread)>,
}

impl Uncertainty {
    /// Of these sources, which are independent of each other: their squares add up.
    pub fn of(parts: Vec<(ErrorSource, Spread)>) -> Self {
        let mut squares = Squares::default();
        for (_, part) in &parts {
            squares.add(part);
        }
        Self { total: squares.mean(1), parts }
    }
}

/// What `errors` of the positions (displacements along the degrees of freedom, `nv` a sample of the motion, each a sample of what
/// may be) do to what is asked of a recorded motion: the root of the mean square of what changes.
///
/// `ask` is given recorded positions and does everything anew that depends on them: filter, derivatives, forces.
///
/// # Errors
///
/// [`SpreadError`] for errors that are not the motion's, and what `ask` refuses.
pub fn position_spread<E: Send + From<SpreadError>>(
    figure: &Figure,
    recorded: &Motion,
    found: &Answer,
    errors: &[Vec<f64>],
    ask: impl Fn(&Motion) -> Result<Answer, E> + Sync + Send,
) -> Result<Spread, E> {
    let ask = |(): &mut (), sample: usize| {
        Ok::<_, E>(change(figure, found, &ask(&displaced(figure, recorded, errors, sample)?)?))
    };
    let mut squares = Squares::default();
    for start in (0..errors.len()).step_by(GROUP) {
        let group = start..errors.len().min(start + GROUP);
        each(group, || (), ask)?.iter().for_each(|change| squares.add(change));
    }
    Ok(squares.mean(errors.len()))
}

/// What the choice of the filter's cut-off does: the root of the mean square of what changes with a cut-off that is by
/// [`CUTOFF_FACTOR`] smaller and greater; of the greater one nothing is asked where that is no cut-off at the motion's rate.
///
/// # Errors
///
/// What `ask` refuses.
pub fn filter_spread<E: Send>(
    figure: &Figure,
    filter: Filter,
    found: &Answer,
    ask: impl Fn(Filter) -> Result<Answer, E> + Sync + Send,
) -> Result<Spread, E> {
    let most = Butterworth::rate_of(found.motion.time()).map_or(f64::INFINITY, |rate| rate / 2.0);
    let cutoffs = [filter.cutoff / CUTOFF_FACTOR, filter.cutoff * CUTOFF_FACTOR];
    let cutoffs: Vec<f64> = cutoffs.into_iter().filter(|cutoff| *cutoff < most).collect();
    let ask = |(): &mut (), i: usize| {
        Ok::<_, E>(change(figure, found, &ask(Filter { cutoff: cutoffs[i], ..filter })?))
    };
    let mut squares = Squares::default();
    each(0..cutoffs.len(), || (), ask)?.iter().for_each(|change| squares.add(change));
    Ok(squares.mean(cutoffs.len()))
}

/// By how much the forces change if the motion of the whole is what the residual comes from: if the root is accelerated by the
/// `δa₀ = M₀₀⁻¹·τ₀` that leaves none, joint `j` needs `M_j₀·δa₀` less.
///
/// Of all ways to change accelerations it is the one that asks least of them (Gauss: the least `Σ m·|δa|²`); plates are taken to
/// be right. Zero for a figure whose root something holds.
///
/// # Errors
///
/// A state that the kernel refuses.
pub fn residual_spread(prepared: &PreparedMotion<'_>, forces: &[f64]) -> Result<Spread, InverseError> {
    let (figure, nv) = (prepared.figure, prepared.tree.nv());
    let root = if figure.root_is_free() { figure.layout().joints()[0].nv } else { 0 };
    let rows = prepared.frames(|workspace, row| {
        let mut mass = DMatrix::zeros(nv, nv);
        let mut change = vec![0.0; nv];
        if root == 0 {
            return Ok(change);
        }
        mass_matrix(&prepared.tree, workspace, prepared.q(row), &mut mass)?;
        let left = DVector::from_column_slice(&forces[row * nv..][..root]);
        let columns = mass.columns(0, root);
        // A root without any mass to accelerate has no residual either.
        if let Some(acceleration) =
            columns.rows(0, root).into_owned().cholesky().map(|factors| factors.solve(&left))
        {
            change.copy_from_slice((columns * acceleration).as_slice());
            figure.fold_forces(prepared.q(row), &mut change);
        }
        Ok::<_, DynamicsError>(change.iter().map(|x| x.abs()).collect())
    })?;
    Ok(Spread { positions: vec![0.0; rows.len() * nv], forces: rows.concat() })
}

/// The recorded motion with its positions displaced by one sample of errors.
fn displaced(
    figure: &Figure,
    recorded: &Motion,
    errors: &[Vec<f64>],
    sample: usize,
) -> Result<Motion, SpreadError> {
    recorded.check_figure(figure)?;
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let (found, expected) = (errors[sample].len(), recorded.len() * nv);
    if found != expected {
        return Err(SpreadError::Length { sample, found, expected });
    }
    let [q, v, a] = recorded.columns();
    let mut moved = vec![0.0; q.len()];
    for (row, &time) in recorded.time().iter().enumerate() {
        figure
            .integrate(recorded.q(row), &errors[sample][row * nv..][..nv], &mut moved[row * nq..][..nq])
            .map_err(|source| SpreadError::Displaced { time, source })?;
    }
    let (info, time, known) = (recorded.info.clone(), recorded.time().to_vec(), recorded.known().clone());
    Ok(Motion::recorded(figure, info, time, [moved, v.to_vec(), a.to_vec()], known)?)
}

/// What is different in another answer.
fn change(figure: &Figure, found: &Answer, other: &Answer) -> Spread {
    let nv = figure.layout().nv();
    let mut positions = vec![0.0; found.motion.len() * nv];
    for row in 0..found.motion.len() {
        let to = &mut positions[row * nv..][..nv];
        if figure.difference(found.motion.q(row), other.motion.q(row), to).is_err() {
            to.fill(0.0);
        }
    }
    let forces = found.forces.iter().zip(&other.forces).map(|(a, b)| b - a).collect();
    Spread { positions, forces }
}

/// Sums of squares, entry by entry.
#[derive(Default)]
struct Squares(Spread);

impl Squares {
    fn add(&mut self, change: &Spread) {
        let Spread { positions, forces } = &mut self.0;
        for (sums, values) in [(positions, &change.positions), (forces, &change.forces)] {
            sums.resize(values.len(), 0.0);
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value * value);
        }
    }

    /// The roots of the means of so many.
    fn mean(self, count: usize) -> Spread {
        let roots = |sums: Vec<f64>| sums.into_iter().map(|sum| (sum / count.max(1) as f64).sqrt()).collect();
        Spread { positions: roots(self.0.positions), forces: roots(self.0.forces) }
    }
}
