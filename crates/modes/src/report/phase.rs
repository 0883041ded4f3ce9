//! What was computed in a part of a run, and what was left out.

use solaris_dynamics::scalar::Operations;

/// What was computed during a stretch of time, and what was left out.
///
/// With the feature `serde` its keys are `start_s`, `end_s`, `dynamic`, `prescribed`, `fused`, `dropped_links`, `operations_of_all`,
/// `operations` (all kinds together) and `omitted`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PhaseReport {
    /// From when (s).
    #[cfg_attr(feature = "serde", serde(rename = "start_s"))]
    pub start: f64,
    /// Until when (s).
    #[cfg_attr(feature = "serde", serde(rename = "end_s"))]
    pub end: f64,
    /// Degrees of freedom that dynamics move.
    pub dynamic: Vec<String>,
    /// Degrees of freedom on prescribed motions that the dynamics have to know.
    pub prescribed: Vec<String>,
    /// Degrees of freedom that stand still and were fused away.
    pub fused: Vec<String>,
    /// Links whose prescribed motion nothing that is computed depends on.
    #[cfg_attr(feature = "serde", serde(rename = "dropped_links"))]
    pub dropped: Vec<String>,
    /// Operations of one evaluation of the whole figure.
    #[cfg_attr(feature = "serde", serde(serialize_with = "all_kinds"))]
    pub operations_of_all: Operations,
    /// Operations of one evaluation of what is left.
    #[cfg_attr(feature = "serde", serde(serialize_with = "all_kinds"))]
    pub operations: Operations,
    /// What was left out besides: `contact: the scene has none`, …
    pub omitted: Vec<String>,
}

/// Operations of all kinds, as one number.
#[cfg(feature = "serde")]
#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde hands over a reference")]
fn all_kinds<S: serde::Serializer>(operations: &Operations, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_u64(operations.total())
}
