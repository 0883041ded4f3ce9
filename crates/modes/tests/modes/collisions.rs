//! Links that touch each other: closed forms, laws, and that nothing is ever refused.

mod laws;
mod piles;

use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind, Vector3};
use solaris_modes::{Collisions, Method, Settings, Simulation};

const G: f64 = 9.81;

fn shape(kind: ShapeKind) -> Shape {
    Shape { kind, placement: Placement::identity() }
}

fn cube(x: f64, y: f64, z: f64) -> ShapeKind {
    ShapeKind::Box { size: Vector3::new(x, y, z) }
}

/// A slab of a metre that stands still, its upper face through the origin, and what flies over it.
fn over_a_slab(bodies: &[(ShapeKind, f64)]) -> Figure {
    let slab = Shape { kind: cube(4.0, 0.2, 4.0), placement: Placement::translation(0.0, -0.1, 0.0) };
    let mut builder =
        FigureBuilder::new("scene").link(LinkSpec::root("slab", Joint::new("ground")).mass(1.0).shape(slab));
    for (i, (kind, mass)) in bodies.iter().enumerate() {
        let link = LinkSpec::child(format!("b{i}"), "slab", Joint::free(format!("free{i}"))).mass(*mass);
        builder = builder.link(link.inertia(Inertia::Uniform(shape(*kind))).shape(shape(*kind)));
    }
    builder.build().expect("valid")
}

/// Under a gravity, at these places and at rest.
fn colliding(figure: &Figure, gravity: Vector3<f64>, friction: f64, places: &[Vector3<f64>]) -> Simulation {
    let mut simulation = Simulation::new(figure, gravity);
    let q: Vec<f64> = places.iter().flat_map(|at| [at.x, at.y, at.z, 0.0, 0.0, 0.0, 1.0]).collect();
    simulation.set_start(&q, &vec![0.0; 6 * places.len()]).expect("valid");
    simulation.set_collisions(Collisions::of(figure, friction).expect("valid")).expect("valid");
    simulation
}

fn settings(duration: f64, rate: f64, step: f64) -> Settings {
    Settings { method: Method::Impulses { step }, estimate: false, ..Settings::new(duration, rate) }
}
