//! Figures as text: what is refused and how, what comes back the same, what is never to panic.

mod bad;
mod good;
mod large;
mod mutated;
mod random;
mod render;
mod round_trip;
