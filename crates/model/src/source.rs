//! Source maps: places in a text that describes a figure, and the findings about them.

use crate::fault::{Fault, FigureError, Part};
use std::collections::HashMap;
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

/// One fault of a text, and where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextFault {
    /// Where.
    pub place: Place,
    /// What is wrong, with its value, and what to do.
    pub message: String,
}

/// The error of a text: everything that is wrong with it, in the order of the text.
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

/// The source map of a figure: where in a text its parts are described, down to single fields (`mass`, `inertia`, `parent`, …) where the
/// reader says so.
#[derive(Clone, Debug, Default)]
pub struct SourceMap {
    places: HashMap<(Part, String, &'static str), Range<usize>>,
}

impl SourceMap {
    /// Says where a part is; the first place of a name stays.
    pub fn put(&mut self, part: Part, name: &str, span: Range<usize>) {
        self.put_field(part, name, "", span);
    }

    /// Says where a field of a part is.
    pub fn put_field(&mut self, part: Part, name: &str, field: &'static str, span: Range<usize>) {
        self.places.entry((part, name.to_owned(), field)).or_insert(span);
    }

    /// Where a part is.
    pub fn get(&self, part: Part, name: &str) -> Option<&Range<usize>> {
        self.field(part, name, "")
    }

    pub(crate) fn field(&self, part: Part, name: &str, field: &'static str) -> Option<&Range<usize>> {
        self.places.get(&(part, name.to_owned(), field))
    }

    /// The place of what a fault is about: its field, or else its part, or else the whole text.
    pub fn find(&self, fault: &Fault) -> Option<Range<usize>> {
        let (part, name, field) = fault.subject();
        let narrow = self.field(part, name, field).or_else(|| self.get(part, name));
        // A dof without a place of its own stands in its joint.
        let joint = name.rsplit_once('.').map_or(name, |(joint, _)| joint);
        let wider =
            (part == Part::Dof).then(|| self.get(Part::Joint, joint).or_else(|| self.get(Part::Joint, name)));
        narrow.or(wider.flatten()).cloned()
    }

    /// The faults of a figure with the places of the text that caused them.
    pub fn locate(&self, text: &str, error: &FigureError) -> TextError {
        let whole = self.get(Part::Figure, "").cloned().unwrap_or(0..0);
        let place = |fault| self.find(fault).unwrap_or_else(|| whole.clone());
        TextError::new(text, error.faults.iter().map(|fault| (place(fault), fault.to_string())).collect())
    }
}

/// The kind of a finding: what a reader or a check has to say, short of a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FindingKind {
    /// Something that looks wrong.
    Suspect,
    /// Something in the text that has no place in a figure and was left out.
    Unsupported,
    /// Something that was done on the way.
    Note,
}

/// A finding: something to know about a figure that does not keep it from being one.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What kind.
    pub kind: FindingKind,
    /// What it is about: a link, a joint, an element of the file.
    pub subject: String,
    /// What there is to say, with values.
    pub message: String,
    /// Where in the text, if it comes from one.
    pub place: Option<Place>,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(f, "{place}: ")?;
        }
        write!(f, "{}: {}", self.subject, self.message)
    }
}
