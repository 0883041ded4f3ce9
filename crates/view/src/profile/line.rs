//! A curve as lines of a picture.

use super::axis::Axis;
use solaris_profiles::{Answers, Quantity};

/// How far a line may be from the curve (px).
const DEVIATION: f64 = 0.06;
/// The least jump that is seen (px).
const JUMP: f64 = 0.3;
/// The longest part of a line that is drawn without looking between its ends (px).
const LONGEST: f64 = 40.0;
/// How often a part is halved at most.
const DEPTH: u32 = 8;
/// With more parts than this, only what each column of pixels holds is drawn.
const MOST_PARTS: usize = 200;
/// Width of a column (px).
const COLUMN: f64 = 1.5;
/// Points that are looked at in a pixel.
const IN_COLUMN: usize = 4;

/// A point of the picture (px).
pub(super) type Point = (f64, f64);

/// The part of the picture that shows one of the four curves.
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) duration: f64,
    pub(super) axis: Axis,
}

impl Frame {
    pub(super) fn x(&self, t: f64) -> f64 {
        self.left + if self.duration > 0.0 { self.width * t / self.duration } else { 0.0 }
    }

    /// What is far outside is kept near, and what has no bound too.
    pub(super) fn y(&self, value: f64) -> f64 {
        let share = self.axis.share(value).clamp(-3.0, 4.0);
        self.top + self.height * (1.0 - if share.is_nan() { 0.5 } else { share })
    }
}

/// One of the four curves in its frame.
struct Drawn<'a> {
    curve: &'a dyn Answers,
    quantity: Quantity,
    frame: &'a Frame,
}

impl Drawn<'_> {
    fn after(&self, t: f64) -> Point {
        (self.frame.x(t), self.frame.y(self.quantity.of(&self.curve.at(t))))
    }

    fn before(&self, t: f64) -> Point {
        (self.frame.x(t), self.frame.y(self.quantity.of(&self.curve.before(t))))
    }

    /// Goes on with `line` from one time to another, as finely as it takes.
    fn refine(&self, line: &mut Vec<Point>, from: (f64, Point), to: (f64, Point), depth: u32) {
        let between = |share: f64| from.0 + (to.0 - from.0) * share;
        let off = |share: f64| {
            let chord = from.1.1 + (to.1.1 - from.1.1) * share;
            (self.after(between(share)).1 - chord).abs()
        };
        // Beside the middle too: a curve may wind about its chord.
        if depth == 0 || [0.5, 0.2, 0.8].into_iter().all(|share| off(share) <= DEVIATION) {
            line.push(to.1);
            return;
        }
        let middle = (between(0.5), self.after(between(0.5)));
        self.refine(line, from, middle, depth - 1);
        self.refine(line, middle, to, depth - 1);
    }

    /// The lines between jumps.
    fn lines(&self, times: &[f64]) -> Vec<Vec<Point>> {
        let mut lines: Vec<Vec<Point>> = Vec::new();
        for pair in times.windows(2) {
            let (start, end) = (self.after(pair[0]), self.before(pair[1]));
            let mut line = match lines.pop() {
                Some(line) if line.last().is_some_and(|last| (last.1 - start.1).abs() <= JUMP) => line,
                other => {
                    lines.extend(other);
                    vec![start]
                }
            };
            let count = ((end.0 - start.0) / LONGEST).ceil().max(1.0) as usize;
            let mut from = (pair[0], start);
            for i in 1..=count {
                let t = pair[0] + (pair[1] - pair[0]) * i as f64 / count as f64;
                let to = (t, if i == count { end } else { self.after(t) });
                self.refine(&mut line, from, to, DEPTH);
                from = to;
            }
            lines.push(line);
        }
        lines
    }

    /// One line through the least and the greatest of each column of pixels.
    fn columns(&self, times: &[f64]) -> Vec<Point> {
        let count = self.frame.width.ceil().max(1.0) as usize * IN_COLUMN;
        let even = (0..=count).map(|i| self.frame.duration * i as f64 / count as f64);
        let mut points: Vec<Point> = even.map(|t| self.after(t)).collect();
        points.extend(times.iter().flat_map(|&t| [self.before(t), self.after(t)]));
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut line = Vec::new();
        for column in points.chunk_by(|a, b| ((a.0 / COLUMN).floor() - (b.0 / COLUMN).floor()).abs() < 0.5) {
            let low = column.iter().copied().reduce(|a, b| if b.1 < a.1 { b } else { a });
            let high = column.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a });
            let mut both: Vec<Point> = low.into_iter().chain(high).collect();
            both.sort_by(|a, b| a.0.total_cmp(&b.0));
            line.extend(both);
        }
        line
    }
}

/// The lines of a curve in its frame: one for each part between jumps.
pub(super) fn lines(curve: &dyn Answers, quantity: Quantity, frame: &Frame) -> Vec<Vec<Point>> {
    let drawn = Drawn { curve, quantity, frame };
    let mut times = curve.critical(quantity);
    times.retain(|&t| t > 0.0 && t < frame.duration);
    times.extend([0.0, frame.duration]);
    times.sort_by(f64::total_cmp);
    times.dedup();
    if times.len() > MOST_PARTS { vec![drawn.columns(&times)] } else { drawn.lines(&times) }
}

/// A line as the text of a path, to a hundredth of a pixel.
pub(super) fn path(line: &[Point]) -> String {
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
pub(super) fn short(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
