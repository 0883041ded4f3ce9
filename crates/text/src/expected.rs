//! What a reader would have taken at a place of a text: what may stand there.

use std::ops::Range;

/// What kind of thing may stand at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExpectedKind {
    /// A field of a group, without quotes and before a colon.
    Field,
    /// A bare word, or the word before brackets.
    Word,
    /// A name in quotes.
    Name,
}

/// What may stand at a place of a text, as the reader knows it that reads this place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected {
    /// What is read there, in bytes; quotes belong to it.
    pub span: Range<usize>,
    /// What kind of thing it must be.
    pub kind: ExpectedKind,
    /// What it is of, for people: the group of a field, what is named.
    pub of: String,
    /// All that may stand there.
    pub names: Vec<String>,
}
