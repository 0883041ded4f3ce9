//! Kernels in the machine's wider instructions, where it has them: the same operations in the same order, and so the same bits.
//!
//! The compiler joins no multiplication with an addition unless it is told to. What is gained are more registers, of which each holds
//! more, and instructions that leave their operands alone.

#![allow(unsafe_code, reason = "instructions may be asked only of machines that have them")]

use crate::scalar::Scalar;

/// Runs `f` with all that is compiled into it written in the best instructions that the machine has, if `T` gains by them.
#[cfg(all(target_arch = "x86_64", feature = "dispatch"))]
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn wide<T: Scalar, A>(f: impl FnOnce() -> A) -> A {
    use std::arch::is_x86_feature_detected as has;

    #[target_feature(enable = "avx2")]
    fn with_avx2<A>(f: impl FnOnce() -> A) -> A {
        f()
    }
    #[target_feature(enable = "avx2,avx512f,avx512dq,avx512vl")]
    fn with_avx512<A>(f: impl FnOnce() -> A) -> A {
        f()
    }
    if !T::IS_FLOAT || !has!("avx2") {
        f()
    } else if has!("avx512f") && has!("avx512dq") && has!("avx512vl") {
        // SAFETY: the machine has all of them.
        unsafe { with_avx512(f) }
    } else {
        // SAFETY: the machine has AVX2.
        unsafe { with_avx2(f) }
    }
}

/// Runs `f`.
#[cfg(not(all(target_arch = "x86_64", feature = "dispatch")))]
#[allow(clippy::extra_unused_type_parameters, reason = "what gains by wider instructions is asked elsewhere")]
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn wide<T: Scalar, A>(f: impl FnOnce() -> A) -> A {
    f()
}
