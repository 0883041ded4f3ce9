//! Changes of single numbers in a text, everything else of which stays as it is.

use crate::xml::{Node, Reader, elements, shown, tag};
use solaris_model::Vector3;
use std::ops::Range;

/// Whether two numbers are one, to the last bit but for the sign of zero.
pub(super) fn same(a: f64, b: f64) -> bool {
    (a - b).abs() == 0.0
}

/// The factor of all three axes, where they have the same.
pub(super) fn alike(s: &Vector3<f64>) -> Option<f64> {
    (same(s.x, s.y) && same(s.y, s.z)).then_some(s.x)
}

/// What is to be written where.
#[derive(Default)]
pub(super) struct Edits {
    list: Vec<(Range<usize>, String)>,
}

impl Edits {
    /// Multiplies the numbers in the text of `node` by `factors`, one each; those with a factor of one keep their bytes.
    pub(super) fn scale(&mut self, reader: &mut Reader, node: Node, factors: &[f64]) {
        let Some(numbers) = numbers(reader, node, factors.len()) else { return };
        for ((span, number), factor) in numbers.into_iter().zip(factors) {
            self.number(reader, node, span, number, number * factor);
        }
    }

    /// Writes `values` in place of the numbers in the text of `node`; those that are the same keep their bytes.
    pub(super) fn set(&mut self, reader: &mut Reader, node: Node, values: &[f64]) {
        let Some(numbers) = numbers(reader, node, values.len()) else { return };
        for ((span, number), value) in numbers.into_iter().zip(values) {
            self.number(reader, node, span, number, *value);
        }
    }

    fn number(&mut self, reader: &mut Reader, node: Node, span: Range<usize>, from: f64, to: f64) {
        if !to.is_finite() {
            let name = node.tag_name().name();
            reader.fault(span, format!("<{name}>: {from} becomes {to}; check the factors"));
        } else if to.to_bits() != from.to_bits() {
            self.list.push((span, to.to_string()));
        }
    }

    /// Multiplies the numbers of the child `name` of `node`, which are all `absent` where there is no such child.
    pub(super) fn scale_child(
        &mut self,
        reader: &mut Reader,
        node: Node,
        name: &str,
        absent: f64,
        factors: &[f64],
    ) {
        match elements(node).find(|child| child.tag_name().name() == name) {
            Some(child) => self.scale(reader, child, factors),
            None if factors.iter().all(|factor| same(*factor, 1.0)) => {}
            None => {
                let numbers: Vec<String> =
                    factors.iter().map(|factor| (absent * factor).to_string()).collect();
                self.insert(node, &format!("<{name}>{}</{name}>", numbers.join(" ")));
            }
        }
    }

    /// Puts an element into `node`, after all that it holds.
    pub(super) fn insert(&mut self, node: Node, element: &str) {
        let (text, range) = (node.document().input_text(), node.range());
        let children: Vec<Node> = elements(node).collect();
        if let (Some(first), Some(last)) = (children.first(), children.last()) {
            // On a line of its own, as far to the right as the others.
            let before = &text[range.start..first.range().start];
            let blanks = before.len() - before.trim_end().len();
            let indent = &before[before.len() - blanks..];
            let indent = indent.rfind('\n').map_or(indent, |at| &indent[at..]);
            let end = last.range().end;
            self.list.push((end..end, format!("{indent}{element}")));
        } else if text[range.clone()].ends_with("/>") {
            let name = tag(node);
            self.list.push((
                range.end - 2..range.end,
                format!(">{element}</{}>", &text[name.start + 1..name.end]),
            ));
        } else if let Some(close) = text[range.clone()].rfind("</") {
            let end = range.start + close;
            self.list.push((end..end, element.to_owned()));
        }
    }

    /// Puts text before and after an element.
    pub(super) fn wrap(&mut self, node: Node, before: String, after: String) {
        let range = node.range();
        self.list.push((range.start..range.start, before));
        self.list.push((range.end..range.end, after));
    }

    /// Writes other words in place of the text of an element that has some.
    pub(super) fn replace(&mut self, span: Range<usize>, words: String) {
        self.list.push((span, words));
    }

    /// Takes an element out, with the blanks before it.
    pub(super) fn remove(&mut self, node: Node) {
        let (text, range) = (node.document().input_text(), node.range());
        let before = &text[..range.start];
        let blanks = &before[before.trim_end().len()..];
        let start = blanks.rfind('\n').map_or(range.start, |at| range.start - (blanks.len() - at));
        let start = if text[..start].ends_with('\r') { start - 1 } else { start };
        self.list.push((start..range.end, String::new()));
    }

    /// The text with all changes.
    pub(super) fn applied(&self, text: &str) -> String {
        let mut list: Vec<&(Range<usize>, String)> = self.list.iter().collect();
        list.sort_by_key(|(span, _)| (span.start, span.end));
        let (mut changed, mut from) = (String::with_capacity(text.len() + text.len() / 16), 0);
        for (span, words) in list {
            // What stands in something that is taken out is gone with it.
            if span.start < from {
                continue;
            }
            changed.push_str(&text[from..span.start]);
            changed.push_str(words);
            from = span.end;
        }
        changed + &text[from..]
    }
}

/// The numbers in the text of an element, with their places; nothing where they are not as many, which is a fault.
fn numbers(reader: &mut Reader, node: Node, count: usize) -> Option<Vec<(Range<usize>, f64)>> {
    let text = node.document().input_text();
    let mut found = Vec::new();
    for child in node.children().filter(Node::is_text) {
        let range = child.range();
        let raw = &text[range.clone()];
        for word in raw.split_whitespace() {
            let start = range.start + (word.as_ptr() as usize - raw.as_ptr() as usize);
            let span = start..start + word.len();
            let Some(number) = word.parse().ok().filter(|number: &f64| number.is_finite()) else {
                let name = node.tag_name().name();
                reader.fault(span, format!("<{name}>: '{}' is no finite number", shown(word)));
                return None;
            };
            found.push((span, number));
        }
    }
    if found.len() == count {
        return Some(found);
    }
    let name = node.tag_name().name();
    reader.fault(tag(node), format!("<{name}> holds {} numbers; it must hold {count}", found.len()));
    None
}
