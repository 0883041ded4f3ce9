//! The list of what a reader does not understand, by name.

use super::{Node, Reader, tag};
use solaris_model::{Finding, FindingKind};
use std::collections::HashMap;
use std::ops::Range;

/// What was met and not read: each name once, with its first place and how often.
#[derive(Default)]
pub(super) struct Unread {
    /// What may matter to the motion.
    parts: Names,
    /// What does not: looks, contacts, the simulator's own affairs.
    asides: Names,
}

#[derive(Default)]
struct Names {
    /// In the order of their first places.
    names: Vec<(String, Range<usize>, usize)>,
    index: HashMap<String, usize>,
}

impl Names {
    fn add(&mut self, name: String, span: Range<usize>) {
        if let Some(&i) = self.index.get(&name) {
            self.names[i].2 += 1;
        } else {
            self.index.insert(name.clone(), self.names.len());
            self.names.push((name, span, 1));
        }
    }
}

impl Unread {
    pub(super) fn findings(&mut self) -> Vec<(Range<usize>, Finding)> {
        let unsupported = |span, subject, message| {
            (span, Finding { kind: FindingKind::Unsupported, subject, message, place: None })
        };
        let mut findings: Vec<_> = std::mem::take(&mut self.parts)
            .names
            .into_iter()
            .map(|(name, span, count)| {
                let times = if count > 1 { format!(" ({count} times)") } else { String::new() };
                unsupported(span, name, format!("not read{times}"))
            })
            .collect();
        let asides = std::mem::take(&mut self.asides).names;
        if let Some((_, first, _)) = asides.first() {
            let names: Vec<String> = asides
                .iter()
                .map(
                    |(name, _, count)| {
                        if *count > 1 { format!("{name} ({count} times)") } else { name.clone() }
                    },
                )
                .collect();
            let message = format!("not read, and not needed for the motion: {}", names.join(", "));
            findings.push(unsupported(first.clone(), "looks and settings".to_owned(), message));
        }
        findings
    }
}

impl Reader<'_> {
    /// An element that may matter to the motion and is not read: `<name>` in the list.
    pub(crate) fn unread_element(&mut self, node: Node) {
        let name = format!("<{}>", node.tag_name().name());
        self.unread.parts.add(name, tag(node));
    }

    /// Something else that may matter and is not read, by a name of its own.
    pub(crate) fn unread(&mut self, name: impl Into<String>, span: Range<usize>) {
        self.unread.parts.add(name.into(), span);
    }

    /// Something that does not matter to the motion: all of these are summed up in one finding by their names.
    pub(crate) fn aside(&mut self, name: impl Into<String>, span: Range<usize>) {
        self.unread.asides.add(name.into(), span);
    }

    /// Lists the attributes of `node` that are not in `known`.
    pub(crate) fn check_attributes(&mut self, node: Node, known: &[&str]) {
        self.check_attributes_but(node, known, &[]);
    }

    /// Lists the attributes of `node` that are not in `known`, those in `asides` as not needed for the motion.
    pub(crate) fn check_attributes_but(&mut self, node: Node, known: &[&str], asides: &[&str]) {
        for attribute in node.attributes() {
            let name = attribute.name();
            if known.contains(&name) && attribute.namespace().is_none() {
                continue;
            }
            let listed = format!("attribute '{name}' of <{}>", node.tag_name().name());
            if asides.contains(&name) {
                self.aside(listed, attribute.range());
            } else {
                self.unread(listed, attribute.range());
            }
        }
    }

    /// Lists the child elements of `node` that are not in `known`, those in `asides` as not needed for the motion.
    pub(crate) fn check_elements(&mut self, node: Node, known: &[&str], asides: &[&str]) {
        for child in super::elements(node) {
            let name = child.tag_name().name();
            if asides.contains(&name) {
                self.aside(format!("<{name}>"), tag(child));
            } else if !known.contains(&name) {
                self.unread_element(child);
            }
        }
    }
}
