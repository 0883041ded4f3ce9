//! Messages about a file without what stands in it: names, numbers and texts are veiled, the program's own words stay.

use std::collections::BTreeSet;

/// Words with capitals that are the program's own.
const OURS: [&str; 16] = [
    "Gazebo", "Hz", "BVH", "C3D", "CSV", "MJCF", "MuJoCo", "N", "OpenSim", "RON", "SDF", "STO", "TRC",
    "URDF", "XML", "glTF",
];

/// What stands for what was taken out of a message.
const VEIL: &str = "…";

/// The words of a file that no message may repeat.
#[derive(Debug, Default)]
pub(super) struct Veil(BTreeSet<String>);

impl Veil {
    /// All words of names.
    pub(super) fn names<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) {
        for name in names {
            self.0.extend(words(name));
        }
    }

    /// The words of a file that may be names: of a model what stands in quotes and between tags, of a table every one. Comments, which
    /// explain formats in the words that we use ourselves, are no names.
    pub(super) fn text(&mut self, text: &str, is_table: bool) {
        if is_table {
            return self.names([text]);
        }
        if text.trim_start().starts_with('<') {
            let mut rest = text;
            while let Some((before, inner)) = rest.split_once("<!--") {
                self.between_tags(before);
                rest = inner.split_once("-->").map_or("", |(_, after)| after);
            }
            return self.between_tags(rest);
        }
        self.names(text.split('"').skip(1).step_by(2));
    }

    fn between_tags(&mut self, text: &str) {
        for piece in text.split('<') {
            let (tag, content) = piece.split_once('>').unwrap_or((piece, ""));
            self.names([content]);
            for quote in ['"', '\''] {
                self.names(tag.split(quote).skip(1).step_by(2));
            }
        }
    }

    /// The message without what is in quotes, without numbers and without any word that is not ours.
    pub(super) fn over(&self, message: &str) -> String {
        let mut veiled = String::new();
        let mut rest = message;
        while let Some(first) = rest.chars().next() {
            let (piece, shown) = match first {
                '\'' | '"' | '`' => match quoted(rest) {
                    Some(piece) => (piece, format!("{first}{VEIL}{first}")),
                    None => (&rest[..1], first.to_string()),
                },
                _ if first.is_ascii_digit() => {
                    let piece = number(rest);
                    (piece, if piece.parse::<f64>().is_ok() { "#" } else { VEIL }.to_owned())
                }
                // A sign is of the number, unless a word goes before: "not-2".
                '-' | '+'
                    if rest[1..].starts_with(|c: char| c.is_ascii_digit())
                        && !veiled.ends_with(is_of_word) =>
                {
                    let piece = &rest[..=number(&rest[1..]).len()];
                    (piece, "#".to_owned())
                }
                _ if is_of_word(first) => {
                    let piece = &rest[..rest.find(|c| !is_of_word(c)).unwrap_or(rest.len())];
                    (
                        piece,
                        if self.shows(piece, veiled.is_empty() || veiled.ends_with(". ")) {
                            piece
                        } else {
                            VEIL
                        }
                        .to_owned(),
                    )
                }
                _ => (&rest[..first.len_utf8()], first.to_string()),
            };
            rest = &rest[piece.len()..];
            // After a word an apostrophe is no quote: "the figure's".
            if shown.ends_with(|c: char| c.is_ascii_alphabetic()) && rest.starts_with('\'') {
                veiled.push_str(&shown);
                veiled.push('\'');
                rest = &rest[1..];
                continue;
            }
            veiled.push_str(&shown);
        }
        veiled
    }

    /// Whether a word is ours.
    fn shows(&self, word: &str, is_first: bool) -> bool {
        if OURS.contains(&word) {
            return true;
        }
        let begins = if is_first { word.get(1..).unwrap_or("") } else { word };
        let is_plain = word.is_ascii() && begins.chars().all(|c| c.is_ascii_lowercase());
        is_plain && !self.0.contains(&word.to_lowercase())
    }
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The words of a text, in small letters; single letters are none.
fn words(text: &str) -> impl Iterator<Item = String> {
    let words = text.split(|c| !is_of_word(c)).filter(|word| word.chars().count() > 1);
    words.map(str::to_lowercase)
}

/// What stands in quotes at the beginning, with them: to a quote that no word goes on behind.
fn quoted(text: &str) -> Option<&str> {
    let quote = text.chars().next()?;
    let ends = text.char_indices().skip(1).filter(|(_, c)| *c == quote).map(|(at, _)| at + 1);
    ends.map(|end| &text[..end]).find(|piece| !text[piece.len()..].starts_with(is_of_word))
}

/// What may be a number at the beginning.
fn number(text: &str) -> &str {
    let bytes = text.as_bytes();
    let mut end = 0;
    while let Some(byte) = bytes.get(end) {
        let digit_follows = bytes.get(end + 1).is_some_and(u8::is_ascii_digit);
        let goes_on = match byte {
            b'.' | b',' => digit_follows,
            b'-' | b'+' => digit_follows && matches!(bytes[end - 1], b'e' | b'E'),
            byte => byte.is_ascii_alphanumeric() || *byte == b'_',
        };
        if !goes_on {
            break;
        }
        end += 1;
    }
    &text[..end]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn veil(names: &[&str], message: &str) -> String {
        let mut veil = Veil::default();
        veil.names(names.iter().copied());
        veil.over(message)
    }

    #[test]
    fn names_and_numbers_go_and_the_sentence_stays() {
        let message =
            "joint 'el'bow' names the link 'uper_arm', which is not there; did you mean 'upper_arm'?";
        assert_eq!(veil(&[], message), "joint '…' names the link '…', which is not there; did you mean '…'?");
        assert_eq!(
            veil(&[], "its limits -2.6 to 1e-3 exclude 0, the zero pose"),
            "its limits # to # exclude #, the zero pose"
        );
        assert_eq!(veil(&[], "'value': '2,0' is no finite number"), "'…': '…' is no finite number");
        assert_eq!(veil(&[], "the figure's mass of URDF 'x' is 0"), "the figure's mass of URDF '…' is #");
    }

    #[test]
    fn a_name_without_quotes_goes_too() {
        assert_eq!(veil(&["head"], "head of left_knee.rx and Bob"), "… of ….rx and …");
        // Not only at the beginning of a message.
        assert_eq!(veil(&["nose"], "The nose is heavy"), "The … is heavy");
        assert_eq!(veil(&[], "élan 7up"), "… …");
    }

    #[test]
    fn names_are_found_in_texts() {
        let mut veil = Veil::default();
        veil.text("<robot name='rex'><!-- the mass of a link --><parent>tail base</parent></robot>", false);
        assert_eq!(veil.over("rex has a tail and a mass"), "… has a … and a mass");
        let mut veil = Veil::default();
        veil.text("Figure(links: [Link(name: \"ear\")])", false);
        assert_eq!(veil.over("ear of links"), "… of links");
        let mut veil = Veil::default();
        veil.text("time,elbow\n0,1", true);
        assert_eq!(veil.over("column elbow"), "column …");
    }
}
