//! The picture: error against work, both logarithmic.

use super::axis::Decades;
use super::{Against, Diagram, MOST_SERIES, Point, Series};
use crate::html::escape;
use crate::profile::text::{cut, width};
use std::fmt::Write as _;

/// Size of the whole picture, and of the field of the points (px).
const SIZE: (f64, f64) = (640.0, 440.0);
const FIELD: Field = Field { left: 66.0, top: 106.0, right: 624.0, bottom: 394.0 };
/// Height of the strip over the field, for settings without a usable result (px).
const STRIP: f64 = 26.0;
/// An error from here on (rad or m) says nothing.
const USELESS: f64 = 10.0;
/// Size of the letters (px).
const LETTERS: f64 = 11.0;
const SMALL: f64 = 9.5;

const STYLE: &str = include_str!("../../assets/precision.svg.css");

/// The corners of a rectangle (px).
#[derive(Clone, Copy)]
struct Field {
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
}

impl Field {
    fn meets(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// Error against work as the text of an SVG file: one line for each method, each point a setting. Settings without a
/// result, or with an error above 10, stand in a strip over the field. The same diagram gives the same text, byte for
/// byte.
///
/// # Examples
///
/// ```
/// use solaris_view::precision::{Against, Diagram, Point, Series, svg};
///
/// let point = |label: &str, evaluations: f64, error: Option<f64>| Point {
///     label: label.to_owned(),
///     seconds: None,
///     evaluations: Some(evaluations),
///     error,
/// };
/// let points = vec![point("1e-1 s", 40.0, None), point("1e-2 s", 400.0, Some(1e-6))];
/// let series = vec![Series { name: "Runge-Kutta 4".to_owned(), points }];
/// let diagram = Diagram { title: "pendulum".to_owned(), series, ..Diagram::default() };
/// assert!(svg(&diagram, Against::Evaluations).contains("no usable result"));
/// ```
pub fn svg(diagram: &Diagram, against: Against) -> String {
    let axes = Axes::of(diagram, against);
    let wide = SIZE.0 - 32.0;
    let (width, height) = SIZE;
    let label = format!("{}: error against {}", diagram.title, against.name());
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"solaris-precision\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\" role=\"img\" aria-label=\"{0}\">\n<title>{0}</title>\n<style>{1}</style>\n\
         <rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n\
         <text class=\"title\" x=\"16\" y=\"22\">{2}</text>\n<text class=\"soft\" x=\"16\" y=\"39\">{3}</text>\n",
        escape(&label),
        STYLE.trim_end(),
        escape(&cut(&diagram.title, 15.0, wide)),
        escape(&cut(&diagram.subtitle, LETTERS, wide)),
    );
    legend(&mut svg, diagram);
    axes.draw(&mut svg, diagram);
    let mut taken = Vec::new();
    for (index, series) in diagram.series.iter().enumerate() {
        line(&mut svg, &axes, index, series, &mut taken);
    }
    // Labels last: they keep clear of all marks.
    for (index, series) in diagram.series.iter().enumerate() {
        labels(&mut svg, &axes, index, series, &mut taken);
    }
    svg.push_str("</svg>\n");
    svg
}

struct Axes {
    against: Against,
    work: Decades,
    error: Decades,
}

impl Axes {
    fn of(diagram: &Diagram, against: Against) -> Self {
        let points = || diagram.series.iter().flat_map(|series| &series.points);
        let errors = points().filter_map(usable).chain(diagram.wanted);
        Self {
            against,
            work: Decades::around(points().filter_map(|point| against.of(point)), (-9, 15)),
            error: Decades::around(errors, (-17, 1)),
        }
    }

    /// Where a point is drawn; in the strip where it has no usable result; nowhere where its work is unknown.
    fn place(&self, series: usize, point: &Point) -> Option<(f64, f64)> {
        let x = self.x(self.against.of(point)?);
        // Methods of the same cost one below the other.
        let lane = (series % MOST_SERIES) as f64 / (MOST_SERIES - 1) as f64;
        let strip = FIELD.top - STRIP * (0.8 - 0.6 * lane);
        Some((x, usable(point).map_or(strip, |error| self.y(error))))
    }

    fn x(&self, work: f64) -> f64 {
        FIELD.left + (FIELD.right - FIELD.left) * self.work.share(work)
    }

    fn y(&self, error: f64) -> f64 {
        FIELD.bottom - (FIELD.bottom - FIELD.top) * self.error.share(error)
    }

    fn draw(&self, svg: &mut String, diagram: &Diagram) {
        let Field { left, top, right, bottom } = FIELD;
        let (strip, wide, high) = (top - STRIP, right - left, bottom - top);
        // Writing to a string cannot fail.
        let _ = writeln!(
            svg,
            "<rect class=\"strip\" x=\"{left}\" y=\"{strip}\" width=\"{wide}\" height=\"{STRIP}\"/>\n\
             <text class=\"soft small end\" x=\"{}\" y=\"{}\">no usable result</text>",
            right - 6.0,
            top - 0.5 * STRIP + 3.5,
        );
        let mut grid: (String, String) = Default::default();
        for work in self.work.between() {
            let _ = write!(grid.1, "M{:.1} {top}V{bottom}", self.x(work));
        }
        for error in self.error.between() {
            let _ = write!(grid.1, "M{left} {:.1}H{right}", self.y(error));
        }
        for (work, text) in self.work.ticks(9) {
            let x = self.x(work);
            let _ = write!(grid.0, "M{x:.1} {top}V{bottom}");
            let y = bottom + 16.0;
            let _ =
                text.map(|text| writeln!(svg, "<text class=\"middle\" x=\"{x:.1}\" y=\"{y}\">{text}</text>"));
        }
        for (error, text) in self.error.ticks(9) {
            let y = self.y(error);
            let _ = write!(grid.0, "M{left} {y:.1}H{right}");
            let (x, y) = (left - 7.0, y + 3.8);
            let _ =
                text.map(|text| writeln!(svg, "<text class=\"end\" x=\"{x}\" y=\"{y:.1}\">{text}</text>"));
        }
        let _ = writeln!(
            svg,
            "<path class=\"fine\" d=\"{}\"/>\n<path class=\"grid\" d=\"{}\"/>\n\
             <rect class=\"box\" x=\"{left}\" y=\"{strip}\" width=\"{wide}\" height=\"{}\"/>",
            grid.1,
            grid.0,
            high + STRIP,
        );
        let (middle, across) = (0.5 * (left + right), 0.5 * (top + bottom));
        let what = if diagram.error.is_empty() { "error" } else { &format!("error of {}", diagram.error) };
        let _ = writeln!(
            svg,
            "<text class=\"middle\" x=\"{middle}\" y=\"{}\">{}</text>\n\
             <text class=\"middle\" transform=\"translate(17 {across}) rotate(-90)\">{}</text>",
            SIZE.1 - 12.0,
            self.against.name(),
            escape(what),
        );
        self.levels(svg, diagram);
    }

    /// The error that is wanted, and how well the answer is known.
    fn levels(&self, svg: &mut String, diagram: &Diagram) {
        let Field { left, right, bottom, .. } = FIELD;
        if let Some(floor) = diagram.floor.map(|floor| self.y(floor)).filter(|y| bottom - y > 1.0) {
            let _ = writeln!(
                svg,
                "<rect class=\"floor\" x=\"{left}\" y=\"{floor:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>",
                right - left,
                bottom - floor,
            );
            if bottom - floor > 14.0 {
                let (x, y) = (left + 6.0, bottom - 5.0);
                let _ = writeln!(
                    svg,
                    "<text class=\"soft small\" x=\"{x}\" y=\"{y}\">not told apart from the reference</text>"
                );
            }
        }
        if let Some(y) = diagram.wanted.map(|wanted| self.y(wanted)) {
            let _ = writeln!(
                svg,
                "<path class=\"wanted\" d=\"M{left} {y:.1}H{right}\"/>\n<text class=\"soft small end\" x=\"{}\" y=\"{:.1}\">wanted</text>",
                right - 6.0,
                y - 4.0,
            );
        }
    }
}

/// The error of a point that says something.
fn usable(point: &Point) -> Option<f64> {
    point.error.filter(|error| *error < USELESS)
}

/// Marks and names of the series, in as many rows as they need.
fn legend(svg: &mut String, diagram: &Diagram) {
    let (mut x, mut y) = (22.0, 56.0);
    for (index, series) in diagram.series.iter().enumerate() {
        let name = cut(&series.name, LETTERS, 200.0);
        let wide = width(&name, LETTERS) + 28.0;
        if x + wide > SIZE.0 - 10.0 && x > 22.0 {
            (x, y) = (22.0, y + 15.0);
        }
        let mark = mark(index, (x, y - 4.0), true);
        let _ = writeln!(svg, "{mark}<text x=\"{:.1}\" y=\"{y}\">{}</text>", x + 10.0, escape(&name));
        x += wide;
    }
}

/// The line of a series and its marks.
fn line(svg: &mut String, axes: &Axes, index: usize, series: &Series, taken: &mut Vec<Field>) {
    let mut path = String::new();
    let mut marks = String::new();
    // What has no usable result ends the line.
    let mut joined = false;
    for point in &series.points {
        let Some((x, y)) = axes.place(index, point) else { continue };
        let is_usable = usable(point).is_some();
        if is_usable {
            let _ = write!(path, "{}{x:.1} {y:.1}", if joined { 'L' } else { 'M' });
        }
        joined = is_usable;
        let said = point.error.map_or_else(|| "no result".to_owned(), |error| format!("error {error:.1e}"));
        let said = escape(&format!("{}, {}: {said}", series.name, point.label));
        let _ = writeln!(marks, "<g><title>{said}</title>{}</g>", mark(index, (x, y), is_usable));
        taken.push(Field { left: x - 5.0, top: y - 5.0, right: x + 5.0, bottom: y + 5.0 });
    }
    let color = index % MOST_SERIES;
    let _ = write!(svg, "<path class=\"line s{color}\" d=\"{path}\"/>\n{marks}");
}

/// The settings beside the marks, as far as they do not cover anything.
fn labels(svg: &mut String, axes: &Axes, index: usize, series: &Series, taken: &mut Vec<Field>) {
    let color = index % MOST_SERIES;
    for point in series.points.iter().filter(|point| usable(point).is_some()) {
        let Some((x, y)) = axes.place(index, point) else { continue };
        let wide = width(&point.label, SMALL);
        let beside =
            [(x + 8.0, y - 3.0), (x - 8.0 - wide, y + 11.0), (x + 8.0, y + 11.0), (x - 8.0 - wide, y - 3.0)];
        let boxed = |(left, line): (f64, f64)| Field {
            left,
            top: line - SMALL,
            right: left + wide,
            bottom: line + 2.0,
        };
        let free = |label: &Field| {
            let inside = label.left > FIELD.left + 2.0 && label.right < FIELD.right - 2.0;
            inside
                && label.bottom < FIELD.bottom - 2.0
                && label.top > FIELD.top
                && !taken.iter().any(|it| it.meets(label))
        };
        let Some(label) = beside.into_iter().map(boxed).find(free) else { continue };
        let (left, line) = (label.left, label.bottom - 2.0);
        let _ = writeln!(
            svg,
            "<text class=\"small label t{color}\" x=\"{left:.1}\" y=\"{line:.1}\">{}</text>",
            escape(&point.label)
        );
        taken.push(label);
    }
}

/// A mark; a cross over it where there is no usable result.
fn mark(index: usize, (x, y): (f64, f64), is_usable: bool) -> String {
    let index = index % MOST_SERIES;
    let shape = match index {
        0 => "M-4-4H4V4H-4Z",
        1 => "M0-5L5 4H-5Z",
        2 => "M0 5L5-4H-5Z",
        3 => "M-4.5 0A4.5 4.5 0 1 0 4.5 0A4.5 4.5 0 1 0-4.5 0Z",
        4 => "M0-5.5L5.5 0L0 5.5L-5.5 0Z",
        _ => "M-2-5H2V-2H5V2H2V5H-2V2H-5V-2H-2Z",
    };
    let (class, shape) = if is_usable { ("mark", shape) } else { ("failed", "M-4-4L4 4M-4 4L4-4") };
    format!("<path class=\"{class} s{index}\" transform=\"translate({x:.1} {y:.1})\" d=\"{shape}\"/>")
}
