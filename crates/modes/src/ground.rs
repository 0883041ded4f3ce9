//! The ground under a motion.

mod consistency;

pub use consistency::{
    Balance, Consistency, ConsistencyError, ConsistencyOptions, Outcome as ConsistencyOutcome, ShiftError,
    Violation, consistent, shift_root,
};
