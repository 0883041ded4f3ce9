//! Cells of a row: a number each, or several between commas.

use crate::table::{TIME, Table, TableNote};
use std::borrow::Cow;

/// What stands between numbers of a row that may hold vectors, without what only dresses them up (`~[1, 2, 3]`).
pub(super) fn undressed(row: &str) -> Cow<'_, str> {
    if !row.contains(['[', '(', ',']) {
        return Cow::Borrowed(row);
    }
    let mut out = String::with_capacity(row.len());
    let mut in_cell = false;
    for c in row.chars() {
        match c {
            '~' => {}
            '[' | '(' => in_cell = true,
            ']' | ')' => in_cell = false,
            ' ' | '\t' if in_cell || out.ends_with(',') => {}
            c => out.push(c),
        }
    }
    Cow::Owned(out)
}

/// Whether cells of a table hold several numbers, as its header or its first row says. A comma alone may be a decimal one.
pub(super) fn hold_vectors(kind: &str, row: &str) -> bool {
    let is_scalar = kind.is_empty() || kind.eq_ignore_ascii_case("double");
    (!is_scalar && row.contains(',')) || row.contains("~[")
}

/// Splits the columns of `table` whose cells hold several numbers, as its first row (undressed) has them. Returns the number of
/// numbers of each cell.
pub(super) fn split_columns(table: &mut Table, kind: &str, row: &str) -> Vec<usize> {
    let mut parts: Vec<usize> = row.split_whitespace().map(|cell| cell.matches(',').count() + 1).collect();
    if parts.len() != table.columns.len() {
        // Its first row is at fault for that.
        return vec![1; table.columns.len()];
    }
    let names = std::mem::take(&mut table.columns);
    for (name, parts) in names.into_iter().zip(&mut parts) {
        // A time is one number, or at fault.
        if name == TIME {
            *parts = 1;
        }
        let parts = *parts;
        if parts == 1 {
            table.columns.push(name);
        } else {
            let first = table.columns.len();
            table.columns.extend((0..parts).map(|i| format!("{name}.{}", part(kind, parts, i))));
            if !table.notes.iter().any(|note| matches!(note, TableNote::Vectors { .. })) {
                let (kind, first) =
                    (if kind.is_empty() { "vectors" } else { kind }, table.columns[first].clone());
                table.notes.push(TableNote::Vectors { kind: kind.to_owned(), parts, first });
            }
        }
    }
    parts
}

/// What the number `i` of `parts` is called.
fn part(kind: &str, parts: usize, i: usize) -> String {
    let names: &[&str] = match (kind, parts) {
        ("Quaternion", 4) => &["w", "x", "y", "z"],
        ("SpatialVec", 6) => &["rx", "ry", "rz", "tx", "ty", "tz"],
        (_, 2 | 3) => &["x", "y", "z"],
        _ => &[],
    };
    names.get(i).map_or_else(|| (i + 1).to_string(), |name| (*name).to_owned())
}
