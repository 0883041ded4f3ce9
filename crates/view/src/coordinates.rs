//! Coordinates of a motion over time, as a picture.

use crate::over_time::{BELOW, COLORS, Curve, LEFT, PANEL, TOP, begin, panel};
use solaris_model::{AxisKind, EventKind, Figure, JointKind, Motion};
use std::fmt::Write as _;

/// The most lines of a panel.
const MOST_LINES: usize = 6;

/// A coordinate, with how far it goes.
struct Line<'a> {
    name: &'a str,
    coordinate: usize,
    low: f64,
    high: f64,
}

/// Coordinates of one kind.
struct Panel<'a> {
    /// What the axis says.
    name: &'static str,
    /// How many of what is shown there are in a rad or m.
    unit: f64,
    lines: Vec<Line<'a>>,
    /// How many others move, less far.
    more: usize,
}

impl Panel<'_> {
    fn curves<'a>(&'a self, motion: &'a Motion) -> Vec<Curve<'a>> {
        let curve = |(line, color): (&'a Line<'_>, &'static str)| {
            let column = (0..motion.len()).map(|frame| self.unit * motion.q(frame)[line.coordinate]);
            Curve { name: line.name, time: motion.time(), values: column.collect(), color, thin: false }
        };
        self.lines.iter().zip(COLORS).map(curve).collect()
    }
}

/// The coordinates of `motion` that go farthest, over time: angles (°) in one panel, ways (m) in another, as an SVG.
/// Orientations of ball and free joints are not drawn. Changes of drives are marked.
///
/// The same motion gives the same text, byte for byte.
pub fn coordinates(figure: &Figure, motion: &Motion, title: &str) -> String {
    let panels = [
        ("angle (°)", 180.0 / std::f64::consts::PI, AxisKind::Rotation),
        ("way (m)", 1.0, AxisKind::Translation),
    ]
    .map(|(name, unit, kind)| {
        let (lines, more) = farthest(figure, motion, kind);
        Panel { name, unit, lines, more }
    });
    let panels: Vec<Panel<'_>> = panels.into_iter().filter(|panel| !panel.lines.is_empty()).collect();
    let mut svg = begin(title, panels.len().max(1));
    let changes = motion.events.iter().filter(|event| matches!(event.kind, EventKind::DriveChange { .. }));
    let changes: Vec<f64> = changes.map(|event| event.time).collect();
    for (index, shown) in panels.iter().enumerate() {
        let top = TOP + index as f64 * (PANEL.1 + BELOW);
        let _ = writeln!(svg, "<g transform=\"translate({LEFT} {top})\">");
        panel(&mut svg, shown.name, &shown.curves(motion), &changes);
        if shown.more > 0 {
            let (x, y) = (PANEL.0 + 8.0, 18.0 + 16.0 * shown.lines.len() as f64);
            let _ =
                writeln!(svg, "<text x=\"{x}\" y=\"{y}\" fill=\"#555\">and {} more that</text>", shown.more);
            let _ = writeln!(svg, "<text x=\"{x}\" y=\"{}\" fill=\"#555\">go less far</text>", y + 14.0);
        }
        svg.push_str("</g>\n");
    }
    if panels.is_empty() {
        svg.push_str("<text x=\"16\" y=\"60\">No joint with an axis moves.</text>\n");
    }
    svg.push_str("</svg>\n");
    svg
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
    let more = lines.len().saturating_sub(MOST_LINES);
    lines.truncate(MOST_LINES);
    lines.sort_by_key(|line| line.coordinate);
    (lines, more)
}
