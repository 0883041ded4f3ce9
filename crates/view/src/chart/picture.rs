//! The sheet that everything is drawn on, from its top to its bottom.

use super::{LETTERS, MARGIN, Mark, Point, WIDTH, cut, escape, line, lines, short, style};
use std::fmt::{Arguments, Write as _};

/// Size of a title's letters, and height of its lines and of others (px).
const TITLE: f64 = 17.0;
const TITLE_LINE: f64 = 22.0;
pub(super) const LINE: f64 = 17.0;

/// A picture in the making. What flows takes its place below what was there before: title, remarks, headings, legends, panels.
/// Everything else goes where it is told to.
///
/// A class says what an element looks like: `line s0`, `soft end`; `chart/style.rs` has them all.
#[derive(Clone, Debug)]
pub struct Picture {
    title: String,
    class: &'static str,
    has_tooltip: bool,
    body: String,
    top: f64,
}

impl Picture {
    /// An empty sheet with a title of at most two lines.
    pub fn new(title: &str) -> Self {
        let mut picture =
            Self { title: title.to_owned(), class: "", has_tooltip: true, body: String::new(), top: 6.0 };
        for line in lines(title, 1.08 * TITLE, WIDTH - 2.0 * MARGIN, 2) {
            let y = picture.take(TITLE_LINE) + TITLE;
            picture.text("title", (MARGIN, y), &line);
        }
        picture.top += 4.0;
        picture
    }

    /// The same with another name for those who do not see it: by default the title.
    pub fn named(self, name: String) -> Self {
        Self { title: name, ..self }
    }

    /// The same without the title as a tooltip, and with a class of its own: for a page that draws into the picture and says other
    /// things under the pointer.
    pub fn on_page(self, class: &'static str) -> Self {
        Self { has_tooltip: false, class, ..self }
    }

    /// The next `height` (px) of the sheet: where they begin.
    pub fn take(&mut self, height: f64) -> f64 {
        let top = self.top;
        self.top += height;
        top
    }

    /// A remark of at most `count` lines, in soft letters.
    pub fn remark(&mut self, text: &str, count: usize) {
        for line in lines(text, LETTERS, WIDTH - 2.0 * MARGIN, count) {
            let y = self.take(LINE) + LETTERS;
            self.text("soft", (MARGIN, y), &line);
        }
    }

    /// What the next panel shows: `angle (°)`.
    pub fn heading(&mut self, text: &str) {
        // So far over the panel that the panel's highest number has room.
        let y = self.take(LINE + 12.0) + LETTERS + 5.0;
        self.text("bold", (MARGIN, y), &cut(text, 1.1 * LETTERS, WIDTH - 2.0 * MARGIN));
    }

    /// A text with its left end (or what its class says) at a point of its line.
    pub fn text(&mut self, class: &str, (x, y): Point, text: &str) {
        let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
        let (x, y, text) = (short(x), short(y), escape(text));
        self.put(format_args!("<text{class} x=\"{x}\" y=\"{y}\">{text}</text>"));
    }

    /// A path from its SVG text: `M0 0L10 10`; nothing where it is empty.
    pub fn path(&mut self, class: &str, d: &str) {
        if !d.is_empty() {
            self.put(format_args!("<path class=\"{class}\" d=\"{d}\"/>"));
        }
    }

    /// A line through points.
    pub fn line(&mut self, class: &str, points: &[Point]) {
        self.path(class, &line::path(points));
    }

    /// A rectangle from its upper left corner, with its width and height (px).
    pub fn rect(&mut self, class: &str, corner: Point, size: Point) {
        let [x, y, width, height] = [corner.0, corner.1, size.0.max(0.0), size.1.max(0.0)].map(short);
        self.put(format_args!(
            "<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>"
        ));
    }

    /// A circle.
    pub fn circle(&mut self, class: &str, centre: Point, radius: f64) {
        let [x, y, r] = [centre.0, centre.1, radius].map(short);
        self.put(format_args!("<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"));
    }

    /// A mark of a series, in its colour and shape.
    pub fn mark(&mut self, mark: Mark, series: usize, at: Point) {
        let (class, d) = mark.look(series);
        let (x, y) = (short(at.0), short(at.1));
        self.put(format_args!("<path class=\"{class}\" transform=\"translate({x} {y})\" d=\"{d}\"/>"));
    }

    /// What `draw` draws, with a text that is told under the pointer.
    pub fn told(&mut self, text: &str, draw: impl FnOnce(&mut Self)) {
        self.put(format_args!("<g><title>{}</title>", escape(text)));
        draw(self);
        self.put(format_args!("</g>"));
    }

    /// What `draw` draws, cut off at a rectangle.
    pub fn clipped(&mut self, corner: Point, size: Point, draw: impl FnOnce(&mut Self)) {
        let [x, y, width, height] = [corner.0, corner.1, size.0, size.1].map(short);
        // A picture within the picture needs no name, of which another picture on the same page could have the same.
        self.put(format_args!(
            "<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" viewBox=\"{x} {y} {width} {height}\" \
             overflow=\"hidden\">"
        ));
        draw(self);
        self.put(format_args!("</svg>"));
    }

    /// The text of the SVG file, as high as what was taken.
    pub fn finish(self) -> String {
        let class = format!("solaris-chart {}", self.class);
        let (title, height) = (escape(&self.title), short((self.top + 10.0).ceil()));
        let tooltip = if self.has_tooltip { format!("<title>{title}</title>\n") } else { String::new() };
        let paper = format!("<rect class=\"paper\" width=\"{WIDTH}\" height=\"{height}\"/>\n");
        let body = paper + &self.body;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{}\" viewBox=\"0 0 {WIDTH} {height}\" \
             width=\"{WIDTH}\" height=\"{height}\" role=\"img\" aria-label=\"{title}\">\n{tooltip}<style>\n{}</style>\n{body}</svg>\n",
            class.trim_end(),
            style::sheet(&body),
        )
    }

    fn put(&mut self, element: Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.body, "{element}");
    }
}
