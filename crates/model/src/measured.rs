//! Forces that were measured beside a motion, at times of their own.

use crate::motion::Contact;
use nalgebra::Vector3;

/// A force on one link that was measured over time: what a force plate records.
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "ExternalForce")]
#[doc(alias = "grf")]
pub struct MeasuredForce {
    /// The link that they act on, or two: the second once the centre of pressure has passed the point between them.
    pub links: Vec<String>,
    /// Of two links, that point and the second one's foremost (m, in the second's frame); `None` for ball and tip of its sole.
    pub ball_and_tip: Option<[Vector3<f64>; 2]>,
    /// When (s), rising; need not be the times of the motion.
    pub time: Vec<f64>,
    /// What acts, one a time: world axes, moment about the world's origin.
    pub samples: Vec<Contact>,
}
