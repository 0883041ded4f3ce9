//! Models read from MJCF.
#![cfg(feature = "mjcf")]
#![allow(clippy::doc_markdown, reason = "MuJoCo is a name, not code")]

mod bad_text;
#[path = "../urdf/data.rs"]
mod data;
mod humanoid;
mod models;
#[path = "../urdf/table.rs"]
mod table;
