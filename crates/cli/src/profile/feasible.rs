//! The values of a parameter that keep a motion from turning round.

use crate::words::ranges;
use solaris::profiles::{Parameter, Ranges};

/// The values of a parameter with which the motion never turns round.
pub(super) struct Feasible {
    pub(super) parameter: &'static Parameter,
    pub(super) ranges: Ranges,
}

impl Feasible {
    pub(super) fn label(&self) -> String {
        format!("never turns round, {}", self.parameter.symbol)
    }

    /// The ranges with few digits, rounded inwards: what is read is in them.
    pub(super) fn short(&self) -> String {
        ranges(self.ranges.as_slice())
    }
}
