//! Motions of a figure: tables and clips.

use crate::error::FileError;
use crate::figure::is_clip;
use crate::files::Source;
use crate::read::{extension, refuse_unread};
use solaris_io::clip::ReadOptions;
use solaris_io::{Table, csv, sto};
use solaris_model::{Figure, Finding, FindingKind};
use std::path::Path;

impl Source<'_> {
    /// Reads a motion of a figure, and what looks wrong with it.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, and clips that are not of the figure.
    pub fn motion(self, path: &Path, figure: &Figure) -> Result<(Table, Vec<Finding>), FileError> {
        if !is_clip(path) {
            return Ok((self.table(path)?, Vec::new()));
        }
        let mut clip = self.clip(path, &ReadOptions::default())?;
        let table = clip.table_of(figure).map_err(|error| FileError::input(path, &error))?;
        // The masses are the figure's.
        clip.findings.retain(|finding| finding.kind == FindingKind::Suspect && finding.subject != "masses");
        Ok((table, clip.findings))
    }

    /// Reads a table of numbers.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, and texts that are no table.
    pub fn table(self, path: &Path) -> Result<Table, FileError> {
        let read = match extension(path).as_str() {
            "csv" => csv::read_table,
            "mot" => sto::read_mot,
            "sto" => sto::read,
            _ => {
                refuse_unread(path, "a motion is .csv, .mot, .sto, .bvh or .glb")?;
                return Err(FileError::input(
                    path,
                    &"its extension says nothing; a table is .csv, .mot or .sto",
                ));
            }
        };
        read(&self.text(path)?).map_err(|error| FileError::input(path, &error))
    }
}

/// [`Source::motion`] of the disk.
///
/// # Errors
///
/// As there.
pub fn motion(path: &Path, figure: &Figure) -> Result<(Table, Vec<Finding>), FileError> {
    Source::disk().motion(path, figure)
}

/// [`Source::table`] of the disk.
///
/// # Errors
///
/// As there.
pub fn table(path: &Path) -> Result<Table, FileError> {
    Source::disk().table(path)
}

/// Whether a file is one of motions, by its extension.
pub fn is_motion(path: &Path) -> bool {
    is_clip(path) || matches!(extension(path).as_str(), "csv" | "mot" | "sto" | "c3d" | "trc")
}
