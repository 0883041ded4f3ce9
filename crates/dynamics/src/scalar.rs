//! The scalars that the recursions are written over: [`Scalar`] says what one has to do, and each of the others answers one
//! question through the very same code.
//!
//! | scalar | holds | for |
//! |---|---|---|
//! | `f64`, `f32` | itself | the answer |
//! | [`Dual`] | a value and its derivatives along several directions | exact derivatives of any operation |
//! | [`Lanes`] | several states | several answers in one pass |
//! | `Counted` (feature `counted`) | a value, with a count beside it | how many operations an answer takes |
//! | `DoubleDouble` (feature `double-double`) | 32 digits | how many digits of an answer are right |
//!
//! All but [`Lanes`] are those of the crate `solaris-scalar`.

mod lanes;

pub use lanes::Lanes;
#[cfg(feature = "double-double")]
pub use solaris_scalar::DoubleDouble;
#[cfg(feature = "counted")]
pub use solaris_scalar::{Counted, Operations};
pub use solaris_scalar::{Dual, Elementary, Scalar};
