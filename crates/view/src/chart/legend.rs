//! Legends.

use super::picture::LINE;
use super::{LETTERS, MARGIN, Mark, Picture, WIDTH, cut, width};

/// An entry of a legend: a sample and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    sample: Sample,
    name: String,
}

#[derive(Clone, Debug, PartialEq)]
enum Sample {
    Line(String),
    Mark(Mark, usize),
    Area(String),
}

/// Width of a sample, and of what is free after an entry (px).
const SAMPLE: f64 = 22.0;
const GAP: f64 = 16.0;

impl Key {
    /// The line of a series.
    pub fn line(series: usize, name: impl Into<String>) -> Self {
        Self::stroke(format!("line s{}", series % super::SERIES), name)
    }

    /// A line of a class.
    pub fn stroke(class: impl Into<String>, name: impl Into<String>) -> Self {
        Self { sample: Sample::Line(class.into()), name: name.into() }
    }

    /// A mark of a series.
    pub fn mark(mark: Mark, series: usize, name: impl Into<String>) -> Self {
        Self { sample: Sample::Mark(mark, series), name: name.into() }
    }

    /// An area of a class.
    pub fn area(class: impl Into<String>, name: impl Into<String>) -> Self {
        Self { sample: Sample::Area(class.into()), name: name.into() }
    }

    fn width(&self) -> f64 {
        match self.sample {
            Sample::Line(_) => SAMPLE + 8.0,
            Sample::Mark(..) | Sample::Area(_) => 18.0,
        }
    }
}

impl Picture {
    /// Samples and their names, in as many rows as they need.
    pub fn legend(&mut self, keys: &[Key]) {
        let Some(last) = keys.len().checked_sub(1) else { return };
        let (mut x, mut y) = (MARGIN, self.take(LINE) + LETTERS);
        for (index, key) in keys.iter().enumerate() {
            let name = cut(&key.name, LETTERS, WIDTH - 2.0 * MARGIN - key.width());
            let wide = key.width() + width(&name, LETTERS);
            if x + wide > WIDTH - MARGIN && x > MARGIN {
                (x, y) = (MARGIN, self.take(LINE) + LETTERS);
            }
            let middle = y - 4.5;
            match &key.sample {
                Sample::Line(class) => self.line(class, &[(x + 2.0, middle), (x + SAMPLE, middle)]),
                Sample::Mark(mark, series) => self.mark(*mark, *series, (x + 6.0, middle)),
                Sample::Area(class) => self.rect(class, (x, y - 11.0), (12.0, 12.0)),
            }
            self.text("", (x + key.width(), y), &name);
            x += wide + GAP;
            if index == last {
                self.take(5.0);
            }
        }
    }
}
