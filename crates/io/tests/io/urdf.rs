//! Robots read from URDF.

mod bad_text;
mod models;
mod robots;
