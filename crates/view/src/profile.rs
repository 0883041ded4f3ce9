//! The picture of one motion curve: an SVG for print and screen, and a page with its answers.

mod answers;
mod line;
mod page;
mod panel;

pub use crate::chart::number;
pub use page::page;

use crate::TableRow;
use crate::chart::{Axis, Panel, Picture, superscript};
use panel::{Asked, draw};
use solaris_profiles::{Answers, Quantity};

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

/// Height of a panel, and of what is over it (px).
const PANEL: (f64, f64) = (108.0, 27.0);

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
    picture(curve, labels).0.finish()
}

/// What the answers of a curve come to, in rows that are ready to be read.
pub fn answers(curve: &dyn Answers, labels: &Labels) -> Vec<TableRow> {
    answers::rows(curve, labels)
}

/// The unit of the derivative of this order: "rad/s²"; nothing where positions have none.
pub fn unit(unit: &str, order: usize) -> String {
    let unit = unit.trim();
    match order {
        _ if unit.is_empty() => String::new(),
        0 => unit.to_owned(),
        1 => format!("{unit}/s"),
        _ => format!("{unit}/s{}", superscript(&order.to_string())),
    }
}

/// The picture, and its panels.
fn picture(curve: &dyn Answers, labels: &Labels) -> (Picture, Vec<Panel>) {
    let asked = Asked::of(curve, labels);
    let mut picture = Picture::new(&labels.title);
    picture.remark(&labels.parameters, 3);
    let axes: Vec<Axis> = (0..ORDER.len()).map(|order| asked.axis(order)).collect();
    let left = Panel::left_of(&axes);
    let time = Axis::linear(0.0, curve.duration(), 8.0);
    let panels = axes.into_iter().map(|axis| {
        picture.take(PANEL.1);
        Panel::from_left(&mut picture, left, PANEL.0, time.clone(), axis)
    });
    let panels: Vec<Panel> = panels.collect();
    for (order, panel) in panels.iter().enumerate() {
        draw(&mut picture, &asked, order, panel);
    }
    if let Some(last) = panels.last() {
        last.foot(&mut picture, &format!("time ({})", time.unit("s")));
    }
    (picture, panels)
}
