//! Models and external loads of OpenSim.
//!
//! [`read`] takes a model (`.osim`) of any version that OpenSim 4 opens (from 10901 on), and makes a figure of its bodies and joints:
//!
//! | element | becomes |
//! |---|---|
//! | `Body` | a link, or a frame of that name where it is welded to another |
//! | `PhysicalOffsetFrame`, `StationDefinedFrame`, `location_in_parent` … | placements; orientations are body-fixed x-y-z angles |
//! | `PinJoint` | a rotation about z |
//! | `SliderJoint` | a slide along x |
//! | `WeldJoint` | nothing: its bodies are one link |
//! | `UniversalJoint` | rotations about x, then y |
//! | `BallJoint`, `GimbalJoint` | rotations about x, then y, then z, named by their coordinates |
//! | `PlanarJoint` | slides along x and y, then a rotation about z |
//! | `FreeJoint` | slides along x, y, z, then rotations about x, y, z |
//! | `CustomJoint` | its translations along axes of the parent's frame, then its three rotations about axes that turn along |
//! | `EllipsoidJoint` | slides and turns that follow its three angles, so that its child glides on the ellipsoid |
//! | `ScapulothoracicJoint` | the same, then a turn about the winging axis |
//! | a body without a joint | a `FreeJoint` to ground, as in OpenSim |
//! | `CoordinateCouplerConstraint` | the dependent coordinate follows the independent one |
//!
//! A degree of freedom has the name of its coordinate. An axis that a coordinate drives by any other function than itself
//! is a degree of freedom that **follows** the coordinate (see [`solaris_model::Follower`]), named `JOINT.tx …`: that is
//! how a knee's centre moves as it bends, with both derivatives. Where a coordinate drives no axis one to one (a kneecap's),
//! it is itself a part of the first axis that it drives, and what the function adds follows it:
//!
//! ```text
//! R(a, f(x)) = R(a, x)·R(a, f(x) − x)
//! ```
//!
//! Functions of a coordinate that a constraint makes a function of another are both, one after the other. Functions are
//! `Constant`, `LinearFunction`, `PolynomialFunction`, `PiecewiseLinearFunction`, `SimmSpline` (`NaturalCubicSpline`),
//! `GCVSpline` of degree 3 and 5 without smoothing, `Sine`, and any of these in a `MultiplierFunction`; all are kept
//! exactly.
//!
//! The world is the model's ground: y up, x forward, z to the right. A link's frame has the directions of its body's
//! frame and its origin at the joint; where that is not the body's origin, the body's frame stays by its name.
//!
//! Muscles, actuators, other forces and constraints, controllers, wrapping and geometry are listed, not read.
//!
//! [`rescale`] scales the text of a model to a subject, by the rules of OpenSim's `ScaleTool`.
//!
//! [`external_loads`] reads which columns of a table are forces on which bodies, [`markers`] the markers of a model or of a file
//! of their own, [`ik_setup`] and [`scale_setup`] what OpenSim's tools for markers are told.

mod axes;
mod component;
mod coordinate;
mod couplers;
mod curves;
mod custom;
mod defaults;
mod element;
mod ellipsoid;
mod frames;
mod function;
mod joint;
mod layout;
mod loads;
mod marker_set;
mod mount;
mod older;
mod quintic;
mod rescale;
mod rest;
mod setup;
mod spline;
mod station;

pub use defaults::coordinate_defaults;
pub use loads::{ExternalForce, ExternalLoads, external_loads};
pub use marker_set::{MarkerSet, markers};
pub use rescale::{MarkerPlace, Rescaling, rescale};
pub use setup::{
    BodyAxes, CoordinateTask, IkSetup, ManualScale, MarkerTask, Measurement, PlacerSetup, ScaleSetup,
    ScalingStep, TaskValue, ik_setup, scale_setup,
};

use crate::import::Import;
use crate::tree::finish;
use crate::xml::{self, Node, Reader};
use element::words;
use solaris_model::{TextError, Vector3};

/// How deep elements may be nested.
const DEEPEST: usize = 100;

/// Reads an OpenSim model.
///
/// # Errors
///
/// [`TextError`] with every fault that was found and its place: text that is no XML, a version that cannot be read, frames and
/// coordinates that are not there, joints and functions that cannot be kept, bodies that no mass distribution has.
///
/// # Examples
///
/// ```
/// let text = r#"<OpenSimDocument Version="40000"><Model name="swing">
///   <BodySet><objects><Body name="rod">
///     <mass>2</mass><mass_center>0 -0.5 0</mass_center><inertia>0.1 0.01 0.1 0 0 0</inertia>
///   </Body></objects></BodySet>
///   <JointSet><objects><PinJoint name="pivot">
///     <socket_parent_frame>/ground</socket_parent_frame>
///     <socket_child_frame>/bodyset/rod</socket_child_frame>
///     <coordinates><Coordinate name="angle" /></coordinates>
///   </PinJoint></objects></JointSet>
/// </Model></OpenSimDocument>"#;
/// let import = solaris_io::opensim::read(text)?;
/// assert_eq!(import.figure.layout().q_names(), ["angle"]);
/// assert_eq!((import.gravity.y, import.gravity_is_given), (-9.80665, false));
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn read(text: &str) -> Result<Import, TextError> {
    let strict = xml::mended(text);
    let document = xml::parse(&strict, DEEPEST)?;
    let (model, version) = model_of(&document, text)?;
    let mut reader = Reader::new(text);
    let gravity = gravity(&mut reader, model);
    let layout = if version < FIRST_WITH_JOINTS {
        older::read(&mut reader, model)
    } else {
        layout::read(&mut reader, model)
    };
    let tree = layout.tree(&mut reader, model);
    rest::list(&mut reader, model);
    // What hangs on an unreadable joint, or on nothing, would be at fault for that alone.
    if !tree.whole {
        reader.error().map_or(Ok(()), Err)?;
    }
    let name = model.attribute("name").unwrap_or("model").to_owned();
    // Of large models, all that is no longer needed.
    drop(layout);
    drop(document);
    let (figure, findings) = finish(reader, &name, tree.bodies, tree.places)?;
    let gravity_is_given = gravity.is_some();
    let gravity = gravity.unwrap_or_else(|| Vector3::new(0.0, -9.80665, 0.0));
    Ok(Import { figure, findings, gravity, gravity_is_given })
}

/// The first version that is read; what OpenSim 4 itself refuses is older.
const FIRST: u32 = 10_901;
/// The first version with joints of their own; before, bodies hold their joints.
const FIRST_WITH_JOINTS: u32 = 30_501;

/// The model of a document and the document's version.
fn model_of<'a>(document: &'a roxmltree::Document<'a>, text: &str) -> Result<(Node<'a>, u32), TextError> {
    let root = document.root_element();
    let refuse = |node: Node, message: String| Err(TextError::one(text, xml::tag(node), message));
    let name = root.tag_name().name();
    if name != "OpenSimDocument" {
        return refuse(
            root,
            format!("the root element is <{name}>; a model of OpenSim is an <OpenSimDocument>"),
        );
    }
    let Some(model) = xml::element(root, "Model") else {
        let found = xml::elements(root).next().map_or("nothing", |child| child.tag_name().name());
        return refuse(root, format!("the document holds <{found}>, and no <Model>"));
    };
    let told = root.attribute("Version").unwrap_or_default();
    let Ok(version) = told.trim().parse::<u32>() else {
        return refuse(
            root,
            format!("the version is '{}', which is no number such as 40000", xml::shown(told)),
        );
    };
    if version >= FIRST {
        return Ok((model, version));
    }
    let message = format!(
        "documents of version {version} are not read, nor by OpenSim 4; open and save it in OpenSim 3.3, which is free"
    );
    refuse(root, message)
}

/// The gravity that the file gives.
fn gravity(reader: &mut Reader, model: Node) -> Option<Vector3<f64>> {
    let node = xml::element(model, "gravity").filter(|node| !words(*node).is_empty())?;
    let numbers = reader.text_numbers(node, 3..=3)?;
    Some(Vector3::new(numbers[0], numbers[1], numbers[2]))
}
