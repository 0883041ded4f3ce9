#![doc = include_str!("../README.md")]
#![cfg_attr(not(feature = "std"), no_std)]
#![allow(
    clippy::inline_always,
    reason = "what runs in vector registers is compiled whole, for the instructions at hand"
)]

#[cfg(feature = "counted")]
mod counted;
#[cfg(feature = "double-double")]
mod double_double;
mod dual;
mod elementary;
mod float;
mod scalar;
pub mod sine;

#[cfg(feature = "counted")]
pub use counted::{Counted, Operations};
#[cfg(feature = "double-double")]
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use elementary::Elementary;
pub use scalar::Scalar;
