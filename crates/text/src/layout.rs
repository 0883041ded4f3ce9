//! Lines of a text that is written: what fits stands on one, the rest is broken at its commas.
//!
//! ```
//! use solaris_text::layout::{Doc, field, group, number};
//!
//! let line = group("Line(", vec![field("from", Doc::Atom(number(0.0))), field("to", Doc::Atom(number(1.0)))], ")");
//! assert_eq!(line.flat(), "Line(from: 0.0, to: 1.0)");
//! let mut text = String::new();
//! line.print_broken(0, &mut text);
//! assert_eq!(text, "Line(\n    from: 0.0,\n    to: 1.0,\n)");
//! ```

use std::fmt::Write as _;

/// The widest line (characters).
const WIDEST: usize = 100;

/// A piece of text that can be broken into lines.
#[derive(Clone, Debug)]
pub enum Doc {
    /// Never broken.
    Atom(String),
    /// `name: value`
    Field(String, Box<Doc>),
    /// Values between brackets, separated by commas.
    Group {
        /// What opens it: `Line(`.
        open: String,
        /// What stands in it.
        items: Vec<Doc>,
        /// What closes it.
        close: &'static str,
    },
}

/// `name: value`
pub fn field(name: &str, value: Doc) -> Doc {
    Doc::Field(name.to_owned(), Box::new(value))
}

/// Values between brackets.
pub fn group(open: &str, items: Vec<Doc>, close: &'static str) -> Doc {
    Doc::Group { open: open.to_owned(), items, close }
}

/// The shortest digits that read back equal.
pub fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A text in quotes.
pub fn quoted(text: &str) -> String {
    let mut quoted = String::with_capacity(text.len() + 2);
    quoted.push('"');
    for c in text.chars() {
        match c {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            c if c.is_control() => {
                // Writing to a string does not fail.
                let _ = write!(quoted, "\\u{{{:x}}}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

impl Doc {
    /// All of it on one line.
    pub fn flat(&self) -> String {
        let mut text = String::new();
        self.print_flat(&mut text);
        text
    }

    /// Characters on one line.
    fn width(&self) -> usize {
        match self {
            Self::Atom(text) => text.chars().count(),
            Self::Field(name, value) => name.chars().count() + 2 + value.width(),
            Self::Group { open, items, close } => {
                let between = 2 * items.len().saturating_sub(1);
                open.chars().count() + close.len() + between + items.iter().map(Self::width).sum::<usize>()
            }
        }
    }

    /// Adds it to the text, after what takes `column` characters of the line, with `after` more to come.
    pub fn print(&self, column: usize, after: usize, text: &mut String) {
        if column + self.width() + after <= WIDEST {
            return self.print_flat(text);
        }
        match self {
            Self::Field(name, value) => {
                text.push_str(name);
                text.push_str(": ");
                match &**value {
                    // The brackets' contents stand one step further in than the field.
                    broken @ Self::Group { .. } => broken.print_broken(column, text),
                    other => other.print_flat(text),
                }
            }
            Self::Group { .. } => self.print_broken(column, text),
            Self::Atom(_) => self.print_flat(text),
        }
    }

    /// Adds it, each item of a group on a line of its own, in from `indent`.
    pub fn print_broken(&self, indent: usize, text: &mut String) {
        let Self::Group { open, items, close } = self else { return self.print_flat(text) };
        text.push_str(open);
        text.push('\n');
        for item in items {
            text.extend(std::iter::repeat_n(' ', indent + 4));
            item.print(indent + 4, 1, text);
            text.push_str(",\n");
        }
        text.extend(std::iter::repeat_n(' ', indent));
        text.push_str(close);
    }

    fn print_flat(&self, text: &mut String) {
        match self {
            Self::Atom(atom) => text.push_str(atom),
            Self::Field(name, value) => {
                text.push_str(name);
                text.push_str(": ");
                value.print_flat(text);
            }
            Self::Group { open, items, close } => {
                text.push_str(open);
                for (i, item) in items.iter().enumerate() {
                    if i > 0 {
                        text.push_str(", ");
                    }
                    item.print_flat(text);
                }
                text.push_str(close);
            }
        }
    }
}
