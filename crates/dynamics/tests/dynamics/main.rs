//! The kernel: its laws, closed forms, reference numbers and questions.

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod contacts;
mod coupling;
mod denavit_hartenberg;
mod errors;
mod forward;
mod fuse_laws;
mod hard_cases;
mod lagrange;
mod lagrange_laws;
mod motion_laws;
mod operation_counts;
mod oracle_laws;
mod other_scalars;
mod questions;
mod reference;
mod root_laws;
mod scalars;
