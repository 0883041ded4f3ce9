//! C3D: what motion capture systems write, markers and force plates in one binary file.
//!
//! Integers and reals, in the numbers of Intel, DEC and MIPS machines. A file begins with a header of 512 bytes, which says
//! where the parameters are; these are in groups such as `POINT:RATE`, and say where the frames begin. Every frame has its
//! points and then its samples of the analog channels.
//!
//! - Lengths become metres, by `POINT:UNITS`; where no subject can have the size that follows, by the unit in which one has,
//!   with a finding, unless [`ReadOptions::unit`] names it.
//! - A point whose residual is negative was hidden.
//! - What `POINT:ANGLES`, `FORCES`, `MOMENTS`, `POWERS` and `SCALARS` list are no markers, and are left out.
//! - The first frame is at time zero, whatever its number. Events, which files count from frame 1, are on the same clock.
//! - `POINT:LABELS2`, … go on where 255 labels are not enough; `TRIAL:ACTUAL_START_FIELD`, `TRIAL:ACTUAL_END_FIELD` and
//!   `POINT:LONG_FRAMES` count more than 65535 frames. Where the header, the parameters and the file's length disagree on the
//!   frames, what is there is read, with a finding.
//! - Force plates of types 1 to 4 are [read](crate::markers::Plate); others are named in a finding.
//!
//! # Source
//!
//! Motion Lab Systems, *The C3D File Format: User Guide* (2021), chapters on the header, the parameter section, the 3D and
//! analog data and the force platform group.

mod analog;
mod bytes;
mod error;
mod events;
mod header;
mod layout;
mod parameters;
mod plates;
mod points;
mod read;

pub use error::C3dError;
pub use read::{ReadOptions, read};
