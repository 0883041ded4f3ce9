//! The lines before the frames.

use crate::table::is_around;
use solaris_model::TextError;
use std::ops::Range;

/// What the lines before the frames say.
pub(super) struct Header<'a> {
    /// Values by their names, as they stand.
    values: Vec<(&'a str, &'a str)>,
    /// The markers' names, each with the column of its x.
    pub(super) names: Vec<String>,
    /// Whether names do not stand above the columns that they should.
    pub(super) is_shifted: bool,
    /// Names of coordinates, such as `X1`.
    pub(super) coordinates: usize,
    /// Whether cells stand between tabs.
    pub(super) has_tabs: bool,
    /// The first line that may be a frame.
    pub(super) body: usize,
    /// The line of the names.
    pub(super) line: Range<usize>,
}

/// The lines of a text, each with where it stands, without its end.
pub(super) fn lines(text: &str) -> Vec<Range<usize>> {
    let mut all = Vec::new();
    let mut start = text.len() - text.trim_start_matches('\u{feff}').len();
    while start < text.len() {
        let rest = &text[start..];
        let length = rest.find(['\n', '\r']).unwrap_or(rest.len());
        all.push(start..start + length);
        start += length + if rest[length..].starts_with("\r\n") { 2 } else { 1 };
    }
    all
}

/// The cells of a line, each with where it stands, without blanks around it.
pub(super) fn cells(text: &str, line: &Range<usize>, has_tabs: bool) -> Vec<Range<usize>> {
    let words = &text[line.clone()];
    let mut all = Vec::new();
    let mut start = 0;
    for cell in words.split(|c: char| if has_tabs { c == '\t' } else { c.is_whitespace() }) {
        let first = line.start + start + (cell.len() - cell.trim_start().len());
        let trimmed = cell.trim();
        if has_tabs || !trimmed.is_empty() {
            all.push(first..first + trimmed.len());
        }
        start += cell.len() + words[start + cell.len()..].chars().next().map_or(0, char::len_utf8);
    }
    all
}

impl<'a> Header<'a> {
    pub(super) fn read(text: &'a str, lines: &[Range<usize>]) -> Result<Self, TextError> {
        let is_names = |line: &&Range<usize>| {
            let line = text[(*line).clone()].trim_start().trim_start_matches('"');
            line.get(..5).is_some_and(|start| start.eq_ignore_ascii_case("frame"))
        };
        let at = lines.iter().position(|line| is_names(&line)).ok_or_else(|| {
            let message = "there is no line 'Frame# Time …' with the markers' names; a TRC file needs one before its frames";
            TextError::one(text, 0..lines.first().map_or(0, |line| line.end), message)
        })?;
        let line = lines[at].clone();
        let has_tabs = text[line.clone()].contains('\t');
        let values = values(text, &lines[..at]);
        let labels = cells(text, &line, has_tabs);
        let next = lines.get(at + 1).map(|line| cells(text, line, has_tabs)).unwrap_or_default();
        let is_coordinate = |cell: &Range<usize>| {
            let cell = &text[cell.clone()];
            cell.starts_with(['X', 'Y', 'Z', 'x', 'y', 'z']) && cell[1..].chars().all(|c| c.is_ascii_digit())
        };
        let coordinates = next.iter().filter(|cell| is_coordinate(cell)).count();
        let (names, is_shifted) = names(text, &labels, has_tabs);
        let body = at + if coordinates > 0 { 2 } else { 1 };
        Ok(Self { values, names, is_shifted, coordinates, has_tabs, body, line })
    }

    /// What the header says of `key`.
    pub(super) fn value(&self, key: &str) -> Option<&'a str> {
        let found = self.values.iter().find(|(known, _)| known.eq_ignore_ascii_case(key))?;
        Some(found.1).filter(|value| !value.is_empty())
    }

    /// The number that the header says of `key`.
    pub(super) fn number(&self, key: &str) -> Option<f64> {
        self.value(key)?.replace(',', ".").parse().ok().filter(|value: &f64| value.is_finite())
    }
}

/// The names and values of the header: a line of names with `DataRate` or `Units` among them, and one of values below it. They
/// belong together in their order where there are as many, and else by their columns.
fn values<'a>(text: &'a str, lines: &[Range<usize>]) -> Vec<(&'a str, &'a str)> {
    let words = |line: &Range<usize>| -> Vec<&'a str> {
        let has_tabs = text[line.clone()].contains('\t');
        cells(text, line, has_tabs).into_iter().map(|cell| &text[cell]).collect()
    };
    let is_key = |key: &&str| key.eq_ignore_ascii_case("DataRate") || key.eq_ignore_ascii_case("Units");
    let Some(pair) = lines.windows(2).find(|pair| words(&pair[0]).iter().any(is_key)) else {
        return Vec::new();
    };
    let (keys, found) = (words(&pair[0]), words(&pair[1]));
    let filled = |words: &[&'a str]| -> Vec<&'a str> {
        words.iter().copied().filter(|word| !word.is_empty()).collect()
    };
    let (whole, own) = (filled(&keys), filled(&found));
    if whole.len() == own.len() {
        return whole.into_iter().zip(own).collect();
    }
    keys.into_iter().zip(found).collect()
}

/// A marker's name without the quotes, blanks and marks around it.
pub(super) fn bare_name(cell: &str) -> &str {
    cell.trim_matches(|c| c == '"' || is_around(c))
}

/// The markers' names, and whether they stand elsewhere than every third column from the third.
fn names(text: &str, labels: &[Range<usize>], has_tabs: bool) -> (Vec<String>, bool) {
    let own = |cell: &Range<usize>| bare_name(&text[cell.clone()]).to_owned();
    let labels = labels.get(2..).unwrap_or_default();
    let filled = || labels.iter().enumerate().filter(|(_, cell)| !cell.is_empty());
    if !has_tabs {
        return (labels.iter().map(own).collect(), false);
    }
    if filled().all(|(column, _)| column.is_multiple_of(3)) {
        let count = filled().next_back().map_or(0, |(column, _)| column / 3 + 1);
        return (labels.iter().step_by(3).take(count).map(own).collect(), false);
    }
    (filled().map(|(_, cell)| own(cell)).collect(), true)
}
