//! The tangents of splines: velocities at their keys.

mod continuous;
mod local;

pub(super) use continuous::continuous;
pub(super) use local::{bent, catmull_rom, centripetal, monotone};
