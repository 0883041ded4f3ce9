//! A text to a table.

use super::StoFault;
use crate::error::IoError;
use crate::table::Table;

/// What ends the header.
const END: &str = "endheader";

/// Reads a `.mot` or `.sto` table.
///
/// # Errors
///
/// [`IoError::Sto`] where the header is wrong or disagrees with what follows, [`IoError::DuplicateColumn`],
/// [`IoError::RowLength`] and [`IoError::Number`], all with their lines from 1.
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
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = (1_u64..).zip(text.split('\n').map(|line| line.trim_end_matches('\r')));
    let header = Header::read(&mut lines)?;
    let mut lines = lines.filter(|(_, line)| !line.trim().is_empty());
    let (header_line, line) =
        lines.next().ok_or(IoError::Sto { line: header.end, fault: StoFault::NoHeadings })?;
    let columns = headings(line, header.columns.map(|(_, count)| count));
    let (title, in_degrees) = (header.title, header.in_degrees);
    let mut table = Table { title, in_degrees, columns, values: Vec::new(), lines: Vec::new(), header_line };
    check(&table, header.columns)?;
    for (line, row) in lines {
        push(&mut table, line, row)?;
    }
    agree(header.rows, "rows", table.len())?;
    Ok(table)
}

/// What the lines before `endheader` say.
#[derive(Default)]
struct Header {
    title: String,
    in_degrees: Option<bool>,
    /// The line that tells the number of rows, and the number.
    rows: Option<(u64, usize)>,
    columns: Option<(u64, usize)>,
    /// The line that ends the header.
    end: u64,
}

impl Header {
    fn read<'a>(lines: &mut impl Iterator<Item = (u64, &'a str)>) -> Result<Self, IoError> {
        let mut header = Self::default();
        let mut first = true;
        let mut last = 1;
        for (number, line) in lines {
            let line = line.trim();
            last = number;
            if line.is_empty() {
                continue;
            }
            let (key, rest) = line.split_once([' ', '\t', '=']).unwrap_or((line, ""));
            let rest = rest.trim_start_matches([' ', '\t', '=']);
            match key {
                END => return Ok(Self { end: number, ..header }),
                "nRows" | "nr" | "datarows" => {
                    header.rows = Some((number, count(number, key, rest, "rows")?));
                }
                "nColumns" | "nc" | "datacolumns" => {
                    header.columns = Some((number, count(number, key, rest, "columns")?));
                }
                "inDegrees" => header.in_degrees = Some(degrees(number, rest)?),
                "Angles" if header.in_degrees.is_none() => {
                    header.in_degrees = angles(line);
                }
                "name" => rest.clone_into(&mut header.title),
                _ if first && !is_key(key) => line.clone_into(&mut header.title),
                _ => {}
            }
            first = false;
        }
        Err(IoError::Sto { line: last, fault: StoFault::NoEnd })
    }
}

/// Whether a header's line that begins so is no title.
pub(super) fn is_key(word: &str) -> bool {
    const KEYS: [&str; 14] = [
        "name",
        "nRows",
        "nr",
        "datarows",
        "nColumns",
        "nc",
        "datacolumns",
        "inDegrees",
        "version",
        "units",
        "Angles",
        "range",
        "nd",
        END,
    ];
    KEYS.contains(&word)
}

fn count(line: u64, key: &str, text: &str, what: &'static str) -> Result<usize, IoError> {
    let fault = || StoFault::NoCount { key: key.to_owned(), text: text.to_owned(), what };
    text.parse().map_err(|_| IoError::Sto { line, fault: fault() })
}

fn degrees(line: u64, text: &str) -> Result<bool, IoError> {
    match text.to_ascii_lowercase().as_str() {
        "yes" | "y" | "true" => Ok(true),
        "no" | "n" | "false" => Ok(false),
        _ => Err(IoError::Sto { line, fault: StoFault::Degrees { text: text.to_owned() } }),
    }
}

/// What the sentence of older files says.
fn angles(line: &str) -> Option<bool> {
    match line.trim_end_matches('.') {
        "Angles are in degrees" => Some(true),
        "Angles are in radians" => Some(false),
        _ => None,
    }
}

/// The headings of a line: words, or what stands between tabs where only that gives the number that was told.
fn headings(line: &str, told: Option<usize>) -> Vec<String> {
    let words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
    let cells: Vec<String> = line.trim_end().split('\t').map(|cell| cell.trim().to_owned()).collect();
    if told != Some(words.len()) && told == Some(cells.len()) { cells } else { words }
}

/// The headings' own faults.
fn check(table: &Table, told: Option<(u64, usize)>) -> Result<(), IoError> {
    let line = table.header_line;
    if let Some(column) = table.columns.iter().position(String::is_empty) {
        return Err(IoError::Sto { line, fault: StoFault::EmptyHeading { column: column + 1 } });
    }
    agree(told, "columns", table.columns.len())?;
    table.check_headings()?;
    if table.column("time").is_none() {
        let headings: Vec<String> = table.columns.iter().take(3).map(|name| format!("'{name}'")).collect();
        let more = if table.columns.len() > 3 { " …" } else { "" };
        let fault = StoFault::NoTime { headings: headings.join(", ") + more };
        return Err(IoError::Sto { line, fault });
    }
    Ok(())
}

fn push(table: &mut Table, line: u64, row: &str) -> Result<(), IoError> {
    let (expected, found) = (table.columns.len(), row.split_whitespace().count());
    if found != expected {
        return Err(IoError::RowLength { line, found, expected });
    }
    for (column, text) in row.split_whitespace().enumerate() {
        let Some(number) = text.parse::<f64>().ok().filter(|number| number.is_finite()) else {
            let (name, text) = (table.columns[column].clone(), text.chars().take(40).collect());
            return Err(IoError::Number { line, column: column + 1, name, text });
        };
        table.values.push(number);
    }
    table.lines.push(line);
    Ok(())
}

/// Whether there are as many as were told.
fn agree(told: Option<(u64, usize)>, what: &'static str, found: usize) -> Result<(), IoError> {
    match told {
        Some((line, told)) if told != found => {
            Err(IoError::Sto { line, fault: StoFault::Count { what, told, found } })
        }
        _ => Ok(()),
    }
}
