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

/// How a loop was held, as the frames show it.
///
/// With the feature `serde` its keys are `links`, `apart_m`, `apart_time_s`, `force_n` and `force_time_s`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LoopReport {
    /// The links that it holds together, or `world`.
    pub links: [String; 2],
    /// How far apart its points were at most (m).
    #[cfg_attr(feature = "serde", serde(rename = "apart_m"))]
    pub apart: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "apart_time_s"))]
    pub apart_time: f64,
    /// The greatest force that it took (N).
    #[cfg_attr(feature = "serde", serde(rename = "force_n"))]
    pub force: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "force_time_s"))]
    pub force_time: f64,
}

impl LinkCollision {
    /// One frame more, `step` (s) after the one before.
    pub(crate) fn take(&mut self, (time, step): (f64, f64), depth: f64, force: f64) {
        self.touching += step;
        if depth > self.depth {
            (self.depth, self.depth_time) = (depth, time);
        }
        if force > self.force {
            (self.force, self.force_time) = (force, time);
        }
    }
}

impl LoopReport {
    /// One frame more.
    pub(crate) fn take(&mut self, time: f64, apart: f64, force: f64) {
        if apart > self.apart {
            (self.apart, self.apart_time) = (apart, time);
        }
        if force > self.force {
            (self.force, self.force_time) = (force, time);
        }
    }
}
