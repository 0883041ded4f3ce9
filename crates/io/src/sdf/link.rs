//! `<link>`.

use super::frames::{Entity, Kind};
use super::geometry::{self, Solid};
use super::include::is_true;
use super::model::{Contents, Context};
use super::pose;
use crate::tree::{Lump, MOST_BODIES, combined};
use crate::xml::{Node, Reader, element, elements_called, tag, text_of, value_span};
use solaris_model::{Matrix3, Shape, Vector3};
use std::ops::Range;

/// What a `<link>` says, along its own axes.
pub(super) struct Link {
    pub(super) entity: usize,
    pub(super) lump: Lump,
    pub(super) shape: Option<Shape>,
    pub(super) span: Range<usize>,
    /// Where its inertial stands.
    pub(super) inertial: Range<usize>,
    /// Whether the file leaves mass and inertia to the format's defaults.
    pub(super) by_default: bool,
    /// Whether gravity passes it over.
    pub(super) weightless: bool,
}

pub(super) fn read(reader: &mut Reader, node: Node, contents: &mut Contents, context: &Context) {
    if contents.links.len() >= MOST_BODIES {
        // Said once.
        if !contents.is_full {
            reader
                .fault(tag(node), format!("there are more than {MOST_BODIES} links, the most that are read"));
        }
        contents.is_full = true;
        return;
    }
    reader.check_attributes(node, &["name"]);
    let asides = [
        "sensor",
        "light",
        "audio_sink",
        "audio_source",
        "projector",
        "battery",
        "particle_emitter",
        "plugin",
        "self_collide",
        "must_be_base_link",
        "enable_wind",
        "kinematic",
    ];
    reader.check_elements(node, &["pose", "inertial", "visual", "collision", "gravity"], &asides);
    let name = reader.need(node, "name").unwrap_or_default().trim().to_owned();
    let pose = pose::of(reader, node, context.version);
    let link = contents.links.len();
    let span = value_span(node, "name");
    let relative_to = context.base(&pose, &context.own);
    let kind = Kind::Link(link);
    let entity = Entity { name: name.clone(), scope: context.scope, place: pose.place, relative_to, kind };
    let entity = contents.add(reader, context, span.clone(), entity);
    let solids = geometry::solids(reader, node, context.version);
    let inertial = element(node, "inertial");
    let lump = match inertial {
        Some(inertial) if inertial.attribute("auto").is_some_and(is_true) => {
            of_collisions(reader, inertial, &solids)
        }
        Some(inertial) => read_inertial(reader, inertial, context.version),
        None => Lump { mass: 1.0, com: Vector3::zeros(), inertia: Matrix3::identity() },
    };
    contents.links.push(Link {
        entity,
        lump,
        shape: geometry::shape(reader, node, &solids, context.version),
        span: context.at(span),
        inertial: context.at(inertial.map_or_else(|| tag(node), tag)),
        by_default: inertial.is_none(),
        weightless: element(node, "gravity").is_some_and(|it| !is_true(text_of(it).0)),
    });
}

/// What is not said is 1 kg and 1 kg m² about every axis, as the format has it.
fn read_inertial(reader: &mut Reader, node: Node, version: u32) -> Lump {
    reader.check_attributes(node, &["auto"]);
    reader.check_elements(node, &["mass", "pose", "inertia", "density", "frame"], &["auto_inertia_params"]);
    if let Some(added) = element(node, "fluid_added_mass") {
        let message = "the mass of the fluid that it carries along is not read: forces differ in a fluid";
        reader.missing(tag(added), "<fluid_added_mass>", message);
    }
    let faults = reader.fault_count();
    let number = |reader: &mut Reader, node: Option<Node>, otherwise: f64| {
        node.and_then(|node| reader.text_number(node)).unwrap_or(otherwise)
    };
    let mass = number(reader, element(node, "mass"), 1.0);
    let at = pose::of(reader, node, version).place;
    let inertia = element(node, "inertia");
    let names = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
    if let Some(inertia) = inertia {
        reader.check_elements(inertia, &names, &[]);
    }
    let [xx, xy, xz, yy, yz, zz] = names.map(|name| {
        let otherwise = if name.as_bytes()[1] == name.as_bytes()[2] { 1.0 } else { 0.0 };
        number(reader, inertia.and_then(|inertia| element(inertia, name)), otherwise)
    });
    if reader.fault_count() > faults {
        // Nothing further follows from what cannot be read.
        return Lump { mass: 1.0, com: Vector3::zeros(), inertia: Matrix3::zeros() };
    }
    let own = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let turn = *at.rotation.to_rotation_matrix().matrix();
    let turned = if turn == Matrix3::identity() { own } else { turn * own * turn.transpose() };
    Lump { mass, com: at.translation.vector, inertia: (turned + turned.transpose()) / 2.0 }
}

/// The mass of the collision shapes: theirs by density, or the one that is said, spread as they are.
fn of_collisions(reader: &mut Reader, inertial: Node, solids: &[Solid]) -> Lump {
    let nothing = Lump { mass: 1.0, com: Vector3::zeros(), inertia: Matrix3::zeros() };
    let said = element(inertial, "mass").and_then(|mass| reader.text_number(mass));
    let density = element(inertial, "density").and_then(|density| reader.text_number(density));
    let collisions: Vec<&Solid> = solids.iter().filter(|solid| solid.collides).collect();
    let unknown = inertial.parent().and_then(|link| {
        elements_called(link, "collision")
            .find(|node| geometry::form(*node).is_none_or(|form| !geometry::is_simple(form)))
    });
    if let Some(unknown) = unknown {
        let what = geometry::form(unknown).map_or("nothing", |form| form.tag_name().name());
        let message = format!(
            "its inertial is to be found from its collisions (auto), and one of them is a <{what}>: only box, cylinder, sphere, \
             capsule and ellipsoid are; write down mass and inertia"
        );
        reader.fault(tag(unknown), message);
        return nothing;
    }
    if collisions.is_empty() {
        reader
            .fault(tag(inertial), "its inertial is to be found from its collisions (auto), and it has none");
        return nothing;
    }
    let lumps: Vec<Lump> = collisions.iter().map(|solid| solid.lump(density.unwrap_or(1000.0))).collect();
    let whole = combined(&lumps.iter().collect::<Vec<_>>());
    match said {
        Some(mass) if whole.mass > 0.0 => {
            Lump { mass, inertia: whole.inertia * (mass / whole.mass), ..whole }
        }
        _ => whole,
    }
}
