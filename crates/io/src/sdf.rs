//! SDF: the models and worlds of Gazebo, versions 1.4 to 1.12.
//!
//! | element | becomes |
//! |---|---|
//! | `<link>` with `<inertial>` | mass, centre of mass, inertia; without it 1 kg and 1 kg m² about every axis, as the format says. `auto="true"`: those of its collision shapes |
//! | `<joint>` `revolute`, `continuous`, `prismatic` | one degree of freedom called like the joint |
//! | `universal`, `revolute2` | two turns, `JOINT.axis` and `JOINT.axis2` |
//! | `screw` | a turn, and a slide `JOINT.slide` that follows it |
//! | `ball` | a ball joint |
//! | `fixed` | nothing: the child is part of its parent's link, its frame stays by the child's name |
//! | `<limit>`, `<dynamics>` | limits; damper, dry friction, spring |
//! | `<frame>`, nested `<model>`s | named frames; links called `MODEL::LINK` |
//! | `<include>` of a `model://` or relative URI | the model of that file, which a [`Loader`] opens |
//! | `<static>` | nothing that moves: left out beside models that do |
//! | a link that no joint holds | moved by a free joint, whose coordinates are its place in the world |
//! | the only `box`, `cylinder`, `sphere`, `capsule` or `ellipsoid` of the `<visual>`s, else of the `<collision>`s | the link's shape, for drawing |
//!
//! All poses are resolved: `relative_to`, `attached_to`, `expressed_in`, `placement_frame`, `degrees`, quaternions. A joint may
//! hold its parent by the child, where that one hangs on something else already. A joint that closes a loop, and a
//! `gearbox`, are left open, with a finding: their forces are missing.
//!
//! Gravity is the world's; a file that is no world has standard gravity along −z.

mod carriers;
mod frames;
mod geometry;
mod include;
mod joint;
mod link;
mod model;
mod pose;
mod solved;
mod spanning;
mod structure;
mod ties;

use crate::import::Import;
use crate::loader::{Loader, NoFiles};
use crate::tree;
use crate::xml::{self, Node, Reader, element, elements_called, tag};
use include::Files;
use model::{Contents, Context};
use solaris_model::{Part, SourceMap, TextError, Tie, Vector3};
use ties::Closing;

/// Deeper nesting than any model has.
const DEEPEST: usize = 200;
/// Standard gravity (m/s²), and what a world without a `<gravity>` has.
const GRAVITY: f64 = 9.80665;
const OF_WORLDS: f64 = 9.8;

/// A model, or the models of a world, from the text of an SDF file that names no other files.
///
/// # Errors
///
/// [`TextError`] with every fault and its place.
///
/// # Examples
///
/// ```
/// let text = r#"
///     <sdf version="1.9">
///       <model name="pendulum">
///         <link name="bob">
///           <pose>0 0 1 0 0 0</pose>
///           <inertial>
///             <pose>0 0 -0.5 0 0 0</pose>
///             <mass>2</mass>
///             <inertia> <ixx>0.01</ixx> <iyy>0.01</iyy> <izz>0.01</izz> </inertia>
///           </inertial>
///         </link>
///         <joint name="pivot" type="revolute">
///           <parent>world</parent> <child>bob</child>
///           <axis> <xyz>0 1 0</xyz> </axis>
///         </joint>
///       </model>
///     </sdf>"#;
/// let import = solaris_io::sdf::read(text)?;
/// assert_eq!(import.figure.layout().v_names(), ["pivot"]);
/// assert_eq!(import.figure.mass(), 2.0);
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn read(text: &str) -> Result<Import, TextError> {
    read_with(text, &mut NoFiles)
}

/// The same with the files that it includes, which `loader` opens.
///
/// # Errors
///
/// As for [`read`]; faults of another file stand where it is included, by its name and line.
pub fn read_with(text: &str, loader: &mut dyn Loader) -> Result<Import, TextError> {
    Ok(whole(text, loader)?.0)
}

/// What the joints hold together that close a loop, in the pose of the file: of a `ball` joint two points, of a `fixed` one the axes, too, of
/// a hinge two points of its axis, as two ties; others are [`TieLaw::Other`](solaris_model::TieLaw::Other). Limits, dampers and friction of
/// such joints are not in them.
///
/// # Errors
///
/// As for [`read_with`].
///
/// # Examples
///
/// ```
/// use solaris_io::{NoFiles, sdf};
/// use solaris_model::TieLaw;
///
/// let link = |name: &str| format!("<link name='{name}'/>");
/// let joint = |name: &str, kind: &str, parent: &str, child: &str| {
///     let axis = if kind == "ball" { "" } else { "<axis><xyz>0 1 0</xyz></axis>" };
///     format!("<joint name='{name}' type='{kind}'><parent>{parent}</parent><child>{child}</child>{axis}</joint>")
/// };
/// let parts = [link("a"), link("b"), joint("one", "revolute", "world", "a"), joint("two", "revolute", "world", "b"), joint("three", "ball", "a", "b")];
/// let found = sdf::ties(&format!("<sdf version='1.9'><model name='m'>{}</model></sdf>", parts.concat()), &mut NoFiles)?;
/// assert_eq!((found[0].name.as_str(), &found[0].law), ("three", &TieLaw::Points));
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn ties(text: &str, loader: &mut dyn Loader) -> Result<Vec<Tie>, TextError> {
    let (import, closings) = whole(text, loader)?;
    Ok(closings.into_iter().flat_map(|closing| closing.ties(&import.figure)).collect())
}

fn whole(text: &str, loader: &mut dyn Loader) -> Result<(Import, Vec<Closing>), TextError> {
    let text = &*xml::mended(text);
    let document = xml::parse(text, DEEPEST)?;
    let root = document.root_element();
    let version = version(text, root)?;
    let mut reader = Reader::new(text);
    reader.check_attributes(root, &["version"]);
    reader.check_elements(root, &["world", "model", "include"], &["actor", "light"]);
    let world = world(text, root)?;

    let mut contents = Contents::new(Files::new(loader));
    let context = Context::outer(version);
    let gravity = world.and_then(|world| gravity(&mut reader, world));
    match world {
        Some(world) => model::of_world(&mut reader, world, &mut contents, &context),
        None => model::of_root(&mut reader, root, &mut contents, &context),
    }
    let named = world.or_else(|| element(root, "model")).and_then(|node| node.attribute("name"));
    let top = structure::top(&contents);
    let name = top.map_or(named.unwrap_or("model"), |model| contents.frames.name(model)).to_owned();
    let mut places = SourceMap::default();
    places.put(Part::Figure, "", tag(root));
    let (bodies, closings) = structure::bodies(&mut reader, root, &contents, top, &mut places);
    let is_of_world = world.is_some();
    // Of large models, all that is no longer needed.
    drop((contents, document));
    let (figure, findings) = tree::finish(reader, &name, bodies, places)?;
    let standard = if is_of_world { OF_WORLDS } else { GRAVITY };
    let gravity_is_given = is_of_world;
    let gravity = gravity.unwrap_or_else(|| Vector3::new(0.0, 0.0, -standard));
    Ok((Import { figure, findings, gravity, gravity_is_given }, closings))
}

/// The second number of the version; 1.4 is the first that is read.
fn version(text: &str, root: Node) -> Result<u32, TextError> {
    let name = root.tag_name().name();
    if name != "sdf" {
        let message = format!("the root element is <{name}>, not <sdf>: this is no SDF");
        return Err(TextError::one(text, tag(root), message));
    }
    let said = root.attribute("version").unwrap_or_default().trim();
    let minor = said.strip_prefix("1.").and_then(|minor| minor.parse().ok());
    minor.filter(|minor| *minor >= 4).ok_or_else(|| {
        let message = format!(
            "its version is '{said}'; versions 1.4 and later are read: `gz sdf -p FILE > NEW.sdf` writes it in the newest one"
        );
        TextError::one(text, xml::value_span(root, "version"), message)
    })
}

/// The world, where there is one.
fn world<'a>(text: &str, root: Node<'a>) -> Result<Option<Node<'a>>, TextError> {
    let (worlds, models) = (elements_called(root, "world").count(), elements_called(root, "model").count());
    let includes = elements_called(root, "include").count();
    if worlds + models + includes == 1 {
        return Ok(element(root, "world"));
    }
    let message = format!(
        "<sdf> holds {worlds} worlds, {models} models and {includes} includes; one of them is read: keep one, or put the models into \
         one <world>"
    );
    Err(TextError::one(text, tag(root), message))
}

fn gravity(reader: &mut Reader, world: Node) -> Option<Vector3<f64>> {
    let numbers = reader.text_numbers(element(world, "gravity")?, 3..=3)?;
    Some(Vector3::from_row_slice(&numbers))
}
