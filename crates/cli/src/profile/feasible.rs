//! The values of a parameter that keep a motion from turning round.

use solaris::profiles::{Parameter, Range, Ranges};

/// Digits of the bounds that people read.
const DIGITS: usize = 7;

/// The values of a parameter with which the motion never turns round.
pub(super) struct Feasible {
    pub(super) parameter: &'static Parameter,
    pub(super) ranges: Ranges,
}

impl Feasible {
    pub(super) fn label(&self) -> String {
        format!("never turns round, {}", self.parameter.symbol)
    }

    /// The ranges with few digits, rounded inwards: what is read is in them.
    pub(super) fn short(&self) -> String {
        Ranges::new(
            self.ranges
                .as_slice()
                .iter()
                .map(|range| Range::new(range.low.map(|x| -inward(-x)), range.high.map(inward))),
        )
        .to_string()
    }
}

/// The nearest number of few digits that is not greater.
fn inward(x: f64) -> f64 {
    let parse = |text: String| text.parse::<f64>().unwrap_or(x);
    let near = parse(format!("{x:.*e}", DIGITS - 1));
    if near <= x || !x.is_finite() {
        return near;
    }
    let unit = 10f64.powf(x.abs().log10().floor() - (DIGITS as f64 - 1.0));
    parse(format!("{:.*e}", DIGITS - 1, x - unit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::Bound;

    #[test]
    fn bounds_are_rounded_inwards() {
        let ranges = Ranges::from(Range::new(Bound::Included(0.1), Bound::Excluded(9.330_127_018_922_193)));
        let feasible = |ranges| Feasible { parameter: &Parameter::START_VELOCITY, ranges };
        assert_eq!(feasible(ranges).short(), "at least 0.1 and less than 9.330127");
        let ranges = Ranges::outside(-2.0 / 3.0, 2.0 / 3.0);
        assert_eq!(feasible(ranges).short(), "at most -0.6666667, or at least 0.6666667");
        assert_eq!(feasible(Range::at_least(1.0 / 3.0).into()).short(), "at least 0.3333334");
    }
}
