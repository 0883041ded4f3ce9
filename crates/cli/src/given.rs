//! A figure in a given motion, read and differentiated, and what is to be said of both.

mod read;
mod report;
mod summary;

pub(crate) use read::{Given, in_order};
pub(crate) use report::GivenReport;
