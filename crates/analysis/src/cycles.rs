//! Strides of a motion, laid over each other.

use crate::ground::Stances;

/// Parts of a stride, both ends among them: every percent.
pub const PERCENTS: usize = 101;

/// The mean of a quantity over strides, and how far they spread.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeanCycle {
    /// Mean at every percent of the stride.
    pub mean: Vec<f64>,
    /// Standard deviation there, of n − 1; zero of one stride.
    pub deviation: Vec<f64>,
}

/// From when until when (s) each stride of a foot lasts: from a touch-down to the next one.
///
/// A stance that the motion begins with has no touch-down.
#[doc(alias = "gait cycles")]
pub fn strides(stances: &Stances, foot: usize, time: &[f64]) -> Vec<[f64; 2]> {
    let first = time.first().copied().unwrap_or_default();
    let own = stances.list.iter().filter(|stance| stance.foot == foot && stance.start > first);
    let downs: Vec<f64> = own.map(|stance| stance.start).collect();
    downs.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Lays the strides of `values`, one for each of the rising times (s), over each other: each is cut to [`PERCENTS`] parts, straight
/// between samples. Empty without strides or samples.
///
/// ```
/// use solaris_analysis::cycles::mean_cycle;
///
/// let time: Vec<f64> = (0..=20).map(|i| 0.1 * f64::from(i)).collect();
/// let once_more: Vec<f64> = time.iter().map(|t| if *t < 1.0 { 1.0 } else { 3.0 }).collect();
/// let cycle = mean_cycle(&time, &once_more, &[[0.0, 0.9], [1.0, 1.9]]);
/// assert_eq!((cycle.mean[50], cycle.deviation[50]), (2.0, 2.0_f64.sqrt()));
/// ```
#[doc(alias = "time normalisation")]
pub fn mean_cycle(time: &[f64], values: &[f64], strides: &[[f64; 2]]) -> MeanCycle {
    if strides.is_empty() || time.is_empty() || time.len() != values.len() {
        return MeanCycle::default();
    }
    let count = strides.len() as f64;
    let part = |percent: usize| {
        let share = percent as f64 / (PERCENTS - 1) as f64;
        let all = || strides.iter().map(move |[from, to]| at(time, values, from + share * (to - from)));
        let mean = all().sum::<f64>() / count;
        let squares: f64 = all().map(|value| (value - mean).powi(2)).sum();
        (mean, (squares / (count - 1.0).max(1.0)).sqrt())
    };
    let (mean, deviation) = (0..PERCENTS).map(part).unzip();
    MeanCycle { mean, deviation }
}

/// The value at a time, straight between samples; the ends' beyond them.
fn at(time: &[f64], values: &[f64], when: f64) -> f64 {
    let after = time.partition_point(|time| *time < when);
    match (after.checked_sub(1), values.get(after)) {
        (Some(before), Some(value)) => {
            let share = (when - time[before]) / (time[after] - time[before]);
            values[before] + share * (value - values[before])
        }
        (None, Some(value)) => *value,
        (_, None) => values[values.len() - 1],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ground::Stance;
    use solaris_model::Vector3;

    #[test]
    fn a_stride_lasts_from_touch_down_to_touch_down() {
        let stance = |foot, start, end| Stance { foot, start, end };
        let list = vec![
            stance(0, 0.0, 0.4),
            stance(1, 0.3, 0.9),
            stance(0, 0.8, 1.4),
            stance(0, 1.9, 2.4),
            stance(0, 2.9, 3.0),
        ];
        let stances =
            Stances { list, belt: Vector3::zeros(), level: 0.0, footings: Vec::new(), method: "hand" };
        assert_eq!(strides(&stances, 0, &[0.0, 3.0]), [[0.8, 1.9], [1.9, 2.9]]);
        assert!(strides(&stances, 1, &[0.0, 3.0]).is_empty());
    }

    #[test]
    fn strides_of_other_lengths_are_the_same_in_percent() {
        let time: Vec<f64> = (0..=300).map(|i| 0.01 * f64::from(i)).collect();
        // A ramp from 0 to 1 over each stride.
        let values: Vec<f64> = time.iter().map(|t| if *t < 1.0 { *t } else { (t - 1.0) / 2.0 }).collect();
        let cycle = mean_cycle(&time, &values, &[[0.0, 0.99], [1.0, 2.98]]);
        assert_eq!((cycle.mean.len(), cycle.deviation.len()), (101, 101));
        for percent in [0, 25, 70, 100] {
            assert!((cycle.mean[percent] - 0.0099 * percent as f64).abs() < 1e-9, "{}", cycle.mean[percent]);
            assert!(cycle.deviation[percent] < 1e-9);
        }
    }

    #[test]
    fn one_stride_does_not_spread() {
        let cycle = mean_cycle(&[0.0, 1.0], &[0.0, 4.0], &[[0.0, 1.0]]);
        assert_eq!((cycle.mean[25], cycle.deviation[25]), (1.0, 0.0));
        assert!(mean_cycle(&[], &[], &[[0.0, 1.0]]).mean.is_empty());
    }
}
