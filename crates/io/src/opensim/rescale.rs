//! The text of a model, scaled to a subject.

mod bodies;
mod drives;
mod edits;
mod lengths;
mod markers;
mod masses;
mod paths;
mod wraps;

pub use markers::MarkerPlace;

use super::couplers::COUPLER;
use super::element::{child_flag, child_words};
use super::{DEEPEST, model_of};
use crate::xml::{self, Node, Reader, tag};
use bodies::Bodies;
use edits::Edits;
use paths::{Length, Pose};
use solaris_model::{Finding, MassShares, TextError, Vector3};
use std::collections::{HashMap, HashSet};

/// What [`rescale`] makes of a model.
#[derive(Clone, Debug, Default, PartialEq)]
#[doc(alias = "ScaleSet")]
pub struct Rescaling {
    /// Factors of bodies (and of `ground`) by name, along their own x, y and z; bodies that are not named stay as they are.
    /// Names that are no body's are passed over where their factors are one.
    pub factors: Vec<(String, Vector3<f64>)>,
    /// Total mass (kg); without one it is what the masses add up to.
    pub mass: Option<f64>,
    /// How the mass is shared out.
    pub shares: MassShares,
    /// Markers with places of their own, which may be new; the others go with their bodies.
    pub markers: Vec<MarkerPlace>,
    /// The names of markers that go.
    pub removed: Vec<String>,
}

/// The text of a model of OpenSim (of any version that [`read`](super::read) takes), scaled by the rules of `ScaleTool`.
///
/// Only numbers change, and they alone that do: every other byte of the text stays, comments and muscles' properties with them.
///
/// | element | with `s` the factors of the body that it is fixed to |
/// |---|---|
/// | `mass_center`, offset frames, stations, markers, points of paths, wrap objects | places elementwise times `s`; no orientation |
/// | functions of moving points | times `s` of their axis |
/// | translations of a `CustomJoint`, unless they are their coordinate | times `Σ\|u_i\|·s_i` of the parent, with the axis `u` |
/// | coordinates that slide and are coupled | the same |
/// | radii of an `EllipsoidJoint` or `ScapulothoracicJoint` | elementwise times `s` of the parent |
/// | wrap objects' sizes, `scale_factors` of what is attached | by how much longer their own axes become |
/// | `mass` | its share, or times `s_x·s_y·s_z`, then all to the total |
/// | `inertia` | [`solaris_model::stretched_inertia`] |
/// | fibres, tendons, springs at rest | as the path becomes longer in the default pose, where it touches no wrap object and the model has no constraints but couplers of two coordinates |
///
/// A function gets a `MultiplierFunction` around it, as OpenSim writes it. The findings say which muscles and springs kept their
/// lengths, and what OpenSim does not scale either.
///
/// # Source
///
/// `Model::scale` of OpenSim 4.6 and the `extendScale` of its components.
///
/// # Errors
///
/// [`TextError`] with every fault: text that is no model, factors and masses that are none, names of no body or marker, numbers
/// that cannot be read.
///
/// # Examples
///
/// ```
/// use solaris_io::opensim::{Rescaling, rescale};
/// use solaris_model::Vector3;
/// let text = r#"<OpenSimDocument Version="40000"><Model><BodySet><objects>
///   <Body name="rod"><mass>2</mass><!-- of wood --><mass_center>0 -0.5 0</mass_center></Body>
/// </objects></BodySet></Model></OpenSimDocument>"#;
/// let factors = vec![("rod".to_owned(), Vector3::new(1.0, 1.5, 1.0))];
/// let (scaled, _) = rescale(text, &Rescaling { factors, mass: Some(3.0), ..Rescaling::default() })?;
/// assert!(scaled.contains("<mass>3</mass><!-- of wood --><mass_center>0 -0.75 0</mass_center>"));
/// # Ok::<(), solaris_model::TextError>(())
/// ```
#[doc(alias = "ScaleTool")]
pub fn rescale(text: &str, rescaling: &Rescaling) -> Result<(String, Vec<Finding>), TextError> {
    let strict = xml::mended(text);
    let document = xml::parse(&strict, DEEPEST)?;
    let (model, version) = model_of(&document, text)?;
    let mut reader = Reader::new(text);
    let mut bodies = Bodies::of(&mut reader, model, version);
    bodies.scale(&mut reader, rescaling);
    reader.error().map_or(Ok(()), Err)?;
    let mut edits = Edits::default();
    masses::scale(&mut edits, &mut reader, &bodies, rescaling);
    let placed: HashSet<&str> = rescaling.markers.iter().map(|marker| marker.name.as_str()).collect();
    let moved: HashSet<&str> =
        placed.into_iter().chain(rescaling.removed.iter().map(String::as_str)).collect();
    for node in parts(model) {
        lengths::scale(&mut edits, &mut reader, &mut bodies, node, |name| moved.contains(name));
        drives::scale(&mut edits, &mut reader, &mut bodies, node);
    }
    reader.error().map_or(Ok(()), Err)?;
    let scaled = edits.applied(text);
    let (frames, after) = measured(&scaled)?;
    markers::place(&mut edits, &mut reader, &bodies, rescaling, &frames);
    let before = path_lengths(&mut reader, &mut bodies, text);
    paths::scale(&mut edits, &mut reader, model, &before, &after);
    unscaled(&mut reader, model);
    reader.error().map_or_else(|| Ok((edits.applied(text), reader.findings())), Err)
}

/// The elements of a model but for those that stand for what others leave out.
fn parts(model: Node<'_>) -> impl Iterator<Item = Node<'_>> {
    let is_default = |node: &Node| node.ancestors().any(|above| above.has_tag_name("defaults"));
    model.descendants().filter(move |node| node.is_element() && !is_default(node))
}

/// Of the scaled text, the frames of its markers and the lengths of its paths.
fn measured(scaled: &str) -> Result<(HashMap<String, markers::Frame>, Vec<Length>), TextError> {
    let strict = xml::mended(scaled);
    let document = xml::parse(&strict, DEEPEST)?;
    let (model, version) = model_of(&document, scaled)?;
    let mut reader = Reader::new(scaled);
    let mut bodies = Bodies::of(&mut reader, model, version);
    let frames = markers::frames(&mut reader, &mut bodies);
    let lengths = path_lengths(&mut reader, &mut bodies, scaled);
    Ok((frames, lengths))
}

/// Whether an element is a constraint that a figure cannot hold.
fn constrains(reader: &mut Reader, node: Node) -> bool {
    let name = node.tag_name().name();
    let is_one = name.ends_with("Constraint")
        && child_flag(reader, node, "isEnforced", true)
        && !child_flag(reader, node, "isDisabled", false);
    let leaders = child_words(node, "independent_coordinate_names").unwrap_or_default();
    is_one && (name != COUPLER || leaders.split_whitespace().count() != 1)
}

/// The lengths of the paths of the model that `text` is; unknown where it is no figure.
fn path_lengths(reader: &mut Reader, bodies: &mut Bodies, text: &str) -> Vec<Length> {
    // What closes loops moves the default pose, in OpenSim.
    if parts(bodies.model).any(|node| constrains(reader, node)) {
        return paths::unknown(bodies.model);
    }
    let names: Vec<String> = bodies.list.iter().map(|(name, _)| (*name).to_owned()).collect();
    match Pose::of(text, names.into_iter()) {
        Some(pose) => paths::lengths(reader, bodies, &pose),
        None => paths::unknown(bodies.model),
    }
}

/// Says what has places and sizes that OpenSim does not scale.
fn unscaled(reader: &mut Reader, model: Node) {
    const KINDS: [&str; 6] = [
        "ContactSphere",
        "ContactMesh",
        "ContactHalfSpace",
        "ContactEllipsoid",
        "PointConstraint",
        "ConstantDistanceConstraint",
    ];
    for kind in KINDS {
        let mut found = parts(model).filter(|node| node.has_tag_name(kind));
        if let Some(first) = found.next() {
            let message = format!("{} of them keep places and sizes, as in OpenSim", 1 + found.count());
            reader.unsupported(tag(first), format!("<{kind}>"), message);
        }
    }
}
