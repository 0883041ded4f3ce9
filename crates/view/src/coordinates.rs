//! Coordinates of a motion over time, as a picture.

use crate::html::escape;
use crate::profile::axis::Axis;
use crate::profile::text::cut;
use solaris_model::{AxisKind, EventKind, Figure, JointKind, Motion};
use std::fmt::Write as _;

/// The most lines of a panel.
const MOST_LINES: usize = 6;
/// Width of the picture, and size of a panel (px).
const WIDTH: f64 = 720.0;
const PANEL: (f64, f64) = (560.0, 220.0);
const LEFT: f64 = 64.0;
const TOP: f64 = 44.0;
/// What is below a panel (px).
const BELOW: f64 = 46.0;
/// The most points of a line: more than there are pixels do not show.
const MOST_POINTS: usize = 1200;
/// Colours that people with any kind of colour vision tell apart (M. Okabe, K. Ito).
const COLORS: [&str; MOST_LINES] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

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
    let height = TOP + (panels.len().max(1) as f64) * (PANEL.1 + BELOW);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" \
         font-family=\"Helvetica,Arial,sans-serif\" font-size=\"11\" fill=\"#222\">\n<title>{0}</title>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fff\"/>\n\
         <text x=\"16\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{0}</text>\n",
        escape(&cut(title, 15.0, WIDTH - 32.0))
    );
    for (index, shown) in panels.iter().enumerate() {
        let top = TOP + index as f64 * (PANEL.1 + BELOW);
        let _ = writeln!(svg, "<g transform=\"translate({LEFT} {top})\">");
        panel(&mut svg, motion, shown);
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

fn panel(svg: &mut String, motion: &Motion, shown: &Panel<'_>) {
    let Panel { name, unit, lines, .. } = shown;
    let (first, last) = (motion.time()[0], motion.time()[motion.len() - 1]);
    let low = lines.iter().fold(f64::INFINITY, |low, line| low.min(line.low * unit));
    let high = lines.iter().fold(f64::NEG_INFINITY, |high, line| high.max(line.high * unit));
    let (time, value) = (Axis::new(first, last, 8.0), Axis::new(low, high, 5.0).padded(0.06));
    let x = |t: f64| PANEL.0 * time.share(t);
    let y = |v: f64| PANEL.1 * (1.0 - value.share(v));
    for (tick, label) in time.ticks() {
        let at = x(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M{at:.1} 0V{}\" stroke=\"#e2e2e2\"/><text x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            PANEL.1,
            PANEL.1 + 15.0
        );
    }
    for (tick, label) in value.ticks() {
        let at = y(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M0 {at:.1}H{}\" stroke=\"#e2e2e2\"/><text x=\"-6\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
            PANEL.0,
            at + 4.0
        );
    }
    let changes = motion.events.iter().filter(|event| matches!(event.kind, EventKind::DriveChange { .. }));
    for event in changes {
        let at = x(event.time);
        let _ =
            writeln!(svg, "<path d=\"M{at:.1} 0V{}\" stroke=\"#999\" stroke-dasharray=\"2 3\"/>", PANEL.1);
    }
    let _ = writeln!(
        svg,
        "<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#999\"/>\
         <text transform=\"translate(-46 {}) rotate(-90)\" text-anchor=\"middle\">{name}</text>\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">time (s)</text>",
        PANEL.0,
        PANEL.1,
        0.5 * PANEL.1,
        0.5 * PANEL.0,
        PANEL.1 + 31.0
    );
    let stride = motion.len().div_ceil(MOST_POINTS);
    for (index, line) in lines.iter().enumerate() {
        let frames = (0..motion.len())
            .step_by(stride)
            .chain((motion.len() % stride != 1 % stride).then_some(motion.len() - 1));
        let mut path = String::new();
        for frame in frames {
            let (x, y) = (x(motion.time()[frame]), y(unit * motion.q(frame)[line.coordinate]));
            let _ = write!(path, "{}{x:.1} {y:.1}", if path.is_empty() { 'M' } else { 'L' });
        }
        let (color, at) = (COLORS[index], 14.0 + 16.0 * index as f64);
        let _ = writeln!(
            svg,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"/>\
             <path d=\"M{0} {1}h14\" stroke=\"{color}\" stroke-width=\"3\"/><text x=\"{2}\" y=\"{at}\">{3}</text>",
            PANEL.0 + 8.0,
            at - 4.0,
            PANEL.0 + 26.0,
            escape(&cut(line.name, 11.0, WIDTH - LEFT - PANEL.0 - 30.0))
        );
    }
}
