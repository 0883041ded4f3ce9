//! The difference of two passes.

use super::record::Record;
use crate::failure::SetupError;
use crate::report::ErrorEstimate;
use solaris_model::Figure;

/// The greatest difference of positions and of velocities over the frames that both have.
pub(crate) fn difference(figure: &Figure, one: &Record, other: &Record) -> Result<ErrorEstimate, SetupError> {
    let mut step = vec![0.0; figure.layout().nv()];
    let mut greatest = ErrorEstimate::default();
    for frame in 0..one.done.min(other.done) {
        figure.difference(one.q(frame), other.q(frame), &mut step)?;
        greatest.position = step.iter().fold(greatest.position, |most, x| most.max(x.abs()));
        let rates = one.v(frame).iter().zip(other.v(frame));
        greatest.velocity = rates.fold(greatest.velocity, |most, (a, b)| most.max((a - b).abs()));
    }
    Ok(greatest)
}
