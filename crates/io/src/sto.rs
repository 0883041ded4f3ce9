//! Tables of OpenSim: `.mot` (motions) and `.sto` (anything else), which are one format.
//!
//! A header of free lines that ends with `endheader`, a line of headings, and one line of numbers a row, between tabs or
//! spaces:
//!
//! ```text
//! pendulum
//! version=1
//! nRows=2
//! nColumns=2
//! inDegrees=no
//! endheader
//! time    angle
//! 0       0.1
//! 0.01    0.12
//! ```
//!
//! - The first line is the title, unless it is one of the keys below; a line `name=…` is a title too.
//! - Where `nRows` (`datarows`) and `nColumns` (`datacolumns`) are wrong the table counts, with a
//!   [note](crate::TableNote): a table that was cut off is not read in silence.
//! - `inDegrees` is kept as it stands, and `Angles are in degrees.` of files without a version counts as one. A `.mot` without
//!   a version is in degrees where it does not say radians, as in SIMM ([`read_mot`]). Which columns are angles is the figure's to say: a table of forces may
//!   claim degrees too, and translations never are.
//! - Every other line of the header is passed over. `endheader` may be written in capitals.
//! - Numbers are finite. `nan`, which OpenSim writes for what it could not compute, is refused with its place.
//! - Cells of several numbers (`DataType=Vec3`, `Quaternion`, …, or `~[x,y,z]`) become columns of one each: `NAME.x`, `.y`, `.z`;
//!   of a quaternion `NAME.w` first, as it stands there.
//! - A heading that stands twice is a note; whoever asks for it is refused.
//! - Line ends may be those of Windows, and what stands between numbers any tabs and spaces.

mod cells;
mod header;
mod read;
mod write;

pub use read::{read, read_mot};
pub use write::write;

/// What the header of a `.mot` or `.sto` table says wrongly.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StoFault {
    /// The text ends before the header does.
    #[error(
        "there is no line 'endheader'; a .mot or .sto table needs one between its header and its headings"
    )]
    NoEnd,
    /// Nothing comes after the header.
    #[error("there are no headings after 'endheader'")]
    NoHeadings,
    /// No column of times.
    #[error("no column is called 'time'; the headings are {headings}")]
    NoTime {
        /// The first of them.
        headings: String,
    },
    /// A heading of no letters.
    #[error("heading {column} is empty")]
    EmptyHeading {
        /// Its number, from 1.
        column: usize,
    },
    /// A number of rows or columns that is none.
    #[error("'{key}' is '{text}', which is no number of {what}")]
    NoCount {
        /// The key, as the file writes it.
        key: String,
        /// What stands there.
        text: String,
        /// Rows or columns.
        what: &'static str,
    },
    /// Neither yes nor no.
    #[error("'inDegrees' is '{text}'; it must be yes or no")]
    Degrees {
        /// What stands there.
        text: String,
    },
}
