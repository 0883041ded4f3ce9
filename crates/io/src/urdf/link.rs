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
    let inertial = element(node, "inertial").map(|inertial| read_inertial(reader, &name, inertial));
    let inertial = inertial.inspect(|inertial| check_inertial(reader, &name, inertial));
    Link { span: value_span(node, "name"), inertial, shape: geometry::shape(reader, node), name }
}

/// What is missing counts as zero, as in other readers; what cannot be read is a fault, and replaced by what no further
/// fault follows from.
fn read_inertial(reader: &mut Reader, link: &str, node: Node) -> Inertial {
    reader.check_attributes(node, &[]);
    reader.check_elements(node, &["origin", "mass", "inertia"], &[]);
    let at = origin(reader, node);
    let faults = reader.fault_count();
    let mass = element(node, "mass").filter(|mass| mass.attribute("value").is_some());
    let [mass, inertia] = [mass, element(node, "inertia")];
    let spans = [
        mass.map_or_else(|| tag(node), |mass| value_span(mass, "value")),
        inertia.map_or_else(|| tag(node), |inertia| inertia.range()),
    ];
    if mass.is_none() {
        reader.suspect(tag(node), link, "its <inertial> says no <mass value>: it counts as massless");
    }
    if inertia.is_none() {
        reader.suspect(tag(node), link, "its <inertial> says no <inertia>: it counts as a point mass");
    }
    let mass = mass.and_then(|mass| {
        reader.check_attributes(mass, &["value"]);
        reader.number(mass, "value")
    });
    let inertia = inertia.map(|inertia| tensor(reader, link, inertia)).unwrap_or_default();
    let readable = reader.fault_count() == faults;
    let (mass, inertia) = if readable { (mass.unwrap_or(0.0), inertia) } else { (1.0, Matrix3::zeros()) };
    let turn = *at.rotation.to_rotation_matrix().matrix();
    let turned = if turn == Matrix3::identity() { inertia } else { turn * inertia * turn.transpose() };
    let inertia = (turned + turned.transpose()) / 2.0;
    Inertial { mass, com: at.translation.vector, inertia, spans }
}

fn tensor(reader: &mut Reader, link: &str, node: Node) -> Matrix3<f64> {
    let names = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
    reader.check_attributes(node, &names);
    let missing: Vec<&str> = names.into_iter().filter(|name| node.attribute(*name).is_none()).collect();
    if !missing.is_empty() {
        reader.suspect(
            tag(node),
            link,
            format!("its <inertia> says no {}: what is missing counts as 0", missing.join(", ")),
        );
    }
    let [xx, xy, xz, yy, yz, zz] = names.map(|name| reader.number(node, name).unwrap_or(0.0));
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
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
