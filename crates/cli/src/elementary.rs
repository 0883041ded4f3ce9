//! Sines, exponentials and their like: those of the crate `libm`, by the names that the system's library has for them.
//!
//! IEEE 754 settles +, −, ×, ÷ and √ to the last bit, and leaves these to whoever writes them: two systems differ in the last digit, and a plan that is iterated
//! from them differs by more. WebAssembly has those of `libm`. As the linker takes the program's own names first, all that it is made of calls
//! these, and the same command gives the same bits on every Linux and in the studio's page (`studio/test/exact.mjs`). Some 2 % of a walk's time.
#![expect(
    unsafe_code,
    reason = "what replaces a function of the system has its name and its way to be called"
)]

macro_rules! of_one {
    ($kind:ty: $($name:ident)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(x: $kind) -> $kind {
            libm::$name(x)
        }
    )*};
}

macro_rules! of_two {
    ($kind:ty: $($name:ident)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(x: $kind, y: $kind) -> $kind {
            libm::$name(x, y)
        }
    )*};
}

of_one! { f64: sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp exp2 expm1 log log2 log10 log1p cbrt }
of_one! { f32: sinf cosf tanf asinf acosf atanf sinhf coshf tanhf asinhf acoshf atanhf expf exp2f expm1f logf log2f log10f log1pf cbrtf }
of_two! { f64: atan2 pow hypot }
of_two! { f32: atan2f powf hypotf }

/// Sine and cosine of one angle, which the compiler asks for together.
///
/// # Safety
///
/// Both places can be written.
#[unsafe(no_mangle)]
unsafe extern "C" fn sincos(x: f64, sine: *mut f64, cosine: *mut f64) {
    // SAFETY: as C's function of this name has it, both places are the caller's to be written.
    unsafe {
        sine.write(libm::sin(x));
        cosine.write(libm::cos(x));
    }
}

/// As [`sincos`], of half as many digits.
///
/// # Safety
///
/// Both places can be written.
#[unsafe(no_mangle)]
unsafe extern "C" fn sincosf(x: f32, sine: *mut f32, cosine: *mut f32) {
    // SAFETY: as C's function of this name has it, both places are the caller's to be written.
    unsafe {
        sine.write(libm::sinf(x));
        cosine.write(libm::cosf(x));
    }
}

#[cfg(test)]
mod tests {
    /// Of a hundred thousand numbers some are among those at which libraries differ: which of them is called cannot be seen otherwise.
    #[test]
    fn the_program_calls_its_own() {
        for i in 0..100_000 {
            let x = std::hint::black_box(f64::from(i).mul_add(1.234_567e-3, 1e-3));
            assert_eq!(x.sin().to_bits(), libm::sin(x).to_bits(), "sin {x}");
            assert_eq!(x.exp().to_bits(), libm::exp(x).to_bits(), "exp {x}");
            assert_eq!(x.atan2(2.0).to_bits(), libm::atan2(x, 2.0).to_bits(), "atan2 {x}");
            assert_eq!(x.hypot(0.7).to_bits(), libm::hypot(x, 0.7).to_bits(), "hypot {x}");
            let (sine, cosine) = x.sin_cos();
            assert_eq!(
                (sine.to_bits(), cosine.to_bits()),
                (libm::sin(x).to_bits(), libm::cos(x).to_bits()),
                "sin_cos {x}"
            );
        }
    }
}
