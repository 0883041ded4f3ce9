//! OBJ: corners, and faces of three corners or more.

use super::Triangle;
use super::hull::hull;
use solaris_model::Vector3;

/// The triangles of the first object of a file, which is the one that MuJoCo takes.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<Triangle>, String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "it is no text".to_owned())?;
    let mut corners: Vec<Vector3<f64>> = Vec::new();
    let (mut triangles, mut face, mut ended) = (Vec::new(), Vec::new(), false);
    for (i, line) in text.lines().enumerate() {
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") => {
                let mut number =
                    || words.next().and_then(|word| word.parse().ok()).filter(|x: &f64| x.is_finite());
                let corner = (|| Some(Vector3::new(number()?, number()?, number()?)))();
                corners.push(corner.ok_or_else(|| format!("line {}: a corner has no three numbers", i + 1))?);
            }
            Some("o" | "g") => ended |= !triangles.is_empty(),
            Some("f") if !ended => {
                face.clear();
                for word in words {
                    let corner = index(word, corners.len()).map(|at| corners[at]);
                    face.push(
                        corner.ok_or_else(|| format!("line {}: '{word}' is no corner before it", i + 1))?,
                    );
                }
                if face.len() < 3 {
                    return Err(format!("line {}: a face has fewer than three corners", i + 1));
                }
                split(&face, &mut triangles);
            }
            _ => {}
        }
    }
    // Points alone stand for their hull.
    if triangles.is_empty() { hull(&corners) } else { Ok(triangles) }
}

/// The corner that `7`, `7/1/2` or `-1` names, from 0.
fn index(word: &str, count: usize) -> Option<usize> {
    let number: i64 = word.split('/').next()?.parse().ok()?;
    let at = if number < 0 { i64::try_from(count).ok()? + number } else { number - 1 };
    usize::try_from(at).ok().filter(|at| *at < count)
}

/// Four corners are split along the shorter diagonal, more from the first.
fn split(face: &[Vector3<f64>], triangles: &mut Vec<Triangle>) {
    if let [a, b, c, d] = *face
        && (d - b).norm_squared() <= (c - a).norm_squared()
    {
        triangles.extend([[a, b, d], [b, c, d]]);
        return;
    }
    triangles.extend(face[1..].windows(2).map(|pair| [face[0], pair[0], pair[1]]));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_counted_from_one_or_from_the_end() {
        let text = "# a square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1 2//2 3 -1\ng more\nf 1 2 3\n";
        let triangles = read(text.as_bytes()).expect("triangles");
        // The second group does not count.
        assert_eq!(triangles.len(), 2);
        assert_eq!(triangles[0][0], Vector3::zeros());
        assert_eq!(read(b"v 0 0 0\nf 1 2 3").expect_err("no corner"), "line 2: '2' is no corner before it");
        assert!(read(b"v 0 0 nan").is_err() && read(b"v 0 0 0\nf 1 1").is_err());
    }
}
