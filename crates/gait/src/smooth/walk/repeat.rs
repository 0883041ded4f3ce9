//! The repeated middle of a long walk, which is a shorter one with one stride walked again.
//!
//! What begins and ends a walk dies away along it: by 0.01 to 0.03 a stride, to 1e-11 of a metre after ten. A walk of more than
//! [`LONGEST`] steps is planned with no more than these, and its middle stride is walked as often as is needed. The cost
//! of planning does not grow from there on.

/// The most steps that are planned; even, so that a walk keeps which foot comes last.
const LONGEST: usize = 42;

/// How often the middle stride is repeated, and where it lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Repeat {
    /// Steps that are planned.
    pub(super) planned: usize,
    /// How often the stride is walked once more.
    strides: usize,
    /// Where it begins, on the clock.
    cut: f64,
    /// How far it goes (m).
    advance: f64,
}

/// How many of so many steps are planned.
pub(super) fn planned(steps: usize) -> usize {
    steps - 2 * steps.saturating_sub(LONGEST).div_ceil(2)
}

impl Repeat {
    /// Of `steps` steps with the steps that are planned of them, `rate` nodes a stride.
    pub(super) fn new(steps: usize, planned: usize, rate: usize, step_length: f64) -> Self {
        // A quarter of a stride after a contact, far from everything sudden, and at a node.
        let middle = (planned / 4) as f64 + 0.3;
        let cut = (middle * rate as f64).round() / rate as f64;
        Self { planned, strides: (steps - planned) / 2, cut, advance: 2.0 * step_length }
    }

    /// The clock of a contact from which on a stride repeats itself, where there is one.
    pub(super) fn middle(&self) -> Option<f64> {
        (self.planned + 1 >= LONGEST).then_some((self.planned / 4) as f64)
    }

    /// The clock of the planned walk for one of the whole walk, and how much farther along the body is (m).
    pub(super) fn fold(&self, u: f64) -> (f64, f64) {
        let strides = (u - self.cut).floor().clamp(0.0, self.strides as f64);
        (u - strides, strides * self.advance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_walk_is_folded_into_a_shorter_one() {
        let of = |steps: usize| Repeat::new(steps, planned(steps), 100, 0.7);
        let short = of(42);
        assert_eq!((short.planned, short.fold(30.0)), (42, (30.0, 0.0)));
        let long = of(100);
        assert_eq!(long.planned, 42);
        assert_eq!(long.fold(3.0), (3.0, 0.0));
        let (u, advance) = long.fold(25.5);
        assert!((u - 10.5).abs() < 1e-12 && (advance - 15.0 * 1.4).abs() < 1e-12);
        let (u, advance) = long.fold(51.0);
        assert!((u - 22.0).abs() < 1e-12 && (advance - 29.0 * 1.4).abs() < 1e-12);
        assert_eq!(of(101).planned, 41);
    }
}
