//! Errors of the libraries as the exceptions of `solaris/errors.py`, with fields in place of strings to cut.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use solaris::dynamics::DynamicsError;
use solaris::dynamics::batch::BatchError;
use solaris::files::FileError;
use solaris::gait::{GaitError, RequestError};
use solaris::model::{TextError, TextFault};
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

/// What is wrong with an argument, as Python's own functions say it.
pub(crate) fn value(message: impl Display) -> PyErr {
    pyo3::exceptions::PyValueError::new_err(message.to_string())
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
    Python::attach(|py| {
        let fields = PyDict::new(py);
        match fields.set_item("path", path.display().to_string()) {
            Ok(()) => exception(py, "FileError", message, &fields),
            Err(error) => error,
        }
    })
}

/// The kernel's refusal.
pub(crate) fn dynamics(error: DynamicsError) -> PyErr {
    plain("DynamicsError")(&error)
}

/// Refusals of a batch: the rows are a field.
pub(crate) fn batch(error: BatchError) -> PyErr {
    let rows = match &error {
        BatchError::Rows { rows, .. } => rows.clone(),
        _ => Vec::new(),
    };
    Python::attach(|py| {
        let fields = PyDict::new(py);
        match fields.set_item("rows", rows) {
            Ok(()) => exception(py, "DynamicsError", &error.to_string(), &fields),
            Err(error) => error,
        }
    })
}

/// A walk that cannot be: of a number out of its range, which and in which.
pub(crate) fn gait(error: GaitError) -> PyErr {
    let range = match &error {
        GaitError::Request(
            RequestError::Range { parameter, value, lower, upper, unit, .. }
            | RequestError::StepLength { parameter, value, lower, upper, unit, .. },
        ) => Some((*parameter, [*value, *lower, *upper], unit.trim())),
        _ => None,
    };
    // Angles of arguments are in rad; numbers of the style are in their own units.
    let range = range.map(|(parameter, numbers, unit)| match parameter {
        "slope" | "turn" => (parameter, numbers.map(f64::to_radians), "rad"),
        _ => (parameter, numbers, unit),
    });
    Python::attach(|py| {
        let build = || -> PyResult<Bound<'_, PyDict>> {
            let fields = PyDict::new(py);
            if let Some((parameter, [value, lower, upper], unit)) = range {
                fields.set_item("parameter", parameter.replace([' ', '-'], "_"))?;
                fields.set_item("value", value)?;
                fields.set_item("lower", lower)?;
                fields.set_item("upper", upper)?;
                fields.set_item("unit", unit)?;
            }
            Ok(fields)
        };
        build().map_or_else(|e| e, |fields| exception(py, "WalkError", &error.to_string(), &fields))
    })
}
