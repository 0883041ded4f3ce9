//! Tables of numbers: what CSV, `.mot` and `.sto` files hold.

use crate::error::IoError;

/// Endings of the nine columns of a contact, in order.
pub(crate) const CONTACT: [&str; 9] = ["fx", "fy", "fz", "mx", "my", "mz", "px", "py", "pz"];
/// Ending of the columns of generalized forces.
pub(crate) const TAU: &str = "tau";
/// Heading of the column of times.
pub(crate) const TIME: &str = "time";

/// Named columns of numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The title that the file gives itself; empty where it has none.
    pub title: String,
    /// Whether the header says that angles are in degrees; `None` where the format does not say.
    pub in_degrees: Option<bool>,
    /// Headings, all different.
    pub columns: Vec<String>,
    /// The numbers, row by row; all finite.
    pub values: Vec<f64>,
    /// The line of the text (from 1) that each row stands in.
    pub lines: Vec<u64>,
    /// The line of the text (from 1) that the headings stand in.
    pub header_line: u64,
}

impl Table {
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
