//! Recorded motions and forces, before anything is derived from them.

use crate::motion::Contact;
use nalgebra::Vector3;

/// States of a figure over time, of which velocities and accelerations may be missing.
///
/// Rows are samples, in the order of the figure's [`crate::StateLayout`]: `q` has `nq` numbers a row, `v` and `a` have
/// `nv`.
#[doc(alias = "recording")]
#[doc(alias = "motion capture")]
#[doc(alias = "mocap")]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// When (s), rising; rows that are unrelated states are numbered 0, 1, 2 ….
    pub time: Vec<f64>,
    /// Positions (m, rad; quaternions x, y, z, w).
    pub q: Vec<f64>,
    /// Velocities (m/s, rad/s); zero where they are not known.
    pub v: Vec<f64>,
    /// Accelerations (m/s², rad/s²); zero where they are not known.
    pub a: Vec<f64>,
    /// Of each degree of freedom, whether its velocities were recorded.
    pub known_v: Vec<bool>,
    /// Of each degree of freedom, whether its accelerations were recorded.
    pub known_a: Vec<bool>,
}

/// Forces on one link that were measured over time.
#[doc(alias = "force plate")]
#[doc(alias = "grf")]
#[derive(Clone, Debug, PartialEq)]
pub struct ForceRecord {
    /// The link that they act on, or two: the second once the centre of pressure has passed the point between them.
    pub links: Vec<String>,
    /// Of two links, that point and the second one's foremost (m, in the second's frame); `None` for ball and tip of its sole.
    pub ball_and_tip: Option<[Vector3<f64>; 2]>,
    /// When (s), rising; need not be the times of the motion.
    pub time: Vec<f64>,
    /// What acts, one a time: world axes, moment about the world's origin.
    pub samples: Vec<Contact>,
}
