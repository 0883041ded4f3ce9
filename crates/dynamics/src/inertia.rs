//! The inertia of a whole figure: mass matrix, Coriolis matrix, momentum, energy.

pub(crate) mod centroidal;
pub(crate) mod columns;
pub(crate) mod coriolis;
pub(crate) mod energy;
pub(crate) mod inverse;
pub(crate) mod mass_matrix;
pub(crate) mod momentum;
