//! The page and the tables of a motion.

mod charts;
mod denavit_hartenberg;
mod film;
mod page;
mod precision;
mod profile;
