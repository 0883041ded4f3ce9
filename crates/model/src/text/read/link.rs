//! A link: its mass, what it looks like, what is fixed to it.

use super::FigureReader;
use crate::builder::LinkSpec;
use crate::fault::Part;
use crate::inertia::{Inertia, Shape, ShapeKind};
use crate::joint::Joint;
use crate::link::SolePart;
use crate::text::spatial::ReadSpatial as _;
use nalgebra::{Matrix3, Vector3};
use solaris_text::{Content, Fields, Node};

const FIELDS: [&str; 11] =
    ["name", "parent", "joint", "mass", "com", "inertia", "solid", "shape", "tip", "sole", "frames"];
const SHAPES: [&str; 5] = ["Box", "Cylinder", "Ellipsoid", "Capsule", "Sphere"];
const SOLE: [&str; 3] = ["Heel", "Ball", "ToeTip"];

impl FigureReader<'_> {
    /// The link number `index` of the list.
    pub(super) fn link(&mut self, node: &Node<'_>, index: usize) -> Option<LinkSpec> {
        let Some(fields) = self.fields(node, &["Link"], &FIELDS) else {
            self.lost.dofs = true;
            return None;
        };
        let name_node = self.required(&fields, "name", "\"…\"");
        let name = name_node.and_then(|node| self.name(node, "the name of a link"));
        let name = if let (Some(name), Some(node)) = (name, name_node) {
            self.places.put_name(Part::Link, name, node.span.clone());
            name.to_owned()
        } else {
            self.lost.links = true;
            let stand_in = format!("(number {})", index + 1);
            self.places.put(Part::Link, &stand_in, fields.at.clone());
            stand_in
        };
        let places = [
            ("parent", "parent"),
            ("mass", "mass"),
            ("com", "com"),
            ("inertia", "inertia"),
            ("solid", "shape"),
            ("shape", "shape"),
            ("tip", "tip"),
            ("sole", "sole"),
            ("frames", "frames"),
            ("joint", "joint"),
        ];
        for (field, part) in places {
            if let Some(node) = fields.get(field) {
                self.places.put_field(Part::Link, &name, part, node.place().start..node.span.end);
            }
        }
        let joint = self.required(&fields, "joint", "Joint(name: \"…\", axes: [rx])");
        let joint = joint.and_then(|node| self.joint(node, &name)).unwrap_or_else(|| {
            self.lost.dofs = true;
            Joint::new(format!("(of link {})", index + 1))
        });
        let mut link = match fields.get("parent") {
            None => LinkSpec::root(name, joint),
            Some(node) => {
                if let Some(parent) = self.name(node, "the name of the parent") {
                    LinkSpec::child(name, parent, joint)
                } else {
                    self.lost.parents = true;
                    LinkSpec::root(name, joint)
                }
            }
        };
        if let Some(node) = fields.get("mass") {
            let mass = self.number(node, "mass");
            link = link.mass(mass.unwrap_or(1.0));
        } else if fields.flawed {
            link = link.mass(1.0);
        }
        link = self.inertia(&fields, link);
        Some(self.fixed(&fields, link))
    }

    /// The centre of mass and the inertia.
    fn inertia(&mut self, fields: &Fields<'_, '_>, mut link: LinkSpec) -> LinkSpec {
        if let Some(solid) = fields.get("solid") {
            for (other, why) in [("com", "has its own centre of mass"), ("inertia", "has its own inertia")] {
                if let Some(node) = fields.get(other) {
                    let message =
                        format!("a link with a solid {why}; remove {other}, or make the solid a shape");
                    self.fault(node.place(), message);
                }
            }
            return match self.shape(solid) {
                Some(shape) => link.inertia(Inertia::Uniform(shape)),
                None => link,
            };
        }
        if let Some(com) = fields.get("com").and_then(|node| self.vector(node, "com")) {
            link = link.com(com);
        }
        let tensor = fields.get("inertia").and_then(|node| match node.items() {
            Some(items) if items.len() != 3 => {
                if items.len() != 6 {
                    let message = format!(
                        "inertia takes 3 numbers (xx, yy, zz) or 6 numbers (xx, yy, zz, xy, xz, yz); these are {}",
                        items.len()
                    );
                    self.fault(node.span.clone(), message);
                    return None;
                }
                self.numbers(node, "inertia", ["xx", "yy", "zz", "xy", "xz", "yz"])
            }
            _ => {
                let [x, y, z] = self.numbers(node, "inertia", ["xx", "yy", "zz"])?;
                Some([x, y, z, 0.0, 0.0, 0.0])
            }
        });
        match tensor {
            Some([xx, yy, zz, xy, xz, yz]) => {
                link.inertia(Inertia::Tensor(Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)))
            }
            None => link,
        }
    }

    /// What it looks like, and what is fixed to it.
    fn fixed(&mut self, fields: &Fields<'_, '_>, mut link: LinkSpec) -> LinkSpec {
        if let Some(shape) = fields.get("shape").and_then(|node| self.shape(node)) {
            link = link.shape(shape);
        }
        if let Some(tip) = fields.get("tip").and_then(|node| self.vector(node, "tip")) {
            link = link.tip(tip);
        }
        if let Some(node) = fields.get("sole") {
            for (part, position) in self.sole(node) {
                link = link.sole(part, position);
            }
        }
        let Some(node) = fields.get("frames") else { return link };
        let entries = self.entries(node, "frames", "{\"marker\": (at: (x, y, z))}").unwrap_or_default();
        for (key, value) in entries {
            let name = self.name(key, "the name of a frame");
            let Some(fields) = self.fields(value, &["Frame"], &["at", "turned"]) else { continue };
            let placement = self.placement(&fields);
            if let Some(name) = name {
                self.places.put_name(Part::Frame, name, key.span.clone());
                link = link.frame(name, placement);
            }
        }
        link
    }

    /// `[Heel(x, y, z), …]`
    fn sole(&mut self, node: &Node<'_>) -> Vec<(SolePart, Vector3<f64>)> {
        let example = "[Heel(x, y, z), Ball(x, y, z), ToeTip(x, y, z)]";
        let items = self.items(node, "sole", example).unwrap_or_default();
        let mut points = Vec::new();
        for item in items {
            let part = match self.kind(item, &SOLE) {
                Some("Heel") => SolePart::Heel,
                Some("Ball") => SolePart::Ball,
                Some(_) => SolePart::ToeTip,
                None => continue,
            };
            match item.group().map(|group| &group.content) {
                Some(Content::Tuple(numbers)) if numbers.len() == 3 => {
                    let found: Vec<Option<f64>> = numbers
                        .iter()
                        .map(|number| self.number(number, "a coordinate of the sole"))
                        .collect();
                    if let [Some(x), Some(y), Some(z)] = found[..] {
                        points.push((part, Vector3::new(x, y, z)));
                    }
                }
                _ => self.fault(item.span.clone(), format!("{part:?}(x, y, z) takes three numbers (m)")),
            }
        }
        points
    }

    /// A shape, with the placement of its own frame.
    fn shape(&mut self, node: &Node<'_>) -> Option<Shape> {
        let (known, example): (&[&str], _) = match self.kind(node, &SHAPES)? {
            "Box" => (&["size", "at", "turned"], ("size", "(0.1, 0.2, 0.3)")),
            "Ellipsoid" => (&["radii", "at", "turned"], ("radii", "(0.1, 0.2, 0.3)")),
            "Sphere" => (&["radius", "at", "turned"], ("radius", "0.1")),
            _ => (&["radius", "length", "at", "turned"], ("radius", "0.1")),
        };
        let fields = self.fields(node, &SHAPES, known)?;
        let placement = self.placement(&fields);
        let first = self.required(&fields, example.0, example.1);
        let kind = match fields.kind {
            "Box" => ShapeKind::Box { size: self.vector(first?, "size")? },
            "Ellipsoid" => ShapeKind::Ellipsoid { radii: self.vector(first?, "radii")? },
            "Sphere" => ShapeKind::Sphere { radius: self.number(first?, "radius")? },
            rod => {
                let length = self.required(&fields, "length", "0.3");
                let radius = first.and_then(|node| self.number(node, "radius"));
                let length = length.and_then(|node| self.number(node, "length"));
                let (radius, length) = (radius?, length?);
                if rod == "Capsule" {
                    ShapeKind::Capsule { radius, length }
                } else {
                    ShapeKind::Cylinder { radius, length }
                }
            }
        };
        Some(Shape { kind, placement })
    }
}
