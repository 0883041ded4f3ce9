//! Joint moments over time, with the ground's forces below them, as a picture.

use crate::chart::Picture;
use crate::forces::{self, FootForces};
use crate::multiples::{self, Line};
use solaris_model::Vector3;

/// What a degree of freedom needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Effort {
    /// The degree of freedom; left and right of a name share a panel.
    pub name: String,
    /// `N m` or `N`.
    pub unit: String,
    /// One value a time.
    pub values: Vec<f64>,
    /// Two standard errors of each value, where they are known: half the width of an area around the line.
    pub spread: Option<Vec<f64>>,
}

/// Joint moments (and forces, of joints that slide) over `time` (s), a small panel each, then the forces of `feet` along `axes` as
/// [`forces`](crate::forces()) draws them, as an SVG.
///
/// The same numbers give the same text, byte for byte.
pub fn efforts(
    time: &[f64],
    efforts: &[Effort],
    feet: &[FootForces<'_>],
    axes: &[(&str, Vector3<f64>)],
    title: &str,
) -> String {
    let mut picture = Picture::new(title);
    let line = |effort: &Effort| {
        let Effort { name, unit, values, spread } = effort.clone();
        Line { name, unit, values, spread }
    };
    let lines: Vec<Line> = efforts.iter().map(line).collect();
    let has_areas = lines.iter().any(|line| line.spread.is_some());
    let caption = if has_areas { "across: time (s); areas: two standard errors" } else { "across: time (s)" };
    multiples::draw(&mut picture, caption, time, &lines);
    if !feet.is_empty() {
        picture.take(8.0);
        forces::draw(&mut picture, feet, axes);
    }
    picture.finish()
}
