//! The pivot split of any motion.

use super::sharing::{Parts, Sharing};
use crate::split::{FootSupport, pivot_parts};

/// Height of the point that the feet's forces point at, over the height of the centre of mass: that of the walks that
/// Solaris plans.
const PIVOT: f64 = 1.4297;

/// `feet` are those that stand in the frame, if any do.
pub(super) fn share(sharing: &Sharing<'_>, row: usize, feet: Option<&[FootSupport]>) -> Parts {
    let mut parts = sharing.nothing();
    let Some(feet) = feet else { return parts };
    if let Some(foot) = Sharing::only(feet) {
        return sharing.whole(row, foot);
    }
    // A centre of mass at or below the ground has no pivot above it: the forces stay parallel.
    let height = sharing.height(row);
    let pull = if height > 0.0 { 1.0 / (PIVOT * height) } else { 0.0 };
    pivot_parts(&sharing.total[row].wrench(), &sharing.prepared.up, pull, feet, &mut parts);
    parts
}
