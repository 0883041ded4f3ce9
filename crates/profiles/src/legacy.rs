//! Curves that are kept for comparison with what was made by them; there are better ones.

mod hyperbolic;

pub use hyperbolic::Hyperbolic;
