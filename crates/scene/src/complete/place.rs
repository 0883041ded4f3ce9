//! A place in a text that may be broken, and texts around it that are not.

use solaris_model::text::parse;
use std::iter::Peekable;
use std::str::CharIndices;

/// What may stand at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stand {
    /// A field's name, before its colon.
    Field,
    /// A bare word.
    Word,
    /// A text in quotes.
    Name,
    /// The same as a key of a map, before its colon.
    Key,
}

/// Brackets that are open at a place.
#[derive(Clone, Debug)]
struct Level {
    open: char,
    /// Where the bracket stands.
    at: usize,
    /// Where its commas stand.
    commas: Vec<usize>,
    /// Whether a colon stands between them.
    has_colon: bool,
}

/// A place where somebody is writing.
#[derive(Debug)]
pub(super) struct Place<'t> {
    text: &'t str,
    /// The bytes of the word, or of what stands between quotes.
    pub(super) from: usize,
    pub(super) to: usize,
    /// Whether quotes are open.
    pub(super) in_quotes: bool,
    /// Whether a colon follows.
    pub(super) has_colon: bool,
    levels: Vec<Level>,
    stands: &'static [Stand],
}

/// The nearest place before a byte at which a character begins.
pub(super) fn boundary(text: &str, offset: usize) -> usize {
    let mut at = offset.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

impl<'t> Place<'t> {
    /// The place of a byte; none in comments, in numbers, and where only a comma can follow.
    pub(super) fn find(text: &'t str, offset: usize) -> Option<Self> {
        let offset = boundary(text, offset);
        let seen = Seen::of(&text[..offset]);
        let rest = &text[offset..];
        let (from, to, in_quotes) = match seen.inside {
            Inside::Comment => return None,
            Inside::Quotes(start) => {
                let end = rest.find(['"', '\n']);
                let closed = end.is_some_and(|end| rest[end..].starts_with('"'));
                (start + 1, offset + if closed { end.unwrap_or_default() } else { 0 }, true)
            }
            Inside::Code => {
                let word = text[..offset].trim_end_matches(is_of_word).len();
                let end = rest.find(|c| !is_of_word(c)).unwrap_or(rest.len());
                (word, offset + end, false)
            }
        };
        let is_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+');
        if !in_quotes && (text[from..].starts_with(is_number) || text[..from].ends_with(['.', '-', '+'])) {
            return None;
        }
        let before = if in_quotes { from - 1 } else { from };
        let Seen { levels, last, .. } = Seen::of(&text[..before]);
        let after = Self::after(text, to, in_quotes);
        let has_colon = text[after..].trim_start().starts_with(':');
        let value: &'static [Stand] = if in_quotes { &[Stand::Name] } else { &[Stand::Word, Stand::Name] };
        let stands: &'static [Stand] = match (levels.last(), last) {
            (_, Some(':')) | (None, None) | (Some(Level { open: '[', .. }), Some('[' | ',')) => value,
            (Some(Level { open: '{', .. }), Some('{' | ',')) => &[Stand::Key],
            (Some(Level { open: '(', has_colon, .. }), Some(last @ ('(' | ','))) => {
                match (in_quotes, has_colon, last) {
                    (false, true, _) => &[Stand::Field],
                    (false, false, '(') => &[Stand::Field, Stand::Word, Stand::Name][..],
                    _ => value,
                }
            }
            _ => return None,
        };
        Some(Self { text, from, to, in_quotes, has_colon, levels, stands })
    }

    /// The byte after what stands here, with the quotes that close it.
    fn after(text: &str, to: usize, in_quotes: bool) -> usize {
        to + usize::from(in_quotes && text[to..].starts_with('"'))
    }

    /// What may stand here.
    pub(super) fn stands(&self) -> &'static [Stand] {
        self.stands
    }

    /// Texts with a word here that nobody knows, each with a byte in this word: with all that follows; with nothing behind it, but for
    /// the brackets that close; and the same without whatever is broken before it.
    pub(super) fn tries(&self, stand: Stand, nobody: &str) -> Vec<(String, usize)> {
        let Self { text, from, to, in_quotes, has_colon, levels, .. } = self;
        let begin = if *in_quotes { from - 1 } else { *from };
        let tail = &text[Self::after(text, *to, *in_quotes)..];
        let word = match stand {
            Stand::Field | Stand::Word => nobody.to_owned(),
            Stand::Name | Stand::Key => format!("\"{nobody}\""),
        };
        let needs_value = matches!(stand, Stand::Field | Stand::Key);
        let value = if needs_value { ": 0" } else { "" };
        let closers: String = levels.iter().rev().map(|level| closing(level.open)).collect();
        let next = tail.trim_start().chars().next();
        let comma =
            if next.is_none_or(|next| ",)]}:".contains(next)) || tail.starts_with('(') { "" } else { "," };
        let whole = format!("{}{word}{}{comma}{tail}", &text[..begin], if *has_colon { "" } else { value });
        let cut = format!("{}{word}{value}{closers}", &text[..begin]);
        let sound = self.sound(begin);
        let at = sound.len() + 1;
        vec![(whole, begin + 1), (cut, begin + 1), (format!("{sound}{word}{value}{closers}"), at)]
    }

    /// The text before the place, without what is broken in the brackets that are open.
    fn sound(&self, begin: usize) -> String {
        let Some(first) = self.levels.first() else { return String::new() };
        let mut sound = self.text[..=first.at].to_owned();
        for (i, Level { open, at, commas, .. }) in self.levels.iter().enumerate() {
            let end = self.levels.get(i + 1).map_or(begin, |next| next.at + 1);
            let mut start = at + 1;
            for comma in commas {
                let piece = &self.text[start..*comma];
                if parse(&format!("X{open}{piece}{}", closing(*open)), "piece", "X(…)").is_ok()
                    || is_entry(*open, piece)
                {
                    sound.push_str(piece);
                    sound.push(',');
                }
                start = comma + 1;
            }
            sound.push_str(&self.text[start..end]);
        }
        sound
    }
}

/// Whether it is sound in brackets that have no name before them.
fn is_entry(open: char, piece: &str) -> bool {
    open != '(' && parse(&format!("X({open}{piece}{})", closing(open)), "piece", "X(…)").is_ok()
}

fn closing(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

/// Where the end of a text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Inside {
    Code,
    Comment,
    /// In quotes that open at this byte.
    Quotes(usize),
}

/// What is open at the end of a text.
struct Seen {
    levels: Vec<Level>,
    inside: Inside,
    /// The last character that is no blank and no part of a comment.
    last: Option<char>,
}

impl Seen {
    fn of(text: &str) -> Self {
        let mut seen = Self { levels: Vec::new(), inside: Inside::Code, last: None };
        let mut chars = text.char_indices().peekable();
        while let Some((at, c)) = chars.next() {
            let rest = &text[at..];
            seen.inside = match c {
                '"' if !pass_quotes(&mut chars) => Inside::Quotes(at),
                '/' if rest.starts_with("//") => {
                    if chars.any(|(_, c)| c == '\n') {
                        Inside::Code
                    } else {
                        Inside::Comment
                    }
                }
                '/' if rest.starts_with("/*") => {
                    chars.next();
                    if pass_comment(&mut chars) { Inside::Code } else { Inside::Comment }
                }
                _ => Inside::Code,
            };
            if seen.inside != Inside::Code || rest.starts_with("//") || rest.starts_with("/*") {
                continue;
            }
            match c {
                '(' | '[' | '{' => {
                    seen.levels.push(Level { open: c, at, commas: Vec::new(), has_colon: false });
                }
                ')' | ']' | '}' => drop(seen.levels.pop()),
                ',' => seen.levels.iter_mut().last().into_iter().for_each(|level| level.commas.push(at)),
                ':' => seen.levels.iter_mut().last().into_iter().for_each(|level| level.has_colon = true),
                _ => {}
            }
            if !c.is_whitespace() {
                seen.last = Some(c);
            }
        }
        seen
    }
}

/// Passes a text whose quotes have opened; whether they close on its line.
fn pass_quotes(chars: &mut Peekable<CharIndices<'_>>) -> bool {
    while let Some((_, c)) = chars.next() {
        match c {
            // A name over several lines is a quote that was forgotten.
            '"' | '\n' => return true,
            '\\' => drop(chars.next()),
            _ => {}
        }
    }
    false
}

/// Passes a comment that has opened, which may hold others; whether it closes.
fn pass_comment(chars: &mut Peekable<CharIndices<'_>>) -> bool {
    let mut depth = 1;
    while let Some((_, c)) = chars.next() {
        let next = chars.peek().map(|(_, next)| *next);
        match (c, next) {
            ('/', Some('*')) => depth += 1,
            ('*', Some('/')) => depth -= 1,
            _ => continue,
        }
        chars.next();
        if depth == 0 {
            return true;
        }
    }
    false
}
