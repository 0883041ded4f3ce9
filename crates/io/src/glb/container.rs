//! The container: a header, the JSON part, the binary part.

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
    let mut text = root.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let parts = [(JSON, &text), (BIN, &binary)];
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
