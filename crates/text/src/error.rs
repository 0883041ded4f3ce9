//! Everything that is wrong with a text.

use crate::place::Place;
use std::fmt;
use std::ops::Range;

/// One fault of a text, and where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextFault {
    /// Where.
    pub place: Place,
    /// What is wrong, with its value, and what to do.
    pub message: String,
}

/// Everything that is wrong with a text, in the order of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextError {
    /// The first [`TextError::MOST`] faults, at least one.
    pub faults: Vec<TextFault>,
    /// How many more there are.
    pub omitted: usize,
}

impl TextError {
    /// The most faults that are kept.
    pub const MOST: usize = 100;

    /// Of faults given by their bytes and messages, in any order.
    pub fn new(text: &str, mut faults: Vec<(Range<usize>, String)>) -> Self {
        faults.sort_by_key(|(span, _)| span.start);
        let omitted = faults.len().saturating_sub(Self::MOST);
        faults.truncate(Self::MOST);
        let placed = |(span, message)| TextFault { place: Place::of(text, span), message };
        Self { faults: faults.into_iter().map(placed).collect(), omitted }
    }

    /// Of one fault.
    pub fn one(text: &str, span: Range<usize>, message: impl Into<String>) -> Self {
        Self::new(text, vec![(span, message.into())])
    }
}

impl fmt::Display for TextError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, fault) in self.faults.iter().enumerate() {
            let newline = if i > 0 { "\n" } else { "" };
            write!(f, "{newline}{}: {}", fault.place, fault.message)?;
        }
        if self.omitted > 0 { write!(f, "\nand {} more", self.omitted) } else { Ok(()) }
    }
}

impl std::error::Error for TextError {}
