//! `<compiler>`: what the numbers of the file mean.

use crate::xml::{Node, Reader, elements_called, value_span};
use std::ops::Range;

/// Where a body's mass comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FromGeoms {
    /// From `<inertial>`, which all moving bodies have.
    Never,
    /// From `<inertial>` where there is one.
    Auto,
    /// Always from the geoms.
    Always,
}

/// The settings that change what a figure becomes.
pub(super) struct Compiler {
    /// In one unit of angle of the file (rad).
    pub(super) angle: f64,
    /// The axes of `euler`, as characters x y z (moving) or X Y Z (fixed).
    pub(super) euler: [char; 3],
    pub(super) autolimits: bool,
    pub(super) from_geoms: FromGeoms,
    /// First and last group of the geoms that have mass.
    pub(super) groups: (f64, f64),
    pub(super) balance: bool,
    pub(super) least_mass: f64,
    pub(super) least_inertia: f64,
    /// The mass of all bodies together and where it is said.
    pub(super) total: Option<(f64, Range<usize>)>,
}

const SETTINGS: [&str; 20] = [
    "meshdir",
    "texturedir",
    "assetdir",
    "strippath",
    "discardvisual",
    "usethread",
    "convexhull",
    "fitaabb",
    "exactmeshinertia",
    "saveinertial",
    "savecanonical",
    "savecompiled",
    "conflict",
    "fusestatic",
    "passthrough",
    "angle",
    "autolimits",
    "coordinate",
    "lengthrange",
    "eulerseq",
];

impl Compiler {
    pub(super) fn read(reader: &mut Reader, root: Node) -> Self {
        let degree = 1.0_f64.to_radians();
        let mut compiler = Self {
            angle: degree,
            euler: ['x', 'y', 'z'],
            autolimits: true,
            from_geoms: FromGeoms::Auto,
            groups: (0.0, 5.0),
            balance: false,
            least_mass: 0.0,
            least_inertia: 0.0,
            total: None,
        };
        let switch = [("true", true), ("false", false)];
        // Later elements win, attribute by attribute.
        for node in elements_called(root, "compiler") {
            let known = [
                "inertiafromgeom",
                "inertiagrouprange",
                "balanceinertia",
                "boundmass",
                "boundinertia",
                "settotalmass",
            ];
            reader.check_attributes_but(node, &[known.as_slice(), &SETTINGS[15..]].concat(), &SETTINGS);
            if let Some(angle) = reader.choice(node, "angle", &[("degree", degree), ("radian", 1.0)]) {
                compiler.angle = angle;
            }
            if node.attribute("coordinate").is_some_and(|kind| kind != "local") {
                let message = "only local coordinates are read, as by MuJoCo since 2.3.4; MuJoCo 2.3.3 converts such a file";
                reader.fault(value_span(node, "coordinate"), message);
            }
            compiler.read_euler(reader, node);
            let set = |reader: &mut Reader, name, value: &mut bool| {
                *value = reader.choice(node, name, &switch).unwrap_or(*value);
            };
            set(reader, "autolimits", &mut compiler.autolimits);
            set(reader, "balanceinertia", &mut compiler.balance);
            let modes = [("false", FromGeoms::Never), ("auto", FromGeoms::Auto), ("true", FromGeoms::Always)];
            compiler.from_geoms =
                reader.choice(node, "inertiafromgeom", &modes).unwrap_or(compiler.from_geoms);
            if let Some([first, last]) = reader.numbers(node, "inertiagrouprange") {
                compiler.groups = (first, last);
            }
            compiler.least_mass = reader.number(node, "boundmass").unwrap_or(compiler.least_mass);
            compiler.least_inertia = reader.number(node, "boundinertia").unwrap_or(compiler.least_inertia);
            if let Some(total) = reader.number(node, "settotalmass") {
                compiler.total = (total > 0.0).then(|| (total, value_span(node, "settotalmass")));
            }
        }
        compiler
    }

    fn read_euler(&mut self, reader: &mut Reader, node: Node) {
        let Some(sequence) = node.attribute("eulerseq") else { return };
        let axes: Vec<char> = sequence.chars().collect();
        match axes.as_slice() {
            [a, b, c] if axes.iter().all(|axis| "xyzXYZ".contains(*axis)) => self.euler = [*a, *b, *c],
            _ => reader.fault(
                value_span(node, "eulerseq"),
                format!("'eulerseq' is '{sequence}'; it must be three of x, y, z (moving axes) or X, Y, Z (fixed axes)"),
            ),
        }
    }
}
