//! Words, numbers and texts: the smallest pieces of a text.

use crate::node::Value;
use std::borrow::Cow;
use std::ops::Range;

/// Where in the text the reading is.
pub(crate) struct Cursor<'a> {
    pub(crate) text: &'a str,
    pub(crate) at: usize,
    /// How many values have begun.
    pub(crate) values: usize,
}

/// A fault that ends the reading.
pub(crate) type Stop = (Range<usize>, String);

impl<'a> Cursor<'a> {
    /// At the beginning of a text, after a mark of its encoding.
    pub(crate) fn new(text: &'a str) -> Self {
        Self { text, at: if text.starts_with('\u{feff}') { 3 } else { 0 }, values: 0 }
    }

    pub(crate) fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    pub(crate) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// The next byte.
    pub(crate) fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Takes the sign `expected`, of one byte, if it comes next.
    pub(crate) fn take(&mut self, expected: char) -> bool {
        let found = self.byte().map(char::from) == Some(expected);
        self.at += usize::from(found);
        found
    }

    /// The bytes of the next character, or the empty end.
    pub(crate) fn next_span(&self) -> Range<usize> {
        self.at..self.at + self.peek().map_or(0, char::len_utf8)
    }

    fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let length = rest.find(|c| !wanted(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// Passes white space and comments.
    pub(crate) fn skip(&mut self) -> Result<(), Stop> {
        loop {
            match self.byte() {
                Some(b' ' | b'\n' | b'\r' | b'\t') => self.at += 1,
                Some(b'/') if self.rest().starts_with("//") => {
                    self.take_while(|c| c != '\n');
                }
                Some(b'/') if self.rest().starts_with("/*") => self.block_comment()?,
                None | Some(0x20..=0x7e) => return Ok(()),
                Some(_) if self.take_while(char::is_whitespace).is_empty() => return Ok(()),
                Some(_) => {}
            }
        }
    }

    /// Passes a comment between `/*` and `*/`, which may hold others.
    fn block_comment(&mut self) -> Result<(), Stop> {
        let (start, mut depth) = (self.at, 0_usize);
        loop {
            if self.rest().starts_with("/*") {
                (depth, self.at) = (depth + 1, self.at + 2);
            } else if self.rest().starts_with("*/") {
                (depth, self.at) = (depth - 1, self.at + 2);
            } else if let Some(c) = self.peek() {
                self.at += c.len_utf8();
            } else {
                return Err((start..start + 2, "this comment is never closed; add */".to_owned()));
            }
            if depth == 0 {
                return Ok(());
            }
        }
    }

    /// A bare word, which may be empty; `r#` before one says only that it is a word.
    pub(crate) fn word(&mut self) -> &'a str {
        if self.rest().strip_prefix("r#").is_some_and(|rest| rest.starts_with(begins_word)) {
            self.at += 2;
        }
        match self.peek() {
            Some(c) if begins_word(c) => self.take_while(|c| c.is_alphanumeric() || c == '_'),
            _ => "",
        }
    }

    /// A number that begins here.
    pub(crate) fn number(&mut self) -> Result<Value<'a>, Stop> {
        let start = self.at;
        let bytes = self.text.as_bytes();
        let mut end = start;
        while let Some(byte) = bytes.get(end) {
            let exponent = end > start && matches!(bytes[end - 1], b'e' | b'E');
            let sign = matches!(byte, b'+' | b'-') && (end == start || exponent);
            if !(sign || byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_')) {
                break;
            }
            end += 1;
        }
        let written = &self.text[start..end];
        if bytes.get(end..).is_some_and(|rest| rest.starts_with("°".as_bytes())) {
            let message = format!("degrees are written deg({written}), without the sign °");
            return Err((start..end + "°".len(), message));
        }
        self.at = end;
        match parse(written) {
            // Nothing but `inf` itself has no digits.
            Some(number) if number.is_infinite() && !written.ends_with("inf") => Ok(Value::TooLarge(written)),
            Some(number) => Ok(Value::Number(number)),
            None => Err((start..end, no_number(written))),
        }
    }

    /// A text in quotes that begins here.
    pub(crate) fn quoted(&mut self) -> Result<Value<'a>, Stop> {
        let start = self.at;
        self.at += 1;
        let mut text = Cow::Borrowed("");
        loop {
            let plain = self.take_while(|c| c != '"' && c != '\\' && c != '\n');
            match &mut text {
                Cow::Borrowed("") => text = Cow::Borrowed(plain),
                text => text.to_mut().push_str(plain),
            }
            match self.peek() {
                Some('"') => {
                    self.at += 1;
                    return Ok(Value::Text(text));
                }
                Some('\\') => text.to_mut().push(self.escape()?),
                // A name over several lines is a quote that was forgotten.
                Some(_) | None => break,
            }
        }
        let line = self.text[start..].find(['\n', '\r']).map_or(self.text.len(), |length| start + length);
        Err((start..line, "this text is never closed on its line; add a \" at its end".to_owned()))
    }

    /// The character that a backslash and what follows it stand for.
    fn escape(&mut self) -> Result<char, Stop> {
        let start = self.at;
        self.at += 1;
        let Some(letter) = self.peek() else {
            return Err((start..self.at, "a text cannot end after a backslash".to_owned()));
        };
        self.at += letter.len_utf8();
        let found = match letter {
            'n' => Some('\n'),
            'r' => Some('\r'),
            't' => Some('\t'),
            '0' => Some('\0'),
            '"' | '\'' | '\\' => Some(letter),
            'x' => {
                let digits = self.rest().get(..2).unwrap_or_default();
                self.at += digits.len();
                u8::from_str_radix(digits, 16).ok().map(char::from)
            }
            'u' if self.take('{') => {
                let digits = self.take_while(|c| c.is_ascii_hexdigit());
                let closed = self.take('}');
                u32::from_str_radix(digits, 16).ok().filter(|_| closed).and_then(char::from_u32)
            }
            _ => None,
        };
        found.ok_or_else(|| {
            let message = "a backslash stands before \" \\ n r t 0, x and two digits (\\x41), or u and a number in braces \
                           (\\u{e9}); a backslash itself is written twice";
            (start..self.at, message.to_owned())
        })
    }

    /// A text between `r"` and `"`, or with as many `#` on both sides as needed, that begins here.
    pub(crate) fn raw(&mut self) -> Result<Value<'a>, Stop> {
        let start = self.at;
        self.at += 1;
        let marks = self.take_while(|c| c == '#');
        let (begin, end) = (self.at + 1, format!("\"{marks}"));
        let Some(length) = self.text.get(begin..).and_then(|rest| rest.find(&end)) else {
            return Err((
                start..begin.min(self.text.len()),
                format!("this text is never closed; add {end} at its end"),
            ));
        };
        self.at = begin + length + end.len();
        Ok(Value::Text(Cow::Borrowed(&self.text[begin..begin + length])))
    }
}

/// Whether a word can begin so.
pub(crate) fn begins_word(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

/// The number that is written so; RON allows `_` between digits, other bases for whole numbers, and `inf` and `NaN`.
pub(crate) fn parse(written: &str) -> Option<f64> {
    let (sign, size) = match written.as_bytes().first()? {
        b'-' => (-1.0, &written[1..]),
        b'+' => (1.0, &written[1..]),
        _ => (1.0, written),
    };
    match size {
        "inf" => return Some(sign * f64::INFINITY),
        "NaN" => return Some(f64::NAN),
        _ => {}
    }
    let digits: Cow<str> = if size.contains('_') { size.replace('_', "").into() } else { size.into() };
    for (prefix, base) in [("0x", 16), ("0b", 2), ("0o", 8)] {
        if let Some(digits) = digits.strip_prefix(prefix) {
            return u64::from_str_radix(digits, base).ok().map(|whole| sign * whole as f64);
        }
    }
    // The standard library also takes words, such as `infinity`.
    let begins = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    digits.parse::<f64>().ok().filter(|_| begins).map(|number| sign * number)
}

fn no_number(written: &str) -> String {
    let digits = written.trim_end_matches(|c: char| c.is_alphabetic());
    let unit = &written[digits.len()..];
    match (parse(digits).is_some(), unit) {
        (true, "deg" | "degrees" | "grad" | "d") => {
            format!("'{written}' is no number; degrees are written deg({digits})")
        }
        (true, _) => {
            format!(
                "'{written}' is no number; units are not written: lengths are in m, masses in kg, angles in rad or deg(…)"
            )
        }
        (false, _) => format!("'{written}' is no number"),
    }
}
