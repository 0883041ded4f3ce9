//! The table of a crowd's people, and their files' names.

use crate::args::{PLACES, columns, walk_options};
use crate::error::CliError;
use crate::input;
use solaris::io::csv::{Row, read_rows};
use solaris::model::nearest;
use std::collections::BTreeSet;
use std::path::Path;

/// How far people who are drawn stand from each other (m), and how many in a row.
const APART: f64 = 1.5;
const IN_A_ROW: u32 = 10;

/// The people of a table.
pub(super) struct People {
    pub(super) columns: Vec<String>,
    pub(super) rows: Vec<Row>,
    /// Whether there is such a table, so that its lines mean something.
    pub(super) written: bool,
    /// A name of a file for each, without its extension.
    pub(super) files: Vec<String>,
}

impl People {
    fn new(columns: Vec<String>, rows: Vec<Row>, written: bool) -> Self {
        let name = columns.iter().position(|column| column == "name");
        let mut taken = BTreeSet::new();
        let files = rows.iter().enumerate().map(|(number, row)| {
            let own = name.and_then(|name| row.fields.get(name)).filter(|own| !own.is_empty());
            let own = own.map_or_else(|| format!("person-{:04}", number + 1), |own| file_name(own));
            // Names that differ in their letters' case are one file on some disks.
            let mut tries = std::iter::once(own.clone()).chain((2..).map(|n| format!("{own}-{n}")));
            tries.find(|name| taken.insert(name.to_lowercase())).unwrap_or(own)
        });
        let files = files.collect();
        Self { columns, rows, written, files }
    }

    /// So many people of whom nothing is asked, ten in a row.
    pub(super) fn drawn(count: u32) -> Self {
        let rows = (0..count).map(|i| {
            let place = |n: u32| (f64::from(n) * APART).to_string();
            Row { line: u64::from(i) + 1, fields: vec![place(i % IN_A_ROW), place(i / IN_A_ROW)] }
        });
        Self::new(vec!["x".to_owned(), "z".to_owned()], rows.collect(), false)
    }
}

/// A name as a file may have it: letters, digits, `-` and `_`.
fn file_name(name: &str) -> String {
    let clean: String =
        name.chars().take(80).map(|c| if c.is_alphanumeric() || c == '-' { c } else { '_' }).collect();
    // That is the table's.
    if clean.eq_ignore_ascii_case("crowd") { format!("{clean}-1") } else { clean }
}

/// Reads a table of people; every column is known.
pub(super) fn read(path: &Path) -> Result<People, CliError> {
    let refuse = |why: &dyn ToString| CliError::input(path, why);
    if input::extension(path) != "csv" {
        return Err(refuse(&"its extension says nothing; a table of people is .csv"));
    }
    let text = input::text(path)?;
    if text.trim_start_matches('\u{feff}').trim().is_empty() {
        return Err(refuse(&"it is empty; its first line must name columns: name,height,age,manner …"));
    }
    let table = read_rows(&text).map_err(|error| refuse(&error))?;
    let mut known: Vec<String> = PLACES.iter().map(|name| (*name).to_owned()).collect();
    known.extend(columns(&walk_options()));
    let is_known = |name: &str| known.iter().any(|known| known == name) || name == "cadence";
    for (number, name) in table.columns.iter().enumerate() {
        // Words of a name may be joined by either.
        if !is_known(&name.replace('_', "-")) {
            let near = nearest(name, known.iter().map(String::as_str));
            let hint = near.map_or_else(
                || format!("there are {}", known.join(", ")),
                |near| format!("did you mean '{near}'?"),
            );
            return Err(refuse(&format!(
                "line 1, column {}: there is no column '{name}'; {hint}",
                number + 1
            )));
        }
    }
    let columns = table.columns.iter().map(|name| name.replace('_', "-")).collect();
    Ok(People::new(columns, table.rows, true))
}
