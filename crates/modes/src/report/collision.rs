//! What links did to each other in a run.

/// Two links that touched each other, as the frames show it.
///
/// With the feature `serde` its keys are `links`, `touching_s`, `depth_m`, `depth_time_s`, `force_n` and `force_time_s`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LinkCollision {
    /// Their names.
    pub links: [String; 2],
    /// How long they touched (s): as many frames as they did in.
    #[cfg_attr(feature = "serde", serde(rename = "touching_s"))]
    pub touching: f64,
    /// How deep they were in each other at most (m).
    #[cfg_attr(feature = "serde", serde(rename = "depth_m"))]
    pub depth: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "depth_time_s"))]
    pub depth_time: f64,
    /// The greatest force of one on the other (N).
    #[cfg_attr(feature = "serde", serde(rename = "force_n"))]
    pub force: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "force_time_s"))]
    pub force_time: f64,
}
