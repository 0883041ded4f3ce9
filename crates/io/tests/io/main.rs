//! Motions through the formats and back.

mod bvh;
mod bvh_reader;
#[cfg(feature = "csv")]
mod csv;
mod csv_tables;
mod motions;
#[cfg(feature = "opensim")]
mod opensim;
#[cfg(feature = "opensim")]
mod opensim_faults;
#[cfg(feature = "opensim")]
mod opensim_laws;
#[cfg(feature = "opensim")]
mod opensim_loads;
mod records;
mod sto;
