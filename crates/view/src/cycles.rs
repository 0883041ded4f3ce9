//! Means over strides, in percent of the stride, as a picture.

use crate::chart::Picture;
use crate::multiples::{self, Line};

/// The mean of a quantity over strides, and how far they spread.
#[derive(Clone, Debug, PartialEq)]
pub struct CycleCurve {
    /// What it is of; left and right of a name share a panel.
    pub name: String,
    /// In what.
    pub unit: String,
    /// Mean at even parts of the stride, from its begin to its end.
    pub mean: Vec<f64>,
    /// Standard deviation at the same parts.
    pub deviation: Vec<f64>,
}

/// Means over strides with one standard deviation around them, a small panel each, as an SVG.
///
/// The same numbers give the same text, byte for byte.
pub fn cycles(curves: &[CycleCurve], title: &str) -> String {
    let mut picture = Picture::new(title);
    let parts = curves.iter().map(|curve| curve.mean.len()).max().unwrap_or_default();
    let percent: Vec<f64> =
        (0..parts).map(|i| 100.0 * i as f64 / parts.saturating_sub(1).max(1) as f64).collect();
    let line = |curve: &CycleCurve| {
        let CycleCurve { name, unit, mean, deviation } = curve.clone();
        Line { name, unit, values: mean, spread: Some(deviation) }
    };
    let lines: Vec<Line> = curves.iter().map(line).collect();
    multiples::draw(
        &mut picture,
        "across: percent of the stride; areas: one standard deviation",
        &percent,
        &lines,
    );
    picture.finish()
}
