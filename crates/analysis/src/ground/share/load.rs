//! The loading curve of a stance: a foot takes weight over, bears it and gives it back.

use crate::ground::Stance;
use solaris_profiles::step::cubic;

/// A stance, and when it has its full share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Load {
    pub(super) stance: Stance,
    /// From when to when (s).
    pub(super) full: (f64, f64),
}

impl Load {
    /// Of each stance: it takes over until the first of those that stand when it comes has left, and gives back from
    /// when the last of those came that stay when it leaves; neither beyond its own middle.
    pub(super) fn all(stances: &[Stance]) -> Vec<Self> {
        let full = |own: &Stance| {
            let others = || stances.iter().filter(|other| other.foot != own.foot);
            let middle = own.start.midpoint(own.end);
            let there = others().filter(|other| other.start < own.start && other.end > own.start);
            let from = there.map(|other| other.end).reduce(f64::min).map_or(own.start, |end| end.min(middle));
            let stay = others().filter(|other| other.start < own.end && other.end > own.end);
            let to =
                stay.map(|other| other.start).reduce(f64::max).map_or(own.end, |start| start.max(middle));
            (from, to)
        };
        stances.iter().map(|stance| Self { stance: *stance, full: full(stance) }).collect()
    }

    /// Whether it comes while others stand.
    pub(super) fn comes(&self) -> bool {
        self.full.0 > self.stance.start
    }

    /// Whether it leaves while others stay.
    pub(super) fn leaves(&self) -> bool {
        self.full.1 < self.stance.end
    }

    /// Its weight among those that stand at `t` (s), 0 to 1; 0 where it does not stand.
    pub(super) fn weight(&self, t: f64) -> f64 {
        let Stance { start, end, .. } = self.stance;
        if !(start..=end).contains(&t) {
            return 0.0;
        }
        let taken = if self.comes() { cubic((t - start) / (self.full.0 - start)).position } else { 1.0 };
        let kept = if self.leaves() { cubic((end - t) / (end - self.full.1)).position } else { 1.0 };
        taken * kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn in_double_support_two_weights_add_up_to_one() {
        let stance = |foot, start, end| Stance { foot, start, end };
        let loads = Load::all(&[stance(0, 0.0, 1.0), stance(1, 0.8, 1.8), stance(0, 1.6, 2.6)]);
        assert_eq!(loads[1].full, (1.0, 1.6));
        for i in 0..=26 {
            let t = f64::from(i) * 0.1;
            let sum: f64 = loads.iter().map(|load| load.weight(t)).sum();
            assert_relative_eq!(sum, 1.0, epsilon = 1e-12);
        }
        assert_relative_eq!(loads[0].weight(0.9), 0.5, epsilon = 1e-12);
    }

    #[test]
    fn a_tap_beside_a_foot_that_stands_takes_half_at_most() {
        let stance = |foot, start, end| Stance { foot, start, end };
        let loads = Load::all(&[stance(0, 0.0, 9.0), stance(1, 4.0, 5.0)]);
        assert_eq!(loads[1].full, (4.5, 4.5));
        for (t, weight) in [(4.0, 0.0), (4.5, 1.0), (5.0, 0.0)] {
            assert!((loads[1].weight(t) - weight).abs() < 1e-15 && (loads[0].weight(t) - 1.0).abs() < 1e-15);
        }
    }
}
