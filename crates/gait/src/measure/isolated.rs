//! Isolated peaks: forces that only one sample has.

use super::Peak;
use crate::body::FEET;
use crate::error::MeasureError;
use nalgebra::Vector3;
use solaris_model::Motion;

/// What a sample beside a peak comes to at least, as a part of it, where the peak is the motion's.
const NEAR: f64 = 0.5;

/// The greatest force of the ground on one foot in some direction, where only one sample has it: neither of the two beside it
/// comes to half of it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "spike")]
#[doc(alias = "outlier")]
pub struct IsolatedPeak {
    /// `upward`, `backward` or `forward`.
    pub direction: &'static str,
    /// The force (N) and when it occurs (s).
    pub peak: Peak,
    /// The greater one of the two samples beside it (N); less than 0 where both point the other way.
    pub neighbour: f64,
}

/// The greatest forces upward, backward and forward on one foot, those of them that only one sample has: such a force belongs to
/// an instant at which the motion is not smooth, and other rates find another one.
///
/// # Errors
///
/// A motion without ground reactions on both feet.
#[doc(alias = "lone_forces")]
#[doc(alias = "spike")]
#[doc(alias = "outlier")]
pub fn isolated_peaks(motion: &Motion) -> Result<Vec<IsolatedPeak>, MeasureError> {
    type Part = fn(&Vector3<f64>) -> f64;
    let parts: [(&'static str, Part); 3] =
        [("upward", |force| force.y), ("backward", |force| -force.z), ("forward", |force| force.z)];
    let mut all = Vec::new();
    for (direction, part) in parts {
        let on = |foot: &str| -> Result<Vec<f64>, MeasureError> {
            let track = motion.contact(foot);
            let track = track.ok_or(MeasureError::NothingToMeasure { what: "contacts of both feet" })?;
            Ok(track.samples.iter().map(|contact| part(&contact.force)).collect())
        };
        let feet = [on(FEET[0])?, on(FEET[1])?];
        all.extend(isolated(&feet).map(|(sample, value, neighbour)| {
            let peak = Peak { value, time: motion.time()[sample] };
            IsolatedPeak { direction, peak, neighbour }
        }));
    }
    Ok(all)
}

/// The greatest of some series where it is alone: its index, its value, and the greater of the two beside it.
fn isolated(series: &[Vec<f64>]) -> Option<(usize, f64, f64)> {
    let all = series.iter().flat_map(|values| (0..values.len()).map(move |i| (values, i)));
    let (values, sample) = all.max_by(|(a, i), (b, j)| a[*i].total_cmp(&b[*j]))?;
    // Of an end nobody knows what is beyond.
    let (before, after) = (values.get(sample.checked_sub(1)?)?, values.get(sample + 1)?);
    let (value, neighbour) = (values[sample], before.max(*after));
    (value > 0.0 && neighbour < NEAR * value).then_some((sample, value, neighbour))
}

#[cfg(test)]
mod tests {
    use super::isolated;

    #[test]
    fn a_sample_alone_is_found_and_one_with_neighbours_is_not() {
        let rest = vec![0.0; 5];
        let of = |values: [f64; 5]| isolated(&[rest.clone(), values.to_vec()]);
        assert_eq!(of([1.0, 2.0, 9.0, -3.0, 1.0]), Some((2, 9.0, 2.0)));
        assert_eq!(of([0.0, -4.0, 9.0, -3.0, 1.0]), Some((2, 9.0, -3.0)));
        // A peak with a flank, a step, an end, nothing at all, no number of samples.
        assert_eq!(of([1.0, 5.0, 9.0, 2.0, 1.0]), None);
        assert_eq!(of([9.0, 9.0, 9.0, 0.0, 0.0]), None);
        assert_eq!(of([9.0, 1.0, 0.0, 0.0, 0.0]), None);
        assert_eq!(of([0.0; 5]), None);
        assert_eq!(isolated(&[Vec::new(), Vec::new()]), None);
        // The other foot has a greater one, with neighbours.
        assert_eq!(isolated(&[vec![0.0, 8.0, 9.0, 8.0, 0.0], vec![0.0, 0.0, 7.0, 0.0, 0.0]]), None);
    }
}
