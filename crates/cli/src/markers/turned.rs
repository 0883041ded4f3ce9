//! A figure that markers lay on its side, and the axes that would not.

use crate::error::CliError;
use crate::input::Body;
use crate::plausible::Finding;
use crate::recording::Turned;
use solaris::analysis::plausibility::{MotionFinding, check_upright};

/// That the figure lies or stands on its head at `q`, from how it is at `rest`, and what to name if that is not so.
pub(super) fn turned(
    body: &Body,
    [rest, q]: [&[f64]; 2],
    read: &Turned,
    axes_are_named: bool,
) -> Result<Option<Finding>, CliError> {
    let found = check_upright(&body.figure, rest, q, body.gravity).map_err(CliError::other)?;
    let Some(MotionFinding::Turned { along, .. }) = found else { return Ok(None) };
    let (up, other) = (read.axes.up(), read.with_up(&along.into()));
    let by = if axes_are_named { ", as --axes says" } else { "" };
    let advice = format!("the file is read with {up} up{by}: if nobody lies in it, give --axes {other}");
    Ok(found.as_ref().map(|found| Finding::from(found).with_advice(&advice)))
}
