//! Errors of the libraries as the exceptions of `solaris/errors.py`, with fields in place of strings to cut.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use solaris::dynamics::DynamicsError;
use solaris::dynamics::batch::BatchError;
use solaris::files::FileError;
use solaris::gait::{GaitError, RequestError};
use solaris::model::{FigureError, HumanError, MotionError, TextError, TextFault};
use solaris::modes::RunError;
use solaris::scene::SceneError;
use std::fmt::Display;

/// An exception of `solaris.errors`, with these fields.
pub(crate) fn exception(py: Python<'_>, class: &str, message: &str, fields: &Bound<'_, PyDict>) -> PyErr {
    let raised = py
        .import("solaris.errors")
        .and_then(|module| module.getattr(class))
        .and_then(|class| class.call((message,), Some(fields)));
    raised.map_or_else(|error| error, PyErr::from_value)
}

/// An exception of this class that has a message alone.
pub(crate) fn plain(class: &'static str) -> impl Fn(&dyn Display) -> PyErr {
    move |error| Python::attach(|py| exception(py, class, &error.to_string(), &PyDict::new(py)))
}

/// An exception of this class with the fields that `fill` sets.
fn with(
    class: &str,
    error: &dyn Display,
    fill: impl FnOnce(Python<'_>, &Bound<'_, PyDict>) -> PyResult<()>,
) -> PyErr {
    Python::attach(|py| {
        let fields = PyDict::new(py);
        match fill(py, &fields) {
            Ok(()) => exception(py, class, &error.to_string(), &fields),
            Err(error) => error,
        }
    })
}

/// What is wrong with an argument of this name.
pub(crate) fn argument(name: &str, message: impl Display) -> PyErr {
    with("ArgumentError", &message, |_, fields| fields.set_item("argument", name))
}

/// What is wrong with several arguments, or with none in particular.
pub(crate) fn value(message: impl Display) -> PyErr {
    plain("ArgumentError")(&message)
}

/// A text with faults: `FigureError`, `SceneError` or another class with a list of them.
pub(crate) fn text(class: &str, path: &str, message: &str, files: &[(&str, &TextError)]) -> PyErr {
    Python::attach(|py| {
        let build = || -> PyResult<Bound<'_, PyDict>> {
            let fault = py.import("solaris.errors")?.getattr("Fault")?;
            let of = |file: &str, TextFault { place, message, .. }: &TextFault| {
                fault.call1((file, place.line, place.column, message))
            };
            let faults = files.iter().flat_map(|(file, error)| error.faults.iter().map(|f| of(file, f)));
            let fields = PyDict::new(py);
            fields.set_item("path", path)?;
            fields.set_item("faults", faults.collect::<PyResult<Vec<_>>>()?)?;
            Ok(fields)
        };
        build().map_or_else(|error| error, |fields| exception(py, class, message, &fields))
    })
}

/// A file that cannot be used: one that holds faults raises `class`, others a `FileError`.
pub(crate) fn file(class: &'static str) -> impl Fn(FileError) -> PyErr {
    move |error| {
        let message = error.to_string();
        match &error {
            FileError::Text { path, faults, .. } => {
                let shown = path.display().to_string();
                text(class, &shown, &message, &[(&shown, faults)])
            }
            FileError::Files { path, error } => {
                let shown = path.display().to_string();
                let name = |file: &str| {
                    if file.is_empty() {
                        shown.clone()
                    } else {
                        path.with_file_name(file).display().to_string()
                    }
                };
                let names: Vec<String> = error.files.iter().map(|file| name(&file.path)).collect();
                let files: Vec<_> =
                    names.iter().zip(&error.files).map(|(name, file)| (name.as_str(), &file.error)).collect();
                text(class, &shown, &message, &files)
            }
            FileError::Input { path, .. } | FileError::Folder { folder: path, .. } => of_path(path, &message),
            _ => plain("FileError")(&message),
        }
    }
}

/// A file at fault.
pub(crate) fn of_path(path: &std::path::Path, message: &str) -> PyErr {
    with("FileError", &message, |_, fields| fields.set_item("path", path.display().to_string()))
}

/// A table that is no motion of a figure.
pub(crate) fn of_table(path: &std::path::Path, error: &dyn Display) -> PyErr {
    let shown = path.display().to_string();
    with("MotionError", &format!("{shown}: {error}"), |_, fields| fields.set_item("path", &shown))
}

/// A figure that cannot be; its faults have no place, for they are of no text.
pub(crate) fn figure(error: FigureError) -> PyErr {
    with("FigureError", &error, |py, fields| {
        let fault = py.import("solaris.errors")?.getattr("Fault")?;
        let faults = error.faults.iter().map(|found| fault.call1(("", 0, 0, found.to_string())));
        fields.set_item("faults", faults.collect::<PyResult<Vec<_>>>()?)
    })
}

/// A person who cannot be.
pub(crate) fn human(error: HumanError) -> PyErr {
    let range = error.range().map(|(parameter, numbers, unit)| (parameter.to_owned(), numbers, unit));
    with("FigureError", &error, |_, fields| set_range(fields, range))
}

/// The kernel's refusal: the argument, and the name of the degree of freedom, link or frame.
pub(crate) fn dynamics(error: DynamicsError) -> PyErr {
    use DynamicsError as E;
    let (argument, name) = match &error {
        E::NotFinite { what, dof, .. } => (Some(*what), Some(dof)),
        E::Length { what, .. } => (Some(*what), None),
        E::Quaternion { name, .. } => (Some("q"), Some(name)),
        E::UnknownFrame { name, .. } => (Some("frame"), Some(name)),
        E::FrameNotFinite { link, .. } => (Some("frame"), Some(link)),
        E::WrenchNotFinite { link, .. } => (Some("external"), Some(link)),
        E::NoInertia { dof, .. } | E::Follower { dof, .. } => (None, Some(dof)),
        E::Joint { joint } => (None, Some(joint)),
        E::Root { link } => (None, Some(link)),
        _ => (None, None),
    };
    with("DynamicsError", &error, |_, fields| {
        fields.set_item("argument", argument)?;
        fields.set_item("name", name)
    })
}

/// A wrench on a link that there is not.
pub(crate) fn no_link(name: &str, message: &dyn Display) -> PyErr {
    with("DynamicsError", message, |_, fields| {
        fields.set_item("argument", "external")?;
        fields.set_item("name", name)
    })
}

/// Refusals of a batch: the rows are a field.
pub(crate) fn batch(error: BatchError) -> PyErr {
    let rows = match &error {
        BatchError::Rows { rows, .. } => rows.clone(),
        _ => Vec::new(),
    };
    with("DynamicsError", &error, |_, fields| fields.set_item("rows", rows))
}

/// Numbers that are no motion: which sample, when, and of which degree of freedom.
pub(crate) fn motion(error: MotionError) -> PyErr {
    let (sample, time, dof) = match &error {
        MotionError::Time { sample, time } => (Some(*sample), Some(*time), None),
        MotionError::NotFinite { dof, time, .. } => (None, Some(*time), Some(dof)),
        _ => (None, None, None),
    };
    with("MotionError", &error, |_, fields| {
        fields.set_item("sample", sample)?;
        fields.set_item("time", time)?;
        fields.set_item("dof", dof)
    })
}

/// A run that failed: when, where, and what helps.
pub(crate) fn run(error: RunError) -> PyErr {
    run_told(&error, &error)
}

/// A run of a scene that failed, in the words of a scene.
pub(crate) fn scene_run(error: SceneError) -> PyErr {
    match &error {
        SceneError::Run(run) => run_told(run, &error),
        _ => plain("RunError")(&error),
    }
}

fn run_told(error: &RunError, message: &dyn Display) -> PyErr {
    let RunError::Failed(failure) = error else { return plain("RunError")(message) };
    with("RunError", message, |_, fields| {
        fields.set_item("time", failure.time)?;
        fields.set_item("dof", failure.dof.as_ref())?;
        fields.set_item("remedies", failure.remedies.iter().map(ToString::to_string).collect::<Vec<_>>())
    })
}

/// A number out of its range: which, its value and its least and greatest value, its unit.
type Range = (String, [f64; 3], &'static str);

fn set_range(fields: &Bound<'_, PyDict>, range: Option<Range>) -> PyResult<()> {
    let Some((parameter, [value, lower, upper], unit)) = range else { return Ok(()) };
    fields.set_item("parameter", parameter.replace([' ', '-'], "_"))?;
    fields.set_item("value", value)?;
    fields.set_item("lower", lower)?;
    fields.set_item("upper", upper)?;
    fields.set_item("unit", unit)
}

/// A walk that cannot be: of a number out of its range, which and in which.
pub(crate) fn gait(error: GaitError) -> PyErr {
    let mut cause = &error;
    while let GaitError::InSegment { why, .. }
    | GaitError::InPart { why, .. }
    | GaitError::BesideRun { why, .. } = cause
    {
        cause = why;
    }
    // Angles of arguments are in rad; numbers of the style are in their own units.
    let range = match cause {
        GaitError::Request(RequestError::Range {
            parameter: parameter @ ("slope" | "turn"),
            value,
            lower,
            upper,
            ..
        }) => Some(((*parameter).to_owned(), [*value, *lower, *upper].map(f64::to_radians), "rad")),
        GaitError::Request(
            RequestError::Range { parameter, value, lower, upper, unit, .. }
            | RequestError::StepLength { parameter, value, lower, upper, unit, .. },
        ) => Some(((*parameter).to_owned(), [*value, *lower, *upper], unit.trim())),
        _ => None,
    };
    with("WalkError", &error, |_, fields| set_range(fields, range))
}
