//! The binary part of a file: arrays of numbers one after the other, and what says where each is.

use serde_json::{Value, json};

/// Components of numbers, by their numbers in glTF.
const BYTE: u32 = 5121;
const SHORT: u32 = 5123;
const INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// What a view is read as, by its number in glTF.
pub(super) const VERTICES: Option<u32> = Some(34962);
pub(super) const INDICES: Option<u32> = Some(34963);

#[derive(Default)]
pub(super) struct Pack {
    /// The buffer that the bytes are, and how many views and accessors the file has before these.
    pub(super) buffer: usize,
    pub(super) first: [usize; 2],
    pub(super) bytes: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
}

impl Pack {
    /// A view of raw bytes; its index.
    pub(super) fn view(&mut self, bytes: &[u8], target: Option<u32>) -> usize {
        // Whatever is in it begins at a multiple of its own size.
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let mut view =
            json!({ "buffer": self.buffer, "byteOffset": self.bytes.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        self.bytes.extend_from_slice(bytes);
        self.views.push(view);
        self.first[0] + self.views.len() - 1
    }

    fn accessor(
        &mut self,
        view: usize,
        component: u32,
        count: usize,
        kind: &str,
        more: &[(&str, Value)],
    ) -> usize {
        let mut accessor =
            json!({ "bufferView": view, "componentType": component, "count": count, "type": kind });
        for (key, value) in more {
            accessor[*key] = value.clone();
        }
        self.accessors.push(accessor);
        self.first[1] + self.accessors.len() - 1
    }

    /// Rows of `N` floats (`SCALAR`, `VEC3`, `VEC4`, `MAT4`); with their least and greatest values where `limits` are wanted.
    pub(super) fn floats<const N: usize>(
        &mut self,
        rows: &[[f32; N]],
        target: Option<u32>,
        limits: bool,
    ) -> usize {
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let view = self.view(&bytes, target);
        let fold = |pick: fn(f32, f32) -> f32| -> Vec<f32> {
            (0..N).map(|k| rows.iter().map(|row| row[k]).reduce(pick).unwrap_or(0.0)).collect()
        };
        let limits = if limits {
            vec![("min", json!(fold(f32::min))), ("max", json!(fold(f32::max)))]
        } else {
            Vec::new()
        };
        let kind = match N {
            1 => "SCALAR",
            3 => "VEC3",
            4 => "VEC4",
            _ => "MAT4",
        };
        self.accessor(view, FLOAT, rows.len(), kind, &limits)
    }

    /// Rows of shares from 0 to 1 in steps of 1/65535, of vertices.
    pub(super) fn shares<const N: usize>(&mut self, rows: &[[u16; N]]) -> usize {
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let view = self.view(&bytes, VERTICES);
        let kind = if N == 2 { "VEC2" } else { "VEC4" };
        self.accessor(view, SHORT, rows.len(), kind, &[("normalized", json!(true))])
    }

    /// Four numbers of nodes a vertex.
    pub(super) fn joints(&mut self, rows: &[[u16; 4]]) -> usize {
        let small = rows.iter().flatten().all(|x| *x < 256);
        let narrow = |x: &u16| vec![*x as u8];
        let wide = |x: &u16| x.to_le_bytes().to_vec();
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(if small { narrow } else { wide }).collect();
        let view = self.view(&bytes, VERTICES);
        self.accessor(view, if small { BYTE } else { SHORT }, rows.len(), "VEC4", &[])
    }

    pub(super) fn triangles(&mut self, triangles: &[[u32; 3]], vertices: usize) -> usize {
        // 65535 itself means "begin anew" to some.
        let small = vertices <= 65_535;
        let narrow = |x: &u32| (*x as u16).to_le_bytes().to_vec();
        let wide = |x: &u32| x.to_le_bytes().to_vec();
        let bytes: Vec<u8> = triangles.iter().flatten().flat_map(if small { narrow } else { wide }).collect();
        let view = self.view(&bytes, INDICES);
        self.accessor(view, if small { SHORT } else { INT }, triangles.len() * 3, "SCALAR", &[])
    }

    /// Times of keys (s).
    pub(super) fn times(&mut self, times: &[f64]) -> usize {
        let rows: Vec<[f32; 1]> = times.iter().map(|time| [*time as f32]).collect();
        self.floats(&rows, None, true)
    }
}
