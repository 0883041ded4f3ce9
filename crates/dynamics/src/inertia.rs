//! What the masses of a figure come to: the mass matrix and its relatives, momentum, energy.

pub(crate) mod centroidal;
pub(crate) mod coriolis;
pub(crate) mod energy;
pub(crate) mod mass_matrix;
pub(crate) mod momentum;
