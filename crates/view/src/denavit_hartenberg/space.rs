//! Lines, arrows and names in space, and how they are seen.

use super::View;
use crate::chart::{LETTERS, Labels, MARGIN, Picture, Rect, SMALL, WIDTH, path, width};
use nalgebra::{Point2, Point3, Rotation2, Rotation3, Unit, Vector2, Vector3};

/// The greatest height of the drawing, and what is free around it (px).
const TALLEST: f64 = 520.0;
const FREE: f64 = 34.0;

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
    pub(super) const ALL: [(Self, &'static str); 6] = [
        (Self::Bone, "link of the figure"),
        (Self::Base, "base B"),
        (Self::Offset, "offset s, along z"),
        (Self::Normal, "common normal a, along x"),
        (Self::Z, "axis n: z of the frame before"),
        (Self::X, "xn: x of frame n"),
    ];

    pub(super) fn class(self) -> &'static str {
        match self {
            Self::Bone => "bone",
            Self::Name => "soft italic over",
            Self::Base => "dots s3",
            Self::Offset => "dashes s0",
            Self::Normal => "line s2",
            Self::Z => "arrow s0 f0",
            Self::X => "arrow s1 f1",
        }
    }

    /// The class of its label.
    fn text(self) -> &'static str {
        match self {
            Self::Z => "bold over t0",
            Self::X => "bold over t1",
            other => other.class(),
        }
    }
}

struct Line {
    from: Point2<f64>,
    to: Point2<f64>,
    stroke: Stroke,
    label: String,
}

/// A drawing in the plane of the view, in metres with y up until it is finished.
pub(super) struct Space {
    right: Vector3<f64>,
    up: Vector3<f64>,
    lines: Vec<Line>,
}

impl Space {
    /// Seen from a third of the way up between the horizon and the zenith, as an isometric view is.
    pub(super) fn new(view: &View) -> Self {
        let up = Unit::new_normalize(view.up);
        let reference = Vector3::ith((0..3).find(|i| up[*i].abs() < 0.9).unwrap_or_default(), 1.0);
        let level = (reference - *up * up.dot(&reference)).normalize();
        let towards_viewer = Rotation3::from_axis_angle(&up, view.azimuth) * level * (2.0_f64 / 3.0).sqrt()
            + *up / 3.0_f64.sqrt();
        let right = up.cross(&towards_viewer).normalize();
        Self { right, up: towards_viewer.cross(&right), lines: Vec::new() }
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

    /// The drawing, as large as the picture is wide.
    pub(super) fn draw(mut self, picture: &mut Picture) {
        let (low, high) = self.bounds();
        let size = high - low;
        let free = WIDTH - 2.0 * MARGIN - 2.0 * FREE;
        let scale = (free / size.x.max(1e-9)).min(TALLEST / size.y.max(1e-9));
        let height = size.y * scale + 2.0 * FREE;
        let top = picture.take(height + 10.0);
        let middle = (low + high.coords) / 2.0;
        for line in &mut self.lines {
            for end in [&mut line.from, &mut line.to] {
                let from_middle = (*end - middle) * scale;
                *end = Point2::new(0.5 * WIDTH + from_middle.x, top + 0.5 * height - from_middle.y);
            }
        }
        for (stroke, _) in Stroke::ALL {
            for line in self.lines.iter().filter(|line| line.stroke == stroke) {
                line.draw(picture);
            }
        }
        let sheet = Rect { left: 4.0, top, right: WIDTH - 4.0, bottom: top + height + 8.0 };
        self.labels(picture, Labels::within(sheet));
    }

    /// Each label at the first place near its arrow's head, or beside its line's middle, that is free.
    fn labels(&self, picture: &mut Picture, mut labels: Labels) {
        // Lines are to stay visible: nothing covers an arrow, and no name anything else.
        let keep_off = |labels: &mut Labels, line: &Line| {
            let steps = ((line.to - line.from).norm() / 5.0).ceil().max(1.0);
            let step = (line.to - line.from) / steps;
            for i in 0..=steps as usize {
                let point = line.from + step * i as f64;
                labels.keep_off(Rect::about((point.x, point.y), (2.0, 2.0)));
            }
        };
        let drawn = || self.lines.iter().filter(|line| line.stroke != Stroke::Name);
        drawn().filter(|line| !line.label.is_empty()).for_each(|line| keep_off(&mut labels, line));
        // Names last: they have the most room.
        for names in [false, true] {
            if names {
                drawn().filter(|line| line.label.is_empty()).for_each(|line| keep_off(&mut labels, line));
            }
            let labelled = self.lines.iter().rev().filter(|line| !line.label.is_empty());
            for line in labelled.filter(|line| (line.stroke == Stroke::Name) == names) {
                let half = (0.52 * width(&line.label, LETTERS) + 1.0, 0.6 * SMALL);
                let places = line.places(half);
                let place = labels.place(places.iter().copied()).unwrap_or(places[0]);
                picture.text(line.stroke.text(), (place.left + 1.0, place.bottom - 2.5), &line.label);
            }
        }
    }
}

impl Line {
    fn draw(&self, picture: &mut Picture) {
        let (from, to, class) = (self.from, self.to, self.stroke.class());
        picture.line(class, &[(from.x, from.y), (to.x, to.y)]);
        let length = (to - from).norm();
        if matches!(self.stroke, Stroke::Z | Stroke::X) && length > 1.0 {
            let along = (to - from) / length * 7.0;
            let (across, neck) = (Vector2::new(-along.y, along.x) * 0.45, to - along);
            let head = [to, neck + across, neck - across].map(|point| (point.x, point.y));
            picture.path(class, &(path(&head) + "Z"));
        }
    }

    /// Where a label with these half sides may stand, the best place first: straight on, then to either side, then farther
    /// away.
    fn places(&self, half: (f64, f64)) -> Vec<Rect> {
        let along = (self.to - self.from).try_normalize(1e-9).unwrap_or_else(Vector2::x);
        let (start, first) = match self.stroke {
            Stroke::Name => (nalgebra::center(&self.from, &self.to), Vector2::new(-along.y, along.x)),
            _ => (self.to, along),
        };
        let place = |i: u32| {
            let turn = f64::from((i % 12).div_ceil(2)) * if i.is_multiple_of(2) { 0.5 } else { -0.5 };
            let away = Vector2::new(half.0, half.1) + Vector2::repeat(4.0 + f64::from(i / 12) * 6.0);
            let centre = start + (Rotation2::new(turn) * first).component_mul(&away);
            Rect::about((centre.x, centre.y), half)
        };
        (0..144).map(place).collect()
    }
}
