//! TRC: the tables of markers that OpenSim reads.
//!
//! Three lines of header, a line of names with three columns each, one of coordinates, and a line a frame:
//!
//! ```text
//! PathFileType  4  (X/Y/Z)  walk.trc
//! DataRate  CameraRate  NumFrames  NumMarkers  Units  OrigDataRate  OrigDataStartFrame  OrigNumFrames
//! 100       100         2          2           mm     100           1                   2
//! Frame#  Time  heel          toe
//!               X1   Y1   Z1  X2   Y2   Z2
//!
//! 1       0.00  101  52   3   240  31   2
//! 2       0.01  102  52   3
//! ```
//!
//! - Cells stand between tabs; where a file has none, between blanks, and then every cell must be there.
//! - A blank cell hides its marker in that frame, as do cells that are missing at the end of a line, and `NaN`. So do three
//!   zeros, where the same marker is elsewhere far from the origin: some systems write them.
//! - Where the numbers of markers and frames in the header are wrong the table counts; a finding says so.
//! - Times that are missing are made of the rate. Names that are missing or stand twice get one of their own.
//! - Lengths become metres by `Units`; where no subject can have the size that follows, by the unit in which one has, unless
//!   [`ReadOptions::unit`] names it.
//! - Decimal commas, the line ends of Windows and of old Macs, and a byte order mark are read.

mod header;
mod read;
mod rows;
mod write;

pub use read::{ReadOptions, read};
pub use write::write;
