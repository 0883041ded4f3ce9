//! Figures and motions through the formats and back.

mod bvh;
mod bvh_in;
mod bvh_reader;
#[cfg(feature = "c3d")]
mod c3d;
#[cfg(feature = "csv")]
mod csv;
mod csv_tables;
mod data;
#[cfg(feature = "glb")]
mod glb;
#[cfg(feature = "glb")]
mod glb_in;
#[cfg(all(feature = "mjcf", feature = "opensim", feature = "sdf", feature = "urdf"))]
mod limits;
#[cfg(all(feature = "mjcf", feature = "opensim", feature = "sdf", feature = "urdf"))]
mod measure;
#[cfg(feature = "mjcf")]
mod mjcf;
mod motions;
#[cfg(feature = "opensim")]
mod opensim;
#[cfg(feature = "opensim")]
mod opensim_faults;
#[cfg(feature = "opensim")]
mod opensim_joints;
#[cfg(feature = "opensim")]
mod opensim_laws;
#[cfg(feature = "opensim")]
mod opensim_loads;
#[cfg(feature = "opensim")]
mod opensim_reference;
#[cfg(feature = "opensim")]
mod opensim_rescale;
mod records;
#[cfg(feature = "glb")]
mod retarget;
#[cfg(feature = "glb")]
mod rig;
#[cfg(feature = "sdf")]
mod sdf;
mod sto;
#[cfg(any(feature = "mjcf", feature = "sdf", feature = "urdf"))]
mod table;
#[cfg(feature = "trc")]
mod trc;
#[cfg(feature = "urdf")]
mod urdf;
#[cfg(feature = "glb")]
mod usd;
#[cfg(feature = "glb")]
mod vrm;
