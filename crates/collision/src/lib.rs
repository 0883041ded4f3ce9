#![doc = include_str!("../README.md")]

mod colliders;
mod solid;

pub use colliders::{Colliders, CollisionError, Touch};
