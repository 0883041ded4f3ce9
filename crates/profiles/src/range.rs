//! Ranges of numbers, and sets of several.

use alloc::vec::Vec;
use core::fmt;
use core::ops::Bound::{self, Excluded, Included, Unbounded};

/// Numbers between two bounds, each of which belongs to them or not, or is missing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Where the numbers begin.
    pub low: Bound<f64>,
    /// Where they end.
    pub high: Bound<f64>,
}

impl Range {
    /// All numbers.
    pub const ALL: Self = Self::new(Unbounded, Unbounded);
    /// Numbers above zero.
    pub const POSITIVE: Self = Self::new(Excluded(0.0), Unbounded);
    /// Numbers that are not below zero.
    pub const NOT_NEGATIVE: Self = Self::new(Included(0.0), Unbounded);

    /// Between two bounds.
    pub const fn new(low: Bound<f64>, high: Bound<f64>) -> Self {
        Self { low, high }
    }

    /// Between two numbers, both included.
    pub const fn closed(low: f64, high: f64) -> Self {
        Self::new(Included(low), Included(high))
    }

    /// This number and all above it.
    pub const fn at_least(low: f64) -> Self {
        Self::new(Included(low), Unbounded)
    }

    /// This number and all below it.
    pub const fn at_most(high: f64) -> Self {
        Self::new(Unbounded, Included(high))
    }

    /// Whether a number is one of these; NaN never is.
    pub fn contains(&self, x: f64) -> bool {
        let above = match self.low {
            Included(low) => x >= low,
            Excluded(low) => x > low,
            Unbounded => !x.is_nan(),
        };
        let below = match self.high {
            Included(high) => x <= high,
            Excluded(high) => x < high,
            Unbounded => !x.is_nan(),
        };
        above && below
    }

    /// Whether there is no such number.
    pub fn is_empty(&self) -> bool {
        match (self.low, self.high) {
            (Included(low), Included(high)) => low > high,
            (Included(low) | Excluded(low), Included(high) | Excluded(high)) => low >= high,
            _ => false,
        }
    }

    /// The numbers −x of all x in it.
    pub fn negated(self) -> Self {
        let negate = |bound: Bound<f64>| bound.map(|x| 0.0 - x);
        Self::new(negate(self.high), negate(self.low))
    }
}

/// "at least 1", "more than 0 and at most 2", "any number".
impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.low {
            Included(low) => write!(f, "at least {low}")?,
            Excluded(low) => write!(f, "more than {low}")?,
            Unbounded => {}
        }
        if self.low != Unbounded && self.high != Unbounded {
            write!(f, " and ")?;
        }
        match self.high {
            Included(high) => write!(f, "at most {high}"),
            Excluded(high) => write!(f, "less than {high}"),
            Unbounded if self.low == Unbounded => write!(f, "any number"),
            Unbounded => Ok(()),
        }
    }
}

/// Several ranges apart from each other, in rising order; possibly none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ranges(Vec<Range>);

impl Ranges {
    /// No number at all.
    pub const NONE: Self = Self(Vec::new());

    /// All numbers.
    pub fn all() -> Self {
        Self::from(Range::ALL)
    }

    /// All numbers but those strictly between `low` and `high`.
    pub fn outside(low: f64, high: f64) -> Self {
        if low < high { Self::new([Range::at_most(low), Range::at_least(high)]) } else { Self::all() }
    }

    /// These ranges, without the empty ones.
    pub fn new(ranges: impl IntoIterator<Item = Range>) -> Self {
        Self(ranges.into_iter().filter(|range| !range.is_empty()).collect())
    }

    /// The ranges.
    pub fn as_slice(&self) -> &[Range] {
        &self.0
    }

    /// Whether a number is in one of them.
    pub fn contains(&self, x: f64) -> bool {
        self.0.iter().any(|range| range.contains(x))
    }

    /// Whether there is no such number.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The numbers −x of all x in them.
    pub fn negated(&self) -> Self {
        Self(self.0.iter().rev().map(|range| range.negated()).collect())
    }
}

impl From<Range> for Ranges {
    fn from(range: Range) -> Self {
        Self::new([range])
    }
}

/// "at most -1, or at least 2"; "no number" where there is none.
impl fmt::Display for Ranges {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            return write!(f, "no number");
        }
        for (i, range) in self.0.iter().enumerate() {
            if i > 0 {
                write!(f, ", or ")?;
            }
            write!(f, "{range}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    #[test]
    fn ranges_say_what_they_hold() {
        assert_eq!(Range::POSITIVE.to_string(), "more than 0");
        assert_eq!(Range::new(Included(1.0), Excluded(2.5)).to_string(), "at least 1 and less than 2.5");
        assert_eq!(Range::ALL.to_string(), "any number");
        assert_eq!(Ranges::outside(-1.0, 0.0).to_string(), "at most -1, or at least 0");
        assert_eq!(Ranges::NONE.to_string(), "no number");
    }

    #[test]
    fn bounds_belong_to_a_range_or_not() {
        let range = Range::new(Included(1.0), Excluded(2.0));
        assert!(range.contains(1.0) && !range.contains(2.0) && !range.contains(f64::NAN));
        assert!(range.negated().contains(-1.0) && !range.negated().contains(-2.0));
        assert!(Range::new(Included(1.0), Excluded(1.0)).is_empty() && !Range::closed(1.0, 1.0).is_empty());
        assert!(Ranges::outside(0.0, 0.0).contains(0.0) && !Range::ALL.contains(f64::NAN));
    }
}
