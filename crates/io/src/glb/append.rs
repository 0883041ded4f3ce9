//! A file with more animations: nothing that was there is written anew.

use super::container::{Parts, join, split};
use super::fault::GlbError;
use super::pack::Pack;
use crate::error::IoError;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::value::RawValue;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::ops::Range;

/// An animation of nodes: turns (x, y, z, w), of one key where they stand still, and the places of one.
pub(super) struct Added {
    pub(super) name: String,
    /// Of the keys (s).
    pub(super) times: Vec<f64>,
    pub(super) turns: Vec<(usize, Vec<[f32; 4]>)>,
    pub(super) root: usize,
    pub(super) way: Vec<[f32; 3]>,
}

/// Writes a file, which was read before, with more animations. Gives the names that they have.
pub(super) fn append(bytes: &[u8], added: Vec<Added>, out: &mut impl Write) -> Result<Vec<String>, IoError> {
    let Parts { json, binary } = split(bytes)?;
    let text = std::str::from_utf8(json).map_err(|_| GlbError::NoJson)?;
    let edit = Edit::of(text)?;
    let count = |key: &str| edit.list(key).map(|list| list.len());
    let mut pack = Pack { first: [count("bufferViews")?, count("accessors")?], ..Pack::default() };
    let buffers = edit.list("buffers")?;
    // The chunk is the first buffer's. Where there is none, the new bytes are a buffer of their own, inside the JSON if others are.
    let is_inside = binary.is_none() && !buffers.is_empty();
    pack.buffer = if is_inside { buffers.len() } else { 0 };
    if let (Some(binary), false) = (binary, is_inside) {
        pack.bytes.extend_from_slice(binary);
    }
    let mut taken = edit.taken_names()?;
    let (mut names, mut animations) = (Vec::new(), Vec::new());
    for Added { name, times, turns, root, way } in added {
        let mut animation = super::Animation::default();
        let all = pack.times(&times);
        let one = pack.times(&times[..times.len().min(1)]);
        for (node, turns) in &turns {
            let still =
                turns.iter().all(|turn| turn.iter().zip(&turns[0]).all(|(a, b)| a.to_bits() == b.to_bits()));
            let output = pack.floats(&turns[..if still { 1 } else { turns.len() }], None, false);
            animation.channel(*node, "rotation", if still { one } else { all }, output);
        }
        let output = pack.floats(&way, None, false);
        animation.channel(root, "translation", all, output);
        let name = free_name(&name, &taken);
        animations
            .push(json!({ "name": name, "channels": animation.channels, "samplers": animation.samplers }));
        taken.insert(name.clone());
        names.push(name);
    }
    let mut changes = vec![
        edit.grown("bufferViews", &pack.views)?,
        edit.grown("accessors", &pack.accessors)?,
        edit.grown("animations", &animations)?,
    ];
    let length = pack.bytes.len();
    pack.bytes.resize(length.next_multiple_of(4), 0);
    changes.push(match buffers.first() {
        Some(first) if !is_inside => edit.length(first, length)?,
        _ if is_inside => {
            let uri = format!("data:application/octet-stream;base64,{}", STANDARD.encode(&pack.bytes));
            edit.grown("buffers", &[json!({ "byteLength": pack.bytes.len(), "uri": uri })])?
        }
        _ => edit.grown("buffers", &[json!({ "byteLength": length })])?,
    });
    let binary = if is_inside { &[][..] } else { &pack.bytes };
    join(edit.with(changes).into_bytes(), binary, out)?;
    Ok(names)
}

/// A name that no animation has.
fn free_name(name: &str, taken: &BTreeSet<String>) -> String {
    let others = (2..).map(|number| format!("{name} {number}"));
    let mut free = std::iter::once(name.to_owned()).chain(others).filter(|name| !taken.contains(name));
    free.next().unwrap_or_default()
}

/// A JSON text that is changed in places.
struct Edit<'a> {
    text: &'a str,
    root: BTreeMap<String, &'a RawValue>,
}

/// What stands in a text in place of some bytes of it.
struct Change {
    at: Range<usize>,
    new: String,
    /// Whether it is a member of its own at the beginning of the root.
    is_member: bool,
}

impl<'a> Edit<'a> {
    fn of(text: &'a str) -> Result<Self, IoError> {
        Ok(Self { text, root: serde_json::from_str(text).map_err(|error| fault(&error))? })
    }

    fn list(&self, key: &str) -> Result<Vec<&'a RawValue>, IoError> {
        self.root.get(key).map_or_else(
            || Ok(Vec::new()),
            |raw| serde_json::from_str(raw.get()).map_err(|error| fault(&error)),
        )
    }

    /// Where a piece of the text stands in it.
    fn place(&self, piece: &str) -> Range<usize> {
        let at = piece.as_ptr() as usize - self.text.as_ptr() as usize;
        at..at + piece.len()
    }

    /// A list with more in it.
    fn grown(&self, key: &str, more: &[Value]) -> Result<Change, IoError> {
        let more = more.iter().map(Value::to_string).collect::<Vec<_>>().join(",");
        let Some(raw) = self.root.get(key) else {
            let start = self.text.find('{').map_or(0, |at| at + 1);
            return Ok(Change { at: start..start, new: format!("\"{key}\":[{more}]"), is_member: true });
        };
        let end = self.place(raw.get()).end - 1;
        let comma = if self.list(key)?.is_empty() { "" } else { "," };
        Ok(Change { at: end..end, new: format!("{comma}{more}"), is_member: false })
    }

    /// A buffer of another length.
    fn length(&self, buffer: &'a RawValue, length: usize) -> Result<Change, IoError> {
        let members: BTreeMap<String, &RawValue> =
            serde_json::from_str(buffer.get()).map_err(|error| fault(&error))?;
        let old = members.get("byteLength").map_or(buffer.get(), |raw| raw.get());
        Ok(Change { at: self.place(old), new: length.to_string(), is_member: false })
    }

    /// The names of its animations.
    fn taken_names(&self) -> Result<BTreeSet<String>, IoError> {
        let mut taken = BTreeSet::new();
        for animation in self.list("animations")? {
            let animation: Value = serde_json::from_str(animation.get()).map_err(|error| fault(&error))?;
            taken.extend(animation.get("name").and_then(Value::as_str).map(str::to_owned));
        }
        Ok(taken)
    }

    fn with(&self, mut changes: Vec<Change>) -> String {
        changes.sort_by_key(|change| change.at.start);
        let (mut text, mut at) = (String::with_capacity(self.text.len()), 0);
        for change in changes {
            text.push_str(&self.text[at..change.at.start]);
            text.push_str(&change.new);
            // Of an object with nothing in it this would be one comma too many; but a file has its asset.
            text.push_str(if change.is_member { "," } else { "" });
            at = change.at.end;
        }
        text.push_str(&self.text[at..]);
        text
    }
}

/// JSON that was read before and is none.
fn fault(error: &serde_json::Error) -> IoError {
    GlbError::Json { message: error.to_string(), line: error.line(), column: error.column() }.into()
}
