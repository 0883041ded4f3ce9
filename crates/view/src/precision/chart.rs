//! The picture: error against work, both logarithmic.

use super::{Against, Diagram, MOST_SERIES, Point, Series};
use crate::chart::{Axis, Key, Labels, Mark, Panel, Picture, Rect, SMALL, path, width};

/// Height of the field of the points, and of the strip over it for settings without a usable result (px).
const FIELD: f64 = 330.0;
const STRIP: f64 = 28.0;
/// An error from here on (rad or m) says nothing.
const USELESS: f64 = 10.0;
/// Half the size of a mark that labels keep off (px).
const MARK: (f64, f64) = (6.0, 6.0);

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
    let mut picture =
        Picture::new(&diagram.title).named(format!("{}: error against {}", diagram.title, against.name()));
    picture.remark(&diagram.subtitle, 2);
    picture.take(3.0);
    let mark = |(index, series): (usize, &Series)| Key::mark(Mark::Filled, index, series.name.as_str());
    picture.legend(&diagram.series.iter().enumerate().map(mark).collect::<Vec<Key>>());
    picture.heading(&if diagram.error.is_empty() {
        "error".to_owned()
    } else {
        format!("error of {}", diagram.error)
    });
    let field = Field::of(&mut picture, diagram, against);
    let mut labels = Labels::within(Rect { left: field.panel.left + 2.0, ..field.panel.rect() });
    field.axes(&mut picture, diagram, &mut labels);
    for (index, series) in diagram.series.iter().enumerate() {
        field.line(&mut picture, index, series, &mut labels);
    }
    // Settings last: they keep off all marks.
    for (index, series) in diagram.series.iter().enumerate() {
        field.settings(&mut picture, index, series, &mut labels);
    }
    picture.finish()
}

/// The field of the points, with the strip over it.
struct Field {
    against: Against,
    panel: Panel,
}

impl Field {
    fn of(picture: &mut Picture, diagram: &Diagram, against: Against) -> Self {
        let points = || diagram.series.iter().flat_map(|series| &series.points);
        let errors = points().filter_map(usable).chain(diagram.wanted);
        let work = Axis::logarithmic(points().filter_map(|point| against.of(point)), (-9, 15), 9);
        let error = Axis::logarithmic(errors, (-17, 1), 9);
        picture.take(STRIP);
        Self { against, panel: Panel::below(picture, FIELD, work, error) }
    }

    /// Where a point is drawn; in the strip where it has no usable result; nowhere where its work is unknown.
    fn place(&self, series: usize, point: &Point) -> Option<(f64, f64)> {
        let x = self.panel.x(self.against.of(point)?);
        // Methods of the same cost one below the other.
        let lane = (series % MOST_SERIES) as f64 / (MOST_SERIES - 1) as f64;
        let strip = self.panel.top - STRIP * (0.8 - 0.6 * lane);
        Some((x, usable(point).map_or(strip, |error| self.panel.y(error))))
    }

    /// Strip, axes, the error that is wanted, and how well the answer is known.
    fn axes(&self, picture: &mut Picture, diagram: &Diagram, labels: &mut Labels) {
        let panel = &self.panel;
        let (left, right, bottom) = (panel.left, panel.right(), panel.bottom());
        picture.rect("strip", (left, panel.top - STRIP), (panel.width, STRIP));
        picture.text("soft small end", (right - 6.0, panel.top - 0.5 * STRIP + 4.0), "no usable result");
        let floor = diagram.floor.map_or(bottom, |floor| panel.y(floor));
        if bottom - floor > 1.0 {
            picture.rect("floor", (left, floor), (panel.width, bottom - floor));
        }
        panel.grid(picture);
        picture.rect("box", (left, panel.top - STRIP), (panel.width, STRIP));
        panel.foot(picture, self.against.name());
        let mut note = |picture: &mut Picture, text: &str, is_left: bool, line: f64| {
            let wide = width(text, SMALL);
            let from = if is_left { left + 6.0 } else { right - 6.0 - wide };
            picture.text("soft small over", (from, line), text);
            labels.keep_off(Rect { left: from, top: line - SMALL, right: from + wide, bottom: line + 3.0 });
        };
        if bottom - floor > 16.0 {
            note(picture, "not told apart from the reference", true, bottom - 5.0);
        }
        if let Some(wanted) = diagram.wanted {
            panel.level(picture, "level", wanted);
            note(picture, "wanted", false, panel.y(wanted) - 4.0);
        }
    }

    /// The line of a series and its marks.
    fn line(&self, picture: &mut Picture, index: usize, series: &Series, labels: &mut Labels) {
        let placed = |point: &Point| self.place(index, point).filter(|_| usable(point).is_some());
        // What has no usable result ends the line; what has no place is passed by.
        let known: Vec<&Point> =
            series.points.iter().filter(|point| self.place(index, point).is_some()).collect();
        let pieces = known.chunk_by(|a, b| placed(a).is_some() == placed(b).is_some());
        let pieces: Vec<Vec<(f64, f64)>> =
            pieces.map(|piece| piece.iter().filter_map(|point| placed(point)).collect()).collect();
        let d: String = pieces.iter().map(|piece| path(piece)).collect();
        picture.path(&format!("line s{}", index % MOST_SERIES), &d);
        for point in known {
            let Some(at) = self.place(index, point) else { continue };
            let said =
                point.error.map_or_else(|| "no result".to_owned(), |error| format!("error {error:.1e}"));
            let mark = if usable(point).is_some() { Mark::Filled } else { Mark::Failed };
            picture.told(&format!("{}, {}: {said}", series.name, point.label), |picture| {
                picture.mark(mark, index, at);
            });
            labels.keep_off(Rect::about(at, MARK));
        }
    }

    /// The settings beside the marks, as far as they do not cover anything.
    fn settings(&self, picture: &mut Picture, index: usize, series: &Series, labels: &mut Labels) {
        for point in series.points.iter().filter(|point| usable(point).is_some() && !point.label.is_empty()) {
            let Some((x, y)) = self.place(index, point) else { continue };
            let half = 0.5 * width(&point.label, SMALL);
            let beside = [(1.0, -0.7), (-1.0, 0.7), (1.0, 0.7), (-1.0, -0.7), (0.0, -1.6), (0.0, 1.6)];
            let boxes = beside.map(|(right, down)| {
                Rect::about((x + right * (half + 8.0), y + down * 8.0), (half, 0.5 * SMALL + 1.0))
            });
            if let Some(label) = labels.place(boxes) {
                let class = format!("small over t{}", index % MOST_SERIES);
                picture.text(&class, (label.left, label.bottom - 3.0), &point.label);
            }
        }
    }
}

/// The error of a point that says something.
fn usable(point: &Point) -> Option<f64> {
    point.error.filter(|error| *error < USELESS)
}
