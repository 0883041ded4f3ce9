//! What the kernel answers besides forces and accelerations, over figures with joints of every kind.

pub(crate) mod case;
mod centroidal;
mod coriolis;
mod derivatives;
mod ground;
mod jacobian;
mod joints;
mod reacting;
mod reactions;
mod refusals;
mod regressor;
mod scalars;
