//! What the lines before `endheader` say.

use super::StoFault;
use crate::error::IoError;

/// What ends the header.
const END: &str = "endheader";

/// What the lines before `endheader` say.
#[derive(Default)]
pub(super) struct Header {
    pub(super) title: String,
    pub(super) in_degrees: Option<bool>,
    /// Whether it says a version.
    pub(super) has_version: bool,
    /// The line that tells the number of rows, and the number.
    pub(super) rows: Option<(u64, usize)>,
    pub(super) columns: Option<(u64, usize)>,
    /// What its cells hold, where it says so.
    pub(super) kind: String,
    /// The line that ends the header.
    pub(super) end: u64,
}

impl Header {
    pub(super) fn read<'a>(lines: &mut impl Iterator<Item = (u64, &'a str)>) -> Result<Self, IoError> {
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
                _ if key.eq_ignore_ascii_case(END) => return Ok(Self { end: number, ..header }),
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
                "version" => header.has_version = true,
                "DataType" => rest.clone_into(&mut header.kind),
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
    const KEYS: [&str; 16] = [
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
        "DataRate",
        "DataType",
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
