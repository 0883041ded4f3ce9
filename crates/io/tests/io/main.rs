//! Motions through the formats and back.

mod bvh;
mod bvh_reader;
#[cfg(feature = "csv")]
mod csv;
mod motions;
