//! The parser: the part of RON that texts for people use, to a tree.

use crate::error::TextError;
use crate::lex::{Cursor, Stop, begins_word, parse as parse_number};
use crate::node::{Content, Group, Named, Node, Value};
use std::ops::Range;

/// How deep brackets may stand in each other.
const DEEPEST: usize = 64;
/// The most values of a text: some 300 MB of them.
const MOST_VALUES: usize = 4_000_000;

/// The word that a text begins with, after comments: `Figure`, `Scene`.
pub fn first_word(text: &str) -> Option<&str> {
    let mut cursor = Cursor::new(text);
    cursor.skip().ok()?;
    while cursor.rest().starts_with("#!") {
        extension(&mut cursor).ok()?;
    }
    Some(cursor.word()).filter(|word| !word.is_empty())
}

/// The tree of a text: `noun` says what it is (`scene`), `begins` how one begins (`Scene(version: 1, …)`), both for messages.
///
/// Of RON there is all that such texts need: comments (`//`, `/* */`), commas at the end, raw texts, names left out. Texts end on
/// the line on which they begin. Time and memory grow in proportion to the text; brackets in each other are refused beyond 64, and
/// values beyond 4 million.
///
/// # Errors
///
/// [`TextError`] with the one place where the text is no RON.
pub fn parse<'a>(text: &'a str, noun: &str, begins: &str) -> Result<Node<'a>, TextError> {
    whole(text, noun, begins).map_err(|(span, message)| TextError::one(text, span, message))
}

/// The one value that a text is, or the first thing that keeps it from being one.
fn whole<'a>(text: &'a str, name: &str, begins: &str) -> Result<Node<'a>, Stop> {
    if let Some(at) = text.find('\0') {
        return Err((at..at + 1, format!("this is no text but binary data; give the text of a {name}")));
    }
    let mut cursor = Cursor::new(text);
    cursor.skip()?;
    while cursor.rest().starts_with("#!") {
        extension(&mut cursor)?;
    }
    if cursor.peek().is_none() {
        return Err((0..0, format!("the text is empty; a {name} begins with {begins}")));
    }
    let node = value(&mut cursor, 0)?;
    cursor.skip()?;
    match cursor.peek() {
        None => Ok(node),
        Some(c @ (')' | ']' | '}')) => {
            Err((cursor.next_span(), format!("this '{c}' closes nothing; the {name} has ended before it")))
        }
        Some(_) => {
            Err((cursor.next_span(), format!("the {name} has ended before this; remove what follows")))
        }
    }
}

/// `#![enable(…)]`: extensions of RON that change nothing here.
fn extension(cursor: &mut Cursor<'_>) -> Result<(), Stop> {
    let start = cursor.at;
    let Some(length) = cursor.rest().find(']') else {
        return Err((start..start + 2, "this '#![' is never closed; add a ']'".to_owned()));
    };
    cursor.at += length + 1;
    cursor.skip()
}

fn value<'a>(cursor: &mut Cursor<'a>, depth: usize) -> Result<Node<'a>, Stop> {
    let start = cursor.at;
    cursor.values += 1;
    if cursor.values > MOST_VALUES {
        let message = format!("there are more than {MOST_VALUES} values, the most that are read");
        return Err((cursor.next_span(), message));
    }
    let value = match cursor.peek() {
        Some('(' | '[' | '{') => group(cursor, None, depth)?,
        Some('"') => cursor.quoted()?,
        Some('r') if cursor.rest()[1..].trim_start_matches('#').starts_with('"') => cursor.raw()?,
        Some('0'..='9' | '+' | '-' | '.') => cursor.number()?,
        Some(c) if begins_word(c) => {
            let name = cursor.word();
            let span = start..cursor.at;
            let number = if matches!(name, "inf" | "NaN") { parse_number(name) } else { None };
            cursor.skip()?;
            if cursor.peek() != Some('(') {
                // Comments after a word are not part of it.
                let value = number.map_or(Value::Word(name), Value::Number);
                return Ok(Node { span, value });
            }
            group(cursor, Some(Named { name, span }), depth)?
        }
        Some('\'') => {
            return Err((cursor.next_span(), "texts stand in double quotes: \"…\"".to_owned()));
        }
        Some('“' | '”' | '„' | '«') => {
            return Err((cursor.next_span(), "texts stand in plain double quotes: \"…\"".to_owned()));
        }
        Some(c) => return Err((cursor.next_span(), format!("a value must stand here, not {}", shown(c)))),
        None => {
            return Err((
                cursor.next_span(),
                "the text ends where a value must stand; is it complete?".to_owned(),
            ));
        }
    };
    Ok(Node { span: start..cursor.at, value })
}

/// A character in a message.
fn shown(c: char) -> String {
    if c.is_control() || c == '\u{fffd}' {
        format!("the character {}", c.escape_unicode())
    } else {
        format!("'{c}'")
    }
}

/// What stands in the brackets that open here.
fn group<'a>(cursor: &mut Cursor<'a>, name: Option<Named<'a>>, depth: usize) -> Result<Value<'a>, Stop> {
    let open = cursor.next_span();
    if depth == DEEPEST {
        let message =
            format!("brackets stand more than {DEEPEST} deep in each other here, deeper than anything needs");
        return Err((open, message));
    }
    let inside = Inside { open, depth: depth + 1 };
    let bracket = cursor.peek();
    cursor.at += 1;
    cursor.skip()?;
    let content = match bracket {
        Some('[') => Content::List(inside.all(cursor, ']', |cursor| value(cursor, inside.depth))?),
        Some('{') => Content::Map(inside.all(cursor, '}', |cursor| inside.entry(cursor))?),
        _ if begins_with_field(cursor)? => {
            Content::Fields(inside.all(cursor, ')', |cursor| inside.field(cursor))?)
        }
        _ => Content::Tuple(inside.all(cursor, ')', |cursor| value(cursor, inside.depth))?),
    };
    Ok(Value::Group(Box::new(Group { name, content })))
}

/// Whether a word and a colon come next.
fn begins_with_field(cursor: &Cursor<'_>) -> Result<bool, Stop> {
    let mut ahead = Cursor { ..*cursor };
    if ahead.word().is_empty() {
        return Ok(false);
    }
    ahead.skip()?;
    Ok(ahead.peek() == Some(':'))
}

/// What is inside of one pair of brackets.
struct Inside {
    open: Range<usize>,
    depth: usize,
}

impl Inside {
    /// All that stands between commas, up to the bracket that closes.
    fn all<'a, T>(
        &self,
        cursor: &mut Cursor<'a>,
        close: char,
        one: impl Fn(&mut Cursor<'a>) -> Result<T, Stop>,
    ) -> Result<Vec<T>, Stop> {
        let mut found = Vec::new();
        loop {
            cursor.skip()?;
            if cursor.take(close) {
                return Ok(found);
            }
            if cursor.peek().is_none() {
                return Err(self.never_closed(cursor, close));
            }
            found.push(one(cursor)?);
            cursor.skip()?;
            if !cursor.take(',') && cursor.peek() != Some(close) {
                return Err(self.no_comma(cursor, close));
            }
        }
    }

    fn never_closed(&self, cursor: &Cursor<'_>, close: char) -> Stop {
        let open = &cursor.text[self.open.clone()];
        (
            self.open.clone(),
            format!("this '{open}' is never closed: the text ends before its '{close}'; is it complete?"),
        )
    }

    fn no_comma(&self, cursor: &Cursor<'_>, close: char) -> Stop {
        match cursor.peek() {
            None => self.never_closed(cursor, close),
            Some(c @ (')' | ']' | '}')) => {
                let open = &cursor.text[self.open.clone()];
                let line = cursor.text[..self.open.start].matches('\n').count() + 1;
                let message =
                    format!("'{c}' does not close the '{open}' of line {line}; that takes '{close}'");
                (cursor.next_span(), message)
            }
            // Fields are told from values by the first of them.
            Some(':') if close == ')' => {
                let message = "values and fields cannot stand beside each other here: name all of them, as in File(path: \"robot.urdf\", base: Free)";
                (cursor.next_span(), message.to_owned())
            }
            Some(c) => {
                (cursor.next_span(), format!("a comma or '{close}' is missing before this {}", shown(c)))
            }
        }
    }

    fn field<'a>(&self, cursor: &mut Cursor<'a>) -> Result<(Named<'a>, Node<'a>), Stop> {
        let start = cursor.at;
        let name = cursor.word();
        if name.is_empty() {
            let message = match cursor.peek() {
                Some('0'..='9') => {
                    "a field must stand here, name: value; in a number, a point takes the place of a comma"
                }
                _ => "a field must stand here, its name without quotes: name: value",
            };
            return Err((cursor.next_span(), message.to_owned()));
        }
        let span = start..cursor.at;
        cursor.skip()?;
        if !cursor.take(':') {
            return Err((span, format!("'{name}' has no value; write {name}: and its value")));
        }
        cursor.skip()?;
        Ok((Named { name, span }, value(cursor, self.depth)?))
    }

    fn entry<'a>(&self, cursor: &mut Cursor<'a>) -> Result<(Node<'a>, Node<'a>), Stop> {
        let key = value(cursor, self.depth)?;
        cursor.skip()?;
        if !cursor.take(':') {
            return Err((key.span, "this key of a map has no value; write key: value".to_owned()));
        }
        cursor.skip()?;
        Ok((key, value(cursor, self.depth)?))
    }
}
