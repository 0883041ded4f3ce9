//! A link as text.

use super::joint::joint;
use super::number::{is_plain_zero, placement, plain, tuple};
use crate::builder::{FigureBuilder, LinkSpec};
use crate::figure::Figure;
use crate::inertia::{Inertia, Shape, ShapeKind};
use crate::joint::Joint;
use crate::link::Link;
use solaris_text::layout::{Doc, field, group, number, quoted};

/// The paragraph of a link.
pub(super) fn link(figure: &Figure, link: &Link) -> Doc {
    let mut fields = vec![field("name", Doc::Atom(quoted(&link.name)))];
    if let Some(parent) = link.parent {
        fields.push(field("parent", Doc::Atom(quoted(&figure.links[parent].name))));
    }
    fields.push(field("joint", joint(&link.joint)));
    if !is_plain_zero(&[link.mass]) {
        fields.push(field("mass", plain(link.mass)));
    }
    let solid = link.shape.as_ref().filter(|shape| is_solid(link, shape));
    if let Some(solid) = solid {
        fields.push(field("solid", shape(solid)));
    } else {
        if !is_plain_zero(link.com.as_slice()) {
            fields.push(field("com", tuple(link.com.as_slice())));
        }
        let i = &link.inertia;
        let (moments, products) = ([i.m11, i.m22, i.m33], [i.m12, i.m13, i.m23]);
        if !is_plain_zero(&products) {
            fields.push(field("inertia", tuple(&[moments, products].concat())));
        } else if !is_plain_zero(&moments) {
            fields.push(field("inertia", tuple(&moments)));
        }
        fields.extend(link.shape.as_ref().map(|drawn| field("shape", shape(drawn))));
    }
    if let Some(tip) = &link.tip {
        fields.push(field("tip", tuple(tip.as_slice())));
    }
    if !link.sole.is_empty() {
        let points = link.sole.iter().map(|point| {
            let [x, y, z] = point.position.into();
            Doc::Atom(format!("{:?}({}, {}, {})", point.part, number(x), number(y), number(z)))
        });
        fields.push(field("sole", group("[", points.collect(), "]")));
    }
    if !link.frames.is_empty() {
        let frames = link
            .frames
            .iter()
            .map(|frame| field(&quoted(&frame.name), group("(", placement(&frame.placement), ")")));
        fields.push(field("frames", group("{", frames.collect(), "}")));
    }
    group("Link(", fields, ")")
}

/// Whether the mass of the link is spread evenly over its shape, bit for bit.
fn is_solid(link: &Link, shape: &Shape) -> bool {
    let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    if link.mass <= 0.0 || bits(link.com.as_slice()) != bits(shape.placement.translation.vector.as_slice()) {
        return false;
    }
    let alone = LinkSpec::root("solid", Joint::new("weld")).mass(link.mass).inertia(Inertia::Uniform(*shape));
    let built = FigureBuilder::new("solid").link(alone).build();
    built.is_ok_and(|figure| bits(figure.links[0].inertia.as_slice()) == bits(link.inertia.as_slice()))
}

fn shape(shape: &Shape) -> Doc {
    let (name, mut fields) = match &shape.kind {
        ShapeKind::Box { size } => ("Box(", vec![field("size", tuple(size.as_slice()))]),
        ShapeKind::Ellipsoid { radii } => ("Ellipsoid(", vec![field("radii", tuple(radii.as_slice()))]),
        ShapeKind::Sphere { radius } => ("Sphere(", vec![field("radius", plain(*radius))]),
        ShapeKind::Cylinder { radius, length } => ("Cylinder(", rod(*radius, *length)),
        ShapeKind::Capsule { radius, length } => ("Capsule(", rod(*radius, *length)),
    };
    fields.extend(placement(&shape.placement));
    group(name, fields, ")")
}

fn rod(radius: f64, length: f64) -> Vec<Doc> {
    vec![field("radius", plain(radius)), field("length", plain(length))]
}
