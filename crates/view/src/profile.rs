//! The picture of one motion curve: an SVG for print and screen, and a page with its answers.
//!
//! Own SVG text and no plotting crate: it takes a few hundred lines, keeps texts apart from each other, and gives the same
//! bytes for the same curve.

mod answers;
pub(crate) mod axis;
mod line;
mod page;
mod panel;
pub(crate) mod text;

pub use page::page;
pub use text::{number, unit};

use crate::TableRow;
use crate::html::escape;
use axis::Axis;
use line::{Frame, short};
use panel::{Asked, SIZE, panel};
use solaris_profiles::{Answers, Quantity};
use std::fmt::Write as _;

/// What stands beside the curves; plain text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Labels {
    /// The first line.
    pub title: String,
    /// The line below it: the parameters.
    pub parameters: String,
    /// Unit of positions; may be empty. Only a label.
    pub unit: String,
    /// Keys that the curve goes through: times and positions, the first at the curve's beginning.
    pub keys: Vec<(f64, f64)>,
    /// Further rows of the table of answers.
    pub rows: Vec<TableRow>,
}

/// The four curves in their order.
const ORDER: [(&str, Quantity); 4] = [
    ("position", Quantity::Position),
    ("velocity", Quantity::Velocity),
    ("acceleration", Quantity::Acceleration),
    ("jerk", Quantity::Jerk),
];

/// Width of the picture (px).
const WIDTH: f64 = 640.0;
/// Height of a panel, and of what is over it (px).
const PANEL: (f64, f64) = (108.0, 25.0);
/// What is left free at the sides (px).
const MARGIN: f64 = 16.0;

const STYLE: &str = include_str!("../assets/profile.svg.css");

/// The picture of a curve: position, velocity, acceleration and jerk over one time axis, as the text of an SVG file.
///
/// Marked are where the motion turns round (dot), touches standstill (ring) and rests (band), the greatest magnitudes
/// (triangles) and the keys (squares). A quantity that grows without bound is cut off, and said to. The same curve and
/// labels give the same text, byte for byte.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Boundary, Quintic};
/// use solaris_view::profile::{Labels, svg};
///
/// let curve = Quintic::new(2.0, Boundary::rest(0.0), Boundary::rest(1.2))?;
/// let labels = Labels { title: "minimum jerk".to_owned(), unit: "rad".to_owned(), ..Labels::default() };
/// assert!(svg(&curve, &labels).starts_with("<svg "));
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
pub fn svg(curve: &dyn Answers, labels: &Labels) -> String {
    let title = format!("<title>{}</title>\n", escape(&labels.title));
    picture(curve, labels, &title).0
}

/// What the answers of a curve come to, in rows that are ready to be read.
pub fn answers(curve: &dyn Answers, labels: &Labels) -> Vec<TableRow> {
    answers::rows(curve, labels)
}

/// The picture, and the frames of its panels.
fn picture(curve: &dyn Answers, labels: &Labels, title: &str) -> (String, Vec<Frame>) {
    let asked = Asked::of(curve, labels);
    let duration = curve.duration();
    let wide = WIDTH - 2.0 * MARGIN;
    let parameters = text::lines(&labels.parameters, SIZE, wide, 3);
    let heads = 30.0 + 15.0 * parameters.len() as f64;

    let axes: Vec<Axis> = (0..ORDER.len()).map(|order| asked.axis(order)).collect();
    let widest = axes.iter().flat_map(Axis::ticks).map(|(_, label)| text::width(&label, SIZE));
    let left = (widest.fold(20.0, f64::max) + 12.0).min(0.4 * WIDTH);
    let mut top = heads;
    let frames: Vec<Frame> = axes
        .into_iter()
        .map(|axis| {
            top += PANEL.1;
            let frame = Frame { left, top, width: WIDTH - MARGIN - left, height: PANEL.0, duration, axis };
            top += PANEL.0;
            frame
        })
        .collect();
    let time = Axis::new(0.0, duration, 8.0);
    let times = if duration > 0.0 { time.ticks() } else { vec![(0.0, "0".to_owned())] };
    let height = top + 42.0;

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"solaris-profile\" viewBox=\"0 0 {WIDTH} {height}\" \
         width=\"{WIDTH}\" height=\"{height}\" role=\"img\" aria-label=\"{}\">\n{title}<style>{}</style>\n\
         <rect class=\"paper\" width=\"{WIDTH}\" height=\"{height}\"/>\n<text class=\"title\" x=\"{MARGIN}\" y=\"24\">{}</text>\n",
        escape(&labels.title),
        STYLE.trim_end(),
        escape(&text::cut(&labels.title, 16.0, wide)),
    );
    // Writing to a string cannot fail.
    for (i, line) in parameters.iter().enumerate() {
        let y = 42.0 + 15.0 * i as f64;
        let _ = writeln!(svg, "<text class=\"soft\" x=\"{MARGIN}\" y=\"{y}\">{}</text>", escape(line));
    }
    for (order, frame) in frames.iter().enumerate() {
        svg.push_str(&panel(&asked, order, frame, &times));
    }
    if let Some(frame) = frames.last() {
        svg.push_str("<g class=\"times\">");
        for (t, label) in &times {
            let (x, y) = (short(frame.x(*t)), short(top + 15.0));
            let _ = write!(svg, "<text class=\"middle\" x=\"{x}\" y=\"{y}\">{label}</text>");
        }
        let (x, y) = (short(frame.left + 0.5 * frame.width), short(top + 33.0));
        let _ =
            writeln!(svg, "<text class=\"middle\" x=\"{x}\" y=\"{y}\">time ({})</text></g>", time.unit("s"));
    }
    svg.push_str("</svg>\n");
    (svg, frames)
}
