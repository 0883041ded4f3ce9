//! MJCF: the models of MuJoCo.
//!
//! | element | becomes |
//! |---|---|
//! | `<body>` | a link; one without joints is part of its parent's link, its frame stays by its name |
//! | `<joint>` `hinge`, `slide` | a degree of freedom called like the joint, at MuJoCo's `qpos` (a `ref` is where it starts) |
//! | `ball`, `free`, `<freejoint>` | a ball or free joint |
//! | several joints of a body | one joint of several degrees of freedom where their anchors allow it, else joints in a row with massless links between them |
//! | `<inertial>`, or `<geom>`s by volume and density (or mass) | mass, centre of mass, inertia |
//! | the heaviest of the geoms | the link's shape, for drawing |
//! | `armature`, `damping`, `stiffness` with `springref`, `frictionloss` | what acts on the degree of freedom |
//! | `range` | limits of hinges and slides |
//! | `<site>` with a name | a frame |
//! | `<frame>`, `<default>`, `class`, `childclass`, `<compiler>` | are applied |
//! | `<include>`, `<model>` with `<attach>` | are followed by [`read_with`], which asks a [`Loader`] for files |
//! | `<replicate>` | is written out: the copies of `leaf` are `leaf0`, `leaf1` … |
//! | `<mesh>` in STL, OBJ, MSH or as corners | its solid, shell or hull, where a body's mass is that of its geoms |
//! | `<option gravity>` | gravity; MuJoCo's own default is (0, 0, −9.81) |
//! | `<option density viscosity wind>`, `fluidshape`, `gravcomp` | a [`Medium`] beside the figure |
//! | `<flag>` of springs, dampers, friction | are applied |
//!
//! Joints without a name are called `BODY_joint` (a free one `root`), bodies without one `bodyN` with MuJoCo's number; a
//! joint of several degrees of freedom is called like its body, a massless link in front of a body `BODY_JOINT` after the
//! last joint that moves it. What acts on bodies in MuJoCo and has no place in a figure is a finding of the kind
//! [`FindingKind::Missing`], once a kind: tendons and actuators with springs, dampers or armature, equalities, soft bodies,
//! meshes that were not read. `springdamper` sets spring and damper by the inertia that the joint feels, as in MuJoCo. Contacts, sensors and keyframes are listed by name; `<composite>` and `<flexcomp>` are
//! refused.
//!
//! MuJoCo's numbers for free and ball joints differ from ours: [`state_from_mujoco`] is the one place that converts them.

#![allow(clippy::doc_markdown, reason = "MuJoCo is a name, not code")]

mod acting;
mod actuators;
mod assembly;
mod bodies;
mod chain;
mod compiler;
mod defaults;
mod geom;
mod inertia;
mod joint;
mod medium;
mod mesh;
mod model;
mod orientation;
mod sections;
mod shell;
mod springs;
mod state;
mod ties;

pub use actuators::actuators;
pub use state::{StateError, forces_from_mujoco, forces_to_mujoco, state_from_mujoco, state_to_mujoco};
pub use ties::ties;

use crate::import::Import;
use crate::loader::{FilesError, Loader, NoFiles};
use crate::tree::{self, Body};
use crate::xml::{self, Reader, tag};
use assembly::Assembly;
use model::Model;
use sections::World;
use solaris_model::{Finding, FindingKind, Joint, Medium, Part, SourceMap, TextError};
use springs::Sprung;
use std::collections::HashMap;

/// Bodies may be nested as deep as memory allows: nothing here recurses.
const DEEPEST: usize = usize::MAX;

/// A model from the text of an MJCF file.
///
/// # Errors
///
/// [`TextError`] with every fault and its place.
///
/// # Examples
///
/// ```
/// let text = r#"
///     <mujoco model="pendulum">
///       <worldbody>
///         <body name="bob" pos="0 0 2">
///           <joint name="pivot" axis="0 1 0" range="-90 90" damping="0.1"/>
///           <geom type="capsule" fromto="0 0 0 0 0 -1" size="0.05"/>
///         </body>
///       </worldbody>
///     </mujoco>"#;
/// let import = solaris_io::mjcf::read(text)?;
/// assert_eq!(import.figure.layout().v_names(), ["pivot"]);
/// // 1000 kg/m³ · π · 0.05² · (1 + 4/3 · 0.05)
/// assert!((import.figure.mass() - 8.377_580).abs() < 1e-6);
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn read(text: &str) -> Result<Import, TextError> {
    let loaded = read_with(text, &mut NoFiles).map_err(|error| {
        let own = error.files.into_iter().next();
        own.map_or_else(|| TextError::one(text, 0..0, "it cannot be read"), |own| own.error)
    })?;
    let Loaded { mut import, medium } = loaded;
    if !medium.is_empty() {
        let message = "forces of the fluid and what carries bodies against gravity have no place in a figure";
        let (kind, subject) = (FindingKind::Missing, "<option>".to_owned());
        import.findings.push(Finding { kind, subject, message: message.to_owned(), place: None });
    }
    Ok(import)
}

/// A model with what acts on it besides its joints.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The figure and what there is to say about the model.
    pub import: Import,
    /// The fluid that it moves in, and what carries its bodies against gravity; mostly empty.
    pub medium: Medium,
}

/// A model from the text of an MJCF file and the files that it names, which `loader` opens: what `<include>` and `<attach>`
/// bring, and the meshes that bodies get their mass from.
///
/// # Errors
///
/// [`FilesError`] with every fault and its place in its file.
pub fn read_with(text: &str, loader: &mut dyn Loader) -> Result<Loaded, FilesError> {
    let assembly = Assembly::of(text, loader)?;
    let read = assembled(&assembly, loader, HashMap::new()).map_err(|error| assembly.error(error))?;
    let (mut loaded, sprung) = read;
    if !sprung.joints.is_empty() {
        // Once more, with what only the whole model tells.
        let found = springs::find(&loaded.import.figure, &sprung);
        (loaded, _) = assembled(&assembly, loader, found).map_err(|error| assembly.error(error))?;
    }
    assembly.place(&mut loaded.import.findings);
    Ok(loaded)
}

fn assembled(
    assembly: &Assembly,
    loader: &mut dyn Loader,
    sprung: HashMap<String, [f64; 2]>,
) -> Result<(Loaded, Sprung), TextError> {
    let text = assembly.text.as_ref();
    let document = xml::parse(text, DEEPEST)?;
    let root = document.root_element();
    let name = root.tag_name().name();
    if name != "mujoco" {
        let message = format!("the root element is <{name}>, not <mujoco>: this is no MJCF");
        return Err(TextError::one(text, tag(root), message));
    }
    let mut reader = Reader::new(text);
    let models = Model::all(&mut reader, root, assembly);
    // That of the main model holds for those that it attaches.
    let world = World { sprung, ..World::read(&mut reader, root) };
    for model in &models {
        reader.check_attributes(model.root, &["model"]);
        sections::read(&mut reader, model);
    }
    let mut places = SourceMap::default();
    places.put(Part::Figure, "", tag(root));
    let (mut bodies, acting, sprung) =
        bodies::read(&mut reader, &models, assembly, &world, &mut places, loader);
    if bodies.is_empty() {
        // As MuJoCo opens it: the parts that others include are models, too.
        let message = "it has no <body>, so that nothing can move: is it a part that another file includes?";
        reader.suspect(tag(root), "<mujoco>", message);
        bodies.push(Body::new("world", None, Joint::new("root"), tag(root)));
    }
    let name = root.attribute("model").filter(|name| !name.trim().is_empty()).unwrap_or("mujoco");
    let (figure, findings) = tree::finish(reader, name, bodies, places)?;
    let medium = acting.medium(&figure, &world);
    let import = Import { figure, findings, gravity: world.gravity, gravity_is_given: true };
    Ok((Loaded { import, medium }, sprung))
}
