//! A map of two parameters: where all inequalities hold, and which forbids what lies beyond.

use crate::chart::{Axis, Key, Panel, Picture, SERIES, path, short};
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

/// Height of the map (px).
const HEIGHT: f64 = 400.0;

/// The map as an SVG: white where all holds, elsewhere the colour of the inequality that fails first; the boundary's colours
/// are those of what fails beyond it.
///
/// The same map gives the same text, byte for byte.
pub fn regions(map: &Regions<'_>, title: &str) -> String {
    let mut picture = Picture::new(title);
    let mut keys = vec![Key::area("open", "all hold")];
    for (condition, text) in map.conditions.iter().enumerate() {
        let series = condition % SERIES;
        keys.push(Key::area(format!("area f{series} s{series}"), format!("fails: {text}")));
    }
    picture.legend(&keys);
    picture.heading(&map.axes[1]);
    let [across, up] = map.spans.map(|(lower, upper)| Axis::linear(lower, upper, 7.0));
    let panel = Panel::below(&mut picture, HEIGHT, across, up);
    panel.clipped(&mut picture, |picture| areas(picture, map, &panel));
    panel.grid(&mut picture);
    panel.clipped(&mut picture, |picture| boundary(picture, map, &panel));
    if let Some([across, up]) = map.mark {
        picture.circle("ink", (panel.x(across), panel.y(up)), 5.0);
    }
    panel.foot(&mut picture, &map.axes[0]);
    picture.finish()
}

/// The places where something fails, runs of a row as one rectangle.
fn areas(picture: &mut Picture, map: &Regions<'_>, panel: &Panel) {
    let [columns, rows] = map.places;
    let (w, h) = (panel.width / (columns.max(2) - 1) as f64, panel.height / (rows.max(2) - 1) as f64);
    let mut paths = vec![String::new(); SERIES];
    for (row, places) in map.fails.chunks(columns.max(1)).enumerate() {
        let mut from = 0;
        for run in places.chunk_by(|a, b| a == b) {
            if let Some(condition) = run[0] {
                let (x, y) = (panel.left + (from as f64 - 0.5) * w, panel.bottom() - (row as f64 + 0.5) * h);
                let [x, y, width, height] = [x, y, run.len() as f64 * w, h].map(short);
                // Writing to a string cannot fail.
                let _ = write!(paths[condition % SERIES], "M{x} {y}h{width}v{height}h-{width}z");
            }
            from += run.len();
        }
    }
    // One path for each colour: no seams between its rows.
    for (series, path) in paths.iter().enumerate() {
        picture.path(&format!("area f{series}"), path);
    }
}

/// The pieces of the boundary, by what fails beyond.
fn boundary(picture: &mut Picture, map: &Regions<'_>, panel: &Panel) {
    for condition in 0..map.conditions.len() {
        let mut pieces = String::new();
        for (ends, _) in map.edges.iter().filter(|(_, fails)| *fails == condition) {
            pieces += &path(&ends.map(|[across, up]| (panel.x(across), panel.y(up))));
        }
        picture.path(&format!("line s{}", condition % SERIES), &pieces);
    }
}
