//! A way to walk along, out of a file.

use crate::error::CliError;
use crate::input;
use solaris::gait::WalkPath;
use std::path::Path;

/// The columns of a way.
const COLUMNS: [&str; 2] = ["x", "z"];

/// Reads the points of a way.
pub(super) fn read(path: &Path) -> Result<WalkPath, CliError> {
    let table = input::table(path)?;
    let column = |name: &str| {
        let missing = || {
            let found = table.columns.join(", ");
            CliError::input(
                path,
                &format!(
                    "there is no column '{name}'; a way has x (to the left) and z (ahead) in m, and here are {found}"
                ),
            )
        };
        table.column(name).ok_or_else(missing)
    };
    let [x, z] = [column(COLUMNS[0])?, column(COLUMNS[1])?];
    let points: Vec<[f64; 2]> = (0..table.len()).map(|row| [table.row(row)[x], table.row(row)[z]]).collect();
    WalkPath::through(&points).map_err(|error| CliError::input(path, &error))
}
