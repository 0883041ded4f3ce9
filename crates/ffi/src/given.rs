//! What C hands over: handles, arrays and texts, checked as far as that is possible.

use crate::error::Failure;
use solaris::model::Vector3;
use std::ffi::{CStr, c_char};

/// A handle.
pub(crate) unsafe fn handle<'a, T>(name: &str, given: *const T) -> Result<&'a T, Failure> {
    unsafe { given.as_ref() }.ok_or_else(|| null(name))
}

/// A handle that changes.
pub(crate) unsafe fn handle_mut<'a, T>(name: &str, given: *mut T) -> Result<&'a mut T, Failure> {
    unsafe { given.as_mut() }.ok_or_else(|| null(name))
}

/// A place for a result.
pub(crate) unsafe fn give<T>(name: &str, place: *mut *mut T, made: T) -> Result<(), Failure> {
    let place = unsafe { place.as_mut() }.ok_or_else(|| null(name))?;
    *place = Box::into_raw(Box::new(made));
    Ok(())
}

/// Takes a handle back.
pub(crate) unsafe fn free<T>(given: *mut T) {
    if !given.is_null() {
        drop(unsafe { Box::from_raw(given) });
    }
}

/// Numbers that are read, `expected` of them.
pub(crate) unsafe fn numbers<'a>(
    name: &str,
    given: *const f64,
    length: usize,
    expected: usize,
) -> Result<&'a [f64], Failure> {
    check_length(name, given.is_null(), length, expected)?;
    if expected == 0 {
        return Ok(&[]);
    }
    Ok(unsafe { std::slice::from_raw_parts(given, length) })
}

/// Numbers that are written, `expected` of them, apart from those that are read.
pub(crate) unsafe fn numbers_mut<'a>(
    name: &str,
    given: *mut f64,
    length: usize,
    expected: usize,
    read: &[&[f64]],
) -> Result<&'a mut [f64], Failure> {
    check_length(name, given.is_null(), length, expected)?;
    if expected == 0 {
        return Ok(&mut []);
    }
    let (start, end) = (given as usize, given as usize + 8 * length);
    let overlaps = |other: &&[f64]| {
        let from = other.as_ptr() as usize;
        !other.is_empty() && from < end && start < from + 8 * other.len()
    };
    if read.iter().any(overlaps) {
        return Err(Failure::argument(format!("{name} overlaps an argument; give it an array of its own")));
    }
    Ok(unsafe { std::slice::from_raw_parts_mut(given, length) })
}

/// Three numbers of a point or a direction.
pub(crate) unsafe fn vector(name: &str, given: *const f64) -> Result<Vector3<f64>, Failure> {
    Ok(Vector3::from_column_slice(unsafe { numbers(name, given, 3, 3) }?))
}

/// A text.
pub(crate) unsafe fn words<'a>(name: &str, given: *const c_char) -> Result<&'a str, Failure> {
    if given.is_null() {
        return Err(null(name));
    }
    let text = unsafe { CStr::from_ptr(given) };
    text.to_str().map_err(|error| Failure::argument(format!("{name} is no UTF-8: {error}")))
}

fn null(name: &str) -> Failure {
    Failure::argument(format!("{name} is NULL"))
}

fn check_length(name: &str, is_null: bool, length: usize, expected: usize) -> Result<(), Failure> {
    if length != expected {
        return Err(Failure::argument(format!("{name} has {length} numbers; it must have {expected}")));
    }
    if is_null && expected > 0 {
        return Err(null(name));
    }
    Ok(())
}
