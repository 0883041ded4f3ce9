//! The body by roles: which link is a thigh and which a foot, what a leg measures, and how a posture becomes coordinates.

pub(crate) mod cane;
pub(crate) mod foot;
pub(crate) mod leg;
pub(crate) mod missing;
pub(crate) mod posture;
pub(crate) mod roles;
pub(crate) mod rotations;
mod segments;

pub use cane::helped_side;
pub use leg::LegGeometry;
pub use missing::missing_for_walking;
pub use roles::{CANE, FEET};
pub(crate) use segments::{Body, Cane, REFERENCE_HEIGHT, Segment, root_order};
