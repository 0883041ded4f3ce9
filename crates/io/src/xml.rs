//! XML as the importers read it: bounded, every fault with its place, and nothing left out in silence.
//!
//! ```text
//! let document = xml::parse(text, 100)?;             // a tree of nodes, at most so deep
//! let mut reader = Reader::new(text);
//! let root = document.root_element();
//! let mass = reader.number(root, "mass");            // None where it is absent or no number; the latter is a fault
//! reader.check_attributes(root, &["mass"]);          // lists the others
//! let findings = reader.findings();                  // after reader.error(), if that is None
//! ```

#![cfg_attr(
    not(all(feature = "urdf", feature = "mjcf", feature = "opensim", feature = "sdf")),
    allow(dead_code, unused_imports, reason = "each importer uses a part")
)]

mod lacking;
mod mended;
mod numbers;
mod parse;
mod unread;

pub(crate) use mended::mended;
pub(crate) use numbers::text_of;
pub(crate) use parse::parse;

use lacking::Lacking;
use solaris_model::{Finding, FindingKind, Place, TextError};
use std::ops::Range;
use unread::Unread;

/// An element (or text, or comment) of a parsed document.
pub(crate) type Node<'a> = roxmltree::Node<'a, 'a>;

/// Collects what there is to say about a text while it is read: faults, findings, and what was not understood.
pub(crate) struct Reader<'a> {
    text: &'a str,
    faults: Vec<(Range<usize>, String)>,
    findings: Vec<(Range<usize>, Finding)>,
    unread: Unread,
    lacking: Lacking,
    suggestions: usize,
}

impl<'a> Reader<'a> {
    /// The most unknown names for which the nearest known one is looked up; with more, something else is wrong.
    const SUGGESTIONS: usize = 20;

    /// Of nothing yet.
    pub(crate) fn new(text: &'a str) -> Self {
        let (faults, findings) = (Vec::new(), Vec::new());
        Self {
            text,
            faults,
            findings,
            unread: Unread::default(),
            lacking: Lacking::default(),
            suggestions: 0,
        }
    }

    /// The text.
    pub(crate) fn text(&self) -> &'a str {
        self.text
    }

    /// Something that keeps the text from being a figure.
    pub(crate) fn fault(&mut self, span: Range<usize>, message: impl Into<String>) {
        self.faults.push((span, message.into()));
    }

    /// Whether there is a fault so far.
    pub(crate) fn has_faults(&self) -> bool {
        !self.faults.is_empty()
    }

    /// How many faults there are so far.
    pub(crate) fn fault_count(&self) -> usize {
        self.faults.len()
    }

    /// Something that looks wrong.
    pub(crate) fn suspect(
        &mut self,
        span: Range<usize>,
        subject: impl Into<String>,
        message: impl Into<String>,
    ) {
        self.finding(FindingKind::Suspect, span, subject.into(), message.into());
    }

    /// Something that was left out, besides whole elements and attributes: see [`Reader::unread_element`].
    pub(crate) fn unsupported(
        &mut self,
        span: Range<usize>,
        subject: impl Into<String>,
        message: impl Into<String>,
    ) {
        self.finding(FindingKind::Unsupported, span, subject.into(), message.into());
    }

    /// Something that acts and is not in the figure, so that forces differ.
    pub(crate) fn missing(
        &mut self,
        span: Range<usize>,
        subject: impl Into<String>,
        message: impl Into<String>,
    ) {
        self.finding(FindingKind::Missing, span, subject.into(), message.into());
    }

    /// Something that was done on the way.
    pub(crate) fn note(
        &mut self,
        span: Range<usize>,
        subject: impl Into<String>,
        message: impl Into<String>,
    ) {
        self.finding(FindingKind::Note, span, subject.into(), message.into());
    }

    fn finding(&mut self, kind: FindingKind, span: Range<usize>, subject: String, message: String) {
        self.findings.push((span, Finding { kind, subject, message, place: None }));
    }

    /// `; did you mean 'NAME'?` with the nearest of `names`, or nothing: for the end of a message about an unknown name.
    pub(crate) fn hint<'n>(&mut self, wanted: &str, names: impl Iterator<Item = &'n str>) -> String {
        self.suggestions += 1;
        if self.suggestions > Self::SUGGESTIONS || wanted.len() > 200 {
            return String::new();
        }
        solaris_model::nearest(wanted, names)
            .map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
    }

    /// All faults so far, if there are any; what is read more than once, as defaults are, is said once.
    pub(crate) fn error(&mut self) -> Option<TextError> {
        self.faults.sort_by(|a, b| (a.0.start, &a.1).cmp(&(b.0.start, &b.1)));
        self.faults.dedup();
        self.has_faults().then(|| TextError::new(self.text, self.faults.clone()))
    }

    /// All findings, with what was not understood, in the order of the text.
    pub(crate) fn findings(mut self) -> Vec<Finding> {
        self.findings.extend(self.unread.findings());
        self.findings.extend(self.lacking.findings());
        self.findings.sort_by_key(|(span, _)| span.start);
        // One pass over the text for all places.
        let (mut from, mut line, mut column) = (0, 1, 1);
        let mut placed = Vec::with_capacity(self.findings.len());
        for (span, mut finding) in self.findings {
            let mut start = span.start.min(self.text.len());
            while !self.text.is_char_boundary(start) {
                start -= 1;
            }
            let between = self.text.get(from..start).unwrap_or_default();
            line += between.matches('\n').count();
            column = between.rfind('\n').map_or(column, |_| 1)
                + between.rsplit('\n').next().map_or(0, |rest| rest.chars().count());
            from = start;
            finding.place = Some(Place { span: start..span.end.clamp(start, self.text.len()), line, column });
            placed.push(finding);
        }
        placed
    }
}

/// The bytes of an element's opening `<name`, which is what a message about it points at.
pub(crate) fn tag(node: Node) -> Range<usize> {
    let start = node.range().start;
    let name =
        node.document().input_text()[start..].find(|c: char| c.is_whitespace() || c == '>' || c == '/');
    start..start + name.unwrap_or(1)
}

/// The bytes of an attribute's value, or of the element's tag where it has no such attribute.
pub(crate) fn value_span(node: Node, attribute: &str) -> Range<usize> {
    node.attribute_node(attribute).map_or_else(|| tag(node), |attribute| attribute.range_value())
}

/// The element children of `node`.
pub(crate) fn elements(node: Node<'_>) -> impl Iterator<Item = Node<'_>> {
    node.children().filter(roxmltree::Node::is_element)
}

/// The element children of `node` called `name`.
pub(crate) fn elements_called<'a>(node: Node<'a>, name: &str) -> impl Iterator<Item = Node<'a>> {
    elements(node).filter(move |child| child.tag_name().name() == name)
}

/// The first element child of `node` called `name`.
pub(crate) fn element<'a>(node: Node<'a>, name: &str) -> Option<Node<'a>> {
    elements_called(node, name).next()
}

/// A value as a message shows it: on one line, cut where it is long.
pub(crate) fn shown(value: &str) -> String {
    let mut words = value.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((at, _)) = words.char_indices().nth(60) {
        words.truncate(at);
        words.push('…');
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn findings_are_placed_as_faults_are() {
        let text = "<a>\r\n  <b x='ü'/><c y='1'/>\n<b/>\n</a>";
        let document = parse(text, 10).expect("XML");
        let mut reader = Reader::new(text);
        for node in document.descendants().filter(roxmltree::Node::is_element) {
            reader.unread_element(node);
            reader.check_attributes(node, &[]);
        }
        let findings = reader.findings();
        for finding in &findings {
            let place = finding.place.clone().expect("a place");
            assert_eq!(place, Place::of(text, place.span.clone()), "{finding}");
        }
        let said: Vec<String> = findings.iter().map(ToString::to_string).collect();
        assert_eq!(said[1], "line 2, column 3: <b>: not read (2 times)");
        assert_eq!(said[3], "line 2, column 13: <c>: not read");
    }

    #[test]
    fn nesting_costs_no_stack() {
        let text = format!("{}{}", "<a>".repeat(100_000), "</a>".repeat(100_000));
        assert!(parse(&text, usize::MAX).is_ok());
        let error = parse(&text, 100).expect_err("too deep");
        assert_eq!(
            error.to_string(),
            "line 1, column 301: <a> is nested 101 elements deep; at most 100 are read"
        );
    }
}
