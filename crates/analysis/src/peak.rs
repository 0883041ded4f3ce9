//! The greatest of a quantity over time.

/// The greatest (or the least) value of a quantity, and when it occurs.
///
/// With the feature `serde` its keys are `value` and `at_s`; whoever holds it names its unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Peak {
    /// The value.
    pub value: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
}

impl Peak {
    /// Less than anything.
    pub const NONE: Self = Self { value: f64::NEG_INFINITY, time: 0.0 };

    /// The greater of two; this one where they are equal.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if other.value > self.value { other } else { self }
    }

    /// The less of two; this one where they are equal.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if other.value < self.value { other } else { self }
    }
}
