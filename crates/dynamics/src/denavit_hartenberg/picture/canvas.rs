//! Lines, arrows and labels in space, and their picture.

use super::View;
use nalgebra::{Point2, Point3, Rotation3, Unit, Vector2, Vector3};
use std::fmt::Write;

const MARGIN: f64 = 34.0;
const LINE_HEIGHT: f64 = 17.0;
/// Where the columns of the table end, or begin for the second one (pixels from the table's left edge).
const COLUMNS: [f64; 7] = [18.0, 28.0, 216.0, 258.0, 302.0, 354.0, 404.0];
const TABLE_WIDTH: f64 = 420.0;

/// Number, degree of freedom, base, α, θ⁰, a, s⁰.
pub(super) type Row = [String; 7];

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stroke {
    Bone,
    Name,
    Base,
    Offset,
    Normal,
    Z,
    X,
}

impl Stroke {
    /// In the order in which they are drawn, with what the legend says.
    const ALL: [(Self, &'static str); 6] = [
        (Self::Bone, "link of the figure"),
        (Self::Base, "base B"),
        (Self::Offset, "offset s, along z"),
        (Self::Normal, "common normal a, along x"),
        (Self::Z, "axis n: z of the frame before"),
        (Self::X, "xn: x of frame n"),
    ];

    fn class(self) -> &'static str {
        match self {
            Self::Bone => "bone",
            Self::Name => "name",
            Self::Base => "base",
            Self::Offset => "offset",
            Self::Normal => "normal",
            Self::Z => "z",
            Self::X => "x",
        }
    }
}

const STYLE: &str = "\
text{font:13px sans-serif;fill:#333}\
.bone{stroke:#c9c9c9;stroke-width:9;stroke-linecap:round}\
.base{stroke:#8e44ad;stroke-width:1.6;stroke-dasharray:2 3}\
.offset{stroke:#1f5fbf;stroke-width:1.4;stroke-dasharray:5 3}\
.normal{stroke:#1e8e4e;stroke-width:2}\
.z{stroke:#1f5fbf;stroke-width:2;fill:#1f5fbf}\
.x{stroke:#c0392b;stroke-width:2;fill:#c0392b}\
text.name{fill:#888;font-style:italic}\
text.z,text.x,text.name{stroke:#fff;stroke-width:3;paint-order:stroke}\
text.z,text.x,.head{font-weight:bold}";

struct Line {
    from: Point2<f64>,
    to: Point2<f64>,
    stroke: Stroke,
    label: String,
}

/// A drawing in the plane of the view, in metres with y up until it is finished.
pub(super) struct Canvas {
    right: Vector3<f64>,
    up: Vector3<f64>,
    width: f64,
    lines: Vec<Line>,
}

impl Canvas {
    /// Seen from a third of the way up between the horizon and the zenith, as an isometric view is.
    pub(super) fn new(view: &View) -> Self {
        let up = Unit::new_normalize(view.up);
        let reference = Vector3::ith((0..3).find(|i| up[*i].abs() < 0.9).unwrap_or_default(), 1.0);
        let level = (reference - *up * up.dot(&reference)).normalize();
        let towards_viewer = Rotation3::from_axis_angle(&up, view.azimuth) * level * (2.0_f64 / 3.0).sqrt()
            + *up / 3.0_f64.sqrt();
        let right = up.cross(&towards_viewer).normalize();
        Self { right, up: towards_viewer.cross(&right), width: view.width, lines: Vec::new() }
    }

    fn project(&self, point: Point3<f64>) -> Point2<f64> {
        Point2::new(self.right.dot(&point.coords), self.up.dot(&point.coords))
    }

    pub(super) fn line(&mut self, from: Point3<f64>, to: Point3<f64>, stroke: Stroke) {
        if (to - from).norm() > 0.0 {
            let (from, to) = (self.project(from), self.project(to));
            self.lines.push(Line { from, to, stroke, label: String::new() });
        }
    }

    /// An arrow; one that lies on an earlier arrow of its kind adds its label to that one's.
    pub(super) fn arrow(&mut self, from: Point3<f64>, along: Vector3<f64>, stroke: Stroke, label: &str) {
        let (start, end) = (self.project(from), self.project(from + along));
        let near = |a: &Point2<f64>, b: &Point2<f64>| (a - b).norm() < 0.05 * along.norm();
        let twin = self
            .lines
            .iter_mut()
            .find(|line| line.stroke == stroke && near(&line.from, &start) && near(&line.to, &end));
        match twin {
            Some(twin) => {
                twin.label.push(' ');
                twin.label.push_str(label);
            }
            None => self.lines.push(Line { from: start, to: end, stroke, label: label.to_owned() }),
        }
    }

    /// A name for the line between two points, written beside its middle.
    pub(super) fn name(&mut self, from: Point3<f64>, to: Point3<f64>, name: &str) {
        let (from, to) = (self.project(from), self.project(to));
        self.lines.push(Line { from, to, stroke: Stroke::Name, label: name.to_owned() });
    }

    /// The larger side of what is drawn so far (m).
    pub(super) fn extent(&self) -> f64 {
        let (low, high) = self.bounds();
        (high - low).amax()
    }

    fn bounds(&self) -> (Point2<f64>, Point2<f64>) {
        let points = self.lines.iter().flat_map(|line| [line.from, line.to]);
        points.fold((Point2::origin(), Point2::origin()), |(low, high), point| {
            (low.inf(&point), high.sup(&point))
        })
    }

    /// The document: drawing on the left, table and legend on the right.
    pub(super) fn finish(mut self, title: &str, rows: &[Row]) -> String {
        let (low, high) = self.bounds();
        let size = high - low;
        let table_height = LINE_HEIGHT * (rows.len() + Stroke::ALL.len() + 3) as f64 + 2.0 * MARGIN;
        let scale = (self.width - 2.0 * MARGIN) / size.x.max(size.y / 1.6).max(1e-9);
        let height = (size.y * scale + 2.0 * MARGIN).max(table_height);
        let middle = (low + high.coords) / 2.0;
        let on_page = |point: Point2<f64>| {
            let from_middle = (point - middle) * scale;
            Point2::new(self.width / 2.0 + from_middle.x, height / 2.0 - from_middle.y)
        };
        for line in &mut self.lines {
            (line.from, line.to) = (on_page(line.from), on_page(line.to));
        }
        let width = self.width + TABLE_WIDTH;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" \
             height=\"{height:.0}\">\n<title>{}</title>\n<style>{STYLE}</style>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
            escaped(title)
        );
        for (stroke, _) in Stroke::ALL {
            for line in self.lines.iter().filter(|line| line.stroke == stroke) {
                draw(&mut svg, line);
            }
        }
        self.labels(&mut svg);
        table(&mut svg, self.width, rows);
        legend(&mut svg, self.width, MARGIN + LINE_HEIGHT * (rows.len() + 2) as f64);
        svg.push_str("</svg>\n");
        svg
    }

    /// Each label at the first place near its arrow's head, or beside its line's middle, that is free.
    fn labels(&self, svg: &mut String) {
        let labelled = || self.lines.iter().rev().filter(|line| !line.label.is_empty());
        // Lines are to stay visible: nothing covers an arrow, and no name anything else.
        let points = |line: &Line| {
            let steps = ((line.to - line.from).norm() / 5.0).ceil().max(1.0);
            let (from, step) = (line.from, (line.to - line.from) / steps);
            (0..=steps as usize).map(move |i| (from + step * i as f64, Vector2::repeat(2.0)))
        };
        let (arrows, others): (Vec<&Line>, Vec<&Line>) = self
            .lines
            .iter()
            .filter(|line| line.stroke != Stroke::Name)
            .partition(|line| !line.label.is_empty());
        let mut taken: Vec<(Point2<f64>, Vector2<f64>)> = arrows.into_iter().flat_map(points).collect();
        // Names last: they have the most room.
        for names in [false, true] {
            if names {
                taken.extend(others.iter().copied().flat_map(points));
            }
            for line in labelled().filter(|line| (line.stroke == Stroke::Name) == names) {
                let half = Vector2::new(3.9 * line.label.chars().count() as f64 + 1.0, 7.0);
                let centre = place(line, &half, &taken);
                taken.push((centre, half));
                text(svg, line.stroke.class(), "middle", centre.x, centre.y + 4.5, &line.label);
            }
        }
    }
}

/// The centre of a label with these half sides, off the rectangles that are taken.
fn place(line: &Line, half: &Vector2<f64>, taken: &[(Point2<f64>, Vector2<f64>)]) -> Point2<f64> {
    let along = (line.to - line.from).try_normalize(1e-9).unwrap_or_else(Vector2::x);
    let (start, first) = match line.stroke {
        Stroke::Name => (nalgebra::center(&line.from, &line.to), Vector2::new(-along.y, along.x)),
        _ => (line.to, along),
    };
    let places = (0..144).map(|i| {
        // Straight on, then to either side, then farther away.
        let step = f64::from((i % 12 + 1) / 2) * if i % 2 == 0 { 0.5 } else { -0.5 };
        let away = half + Vector2::repeat(4.0 + f64::from(i / 12) * 6.0);
        start + (nalgebra::Rotation2::new(step) * first).component_mul(&away)
    });
    let is_free = |centre: &Point2<f64>| {
        taken.iter().all(|(other, other_half)| {
            let gap = (centre - other).abs() - half - other_half;
            gap.x > 0.0 || gap.y > 0.0
        })
    };
    let places: Vec<Point2<f64>> = places.collect();
    places.iter().find(|place| is_free(place)).copied().unwrap_or(places[0])
}

fn draw(svg: &mut String, line: &Line) {
    let (from, to, class) = (line.from, line.to, line.stroke.class());
    put(
        svg,
        &format!(
            "<line class=\"{class}\" x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\"/>",
            from.x, from.y, to.x, to.y
        ),
    );
    let length = (to - from).norm();
    if matches!(line.stroke, Stroke::Z | Stroke::X) && length > 1.0 {
        let along = (to - from) / length * 7.0;
        let (across, neck) = (Vector2::new(-along.y, along.x) * 0.45, to - along);
        let (left, right) = (neck + across, neck - across);
        put(
            svg,
            &format!(
                "<path class=\"{class}\" d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}Z\"/>",
                to.x, to.y, left.x, left.y, right.x, right.y
            ),
        );
    }
}

fn table(svg: &mut String, left: f64, rows: &[Row]) {
    let heads = ["n", "degree of freedom", "base", "α (°)", "θ⁰ (°)", "a (m)", "s⁰ (m)"].map(str::to_owned);
    for (i, row) in std::iter::once(&heads).chain(rows).enumerate() {
        let y = MARGIN + LINE_HEIGHT * i as f64;
        for (j, cell) in row.iter().enumerate() {
            let (anchor, class) =
                (if j == 1 { "start" } else { "end" }, if i == 0 { "head" } else { "cell" });
            text(svg, class, anchor, left + COLUMNS[j], y, cell);
        }
    }
}

fn legend(svg: &mut String, left: f64, top: f64) {
    for (i, (stroke, says)) in Stroke::ALL.into_iter().rev().enumerate() {
        let y = top + LINE_HEIGHT * i as f64;
        let from = Point2::new(left + 12.0, y - 4.5);
        draw(svg, &Line { from, to: from + Vector2::x() * 32.0, stroke, label: String::new() });
        text(svg, "says", "start", left + 56.0, y, says);
    }
}

fn text(svg: &mut String, class: &str, anchor: &str, x: f64, y: f64, content: &str) {
    let content = escaped(content);
    put(
        svg,
        &format!(
            "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" style=\"text-anchor:{anchor}\">{content}</text>"
        ),
    );
}

fn put(svg: &mut String, element: &str) {
    // Writing to a string does not fail.
    let _ = writeln!(svg, "{element}");
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
