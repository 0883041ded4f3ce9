//! Models read from MJCF.
#![allow(clippy::doc_markdown, reason = "MuJoCo is a name, not code")]

mod bad_text;
mod humanoid;
mod models;
