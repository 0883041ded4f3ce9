//! The frames.

use super::header::{Header, cells};
use solaris_model::{TextError, Vector3};
use std::ops::Range;

/// The frames as they stand.
pub(super) struct Rows {
    /// The number that the first frame has.
    pub(super) first: Option<i64>,
    /// The times (s), where there are some, and where they stand.
    pub(super) time: Vec<(Option<f64>, Range<usize>)>,
    /// Markers of a frame: those of the header, or more where lines are longer.
    pub(super) markers: usize,
    /// Frame by frame, in the file's unit; NaN where hidden.
    pub(super) points: Vec<Vector3<f64>>,
    /// Whether numbers have decimal commas.
    pub(super) has_commas: bool,
    /// Points that were known in part.
    pub(super) halves: usize,
    /// Lines that are shorter than the table.
    pub(super) short: usize,
}

/// The most points of all frames together that a text of `length` bytes may ask for by leaving out cells.
fn most(length: usize) -> usize {
    1_000_000 + 4 * length
}

/// Reads the frames of a table.
pub(super) fn rows(text: &str, lines: &[Range<usize>], header: &Header<'_>) -> Result<Rows, TextError> {
    let mut table = Vec::new();
    for line in lines.get(header.body..).unwrap_or_default() {
        let cells = cells(text, line, header.has_tabs);
        if cells.iter().any(|cell| !cell.is_empty()) {
            table.push(cells);
        }
    }
    let filled =
        |cells: &Vec<Range<usize>>| cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |at| at + 1);
    let widest = table.iter().map(filled).max().unwrap_or(0);
    let markers = header.names.len().max(widest.saturating_sub(2).div_ceil(3));
    let mut rows = Rows {
        first: None,
        time: Vec::with_capacity(table.len()),
        markers,
        points: Vec::new(),
        has_commas: false,
        halves: 0,
        short: 0,
    };
    if markers.saturating_mul(table.len()) > most(text.len()) {
        let message = format!(
            "{markers} markers in {} frames of mostly empty lines are more than the file has room for; write out its cells",
            table.len()
        );
        return Err(TextError::one(text, header.line.clone(), message));
    }
    for cells in table {
        rows.row(text, &cells, header)?;
    }
    Ok(rows)
}

impl Rows {
    fn row(&mut self, text: &str, cells: &[Range<usize>], header: &Header<'_>) -> Result<(), TextError> {
        let wanted = 2 + 3 * self.markers;
        let whole = cells.first().map_or(0, |cell| cell.start)..cells.last().map_or(0, |cell| cell.end);
        if cells.len() != wanted && !header.has_tabs {
            let message = format!(
                "this line has {} numbers, and {} markers need {wanted}; without tabs nobody can tell which is missing",
                cells.len(),
                self.markers
            );
            return Err(TextError::one(text, whole, message));
        }
        self.short += usize::from(cells.len() < wanted);
        let frame = cells.first().map_or("", |cell| &text[cell.clone()]);
        if self.time.is_empty() {
            self.first =
                frame.parse::<f64>().ok().filter(|frame| frame.is_finite()).map(|frame| frame as i64);
        }
        let time = cells.get(1).cloned().unwrap_or(whole.end..whole.end);
        let at = self.number(text, &time, "the time")?;
        self.time.push((at, if time.is_empty() { whole } else { time }));
        for marker in 0..self.markers {
            let mut point = Vector3::repeat(f64::NAN);
            for (axis, value) in point.iter_mut().enumerate() {
                if let Some(cell) = cells.get(2 + 3 * marker + axis) {
                    *value = self.number(text, cell, "a coordinate")?.unwrap_or(f64::NAN);
                }
            }
            let known = point.iter().filter(|value| !value.is_nan()).count();
            if known == 1 || known == 2 {
                self.halves += 1;
                point = Vector3::repeat(f64::NAN);
            }
            self.points.push(point);
        }
        Ok(())
    }

    /// The number of a cell; `None` of a blank one or of NaN.
    fn number(&mut self, text: &str, cell: &Range<usize>, what: &str) -> Result<Option<f64>, TextError> {
        let word = &text[cell.clone()];
        if word.is_empty() {
            return Ok(None);
        }
        let mut value = word.parse::<f64>();
        if value.is_err() && word.contains(',') && !word.contains('.') {
            value = word.replacen(',', ".", 1).parse();
            self.has_commas |= value.is_ok();
        }
        match value {
            Ok(value) if value.is_nan() => Ok(None),
            Ok(value) if value.is_finite() => Ok(Some(value)),
            _ => {
                let shown: String = word.chars().take(40).collect();
                let message =
                    format!("{what} is '{shown}'; it must be a number, or blank where the marker was hidden");
                Err(TextError::one(text, cell.clone(), message))
            }
        }
    }
}
