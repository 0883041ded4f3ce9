//! Errors of measuring a motion.

/// Why a motion cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum MeasureError {
    #[error("the motion has no {what}; find the ground reactions first")]
    NothingToMeasure { what: &'static str },
    #[error(
        "{duration:.0} s at {rate} samples/s make {samples:.0} samples, more than {most}; walk fewer steps or lower the rate"
    )]
    TooManySamples { duration: f64, rate: f64, samples: f64, most: f64 },
    #[error("gravity is ({}, {}, {}) m/s²; without it nothing says which way is up", .gravity[0], .gravity[1], .gravity[2])]
    NoGravity { gravity: [f64; 3] },
    #[error("{what} of the motion has {found} entries where {expected} are needed")]
    OtherMotion { what: &'static str, found: usize, expected: usize },
}
