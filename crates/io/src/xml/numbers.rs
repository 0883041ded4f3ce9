//! Numbers and words in attributes and in the text of elements.

use super::{Node, Reader, shown, tag, value_span};
use std::ops::Range;

impl Reader<'_> {
    /// The attribute `name`, whose absence is a fault.
    pub(crate) fn need<'n>(&mut self, node: Node<'n>, name: &str) -> Option<&'n str> {
        let value = node.attribute(name);
        if value.is_none() {
            self.fault(tag(node), format!("<{}> has no attribute '{name}'", node.tag_name().name()));
        }
        value
    }

    /// The number in the attribute `name`; `None` where there is none, and where it is no finite number, which is a fault.
    pub(crate) fn number(&mut self, node: Node, name: &str) -> Option<f64> {
        self.numbers::<1>(node, name).map(|[number]| number)
    }

    /// The `N` numbers in the attribute `name`.
    pub(crate) fn numbers<const N: usize>(&mut self, node: Node, name: &str) -> Option<[f64; N]> {
        let list = self.number_list(node, name, N..=N)?;
        list.try_into().ok()
    }

    /// The numbers in the attribute `name`, as many as `counts` allows.
    pub(crate) fn number_list(
        &mut self,
        node: Node,
        name: &str,
        counts: std::ops::RangeInclusive<usize>,
    ) -> Option<Vec<f64>> {
        let value = node.attribute(name)?;
        self.parse_numbers(value, &value_span(node, name), &format!("'{name}'"), counts)
    }

    /// The numbers in the text of an element, as many as `counts` allows.
    pub(crate) fn text_numbers(
        &mut self,
        node: Node,
        counts: std::ops::RangeInclusive<usize>,
    ) -> Option<Vec<f64>> {
        let (value, span) = text_of(node);
        self.parse_numbers(value, &span, &format!("<{}>", node.tag_name().name()), counts)
    }

    /// The number in the text of an element.
    pub(crate) fn text_number(&mut self, node: Node) -> Option<f64> {
        self.text_numbers(node, 1..=1).map(|numbers| numbers[0])
    }

    /// The one of `choices` that the attribute `name` says; `None` where it is absent, and where it says another, which
    /// is a fault.
    pub(crate) fn choice<T: Copy>(&mut self, node: Node, name: &str, choices: &[(&str, T)]) -> Option<T> {
        let value = node.attribute(name)?;
        let found = choices.iter().find(|(word, _)| *word == value.trim()).map(|(_, choice)| *choice);
        if found.is_none() {
            let words: Vec<String> = choices.iter().map(|(word, _)| format!("'{word}'")).collect();
            let message = format!("'{name}' is '{}'; it must be one of {}", shown(value), words.join(", "));
            self.fault(value_span(node, name), message);
        }
        found
    }

    /// The numbers of `value`, which stands at `span` and is called `what`; finite numbers between white space.
    pub(crate) fn parse_numbers(
        &mut self,
        value: &str,
        span: &Range<usize>,
        what: &str,
        counts: std::ops::RangeInclusive<usize>,
    ) -> Option<Vec<f64>> {
        let mut numbers = Vec::new();
        for word in value.split_whitespace() {
            let Some(number) = word.parse().ok().filter(|number: &f64| number.is_finite()) else {
                self.fault(span.clone(), format!("{what}: '{}' is no finite number", shown(word)));
                return None;
            };
            numbers.push(number);
        }
        if counts.contains(&numbers.len()) {
            return Some(numbers);
        }
        let (few, many) = (*counts.start(), *counts.end());
        let wanted = match (few, many) {
            (1, 1) => "one number".to_owned(),
            _ if few == many => format!("{few} numbers"),
            _ if many == usize::MAX => format!("{few} numbers or more"),
            _ => format!("{few} to {many} numbers"),
        };
        self.fault(span.clone(), format!("{what} holds {} numbers; it must hold {wanted}", numbers.len()));
        None
    }
}

/// The text of an element, without the white space around it, and where it is; that of the element's tag where it is empty.
pub(crate) fn text_of(node: Node<'_>) -> (&str, Range<usize>) {
    let text = node
        .children()
        .find(|child| child.is_text() && child.text().is_some_and(|text| !text.trim().is_empty()));
    let Some(text) = text else { return ("", tag(node)) };
    let value = text.text().unwrap_or_default();
    let range = text.range();
    // Where nothing is escaped the value's bytes are the text's.
    let span = if range.len() == value.len() {
        let start = range.start + value.len() - value.trim_start().len();
        start..start + value.trim().len()
    } else {
        range
    };
    (value.trim(), span)
}
