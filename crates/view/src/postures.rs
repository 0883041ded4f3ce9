//! Postures side by side as stick figures, with their angles, and how much room the inequalities leave.

use crate::html::escape;
use crate::over_time::COLORS;
use crate::profile::text::cut;
use std::fmt::Write as _;

/// A stick figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stick {
    /// What the posture is called.
    pub name: String,
    /// Its lines.
    pub lines: Vec<StickLine>,
    /// Its angles, by symbol: `("α", "17.1°")`.
    pub angles: Vec<(String, String)>,
}

/// A line of a stick figure.
#[derive(Clone, Debug, PartialEq)]
pub struct StickLine {
    /// Which part of the body it is.
    pub part: StickPart,
    /// Forward and up (m).
    pub points: Vec<[f64; 2]>,
}

/// Part of a stick figure: what its line looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StickPart {
    /// The leg that stands.
    Stance,
    /// The leg that swings.
    Swing,
    /// Trunk and neck.
    Trunk,
    /// The arm of the side that stands.
    StanceArm,
    /// The arm of the side that swings.
    SwingArm,
    /// The head: its middle, and a point of its outline.
    Head,
}

/// An inequality and its room.
#[derive(Clone, Debug, PartialEq)]
pub struct Room {
    /// What it says: `(i) χ < α`.
    pub text: String,
    /// The lesser and the greater side: `15.89° < 17.08°`.
    pub sides: String,
    /// Room: `1.18°`.
    pub room: String,
    /// The room against the greatest that is drawn, 0 to 1; less than nothing fails.
    pub share: f64,
}

/// Height of the stick figures, and of the space for their names above (px).
const FIGURE: (f64, f64) = (330.0, 66.0);
/// Width of a panel's margin on either side (px).
const MARGIN: f64 = 14.0;
/// Height of a line of text (px).
const LINE: f64 = 17.0;
/// Least width of a panel (px).
const NARROWEST: f64 = 172.0;

/// Stick figures side by side on one ground and in one scale, their angles below, then the inequalities with bars, as an SVG.
///
/// The same postures give the same text, byte for byte.
pub fn postures(sticks: &[Stick], rooms: &[Room], title: &str) -> String {
    let points = || sticks.iter().flat_map(|stick| stick.lines.iter().flat_map(|line| &line.points));
    let top = points().map(|point| point[1]).fold(1e-3, f64::max);
    let scale = FIGURE.0 / (1.06 * top);
    let spans: Vec<(f64, f64)> = sticks.iter().map(span).collect();
    let widths: Vec<f64> =
        spans.iter().map(|(a, b)| ((b - a) * scale + 2.0 * MARGIN).max(NARROWEST)).collect();
    let columns = Columns::of(rooms);
    let width = (widths.iter().sum::<f64>() + 2.0 * MARGIN).max(560.0).max(columns.end);
    let angles = sticks.iter().map(|stick| stick.angles.len()).max().unwrap_or(0) as f64;
    let floor = FIGURE.1 + FIGURE.0;
    let bars = floor + 26.0 + LINE * angles + 16.0;
    let rows = if rooms.is_empty() { 0.0 } else { LINE * (rooms.len() as f64 + 1.0) + 12.0 };
    let height = bars + rows;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" height=\"{height:.0}\" \
         font-family=\"Helvetica,Arial,sans-serif\" font-size=\"12\" fill=\"#222\">\n<title>{0}</title>\n\
         <rect width=\"{width:.0}\" height=\"{height:.0}\" fill=\"#fff\"/>\n\
         <text x=\"16\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{0}</text>\n\
         <path d=\"M{MARGIN} {floor}H{1:.1}\" stroke=\"#999\" stroke-width=\"1.5\"/>\n",
        escape(&cut(title, 15.0, width - 32.0)),
        width - MARGIN
    );
    let mut left = MARGIN;
    for ((stick, span), panel) in sticks.iter().zip(&spans).zip(&widths) {
        let middle = left + 0.5 * panel;
        let at = |point: &[f64; 2]| {
            [middle + (point[0] - 0.5 * (span.0 + span.1)) * scale, floor - point[1] * scale]
        };
        let _ = writeln!(
            svg,
            "<text x=\"{middle:.1}\" y=\"50\" text-anchor=\"middle\" font-weight=\"bold\">{}</text>",
            escape(&cut(&stick.name, 12.0, panel - 4.0))
        );
        stick.lines.iter().for_each(|line| draw(&mut svg, line, &at));
        for (row, (symbol, value)) in stick.angles.iter().enumerate() {
            let y = floor + 26.0 + LINE * row as f64;
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"{y:.1}\" text-anchor=\"end\" font-style=\"italic\">{}</text><text x=\"{:.1}\" y=\"{y:.1}\">{}</text>",
                middle - 6.0,
                escape(symbol),
                middle + 2.0,
                escape(value)
            );
        }
        left += panel;
    }
    if !rooms.is_empty() {
        list(&mut svg, rooms, bars, &columns);
    }
    svg.push_str("</svg>\n");
    svg
}

/// How far a stick figure reaches backward and forward.
fn span(stick: &Stick) -> (f64, f64) {
    let along = stick.lines.iter().flat_map(|line| line.points.iter().map(|point| point[0]));
    let (least, most) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    if least <= most { (least, most) } else { (0.0, 0.0) }
}

fn draw(svg: &mut String, line: &StickLine, at: &dyn Fn(&[f64; 2]) -> [f64; 2]) {
    let (color, width) = match line.part {
        StickPart::Stance => (COLORS[0], 4.0),
        StickPart::Swing => (COLORS[1], 4.0),
        StickPart::Trunk => ("#444", 4.0),
        StickPart::StanceArm => (COLORS[0], 2.5),
        StickPart::SwingArm => (COLORS[1], 2.5),
        StickPart::Head => ("#444", 2.5),
    };
    let points: Vec<[f64; 2]> = line.points.iter().map(at).collect();
    if let (StickPart::Head, [middle, edge]) = (line.part, &points[..]) {
        let radius = (middle[0] - edge[0]).hypot(middle[1] - edge[1]);
        let _ = writeln!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"{radius:.1}\" fill=\"#fff\" stroke=\"{color}\" stroke-width=\"{width}\"/>",
            middle[0], middle[1]
        );
        return;
    }
    let mut path = String::new();
    for [x, y] in &points {
        let _ = write!(path, "{}{x:.1} {y:.1}", if path.is_empty() { 'M' } else { 'L' });
    }
    let _ = writeln!(
        svg,
        "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>"
    );
    if matches!(line.part, StickPart::Stance | StickPart::Swing) {
        for [x, y] in points.iter().take(points.len().saturating_sub(1)) {
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\" fill=\"#fff\" stroke=\"{color}\" stroke-width=\"2\"/>"
            );
        }
    }
}

/// Where the columns of the inequalities are (px).
struct Columns {
    sides: f64,
    bar: f64,
    end: f64,
}

/// Greatest length of a bar, and the space for the room behind it (px).
const BAR: (f64, f64) = (200.0, 80.0);

impl Columns {
    fn of(rooms: &[Room]) -> Self {
        let most = |text: fn(&Room) -> &String| {
            rooms.iter().map(|room| text(room).chars().count()).max().unwrap_or(0) as f64
        };
        let sides = 28.0 + 6.0 * most(|room| &room.text);
        let bar = sides + 7.0 * most(|room| &room.sides) + 8.0;
        let end = if rooms.is_empty() { 0.0 } else { bar + BAR.0 + BAR.1 };
        Self { sides, bar, end }
    }
}

/// The inequalities, one a row, with bars for their room.
fn list(svg: &mut String, rooms: &[Room], top: f64, columns: &Columns) {
    let (numbers, bar, most) = (columns.sides, columns.bar, BAR.0);
    let _ = writeln!(
        svg,
        "<text x=\"16\" y=\"{top:.1}\" font-weight=\"bold\">Room that the inequalities leave</text>"
    );
    for (row, room) in rooms.iter().enumerate() {
        let y = top + LINE * (row as f64 + 1.0);
        let holds = room.share > 0.0;
        let color = if holds { COLORS[2] } else { COLORS[1] };
        let length = most * room.share.abs().clamp(0.004, 1.0);
        let _ = writeln!(
            svg,
            "<text x=\"16\" y=\"{y:.1}\">{}</text><text x=\"{numbers:.1}\" y=\"{y:.1}\">{}</text>\
             <rect x=\"{bar:.1}\" y=\"{:.1}\" width=\"{length:.1}\" height=\"10\" fill=\"{color}\"/>\
             <text x=\"{:.1}\" y=\"{y:.1}\">{}</text>",
            escape(&room.text),
            escape(&room.sides),
            y - 9.5,
            bar + length + 6.0,
            escape(&room.room)
        );
    }
}
