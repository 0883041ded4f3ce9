//! Why a C3D file cannot be read.

use solaris_model::MarkerTrialError;

/// Why a C3D file cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum C3dError {
    /// The bytes are no C3D file.
    #[error("it is no C3D file: its byte 1 is {found:#04x} and must be 0x50; export the trial as C3D again")]
    Key {
        /// What stands in byte 1 (0 where there is none).
        found: u8,
    },
    /// A field has a value that cannot be.
    #[error("{field} is {value} (byte {offset}); {advice}")]
    Field {
        /// The field's name, such as `POINT:USED`.
        field: String,
        /// Its value.
        value: String,
        /// Where it stands in the file, from 0.
        offset: usize,
        /// What to do.
        advice: &'static str,
    },
    /// The file ends too early.
    #[error(
        "{field} should stand in bytes {offset} to {end}, and the file has {length}; it was cut off: copy or export it again"
    )]
    Cut {
        /// What is missing.
        field: String,
        /// Where it should begin, from 0.
        offset: usize,
        /// Where it should end.
        end: usize,
        /// How long the file is.
        length: usize,
    },
    /// The points are no trial.
    #[error(transparent)]
    Trial(#[from] MarkerTrialError),
}
