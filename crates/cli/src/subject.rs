//! A figure that is brought to a person's size.

mod report;

pub(crate) use report::SubjectReport;

use crate::args::{FrameArgs, MarkerArgs, SubjectArgs};
use crate::error::{CliError, UsageError};
use crate::input::{self, Body, Language};
use crate::markers;
use crate::recording;
use report::{BodyFactors, Fitted, Measured, Pair, Placed};
use solaris::analysis::markers::{
    FitOptions, fit_subject, inverse_kinematics, measured_factor, place_markers,
};
use solaris::io::markers::Recording;
use solaris::io::opensim::{self, MarkerSet, Measurement, PlacerSetup, Rescaling, ScaleSetup, ScalingStep};
use solaris::model::{Base, Figure, MarkerTrial, MassShares, Stretching, Vector3};
use std::path::{Path, PathBuf};

/// Reads a figure with its markers, and brings both to a person's size, where that is asked for; how stands beside it.
pub(crate) fn body(
    path: &Path,
    subject: &SubjectArgs,
    markers: &MarkerArgs,
    frame: &FrameArgs,
    trials: &[&Path],
) -> Result<(Body, Option<SubjectReport>), CliError> {
    let mut body = input::body_in(path, frame.files.as_deref())?;
    let base = frame.base.map_or(Base::Fixed, Base::from);
    body.figure = body.figure.on_base(base).map_err(|error| CliError::input(path, &error))?;
    let mut report = None;
    if subject.is_asked() {
        report = Some(if subject.scale_setup.is_none() && (subject.fit || subject.standing.is_some()) {
            fit(&mut body, path, (subject, markers), trials, base)?
        } else {
            scale(&mut body, path, subject, markers, base)?
        });
    } else {
        body.markers.markers = markers::markers(&body, markers.marker_set.as_deref())?;
    }
    Ok((body, report))
}

/// Fits a figure's lengths and markers to trials of a person.
fn fit(
    body: &mut Body,
    path: &Path,
    (subject, args): (&SubjectArgs, &MarkerArgs),
    others: &[&Path],
    base: Base,
) -> Result<SubjectReport, CliError> {
    let others = others.iter().copied().filter(|path| subject.fit && recording::is_one(path));
    let files: Vec<&Path> = subject.standing.as_deref().into_iter().chain(others).collect();
    if files.is_empty() {
        return Err(UsageError::NothingToFit.into());
    }
    body.markers.markers = markers::markers(body, args.marker_set.as_deref())?;
    let mut report = SubjectReport::new(body, None);
    let mut trials = Vec::new();
    for file in files {
        let Recording { markers, findings, .. } =
            recording::in_world(file, body.gravity, args.unit, args.axes)?.recording;
        report.notes.extend(findings.iter().map(|finding| format!("{}: {finding}", file.display())));
        trials.push(markers);
    }
    let refuse = |error: &dyn ToString| CliError::input(path, error);
    let (options, _) = markers::asked(body, args)?;
    let found = fit_subject(&body.figure, &body.markers.markers, &trials, &options, &FitOptions::default())
        .map_err(|error| refuse(&error))?;
    let mass = subject.mass.as_ref().map(|mass| mass.value);
    let stretching = Stretching { factors: found.factors.clone(), mass, shares: MassShares::Kept };
    let factors = of_bodies(&body.figure, &found.factors);
    resize(body, path, &factors, &stretching, base)?;
    body.markers.markers.clone_from(&found.markers);
    report.fitted = Some(Fitted::new(&found, trials.len()));
    report.finish(body, &factors);
    Ok(report)
}

/// The factors of links, and with each those of what is welded to it.
fn of_bodies(figure: &Figure, factors: &[Vector3<f64>]) -> Vec<(String, Vector3<f64>)> {
    let all = figure.links().iter().zip(factors);
    let with_welded = all.flat_map(|(link, by)| {
        let frames = link.frames().iter().map(|frame| frame.name.as_str());
        std::iter::once(link.name()).chain(frames).map(|name| (name.to_owned(), *by))
    });
    let mut bodies: Vec<(String, Vector3<f64>)> = Vec::new();
    for (name, by) in with_welded {
        if bodies.iter().all(|(known, _)| *known != name) {
            bodies.push((name, by));
        }
    }
    bodies
}

/// Gives the figure its size: through the model's text where it is `OpenSim`'s, since there a link may be several bodies.
fn resize(
    body: &mut Body,
    path: &Path,
    factors: &[(String, Vector3<f64>)],
    stretching: &Stretching,
    base: Base,
) -> Result<(), CliError> {
    let refuse = |error: &dyn ToString| CliError::input(path, error);
    body.figure = if body.language == Language::OpenSim {
        rescaled(body, path, factors, stretching)?.on_base(base).map_err(|error| refuse(&error))?
    } else {
        body.figure.stretched(stretching).map_err(|error| refuse(&error))?
    };
    Ok(())
}

/// A setup and where it stands, which its files' names count from.
struct Setup<'a> {
    setup: ScaleSetup,
    path: &'a Path,
}

impl Setup<'_> {
    /// A file that it names, as a path from here.
    fn file(&self, name: Option<&str>) -> Option<PathBuf> {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        name.map(|name| folder.join(name.replace('\\', "/")))
    }
}

/// Brings a figure to a person's size.
fn scale(
    body: &mut Body,
    path: &Path,
    subject: &SubjectArgs,
    markers: &MarkerArgs,
    base: Base,
) -> Result<SubjectReport, CliError> {
    let setup = subject.scale_setup.as_deref().map(read_setup).transpose()?;
    let set_file = setup.as_ref().and_then(|setup| setup.file(setup.setup.marker_set_file.as_deref()));
    body.markers = MarkerSet {
        markers: markers::markers(body, markers.marker_set.as_deref().or(set_file.as_deref()))?,
        findings: std::mem::take(&mut body.markers.findings),
    };
    let mut report = SubjectReport::new(body, setup.as_ref().map(|setup| &setup.setup));
    let factors = match &setup {
        Some(setup) => measured(body, setup, (subject, markers), &mut report)?,
        None => Vec::new(),
    };
    let figure = &body.figure;
    let refuse = |error: &dyn ToString| CliError::input(path, error);
    let told = subject.mass.as_ref().map(|mass| mass.value);
    let shares = if report.grows_by_volume() { MassShares::Volumes } else { MassShares::Kept };
    let stretching = Stretching {
        factors: figure.stretch_factors(&factors).map_err(|error| refuse(&error))?,
        mass: told.or(setup.as_ref().and_then(|setup| setup.setup.mass)),
        shares,
    };
    body.markers.markers = stretching.markers(&body.markers.markers).map_err(|error| refuse(&error))?;
    resize(body, path, &factors, &stretching, base)?;
    if let Some(setup) = &setup
        && let Some(placer) = &setup.setup.placer
    {
        report.placed = Some(place(body, setup, placer, (subject, markers))?);
    }
    report.finish(body, &factors);
    Ok(report)
}

/// The figure of an OpenSim model whose text is scaled: exact body by body, where a figure's links may be several bodies.
fn rescaled(
    body: &Body,
    path: &Path,
    factors: &[(String, Vector3<f64>)],
    stretching: &Stretching,
) -> Result<Figure, CliError> {
    let text = input::decoded(path)?;
    let Stretching { mass, shares, .. } = *stretching;
    let factors = bodies_in(&text, factors);
    let rescaling = Rescaling { factors, mass, shares, ..Rescaling::default() };
    let faulty = |faults| input::faulty(path, &text, faults);
    let (scaled, _) = opensim::rescale(&text, &rescaling).map_err(faulty)?;
    let figure = opensim::read(&scaled).map_err(faulty)?.figure;
    figure.with_gravity(body.gravity).map_err(|error| CliError::input(path, &error))
}

/// Those factors that are of a body in a model's text.
pub(crate) fn bodies_in(text: &str, factors: &[(String, Vector3<f64>)]) -> Vec<(String, Vector3<f64>)> {
    let is_body = |name: &str| text.contains(&format!("<Body name=\"{name}\""));
    factors.iter().filter(|(name, _)| is_body(name)).cloned().collect()
}

fn read_setup(path: &Path) -> Result<Setup<'_>, CliError> {
    let text = input::decoded(path)?;
    let mut setup = opensim::scale_setup(&text).map_err(|faults| input::faulty(path, &text, faults))?;
    if let Some(placer) = &mut setup.placer {
        markers::leave_out_files(&mut placer.coordinates, &mut setup.findings);
    }
    Ok(Setup { setup, path })
}

/// The trial that a part of the setup names, or the one that was asked for, in the world of the figure.
fn trial(
    setup: &Setup,
    (name, range): (Option<&str>, Option<(f64, f64)>),
    gravity: Vector3<f64>,
    (subject, args): (&SubjectArgs, &MarkerArgs),
    report: Option<&mut SubjectReport>,
) -> Result<(PathBuf, MarkerTrial), CliError> {
    let Some(path) = subject.standing.clone().or_else(|| setup.file(name)) else {
        let why = "it names no trial; name one by --static";
        return Err(CliError::input(setup.path, &why));
    };
    let Recording { markers, findings, .. } =
        recording::in_world(&path, gravity, args.unit, args.axes)?.recording;
    if let Some(report) = report {
        report.notes.extend(findings.iter().map(ToString::to_string));
    }
    // The setup's times are those of its own trial.
    let own = setup.file(name);
    let range = range.filter(|_| own.as_deref().and_then(Path::file_name) == path.file_name());
    Ok((path, range.map_or(markers.clone(), |(from, to)| markers.within(from, to))))
}

/// The factors of bodies, in the setup's order.
fn measured(
    body: &Body,
    setup: &Setup,
    asked: (&SubjectArgs, &MarkerArgs),
    report: &mut SubjectReport,
) -> Result<Vec<(String, Vector3<f64>)>, CliError> {
    let mut factors: Vec<(String, Vector3<f64>)> = Vec::new();
    let mut set = |name: &str, axes: [bool; 3], by: &Vector3<f64>| {
        let at = factors.iter().position(|(known, _)| known == name).unwrap_or_else(|| {
            factors.push((name.to_owned(), Vector3::repeat(1.0)));
            factors.len() - 1
        });
        for (axis, _) in axes.iter().enumerate().filter(|(_, asked)| **asked) {
            factors[at].1[axis] = by[axis];
        }
    };
    let ScaleSetup { marker_file, time_range, .. } = &setup.setup;
    for step in &setup.setup.steps {
        match step {
            ScalingStep::Manual => {
                for manual in &setup.setup.manual {
                    set(&manual.body, [true; 3], &manual.factors);
                }
            }
            ScalingStep::Measurements => {
                let (path, trial) = trial(
                    setup,
                    (marker_file.as_deref(), *time_range),
                    body.gravity,
                    asked,
                    Some(&mut *report),
                )?;
                let rest = body.rest();
                for Measurement { name, pairs, bodies } in &setup.setup.measurements {
                    let found = measured_factor(&body.figure, &body.markers.markers, &rest, &trial, pairs);
                    let found = match found {
                        Ok(found) => found,
                        Err(error) => {
                            let why = format!("measurement '{name}': {error}; its bodies keep their size");
                            report.notes.push(format!("{}: {why}", path.display()));
                            continue;
                        }
                    };
                    for scaled in bodies {
                        set(&scaled.body, scaled.axes, &Vector3::repeat(found.factor));
                    }
                    report.measured.push(Measured {
                        name: name.clone(),
                        factor: found.factor,
                        pairs: found.pairs.iter().map(Pair::of).collect(),
                    });
                }
            }
        }
    }
    factors.retain(|(name, _)| {
        let is_known = body.figure.locate(name).is_some();
        if !is_known {
            report.notes.push(format!("{}: the model has no body '{name}' to scale", setup.path.display()));
        }
        is_known
    });
    Ok(factors)
}

/// Puts the markers where the static trial has them.
fn place(
    body: &mut Body,
    setup: &Setup,
    placer: &PlacerSetup,
    asked: (&SubjectArgs, &MarkerArgs),
) -> Result<Placed, CliError> {
    let (path, trial) =
        trial(setup, (placer.marker_file.as_deref(), placer.time_range), body.gravity, asked, None)?;
    let standing = trial.mean();
    let options = markers::options(body, Some((&placer.markers, &placer.coordinates, setup.path)), asked.1)?;
    let refuse = |error: &dyn ToString| CliError::input(&path, error);
    let found = inverse_kinematics(&body.figure, &body.markers.markers, &standing, &options)
        .map_err(|error| refuse(&error))?;
    let (placed, lost) = place_markers(&body.figure, &body.markers.markers, &found.q, &standing)
        .map_err(|error| refuse(&error))?;
    let before = &body.markers.markers;
    let moved = placed.iter().filter_map(|marker| {
        let old = before.iter().find(|old| old.name == marker.name)?;
        Some((marker.name.clone(), (marker.position - old.position).norm()))
    });
    let placed_report = Placed::new(&found, trial.len(), moved.collect(), lost);
    body.markers.markers = placed;
    Ok(placed_report)
}

/// The factors of a body, if it has any.
fn factors_of((body, factors): &(String, Vector3<f64>)) -> BodyFactors {
    BodyFactors { body: body.clone(), factors: (*factors).into() }
}
