//! Motions that are markers: read, and brought to positions of a figure.

mod report;
mod turned;

pub(crate) use report::MarkersReport;

use crate::args::{MarkerArgs, Span};
use crate::error::CliError;
use crate::input::{self, Body};
use crate::plausible;
use crate::recording;
use solaris::analysis::markers::{CoordinateTask, IkError, IkOptions, MarkerMotion, position_errors};
use solaris::files::{MarkerFit, fit_markers};
use solaris::io::markers::Recording;
use solaris::io::opensim::{self, IkSetup, MarkerTask, TaskValue};
use solaris::model::{Figure, Finding, FindingKind, Marker, Motion};
use std::path::Path;

/// A trial of markers, and the positions that fit it.
pub(crate) struct Fitted {
    pub(crate) recording: Recording,
    /// Positions alone; nothing else is known yet.
    pub(crate) motion: Motion,
    pub(crate) found: MarkerMotion,
    /// The figure's markers, and how they were asked to be fitted.
    markers: Vec<Marker>,
    options: IkOptions,
    /// What the setup file says and has no effect.
    pub(crate) findings: Vec<Finding>,
    /// That the figure lies on its side or stands on its head.
    turned: Option<plausible::Finding>,
}

/// Finds the positions of a figure that fit the markers in a file.
pub(crate) fn fit(
    body: &Body,
    path: &Path,
    args: &MarkerArgs,
    part: Option<&Span>,
) -> Result<Fitted, CliError> {
    let mut read = recording::in_world(path, body.gravity, args.unit, args.axes)?;
    let recording = &mut read.recording;
    let (options, setup) = asked(body, args)?;
    if let Some((from, to)) = setup.as_ref().and_then(|setup| setup.time_range) {
        recording.markers = recording.markers.within(from, to);
    }
    if let Some(span) = part {
        span.check(recording.markers.time())?;
        recording.markers = recording.markers.within(span.from, span.to);
    }
    let fitted = fit_markers(path, body, read.recording.clone(), options)?;
    let MarkerFit { recording, motion, found, markers, options, findings: cut } = fitted;
    let findings = setup.map_or_else(Vec::new, |setup| setup.findings).into_iter().chain(cut).collect();
    let turned = turned::turned(body, [&body.rest(), &found.q], &read, args.axes.is_some())?;
    Ok(Fitted { recording, motion, found, markers, options, findings, turned })
}

impl Fitted {
    /// Errors of the positions, drawn so many times.
    pub(crate) fn errors(&self, figure: &Figure, samples: usize) -> Result<Vec<Vec<f64>>, IkError> {
        let Self { recording, found, markers, options, .. } = self;
        position_errors(figure, markers, &recording.markers, options, found, samples)
    }
}

/// What the options and the setup file that they name ask of the markers; the setup, where there is one.
pub(crate) fn asked(body: &Body, args: &MarkerArgs) -> Result<(IkOptions, Option<IkSetup>), CliError> {
    let Some(path) = args.ik_setup.as_deref() else { return Ok((options(body, None, args)?, None)) };
    let setup = setup(path)?;
    let tasks = Some((&*setup.markers, &*setup.coordinates, path));
    Ok((options(body, tasks, args)?, Some(setup)))
}

/// Reads a setup of OpenSim's tool.
fn setup(path: &Path) -> Result<IkSetup, CliError> {
    let text = input::decoded(path)?;
    let mut setup = opensim::ik_setup(&text).map_err(|faults| input::faulty(path, &text, faults))?;
    leave_out_files(&mut setup.coordinates, &mut setup.findings);
    Ok(setup)
}

/// Leaves out tasks whose values are in a file, and says so.
pub(crate) fn leave_out_files(tasks: &mut Vec<opensim::CoordinateTask>, findings: &mut Vec<Finding>) {
    tasks.retain(|task| {
        let is_in_file = task.value == TaskValue::FromFile;
        if is_in_file {
            findings.push(Finding {
                kind: FindingKind::Missing,
                subject: task.name.clone(),
                message: "values from a file are not read: nothing draws this coordinate".to_owned(),
                place: None,
            });
        }
        !is_in_file
    });
}

/// The markers of a figure: the model's, with those of a file; where there are none, its named frames.
pub(crate) fn markers(body: &Body, more: Option<&Path>) -> Result<Vec<Marker>, CliError> {
    let mut set = body.markers.clone();
    if let Some(path) = more {
        let text = input::decoded(path)?;
        let more =
            opensim::markers(&text, &body.figure).map_err(|faults| input::faulty(path, &text, faults))?;
        set = set.with(more);
    }
    Ok(if set.markers.is_empty() { body.frames_as_markers() } else { set.markers })
}

/// What to weigh and hold: defaults and locks are the model's; ranges hold where it clamps them, and where the format knows no
/// clamps.
pub(crate) fn options(
    body: &Body,
    tasks: Option<(&[MarkerTask], &[opensim::CoordinateTask], &Path)>,
    args: &MarkerArgs,
) -> Result<IkOptions, CliError> {
    let layout = body.figure.layout();
    let rest = body.rest();
    let mut options = IkOptions { keep_labels: args.keep_labels, ..body.ik_options() };
    if let Some((markers, coordinates, path)) = tasks {
        if !markers.is_empty() {
            options.weights = Some(markers.iter().map(|task| (task.name.clone(), task.weight)).collect());
        }
        for task in coordinates {
            let dof = layout.dof_index(&task.name).and_then(|dof| Some((dof, layout.coordinate(dof)?)));
            let refuse = |why: &str| CliError::input(path, &format!("{}: {why}", task.name));
            let Some((dof, at)) = dof else {
                return Err(refuse("the figure has no coordinate of this name"));
            };
            let value = match task.value {
                TaskValue::Default => rest[at],
                TaskValue::Manual(value) => value,
                // Left out before.
                TaskValue::FromFile => continue,
            };
            options.tasks.push(CoordinateTask { dof, value, weight: task.weight });
        }
    }
    Ok(options)
}
