//! How far angles and moments may be off: bands around them, and what they come from.

use crate::error::CliError;
use crate::given::Given;
use crate::words::{row, short};
use serde::Serialize;
use solaris::analysis::ground::{GroundOptions, PlacedFeet, Sole, Split, Stances, ground_forces};
use solaris::analysis::{
    Answer, CUTOFF_FACTOR, ErrorSource, Filter, InverseOptions, InverseReport, Loads, PreparedMotion,
    SpreadError, Uncertainty, differentiate, filter_spread, inverse_motion, medium_forces, position_spread,
    residual_spread,
};
use solaris::model::{AxisKind, Motion};
use std::io::{Result as Written, Write};

/// How often errors of the markers are drawn: a standard error is known to one part in eight.
const SAMPLES: usize = 32;
/// So many standard errors hold 95 of 100 errors.
const TWO: f64 = 2.0;

/// What the forces of a motion are found from, besides the motion.
pub(super) struct Outside<'a> {
    /// What was measured, where there is something.
    pub(super) measured: Option<&'a Loads>,
    /// Where the ground's forces are found from the motion: its feet, when they stand, and how it is shared.
    pub(super) ground: Option<(&'a [Sole], &'a Stances, Split)>,
    pub(super) passive: bool,
}

/// Standard errors of a motion and its forces.
pub(super) struct Bands {
    pub(super) found: Uncertainty,
    pub(super) report: BandsReport,
}

/// How far moments may be off, by degree of freedom.
#[derive(Clone, Debug, Serialize)]
pub(super) struct BandsReport {
    /// How often errors of the markers were drawn; 0 where there are no markers.
    samples: usize,
    joints: Vec<DofBand>,
    /// What every moment has part in: root of the mean square over joints and time (N m).
    sources: Vec<SourceBand>,
}

/// The standard errors of one degree of freedom: roots of the mean squares over time.
#[derive(Clone, Debug, Serialize)]
pub(super) struct DofBand {
    dof: String,
    /// Of its position (rad or m); of ball and free joints along the axis.
    position_se_rms: f64,
    /// Of its force (N m or N).
    pub(super) force_se_rms: f64,
}

#[derive(Clone, Debug, Serialize)]
struct SourceBand {
    source: ErrorSource,
    moment_se_rms_nm: f64,
}

impl Bands {
    /// Of a motion whose forces are found.
    pub(super) fn of(given: &Given, outside: &Outside<'_>, forces: &InverseReport) -> Result<Self, CliError> {
        let figure = &given.body.figure;
        let recorded = &given.recorded.motion;
        let input = |error: &dyn ToString| CliError::input(&given.from, error);
        let ask = |motion: &Motion, filter: Option<Filter>| ask(given, outside, motion, filter);
        let found = Answer { motion: given.motion().clone(), forces: forces.tau.clone() };
        let mut parts = Vec::new();
        if let Some(fitted) = &given.fitted {
            let errors = fitted.errors(figure, SAMPLES).map_err(|error| input(&error))?;
            let spread =
                position_spread(figure, recorded, &found, &errors, |motion| ask(motion, given.filter))?;
            parts.push((ErrorSource::Markers, spread));
        }
        if let Some(filter) = given.filter {
            let spread = filter_spread(figure, filter, &found, |filter| ask(recorded, Some(filter)))?;
            parts.push((ErrorSource::Filter, spread));
        }
        if outside.measured.is_some() && figure.root_is_free() {
            let spread = residual_spread(&given.prepared()?, &forces.tau).map_err(|error| input(&error))?;
            parts.push((ErrorSource::Residual, spread));
        }
        let found = Uncertainty::of(parts);
        let report = BandsReport::of(&found, given, forces);
        Ok(Self { found, report })
    }

    /// Half widths of two standard errors around positions and forces.
    pub(super) fn half_widths(&self) -> [Vec<f64>; 2] {
        let total = &self.found.total;
        [&total.positions, &total.forces].map(|errors| errors.iter().map(|error| TWO * error).collect())
    }
}

/// The forces of recorded positions, with all that depends on them found anew; when feet stand stays.
fn ask(
    given: &Given,
    outside: &Outside<'_>,
    recorded: &Motion,
    filter: Option<Filter>,
) -> Result<Answer, CliError> {
    let (figure, medium) = (&given.body.figure, &given.body.medium);
    let input = |error: &dyn ToString| CliError::input(&given.from, error);
    let motion = differentiate(figure, recorded, filter).map_err(|error| input(&error))?.motion;
    let prepared = PreparedMotion::new(figure, &motion).map_err(|error| input(&error))?;
    let mut loads = outside.measured.cloned().unwrap_or_default();
    if let Some((soles, stances, split)) = outside.ground {
        let feet = PlacedFeet::new(&prepared, soles).map_err(|error| input(&error))?;
        let options = GroundOptions { split, stances: Some(stances.clone()), ..GroundOptions::default() };
        loads = loads.and(ground_forces(&feet, &options).map_err(|error| input(&error))?.loads());
    }
    if outside.passive && !medium.is_empty() {
        loads = loads.and(medium_forces(&prepared, medium).map_err(|error| input(&error))?);
    }
    let options = InverseOptions { passive: outside.passive, progress: None };
    let forces = inverse_motion(&prepared, &loads, options).map_err(|error| input(&error))?.tau;
    Ok(Answer { motion, forces })
}

impl From<SpreadError> for CliError {
    fn from(error: SpreadError) -> Self {
        Self::other(error)
    }
}

impl BandsReport {
    fn of(found: &Uncertainty, given: &Given, forces: &InverseReport) -> Self {
        let (figure, nv) = (&given.body.figure, forces.dofs.len());
        let free: Vec<usize> = (0..nv).filter(|&dof| !figure.follows(dof)).collect();
        let rms = |values: &[f64], dof: usize| {
            let squares: f64 = values.iter().skip(dof).step_by(nv).map(|x| x * x).sum();
            (squares * nv as f64 / values.len().max(1) as f64).sqrt()
        };
        let joints = free.iter().map(|&dof| DofBand {
            dof: forces.dofs[dof].dof.clone(),
            position_se_rms: rms(&found.total.positions, dof),
            force_se_rms: rms(&found.total.forces, dof),
        });
        let turns = |dof: &&usize| {
            figure.layout().axis_kind(**dof) == AxisKind::Rotation && !forces.dofs[**dof].is_residual
        };
        let turning: Vec<usize> = free.iter().filter(turns).copied().collect();
        let sources = found.parts.iter().map(|(source, part)| {
            let squares: f64 = turning.iter().map(|&dof| rms(&part.forces, dof).powi(2)).sum();
            let moment_se_rms_nm = (squares / turning.len().max(1) as f64).sqrt();
            SourceBand { source: *source, moment_se_rms_nm }
        });
        let has = |source| found.parts.iter().any(|(known, _)| *known == source);
        Self {
            samples: if has(ErrorSource::Markers) { SAMPLES } else { 0 },
            joints: joints.collect(),
            sources: sources.collect(),
        }
    }

    /// The band of a degree of freedom: two standard errors of its force (N m or N).
    pub(super) fn half_width(&self, dof: &str) -> Option<f64> {
        self.joints.iter().find(|joint| joint.dof == dof).map(|joint| TWO * joint.force_se_rms)
    }

    /// What the bands hold, a sentence.
    pub(super) fn words(&self) -> String {
        let part = |SourceBand { source, moment_se_rms_nm }: &SourceBand| {
            let what = match source {
                ErrorSource::Markers => {
                    format!("what the markers leave over ({} samples)", self.samples)
                }
                ErrorSource::Filter => format!(
                    "a cut-off {} % lower or {} % higher",
                    short((1.0 - 1.0 / CUTOFF_FACTOR) * 100.0),
                    short((CUTOFF_FACTOR - 1.0) * 100.0)
                ),
                ErrorSource::Residual => "the residual".to_owned(),
            };
            format!("±{} N m by {what}", short(TWO * moment_se_rms_nm))
        };
        if self.sources.is_empty() {
            return "nothing is known of errors: there are no markers, no filter and no measured forces"
                .to_owned();
        }
        let parts: Vec<String> = self.sources.iter().map(part).collect();
        format!("two standard errors; of all moments, rms: {}", parts.join(", "))
    }

    pub(super) fn write(&self, out: &mut dyn Write) -> Written<()> {
        row(out, "bands", &self.words())
    }
}
