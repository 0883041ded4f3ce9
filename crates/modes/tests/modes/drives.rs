//! The modes: what drives do in a run.

mod changes;
mod intensive;
mod order;
mod recorded;
mod servo;
mod simple;
mod takeover;

use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{Drive, LimitLaw, Method, Rule, Run, Settings, Simulation, Step};

/// A block of 2 kg that slides along x.
fn slider() -> Simulation {
    let link = LinkSpec::root("block", Joint::new("slide").tx()).mass(2.0);
    let figure = FigureBuilder::new("slider").link(link).build().expect("valid");
    Simulation::new(&figure, Vector3::zeros())
}

/// A point mass of 2 kg, half a metre below a hinge, hanging.
fn pendulum(gravity: f64) -> Simulation {
    let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
    let figure = FigureBuilder::new("pendulum").link(bob).build().expect("valid");
    Simulation::new(&figure, Vector3::new(0.0, -gravity, 0.0))
}

/// Two point masses of 1 kg on rods of 0.4 m, hanging.
fn double_pendulum() -> Figure {
    let rod = |name: &str| Joint::new(format!("{name}_hinge")).rx();
    let com = Vector3::new(0.0, -0.4, 0.0);
    FigureBuilder::new("double pendulum")
        .link(LinkSpec::root("upper", rod("upper")).mass(1.0).com(com))
        .link(LinkSpec::child("lower", "upper", rod("lower").at(com)).mass(1.0).com(com))
        .build()
        .expect("valid")
}

/// Runge and Kutta's rule at one step, with nothing beside.
fn settings(duration: f64, rate: f64, step: f64) -> Settings {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step };
    Settings { method, estimate: false, ..Settings::new(duration, rate) }
}

/// A run of one degree of freedom from a state, limits ignored, at 100 frames and 1000 steps a second.
fn run(mut simulation: Simulation, state: (f64, f64), steps: Vec<Step>, duration: f64) -> Run {
    let name = simulation.figure().layout().v_names()[0].clone();
    simulation.set_start(&[state.0], &[state.1]).expect("valid");
    simulation.drive(&name, steps).expect("valid");
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    simulation.run(&settings(duration, 100.0, 1e-3)).expect("runs")
}

/// A single drive, until it is done.
fn only(drive: Drive) -> Vec<Step> {
    vec![drive.into()]
}
