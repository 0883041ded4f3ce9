//! Curves that are given by their velocity.
//!
//! | curve | velocity | ends at |
//! |---|---|---|
//! | [`Line`] | from v₀ to v₁ along a straight line | x₀ + (v₀ + v₁)·T/2 |
//! | [`Circle`] | from v₀ to v₁ along an arc of a circle through a third point | where the arc leads |
//! | [`Faired`] | from rest along a sine to V, and back to rest | x₀ + V·(2T₁/π + (T₂ − T₁) + 2(T − T₂)/π) |
//!
//! The position at the end follows; `reaching` of the first and the last finds the velocity that leads to a position,
//! for which the thesis has no formula.

mod circle;
mod faired;
mod line;

pub use circle::Circle;
pub use faired::Faired;
pub use line::Line;
