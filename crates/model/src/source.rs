//! Where in a text the parts of a figure are described.

use crate::fault::{Fault, FigureError, Part};
use solaris_text::TextError;
use solaris_text::layout::quoted;
use std::collections::HashMap;
use std::ops::Range;

/// Where in a text the parts of a figure are described, down to single fields (`mass`, `inertia`, `parent`, …) where the
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
        let place = |fault: &Fault| self.find(fault).unwrap_or_else(|| whole.clone());
        let located = |fault: &Fault| solaris_text::Fault {
            span: place(fault),
            message: fault.to_string(),
            instead: self.instead(fault),
        };
        TextError::new(text, error.faults.iter().map(located).collect())
    }

    /// What stands at the place of a fault instead, where the place is that of a name and another is near.
    pub(crate) fn instead(&self, fault: &Fault) -> Option<String> {
        let Fault::UnknownParent { nearest: Some(nearest), .. } = fault else { return None };
        let (part, name, field) = fault.subject();
        self.field(part, name, field).map(|_| quoted(nearest))
    }
}
