//! Robots read from URDF.
#![cfg(feature = "urdf")]

mod bad_text;
mod data;
mod models;
mod robots;
mod table;
