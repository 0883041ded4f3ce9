//! The text of a BVH file: a hierarchy of joints, and rows of their channels.

use solaris_model::{TextError, Vector3};
use std::ops::Range;

/// The most channels of all joints together, so that a row is never longer than memory.
const MOST_CHANNELS: usize = 1_000_000;
/// The most joints of a file, as many as models of other formats may have bodies.
const MOST_JOINTS: usize = 1 << 17;

/// A file as it is written: lengths in its own unit, along its own axes, angles in degrees.
pub(super) struct Text<'a> {
    /// Parents before their children.
    pub(super) joints: Vec<Node<'a>>,
    /// Numbers of a row.
    pub(super) width: usize,
    /// Rows.
    pub(super) count: usize,
    /// Rows that the file says it has, and where.
    pub(super) said: Option<(usize, Range<usize>)>,
    /// From row to row (s); none where the file has no motion.
    pub(super) interval: Option<f64>,
    /// Row by row.
    pub(super) values: Vec<f64>,
}

/// A `ROOT` or `JOINT`.
pub(super) struct Node<'a> {
    pub(super) name: &'a str,
    /// Where its name stands.
    pub(super) span: Range<usize>,
    pub(super) parent: Option<usize>,
    pub(super) offset: Vector3<f64>,
    pub(super) channels: Vec<Channel>,
    /// Where its channels begin in a row.
    pub(super) first: usize,
    /// Where its `End Site` is, if it has one.
    pub(super) end: Option<Vector3<f64>>,
}

/// What a number of a row is: of axis 0, 1, 2 for x, y, z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channel {
    Position(usize),
    Rotation(usize),
}

impl Text<'_> {
    /// The numbers of one row.
    pub(super) fn row(&self, index: usize) -> &[f64] {
        &self.values[index * self.width..][..self.width]
    }
}

/// Reads a file.
pub(super) fn parse(text: &str) -> Result<Text<'_>, TextError> {
    let mut cursor = Cursor { text, at: 0 };
    let (joints, width) = hierarchy(&mut cursor)?;
    let mut found = Text { joints, width, count: 0, said: None, interval: None, values: Vec::new() };
    motion(&mut cursor, &mut found)?;
    Ok(found)
}

/// A place in the text.
struct Cursor<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Cursor<'a> {
    fn fault<T>(&self, span: Range<usize>, message: impl Into<String>) -> Result<T, TextError> {
        Err(TextError::one(self.text, span, message))
    }

    /// The next word and where it stands; braces are words.
    fn word(&mut self) -> Option<(&'a str, Range<usize>)> {
        let rest = &self.text[self.at..];
        let blank = |c: char| c.is_whitespace() || c == '\u{feff}';
        let start = self.at + (rest.len() - rest.trim_start_matches(blank).len());
        let rest = &self.text[start..];
        let first = rest.chars().next()?;
        let length = match first {
            '{' | '}' => 1,
            _ => rest.find(|c: char| c.is_whitespace() || matches!(c, '{' | '}')).unwrap_or(rest.len()),
        };
        self.at = start + length;
        Some((&rest[..length], start..start + length))
    }

    /// The next word, which the text may not end before.
    fn need(&mut self, wanted: &str) -> Result<(&'a str, Range<usize>), TextError> {
        let end = self.text.len();
        match self.word() {
            Some(word) => Ok(word),
            None => self.fault(end..end, format!("the text ends where {wanted} should be")),
        }
    }

    /// What is left of the line, without blanks around it, up to a brace.
    fn line(&mut self) -> (&'a str, Range<usize>) {
        let rest = &self.text[self.at..];
        let end = rest.find(['\n', '\r', '{', '}']).unwrap_or(rest.len());
        let line = &rest[..end];
        let start = self.at + (line.len() - line.trim_start().len());
        self.at += end;
        let line = line.trim();
        (line, start..start + line.len())
    }

    fn number(&mut self, what: &str) -> Result<f64, TextError> {
        let (word, span) = self.need(what)?;
        match number(word) {
            Some(value) => Ok(value),
            None => self.fault(span, format!("{what} is '{}'; it must be a finite number", shown(word))),
        }
    }

    fn offset(&mut self, owner: &str) -> Result<Vector3<f64>, TextError> {
        let what = format!("a coordinate of the OFFSET of '{owner}'");
        Ok(Vector3::new(self.number(&what)?, self.number(&what)?, self.number(&what)?))
    }
}

/// A finite number; some tools write a decimal comma.
fn number(word: &str) -> Option<f64> {
    let value = word.parse().or_else(|_| word.replacen(',', ".", 1).parse::<f64>()).ok()?;
    value.is_finite().then_some(value)
}

/// A word for a message.
fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}

/// A block that is open.
#[derive(Clone, Copy)]
enum Block {
    Joint(usize),
    /// The `End Site` of a joint.
    End(usize),
}

fn hierarchy<'a>(cursor: &mut Cursor<'a>) -> Result<(Vec<Node<'a>>, usize), TextError> {
    let (word, span) = cursor.need("HIERARCHY")?;
    if !word.eq_ignore_ascii_case("HIERARCHY") {
        return cursor
            .fault(span, format!("it begins with '{}'; a BVH file begins with HIERARCHY", shown(word)));
    }
    let mut joints: Vec<Node> = Vec::new();
    let (mut open, mut width) = (Vec::<Block>::new(), 0);
    loop {
        let wanted = match open.last() {
            None => "ROOT",
            Some(Block::Joint(_)) => "OFFSET, CHANNELS, JOINT, End Site or }",
            Some(Block::End(_)) => "OFFSET or }",
        };
        let (word, span) = cursor.need(wanted)?;
        match (word.to_ascii_uppercase().as_str(), open.last().copied()) {
            ("ROOT", None) => {
                joints.push(opened(cursor, None, width)?);
                open.push(Block::Joint(0));
            }
            ("JOINT", Some(Block::Joint(parent))) => {
                if joints.len() > MOST_JOINTS {
                    return cursor.fault(span, format!("there are more than {MOST_JOINTS} joints"));
                }
                open.push(Block::Joint(joints.len()));
                joints.push(opened(cursor, Some(parent), width)?);
            }
            ("END", Some(Block::Joint(joint))) => {
                cursor.line();
                brace(cursor, "an End Site")?;
                open.push(Block::End(joint));
            }
            ("OFFSET", Some(Block::Joint(joint))) => {
                joints[joint].offset = cursor.offset(joints[joint].name)?;
            }
            ("OFFSET", Some(Block::End(joint))) => {
                let end = cursor.offset(joints[joint].name)?;
                joints[joint].end = joints[joint].end.or(Some(end));
            }
            ("CHANNELS", Some(Block::Joint(joint))) => {
                if !joints[joint].channels.is_empty() {
                    return cursor.fault(span, format!("'{}' has CHANNELS twice", joints[joint].name));
                }
                let channels = channels(cursor, joints[joint].name)?;
                // Channels stand in a row in the order in which they are declared.
                joints[joint].first = width;
                width += channels.len();
                joints[joint].channels = channels;
                if width > MOST_CHANNELS {
                    return cursor.fault(span, format!("there are more than {MOST_CHANNELS} channels"));
                }
            }
            ("}", Some(_)) => {
                open.pop();
                if open.is_empty() {
                    return Ok((joints, width));
                }
            }
            _ => return cursor.fault(span, format!("'{}' stands where {wanted} should be", shown(word))),
        }
    }
}

/// A joint whose name comes next, and its opening brace.
fn opened<'a>(cursor: &mut Cursor<'a>, parent: Option<usize>, first: usize) -> Result<Node<'a>, TextError> {
    let (name, span) = cursor.line();
    brace(cursor, if name.is_empty() { "a joint" } else { name })?;
    Ok(Node { name, span, parent, offset: Vector3::zeros(), channels: Vec::new(), first, end: None })
}

fn brace(cursor: &mut Cursor, owner: &str) -> Result<(), TextError> {
    match cursor.need("{")? {
        ("{", _) => Ok(()),
        (word, span) => {
            cursor.fault(span, format!("'{}' stands where the {{ of '{owner}' should be", shown(word)))
        }
    }
}

fn channels(cursor: &mut Cursor, owner: &str) -> Result<Vec<Channel>, TextError> {
    let (word, span) = cursor.need("the number of channels")?;
    let Some(count) = word.parse::<usize>().ok().filter(|count| *count <= 6) else {
        return cursor.fault(span, format!("'{owner}' has '{}' channels; a joint has 0 to 6", shown(word)));
    };
    let mut channels = Vec::with_capacity(count);
    for _ in 0..count {
        let (word, span) = cursor.need("a channel")?;
        let lower = word.to_ascii_lowercase();
        let axis = ["x", "y", "z"].iter().position(|axis| lower.starts_with(axis));
        let channel = match (axis, lower.get(1..)) {
            (Some(axis), Some("position")) => Channel::Position(axis),
            (Some(axis), Some("rotation")) => Channel::Rotation(axis),
            _ => {
                let message = format!(
                    "'{owner}' has the channel '{}'; channels are Xposition, Yposition, Zposition, Xrotation, \
                     Yrotation, Zrotation",
                    shown(word)
                );
                return cursor.fault(span, message);
            }
        };
        if channels.contains(&channel) {
            return cursor.fault(span, format!("'{owner}' has the channel '{word}' twice"));
        }
        channels.push(channel);
    }
    Ok(channels)
}

fn motion(cursor: &mut Cursor, found: &mut Text) -> Result<(), TextError> {
    // A skeleton alone.
    let Some((word, span)) = cursor.word() else { return Ok(()) };
    if word.eq_ignore_ascii_case("ROOT") {
        return cursor
            .fault(span, "a second ROOT; a file with several figures is not read: keep one of them");
    }
    if !word.eq_ignore_ascii_case("MOTION") {
        return cursor.fault(span, format!("'{}' stands where MOTION should be", shown(word)));
    }
    let (frames, span) = heading(cursor, "Frames")?;
    let Ok(said) = frames.parse::<usize>() else {
        return cursor.fault(span, format!("'{}' is no number of frames", shown(frames)));
    };
    found.said = Some((said, span));
    let (interval, span) = heading(cursor, "Frame Time")?;
    let interval = match number(interval) {
        Some(interval) if interval > 0.0 || said <= 1 => interval,
        _ => {
            return cursor.fault(
                span,
                format!("Frame Time is '{}'; it must be a number of seconds above zero", shown(interval)),
            );
        }
    };
    found.interval = (interval > 0.0).then_some(interval);
    rows(cursor, found)
}

/// What stands behind a heading and its colon.
fn heading<'a>(cursor: &mut Cursor<'a>, name: &str) -> Result<(&'a str, Range<usize>), TextError> {
    let blank = cursor.text[cursor.at..].len() - cursor.text[cursor.at..].trim_start().len();
    cursor.at += blank;
    let (line, span) = cursor.line();
    let begins = line.get(..name.len()).is_some_and(|word| word.eq_ignore_ascii_case(name));
    if !begins {
        return cursor.fault(span, format!("'{}' stands where '{name}:' should be", shown(line)));
    }
    let value = line[name.len()..].trim_start_matches(|c: char| c.is_whitespace() || c == ':');
    Ok((value, span.end - value.len()..span.end))
}

/// The numbers: a frame a line, or as many in all.
fn rows(cursor: &mut Cursor, found: &mut Text) -> Result<(), TextError> {
    let mut uneven: Option<(Range<usize>, usize)> = None;
    let mut at = cursor.at;
    for line in cursor.text[cursor.at..].split_inclusive('\n') {
        let (start, before) = (at, found.values.len());
        at += line.len();
        for word in line.split_whitespace() {
            let Some(value) = number(word) else {
                let from = start + (word.as_ptr() as usize - line.as_ptr() as usize);
                return cursor
                    .fault(from..from + word.len(), format!("'{}' is no finite number", shown(word)));
            };
            found.values.push(value);
        }
        let count = found.values.len() - before;
        if count > 0 && count != found.width && uneven.is_none() {
            uneven = Some((start..start + line.trim_end().len(), count));
        }
    }
    let said = found.said.as_ref().map_or(0, |(said, _)| *said);
    found.count = found.values.len().checked_div(found.width).unwrap_or(0);
    match uneven {
        // Frames over several lines are as good, if all are there.
        Some((span, count)) if Some(found.values.len()) != said.checked_mul(found.width) => cursor
            .fault(span, format!("the line has {count} numbers, and the hierarchy {} channels", found.width)),
        _ => Ok(()),
    }
}
