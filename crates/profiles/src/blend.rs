//! Blends, motions that go over into each other: one that fades into another ([`Blend::between`]), and several with weights that may
//! rise and fall ([`Blend::weighted`]).

mod answers;
mod breaks;
mod curve;
mod fade;
mod jet;
mod keeps;
mod layer;
mod piece;
mod shape;
mod zeros;

pub use curve::Blend;
pub(crate) use fade::Side;
pub use fade::{Fade, FadeKind, Leaving};
pub use keeps::Keeps;
pub use layer::Layer;
