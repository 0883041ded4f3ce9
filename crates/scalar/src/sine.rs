//! Sine and cosine without a call or a branch, of one angle or of several side by side: whatever can be written over them
//! stays in vector registers.

use crate::Scalar;

/// Angles up to this (rad) are reduced here; the rest, and what is not finite, are left to the standard library.
pub const MODERATE: f64 = 1e6;

/// A number in double precision, or several, whose bits can be seen.
pub trait Bits: Scalar {
    /// Exchanges and signs the sine and cosine of a rest by the quarter turns that were taken off; `self` is their number, a
    /// whole one, plus 1.5 · 2⁵², so that its lowest bits are those of the number.
    fn turn_back(self, sine: Self, cosine: Self) -> (Self, Self);
}

impl Bits for f64 {
    #[inline]
    fn turn_back(self, sine: Self, cosine: Self) -> (Self, Self) {
        let (turns, s, c) = (self.to_bits(), sine.to_bits(), cosine.to_bits());
        let exchange = 0_u64.wrapping_sub(turns & 1);
        let difference = (s ^ c) & exchange;
        let negative_sine = (turns & 2) << 62;
        let negative_cosine = (turns.wrapping_add(1) & 2) << 62;
        (Self::from_bits(s ^ difference ^ negative_sine), Self::from_bits(c ^ difference ^ negative_cosine))
    }
}

/// Whether [`sin_cos`] may be asked.
#[inline]
pub(crate) fn is_moderate(angle: f64) -> bool {
    angle.abs() <= MODERATE
}

/// `(r, n)`: the angle less `n` quarter turns, and `n` as [`Bits::turn_back`] takes it, for an angle of at most [`MODERATE`].
///
/// The quarter turn is subtracted in two parts (Cody and Waite). The first has 33 bits, so that its product with `n` and
/// the difference are exact; together they have 86.
#[inline(always)]
fn reduce<T: Bits>(angle: T) -> (T, T) {
    /// Added and taken away again, it leaves the nearest whole number, and that number's bits at the low end.
    const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 · 2⁵²
    const QUARTER_TURN_HIGH: f64 = f64::from_bits(0x3ff9_21fb_5440_0000);
    const QUARTER_TURN_LOW: f64 = f64::from_bits(0x3dd0_b461_1a62_6331);
    let round = T::from_f64(ROUND);
    let shifted = angle.times_plus(T::from_f64(core::f64::consts::FRAC_2_PI), round);
    let turns = shifted - round;
    let rest = turns.times_from(T::from_f64(QUARTER_TURN_HIGH), angle);
    (turns.times_from(T::from_f64(QUARTER_TURN_LOW), rest), shifted)
}

/// `a + x·b`
#[inline(always)]
fn line<T: Scalar>(x: T, a: f64, b: f64) -> T {
    x.times_plus(T::from_f64(b), T::from_f64(a))
}

/// `a₀ + z·a₁ + w·(a₂ + z·a₃ + w·(a₄ + z·a₅))`
#[inline(always)]
fn powers<T: Scalar>(z: T, w: T, a: &[f64; 6]) -> T {
    let last = w.times_plus(line(z, a[4], a[5]), line(z, a[2], a[3]));
    w.times_plus(last, line(z, a[0], a[1]))
}

/// `a₀ + z·a₁ + w·(a₂ + z·a₃)`
#[inline(always)]
fn few_powers<T: Scalar>(z: T, w: T, a: &[f64; 4]) -> T {
    w.times_plus(line(z, a[2], a[3]), line(z, a[0], a[1]))
}

/// Sine and cosine of a moderate angle (rad), within 1.5 units in the 16th digit.
///
/// # Source
///
/// The polynomials for |r| ≤ π/4 are those of Sun's fdlibm (`k_sin.c`, `k_cos.c`), with errors below 2⁻⁵⁷.
#[inline(always)]
pub fn sin_cos<T: Bits>(angle: T) -> (T, T) {
    const S: [f64; 6] = [
        -1.666_666_666_666_663_2e-1,
        8.333_333_333_322_49e-3,
        -1.984_126_982_985_795e-4,
        2.755_731_370_707_006_8e-6,
        -2.505_076_025_340_686_3e-8,
        1.589_690_995_211_55e-10,
    ];
    const C: [f64; 6] = [
        4.166_666_666_666_66e-2,
        -1.388_888_888_887_411e-3,
        2.480_158_728_947_673e-5,
        -2.755_731_435_139_066_3e-7,
        2.087_572_321_298_175e-9,
        -1.135_964_755_778_819_5e-11,
    ];
    let (r, turns) = reduce(angle);
    let z = r * r;
    let w = z * z;
    let sine = (r * z).times_plus(powers(z, w, &S), r);
    // 1 − z/2 loses its last bits; `(1 − u) − z/2` gives them back.
    let half = z * T::from_f64(0.5);
    let u = T::one() - half;
    let cosine = u + w.times_plus(powers(z, w, &C), (T::one() - u) - half);
    turns.turn_back(sine, cosine)
}

/// Sine and cosine of a moderate angle (rad) to single precision: reduced and evaluated in double precision with fewer
/// terms, to be rounded once.
///
/// # Source
///
/// The polynomials are those of FreeBSD's `k_sinf.c`, `k_cosf.c`: errors below 2⁻³⁴.
#[inline(always)]
pub fn sin_cos_single<T: Bits>(angle: T) -> (T, T) {
    const S: [f64; 4] = [
        -0.166_666_666_416_265_24,
        0.008_333_329_385_889_463,
        -0.000_198_393_348_360_966_32,
        2.718_311_493_989_822e-6,
    ];
    const C: [f64; 4] = [
        -0.499_999_997_251_031,
        0.041_666_623_323_739_06,
        -0.001_388_676_377_460_993,
        2.439_044_879_627_741e-5,
    ];
    let (r, turns) = reduce(angle);
    let z = r * r;
    let w = z * z;
    let sine = (r * z).times_plus(few_powers(z, w, &S), r);
    let cosine = z.times_plus(few_powers(z, w, &C), T::one());
    turns.turn_back(sine, cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A million angles of every size, multiples of the eighth turn and their neighbours among them.
    fn angles() -> impl Iterator<Item = f64> {
        let grid = (-200_000..200_000).flat_map(|i| {
            let corner = f64::from(i) * core::f64::consts::FRAC_PI_4;
            [corner, corner.next_up(), corner.next_down()]
        });
        let spread = (0..400_000).map(|i| {
            let x = f64::from(i) * 0.618_033_988_749_895;
            x.fract().powi(5) * 1e6 * if i % 2 == 0 { 1.0 } else { -1.0 }
        });
        grid.chain(spread).chain([0.0, -0.0, 1e-300, 1e-8, 1e6, -1e6])
    }

    #[test]
    fn double_precision_agrees_with_the_standard_library() {
        let worst = angles().fold(0.0_f64, |worst, x| {
            let ((s, c), (t, d)) = (sin_cos(x), f64::sin_cos(x));
            worst.max((s - t).abs()).max((c - d).abs())
        });
        assert!(worst < 2.3e-16, "{worst:e}");
    }

    #[test]
    fn single_precision_agrees_with_the_standard_library() {
        let worst = angles().fold(0.0_f64, |worst, x| {
            let x = x as f32;
            let ((s, c), (t, d)) = (sin_cos_single(f64::from(x)), f64::sin_cos(f64::from(x)));
            let (s, c) = (f64::from(s as f32), f64::from(c as f32));
            worst.max((s - t).abs()).max((c - d).abs())
        });
        assert!(worst < 3.1e-8, "{worst:e}");
    }

    #[test]
    fn small_angles_keep_their_digits() {
        let (s, c) = sin_cos(1e-9_f64);
        assert_eq!((s.to_bits(), c.to_bits()), (1e-9_f64.to_bits(), 1.0_f64.to_bits()));
    }
}
