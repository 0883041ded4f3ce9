//! The difference of two passes.

use super::pass::Passed;
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

/// The part of what a method says of the errors of its steps that is believed in any case.
const LEAST: f64 = 0.01;

/// How many times what it says of them, where nothing else is known: errors grow on the way, in random scenes up to fivefold.
const GROWN: f64 = 5.0;

/// How far off `one` is, at most, by its difference from `other`, of which it is a `part`.
///
/// Where a looser tolerance made no step longer, for drives change more often than that, the two are the same, and their difference
/// says nothing: then five times what the method says of its own steps is the least. A hundredth of that is so at any rate, for two
/// may agree by chance.
pub(crate) fn estimate(
    figure: &Figure,
    one: &Passed,
    other: &Passed,
    part: f64,
) -> Result<ErrorEstimate, SetupError> {
    let apart = difference(figure, &one.record, &other.record)?;
    let least = if one.counts.steps == other.counts.steps { GROWN * one.errors } else { LEAST * one.errors };
    Ok(ErrorEstimate {
        position: (part * apart.position).max(least),
        velocity: (part * apart.velocity).max(least),
    })
}
