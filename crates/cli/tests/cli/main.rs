//! The program, as people run it.

mod alone;
mod disk_full;
mod drives;
mod hostile;
mod inverse;
mod limits;
mod pictures;
mod studio;
mod walk;
