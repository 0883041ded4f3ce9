//! Vector registers as scalars: as many states side by side as one register holds.
//!
//! Registers are there where the machine's instructions are known ([`registers`], x86-64); elsewhere a number is a register with one lane.

#[cfg(not(target_arch = "x86_64"))]
mod plain;
#[cfg(target_arch = "x86_64")]
mod registers;
#[cfg(target_arch = "x86_64")]
mod x86;

#[cfg(not(target_arch = "x86_64"))]
pub(super) use plain::Plain;
#[cfg(target_arch = "x86_64")]
pub(super) use registers::{Avx2, Avx512, Doubles2, Doubles4, Doubles8, Singles4, Singles8, Singles16, Sse2};

use crate::scalar::Scalar;

/// A register as a scalar of the recursions, whose lanes are states.
pub(super) trait Register: Scalar + Send + Sync {
    /// The proof that the machine has its instructions.
    type Token: Token;
    /// What each lane holds.
    type Lane: Scalar + Send + Sync;

    /// How many lanes there are.
    const LANES: usize;

    /// The lanes.
    fn lanes(&self) -> &[Self::Lane];

    /// The lanes, to be written.
    fn lanes_mut(&mut self) -> &mut [Self::Lane];

    /// As many registers as each has lanes, with lane `j` of the `i`th in place of lane `i` of the `j`th.
    fn transposed(square: &[Self]) -> impl AsRef<[Self]> + use<Self>;
}

/// The proof that the machine has some instructions.
pub(super) trait Token: Copy + Send + Sync + 'static {
    /// The proof, if it has them.
    fn new() -> Option<Self>;

    /// Asks for numbers ahead of their use, where the machine can.
    fn ahead<F>(self, _: &[F]) {}

    /// Runs `f`, with all that is compiled into it written in these instructions.
    fn run<A>(self, f: impl FnOnce() -> A) -> A;
}
