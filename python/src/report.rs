//! Reports of the libraries as dictionaries.

use crate::errors::value;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde_json::Value;

/// Anything that can be written, as Python's own types.
pub(crate) fn dictionary<'py>(py: Python<'py>, of: &impl serde::Serialize) -> PyResult<Bound<'py, PyAny>> {
    convert(py, &serde_json::to_value(of).map_err(value)?)
}

fn convert<'py>(py: Python<'py>, of: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match of {
        Value::Null => py.None().into_bound(py),
        Value::Bool(of) => of.into_pyobject(py)?.to_owned().into_any(),
        Value::Number(of) => match (of.as_u64(), of.as_i64()) {
            (Some(of), _) => of.into_pyobject(py)?.into_any(),
            (None, Some(of)) => of.into_pyobject(py)?.into_any(),
            (None, None) => of.as_f64().unwrap_or(f64::NAN).into_pyobject(py)?.into_any(),
        },
        Value::String(of) => of.into_pyobject(py)?.into_any(),
        Value::Array(of) => {
            let all = of.iter().map(|one| convert(py, one)).collect::<PyResult<Vec<_>>>()?;
            PyList::new(py, all)?.into_any()
        }
        Value::Object(of) => {
            let all = PyDict::new(py);
            for (key, one) in of {
                all.set_item(key, convert(py, one)?)?;
            }
            all.into_any()
        }
    })
}
