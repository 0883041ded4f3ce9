//! Many small panels over one axis, two beside each other: a quantity each, of the left side and of the right one.

use crate::chart::{Axis, Key, Panel, Picture, path};
use crate::draw::Side;

/// Height of a panel (px), and of what stands over it.
const HEIGHT: f64 = 118.0;
const HEADING: f64 = 24.0;
/// Height of the numbers below it (px).
const NUMBERS: f64 = 20.0;
/// The most panels of a picture: more is for a table.
const MOST: usize = 40;

/// One curve.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    /// What it is of; a side in it gives the colour, and its two sides share a panel.
    pub(crate) name: String,
    /// In what.
    pub(crate) unit: String,
    /// One value for each place across.
    pub(crate) values: Vec<f64>,
    /// How far others are from it, where that is known.
    pub(crate) spread: Option<Vec<f64>>,
}

/// Curves of one name.
struct Small<'a> {
    name: String,
    lines: Vec<(Side, &'a Line)>,
}

/// Draws the curves over `places`, by name, in the order in which the names come; `caption` says what is across.
pub(crate) fn draw(picture: &mut Picture, caption: &str, places: &[f64], lines: &[Line]) {
    let mut all: Vec<Small<'_>> = Vec::new();
    for line in lines {
        let (side, name) = Side::split(&line.name);
        // The other side's, but never two of the same side.
        let fits = |small: &&mut Small<'_>| {
            small.name == name && small.lines.iter().all(|(other, of)| *other != side && of.unit == line.unit)
        };
        match all.iter_mut().find(fits) {
            Some(small) => small.lines.push((side, line)),
            None => all.push(Small { name, lines: vec![(side, line)] }),
        }
    }
    let sides = [(Side::Left, 0, "left"), (Side::Right, 1, "right"), (Side::Middle, 2, "middle")];
    let has = |side| all.iter().any(|small| small.lines.iter().any(|(of, _)| *of == side));
    if has(Side::Left) || has(Side::Right) {
        let there = sides.iter().filter(|(side, ..)| has(*side));
        picture.legend(&there.map(|(_, series, name)| Key::line(*series, *name)).collect::<Vec<_>>());
    }
    let across = Axis::around(places.iter().copied(), 4.0);
    for pair in all[..all.len().min(MOST)].chunks(2) {
        picture.take(HEADING);
        let axes = pair.iter().map(|small| (across.clone(), up(&small.lines))).collect::<Vec<_>>();
        // The last one alone is no wider than the others.
        let blank = (across.clone(), Axis::linear(0.0, 1.0, 1.0));
        let axes = axes.into_iter().chain(std::iter::once(blank)).take(2).collect();
        let panels = Panel::row(picture, HEIGHT, axes);
        picture.take(NUMBERS);
        for (panel, small) in panels.iter().zip(pair) {
            panel.heading(picture, &small.name.replace('_', " "), &small.lines[0].1.unit);
            panel.grid(picture);
            small.lines.iter().for_each(|(side, line)| curve(picture, panel, *side, places, line));
            panel.numbers(picture);
        }
    }
    picture.remark(caption, 1);
    if all.len() > MOST {
        picture.remark(&format!("and {} more, which a table holds", all.len() - MOST), 1);
    }
}

/// The axis that holds the curves and what is around them.
fn up(lines: &[(Side, &Line)]) -> Axis {
    let ends = lines.iter().flat_map(|(_, line)| {
        let spread =
            |i: usize| line.spread.as_ref().and_then(|spread| spread.get(i)).copied().unwrap_or_default();
        line.values.iter().enumerate().flat_map(move |(i, value)| [value - spread(i), value + spread(i)])
    });
    Axis::around(ends, 4.0).padded(0.06)
}

fn curve(picture: &mut Picture, panel: &Panel, side: Side, places: &[f64], line: &Line) {
    let series = match side {
        Side::Left => 0,
        Side::Right => 1,
        Side::Middle => 2,
    };
    if let Some(spread) = &line.spread {
        let edge = |sign: f64| {
            let ends = places.iter().zip(&line.values).zip(spread);
            ends.map(move |((place, value), spread)| (panel.x(*place), panel.y(value + sign * spread)))
                .collect::<Vec<_>>()
        };
        let around: Vec<_> = edge(1.0).into_iter().chain(edge(-1.0).into_iter().rev()).collect();
        picture.path(&format!("area f{series}"), &(path(&around) + "Z"));
    }
    panel.curve(picture, &format!("line s{series}"), places, &line.values);
}
