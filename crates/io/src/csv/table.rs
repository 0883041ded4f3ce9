//! Any table of numbers, from and to text.

use super::write::{number, writing};
use crate::error::IoError;
use crate::table::{TIME, Table, bare, check_name};
use csv::{ReaderBuilder, StringRecord, Trim};
use std::io::Write;

/// What a message calls this format.
pub(super) const FORMAT: &str = "CSV";

/// The most characters of a field that a message repeats.
const REPEATED: usize = 40;

/// Reads a table of numbers below one line of headings.
///
/// # Errors
///
/// [`IoError`] with the line and the column, both from 1: a text without headings, headings between semicolons or tabs, one that is
/// empty or stands twice, a row with too few or too many fields, a field that is no finite number.
///
/// ```
/// let table = solaris_io::csv::read_table("time,knee.q\r\n0,1.5\r\n0.1,2e-3\r\n")?;
/// assert_eq!((table.len(), table.row(1)), (2, &[0.1, 0.002][..]));
/// let error = solaris_io::csv::read_table("time,knee.q\n0,1,5\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2 has 3 fields, the header has 2");
/// # Ok::<(), solaris_io::IoError>(())
/// ```
pub fn read_table(text: &str) -> Result<Table, IoError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader =
        ReaderBuilder::new().has_headers(false).flexible(true).trim(Trim::All).from_reader(text.as_bytes());
    check_lines(text)?;
    let (mut table, mut record, mut lines) = (Table::default(), StringRecord::new(), Lines::new(text));
    // Text in memory is UTF-8 and any row length is taken, so the reader itself has nothing to refuse.
    while reader.read_record(&mut record).map_err(writing)? {
        let line = lines.of(record.position().map_or(0, csv::Position::byte));
        Table::check_width(line, record.len())?;
        if table.columns.is_empty() {
            table.columns = record.iter().map(|name| bare(name).to_owned()).collect();
            table.header_line = line;
            check_header(&table)?;
            continue;
        }
        if record.len() != table.columns.len() {
            return Err(IoError::RowLength { line, found: record.len(), expected: table.columns.len() });
        }
        for (i, field) in record.iter().enumerate() {
            let value = field.parse().ok().filter(|value: &f64| value.is_finite());
            table.values.push(value.ok_or_else(|| {
                let (name, text) = (shortened(&table.columns[i]), shortened(field));
                IoError::Number { line, column: i + 1, name, text }
            })?);
        }
        table.lines.push(line);
    }
    if table.columns.is_empty() { Err(IoError::NoHeader) } else { Ok(table) }
}

/// Refuses lines of more fields than are kept, for which the reader itself would ask for a gigabyte.
pub(super) fn check_lines(text: &str) -> Result<(), IoError> {
    for (line, text) in (1..).zip(text.split('\n')) {
        if text.len() > Table::MOST_COLUMNS {
            Table::check_width(line, text.bytes().filter(|byte| *byte == b',').count() + 1)?;
        }
    }
    Ok(())
}

/// Counts lines. The reader counts a line end of Windows to the line after it.
pub(super) struct Lines<'a> {
    text: &'a [u8],
    counted: usize,
    line: u64,
}

impl<'a> Lines<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text: text.as_bytes(), counted: 0, line: 1 }
    }

    /// The line (from 1) of the record that the reader has found from this byte on; later records only.
    pub(super) fn of(&mut self, byte: u64) -> u64 {
        let mut start = byte as usize;
        while matches!(self.text.get(start), Some(b'\r' | b'\n')) {
            start += 1;
        }
        for i in self.counted..start {
            let ends = match self.text[i] {
                b'\n' => true,
                b'\r' => self.text.get(i + 1) != Some(&b'\n'),
                _ => false,
            };
            self.line += u64::from(ends);
        }
        self.counted = self.counted.max(start);
        self.line
    }
}

pub(super) fn check_header(table: &Table) -> Result<(), IoError> {
    let line = table.header_line;
    if let [only] = &table.columns[..] {
        let other = [(';', "semicolons"), ('\t', "tabs")].into_iter().find(|(mark, _)| only.contains(*mark));
        if let Some((_, separator)) = other {
            return Err(IoError::Separator { line, separator });
        }
    }
    if let Some(i) = table.columns.iter().position(String::is_empty) {
        return Err(IoError::EmptyHeading { line, column: i + 1 });
    }
    if let Some(i) = table.columns.iter().position(|name| name.contains(['\n', '\r'])) {
        return Err(IoError::OpenHeading { line, column: i + 1 });
    }
    table.check_headings()
}

/// What fits in one line of a message.
fn shortened(field: &str) -> String {
    let mut text: String =
        field.chars().take(REPEATED).map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    if text.len() < field.len() && field.chars().count() > REPEATED {
        text.push('…');
    }
    text
}

/// Writes a table: its headings and one row a line. Title and units of the table are not written.
///
/// Numbers have the fewest digits that read back to the same bits.
///
/// # Errors
///
/// A table in degrees: nothing in CSV says so; headings that would not be read, such as one that stands twice; a number that is
/// not finite; the writer's own errors.
pub fn write_table(table: &Table, out: &mut impl Write) -> Result<(), IoError> {
    if table.in_degrees == Some(true) {
        return Err(IoError::DegreesWithoutFigure);
    }
    check_header(table)?;
    table.columns.iter().try_for_each(|name| check_name(name, FORMAT))?;
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(&table.columns).map_err(writing)?;
    let (mut text, time) = (Vec::new(), table.column(TIME));
    for index in 0..table.len() {
        let row = table.row(index);
        for (value, column) in row.iter().zip(&table.columns) {
            if !value.is_finite() {
                let time = time.map_or(index as f64, |time| row[time]);
                return Err(IoError::NotFinite { column: column.clone(), time, value: *value });
            }
            text.clear();
            number(*value, &mut text)?;
            writer.write_field(&text).map_err(writing)?;
        }
        writer.write_record(None::<&[u8]>).map_err(writing)?;
    }
    Ok(writer.flush()?)
}
