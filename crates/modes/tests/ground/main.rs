//! The ground under a motion: what makes its reactions possible.

mod dense;
mod figure;
mod points;
mod refusals;
mod support;
