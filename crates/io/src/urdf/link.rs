//! `<link>`.

use super::{geometry, origin};
use crate::xml::{Node, Reader, element, tag, value_span};
use solaris_model::{Matrix3, Shape, Vector3};
use std::ops::Range;

/// What an element `<link>` says.
pub(super) struct Link {
    pub(super) name: String,
    pub(super) span: Range<usize>,
    pub(super) inertial: Option<Inertial>,
    pub(super) shape: Option<Shape>,
}

/// What an element `<inertial>` says, along the link's axes.
pub(super) struct Inertial {
    pub(super) mass: f64,
    pub(super) com: Vector3<f64>,
    pub(super) inertia: Matrix3<f64>,
    /// Where the mass stands, and where the inertia.
    pub(super) spans: [Range<usize>; 2],
}

pub(super) fn read(reader: &mut Reader, node: Node) -> Link {
    reader.check_attributes(node, &["name", "type"]);
    reader.check_elements(node, &["inertial", "visual", "collision"], &["material"]);
    let name = reader.need(node, "name").unwrap_or_default().to_owned();
    let inertial = element(node, "inertial").map(|inertial| read_inertial(reader, inertial));
    let inertial = inertial.inspect(|inertial| check_inertial(reader, &name, inertial));
    Link { span: value_span(node, "name"), inertial, shape: geometry::shape(reader, node), name }
}

/// Unreadable numbers have been reported, and are replaced by such as no further fault follows from.
fn read_inertial(reader: &mut Reader, node: Node) -> Inertial {
    reader.check_attributes(node, &[]);
    reader.check_elements(node, &["origin", "mass", "inertia"], &[]);
    let at = origin(reader, node);
    let mass = element(node, "mass");
    let mass = require(reader, node, "mass", mass).and_then(|mass| {
        reader.check_attributes(mass, &["value"]);
        reader.need(mass, "value")?;
        Some((reader.number(mass, "value")?, value_span(mass, "value")))
    });
    let inertia = element(node, "inertia");
    let inertia = require(reader, node, "inertia", inertia).and_then(|inertia| {
        let names = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
        reader.check_attributes(inertia, &names);
        let numbers = names.map(|name| reader.need(inertia, name).and_then(|_| reader.number(inertia, name)));
        let [Some(xx), Some(xy), Some(xz), Some(yy), Some(yz), Some(zz)] = numbers else { return None };
        Some((Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz), inertia.range()))
    });
    let readable = mass.is_some() && inertia.is_some();
    let (mass, mass_span) = mass.unwrap_or((1.0, tag(node)));
    let (inertia, inertia_span) = inertia.unwrap_or((Matrix3::zeros(), tag(node)));
    let (mass, inertia) = if readable { (mass, inertia) } else { (1.0, Matrix3::zeros()) };
    let turn = *at.rotation.to_rotation_matrix().matrix();
    let turned = if turn == Matrix3::identity() { inertia } else { turn * inertia * turn.transpose() };
    let inertia = (turned + turned.transpose()) / 2.0;
    Inertial { mass, com: at.translation.vector, inertia, spans: [mass_span, inertia_span] }
}

fn require<'a>(reader: &mut Reader, node: Node, name: &str, found: Option<Node<'a>>) -> Option<Node<'a>> {
    if found.is_none() {
        reader.fault(tag(node), format!("<{}> has no <{name}>", node.tag_name().name()));
    }
    found
}

/// What a figure can be and hardly is meant.
fn check_inertial(reader: &mut Reader, link: &str, inertial: &Inertial) {
    let Inertial { mass, inertia, spans: [_, span], .. } = inertial;
    if *mass <= 0.0 || reader.has_faults() {
        return;
    }
    let trace = inertia.trace();
    // The radius of gyration about the centre in all directions together.
    let radius = (trace / (2.0 * mass)).sqrt();
    if inertia.amax() == 0.0 {
        let message = format!("its inertia is zero with a mass of {mass} kg; it counts as a point mass");
        reader.suspect(span.clone(), link, message);
    } else if *inertia == Matrix3::identity() && *mass < 10.0 {
        let message = format!(
            "its inertia is 1 kg m² about every axis, which looks like an exporter's default: with a mass of {mass} kg it \
             is spread {radius:.2} m about its centre"
        );
        reader.suspect(span.clone(), link, message);
    } else if radius > 10.0 {
        let message = format!(
            "its inertia spreads its mass of {mass} kg {radius:.1} m about its centre: check the units"
        );
        reader.suspect(span.clone(), link, message);
    }
}
