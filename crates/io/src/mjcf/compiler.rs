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

/// What the names and triangles of meshes mean.
#[derive(Default)]
pub(super) struct MeshSettings {
    /// Where they are, from the model's folder.
    pub(super) folder: String,
    /// Whether the folders in the names of files are left out.
    pub(super) strip_path: bool,
    /// Whether they are closed surfaces, as MuJoCo before 3.3 said for all of them.
    pub(super) exact: bool,
    /// Whether solids are fitted to the box of a mesh, not to its inertia.
    pub(super) fit_box: bool,
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
    pub(super) meshes: MeshSettings,
    /// The mass of all bodies together and where it is said.
    pub(super) total: Option<(f64, Range<usize>)>,
}

const SETTINGS: [&str; 15] = [
    "texturedir",
    "discardvisual",
    "usethread",
    "convexhull",
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
            meshes: MeshSettings::default(),
            total: None,
        };
        let (mut mesh_folder, mut asset_folder) = (None, None);
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
                "meshdir",
                "assetdir",
                "strippath",
                "fitaabb",
                "alignfree",
                "exactmeshinertia",
            ];
            reader.check_attributes_but(node, &[known.as_slice(), &SETTINGS[10..]].concat(), &SETTINGS);
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
            set(reader, "strippath", &mut compiler.meshes.strip_path);
            set(reader, "exactmeshinertia", &mut compiler.meshes.exact);
            set(reader, "fitaabb", &mut compiler.meshes.fit_box);
            mesh_folder = node.attribute("meshdir").or(mesh_folder);
            asset_folder = node.attribute("assetdir").or(asset_folder);
            if node.attribute("alignfree") == Some("true") {
                let message = "it is not applied: they move the body's own frame here, that of its inertia in MuJoCo, so that the \
                               same numbers are other places";
                reader.lacks(
                    "'alignfree' of free joints",
                    message,
                    value_span(node, "alignfree"),
                    "<compiler>",
                );
            }
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
        let folder = mesh_folder.or(asset_folder).unwrap_or_default();
        folder.clone_into(&mut compiler.meshes.folder);
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
