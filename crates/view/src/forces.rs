//! Forces of the ground over time, as a picture.

use crate::over_time::{BELOW, COLORS, Curve, LEFT, PANEL, TOP, begin, panel};
use solaris_model::{Contact, Vector3};
use std::fmt::Write as _;

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
    let mut svg = begin(title, axes.len().max(1));
    let mut names: Vec<&str> = Vec::new();
    for foot in feet {
        if !names.contains(&foot.name) {
            names.push(foot.name);
        }
    }
    for (index, (name, axis)) in axes.iter().enumerate() {
        let curves = feet.iter().map(|foot| {
            let color = names.iter().position(|name| *name == foot.name).unwrap_or_default();
            Curve {
                name: if foot.is_measured { "plate" } else { foot.name },
                time: foot.time,
                values: foot.samples.iter().map(|contact| contact.force.dot(axis)).collect(),
                color: COLORS[color % COLORS.len()],
                thin: foot.is_measured,
            }
        });
        let top = TOP + index as f64 * (PANEL.1 + BELOW);
        let _ = writeln!(svg, "<g transform=\"translate({LEFT} {top})\">");
        panel(&mut svg, &format!("{name} (N)"), &curves.collect::<Vec<_>>(), &[]);
        svg.push_str("</g>\n");
    }
    svg.push_str("</svg>\n");
    svg
}
