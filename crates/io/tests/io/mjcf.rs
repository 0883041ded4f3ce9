//! Models read from MJCF.
#![allow(clippy::doc_markdown, reason = "MuJoCo is a name, not code")]

mod acting;
mod actuators;
mod bad_text;
mod files;
mod humanoid;
mod medium;
mod models;
mod ties;
