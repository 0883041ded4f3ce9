//! The tree of bodies of a model file, made into a figure.
//!
//! A [`Body`] says what the file says; [`assemble`] makes links of them: bodies that cannot move against their parent
//! become part of its link, and their frames are kept by name.

#![cfg_attr(
    not(all(feature = "urdf", feature = "mjcf", feature = "opensim", feature = "sdf")),
    allow(dead_code, unused_imports, reason = "each importer uses a part")
)]

mod composite;
mod lump;
mod names;

pub(crate) use composite::product;
pub(crate) use lump::{Lump, combined};
pub(crate) use names::Names;

use crate::xml::Reader;
use composite::Composite;
use solaris_model::{
    Fault, Figure, FigureBuilder, FigureError, Finding, Inertia, Joint, LinkSpec, Matrix3, NamedFrame, Part,
    Placement, Shape, SourceMap, TextError, Vector3,
};
use std::ops::Range;

/// The most bodies of a model that are read: all that is kept of as many takes less than a gigabyte.
pub(crate) const MOST_BODIES: usize = 1 << 17;

/// A rigid body of a model file, with the joint that moves it.
pub(crate) struct Body {
    /// Its name, unique among the bodies (the importer sees to that); it becomes the link's or a frame's.
    pub(crate) name: String,
    /// Its parent's place in the list of bodies, before or after it; `None` is the world.
    pub(crate) parent: Option<usize>,
    /// Its joint, placed in the parent's **body** frame; one without degrees of freedom is fixed.
    pub(crate) joint: Joint,
    /// The body's frame in the frame that the joint moves.
    pub(crate) beyond: Placement,
    /// Mass (kg).
    pub(crate) mass: f64,
    /// Centre of mass in the body's frame (m).
    pub(crate) com: Vector3<f64>,
    /// Rotational inertia about the centre of mass along the body's axes (kg m²).
    pub(crate) inertia: Matrix3<f64>,
    /// What it looks like, in the body's frame.
    pub(crate) shape: Option<Shape>,
    /// Its named frames, in the body's frame; names may be repeated, [`assemble`] makes them differ.
    pub(crate) frames: Vec<NamedFrame>,
    /// Where the body stands in the text.
    pub(crate) span: Range<usize>,
}

impl Body {
    /// A massless body at its joint.
    pub(crate) fn new(
        name: impl Into<String>,
        parent: Option<usize>,
        joint: Joint,
        span: Range<usize>,
    ) -> Self {
        Self {
            name: name.into(),
            parent,
            joint,
            beyond: Placement::identity(),
            mass: 0.0,
            com: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            shape: None,
            frames: Vec::new(),
            span,
        }
    }

    fn is_fixed(&self) -> bool {
        self.joint.kind().nv() == 0
    }
}

/// The figure called `name` that these bodies are, or every fault with its place in `text`.
///
/// - Links come depth first, children in the order of the list; they have the names of the bodies, and joints their own.
/// - A body fixed to its parent is fused into the parent's link (mass, centre, inertia by the parallel-axis theorem); its
///   frame stays by the body's name. So does the frame of a body whose `beyond` is not the identity.
/// - A single body fixed to the world is a root link with a weld called `root`. Several of them, or one beside bodies that
///   move against the world, are parts of a massless root link called `world`. A single body that moves against the
///   world is the root link with its own joint. The names `root` and `world` get a number where they are taken.
///
/// `places` says where bodies (as links) and joints stand, with fields `mass`, `inertia`, `com`, `joint` of links and
/// `limits`, `armature`, `stiffness`, `damping`, `friction` of dofs where they are known; bodies that have no place there
/// are put at their `span`. Parents must form a tree: cycles are the importer's to find (bodies on one are left out
/// here).
pub(crate) fn assemble(
    name: &str,
    bodies: Vec<Body>,
    mut places: SourceMap,
    text: &str,
) -> Result<Figure, TextError> {
    for body in &bodies {
        places.put(Part::Link, &body.name, body.span.clone());
        places.put(Part::Joint, body.joint.name(), body.span.clone());
    }
    let mut faults = Vec::new();
    let links = Composite::of(bodies, &mut faults);
    let mut builder = FigureBuilder::new(name);
    for link in links {
        builder = builder.link(link.spec());
    }
    match builder.build() {
        Ok(figure) if faults.is_empty() => Ok(figure),
        built => {
            if let Err(error) = built {
                faults.extend(error.faults);
            }
            Err(places.locate(text, &FigureError { figure: name.to_owned(), faults }))
        }
    }
}

/// What [`assemble`] makes of the bodies, with what the reader found: the figure and all findings, or every fault of both.
///
/// Bodies that stand in for unreadable ones must have no faults of their own (mass 1, inertia 0).
pub(crate) fn finish(
    mut reader: Reader,
    name: &str,
    bodies: Vec<Body>,
    places: SourceMap,
) -> Result<(Figure, Vec<Finding>), TextError> {
    if let Some(error) = reader.error().filter(|_| bodies.is_empty()) {
        return Err(error);
    }
    if let Some(body) = bodies.get(MOST_BODIES) {
        let message = format!("there are more than {MOST_BODIES} bodies, the most that are read");
        return Err(TextError::one(reader.text(), body.span.clone(), message));
    }
    let built = assemble(name, bodies, places, reader.text());
    if let Err(error) = &built {
        for fault in &error.faults {
            reader.fault(fault.place.span.clone(), fault.message.clone());
        }
    }
    if let Some(mut error) = reader.error() {
        error.omitted += built.err().map_or(0, |error| error.omitted);
        return Err(error);
    }
    Ok((built?, reader.findings()))
}
