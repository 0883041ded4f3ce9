//! A motion's table by the Arrow C interface.

use crate::errors::value;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{ArrayRef, Float64Array, RecordBatch, RecordBatchIterator};
use arrow_schema::ffi::FFI_ArrowSchema;
use arrow_schema::{DataType, Field, Schema};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use solaris::io::record;
use solaris::model::Motion;
use std::sync::Arc;

/// The columns of a motion's table, in the order of its headings.
pub(crate) fn columns(motion: &Motion) -> Vec<Vec<f64>> {
    let width = if motion.is_empty() { 0 } else { record::row(motion, 0).count() };
    let mut columns = vec![Vec::with_capacity(motion.len()); width];
    for sample in 0..motion.len() {
        for (column, number) in columns.iter_mut().zip(record::row(motion, sample)) {
            column.push(number);
        }
    }
    columns
}

fn typed(headings: Vec<String>) -> Schema {
    let field = |name: String| Field::new(name, DataType::Float64, false);
    Schema::new(headings.into_iter().map(field).collect::<Vec<_>>())
}

pub(crate) fn schema(py: Python<'_>, headings: Vec<String>) -> PyResult<Bound<'_, PyCapsule>> {
    let schema = FFI_ArrowSchema::try_from(&typed(headings)).map_err(value)?;
    PyCapsule::new_with_value(py, schema, c"arrow_schema")
}

pub(crate) fn stream<'py>(
    py: Python<'py>,
    headings: Vec<String>,
    motion: &Motion,
) -> PyResult<Bound<'py, PyCapsule>> {
    let schema = Arc::new(typed(headings));
    let arrays = py
        .detach(|| columns(motion))
        .into_iter()
        .map(|column| Arc::new(Float64Array::from(column)) as ArrayRef);
    let batch = RecordBatch::try_new(Arc::clone(&schema), arrays.collect()).map_err(value)?;
    let reader = RecordBatchIterator::new([Ok(batch)], schema);
    let stream = FFI_ArrowArrayStream::new(Box::new(reader));
    PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
}
