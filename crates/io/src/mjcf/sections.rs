//! The sections of a file besides its bodies.

use super::acting;
use super::model::Model;
use crate::xml::{Node, Reader, elements, elements_called, tag};
use solaris_model::Vector3;
use std::collections::HashMap;

/// Sections without any use for a motion.
const ASIDES: [&str; 7] = ["visual", "asset", "statistic", "size", "custom", "extension", "sensor"];
/// Attributes of `<option>` for the simulation's own steps.
const STEPS: [&str; 23] = [
    "timestep",
    "apirate",
    "impratio",
    "tolerance",
    "ls_tolerance",
    "noslip_tolerance",
    "ccd_tolerance",
    "sleep_tolerance",
    "mpr_tolerance",
    "o_margin",
    "o_solref",
    "o_solimp",
    "o_friction",
    "integrator",
    "cone",
    "jacobian",
    "solver",
    "iterations",
    "ls_iterations",
    "noslip_iterations",
    "ccd_iterations",
    "collision",
    "sdf_iterations",
];

/// What `<option>` says of the world that the bodies move in, and of what acts there.
pub(super) struct World {
    pub(super) gravity: Vector3<f64>,
    /// Of a fluid (kg/m³, Pa s), and how it moves (m/s).
    pub(super) density: f64,
    pub(super) viscosity: f64,
    pub(super) wind: Vector3<f64>,
    /// Whether springs, dampers and dry friction of joints act.
    pub(super) springs: bool,
    pub(super) dampers: bool,
    pub(super) friction: bool,
    /// Stiffness and damping that the inertia of the whole model sets, where they are known.
    pub(super) sprung: HashMap<String, [f64; 2]>,
}

impl World {
    /// Whether there is a fluid that resists.
    pub(super) fn is_fluid(&self) -> bool {
        self.density > 0.0 || self.viscosity > 0.0
    }

    /// As `<option>` says it.
    pub(super) fn read(reader: &mut Reader, root: Node) -> Self {
        let mut world = Self {
            gravity: Vector3::new(0.0, 0.0, -9.81),
            density: 0.0,
            viscosity: 0.0,
            wind: Vector3::zeros(),
            springs: true,
            dampers: true,
            friction: true,
            sprung: HashMap::new(),
        };
        let mut weightless = false;
        for option in elements_called(root, "option") {
            reader.check_attributes_but(option, &["gravity", "density", "viscosity", "wind"], &STEPS);
            world.gravity = reader.numbers(option, "gravity").map_or(world.gravity, Vector3::from);
            world.density = reader.number(option, "density").unwrap_or(world.density);
            world.viscosity = reader.number(option, "viscosity").unwrap_or(world.viscosity);
            world.wind = reader.numbers(option, "wind").map_or(world.wind, Vector3::from);
            for flag in elements_called(option, "flag") {
                for attribute in flag.attributes() {
                    let off = attribute.value() == "disable";
                    match attribute.name() {
                        "gravity" => weightless |= off,
                        "spring" => world.springs &= !off,
                        "damper" => world.dampers &= !off,
                        "passive" if off => (world.springs, world.dampers) = (false, false),
                        "frictionloss" | "constraint" => world.friction &= !off,
                        "passive" | "equality" => {}
                        _ => reader
                            .aside(format!("attribute '{}' of <flag>", attribute.name()), attribute.range()),
                    }
                }
            }
        }
        if weightless {
            world.gravity = Vector3::zeros();
        }
        world
    }
}

/// Lists what is not read of a model's sections.
pub(super) fn read(reader: &mut Reader, model: &Model) {
    for section in elements(model.root) {
        let name = section.tag_name().name();
        match name {
            "compiler" | "default" | "worldbody" | "option" => {}
            "actuator" | "tendon" | "equality" | "deformable" => {
                acting::read(reader, section, &model.defaults);
            }
            "contact" | "keyframe" => {
                for child in elements(section) {
                    reader.unread(format!("<{}> of <{name}>", child.tag_name().name()), tag(child));
                }
            }
            _ if ASIDES.contains(&name) => reader.aside(format!("<{name}>"), tag(section)),
            _ => reader.unread_element(section),
        }
    }
}
