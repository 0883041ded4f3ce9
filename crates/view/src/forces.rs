//! Forces of the ground over time, as a picture.

use crate::chart::{Axis, Key, Panel, Picture, SERIES};
use crate::draw::Side;
use solaris_model::{Contact, Vector3};

/// Height of a panel (px).
const HEIGHT: f64 = 190.0;

/// What the ground does to one foot, or is said to do.
#[derive(Clone, Copy, Debug)]
pub struct FootForces<'a> {
    /// What the foot is called.
    pub name: &'a str,
    /// When (s), rising.
    pub time: &'a [f64],
    /// The forces (N), world axes, one for each time.
    pub samples: &'a [Contact],
    /// Whether a plate measured them: drawn thin and dashed, in the colour of the foot of the same name, which comes before.
    pub is_measured: bool,
}

/// The forces (N) of feet over time, one panel for each of the `axes` (directions of length 1, world axes, with what they are
/// called), as an SVG. Of more than six feet the colours repeat.
///
/// The same forces give the same text, byte for byte.
pub fn forces(feet: &[FootForces<'_>], axes: &[(&str, Vector3<f64>)], title: &str) -> String {
    let mut picture = Picture::new(title);
    draw(&mut picture, feet, axes);
    picture.finish()
}

/// The same below what a picture holds already.
pub(crate) fn draw(picture: &mut Picture, feet: &[FootForces<'_>], axes: &[(&str, Vector3<f64>)]) {
    let mut names: Vec<&str> = Vec::new();
    for foot in feet {
        if !names.contains(&foot.name) {
            names.push(foot.name);
        }
    }
    // As everywhere the left one is blue.
    let one_a_side = match names[..] {
        [one] => side(one) != Side::Middle,
        [one, other] => side(one) != side(other) && ![one, other].map(side).contains(&Side::Middle),
        _ => false,
    };
    let class = |foot: &FootForces<'_>| {
        let series = names.iter().position(|name| *name == foot.name).unwrap_or_default() % SERIES;
        let series = if one_a_side { usize::from(side(foot.name) == Side::Right) } else { series };
        if foot.is_measured { format!("thin s{series}") } else { format!("line s{series}") }
    };
    let name = |foot: &FootForces<'_>| {
        if foot.is_measured { format!("{}, plate", foot.name) } else { foot.name.to_owned() }
    };
    picture.legend(&feet.iter().map(|foot| Key::stroke(class(foot), name(foot))).collect::<Vec<Key>>());
    let columns: Vec<Vec<Vec<f64>>> = axes
        .iter()
        .map(|(_, axis)| {
            let along =
                |foot: &FootForces<'_>| foot.samples.iter().map(|contact| contact.force.dot(axis)).collect();
            feet.iter().map(along).collect()
        })
        .collect();
    let up: Vec<Axis> =
        columns.iter().map(|feet| Axis::around(feet.iter().flatten().copied(), 5.0).padded(0.06)).collect();
    let left = Panel::left_of(&up);
    let time = Axis::around(feet.iter().flat_map(|foot| foot.time.iter().copied()), 8.0);
    for (((name, _), up), columns) in axes.iter().zip(up).zip(&columns) {
        picture.heading(&format!("{name} (N)"));
        let panel = Panel::from_left(picture, left, HEIGHT, time.clone(), up);
        panel.grid(picture);
        for (foot, values) in feet.iter().zip(columns) {
            panel.curve(picture, &class(foot), foot.time, values);
        }
        panel.foot(picture, "time (s)");
    }
}

/// The side of a foot, which may be called by it alone.
fn side(name: &str) -> Side {
    match name {
        "left" => Side::Left,
        "right" => Side::Right,
        _ => Side::split(name).0,
    }
}
