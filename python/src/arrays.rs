//! Arrays in and out: `float64` in C order as they are, everything else copied by numpy.

use crate::errors::argument;
use numpy::{
    Element, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Numbers of one state, or of many in rows.
pub(crate) struct States<'py> {
    array: PyReadonlyArrayDyn<'py, f64>,
    /// How many states there are; `None` where it is one, given as a vector.
    pub(crate) rows: Option<usize>,
}

impl<'py> States<'py> {
    /// An argument of this name: a vector of `width` numbers, or a matrix with a row a state.
    pub(crate) fn of(name: &str, given: &Bound<'py, PyAny>, width: usize) -> PyResult<Self> {
        let array = contiguous(name, given)?;
        let rows = match *array.shape() {
            [n] if n == width => None,
            [rows, n] if n == width => Some(rows),
            ref found => {
                return Err(argument(
                    name,
                    format!(
                        "{name} has the shape {}; it must be ({width},), or (states, {width})",
                        shape(found)
                    ),
                ));
            }
        };
        Ok(Self { array, rows })
    }

    /// The numbers, row by row.
    pub(crate) fn numbers(&self) -> &[f64] {
        // It is contiguous: `contiguous` saw to it.
        self.array.as_slice().unwrap_or_default()
    }

    /// Refuses another number of states than that of a first argument.
    pub(crate) fn check_rows(&self, name: &str, rows: Option<usize>) -> PyResult<()> {
        if self.rows == rows {
            return Ok(());
        }
        let told = |rows: Option<usize>| {
            rows.map_or("one state, a vector".to_owned(), |n| format!("{n} states, a row each"))
        };
        Err(argument(
            name,
            format!("{name} holds {}, q holds {}; give all of them alike", told(self.rows), told(rows)),
        ))
    }
}

/// An argument as `float64` in C order: itself where it is that, else a copy.
pub(crate) fn contiguous<'py>(
    name: &str,
    given: &Bound<'py, PyAny>,
) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let borrow = |array: &Bound<'py, PyArrayDyn<f64>>| {
        array.try_readonly().map_err(|_| argument(name, format!("{name} is being written to")))
    };
    if let Ok(array) = given.cast::<PyArrayDyn<f64>>()
        && array.is_c_contiguous()
    {
        return borrow(array);
    }
    let py = given.py();
    let kind = PyDict::new(py);
    kind.set_item("dtype", "float64")?;
    let copied =
        py.import("numpy")?.call_method("ascontiguousarray", (given,), Some(&kind)).map_err(|error| {
            let name = format!("{name} cannot be an array of numbers: {}", error.value(py));
            pyo3::exceptions::PyTypeError::new_err(name)
        })?;
    borrow(copied.cast::<PyArrayDyn<f64>>()?)
}

/// A fixed number of numbers.
pub(crate) fn fixed<const N: usize>(name: &str, given: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    let array = contiguous(name, given)?;
    let numbers = array.as_slice().unwrap_or_default();
    <[f64; N]>::try_from(numbers).map_err(|_| {
        argument(name, format!("{name} has the shape {}; it must be ({N},)", shape(array.shape())))
    })
}

/// How many there are of something.
pub(crate) fn count(name: &str, given: i64) -> PyResult<usize> {
    usize::try_from(given)
        .map_err(|_| argument(name, format!("{name} is {given}; it must be a whole number, 0 or more")))
}

/// A shape as Python writes it.
pub(crate) fn shape(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        many => format!("({})", many.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// Numbers in rows of `width`, or one vector where there is one state.
pub(crate) fn shaped<T: Element>(
    py: Python<'_>,
    numbers: Vec<T>,
    rows: Option<usize>,
    width: usize,
) -> PyResult<Bound<'_, PyAny>> {
    let flat = PyArray1::from_vec(py, numbers);
    Ok(match rows {
        None => flat.into_any(),
        Some(rows) => flat.reshape([rows, width])?.into_any(),
    })
}

/// A matrix of numbers that lie column by column.
pub(crate) fn matrix<'py>(
    py: Python<'py>,
    of: &solaris::dynamics::DMatrix<f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (rows, columns) = of.shape();
    let transposed = PyArray1::from_slice(py, of.transpose().as_slice());
    transposed.reshape([rows, columns])
}
