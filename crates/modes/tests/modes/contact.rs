//! The ground in simulation: springs, dampers and friction.
mod agreement;
mod awaited;
mod friction;
mod impulses;
mod leaping;
mod momentum;
mod people;
mod planted;
mod restitution;
mod setup;
mod stiffness;
mod usual;

use nalgebra::Unit;
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{ContactLaw, ContactPoint, GroundPlane, Method, Rule, Settings, Simulation};

const G: f64 = 9.81;

/// A point of 2 kg in a plane: along x, and up along y.
fn point() -> Figure {
    let point = LinkSpec::root("point", Joint::new("slide").tx().ty()).mass(2.0);
    FigureBuilder::new("point").link(point).build().expect("valid")
}

/// Its only touch, or that of any first link.
fn at(center: Vector3<f64>, radius: f64) -> ContactPoint {
    ContactPoint { link: 0, center, radius }
}

/// A floor at height 0.
fn floor(friction: f64, stiffness: f64, damping: f64, slip: f64) -> GroundPlane {
    let up = Unit::new_unchecked(Vector3::y());
    GroundPlane { up, height: 0.0, friction, law: ContactLaw::Compliant { stiffness, damping, slip } }
}

/// Under gravity along −y or none.
fn simulation(
    figure: &Figure,
    gravity: f64,
    plane: GroundPlane,
    contact_points: Vec<ContactPoint>,
) -> Simulation {
    let mut simulation = Simulation::new(figure, Vector3::new(0.0, -gravity, 0.0));
    simulation.set_ground(plane, contact_points).expect("valid");
    simulation
}

/// Runge and Kutta's rule, with nothing beside.
fn fixed(duration: f64, rate: f64, step: f64) -> Settings {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step };
    Settings { method, estimate: false, ..Settings::new(duration, rate) }
}
