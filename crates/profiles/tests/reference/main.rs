//! Against numbers of 60 digits (`fixtures/reference/profiles.json`).

#![allow(clippy::print_stdout, reason = "`--nocapture` shows how much of the tolerance is used")]

mod acceleration;
mod blends;
mod displacement;
mod harness;
mod keys;
mod polynomial;
mod velocity;
