//! URDF: the robots of ROS.
//!
//! | element | becomes |
//! |---|---|
//! | `<link>` with `<inertial>` | mass, centre of mass, inertia about it (turned by the origin's `rpy`) |
//! | `<joint>` `revolute`, `continuous`, `prismatic` | one degree of freedom called like the joint |
//! | `floating` | a free joint |
//! | `planar` | two slides and a turn about the axis, in this order |
//! | `fixed` | nothing: the child is part of its parent's link, its frame stays by the child's name |
//! | `<limit lower upper>` | limits; those of a `continuous` joint are listed as not read |
//! | `<dynamics damping friction>` | damper and dry friction |
//! | `<mimic>` | a note: the joint stays a degree of freedom of its own |
//! | the first `box`, `cylinder`, `sphere` or `capsule` of `<visual>`, else of `<collision>` | the link's shape, for drawing |
//!
//! The root link is welded to the world; gravity is not in the file and points along −z. Angles are in rad, lengths in m,
//! as everywhere in URDF. Meshes, materials, transmissions, sensors, `effort`, `velocity` and all other elements and
//! attributes are listed in [`Import::findings`] by name. Xacro is not expanded.

mod actuators;
mod geometry;
mod joint;
mod link;
mod structure;

pub use actuators::actuators;

use crate::import::Import;
use crate::tree;
use crate::xml::{self, Node, Reader, elements_called, tag};
use solaris_model::{Placement, SourceMap, TextError, UnitQuaternion, Vector3};

/// Deeper nesting than any URDF's own elements have; what stands inside of extensions counts too.
const DEEPEST: usize = 1000;
/// Standard gravity (m/s²).
const GRAVITY: f64 = 9.80665;

/// A robot from the text of a URDF.
///
/// # Errors
///
/// [`TextError`] with every fault and its place: what is no XML, missing or unreadable attributes, names that are used twice or
/// not at all, links that form no tree, and what no figure can be (see [`solaris_model::Fault`]).
///
/// # Examples
///
/// ```
/// let text = r#"
///     <robot name="pendulum">
///       <link name="base"/>
///       <link name="bob">
///         <inertial>
///           <origin xyz="0 0 -0.5"/>
///           <mass value="2"/>
///           <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
///         </inertial>
///       </link>
///       <joint name="pivot" type="continuous">
///         <parent link="base"/> <child link="bob"/> <axis xyz="0 1 0"/>
///       </joint>
///     </robot>"#;
/// let import = solaris_io::urdf::read(text)?;
/// assert_eq!(import.figure.layout().v_names(), ["pivot"]);
/// assert_eq!(import.figure.mass(), 2.0);
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn read(text: &str) -> Result<Import, TextError> {
    let text = &*xml::mended(text);
    let document = xml::parse(text, DEEPEST)?;
    let root = document.root_element();
    let mut reader = Reader::new(text);
    let name = root.tag_name().name();
    if name != "robot" {
        let message = format!("the root element is <{name}>, not <robot>: this is no URDF");
        return Err(TextError::one(text, tag(root), message));
    }
    refuse_xacro(text, root)?;
    if let Some(link) = elements_called(root, "link").nth(tree::MOST_BODIES) {
        let message = format!("there are more than {} links, the most that are read", tree::MOST_BODIES);
        return Err(TextError::one(text, tag(link), message));
    }
    reader.check_attributes(root, &["name", "version"]);
    reader.check_elements(root, &["link", "joint"], &["material"]);
    if root.attribute("name").is_none() {
        reader.suspect(tag(root), "robot", "<robot> has no attribute 'name'; the figure is called 'robot'");
    }
    let name = root.attribute("name").unwrap_or("robot").to_owned();

    let links = elements_called(root, "link").map(|node| link::read(&mut reader, node)).collect();
    let joints: Vec<_> = elements_called(root, "joint").map(|node| joint::read(&mut reader, node)).collect();
    let mut places = SourceMap::default();
    places.put(solaris_model::Part::Figure, "", tag(root));
    let bodies = structure::bodies(&mut reader, root, links, &joints, &mut places);
    // Of large models, all that is no longer needed.
    drop((joints, document));
    let (figure, findings) = tree::finish(reader, &name, bodies, places)?;
    let gravity = Vector3::new(0.0, 0.0, -GRAVITY);
    Ok(Import { figure, findings, gravity, gravity_is_given: false })
}

/// A file that xacro has yet to expand is refused as a whole: everything else would be a consequence.
fn refuse_xacro(text: &str, root: Node) -> Result<(), TextError> {
    let advice = "this file holds xacro, which is not expanded here: run `xacro FILE -o robot.urdf` (with ROS 2 `ros2 run xacro xacro \
                  FILE -o robot.urdf`) and read robot.urdf";
    for node in root.descendants().filter(Node::is_element) {
        if node.tag_name().namespace().is_some_and(|uri| uri.contains("xacro")) {
            return Err(TextError::one(text, tag(node), advice));
        }
        if let Some(attribute) = node
            .attributes()
            .find(|attribute| ["${", "$("].iter().any(|word| attribute.value().contains(word)))
        {
            return Err(TextError::one(text, attribute.range_value(), advice));
        }
    }
    Ok(())
}

/// The `<origin xyz rpy>` of an element.
///
/// ```text
/// R = Rz(yaw)·Ry(pitch)·Rx(roll)
/// ```
fn origin(reader: &mut Reader, node: Node) -> Placement {
    let Some(origin) = xml::element(node, "origin") else { return Placement::identity() };
    reader.check_attributes(origin, &["xyz", "rpy"]);
    let [x, y, z] = reader.numbers(origin, "xyz").unwrap_or_default();
    let [roll, pitch, yaw] = reader.numbers(origin, "rpy").unwrap_or_default();
    let turn = if [roll, pitch, yaw].iter().all(|angle| *angle == 0.0) {
        UnitQuaternion::identity()
    } else {
        UnitQuaternion::from_euler_angles(roll, pitch, yaw)
    };
    Placement::from_parts(Vector3::new(x, y, z).into(), turn)
}
