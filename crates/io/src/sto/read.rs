//! A text to a table.

use super::StoFault;
use super::cells::{hold_vectors, split_columns, undressed};
use super::header::Header;
use crate::error::IoError;
use crate::table::{TIME, Table, TableNote, bare};
use std::collections::HashSet;

/// Reads a `.mot` or `.sto` table.
///
/// # Errors
///
/// [`IoError::Sto`] where the header is wrong, [`IoError::RowLength`] and [`IoError::Number`], all with their lines from 1.
///
/// # Examples
///
/// ```
/// let text = "swing\nversion=1\nnRows=2\nnColumns=2\ninDegrees=yes\nendheader\ntime\tknee\n0\t10\n0.5\t12.5\n";
/// let table = solaris_io::sto::read(text)?;
/// assert_eq!((table.in_degrees, table.row(1)), (Some(true), &[0.5, 12.5][..]));
/// # Ok::<(), solaris_io::IoError>(())
/// ```
pub fn read(text: &str) -> Result<Table, IoError> {
    Ok(read_with_header(text)?.0)
}

/// Reads a `.mot` table, as [`read`] does; without a version its angles are in degrees unless the header says otherwise.
///
/// SIMM's motions, and those of OpenSim before it wrote versions, are in degrees and do not say so. OpenSim 4 reads them so.
///
/// # Errors
///
/// Those of [`read`].
///
/// # Examples
///
/// ```
/// let simm = "name walk\ndatacolumns 2\ndatarows 1\notherdata 1\nrange 0.0 1.0\nendheader\ntime knee\n0 60\n";
/// assert_eq!(solaris_io::sto::read_mot(simm)?.in_degrees, Some(true));
/// # Ok::<(), solaris_io::IoError>(())
/// ```
#[doc(alias = "SIMM")]
pub fn read_mot(text: &str) -> Result<Table, IoError> {
    let (mut table, header) = read_with_header(text)?;
    if table.in_degrees.is_none() && !header.has_version {
        table.in_degrees = Some(true);
        table.notes.push(TableNote::OldDegrees);
    }
    Ok(table)
}

fn read_with_header(text: &str) -> Result<(Table, Header), IoError> {
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = (1_u64..).zip(text.split('\n').map(|line| line.trim_end_matches('\r')));
    let header = Header::read(&mut lines)?;
    let mut lines = lines.filter(|(_, line)| !line.trim().is_empty()).peekable();
    let (header_line, line) =
        lines.next().ok_or(IoError::Sto { line: header.end, fault: StoFault::NoHeadings })?;
    Table::check_width(header_line, line.split_whitespace().count())?;
    let first = lines.peek().map(|(_, row)| undressed(row));
    let cells = first.as_ref().map(|row| row.split_whitespace().count());
    let columns = headings(line, [cells, header.columns.map(|(_, count)| count)]);
    let (title, in_degrees) = (header.title.clone(), header.in_degrees);
    let mut table = Table { title, in_degrees, columns, header_line, ..Table::default() };
    check(&table)?;
    agree(&mut table, header.columns, "columns", |table| table.columns.len());
    let row = first.unwrap_or_default();
    let numbers = row.split_whitespace().count() + row.matches(',').count();
    Table::check_width(lines.peek().map_or(header_line, |(line, _)| *line), numbers)?;
    let parts = hold_vectors(&header.kind, lines.peek().map_or("", |(_, row)| row))
        .then(|| split_columns(&mut table, &header.kind, &row));
    note_duplicates(&mut table);
    for (line, row) in lines {
        match &parts {
            None => push(&mut table, line, row)?,
            Some(parts) => push_vectors(&mut table, line, row, parts)?,
        }
    }
    agree(&mut table, header.rows, "rows", Table::len);
    Ok((table, header))
}

/// The headings of a line: words, or what stands between tabs where only that gives one of the numbers that are `known`, of which
/// the first counts most.
fn headings(line: &str, known: [Option<usize>; 2]) -> Vec<String> {
    let words: Vec<String> = line.split_whitespace().map(|word| bare(word).to_owned()).collect();
    let cells: Vec<String> = line.trim().split('\t').map(|cell| bare(cell).to_owned()).collect();
    for count in known.into_iter().flatten() {
        if words.len() == count {
            return words;
        }
        if cells.len() == count {
            return cells;
        }
    }
    words
}

/// The headings' own faults.
fn check(table: &Table) -> Result<(), IoError> {
    let line = table.header_line;
    if let Some(column) = table.columns.iter().position(String::is_empty) {
        return Err(IoError::Sto { line, fault: StoFault::EmptyHeading { column: column + 1 } });
    }
    if table.column(TIME).is_none() {
        let headings: Vec<String> = table.columns.iter().take(3).map(|name| format!("'{name}'")).collect();
        let more = if table.columns.len() > 3 { " …" } else { "" };
        let fault = StoFault::NoTime { headings: headings.join(", ") + more };
        return Err(IoError::Sto { line, fault });
    }
    Ok(())
}

/// Notes headings that stand more than once.
fn note_duplicates(table: &mut Table) {
    let (mut seen, mut again) = (HashSet::new(), HashSet::new());
    let mut names: Vec<String> = Vec::new();
    for name in &table.columns {
        if !seen.insert(name) && again.insert(name) {
            names.push(name.clone());
        }
    }
    if !names.is_empty() {
        table.notes.push(TableNote::Duplicate { line: table.header_line, names });
    }
}

fn push(table: &mut Table, line: u64, row: &str) -> Result<(), IoError> {
    let (expected, found) = (table.columns.len(), row.split_whitespace().count());
    if found != expected {
        return Err(IoError::RowLength { line, found, expected });
    }
    for (column, text) in row.split_whitespace().enumerate() {
        table.values.push(number(table, line, column, text)?);
    }
    table.lines.push(line);
    Ok(())
}

/// A row whose cells hold so many numbers each.
fn push_vectors(table: &mut Table, line: u64, row: &str, parts: &[usize]) -> Result<(), IoError> {
    let row = undressed(row);
    let (expected, found) = (parts.len(), row.split_whitespace().count());
    if found != expected {
        return Err(IoError::RowLength { line, found, expected });
    }
    let mut column = 0;
    for (cell, &parts) in row.split_whitespace().zip(parts) {
        let texts: Vec<&str> = cell.split(',').collect();
        if texts.len() != parts {
            return Err(bad_number(table, line, column, cell));
        }
        for text in texts {
            let value = number(table, line, column, text)?;
            table.values.push(value);
            column += 1;
        }
    }
    table.lines.push(line);
    Ok(())
}

fn number(table: &Table, line: u64, column: usize, text: &str) -> Result<f64, IoError> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| bad_number(table, line, column, text))
}

fn bad_number(table: &Table, line: u64, column: usize, text: &str) -> IoError {
    let name = table.columns.get(column).cloned().unwrap_or_default();
    IoError::Number { line, column: column + 1, name, text: text.chars().take(40).collect() }
}

/// Notes where there are not as many as were told.
fn agree(table: &mut Table, told: Option<(u64, usize)>, what: &'static str, found: impl Fn(&Table) -> usize) {
    let found = found(table);
    if let Some((line, told)) = told.filter(|(_, told)| *told != found) {
        table.notes.push(TableNote::Count { line, what, told, found });
    }
}
