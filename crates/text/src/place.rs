//! Places in a text.

use std::fmt;
use std::ops::Range;

/// A place in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Its bytes.
    pub span: Range<usize>,
    /// Its line, from 1.
    pub line: usize,
    /// Its first character in that line, from 1.
    pub column: usize,
}

impl Place {
    /// The place of these bytes of `text`; what lies beyond the text is its end.
    pub fn of(text: &str, span: Range<usize>) -> Self {
        let mut start = span.start.min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &text[..start];
        let first = before.rfind('\n').map_or(0, |newline| newline + 1);
        let (line, column) = (before.matches('\n').count() + 1, before[first..].chars().count() + 1);
        Self { span: start..span.end.clamp(start, text.len()), line, column }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}", self.line, self.column)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_in_lines_and_characters() {
        let text = "é: 1,\n  ü: 2";
        let found = text.find('2').map_or(0..0, |at| at..at + 1);
        assert_eq!(Place::of(text, found.clone()), Place { span: found, line: 2, column: 6 });
        // Inside of a character, and beyond the end.
        assert_eq!(Place::of(text, 1..3).span.start, 0);
        assert_eq!(Place::of(text, 90..95).span, text.len()..text.len());
    }
}
