#![doc = include_str!("../README.md")]

pub mod bvh;
#[cfg(feature = "c3d")]
pub mod c3d;
pub mod clip;
#[cfg(feature = "csv")]
pub mod csv;
mod encoding;
mod error;
#[cfg(feature = "glb")]
pub mod glb;
pub mod headings;
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim", feature = "sdf"))]
mod import;
#[cfg(any(feature = "mjcf", feature = "sdf"))]
mod loader;
#[cfg(any(feature = "c3d", feature = "trc"))]
pub mod markers;
#[cfg(feature = "mjcf")]
pub mod mjcf;
#[cfg(feature = "opensim")]
pub mod opensim;
#[cfg(feature = "parquet")]
pub mod parquet;
pub mod record;
#[cfg(feature = "glb")]
pub mod rig;
#[cfg(feature = "sdf")]
pub mod sdf;
pub mod sto;
mod table;
#[cfg(feature = "trc")]
pub mod trc;
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim", feature = "sdf"))]
mod tree;
mod upright;
#[cfg(feature = "urdf")]
pub mod urdf;
#[cfg(feature = "glb")]
pub mod usd;
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim", feature = "sdf"))]
mod xml;

pub use encoding::{Encoding, decode};
pub use error::{ClipProblem, ContactProblem, ExternalForceProblem, IoError, VrmProblem};
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim", feature = "sdf"))]
pub use import::Import;
#[cfg(any(feature = "mjcf", feature = "sdf"))]
pub use loader::{FileError, FilesError, Loader, NoFiles};
pub use table::{CoordinateDefault, Table, TableNote};
