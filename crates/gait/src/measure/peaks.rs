//! Peaks of the ground's force on one foot over its stride, where gait laboratories look for them.

use super::window::Window;

/// Parts of a stride in which the first peak of the vertical force, its valley (from so long after the first double support)
/// and its second peak (until toe-off) are looked for.
const FIRST_PEAK: (f64, f64) = (0.02, 0.25);
const VALLEY_AFTER: f64 = 0.01;
const VALLEY_TO: f64 = 0.5;
const SECOND_PEAK_FROM: f64 = 0.30;

/// A foot's stride, and when in it the foot leaves the ground, as a part of it. Forces are by sample, `vertical` upward and
/// `along` forward.
pub(crate) struct Stance<'a> {
    pub(crate) window: Window<'a>,
    pub(crate) toe_off: f64,
}

impl Stance<'_> {
    /// The first peak: of weight acceptance.
    pub(crate) fn first_peak(&self, vertical: &dyn Fn(usize) -> f64) -> f64 {
        self.window.most(FIRST_PEAK, vertical)
    }

    /// The valley between the peaks; `double_support` is a part of the stride.
    pub(crate) fn valley(&self, double_support: f64, vertical: &dyn Fn(usize) -> f64) -> f64 {
        self.window.least((double_support + VALLEY_AFTER, VALLEY_TO), vertical)
    }

    /// The second peak: of the push-off.
    pub(crate) fn second_peak(&self, vertical: &dyn Fn(usize) -> f64) -> f64 {
        self.window.most((SECOND_PEAK_FROM, self.toe_off), vertical)
    }

    /// The greatest force backward; negative.
    pub(crate) fn braking(&self, along: &dyn Fn(usize) -> f64) -> f64 {
        self.window.least((0.0, self.toe_off), along)
    }

    /// The greatest force forward.
    pub(crate) fn pushing(&self, along: &dyn Fn(usize) -> f64) -> f64 {
        self.window.most((0.0, self.toe_off), along)
    }
}
