//! A map of two parameters: where all inequalities hold, and which forbids what lies beyond.

use crate::html::escape;
use crate::over_time::COLORS;
use crate::profile::axis::Axis;
use crate::profile::text::cut;
use std::fmt::Write as _;

/// What a map of two parameters shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Regions<'a> {
    /// What is across and up, with unit and symbol: `heel-strike-angle θ (°)`.
    pub axes: [String; 2],
    /// What is shown of them: least and greatest.
    pub spans: [(f64, f64); 2],
    /// Number of places across and up.
    pub places: [usize; 2],
    /// The inequalities: `(i) χ < α`.
    pub conditions: Vec<String>,
    /// By place, row by row from below: which inequality fails, or none.
    pub fails: &'a [Option<usize>],
    /// Pieces of the boundary, and which inequality fails beyond.
    pub edges: Vec<([[f64; 2]; 2], usize)>,
    /// A point to be marked, as the parameters in question.
    pub mark: Option<[f64; 2]>,
}

/// Place of the map in the picture, and its size (px).
const AT: (f64, f64) = (74.0, 48.0);
const SIZE: (f64, f64) = (520.0, 400.0);

/// The map as an SVG: white where all holds, elsewhere the colour of the inequality that fails first; the boundary's colours
/// are those of what fails beyond it.
///
/// The same map gives the same text, byte for byte.
pub fn regions(map: &Regions<'_>, title: &str) -> String {
    let legend = map.conditions.iter().map(|text| text.chars().count()).max().unwrap_or(0) as f64;
    let width = AT.0 + SIZE.0 + 40.0 + (6.6 * legend).max(110.0);
    let height = (AT.1 + SIZE.1 + 48.0).max(AT.1 + 20.0 * (map.conditions.len() as f64 + 3.0));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" height=\"{height:.0}\" \
         font-family=\"Helvetica,Arial,sans-serif\" font-size=\"12\" fill=\"#222\">\n<title>{0}</title>\n\
         <rect width=\"{width:.0}\" height=\"{height:.0}\" fill=\"#fff\"/>\n\
         <text x=\"16\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{0}</text>\n<g transform=\"translate({1} {2})\">\n",
        escape(&cut(title, 15.0, width - 32.0)),
        AT.0,
        AT.1
    );
    areas(&mut svg, map);
    let axes = map.spans.map(|(lower, upper)| Axis::new(lower, upper, 7.0));
    let share =
        |axis: usize, value: f64| (value - map.spans[axis].0) / (map.spans[axis].1 - map.spans[axis].0);
    let x = |value: f64| SIZE.0 * share(0, value);
    let y = |value: f64| SIZE.1 * (1.0 - share(1, value));
    for (condition, color) in (0..map.conditions.len()).map(|i| (i, COLORS[i % COLORS.len()])) {
        let mut path = String::new();
        for (ends, _) in map.edges.iter().filter(|(_, fails)| *fails == condition) {
            let [a, b] = ends;
            let _ = write!(path, "M{:.2} {:.2}L{:.2} {:.2}", x(a[0]), y(a[1]), x(b[0]), y(b[1]));
        }
        if !path.is_empty() {
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2.5\" stroke-linecap=\"round\"/>"
            );
        }
    }
    for (tick, label) in axes[0].ticks() {
        let at = x(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M{at:.1} {0}v5\" stroke=\"#666\"/><text x=\"{at:.1}\" y=\"{1}\" text-anchor=\"middle\">{label}</text>",
            SIZE.1,
            SIZE.1 + 18.0
        );
    }
    for (tick, label) in axes[1].ticks() {
        let at = y(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M0 {at:.1}h-5\" stroke=\"#666\"/><text x=\"-8\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
            at + 4.0
        );
    }
    if let Some(mark) = map.mark {
        let _ = writeln!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"4.5\" fill=\"#222\" stroke=\"#fff\" stroke-width=\"1.5\"/>",
            x(mark[0]),
            y(mark[1])
        );
    }
    let _ = writeln!(
        svg,
        "<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#666\"/>\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\
         <text transform=\"translate(-52 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
        SIZE.0,
        SIZE.1,
        0.5 * SIZE.0,
        SIZE.1 + 38.0,
        escape(&map.axes[0]),
        0.5 * SIZE.1,
        escape(&map.axes[1])
    );
    key(&mut svg, map);
    svg.push_str("</g>\n</svg>\n");
    svg
}

/// The places where something fails, runs of a row as one rectangle.
fn areas(svg: &mut String, map: &Regions<'_>) {
    let [columns, rows] = map.places;
    let (w, h) = (SIZE.0 / (columns.max(2) - 1) as f64, SIZE.1 / (rows.max(2) - 1) as f64);
    let _ = writeln!(
        svg,
        "<clipPath id=\"map\"><rect width=\"{0}\" height=\"{1}\"/></clipPath><g clip-path=\"url(#map)\" fill-opacity=\"0.22\" shape-rendering=\"crispEdges\">",
        SIZE.0, SIZE.1
    );
    for (row, places) in map.fails.chunks(columns.max(1)).enumerate() {
        let mut from = 0;
        for run in places.chunk_by(|a, b| a == b) {
            if let Some(condition) = run[0] {
                let (x, y) = ((from as f64 - 0.5) * w, SIZE.1 - (row as f64 + 0.5) * h);
                let _ = writeln!(
                    svg,
                    "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{:.2}\" height=\"{h:.2}\" fill=\"{}\"/>",
                    run.len() as f64 * w,
                    COLORS[condition % COLORS.len()]
                );
            }
            from += run.len();
        }
    }
    svg.push_str("</g>\n");
}

fn key(svg: &mut String, map: &Regions<'_>) {
    let x = SIZE.0 + 16.0;
    let _ = writeln!(
        svg,
        "<rect x=\"{x}\" y=\"0\" width=\"12\" height=\"12\" fill=\"#fff\" stroke=\"#666\"/><text x=\"{}\" y=\"10\">all hold</text>",
        x + 18.0
    );
    for (index, text) in map.conditions.iter().enumerate() {
        let y = 20.0 * (index as f64 + 1.0);
        let color = COLORS[index % COLORS.len()];
        let _ = writeln!(
            svg,
            "<rect x=\"{x}\" y=\"{y}\" width=\"12\" height=\"12\" fill=\"{color}\" fill-opacity=\"0.22\" stroke=\"{color}\" stroke-width=\"2\"/><text x=\"{}\" y=\"{}\">fails: {}</text>",
            x + 18.0,
            y + 10.0,
            escape(text)
        );
    }
}
