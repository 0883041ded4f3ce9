//! Files of triangles, by their extensions.

use super::hull::hull;
use super::{Triangle, obj, stl};
use solaris_model::Vector3;

/// The triangles of a file.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Vec<Triangle>, String> {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension).to_ascii_lowercase();
    match extension.as_str() {
        "stl" => stl::read(bytes),
        "obj" => obj::read(bytes),
        "msh" => msh(bytes),
        _ => Err(format!("files of the extension '{extension}' are not read; stl, obj and msh are")),
    }
}

/// Triangles of the corners that three indices each name; without any there is but a cloud of points.
pub(super) fn indexed(corners: &[f64], faces: &[f64]) -> Result<Vec<Triangle>, String> {
    let corner = |index: f64| {
        let at = index as usize;
        let known = index >= 0.0 && index.fract() == 0.0 && at < corners.len() / 3;
        known.then(|| Vector3::new(corners[3 * at], corners[3 * at + 1], corners[3 * at + 2]))
    };
    if !corners.len().is_multiple_of(3) || !faces.len().is_multiple_of(3) {
        return Err("its numbers do not come in threes".to_owned());
    }
    if faces.is_empty() {
        let points: Vec<Vector3<f64>> = corners.chunks_exact(3).map(Vector3::from_column_slice).collect();
        return hull(&points);
    }
    faces
        .chunks_exact(3)
        .map(|face| {
            let missing = || format!("a face names a corner that is not there, of {}", corners.len() / 3);
            Ok([
                corner(face[0]).ok_or_else(missing)?,
                corner(face[1]).ok_or_else(missing)?,
                corner(face[2]).ok_or_else(missing)?,
            ])
        })
        .collect()
}

/// MuJoCo's own binary format: the counts of corners, normals, texture coordinates and faces, then their numbers.
fn msh(bytes: &[u8]) -> Result<Vec<Triangle>, String> {
    let word = |i: usize| -> Option<[u8; 4]> { bytes.get(4 * i..4 * i + 4)?.try_into().ok() };
    let count = |i: usize| word(i).map(i32::from_le_bytes).and_then(|count| usize::try_from(count).ok());
    let short = || "it is cut off, or no MSH file of MuJoCo".to_owned();
    let [corners, normals, texture, faces] = [
        count(0).ok_or_else(short)?,
        count(1).ok_or_else(short)?,
        count(2).ok_or_else(short)?,
        count(3).ok_or_else(short)?,
    ];
    let words = 4 + 3 * (corners + normals + faces) + 2 * texture;
    if bytes.len() != 4 * words {
        return Err(format!(
            "its header tells of {corners} corners and {faces} faces, which make {} bytes, and it has {}",
            4 * words,
            bytes.len()
        ));
    }
    let numbers = |from: usize, count: usize| (from..from + count).filter_map(word);
    let points: Vec<f64> = numbers(4, 3 * corners).map(|word| f64::from(f32::from_le_bytes(word))).collect();
    let indices: Vec<f64> =
        numbers(words - 3 * faces, 3 * faces).map(|word| f64::from(i32::from_le_bytes(word))).collect();
    indexed(&points, &indices)
}
