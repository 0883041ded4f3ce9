//! Times of keys, and how one is found among them.

use crate::error::{ProfileError, check_finite, check_overflow};
use crate::range::Range;
use alloc::vec::Vec;

/// Rising times from 0 on, with a table of which lie in each of as many equal parts of the span as there are pieces.
///
/// A time is looked up in the table and among the few knots of its part: at nearly equal spacing in one step however many
/// there are, at the worst spacing by a binary search among all of them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Knots {
    times: Vec<f64>,
    /// How many inner knots lie before each part, and in the end how many there are.
    before: Vec<u32>,
    /// Parts in a unit of time.
    rate: f64,
}

impl Knots {
    /// The first time, and all times since then.
    ///
    /// Refuses fewer than two, times that are not finite and times that do not rise, also those that no longer do once
    /// the first is subtracted from them.
    pub(super) fn new(keys: impl ExactSizeIterator<Item = f64>) -> Result<(f64, Self), ProfileError> {
        if keys.len() < 2 {
            return Err(ProfileError::Count { what: "keys", found: keys.len(), needed: 2 });
        }
        if u32::try_from(keys.len()).is_err() {
            let range = Range::at_most(f64::from(u32::MAX));
            return Err(ProfileError::OutOfRange { what: "number of keys", value: keys.len() as f64, range });
        }
        let absolute: Vec<f64> = keys.collect();
        check_finite("time of a key", &absolute)?;
        check_rising(&absolute)?;
        let start = absolute[0];
        let times: Vec<f64> = absolute.into_iter().map(|time| time - start).collect();
        check_overflow("duration", &times[times.len() - 1..])?;
        check_rising(&times)?;
        let pieces = times.len() - 1;
        let mut knots =
            Self { before: Vec::with_capacity(pieces + 1), rate: pieces as f64 / times[pieces], times };
        for i in 1..pieces {
            let part = knots.part(knots.times[i]);
            // The parts up to that of this knot have all knots before it behind them.
            knots.before.resize(knots.before.len().max(part + 1), i as u32 - 1);
        }
        knots.before.resize(pieces + 1, pieces as u32 - 1);
        Ok((start, knots))
    }

    /// The times.
    #[inline]
    pub(super) fn times(&self) -> &[f64] {
        &self.times
    }

    /// How many pieces lie between them.
    #[inline]
    pub(super) fn pieces(&self) -> usize {
        self.times.len() - 1
    }

    /// The last time.
    #[inline]
    pub(super) fn end(&self) -> f64 {
        self.times[self.pieces()]
    }

    /// Whether a time lies within the span.
    #[inline]
    pub(super) fn span(&self, t: f64) -> bool {
        (0.0..=self.end()).contains(&t)
    }

    /// The piece that answers at a time within the span: the one that begins at a knot, the last at the end.
    #[inline]
    pub(super) fn piece(&self, t: f64) -> usize {
        self.search(t, |time| time <= t)
    }

    /// The piece that answers just before a time within the span: the one that ends at a knot, the first at the start.
    pub(super) fn piece_before(&self, t: f64) -> usize {
        self.search(t, |time| time < t)
    }

    #[inline]
    fn search(&self, t: f64, is_before: impl Fn(f64) -> bool) -> usize {
        let part = self.part(t);
        let (from, to) = (self.before[part] as usize, self.before[part + 1] as usize);
        from + self.times[from + 1..=to].partition_point(|&time| is_before(time))
    }

    /// The part of the span in which a time of it lies. It never falls as the time rises, also where products are
    /// rounded, and the search rests on nothing else.
    #[inline]
    fn part(&self, t: f64) -> usize {
        ((t * self.rate) as usize).min(self.pieces() - 1)
    }
}

fn check_rising(times: &[f64]) -> Result<(), ProfileError> {
    match times.windows(2).position(|pair| pair[1] <= pair[0]) {
        Some(i) => Err(ProfileError::Knots { index: i + 1, time: times[i + 1], before: times[i] }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_time_is_found_whatever_the_spacing() {
        let records: [Vec<f64>; 5] = [
            vec![3.0, 4.0],
            (0..50).map(f64::from).collect(),
            (0..60).map(|i| f64::from(i).exp2()).collect(),
            (0..50).map(|i| -f64::from(i).exp2()).rev().collect(),
            [0.0, 1e-300, 1e-9, 1.0, 1.0 + 1e-9, 1.5, 1e9, 1e9 + 1.0].into(),
        ];
        for record in records {
            let (start, knots) = Knots::new(record.iter().copied()).expect("rising");
            let times = knots.times().to_vec();
            for (i, pair) in times.windows(2).enumerate() {
                for t in [pair[0], pair[0].midpoint(pair[1]), pair[1].next_down()] {
                    assert_eq!(knots.piece(t), i, "{t} since {start}");
                }
                assert_eq!(knots.piece_before(pair[1]), i);
                assert_eq!(knots.piece_before(pair[0]), i.saturating_sub(1));
            }
            assert_eq!(knots.piece(knots.end()), knots.pieces() - 1);
        }
    }
}
