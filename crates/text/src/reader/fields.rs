//! Groups of fields: those that there are, those that there must be, those that nobody knows.

use super::Reader;
use crate::expected::ExpectedKind;
use crate::nearest::nearest;
use crate::node::{Content, Group, Named, Node, Value};
use std::ops::Range;

/// The fields of one group.
pub struct Fields<'n, 'a> {
    /// What the group is called.
    pub kind: &'static str,
    /// Where a message about the whole group points.
    pub at: Range<usize>,
    /// Whether there are fields that nobody knows, which may be meant for any that are missing.
    pub flawed: bool,
    found: &'n [(Named<'a>, Node<'a>)],
}

impl<'n, 'a> Fields<'n, 'a> {
    /// The value of a field.
    pub fn get(&self, name: &str) -> Option<&'n Node<'a>> {
        let (_, node) = self.found.iter().find(|(named, _)| named.name == name)?;
        // What is there for the sake of saying that it is not.
        let absent = matches!(node.value, Value::Word("None"));
        (!absent).then(|| some(node))
    }
}

/// Whether it is a group of fields, or one without any.
fn has_fields(group: &Group<'_>) -> bool {
    match &group.content {
        Content::Fields(_) => true,
        Content::Tuple(items) => items.is_empty(),
        Content::List(_) | Content::Map(_) => false,
    }
}

/// The value in `Some(…)`.
fn some<'n, 'a>(node: &'n Node<'a>) -> &'n Node<'a> {
    match node.group() {
        Some(Group { name: Some(Named { name: "Some", .. }), content: Content::Tuple(items) })
            if items.len() == 1 =>
        {
            &items[0]
        }
        _ => node,
    }
}

impl Reader {
    /// The fields of a group that is one of the `kinds`; the first is meant where the group has no name. Fields that are
    /// not `known` are faults, unless none are known yet.
    pub fn fields<'n, 'a>(
        &mut self,
        node: &'n Node<'a>,
        kinds: &[&'static str],
        known: &[&str],
    ) -> Option<Fields<'n, 'a>> {
        let kind = self.kind(node, kinds)?;
        let found: &[_] = match node.group().map(|group| &group.content) {
            Some(Content::Fields(found)) => found,
            Some(Content::Tuple(items)) if items.is_empty() => &[],
            None => &[],
            Some(_) => {
                let message =
                    format!("{kind} takes fields with names, {kind}(name: value, …), not bare values");
                self.fault(node.place(), message);
                return None;
            }
        };
        let mut fields = Fields { kind, at: node.place(), flawed: false, found };
        if !known.is_empty() {
            fields.flawed = self.only_known(&fields, known);
        }
        Some(fields)
    }

    /// Which of the `kinds` the value is.
    pub fn kind(&mut self, node: &Node<'_>, kinds: &[&'static str]) -> Option<&'static str> {
        self.one_of(node, kinds, "(…)")
    }

    /// Which of the `words` the value is.
    pub fn word(&mut self, node: &Node<'_>, words: &[&'static str]) -> Option<&'static str> {
        self.one_of(node, words, "")
    }

    /// One of some words, after which a message shows `brackets`.
    fn one_of(&mut self, node: &Node<'_>, kinds: &[&'static str], brackets: &str) -> Option<&'static str> {
        let wanted = || match kinds {
            [others @ .., last] if !others.is_empty() => {
                format!("{}{brackets} or {last}{brackets}", others.join(&format!("{brackets}, ")))
            }
            _ => kinds.concat() + brackets,
        };
        self.expect(
            &node.head().map_or_else(|| node.place(), |head| head.span),
            ExpectedKind::Word,
            "",
            kinds.iter().copied(),
        );
        match node.head() {
            Some(head) => {
                let found = kinds.iter().find(|kind| **kind == head.name).copied();
                if found.is_none() {
                    let explained = self.explained(head.name, kinds);
                    let near = nearest(head.name, kinds.iter().copied()).filter(|_| explained.is_none());
                    let hint = match (explained, &near) {
                        (Some(explained), _) => explained.to_owned(),
                        (None, Some(near)) => format!("did you mean '{near}'?"),
                        (None, None) => format!("write {}", wanted()),
                    };
                    self.fault_meaning(head.span, format!("'{}' is not known here; {hint}", head.name), near);
                }
                found
            }
            None if kinds.len() == 1 && node.group().is_some_and(has_fields) => Some(kinds[0]),
            None => {
                self.fault(node.place(), format!("{} must stand here, not {}", wanted(), node.describe()));
                None
            }
        }
    }

    /// What to write instead of a word of others in one of these groups, or beside one of these words.
    fn explained(&self, word: &str, at: &[&str]) -> Option<&'static str> {
        let found = self.words.iter().find(|(of, other, _)| *other == word && at.contains(of));
        found.map(|(.., instead)| *instead)
    }

    /// Finds fields that are not `known`, and those given twice; whether there are any.
    pub fn only_known(&mut self, fields: &Fields<'_, '_>, known: &[&str]) -> bool {
        let (kind, before) = (fields.kind, self.faults.len());
        for (i, (named, _)) in fields.found.iter().enumerate() {
            let name = named.name;
            let is_free = |field: &&str| fields.found.iter().all(|(other, _)| other.name != *field);
            self.expect(&named.span, ExpectedKind::Field, kind, known.iter().copied().filter(is_free));
            if !known.contains(&name) {
                let explained = self.explained(name, &[kind]);
                let near = nearest(name, known.iter().copied()).filter(|_| explained.is_none());
                let hint = match (explained, &near) {
                    (Some(explained), _) => explained.to_owned(),
                    (None, Some(near)) => format!("did you mean '{near}'?"),
                    (None, None) if known.is_empty() => "it has none".to_owned(),
                    (None, None) => format!("its fields are {}", known.join(", ")),
                };
                let message = format!("{kind} has no field '{name}'; {hint}");
                self.fault_meaning(named.span.clone(), message, near);
            } else if fields.found[..i].iter().any(|(other, _)| other.name == name) {
                self.fault(named.span.clone(), format!("{kind} is given '{name}' twice; keep one of them"));
            }
        }
        self.faults.len() > before
    }

    /// The value of a field that must be there; `example` is what to add.
    pub fn required<'n, 'a>(
        &mut self,
        fields: &Fields<'n, 'a>,
        name: &str,
        example: &str,
    ) -> Option<&'n Node<'a>> {
        let node = fields.get(name);
        if node.is_none() {
            let whose = match fields.get("name").map(|node| &node.value) {
                Some(Value::Text(own)) => format!("{} '{own}'", fields.kind),
                _ => format!("this {}", fields.kind),
            };
            self.fault(fields.at.clone(), format!("{whose} has no {name}; add {name}: {example}"));
        }
        node
    }

    /// A finite number that must be there; `example` is what to add.
    pub fn required_number(&mut self, fields: &Fields<'_, '_>, name: &str, example: &str) -> Option<f64> {
        let node = self.required(fields, name, example)?;
        self.number(node, name)
    }

    /// A finite number, or `default` where the field is not given.
    pub fn number_or(&mut self, fields: &Fields<'_, '_>, name: &str, default: f64) -> Option<f64> {
        fields.get(name).map_or(Some(default), |node| self.number(node, name))
    }

    /// One of some words, the first where the field is not given.
    pub fn choice(
        &mut self,
        fields: &Fields<'_, '_>,
        name: &str,
        words: &[&'static str],
    ) -> Option<&'static str> {
        fields.get(name).map_or_else(|| words.first().copied(), |node| self.word(node, words))
    }

    /// Whether `kind` stands alone, as it must where there is nothing more to say of it.
    pub fn stands_alone(&mut self, node: &Node<'_>, kind: &str) -> bool {
        let is_alone = node.group().is_none();
        if !is_alone {
            self.fault(node.span.clone(), format!("{kind} stands alone: there is nothing more to say of it"));
        }
        is_alone
    }
}
