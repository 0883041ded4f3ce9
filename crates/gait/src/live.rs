//! A walker that is steered while it walks.

mod balance;
mod beat;
mod command;
mod ease;
mod footholds;
mod forces;
mod loose;
mod paces;
mod print;
mod push;
mod step;
mod told;
mod tried;
mod walker;

pub use command::Command;
pub use footholds::Bent;
pub use walker::Walker;
