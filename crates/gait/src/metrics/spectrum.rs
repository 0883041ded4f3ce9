//! Smoothness as the length of a spectrum.

use super::NoValue;
use std::f64::consts::TAU;

/// The highest frequency that counts (Hz), and the share of the greatest amplitude that is still heard.
const HIGHEST: f64 = 10.0;
const HEARD: f64 = 0.05;
/// Zeros are added until there are 2⁴ times as many samples as the next power of two, for a fine spectrum.
const PADDING: u32 = 4;
/// The most samples: 32 MB of spectrum.
const MOST: usize = 1 << 17;
/// How far samples may be from equally spaced, relative: times are printed with few digits.
const EVEN: f64 = 0.01;

/// The spectral arc length of a speed profile: the length of the curve that its normalised amplitude spectrum draws,
/// negative; nearer to zero is smoother.
///
/// ```text
/// SPARC = −∫₀^ω_c √((1/ω_c)² + (dV̂/dω)²) dω      V̂(ω) = |V(ω)|/max |V|      ω_c: the last ω below 10 Hz with V̂ ≥ 0.05
/// ```
///
/// `time` (s) and `speed` (m/s) have one entry a sample.
///
/// # Source
///
/// Balasubramanian, Melendez-Calderon, Roby-Brami, Burdet (2015), On the analysis of movement smoothness, J. `NeuroEng`
/// Rehabil. 12:112, with the constants that are proposed there.
pub(super) fn spectral_arc_length(time: &[f64], speed: &[f64]) -> Result<f64, NoValue> {
    let samples = speed.len();
    if samples < 3 || time.len() != samples {
        return Err(NoValue::TooFewSamples);
    }
    if samples > MOST {
        return Err(NoValue::TooManySamples { most: MOST });
    }
    let step = (time[samples - 1] - time[0]) / (samples - 1) as f64;
    if time.windows(2).any(|pair| ((pair[1] - pair[0]) / step - 1.0).abs() > EVEN) {
        return Err(NoValue::UnevenSamples);
    }
    let size = samples.next_power_of_two() << PADDING;
    let (mut real, mut imaginary) = (vec![0.0; size], vec![0.0; size]);
    real[..samples].copy_from_slice(speed);
    transform(&mut real, &mut imaginary);
    let spacing = 1.0 / (step * size as f64);
    let below = ((HIGHEST / spacing).floor() as usize).min(size / 2);
    let amplitudes: Vec<f64> = (0..=below).map(|i| real[i].hypot(imaginary[i])).collect();
    let greatest = amplitudes.iter().copied().fold(0.0, f64::max);
    let heard = amplitudes.iter().rposition(|amplitude| *amplitude >= HEARD * greatest);
    let last = heard.filter(|last| *last > 0 && greatest > 0.0).ok_or(NoValue::TooFewSamples)?;
    let along = 1.0 / last as f64;
    let length = amplitudes[..=last].windows(2).map(|pair| along.hypot((pair[1] - pair[0]) / greatest));
    Ok(-length.sum::<f64>())
}

/// The discrete Fourier transform in place, by halves; the length is a power of two.
fn transform(real: &mut [f64], imaginary: &mut [f64]) {
    let size = real.len();
    let shift = usize::BITS - size.trailing_zeros();
    for i in 0..size {
        let mirrored = if size > 1 { i.reverse_bits() >> shift } else { 0 };
        if i < mirrored {
            real.swap(i, mirrored);
            imaginary.swap(i, mirrored);
        }
    }
    let mut half = 1;
    while half < size {
        let (mut cosines, mut sines) = (Vec::with_capacity(half), Vec::with_capacity(half));
        for k in 0..half {
            let (sine, cosine) = (-TAU * k as f64 / (2 * half) as f64).sin_cos();
            cosines.push(cosine);
            sines.push(sine);
        }
        for block in (0..size).step_by(2 * half) {
            for k in 0..half {
                let (a, b) = (block + k, block + k + half);
                let re = cosines[k] * real[b] - sines[k] * imaginary[b];
                let im = cosines[k] * imaginary[b] + sines[k] * real[b];
                (real[b], imaginary[b]) = (real[a] - re, imaginary[a] - im);
                (real[a], imaginary[a]) = (real[a] + re, imaginary[a] + im);
            }
        }
        half *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A speed at 131 samples a hundredth of a second apart, of s from 0 to 1.
    fn arc_length(speed: impl Fn(f64) -> f64) -> f64 {
        let time: Vec<f64> = (0..131).map(|i| f64::from(i) / 100.0).collect();
        let speed: Vec<f64> = (0..131).map(|i| speed(f64::from(i) / 130.0)).collect();
        spectral_arc_length(&time, &speed).expect("it moves")
    }

    #[test]
    fn it_is_that_of_the_plain_sums() {
        // By sums over all samples for each frequency, in another language.
        let minimum_jerk = |s: f64| 30.0 * s * s * (1.0 - s) * (1.0 - s);
        assert!((arc_length(minimum_jerk) + 1.403_230_019_413_241_4).abs() < 1e-12);
        let rough = |s: f64| minimum_jerk(s) + 1.2 * (3.0 * TAU * s).sin().abs() * s * (1.0 - s);
        assert!((arc_length(rough) + 1.404_826_729_526_334_4).abs() < 1e-12);
        // Neither how fast nor how far counts.
        assert!((arc_length(|s| 7.0 * minimum_jerk(s)) - arc_length(minimum_jerk)).abs() < 1e-12);
    }

    #[test]
    fn samples_that_have_no_spectrum_say_why() {
        assert_eq!(spectral_arc_length(&[0.0, 0.1], &[1.0; 2]), Err(NoValue::TooFewSamples));
        assert_eq!(spectral_arc_length(&[0.0, 0.1, 0.3], &[1.0; 3]), Err(NoValue::UnevenSamples));
        let many = vec![0.0; MOST + 1];
        assert_eq!(spectral_arc_length(&many, &many), Err(NoValue::TooManySamples { most: MOST }));
    }
}
