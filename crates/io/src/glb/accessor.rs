//! Arrays of numbers: whatever their components, strides and sparse parts, as rows of f64.

use super::document::{At, Document};
use super::fault::GlbError;

/// The rows of an array, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rows {
    /// Numbers of a row.
    pub(super) width: usize,
    pub(super) values: Vec<f64>,
}

impl Rows {
    pub(super) fn len(&self) -> usize {
        self.values.len() / self.width
    }

    pub(super) fn row(&self, i: usize) -> &[f64] {
        &self.values[i * self.width..][..self.width]
    }
}

/// What reads a number out of its bytes.
type Read = fn(&[u8]) -> f64;

/// A kind of component.
#[derive(Clone, Copy)]
struct Component {
    size: usize,
    read: Read,
    /// What stands for one where numbers are shares.
    one: f64,
}

fn component(at: &At) -> Result<Component, GlbError> {
    let (size, read, one): (usize, Read, f64) = match at.as_whole()? {
        5120 => (1, |b| f64::from(b[0] as i8), 127.0),
        5121 => (1, |b| f64::from(b[0]), 255.0),
        5122 => (2, |b| f64::from(i16::from_le_bytes([b[0], b[1]])), 32_767.0),
        5123 => (2, |b| f64::from(u16::from_le_bytes([b[0], b[1]])), 65_535.0),
        5125 => (4, |b| f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])), 4_294_967_295.0),
        5126 => (4, |b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])), 1.0),
        _ => return Err(at.wrong("5120, 5121, 5122, 5123, 5125 or 5126 (bytes to floats)")),
    };
    Ok(Component { size, read, one })
}

/// Numbers of a row, and of its columns, which begin at multiples of four bytes where they are matrices'.
fn shape(at: &At) -> Result<(usize, usize), GlbError> {
    Ok(match at.text()? {
        "SCALAR" => (1, 1),
        "VEC2" => (2, 2),
        "VEC3" => (3, 3),
        "VEC4" => (4, 4),
        "MAT2" => (4, 2),
        "MAT3" => (9, 3),
        "MAT4" => (16, 4),
        _ => return Err(at.wrong("SCALAR, VEC2 to VEC4 or MAT2 to MAT4")),
    })
}

/// An array, each of its numbers finite; shares of whole numbers are from 0 (or −1) to 1.
pub(super) fn rows(document: &Document, index: usize) -> Result<Rows, GlbError> {
    let accessor = document.one("accessors", index)?;
    let count = accessor.need("count")?.as_whole()?;
    let kind = component(&accessor.need("componentType")?)?;
    let (width, column) = shape(&accessor.need("type")?)?;
    let place = &accessor.place;
    document.take(count.saturating_mul(width), place)?;
    let is_share = accessor.is_true("normalized");
    let value = |bytes: &[u8]| {
        let value = (kind.read)(bytes);
        // f = max(c / 127, −1) and so on (glTF 2.0, 3.11).
        if is_share { (value / kind.one).max(-1.0) } else { value }
    };
    let is_matrix = column < width;
    let pitch = if is_matrix { (column * kind.size).next_multiple_of(4) } else { column * kind.size };
    let row_size = pitch * (width / column);
    let row = |bytes: &[u8], into: &mut [f64]| {
        for (i, number) in into.iter_mut().enumerate() {
            let at = (i / column) * pitch + (i % column) * kind.size;
            *number = value(&bytes[at..at + kind.size]);
        }
    };
    let mut values = vec![0.0; count * width];
    if let Some(view) = accessor.get("bufferView") {
        let (bytes, stride) = document.view(view.index("bufferViews", document.count("bufferViews"))?)?;
        let part = Part {
            bytes,
            from: accessor.whole("byteOffset")?.unwrap_or(0),
            stride: stride.unwrap_or(row_size),
            size: row_size,
        };
        part.check(count, place)?;
        for i in 0..count {
            row(part.at(i), &mut values[i * width..][..width]);
        }
    }
    if let Some(sparse) = accessor.get("sparse") {
        let changed = sparse.need("count")?.as_whole()?;
        let part = |key: &str, size: Option<usize>| {
            let at = sparse.need(key)?;
            let view = at.need("bufferView")?.index("bufferViews", document.count("bufferViews"))?;
            let kind = if size.is_none() { Some(component(&at.need("componentType")?)?) } else { None };
            let size = size.or(kind.map(|kind| kind.size)).unwrap_or(1);
            let part = Part {
                bytes: document.view(view)?.0,
                from: at.whole("byteOffset")?.unwrap_or(0),
                stride: size,
                size,
            };
            part.check(changed, &at.place)?;
            Ok::<_, GlbError>((part, kind))
        };
        let (places, kind) = part("indices", None)?;
        let (rows, _) = part("values", Some(row_size))?;
        for i in 0..changed {
            let at = kind.map_or(0.0, |kind| (kind.read)(places.at(i))) as usize;
            if at >= count {
                let (value, want) = (at.to_string(), format!("one of {count} rows"));
                return Err(GlbError::Value {
                    place: format!("{place}.sparse.indices, row {i}"),
                    value,
                    want,
                });
            }
            row(rows.at(i), &mut values[at * width..][..width]);
        }
    }
    match values.iter().position(|x| !x.is_finite()) {
        Some(i) => Err(GlbError::NotFinite { place: place.clone(), row: i / width, value: values[i] }),
        None => Ok(Rows { width, values }),
    }
}

/// Rows of bytes, so many apart.
struct Part<'a> {
    bytes: &'a [u8],
    from: usize,
    stride: usize,
    size: usize,
}

impl Part<'_> {
    /// Refuses rows that are not there.
    fn check(&self, count: usize, place: &str) -> Result<(), GlbError> {
        let end = match count {
            0 => Some(0),
            _ => self
                .stride
                .checked_mul(count - 1)
                .and_then(|x| x.checked_add(self.from)?.checked_add(self.size)),
        };
        let needs = end.unwrap_or(usize::MAX);
        if needs > self.bytes.len() {
            return Err(GlbError::Bytes { place: place.to_owned(), needs, has: self.bytes.len() });
        }
        Ok(())
    }

    fn at(&self, i: usize) -> &[u8] {
        &self.bytes[self.from + i * self.stride..][..self.size]
    }
}
