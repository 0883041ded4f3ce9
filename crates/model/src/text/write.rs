//! The writer of figures: a text that people like to read.

mod joint;
mod link;
mod number;

use super::read::VERSION;
use crate::figure::Figure;
use number::tuple;
use solaris_text::layout::{Doc, field, group, number, quoted};

const HEADER: &str = "\
// A figure. Lengths are in m, masses in kg, inertias in kg m², angles in rad or, as deg(30), in degrees.
// The axes of a joint act in their order, the first nearest to the parent: rx ry rz turn about x y z, tx ty tz slide.
// Inertia: (xx, yy, zz) or (xx, yy, zz, xy, xz, yz), about the centre of mass `com`, along the link's axes.
";

/// The text of a figure.
pub(super) fn write(figure: &Figure) -> String {
    let mut text = HEADER.to_owned();
    text.push_str("Figure(\n");
    let mut line = |field: Doc| {
        text.push_str("    ");
        field.print(4, 1, &mut text);
        text.push_str(",\n");
    };
    line(field("version", Doc::Atom(VERSION.to_string())));
    line(field("name", Doc::Atom(quoted(&figure.name))));
    if let Some(stature) = figure.stature {
        line(field("stature", Doc::Atom(number(stature))));
    }
    if let Some(gravity) = figure.gravity {
        line(field("gravity", tuple(gravity.as_slice())));
    }
    text.push_str("    links: [\n");
    for (i, link) in figure.links.iter().enumerate() {
        if i > 0 {
            text.push('\n');
        }
        text.push_str("        ");
        link::link(figure, link).print_broken(8, &mut text);
        text.push_str(",\n");
    }
    text.push_str("    ],\n");
    if !figure.angles.is_empty() {
        text.push_str("    // Angles as anatomists sign them; those with a minus are the degree of freedom taken negative.\n");
        text.push_str("    angles: ");
        let names = figure.layout.v_names();
        let entries = figure.angles.iter().map(|angle| {
            let dof = &names[angle.dof];
            let sign = match (angle.sign < 0.0, dof.starts_with(['-', '+'])) {
                (true, _) => "-",
                // A name that begins with a sign must not be taken for one.
                (false, true) => "+",
                (false, false) => "",
            };
            field(&quoted(&angle.name), Doc::Atom(quoted(&format!("{sign}{dof}"))))
        });
        group("{", entries.collect(), "}").print_broken(4, &mut text);
        text.push_str(",\n");
    }
    text.push_str(")\n");
    text
}
