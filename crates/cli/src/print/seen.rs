//! A writer that writes out what would not be seen.

use solaris::model::{is_unseen, plain};
use std::fmt::Write as _;
use std::io::{Result, Write};

/// Writes on to another writer, whole characters at a time.
pub(super) struct Seen<W> {
    out: W,
    /// Whether what passes is JSON, in which escapes have a way of their own, with the same meaning as the character.
    is_json: bool,
    /// The beginning of a character whose end is to come.
    begun: Vec<u8>,
}

impl<W: Write> Seen<W> {
    /// Of text.
    pub(super) fn text(out: W) -> Self {
        Self { out, is_json: false, begun: Vec::new() }
    }

    /// Of JSON, where such characters stand in strings alone.
    pub(super) fn json(out: W) -> Self {
        Self { out, is_json: true, begun: Vec::new() }
    }

    fn pass(&mut self, text: &str) -> Result<()> {
        if !self.is_json {
            return self.out.write_all(plain(text).as_bytes());
        }
        let mut shown = String::with_capacity(text.len());
        for c in text.chars() {
            if is_unseen(c) {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    // Writing to a string does not fail.
                    let _ = write!(shown, "\\u{unit:04x}");
                }
            } else {
                shown.push(c);
            }
        }
        self.out.write_all(shown.as_bytes())
    }
}

impl<W: Write> Write for Seen<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        let mut all = std::mem::take(&mut self.begun);
        all.extend_from_slice(bytes);
        let mut rest = &all[..];
        loop {
            match std::str::from_utf8(rest) {
                Ok(text) => {
                    self.pass(text)?;
                    return Ok(bytes.len());
                }
                Err(error) => {
                    let (good, after) = rest.split_at(error.valid_up_to());
                    self.pass(&String::from_utf8_lossy(good))?;
                    let Some(bad) = error.error_len() else {
                        self.begun = after.to_vec();
                        return Ok(bytes.len());
                    };
                    self.pass("\u{fffd}")?;
                    rest = &after[bad..];
                }
            }
        }
    }

    fn flush(&mut self) -> Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(mut seen: Seen<&mut Vec<u8>>, bytes: &[u8]) {
        // Byte for byte: characters come in parts.
        for byte in bytes {
            seen.write_all(&[*byte]).expect("a vector takes all");
        }
    }

    #[test]
    fn what_commands_a_terminal_is_written_out_and_all_else_passes() {
        let mut out = Vec::new();
        written(Seen::text(&mut out), "é…漢\t\u{1b}[31m\u{9b}31m\u{202e}\u{e0041}\n".as_bytes());
        assert_eq!(String::from_utf8_lossy(&out), "é…漢\t\\u{1b}[31m\\u{9b}31m\\u{202e}\\u{e0041}\n");
    }

    #[test]
    fn json_says_the_same_in_its_own_way() {
        let (mut out, text) = (Vec::new(), "é\u{9b}31m\u{202e}\u{e0041}\u{7f}\u{1b}");
        written(Seen::json(&mut out), serde_json::to_string(text).expect("text").as_bytes());
        let shown = String::from_utf8_lossy(&out);
        assert_eq!(shown, r#""é\u009b31m\u202e\udb40\udc41\u007f\u001b""#);
        assert_eq!(serde_json::from_str::<String>(&shown).expect("JSON"), text);
    }

    #[test]
    fn bytes_that_are_no_text_are_shown_as_none() {
        let mut out = Vec::new();
        written(Seen::text(&mut out), b"a\xffb\x9bc");
        assert_eq!(String::from_utf8_lossy(&out), "a\u{fffd}b\u{fffd}c");
    }
}
