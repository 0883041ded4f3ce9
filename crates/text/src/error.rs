//! Everything that is wrong with a text.

use crate::place::Place;
use std::fmt;
use std::ops::Range;

/// What to write in place of some bytes of a text, so that it says what was meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// The bytes.
    pub span: Range<usize>,
    /// What stands there instead, with its quotes where it needs some.
    pub replacement: String,
}

/// A fault that a reader found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Its bytes.
    pub span: Range<usize>,
    /// What is wrong, with its value, and what to do.
    pub message: String,
    /// What stands there instead, where somebody knows what was meant.
    pub instead: Option<String>,
}

impl From<(Range<usize>, String)> for Fault {
    fn from((span, message): (Range<usize>, String)) -> Self {
        Self { span, message, instead: None }
    }
}

/// One fault of a text, and where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextFault {
    /// Where.
    pub place: Place,
    /// What is wrong, with its value, and what to do.
    pub message: String,
    /// What stands at the place instead, where somebody knows what was meant.
    pub instead: Option<String>,
}

impl TextFault {
    /// The change of the text after which it says what was meant, where somebody knows that: what the message asks by "did you mean".
    ///
    /// ```
    /// use solaris_text::{Reader, parse};
    ///
    /// let text = "Tempo(beets: 110)";
    /// let mut reader = Reader::default();
    /// reader.fields(&parse(text, "tempo", "Tempo(beats: 110)")?, &["Tempo"], &["beats"]);
    /// let error = reader.finish(text).unwrap_err();
    /// let meant = error.faults[0].suggestion().expect("one name is near");
    /// assert_eq!((meant.span, &*meant.replacement), (6..11, "beats"));
    /// # Ok::<(), solaris_text::TextError>(())
    /// ```
    pub fn suggestion(&self) -> Option<Suggestion> {
        let replacement = self.instead.clone()?;
        Some(Suggestion { span: self.place.span.clone(), replacement })
    }
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

    /// Of faults, such as bytes and messages, in any order.
    pub fn new<F: Into<Fault>>(text: &str, faults: Vec<F>) -> Self {
        let mut faults: Vec<Fault> = faults.into_iter().map(Into::into).collect();
        faults.sort_by_key(|fault| fault.span.start);
        let omitted = faults.len().saturating_sub(Self::MOST);
        faults.truncate(Self::MOST);
        let placed =
            |Fault { span, message, instead }| TextFault { place: Place::of(text, span), message, instead };
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
