//! Tables of numbers: what CSV, `.mot` and `.sto` files hold.

use crate::error::IoError;
use std::borrow::Cow;

/// Endings of the nine columns of a contact, in order.
pub(crate) const CONTACT: [&str; 9] = ["fx", "fy", "fz", "mx", "my", "mz", "px", "py", "pz"];
/// Ending of the columns of generalized forces.
pub(crate) const TAU: &str = "tau";
/// Heading of the column of times.
pub(crate) const TIME: &str = "time";

/// A degree of freedom's column, such as `left_knee.rx.q`.
pub(crate) fn heading(name: &str, ending: &str) -> String {
    format!("{name}.{ending}")
}

/// What stands around a name in a table and is no part of it: blanks, and the mark of a file's beginning, which programs that put files
/// together leave inside.
pub(crate) fn is_around(c: char) -> bool {
    c.is_whitespace() || c == '\u{feff}'
}

/// A name without what stands around it.
pub(crate) fn bare(name: &str) -> &str {
    name.trim_matches(is_around)
}

/// Refuses a name that would not be read from a line of a table in `format` as it is written.
#[cfg(any(feature = "c3d", feature = "csv", feature = "trc"))]
pub(crate) fn check_name(name: &str, format: &'static str) -> Result<(), IoError> {
    if bare(name) != name || name.contains(['\n', '\r']) {
        return Err(IoError::Heading { name: name.to_owned(), format });
    }
    Ok(())
}

/// Named columns of numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The title that the file gives itself; empty where it has none.
    pub title: String,
    /// Whether the header says that angles are in degrees; `None` where the format does not say.
    pub in_degrees: Option<bool>,
    /// Headings. One may stand twice in `.mot` and `.sto`, which is a [note](Self::notes).
    pub columns: Vec<String>,
    /// The numbers, row by row; all finite.
    pub values: Vec<f64>,
    /// The line of the text (from 1) that each row stands in.
    pub lines: Vec<u64>,
    /// The line of the text (from 1) that the headings stand in.
    pub header_line: u64,
    /// What is odd about the text, and how it was read all the same.
    pub notes: Vec<TableNote>,
}

/// Something odd about a table's text, which does not keep it from being read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableNote {
    /// Fewer or more rows or columns than the header says.
    #[error("line {line}: the header says {told} {what}, there are {found}; what is there is read")]
    Count {
        /// Line, from 1.
        line: u64,
        /// Rows or columns.
        what: &'static str,
        /// What the header says.
        told: usize,
        /// What there are.
        found: usize,
    },
    /// Headings that stand more than once.
    #[error("{} more than once in line {line}; nothing may ask for {}",
        if .names.len() == 1 { format!("'{}' stands", .names[0]) } else { format!("{} headings, such as '{}', stand", .names.len(), .names[0]) },
        if .names.len() == 1 { "it" } else { "them" })]
    Duplicate {
        /// Line of the headings, from 1.
        line: u64,
        /// Which.
        names: Vec<String>,
    },
    /// Cells of several numbers.
    #[error("its cells hold {parts} numbers each ({kind}); '{first}' and so on are columns of one")]
    Vectors {
        /// What the header calls them.
        kind: String,
        /// How many numbers a cell has.
        parts: usize,
        /// The first column of one number.
        first: String,
    },
    /// Angles in degrees, which the header does not say.
    #[error(
        "its header has no version, so its angles are degrees, as SIMM's and OpenSim's first motions have them"
    )]
    OldDegrees,
    /// Rows that repeat the time before.
    #[error("{} the time before (line {line} is the first), left out",
        if *.rows == 1 { "one row repeats".to_owned() } else { format!("{rows} rows repeat") })]
    RepeatedTimes {
        /// How many.
        rows: usize,
        /// The first line, from 1.
        line: u64,
    },
    /// Coordinates without a column, which are where the model has them.
    #[error("no column for {}: the model's own values are taken", defaults(.coordinates))]
    Defaults {
        /// Which, and where they are.
        coordinates: Vec<CoordinateDefault>,
    },
}

/// Where a model has a coordinate while nobody says anything else.
#[derive(Clone, Debug, PartialEq)]
pub struct CoordinateDefault {
    /// Its name.
    pub name: String,
    /// Where it is (rad or m).
    pub value: f64,
    /// Whether the model holds it there.
    pub is_locked: bool,
    /// Whether the model keeps it within its range.
    pub is_clamped: bool,
}

fn defaults(coordinates: &[CoordinateDefault]) -> String {
    const MOST: usize = 8;
    let one = |CoordinateDefault { name, value, is_locked, .. }: &CoordinateDefault| {
        format!("'{name}' ({value}{})", if *is_locked { ", locked" } else { "" })
    };
    let shown: Vec<String> = coordinates.iter().take(MOST).map(one).collect();
    let more = coordinates.len().saturating_sub(MOST);
    shown.join(", ") + &if more > 0 { format!(" and {more} more") } else { String::new() }
}

impl Table {
    /// The most columns of a table that is read.
    pub const MOST_COLUMNS: usize = 1_000_000;

    /// Refuses a row of the text with more columns than are read, before any is kept.
    pub(crate) fn check_width(line: u64, found: usize) -> Result<(), IoError> {
        if found > Self::MOST_COLUMNS { Err(IoError::ManyColumns { line, found }) } else { Ok(()) }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// The place of the column called `name`.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// A row's numbers.
    pub fn row(&self, index: usize) -> &[f64] {
        &self.values[index * self.columns.len()..][..self.columns.len()]
    }

    /// One column's numbers.
    pub fn values_of(&self, column: usize) -> impl Iterator<Item = f64> + '_ {
        self.values.iter().skip(column).step_by(self.columns.len().max(1)).copied()
    }

    /// The table without the rows whose time is that of the row before, with a note: some programs write the last one twice.
    pub fn without_repeated_times(&self) -> Cow<'_, Self> {
        let Some(column) = self.column(TIME) else { return Cow::Borrowed(self) };
        let time = |row: usize| self.row(row)[column];
        let repeats = |row: usize| row > 0 && time(row).to_bits() == time(row - 1).to_bits();
        let Some(first) = (0..self.len()).find(|row| repeats(*row)) else { return Cow::Borrowed(self) };
        let kept: Vec<usize> = (0..self.len()).filter(|row| !repeats(*row)).collect();
        let note = TableNote::RepeatedTimes { rows: self.len() - kept.len(), line: self.lines[first] };
        let mut rest = self.only(&kept);
        rest.notes.push(note);
        Cow::Owned(rest)
    }

    /// The rows whose time is between two (s); all rows of a table without times.
    #[must_use]
    pub fn within(&self, from: f64, to: f64) -> Self {
        let time = self.column(TIME);
        let is_within = |row: usize| time.is_none_or(|column| (from..=to).contains(&self.row(row)[column]));
        self.only(&(0..self.len()).filter(|row| is_within(*row)).collect::<Vec<_>>())
    }

    /// These rows alone.
    fn only(&self, rows: &[usize]) -> Self {
        Self {
            title: self.title.clone(),
            in_degrees: self.in_degrees,
            columns: self.columns.clone(),
            values: rows.iter().flat_map(|row| self.row(*row)).copied().collect(),
            lines: rows.iter().map(|row| self.lines[*row]).collect(),
            header_line: self.header_line,
            notes: self.notes.clone(),
        }
    }

    /// Refuses headings that stand twice.
    pub(crate) fn check_headings(&self) -> Result<(), IoError> {
        let mut places = std::collections::HashMap::new();
        for (column, name) in self.columns.iter().enumerate() {
            if let Some(first) = places.insert(name, column) {
                let (line, column, first) = (self.header_line, column + 1, first + 1);
                return Err(IoError::DuplicateColumn { line, column, name: name.clone(), first });
            }
        }
        Ok(())
    }
}
