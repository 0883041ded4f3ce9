//! Lines with no more points than are seen.

use super::Point;

/// Points in a column of pixels from which on only the least and the greatest are kept, and its width (px).
const IN_COLUMN: f64 = 8.0;
const COLUMN: f64 = 1.5;

/// The points of a line that are needed to have it nowhere farther away than `deviation` (px).
///
/// What has more than a few points in every pixel (rising x) is thinned to the least and the greatest of each column before.
/// After D. H. Douglas and T. K. Peucker (1973).
pub fn simplified(points: &[Point], deviation: f64) -> Vec<Point> {
    let columns = columns(points);
    let points = columns.as_deref().unwrap_or(points);
    let mut kept = vec![false; points.len()];
    let mut parts = Vec::new();
    if let Some(last) = points.len().checked_sub(1) {
        (kept[0], kept[last]) = (true, true);
        parts.push((0, last));
    }
    while let Some((first, last)) = parts.pop() {
        let far = |i: usize| distance(points[i], points[first], points[last]);
        let farthest = (first + 1..last).max_by(|a, b| far(*a).total_cmp(&far(*b)));
        if let Some(farthest) = farthest.filter(|i| far(*i) > deviation) {
            kept[farthest] = true;
            parts.extend([(first, farthest), (farthest, last)]);
        }
    }
    points.iter().zip(kept).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

/// The least and the greatest of each column, in their order; nothing where there are few points anyway.
fn columns(points: &[Point]) -> Option<Vec<Point>> {
    let span = points.last()?.0 - points.first()?.0;
    if points.len() as f64 <= IN_COLUMN * (span / COLUMN).max(1.0) {
        return None;
    }
    let same = |a: &Point, b: &Point| (a.0 / COLUMN).floor() >= (b.0 / COLUMN).floor();
    let ends = points.chunk_by(same).flat_map(|column| {
        let by_height = |a: &&Point, b: &&Point| a.1.total_cmp(&b.1);
        let mut both: Vec<Point> = column
            .iter()
            .min_by(by_height)
            .into_iter()
            .chain(column.iter().max_by(by_height))
            .copied()
            .collect();
        both.sort_by(|a, b| a.0.total_cmp(&b.0));
        both
    });
    Some(ends.collect())
}

/// How far a point is from the line between two others.
fn distance(point: Point, from: Point, to: Point) -> f64 {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let length = x.hypot(y);
    let (u, v) = (point.0 - from.0, point.1 - from.1);
    if length > 0.0 {
        // Beside the line, or before and behind it: a line may turn back.
        let along = ((u * x + v * y) / length).clamp(0.0, length) / length;
        (u - along * x).hypot(v - along * y)
    } else {
        u.hypot(v)
    }
}

/// A line as the text of a path, to a hundredth of a pixel.
pub fn path(line: &[Point]) -> String {
    let mut path = String::new();
    let mut last = String::new();
    for (x, y) in line {
        let point = format!("{} {}", short(*x), short(*y));
        if point != last {
            path.push(if path.is_empty() { 'M' } else { 'L' });
            path.push_str(&point);
        }
        last = point;
    }
    path
}

/// A length to a hundredth.
pub(crate) fn short(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_has_two_points_and_a_corner_three() {
        let straight: Vec<Point> = (0..50).map(|i| (f64::from(i), 3.0 * f64::from(i))).collect();
        assert_eq!(simplified(&straight, 0.1), [straight[0], straight[49]]);
        let corner: Vec<Point> = (0..50).map(|i| (f64::from(i), (f64::from(i) - 20.0).abs())).collect();
        assert_eq!(simplified(&corner, 0.1), [corner[0], corner[20], corner[49]]);
        assert!(simplified(&[], 0.1).is_empty());
    }

    /// A single sample of many that stands out is drawn.
    #[test]
    fn peaks_stay() {
        let mut points: Vec<Point> = (0..100_000).map(|i| (0.005 * f64::from(i), 10.0)).collect();
        points[77_777].1 = 90.0;
        let kept = simplified(&points, 0.1);
        assert!(kept.len() < 10 && kept.contains(&points[77_777]), "{kept:?}");
    }
}
