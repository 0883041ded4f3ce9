//! A file as it is read: its JSON, value by value with the place of each, and its bytes.
//!
//! Nothing that stands in a file is trusted: each length, index and number is checked where it is read.

use super::container::{self, Parts};
use super::fault::GlbError;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;
use std::borrow::Cow;
use std::cell::Cell;

/// The most numbers that all arrays of a file may have together.
const MOST: usize = 40_000_000;
/// The longest value that a message shows (letters).
const SHOWN: usize = 60;

pub(super) struct Document<'a> {
    root: Value,
    buffers: Vec<Cow<'a, [u8]>>,
    /// How many numbers may still be read.
    left: Cell<usize>,
}

impl<'a> Document<'a> {
    /// The JSON and the buffers of a `.glb`, or of a `.gltf` that holds its bytes itself.
    pub(super) fn read(bytes: &'a [u8]) -> Result<Self, GlbError> {
        let Parts { json, binary } = container::split(bytes)?;
        let root: Value = serde_json::from_slice(json).map_err(|error| GlbError::Json {
            message: error.to_string().split(" at line").next().unwrap_or_default().to_owned(),
            line: error.line(),
            column: error.column(),
        })?;
        let mut document = Self { root, buffers: Vec::new(), left: Cell::new(MOST) };
        let version = document.root().get("asset").and_then(|asset| asset.get("version"));
        let version =
            version.map(|version| version.text().map(str::to_owned)).transpose()?.unwrap_or_default();
        if !version.starts_with("2.") {
            return Err(GlbError::Version { version });
        }
        let mut buffers = Vec::new();
        for (i, buffer) in document.list("buffers")?.into_iter().enumerate() {
            buffers.push(bytes_of(&buffer, if i == 0 { binary } else { None })?);
        }
        document.buffers = buffers;
        Ok(document)
    }

    pub(super) fn root(&self) -> At<'_> {
        At { value: &self.root, place: "the file".to_owned() }
    }

    /// A list of the file: nodes, accessors; nothing where there is none.
    pub(super) fn list(&self, key: &str) -> Result<Vec<At<'_>>, GlbError> {
        let Some(list) = self.root.get(key) else { return Ok(Vec::new()) };
        At { value: list, place: key.to_owned() }.each()
    }

    /// How many there are of them.
    pub(super) fn count(&self, key: &str) -> usize {
        self.root.get(key).and_then(Value::as_array).map_or(0, Vec::len)
    }

    /// One of a list, whose index was checked.
    pub(super) fn one(&self, key: &str, index: usize) -> Result<At<'_>, GlbError> {
        let value = self.root.get(key).and_then(|list| list.get(index));
        let place = format!("{key}[{index}]");
        value
            .map(|value| At { value, place: place.clone() })
            .ok_or_else(|| GlbError::Missing { place: "the file".to_owned(), key: place })
    }

    /// The bytes of a view, and its stride where it says one.
    pub(super) fn view(&self, index: usize) -> Result<(&[u8], Option<usize>), GlbError> {
        let view = self.one("bufferViews", index)?;
        for extension in ["EXT_meshopt_compression", "KHR_meshopt_compression"] {
            if view.get("extensions").is_some_and(|all| all.get(extension).is_some()) {
                return Err(GlbError::Packed { place: view.place, extension });
            }
        }
        let buffer = view.need("buffer")?.index("buffers", self.buffers.len())?;
        let from = view.whole("byteOffset")?.unwrap_or(0);
        let length = view.need("byteLength")?.as_whole()?;
        let bytes = &self.buffers[buffer];
        let bytes =
            from.checked_add(length).and_then(|end| bytes.get(from..end)).ok_or_else(|| GlbError::Bytes {
                place: view.place.clone(),
                needs: from.saturating_add(length),
                has: bytes.len(),
            })?;
        Ok((bytes, view.whole("byteStride")?))
    }

    /// Takes `count` numbers from those that may be read.
    pub(super) fn take(&self, count: usize, place: &str) -> Result<(), GlbError> {
        let left = self.left.get().checked_sub(count);
        self.left.set(left.ok_or_else(|| GlbError::Many { place: place.to_owned(), most: MOST })?);
        Ok(())
    }
}

fn bytes_of<'a>(buffer: &At, binary: Option<&'a [u8]>) -> Result<Cow<'a, [u8]>, GlbError> {
    let length = buffer.need("byteLength")?.as_whole()?;
    let bytes = match (buffer.get("uri"), binary) {
        (Some(uri), _) => {
            let text = uri.text()?;
            let coded = text.strip_prefix("data:").and_then(|data| data.split_once(";base64,"));
            let Some((_, coded)) = coded else {
                let uri = cut(text);
                return Err(GlbError::External { place: buffer.place.clone(), uri });
            };
            let bytes = STANDARD.decode(coded).map_err(|_| uri.wrong("base64"))?;
            Cow::Owned(bytes)
        }
        (None, Some(binary)) => Cow::Borrowed(binary),
        // What a compression falls back to has no bytes of its own.
        (None, None) => Cow::Borrowed(&[][..]),
    };
    if buffer.get("uri").is_none() && binary.is_none() {
        return Ok(bytes);
    }
    if bytes.len() < length {
        return Err(GlbError::Bytes { place: buffer.place.clone(), needs: length, has: bytes.len() });
    }
    Ok(match bytes {
        Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[..length]),
        Cow::Owned(mut bytes) => {
            bytes.truncate(length);
            Cow::Owned(bytes)
        }
    })
}

/// A value of the JSON and where it stands.
#[derive(Clone)]
pub(super) struct At<'a> {
    value: &'a Value,
    pub(super) place: String,
}

impl<'a> At<'a> {
    pub(super) fn get(&self, key: &str) -> Option<At<'a>> {
        let value = self.value.get(key)?;
        let place = if self.place == "the file" { key.to_owned() } else { format!("{}.{key}", self.place) };
        Some(At { value, place })
    }

    pub(super) fn need(&self, key: &str) -> Result<At<'a>, GlbError> {
        self.get(key).ok_or_else(|| GlbError::Missing { place: self.place.clone(), key: key.to_owned() })
    }

    /// The members of an array.
    pub(super) fn each(&self) -> Result<Vec<At<'a>>, GlbError> {
        let array = self.value.as_array().ok_or_else(|| self.wrong("an array"))?;
        let at = |(i, value)| At { value, place: format!("{}[{i}]", self.place) };
        Ok(array.iter().enumerate().map(at).collect())
    }

    /// The members of an object, by name.
    pub(super) fn members(&self) -> Vec<(&'a str, At<'a>)> {
        let all = self.value.as_object().into_iter().flatten();
        all.map(|(key, value)| (key.as_str(), At { value, place: format!("{}.{key}", self.place) })).collect()
    }

    pub(super) fn text(&self) -> Result<&'a str, GlbError> {
        self.value.as_str().ok_or_else(|| self.wrong("a text"))
    }

    pub(super) fn number(&self) -> Result<f64, GlbError> {
        self.value.as_f64().filter(|x| x.is_finite()).ok_or_else(|| self.wrong("a finite number"))
    }

    pub(super) fn as_whole(&self) -> Result<usize, GlbError> {
        // Some write whole numbers with a point.
        let whole = |x: f64| (x >= 0.0 && x.fract().abs() < f64::EPSILON && x < 9e15).then_some(x as usize);
        let found = self
            .value
            .as_u64()
            .and_then(|x| usize::try_from(x).ok())
            .or_else(|| self.value.as_f64().and_then(whole));
        found.ok_or_else(|| self.wrong("a whole number, zero or more"))
    }

    /// A whole number of the object, where it is there.
    pub(super) fn whole(&self, key: &str) -> Result<Option<usize>, GlbError> {
        self.get(key).map(|at| at.as_whole()).transpose()
    }

    /// The index of one of `count` things.
    pub(super) fn index(&self, of: &str, count: usize) -> Result<usize, GlbError> {
        let index = self.as_whole()?;
        if index < count { Ok(index) } else { Err(self.wrong(&format!("one of {count} {of}"))) }
    }

    /// `N` numbers of the object, where they are there.
    pub(super) fn numbers<const N: usize>(&self, key: &str) -> Result<Option<[f64; N]>, GlbError> {
        let Some(at) = self.get(key) else { return Ok(None) };
        let all = at.each()?;
        if all.len() != N {
            return Err(at.wrong(&format!("{N} numbers")));
        }
        let mut numbers = [0.0; N];
        for (number, at) in numbers.iter_mut().zip(all) {
            *number = at.number()?;
        }
        Ok(Some(numbers))
    }

    pub(super) fn is_true(&self, key: &str) -> bool {
        self.value.get(key).and_then(Value::as_bool).unwrap_or(false)
    }

    /// That the value is not what it must be.
    pub(super) fn wrong(&self, want: &str) -> GlbError {
        let value = match self.value {
            Value::Array(list) => format!("an array of {}", list.len()),
            Value::Object(_) => "an object".to_owned(),
            other => cut(&other.to_string()),
        };
        GlbError::Value { place: self.place.clone(), value, want: want.to_owned() }
    }
}

fn cut(text: &str) -> String {
    let mut shown: String = text.chars().take(SHOWN).collect();
    if shown.len() < text.len() {
        shown.push('…');
    }
    shown
}
