//! Equally spaced nodes and their sixth-order central differences.

use std::ops::{Add, Mul, Sub};

/// What lies beyond the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ends {
    /// The nodes repeat.
    Periodic,
    /// The first and last node are at rest.
    Resting,
    /// Nothing is known: the rates of the three nodes at either end are those of the fourth.
    Open,
}

/// First-derivative weights over 60.
pub(crate) const FIRST: [f64; 7] = [-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0];
/// Second-derivative weights over 180.
pub(crate) const SECOND: [f64; 7] = [2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0];

/// Nodes `step` seconds apart.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    pub(crate) count: usize,
    pub(crate) step: f64,
    pub(crate) ends: Ends,
}

impl Grid {
    /// Index of the node `offset` after node `i`.
    #[inline]
    fn at(&self, i: usize, offset: isize) -> usize {
        let (j, n) = (i as isize + offset, self.count as isize);
        match self.ends {
            _ if (0..n).contains(&j) => j as usize,
            Ends::Periodic => j.rem_euclid(n) as usize,
            Ends::Resting | Ends::Open => j.clamp(0, n - 1) as usize,
        }
    }

    /// The node whose rate node `i` has.
    #[inline]
    fn differenced(&self, i: usize) -> usize {
        if self.ends == Ends::Open && self.count > 6 { i.clamp(3, self.count - 4) } else { i }
    }

    /// First derivative at node `i` of the values that `f` gives for nodes.
    #[inline]
    pub(crate) fn first<T>(&self, i: usize, f: impl Fn(usize) -> T) -> T
    where
        T: Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
    {
        let i = self.differenced(i);
        let pair = |k: isize| f(self.at(i, k)) - f(self.at(i, -k));
        let unit = 1.0 / (60.0 * self.step);
        pair(1) * (45.0 * unit) - pair(2) * (9.0 * unit) + pair(3) * unit
    }

    /// Second derivative at node `i` of the values that `f` gives for nodes.
    #[inline]
    pub(crate) fn second<T>(&self, i: usize, f: impl Fn(usize) -> T) -> T
    where
        T: Add<Output = T> + Mul<f64, Output = T>,
    {
        let i = self.differenced(i);
        let unit = 1.0 / (180.0 * self.step * self.step);
        let pair = |k: isize| (f(self.at(i, k)) + f(self.at(i, -k))) * (SECOND[(3 + k) as usize] * unit);
        f(i) * (SECOND[3] * unit) + pair(1) + pair(2) + pair(3)
    }

    /// First derivatives at node `i` of the rows that `f` gives for nodes.
    #[inline]
    pub(crate) fn first_of<'a, const D: usize>(
        &self,
        i: usize,
        f: impl Fn(usize) -> &'a [f64; D],
    ) -> [f64; D] {
        let i = self.differenced(i);
        let unit = 1.0 / (60.0 * self.step);
        let mut rates = [0.0; D];
        for (k, weight) in [(1, 45.0 * unit), (2, -9.0 * unit), (3, unit)] {
            let (after, before) = (f(self.at(i, k)), f(self.at(i, -k)));
            for d in 0..D {
                rates[d] += weight * (after[d] - before[d]);
            }
        }
        rates
    }
}
