//! Charts as the text of SVG files: one sheet, panels with axes, lines, marks, keys and labels that keep off each other.
//!
//! Every picture of the project is drawn by it, so that all look alike: 560 px wide with letters of 13 px, which a telephone
//! still shows at 8 px; colours that people with any kind of colour vision tell apart, with shapes beside them; a
//! light sheet of its own, and a dark one where the reader's system asks for it. Own text and no plotting crate: it is
//! little, measures its texts, and gives the same bytes for the same picture.
//!
//! # Examples
//!
//! ```
//! use solaris_view::chart::{Axis, Key, Panel, Picture};
//!
//! let time: Vec<f64> = (0..=100).map(|i| 0.02 * f64::from(i)).collect();
//! let fall: Vec<f64> = time.iter().map(|t| 0.5 * 9.81 * t * t).collect();
//! let mut picture = Picture::new("A fall");
//! picture.heading("way (m)");
//! picture.legend(&[Key::line(0, "without air")]);
//! let panel = Panel::below(&mut picture, 200.0, Axis::linear(0.0, 2.0, 8.0), Axis::linear(0.0, 20.0, 5.0));
//! panel.grid(&mut picture);
//! panel.curve(&mut picture, "line s0", &time, &fall);
//! panel.foot(&mut picture, "time (s)");
//! assert!(picture.finish().starts_with("<svg "));
//! ```

mod axis;
mod labels;
mod legend;
mod line;
mod mark;
mod panel;
mod picture;
mod style;
mod text;

pub use axis::Axis;
pub use labels::{Labels, Rect};
pub use legend::Key;
pub use line::{path, simplified};
pub use mark::Mark;
pub use panel::Panel;
pub use picture::Picture;
pub use text::{cut, escape, lines, number, shown, superscript, width};

pub(crate) use line::short;
pub(crate) use text::joined;

/// A point of a picture: right and down (px).
pub type Point = (f64, f64);

/// Width of a picture (px).
pub const WIDTH: f64 = 560.0;
/// What is left free at the sides (px).
pub const MARGIN: f64 = 14.0;
/// Size of the letters (px), and of small ones.
pub const LETTERS: f64 = 13.0;
/// Size of the letters of class `small` (px).
pub const SMALL: f64 = 11.5;
/// How many series have a colour and a shape of their own: with more, both begin again.
pub const SERIES: usize = 6;
