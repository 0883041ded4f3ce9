//! Sine and cosine without a call or a branch, so that a loop over many angles runs in vector registers.

/// Angles up to this (rad) are reduced here; the rest, and what is not finite, are left to the standard library.
const LARGEST: f64 = 1e6;

/// Whether [`sin_cos`] may be asked.
#[inline]
pub(crate) fn is_moderate(angle: f64) -> bool {
    angle.abs() <= LARGEST
}

/// `(r, n)`: the angle less `n` quarter turns, and the low bits of `n`, for an angle of at most [`LARGEST`].
///
/// The quarter turn is subtracted in two parts (Cody and Waite). The first has 33 bits, so that its product with `n` and
/// the difference are exact; together they have 86.
#[inline]
fn reduce(angle: f64) -> (f64, u64) {
    /// Added and taken away again, it leaves the nearest whole number, and that number's bits at the low end.
    const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 · 2⁵²
    const QUARTER_TURN_HIGH: f64 = f64::from_bits(0x3ff9_21fb_5440_0000);
    const QUARTER_TURN_LOW: f64 = f64::from_bits(0x3dd0_b461_1a62_6331);
    let shifted = angle * core::f64::consts::FRAC_2_PI + ROUND;
    let turns = shifted - ROUND;
    ((angle - turns * QUARTER_TURN_HIGH) - turns * QUARTER_TURN_LOW, shifted.to_bits())
}

/// Exchanges and signs sine and cosine of the rest by the number of quarter turns.
#[inline]
fn turn_back(sine: f64, cosine: f64, turns: u64) -> (f64, f64) {
    let exchange = 0_u64.wrapping_sub(turns & 1);
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    let difference = (s ^ c) & exchange;
    let negative_sine = (turns & 2) << 62;
    let negative_cosine = (turns.wrapping_add(1) & 2) << 62;
    (f64::from_bits(s ^ difference ^ negative_sine), f64::from_bits(c ^ difference ^ negative_cosine))
}

/// Sine and cosine of a moderate angle (rad), within 1.5 units in the 16th digit.
///
/// # Source
///
/// The polynomials for |r| ≤ π/4 are those of Sun's fdlibm (`k_sin.c`, `k_cos.c`), with errors below 2⁻⁵⁷.
#[inline]
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
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
    let sine = r + r * z * ((S[0] + z * S[1]) + w * ((S[2] + z * S[3]) + w * (S[4] + z * S[5])));
    // 1 − z/2 loses its last bits; `(1 − u) − z/2` gives them back.
    let half = z * 0.5;
    let u = 1.0 - half;
    let cosine =
        u + (((1.0 - u) - half) + w * ((C[0] + z * C[1]) + w * ((C[2] + z * C[3]) + w * (C[4] + z * C[5]))));
    turn_back(sine, cosine, turns)
}

/// Sine and cosine of a moderate angle (rad) to single precision: reduced and evaluated in double precision with fewer
/// terms, rounded once.
///
/// # Source
///
/// The polynomials are those of FreeBSD's `k_sinf.c`, `k_cosf.c`: errors below 2⁻³⁴.
#[inline]
pub(crate) fn sin_cos_single(angle: f32) -> (f32, f32) {
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
    let (r, turns) = reduce(f64::from(angle));
    let z = r * r;
    let w = z * z;
    let sine = r + r * z * ((S[0] + z * S[1]) + w * (S[2] + z * S[3]));
    let cosine = 1.0 + z * ((C[0] + z * C[1]) + w * (C[2] + z * C[3]));
    let (s, c) = turn_back(sine, cosine, turns);
    (s as f32, c as f32)
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
            let ((s, c), (t, d)) = (sin_cos(x), x.sin_cos());
            worst.max((s - t).abs()).max((c - d).abs())
        });
        assert!(worst < 2.3e-16, "{worst:e}");
    }

    #[test]
    fn single_precision_agrees_with_the_standard_library() {
        let worst = angles().fold(0.0_f64, |worst, x| {
            let x = x as f32;
            let ((s, c), (t, d)) = (sin_cos_single(x), f64::from(x).sin_cos());
            worst.max((f64::from(s) - t).abs()).max((f64::from(c) - d).abs())
        });
        assert!(worst < 3.1e-8, "{worst:e}");
    }

    #[test]
    fn small_angles_keep_their_digits() {
        let (s, c) = sin_cos(1e-9);
        assert_eq!((s.to_bits(), c.to_bits()), (1e-9_f64.to_bits(), 1.0_f64.to_bits()));
    }
}
