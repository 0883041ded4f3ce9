//! The program, as people run it.

mod disk_full;
mod drives;
mod inverse;
mod pictures;
mod walk;
