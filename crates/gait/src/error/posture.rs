//! Errors of key postures: why there are none, or no walk through them.

use crate::condition::Infeasible;

/// Why there are no such key postures, or no walk through them.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum PostureError {
    #[error("{determinants} determinants cannot walk like this: {why}")]
    Infeasible { determinants: &'static str, why: Box<Infeasible> },
    #[error("{found} values for the {expected} parameters of {determinants} determinants")]
    ParameterCount { determinants: &'static str, found: usize, expected: usize },
    #[error(
        "a walk through key postures needs a step, phases in each of its three cycles, and a duration for each phase"
    )]
    EmptyScript,
    #[error(
        "a walk through key postures: its {name} is {value}; it must be a finite number, and more than nothing"
    )]
    ScriptNumber { name: &'static str, value: f64 },
}
