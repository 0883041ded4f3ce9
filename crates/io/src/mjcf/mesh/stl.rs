//! STL: triangles one by one, binary or as text.

use super::Triangle;
use solaris_model::Vector3;

/// Bytes before the triangles, and of each.
const HEAD: usize = 84;
const EACH: usize = 50;

pub(super) fn read(bytes: &[u8]) -> Result<Vec<Triangle>, String> {
    let told = bytes.get(80..HEAD).and_then(|word| word.try_into().ok()).map(u32::from_le_bytes);
    let fits = told.is_some_and(|count| {
        (count as usize).checked_mul(EACH).and_then(|all| all.checked_add(HEAD)) == Some(bytes.len())
    });
    if fits {
        return Ok(binary(&bytes[HEAD..]));
    }
    if bytes.trim_ascii_start().starts_with(b"solid") {
        let text =
            std::str::from_utf8(bytes).map_err(|_| "it begins as an STL of text and is none".to_owned())?;
        return ascii(text);
    }
    Err(match told {
        None => "it is too short for an STL".to_owned(),
        Some(count) => format!(
            "its header tells of {count} triangles, and its {} bytes hold {}",
            bytes.len(),
            bytes.len().saturating_sub(HEAD) as f64 / EACH as f64
        ),
    })
}

fn binary(bytes: &[u8]) -> Vec<Triangle> {
    let number = |bytes: &[u8]| bytes.try_into().map_or(f32::NAN, f32::from_le_bytes);
    let corner = |bytes: &[u8]| {
        Vector3::new(number(&bytes[..4]), number(&bytes[4..8]), number(&bytes[8..12])).map(f64::from)
    };
    // A normal stands first.
    let triangle = |bytes: &[u8]| [corner(&bytes[12..24]), corner(&bytes[24..36]), corner(&bytes[36..48])];
    bytes.chunks_exact(EACH).map(triangle).collect()
}

fn ascii(text: &str) -> Result<Vec<Triangle>, String> {
    let mut words = text.split_ascii_whitespace();
    let (mut triangles, mut corners) = (Vec::new(), Vec::with_capacity(3));
    while let Some(word) = words.next() {
        match word {
            "vertex" => {
                let mut number = || words.next().and_then(|word| word.parse().ok());
                let corner = (|| Some(Vector3::new(number()?, number()?, number()?)))();
                corners.push(corner.ok_or("a 'vertex' has no three numbers")?);
            }
            "endfacet" => {
                let found: Result<Triangle, _> = std::mem::take(&mut corners).try_into();
                triangles
                    .push(found.map_err(|found: Vec<_>| {
                        format!("a facet has {} corners, not three", found.len())
                    })?);
            }
            _ => {}
        }
    }
    Ok(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes(triangles: u32, told: u32) -> Vec<u8> {
        let mut bytes = vec![b's'; 80];
        bytes.extend(told.to_le_bytes());
        bytes.extend((0..triangles).flat_map(|_| [0_u8; 50]));
        bytes
    }

    #[test]
    fn a_header_that_lies_about_its_count_is_refused() {
        assert_eq!(read(&bytes(2, 2)).map(|all| all.len()), Ok(2));
        for told in [0, 1, 3, u32::MAX] {
            let error = read(&bytes(2, told)).expect_err("a lie");
            assert_eq!(error, format!("its header tells of {told} triangles, and its 184 bytes hold 2"));
        }
        assert!(read(&[0; 20]).is_err());
    }

    #[test]
    fn text_is_read_too() {
        let text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5e0 0\nendloop\nendfacet\nendsolid";
        let triangles = read(text.as_bytes()).expect("triangles");
        assert_eq!(triangles, [[Vector3::zeros(), Vector3::x(), Vector3::y() * 1.5]]);
        assert!(read(&text.as_bytes()[..60]).map_or(true, |found| found.is_empty()));
        assert!(read(text.replace("1.5e0", "x").as_bytes()).is_err());
    }
}
