//! BVH: the skeleton animation that every 3D tool opens.
//!
//! BVH names no unit and no axes. What is written here is right-handed with **y up**, as most tools expect (x left and z
//! forward for a generated human), and **1 unit = 1 cm** unless another [`Unit`] is asked for. Angles are in degrees.
//!
//! - A `JOINT` is a link. One that slides, and then turns at most once about each of x, y, z (or against them), is written in
//!   its own order (`Zrotation Yrotation Xrotation` for Z-Y-X), from the parent outwards. Axes that it lacks follow with zeros,
//!   because many readers want three. Its angles are those of the motion: never wrapped, so they run past 180° without a flip.
//! - Any other joint (a ball, oblique axes, a turned frame) turns in the order Z-Y-X, by angles that go on from frame to frame.
//! - The root has three position channels, in world coordinates, and no offset. A joint below that slides has three too: where
//!   it is in its parent, in place of its offset.
//! - A world in which z is up is turned: x, y, z become z, x, y.
//! - An end-effector ends at its tip; a link without one ends in a stub of 5 cm towards its centre of mass.
//! - Velocities, forces, contacts and events have no place in BVH.
//!
//! [`read`] takes any hierarchy and makes a figure and its motion of it; what the file does not say (unit, up, masses) is
//! asked for, or guessed and said.

mod angles;
mod body;
mod error;
mod guess;
mod motion;
mod parse;
mod pose;
mod read;
mod skeleton;
mod table;
mod unit;
mod write;

pub use crate::clip::{Clip, ReadOptions, Up};
pub use error::BvhError;
pub use read::read;
pub use table::masses;
pub use unit::Unit;
pub use write::write;
