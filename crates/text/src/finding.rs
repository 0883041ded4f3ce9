//! Findings: what there is to say of a text, short of a fault.

use crate::place::Place;
use std::fmt;

/// What kind of thing a reader or a check has to say, short of a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FindingKind {
    /// Something that acts and is not in what was read: forces differ from those of the program that the text was made for.
    Missing,
    /// Something that looks wrong.
    Suspect,
    /// Something in the text that has no place in what is read and was left out.
    Unsupported,
    /// Something that was done on the way.
    Note,
}

/// Something to know about a text, or about what was read from it, that does not keep it from being read.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What kind.
    pub kind: FindingKind,
    /// What it is about: a name, an element of the file.
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
