//! The page and the tables of a motion.

mod page;
mod precision;
mod profile;
