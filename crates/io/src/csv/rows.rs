//! Tables of any text, from and to CSV.

use super::table::{Lines, check_header, check_lines};
use super::write::{number, writing};
use crate::error::IoError;
use crate::table::{Table, bare};
use csv::{ReaderBuilder, StringRecord, Terminator, Trim, WriterBuilder};
use std::io::Write;

/// Named columns of text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// Headings, all different.
    pub columns: Vec<String>,
    /// What stands below them.
    pub rows: Vec<Row>,
}

/// A row of a table of text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// The line of the text (from 1) that it stands in.
    pub line: u64,
    /// Its fields; there may be more or fewer of them than headings.
    pub fields: Vec<String>,
}

/// Reads a table of text below one line of headings. A row may have too few or too many fields: whoever reads it knows
/// what that means.
///
/// # Errors
///
/// [`IoError`] with line and column, both from 1: a text without headings, headings between semicolons or tabs, one that
/// is empty or stands twice.
///
/// ```
/// let table = solaris_io::csv::read_rows("height,who\n1.75,\"Ann, Bob\"\n1.6\n")?;
/// assert_eq!(table.columns, ["height", "who"]);
/// assert_eq!(table.rows[0].fields, ["1.75", "Ann, Bob"]);
/// assert_eq!((table.rows[1].line, table.rows[1].fields.len()), (3, 1));
/// # Ok::<(), solaris_io::IoError>(())
/// ```
pub fn read_rows(text: &str) -> Result<Rows, IoError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader =
        ReaderBuilder::new().has_headers(false).flexible(true).trim(Trim::All).from_reader(text.as_bytes());
    check_lines(text)?;
    let (mut out, mut record, mut lines) = (Rows::default(), StringRecord::new(), Lines::new(text));
    // Text in memory is UTF-8 and any row length is taken, so the reader itself has nothing to refuse.
    while reader.read_record(&mut record).map_err(writing)? {
        let line = lines.of(record.position().map_or(0, csv::Position::byte));
        Table::check_width(line, record.len())?;
        let mut fields: Vec<String> = record.iter().map(str::to_owned).collect();
        if out.columns.is_empty() {
            for name in &mut fields {
                *name = bare(name).to_owned();
            }
            check_header(&Table { columns: fields.clone(), header_line: line, ..Table::default() })?;
            out.columns = fields;
        } else {
            out.rows.push(Row { line, fields });
        }
    }
    if out.columns.is_empty() { Err(IoError::NoHeader) } else { Ok(out) }
}

/// Writes one row of text, with quotes where a field needs them.
///
/// # Errors
///
/// The writer's own.
pub fn write_row<T: AsRef<[u8]>>(
    fields: impl IntoIterator<Item = T>,
    out: &mut impl Write,
) -> Result<(), IoError> {
    let mut row = Vec::new();
    let mut writer =
        WriterBuilder::new().flexible(true).terminator(Terminator::Any(b'\n')).from_writer(&mut row);
    writer.write_record(fields).map_err(writing)?;
    writer.flush()?;
    drop(writer);
    Ok(out.write_all(&row)?)
}

/// A number with the fewest digits that read back to the same bits, as tables have them.
pub fn number_text(value: f64) -> String {
    let mut text = Vec::new();
    // A vector takes all, and digits are text.
    let _ = number(value, &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        let rows = [vec!["a", "b,c", "d \"e\""], vec!["1", "", "two\nlines"]];
        let mut text = Vec::new();
        for row in &rows {
            write_row(row, &mut text).expect("a vector takes all");
        }
        let text = String::from_utf8(text).expect("text");
        assert_eq!(text, "a,\"b,c\",\"d \"\"e\"\"\"\n1,,\"two\nlines\"\n");
        let table = read_rows(&text).expect("a table");
        assert_eq!(table.columns, rows[0]);
        assert_eq!(table.rows[0].fields, rows[1]);
    }

    #[test]
    fn headings_are_checked() {
        for (text, why) in
            [("", "the table is empty"), ("a,a\n", "'a'"), ("a;b\n", "semicolons"), ("a,,b\n", "column 2")]
        {
            let said = read_rows(text).expect_err(text).to_string();
            assert!(said.contains(why), "{text:?}: {said}");
        }
    }
}
