//! Smoothness of the way of the centre of mass.

use super::spectrum::spectral_arc_length;
use super::stride::Steps;
use super::tracks::Tracks;
use super::{Metric, MetricsInput, NoValue};
use nalgebra::Vector3;
use solaris_profiles::NaturalSpline;

/// What is slower than this (m/s) does not move.
const AT_REST: f64 = 1e-6;

pub(super) fn metrics(_: &MetricsInput<'_>, tracks: &Tracks<'_>, steps: &Steps) -> Vec<Metric> {
    let span = steps.stride.map_or(tracks.span(), |stride| stride.span);
    let samples = tracks.samples(span);
    let jerks = jerks(tracks);
    let squares = jerks.and_then(|jerks| {
        let (time, jerks) = (&tracks.time[samples.clone()], &jerks[samples.clone()]);
        if time.len() < 3 { Err(NoValue::TooFewSamples) } else { Ok((integral(time, jerks), length(time))) }
    });
    let speeds: Vec<f64> = tracks.velocity.iter().map(|v| (v - tracks.belt).norm()).collect();
    let fastest = speeds[samples].iter().copied().fold(0.0, f64::max);
    let rms = squares.map(|(squares, duration)| (squares / duration).sqrt());
    let log = squares.and_then(|(squares, duration)| log_dimensionless_jerk(squares, duration, fastest));
    let arc =
        if fastest > AT_REST { spectral_arc_length(tracks.time, &speeds) } else { Err(NoValue::AtRest) };
    vec![
        Metric::new(("jerk_rms_m_s3", "jerk of the centre of mass, rms", "m/s³"), rms, None),
        Metric::new(("log_dimensionless_jerk", "log dimensionless jerk", ""), log, None),
        Metric::new(("spectral_arc_length", "spectral arc length, whole motion", ""), arc, None),
    ]
}

/// The jerk of the centre of mass at the samples (m/s³): the rate of the natural quintic spline through its acceleration.
fn jerks(tracks: &Tracks<'_>) -> Result<Vec<Vector3<f64>>, NoValue> {
    let mut jerks = vec![Vector3::zeros(); tracks.time.len()];
    for k in 0..3 {
        let along: Vec<f64> = tracks.acceleration.iter().map(|a| a[k]).collect();
        let curve = NaturalSpline::new(tracks.time, &along).map_err(|_| NoValue::TooFewSamples)?;
        jerks.iter_mut().zip(curve.nodes()).for_each(|(jerk, node)| jerk[k] = node.velocity);
    }
    Ok(jerks)
}

fn length(time: &[f64]) -> f64 {
    time.last().zip(time.first()).map_or(0.0, |(last, first)| last - first)
}

/// Integral of the squares, by trapezoids.
fn integral(time: &[f64], jerks: &[Vector3<f64>]) -> f64 {
    let trapezoid =
        |i: usize| (time[i + 1] - time[i]) * (jerks[i].norm_squared() + jerks[i + 1].norm_squared()) / 2.0;
    (0..time.len().saturating_sub(1)).map(trapezoid).sum()
}

/// Smoothness that depends neither on how fast nor on how far something goes; nearer to zero is smoother. A movement of
/// minimum jerk from rest to rest has −ln 204.8 = −5.32. Over strides it compares those of different people and paces; over whole
/// motions only such of the same kind, since it falls with the duration.
///
/// ```text
/// LDLJ = −ln (T³/v_peak² ∫ |x‴|² dt)
/// ```
///
/// `squares` is the integral (m²/s⁵), `duration` T (s), `fastest` the greatest speed (m/s).
///
/// # Source
///
/// Balasubramanian, Melendez-Calderon, Roby-Brami, Burdet (2015), On the analysis of movement smoothness, J. `NeuroEng`
/// Rehabil. 12:112, the measure from velocity.
fn log_dimensionless_jerk(squares: f64, duration: f64, fastest: f64) -> Result<f64, NoValue> {
    let dimensionless = duration.powi(3) / fastest.powi(2) * squares;
    if fastest > AT_REST && dimensionless > 0.0 { Ok(-dimensionless.ln()) } else { Err(NoValue::AtRest) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minimum_jerk_has_its_closed_form() {
        // x = D S5(t/T): jerk D/T³ (60 − 360 s + 360 s²), its square's integral 720 D²/T⁵; v_peak = 1.875 D/T.
        let (distance, duration, n) = (0.7, 1.3, 2000);
        let time: Vec<f64> = (0..=n).map(|i| duration * f64::from(i) / f64::from(n)).collect();
        let jerk = |t: &f64| {
            let s = t / duration;
            Vector3::new(distance / duration.powi(3) * (60.0 - 360.0 * s + 360.0 * s * s), 0.0, 0.0)
        };
        let squares = integral(&time, &time.iter().map(jerk).collect::<Vec<_>>());
        let found = log_dimensionless_jerk(squares, duration, 1.875 * distance / duration).expect("it moves");
        assert!((found + 204.8_f64.ln()).abs() < 1e-5, "{found}");
    }
}
