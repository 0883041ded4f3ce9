//! The steps of a walk, their lengths, and the number of steps to a distance.

use super::course::Step;
use super::grounded::Grounded;
use super::numbers::{STEP_FACTORS, WalkNumbers};
use super::repeat;
use crate::smooth::stride::StridePlan;

/// Steps of a walk, each in the style of one of some strides of one figure.
pub(crate) struct Steps<'a> {
    pub(crate) strides: &'a [StridePlan],
    /// The stride in whose manner both feet stand at first.
    pub(crate) standing: usize,
    /// The stride that the walk is called after.
    pub(crate) steady: usize,
    pub(crate) whole: &'a [Step],
    pub(crate) numbers: WalkNumbers,
    /// What a cane bears at most, over the vertical force.
    pub(crate) cane_load: f64,
    /// A shorter walk of which the middle stride is repeated.
    pub(crate) planned: Option<&'a [Step]>,
    /// Ground that is not level, and what its contacts are gone with.
    pub(crate) ground: Option<&'a Grounded>,
}

impl Steps<'_> {
    /// `clock`, where all goes straight on and the stride from there on, and six steps on either side, are of one pace.
    pub(super) fn loop_at(&self, clock: Option<f64>) -> Option<f64> {
        let planned = self.planned.unwrap_or(self.whole);
        clock.filter(|clock| {
            let contact = (2.0 * clock) as usize;
            let around = &planned[contact.saturating_sub(6)..(contact + 8).min(planned.len())];
            planned.iter().all(|step| step.turn == 0.0)
                && around.windows(2).all(|pair| pair[0].pace == pair[1].pace)
        })
    }

    /// How many steps of a long walk are planned.
    pub(crate) fn repeated(steps: usize) -> Option<usize> {
        Some(repeat::planned(steps)).filter(|&planned| planned < steps)
    }
}

/// `n` steps of one pace, ahead.
pub(crate) fn even(n: usize, step_length: f64) -> Vec<Step> {
    factors(n).map(|factor| Step::along_an_arc(0, factor * step_length, 0.0)).collect()
}

/// Lengths of `n` steps over S: the first is shorter, and two shorter ones brake at the end.
pub(crate) fn factors(n: usize) -> impl Iterator<Item = f64> {
    let (first, before, last) = STEP_FACTORS;
    (0..n).map(move |i| match n - i {
        1 => last,
        2 if i == 0 => first.min(before),
        2 => before,
        _ if i == 0 => first,
        _ => 1.0,
    })
}

/// Number of steps for a distance, and the length S of the pace, so that the distance is met exactly: as few steps as need no
/// length above 1.02 of the default one. `lengths` are those of n steps over S, without the factors of the ends.
pub(crate) fn for_distance<L: IntoIterator<Item = f64>>(
    distance: f64,
    default: f64,
    lengths: impl Fn(usize) -> L,
) -> (usize, f64) {
    let total = |n: usize| factors(n).zip(lengths(n)).map(|(factor, length)| factor * length).sum::<f64>();
    // No fewer than if every step were whole.
    let mut n = ((distance / (1.02 * default)) as usize).max(1);
    while distance > 1.02 * default * total(n) {
        n += 1;
    }
    (n, distance / total(n))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_is_met_exactly_by_the_fewest_steps() {
        for distance in [0.1, 0.5, 0.9, 1.1, 2.0, 5.0, 123.4] {
            let (n, step) = for_distance(distance, 0.7, |n| std::iter::repeat_n(1.0, n));
            let sum: f64 = even(n, step).iter().map(|step| step.length).sum();
            assert!((sum - distance).abs() < 1e-12 * distance.max(1.0));
            assert!(step <= 1.02 * 0.7 + 1e-12);
            let fewer: f64 = factors(n - 1).sum();
            assert!(n == 1 || distance > 1.02 * 0.7 * fewer, "{distance} m in {n} steps");
        }
    }
}
