//! The smallest change of a root that makes ground reactions possible.

mod dense;
mod figure;
mod points;
mod refusals;
mod support;
