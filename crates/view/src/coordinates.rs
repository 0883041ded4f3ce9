//! Coordinates of a motion over time, as a picture.

use crate::chart::{Axis, Key, Panel, Picture, SERIES};
use solaris_model::{AxisKind, EventKind, Figure, JointKind, Motion};

/// Height of a panel (px).
const HEIGHT: f64 = 210.0;

/// A coordinate, with how far it goes.
struct Line<'a> {
    name: &'a str,
    coordinate: usize,
    low: f64,
    high: f64,
}

/// The coordinates of `motion` that go farthest, over time: angles (°) in one panel, ways (m) in another, as an SVG.
/// Orientations of ball and free joints are not drawn. Changes of drives are marked.
///
/// The same motion gives the same text, byte for byte.
pub fn coordinates(figure: &Figure, motion: &Motion, title: &str) -> String {
    let mut picture = Picture::new(title);
    let changes = motion.events.iter().filter(|event| matches!(event.kind, EventKind::DriveChange { .. }));
    let changes: Vec<f64> = changes.map(|event| event.time).collect();
    let mut moves = false;
    for (name, unit, kind) in [
        ("angle (°)", 180.0 / std::f64::consts::PI, AxisKind::Rotation),
        ("way (m)", 1.0, AxisKind::Translation),
    ] {
        let (lines, more) = farthest(figure, motion, kind);
        if !lines.is_empty() {
            moves = true;
            panel(&mut picture, name, motion, unit, &lines, more, &changes);
        }
    }
    if !moves {
        picture.remark("No joint with an axis moves.", 1);
    }
    picture.finish()
}

/// Coordinates of one kind; `unit` is how many of what is shown are in a rad or m, `more` how many others move, less far.
fn panel(
    picture: &mut Picture,
    name: &str,
    motion: &Motion,
    unit: f64,
    lines: &[Line<'_>],
    more: usize,
    changes: &[f64],
) {
    picture.heading(name);
    let keys: Vec<Key> =
        lines.iter().enumerate().map(|(series, line)| Key::line(series, line.name)).collect();
    picture.legend(&keys);
    if more > 0 {
        picture.remark(&format!("and {more} more that go less far"), 1);
    }
    let column = |line: &Line<'_>| -> Vec<f64> {
        (0..motion.len()).map(|frame| unit * motion.q(frame)[line.coordinate]).collect()
    };
    let columns: Vec<Vec<f64>> = lines.iter().map(column).collect();
    let time = Axis::around(motion.time().iter().copied(), 8.0);
    let values = Axis::around(columns.iter().flatten().copied(), 5.0).padded(0.06);
    let panel = Panel::below(picture, HEIGHT, time, values);
    panel.grid(picture);
    for change in changes {
        panel.upright(picture, "moment", *change);
    }
    for (series, values) in columns.iter().enumerate() {
        panel.curve(picture, &format!("line s{series}"), motion.time(), values);
    }
    panel.foot(picture, "time (s)");
}

/// The coordinates of a kind that go farthest, in the order of the figure, and how many more move.
fn farthest<'a>(figure: &'a Figure, motion: &Motion, kind: AxisKind) -> (Vec<Line<'a>>, usize) {
    let layout = figure.layout();
    let mut lines: Vec<Line<'a>> = Vec::new();
    for (link, at) in figure.links().iter().zip(layout.joints()) {
        let axes: Vec<usize> = match link.joint().kind() {
            JointKind::Free { .. } if kind == AxisKind::Translation => vec![0, 1, 2],
            other => (0..other.axes().len()).filter(|&i| other.axes()[i].axis.kind == kind).collect(),
        };
        for i in axes {
            let column = (0..motion.len()).map(|frame| motion.q(frame)[at.q + i]);
            let (low, high) =
                column.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
            if high - low > 1e-9 {
                lines.push(Line { name: &layout.q_names()[at.q + i], coordinate: at.q + i, low, high });
            }
        }
    }
    lines.sort_by(|a, b| (b.high - b.low).total_cmp(&(a.high - a.low)));
    let more = lines.len().saturating_sub(SERIES);
    lines.truncate(SERIES);
    lines.sort_by_key(|line| line.coordinate);
    (lines, more)
}
