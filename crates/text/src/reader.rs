//! Reads a tree piece by piece, and gathers every fault on the way.

mod fields;
mod values;

pub use fields::Fields;

use crate::error::{Fault, TextError};
use crate::expected::{Expected, ExpectedKind};
use crate::layout::quoted;
use crate::nearest::nearest;
use crate::node::Node;
use std::ops::Range;

/// Reads values of a tree, and keeps what is wrong with them.
///
/// Each method answers `None` where its value cannot be used, and has then said why; the reading goes on, so that all
/// faults are found at once.
#[derive(Debug, Default)]
pub struct Reader {
    faults: Vec<Fault>,
    /// The place that somebody asks about.
    asked: Option<usize>,
    expected: Vec<Expected>,
    /// What words of others are sought in, or beside, they, and what to write instead.
    words: &'static [(&'static str, &'static str, &'static str)],
}

impl Reader {
    /// A reader that takes note of what may stand at a byte of the text.
    pub fn asked_at(at: usize) -> Self {
        Self { asked: Some(at), ..Self::default() }
    }

    /// A reader without faults that takes note of the same place, to be [appended](Self::append) to this one.
    #[must_use]
    pub fn beside(&self) -> Self {
        Self { asked: self.asked, words: self.words, ..Self::default() }
    }

    /// From now on a message about one of these words, where it is not known, says what to write instead, the third of each; the first is the
    /// group that it is a field of, or a word that could stand in its place.
    pub fn explain(&mut self, words: &'static [(&'static str, &'static str, &'static str)]) {
        self.words = words;
    }

    /// Whether it takes note of what may stand somewhere: what is read is of no use then.
    pub fn is_asked(&self) -> bool {
        self.asked.is_some()
    }

    /// What may stand at the byte that was asked about; nothing where no reader came there.
    pub fn into_expected(self) -> Vec<Expected> {
        self.expected
    }

    /// Takes note of what may stand at the bytes of `span`, if these are asked about.
    pub fn expect<N: Into<String>>(
        &mut self,
        span: &Range<usize>,
        kind: ExpectedKind,
        of: &str,
        names: impl IntoIterator<Item = N>,
    ) {
        if self.asked.is_some_and(|at| (span.start..=span.end).contains(&at)) {
            let names = names.into_iter().map(Into::into).collect();
            self.expected.push(Expected { span: span.clone(), kind, of: of.to_owned(), names });
        }
    }

    /// Adds a fault of the bytes of `span`.
    pub fn fault(&mut self, span: Range<usize>, message: impl Into<String>) {
        self.fault_meaning(span, message, None);
    }

    /// The same where it may be known what was meant: what would stand in place of these bytes, with its quotes where it needs some.
    pub fn fault_meaning(&mut self, span: Range<usize>, message: impl Into<String>, instead: Option<String>) {
        self.faults.push(Fault { span, message: message.into(), instead });
    }

    /// A fault of a name in quotes that is not one of `names`; after the message stands the nearest of these.
    pub fn unknown_name<'m>(
        &mut self,
        span: Range<usize>,
        message: &str,
        name: &str,
        names: impl Iterator<Item = &'m str>,
    ) {
        let near = nearest(name, names);
        let hint = near.as_ref().map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
        self.fault_meaning(span, format!("{message}{hint}"), near.as_deref().map(quoted));
    }

    /// How many faults there are by now: whether something that was read since could be used.
    pub fn count(&self) -> usize {
        self.faults.len()
    }

    /// All faults as the error of `text`, if there are any.
    ///
    /// # Errors
    ///
    /// [`TextError`] with every fault, in the order of the text.
    pub fn finish(self, text: &str) -> Result<(), TextError> {
        if self.faults.is_empty() { Ok(()) } else { Err(TextError::new(text, self.faults)) }
    }

    /// All faults.
    pub fn into_faults(self) -> Vec<Fault> {
        self.faults
    }

    /// Adds the faults of another reader.
    pub fn append(&mut self, other: Self) {
        self.faults.extend(other.faults);
        self.expected.extend(other.expected);
    }

    /// The entries of a map; `what` it is and an `example` of it begin and end the message.
    pub fn entries<'n, 'a>(
        &mut self,
        node: &'n Node<'a>,
        what: &str,
        example: &str,
    ) -> Option<&'n [(Node<'a>, Node<'a>)]> {
        let entries = node.entries();
        if entries.is_none() {
            self.fault(node.place(), format!("{what} must be a map {example}, not {}", node.describe()));
        }
        entries
    }

    /// Whether a text is of a later version than `known`, so that nothing can be said of the rest; a version that is none,
    /// or is missing where it is `required`, is a fault. `noun` is what the text is.
    pub fn is_later(&mut self, fields: &Fields<'_, '_>, noun: &str, known: u32, required: bool) -> bool {
        let known_number = f64::from(known);
        let Some(node) = fields.get("version") else {
            if required {
                self.fault(fields.at.clone(), format!("the {noun} has no version; add version: {known}"));
            }
            return false;
        };
        let Some(version) = self.number(node, "the version") else { return false };
        if version > known_number {
            let message = format!(
                "this {noun} is written in version {version} of the grammar, and only version {known} is known here; \
                 read it with a later Solaris"
            );
            self.fault(node.span.clone(), message);
        } else if version < known_number {
            let message = format!("there is no version {version}; the only one is {known}");
            self.fault(node.span.clone(), message);
        }
        version > known_number
    }
}
