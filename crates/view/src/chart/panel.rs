//! A panel: a part of the sheet with an axis across and one up.

use super::picture::LINE;
use super::{Axis, LETTERS, MARGIN, Picture, Point, Rect, WIDTH, cut, path, short, simplified, width};
use std::fmt::Write as _;

/// How far a drawn curve may be from its points (px).
const DEVIATION: f64 = 0.08;
/// The greatest share of a panel's width that a heading has beside a remark.
const HEADING: f64 = 0.6;
/// How much wider bold letters are.
const BOLD: f64 = 1.1;
/// What stands between panels beside each other (px).
const GAP: f64 = 18.0;

/// A field with two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Its left side (px).
    pub left: f64,
    /// Its upper side (px).
    pub top: f64,
    /// Its width (px).
    pub width: f64,
    /// Its height (px).
    pub height: f64,
    /// What is across.
    pub across: Axis,
    /// What is up.
    pub up: Axis,
}

impl Panel {
    /// The next panel of a picture, over its whole width.
    pub fn below(picture: &mut Picture, height: f64, across: Axis, up: Axis) -> Self {
        let left = Self::left_of([&up]);
        Self::from_left(picture, left, height, across, up)
    }

    /// The next panel, which begins where it is told to: at [`Self::left_of`] several, which are to stand in line.
    pub fn from_left(picture: &mut Picture, left: f64, height: f64, across: Axis, up: Axis) -> Self {
        let top = picture.take(height);
        Self { left, top, width: WIDTH - MARGIN - left, height, across, up }
    }

    /// The next panels beside each other, each with its axes.
    pub fn row(picture: &mut Picture, height: f64, axes: Vec<(Axis, Axis)>) -> Vec<Self> {
        let top = picture.take(height);
        let share = (WIDTH - 2.0 * MARGIN + GAP) / axes.len().max(1) as f64;
        let panel = |(index, (across, up)): (usize, (Axis, Axis))| {
            let before = MARGIN + share * index as f64;
            let left = before + Self::left_of([&up]) - MARGIN;
            Self { left, top, width: before + share - GAP - left, height, across, up }
        };
        axes.into_iter().enumerate().map(panel).collect()
    }

    /// Where panels begin that have room for the texts of these axes.
    pub fn left_of<'a>(axes: impl IntoIterator<Item = &'a Axis>) -> f64 {
        let texts = axes.into_iter().flat_map(Axis::ticks).map(|(_, text)| width(&text, LETTERS));
        (MARGIN + 8.0 + texts.fold(12.0, f64::max)).min(0.4 * WIDTH)
    }

    /// Where a value is across (px).
    pub fn x(&self, value: f64) -> f64 {
        self.left + self.width * self.across.share(value).clamp(-3.0, 4.0)
    }

    /// Where a value is up (px). What is far outside is kept near, and what has no bound too.
    pub fn y(&self, value: f64) -> f64 {
        let share = self.up.share(value).clamp(-3.0, 4.0);
        self.top + self.height * (1.0 - if share.is_nan() { 0.5 } else { share })
    }

    /// Its right side (px).
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Its lower side (px).
    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// The panel as a rectangle.
    pub fn rect(&self) -> Rect {
        Rect { left: self.left, top: self.top, right: self.right(), bottom: self.bottom() }
    }

    /// A heading in the line over the panel, and a remark at its right end, cut where both have no room.
    pub fn heading(&self, picture: &mut Picture, text: &str, remark: &str) {
        let y = self.top - 7.0;
        let share = if remark.is_empty() { 1.0 } else { HEADING };
        let text = cut(text, BOLD * LETTERS, share * self.width);
        picture.text("bold", (self.left, y), &text);
        if !remark.is_empty() {
            picture.text("soft end", (self.right(), y), &cut(remark, LETTERS, self.beside(&text)));
        }
    }

    /// How much room a remark has beside a heading (px).
    pub fn beside(&self, heading: &str) -> f64 {
        self.width - width(heading, BOLD * LETTERS).min(HEADING * self.width) - 12.0
    }

    /// The grid, the numbers at the left, the line of zero and the frame.
    pub fn grid(&self, picture: &mut Picture) {
        let (left, right, top, bottom) =
            (short(self.left), short(self.right()), short(self.top), short(self.bottom()));
        let upright = |values: Vec<f64>| {
            values.into_iter().fold(String::new(), |mut path, value| {
                let _ = write!(path, "M{} {top}V{bottom}", short(self.x(value)));
                path
            })
        };
        let level = |values: Vec<f64>| {
            values.into_iter().fold(String::new(), |mut path, value| {
                let _ = write!(path, "M{left} {}H{right}", short(self.y(value)));
                path
            })
        };
        let [across, up] = [&self.across, &self.up].map(Axis::ticks);
        let values = |ticks: &[(f64, String)]| ticks.iter().map(|tick| tick.0).collect();
        picture.path("fine", &(upright(self.across.between()) + &level(self.up.between())));
        picture.path("grid", &(upright(values(&across)) + &level(values(&up))));
        for (value, text) in up.iter().filter(|tick| !tick.1.is_empty()) {
            picture.text("end", (self.left - 6.0, self.y(*value) + 4.5), text);
        }
        let zero = self.y(0.0);
        if !self.up.is_logarithmic() && zero > self.top && zero < self.bottom() {
            picture.path("zero", &format!("M{left} {}H{right}", short(zero)));
        }
        self.frame(picture);
    }

    /// The frame alone.
    pub fn frame(&self, picture: &mut Picture) {
        picture.rect("box", (self.left, self.top), (self.width, self.height));
    }

    /// The numbers below the panel, and what they are.
    pub fn foot(&self, picture: &mut Picture, caption: &str) {
        picture.take(LINE);
        self.numbers(picture);
        if !caption.is_empty() {
            let y = picture.take(LINE + 4.0) + LETTERS + 3.0;
            let middle = self.left + 0.5 * self.width;
            picture.text("middle", (middle, y), &cut(caption, LETTERS, 2.0 * (WIDTH - middle)));
        }
        picture.take(6.0);
    }

    /// The numbers below the panel, as many as have room.
    pub fn numbers(&self, picture: &mut Picture) {
        let y = self.bottom() + LINE - 2.0;
        let mut free = f64::NEG_INFINITY;
        for (value, text) in self.across.ticks().iter().filter(|tick| !tick.1.is_empty()) {
            let half = 0.5 * width(text, LETTERS);
            // The last number does not leave the sheet.
            let x = self.x(*value).min(WIDTH - 3.0 - half);
            if x - half > free {
                picture.text("middle", (x, y), text);
                free = x + half + 5.0;
            }
        }
    }

    /// A line through values at places across, broken where one is not finite, cut off at the panel.
    pub fn curve(&self, picture: &mut Picture, class: &str, across: &[f64], values: &[f64]) {
        let points: Vec<Point> = across
            .iter()
            .zip(values)
            .map(|(x, y)| (self.x(*x), if y.is_finite() { self.y(*y) } else { f64::NAN }))
            .collect();
        let whole = |a: &Point, b: &Point| a.1.is_nan() == b.1.is_nan();
        let pieces = points.chunk_by(whole).filter(|piece| !piece[0].1.is_nan());
        let d: String = pieces.map(|piece| path(&simplified(piece, DEVIATION))).collect();
        picture.path(class, &d);
    }

    /// A line at a value, from side to side.
    pub fn level(&self, picture: &mut Picture, class: &str, value: f64) {
        let y = self.y(value);
        picture.line(class, &[(self.left, y), (self.right(), y)]);
    }

    /// A line at a place across, from top to bottom.
    pub fn upright(&self, picture: &mut Picture, class: &str, place: f64) {
        let x = self.x(place);
        picture.line(class, &[(x, self.top), (x, self.bottom())]);
    }

    /// What `draw` draws, cut off at the panel (but for the width of a line at its sides).
    pub fn clipped(&self, picture: &mut Picture, draw: impl FnOnce(&mut Picture)) {
        picture.clipped((self.left - 1.0, self.top), (self.width + 2.0, self.height), draw);
    }
}
