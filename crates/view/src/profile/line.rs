//! A curve as lines of a picture.

use super::ORDER;
use crate::chart::{Panel, Point, simplified};
use solaris_profiles::Answers;

/// How far a line may be from the curve (px).
const DEVIATION: f64 = 0.06;
/// The least jump that is seen (px).
const JUMP: f64 = 0.3;
/// Points that are looked at in a pixel.
const IN_PIXEL: f64 = 4.0;
/// With more parts than this, jumps are too close to be seen.
const MOST_PARTS: usize = 200;

/// The lines of one of the four curves in its panel: one for each part between jumps.
pub(super) fn lines(curve: &dyn Answers, order: usize, panel: &Panel) -> Vec<Vec<Point>> {
    let (quantity, duration) = (ORDER[order].1, curve.duration());
    let mut times = curve.critical(quantity);
    times.retain(|&t| t > 0.0 && t < duration);
    times.extend([0.0, duration]);
    times.sort_by(f64::total_cmp);
    times.dedup();
    let jump = if times.len() > MOST_PARTS { f64::INFINITY } else { JUMP };
    let mut lines: Vec<Vec<Point>> = Vec::new();
    for pair in times.windows(2) {
        let [x, end] = [pair[0], pair[1]].map(|t| panel.x(t));
        let count = (IN_PIXEL * (end - x)).ceil().max(1.0);
        let point = |i: usize| {
            let t = pair[0] + (pair[1] - pair[0]) * i as f64 / count;
            // A critical time belongs to what comes after it, and ends what was before.
            let sample = if i < count as usize { curve.at(t) } else { curve.before(pair[1]) };
            (panel.x(t), panel.y(quantity.of(&sample)))
        };
        let part = (0..=count as usize).map(point);
        match lines.last_mut() {
            Some(line) if line.last().is_some_and(|last| (last.1 - point(0).1).abs() <= jump) => {
                line.extend(part);
            }
            _ => lines.push(part.collect()),
        }
    }
    lines.iter().map(|line| simplified(line, DEVIATION)).collect()
}
