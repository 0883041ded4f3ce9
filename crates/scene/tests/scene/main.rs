//! Scenes as texts: what they come to, and what is refused and how.

mod faults;
mod fixtures;
mod grammar;
mod runs;
mod soles;
mod words;
