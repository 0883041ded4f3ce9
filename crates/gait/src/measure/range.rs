//! Joints that leave their own ranges.

use super::series::Series;
use solaris_model::{Figure, Motion};

/// Where a joint goes farthest beyond the range that its figure gives it.
///
/// With the feature `serde` its keys are `joint`, `beyond_deg` and `time`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[doc(alias = "joint limits")]
#[doc(alias = "range of motion")]
pub struct BeyondRange {
    /// Its degree of freedom, as the figure calls it.
    pub joint: String,
    /// By how much (rad).
    #[cfg_attr(feature = "serde", serde(rename = "beyond_deg", serialize_with = "super::angle_in_degrees"))]
    pub by: f64,
    /// When (s).
    pub time: f64,
}

/// The worst of them, if there is any.
pub(super) fn beyond_range(figure: &Figure, motion: &Motion, series: &Series<'_>) -> Option<BeyondRange> {
    let samples = series.time.iter().enumerate();
    let excesses = samples.flat_map(|(i, &time)| {
        figure.limit_excess(motion.q(i)).into_iter().map(move |excess| (excess, time))
    });
    let (worst, time) = excesses.max_by(|a, b| a.0.by.total_cmp(&b.0.by))?;
    Some(BeyondRange { joint: figure.layout().v_names()[worst.dof].clone(), by: worst.by, time })
}
