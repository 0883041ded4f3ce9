//! Recordings of markers, and what their files leave to guess: the unit of lengths and the axes of the laboratory.
//!
//! [`trc`](crate::trc) and [`c3d`](crate::c3d) both give a [`Recording`]: points in metres along the laboratory's own axes,
//! with the first frame at time zero in a C3D file and where the file says in a TRC file.

mod axes;
mod cloud;
mod found;
mod ground;
mod names;
mod plates;
mod recording;
mod table;
mod unit;

pub use axes::{Axes, AxesError, Way};
pub use cloud::{Cloud, CloudError, cloud};
pub use found::find_axes;
pub use ground::ground_forces;
pub(crate) use names::{counted, unique};
pub use plates::{Load, LoadOptions, Plate, PlateKind};
pub use recording::{Channel, Event, Recording};
pub use table::write_csv;
pub use unit::LengthUnit;
pub(crate) use unit::{Extent, plausible};
