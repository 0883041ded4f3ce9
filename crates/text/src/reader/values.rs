//! Single values: numbers, angles, vectors, names.

use super::Reader;
use crate::layout::quoted;
use crate::node::{Content, Group, Named, Node, Value};
use std::fmt::Display;

impl Reader {
    /// A finite number; `what` it is begins the message.
    pub fn number(&mut self, node: &Node<'_>, what: impl Display) -> Option<f64> {
        match &node.value {
            Value::Number(number) if number.is_finite() => Some(*number),
            Value::Number(number) => {
                self.fault(node.span.clone(), format!("{what} is {number}; it must be a finite number"));
                None
            }
            Value::TooLarge(written) => {
                let message =
                    format!("{what} is {written}, which is too large; numbers go up to about 1.8e308");
                self.fault(node.span.clone(), message);
                None
            }
            _ if node.head().is_some_and(|head| head.name == "deg") => {
                self.fault(
                    node.place(),
                    format!("{what} is no angle; it must be a plain number, without deg(…)"),
                );
                None
            }
            _ => {
                self.fault(node.place(), format!("{what} must be a number, not {}", node.describe()));
                None
            }
        }
    }

    /// A number above zero, in `unit`.
    pub fn positive(&mut self, node: &Node<'_>, what: impl Display, unit: &str) -> Option<f64> {
        let value = self.number(node, &what)?;
        if value > 0.0 {
            return Some(value);
        }
        let (blank, place) = (if unit.is_empty() { "" } else { " " }, node.span.clone());
        self.fault(place, format!("{what} is {value}{blank}{unit}; it must be more than zero"));
        None
    }

    /// `true` or `false`.
    pub fn flag(&mut self, node: &Node<'_>) -> Option<bool> {
        Some(self.word(node, &["true", "false"])? == "true")
    }

    /// A number, or where there may be no bound, `inf` or `-inf`.
    pub fn bound(&mut self, node: &Node<'_>, turns: bool, what: impl Display) -> Option<f64> {
        match node.value {
            Value::Number(number) if number.is_infinite() => Some(number),
            _ => self.coordinate(node, turns, what),
        }
    }

    /// A coordinate of a degree of freedom: an angle where it turns.
    pub fn coordinate(&mut self, node: &Node<'_>, turns: bool, what: impl Display) -> Option<f64> {
        if turns { self.angle(node, what) } else { self.number(node, what) }
    }

    /// An angle (rad): a number in rad, or `deg(…)`.
    pub fn angle(&mut self, node: &Node<'_>, what: impl Display) -> Option<f64> {
        match node.group() {
            Some(Group { name: Some(Named { name: "deg", .. }), content }) => match content {
                Content::Tuple(items) if items.len() == 1 => {
                    self.number(&items[0], what).map(f64::to_radians)
                }
                _ => {
                    self.fault(node.span.clone(), format!("{what}: deg(…) takes one number, as in deg(30)"));
                    None
                }
            },
            None if matches!(node.value, Value::Number(_) | Value::TooLarge(_)) => self.number(node, what),
            _ => {
                let message = format!(
                    "{what} must be an angle, a number in rad or degrees as deg(30), not {}",
                    node.describe()
                );
                self.fault(node.place(), message);
                None
            }
        }
    }

    /// Numbers in brackets, one for each of `parts`.
    pub fn numbers<const N: usize>(
        &mut self,
        node: &Node<'_>,
        what: impl Display,
        parts: [&str; N],
    ) -> Option<[f64; N]> {
        let wanted = || format!("({})", parts.join(", "));
        let Some(items) = node.items() else {
            let message = format!("{what} must be {N} numbers {}, not {}", wanted(), node.describe());
            self.fault(node.place(), message);
            return None;
        };
        if items.len() != N {
            let message = format!("{what} takes {N} numbers {}; these are {}", wanted(), items.len());
            self.fault(node.span.clone(), message);
            return None;
        }
        let mut numbers = [0.0; N];
        let mut complete = true;
        for ((number, item), part) in numbers.iter_mut().zip(items).zip(parts) {
            match self.number(item, format_args!("{part} of {what}")) {
                Some(value) => *number = value,
                None => complete = false,
            }
        }
        complete.then_some(numbers)
    }

    /// The values of a list; `what` it is and an `example` of it begin and end the message.
    pub fn items<'n, 'a>(
        &mut self,
        node: &'n Node<'a>,
        what: impl Display,
        example: &str,
    ) -> Option<&'n [Node<'a>]> {
        let items = node.items();
        if items.is_none() {
            self.fault(node.place(), format!("{what} must be a list {example}, not {}", node.describe()));
        }
        items
    }

    /// A list of numbers of any length.
    pub fn list(&mut self, node: &Node<'_>, what: impl Display) -> Option<Vec<f64>> {
        let items = self.items(node, &what, "of numbers […]")?;
        let numbers: Vec<Option<f64>> =
            items.iter().map(|item| self.number(item, format_args!("a number of {what}"))).collect();
        numbers.into_iter().collect()
    }

    /// A text in quotes.
    pub fn text<'n>(&mut self, node: &'n Node<'_>, what: impl Display) -> Option<&'n str> {
        match &node.value {
            Value::Text(text) => Some(text),
            Value::Word(word) => {
                let instead = quoted(word);
                self.fault_meaning(
                    node.span.clone(),
                    format!("{what} must stand in quotes: {instead}"),
                    Some(instead),
                );
                None
            }
            _ => {
                self.fault(node.place(), format!("{what} must be a text in quotes, not {}", node.describe()));
                None
            }
        }
    }

    /// A text that is not empty.
    pub fn name<'n>(&mut self, node: &'n Node<'_>, what: impl Display) -> Option<&'n str> {
        let text = self.text(node, &what)?;
        if text.trim().is_empty() {
            self.fault(node.span.clone(), format!("{what} is empty; give one"));
            return None;
        }
        Some(text)
    }
}
