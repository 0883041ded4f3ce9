//! Models read from SDF.

mod bad_text;
mod included;
mod models;
