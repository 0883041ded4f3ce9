//! The container: a header, the JSON part, the binary part.

use super::fault::GlbError;
use super::{File, palette};
use crate::error::IoError;
use serde_json::{Value, json};
use std::io::Write;

/// "JSON" and "BIN" as numbers.
const JSON: u32 = 0x4E4F_534A;
const BIN: u32 = 0x004E_4942;

pub(super) fn write(mut file: File, out: &mut impl Write) -> Result<(), IoError> {
    let mut root = json!({
        "asset": { "version": "2.0", "generator": "Solaris" },
    });
    if let Some(vrm) = file.vrm {
        root["extensionsUsed"] = json!(["VRMC_vrm"]);
        root["extensions"] = json!({ "VRMC_vrm": vrm });
    }
    if !file.scene.is_empty() {
        root["scene"] = json!(0);
        root["scenes"] = json!([{ "nodes": file.scene }]);
    }
    if file.palette.is_some() {
        let view = file.pack.view(&palette::png(), None);
        root["images"] = json!([{ "name": "palette", "bufferView": view, "mimeType": "image/png" }]);
        // Even between pixels, and no colour from beyond the strip's ends.
        root["samplers"] = json!([{ "magFilter": 9729, "minFilter": 9729, "wrapS": 33071, "wrapT": 33071 }]);
        root["textures"] = json!([{ "sampler": 0, "source": 0 }]);
    }
    let mut binary = file.pack.bytes;
    binary.resize(binary.len().next_multiple_of(4), 0);
    if !binary.is_empty() {
        root["buffers"] = json!([{ "byteLength": binary.len() }]);
    }
    let lists = [
        ("nodes", file.nodes),
        ("meshes", file.meshes),
        ("skins", file.skins),
        ("materials", file.materials),
        ("animations", file.animations),
        ("bufferViews", file.pack.views),
        ("accessors", file.pack.accessors),
    ];
    // An empty list is an error.
    for (key, list) in lists.into_iter().filter(|(_, list)| !list.is_empty()) {
        root[key] = Value::Array(list);
    }
    join(root.to_string().into_bytes(), &binary, out)
}

/// Puts JSON and bytes, a multiple of four of them, into one file.
pub(super) fn join(mut text: Vec<u8>, binary: &[u8], out: &mut impl Write) -> Result<(), IoError> {
    text.resize(text.len().next_multiple_of(4), b' ');
    let parts = [(JSON, &text[..]), (BIN, binary)];
    let parts = parts.into_iter().filter(|(_, bytes)| !bytes.is_empty());
    let total = 12 + parts.clone().map(|(_, bytes)| 8 + bytes.len()).sum::<usize>();
    let length = u32::try_from(total).map_err(|_| IoError::GlbSize { bytes: total })?;
    out.write_all(b"glTF")?;
    out.write_all(&2_u32.to_le_bytes())?;
    out.write_all(&length.to_le_bytes())?;
    for (kind, bytes) in parts {
        out.write_all(&(bytes.len() as u32).to_le_bytes())?;
        out.write_all(&kind.to_le_bytes())?;
        out.write_all(bytes)?;
    }
    Ok(out.flush()?)
}

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Parts<'a> {
    pub(super) json: &'a [u8],
    /// Nothing in a `.gltf`, and where there are no bytes.
    pub(super) binary: Option<&'a [u8]>,
}

/// The parts of a file; chunks of other kinds are passed over.
pub(super) fn split(bytes: &[u8]) -> Result<Parts<'_>, GlbError> {
    if !bytes.starts_with(b"glTF") {
        let json = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let is_text = json.iter().find(|b| !b.is_ascii_whitespace()) == Some(&b'{');
        return if is_text { Ok(Parts { json, binary: None }) } else { Err(GlbError::NotGltf) };
    }
    let word = |at: usize| {
        let four = bytes.get(at..at + 4).and_then(|four| four.try_into().ok()).map(u32::from_le_bytes);
        four.map(|word| word as usize).ok_or(GlbError::Length {
            what: "header",
            at: 0,
            said: 12,
            left: bytes.len(),
        })
    };
    let (version, length) = (word(4)?, word(8)?);
    if version != 2 {
        return Err(GlbError::Version { version: version.to_string() });
    }
    let file = bytes.get(..length);
    let file = file.ok_or(GlbError::Length { what: "header", at: 0, said: length, left: bytes.len() })?;
    let (mut parts, mut at) = (None::<Parts>, 12);
    while at + 8 <= file.len() {
        let (said, kind) = (word(at)?, word(at + 4)?);
        let left = file.len() - at - 8;
        let chunk = file.get(at + 8..).and_then(|rest| rest.get(..said));
        let chunk = chunk.ok_or(GlbError::Length { what: "chunk", at, said, left })?;
        match &mut parts {
            None if kind == JSON as usize => parts = Some(Parts { json: chunk, binary: None }),
            None => return Err(GlbError::NoJson),
            Some(parts) if kind == BIN as usize && parts.binary.is_none() => parts.binary = Some(chunk),
            Some(_) => {}
        }
        at += 8 + said;
    }
    parts.ok_or(GlbError::NoJson)
}
