//! The program, as people run it.

mod again;
mod alone;
mod book;
mod chair;
#[cfg(unix)]
mod commands;
mod disk_full;
mod drives;
mod hostile;
mod inverse;
mod killed;
#[cfg(unix)]
mod learn;
mod limits;
mod pictures;
mod several;
mod studio;
mod walk;
