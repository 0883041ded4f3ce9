#![doc = include_str!("../README.md")]

mod align;
mod belt;
mod error;
mod feet;
mod heading;
mod legs;
mod map;
mod mirror;
mod planted;
mod replant;
mod roles;
mod skeleton;
mod take;
mod transfer;
mod twist;

pub use error::RetargetError;
pub use map::BoneMap;
pub use roles::{Limbs, ROLES, Roles};
pub use skeleton::{Bone, Skeleton};
pub use take::Take;
pub use transfer::{Moved, Replanted, retarget};
pub use twist::Roll;
