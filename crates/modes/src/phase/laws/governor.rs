//! A flyball governor: a stiff scene with numbers to compare with.

use super::rate;
use crate::element::{Anchor, LimitLaw, PointSpring};
use crate::phase::{Phase, Role};
use crate::simulation::Simulation;
use crate::time::System;
use approx::assert_relative_eq;
use nalgebra::{DMatrix, Vector3};
use solaris_model::{Axis, FigureBuilder, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind};
use std::f64::consts::{FRAC_PI_3, TAU};

const GRAVITY: f64 = 9.81;

/// The governor at s = 0.5 m, θ = 60°, with the shaft at 2π rad/s; its degrees of freedom are shaft, s, θ, θ.
fn governor() -> Simulation {
    let bar = |z: f64| {
        let placement = Placement::translation(0.0, 0.0, z);
        Inertia::Uniform(Shape { kind: ShapeKind::Box { size: Vector3::new(0.01, 0.01, 1.0) }, placement })
    };
    let cube =
        Shape { kind: ShapeKind::Box { size: Vector3::repeat(0.1) }, placement: Placement::identity() };
    let mut builder = FigureBuilder::new("governor")
        .link(LinkSpec::root("shaft", Joint::new("spin").rz()).mass(0.3).inertia(bar(0.0)))
        .link(
            LinkSpec::child("base", "shaft", Joint::new("slide").at(Vector3::new(0.0, 0.0, -0.5)).tz())
                .mass(3.0)
                .inertia(Inertia::Uniform(cube)),
        );
    for (name, side) in [("left", 1.0), ("right", -1.0)] {
        let axis = Axis::rotation(Vector3::new(0.0, -side, 0.0));
        let joint = Joint::new(format!("{name} hinge")).at(Vector3::new(0.05 * side, 0.0, 0.5)).axis(axis);
        builder = builder.link(LinkSpec::child(name, "shaft", joint).mass(0.3).inertia(bar(-0.5)));
        let weld = Joint::new(format!("{name} weld")).at(Vector3::new(0.0, 0.0, -1.0));
        builder = builder.link(LinkSpec::child(format!("{name} ball"), name, weld).mass(5.0));
    }
    let figure = builder.build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, 0.0, -GRAVITY));
    simulation.set_start(&[0.0, 0.5, FRAC_PI_3, FRAC_PI_3], &[TAU, 0.0, 0.0, 0.0]).expect("valid");
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    for (name, side) in [("left", 1.0), ("right", -1.0)] {
        let anchor = |name, point| Anchor { link: figure.link_index(name), point };
        let base = anchor("base", Vector3::new(0.05 * side, 0.0, 0.0));
        let rod = anchor(name, Vector3::new(0.0, 0.0, -0.5));
        let spring = PointSpring { between: [base, rod], stiffness: 8e5, damping: 4e4, rest: 0.5 };
        simulation.add_spring(spring).expect("valid");
    }
    simulation
}

fn phase() -> (Phase, Vec<f64>) {
    let simulation = governor();
    let (q, v) = simulation.state();
    let phase = Phase::with(&simulation, &[Role::Dynamic; 4], q, true).expect("valid");
    let y = phase.pack(q, v, 0.0, 0.0);
    (phase, y)
}

/// At the start the springs have their rest length, so that the base falls and the rods go up by their spin alone:
///
/// ```text
/// I·θ̈ = ½·Ω²·dI_z/dθ − g·(m/2 + M)·sin θ
/// ```
#[test]
fn the_governor_starts_as_by_hand() {
    let (mut phase, y) = phase();
    let rates = rate(&mut phase, 0.0, &y);
    let (rod, ball, sine, cosine) = (0.3, 5.0, 0.75_f64.sqrt(), 0.5);
    let (across, along) =
        (rod / 3.0 * (0.5_f64.powi(2) + 0.005_f64.powi(2)), rod / 3.0 * 2.0 * 0.005_f64.powi(2));
    let hinge = across + rod * 0.25 + ball;
    let spread = 2.0 * rod * (0.05 + 0.5 * sine) * 0.5 * cosine
        + 2.0 * (across - along) * sine * cosine
        + 2.0 * ball * (0.05 + sine) * cosine;
    let expected = (0.5 * TAU * TAU * spread - GRAVITY * (0.15 + ball) * sine) / hinge;
    let [spin, slide, left, right] = rates[4..8] else { panic!("four accelerations") };
    assert_relative_eq!(spin, 0.0, epsilon = 1e-10);
    assert_relative_eq!(slide, -GRAVITY, epsilon = 1e-9);
    assert_relative_eq!(left, expected, max_relative = 1e-11);
    assert_relative_eq!(right, expected, max_relative = 1e-11);
}

/// −8117 1/s, from a second implementation.
#[test]
fn the_governors_stiffest_eigenvalue() {
    let (mut phase, y) = phase();
    let mut jacobian = DMatrix::zeros(y.len(), y.len());
    phase.jacobian(0.0, &y, &mut jacobian).expect("finite");
    let eigenvalues = jacobian.complex_eigenvalues();
    let stiffest = eigenvalues.iter().max_by(|a, b| a.norm().total_cmp(&b.norm())).expect("eight");
    assert!((stiffest.re + 8117.0).abs() < 0.5 && stiffest.im.abs() < 1e-6, "{stiffest}");
}

#[test]
fn the_governors_mass_matrix_is_well_conditioned_in_its_own_units() {
    let (mut phase, y) = phase();
    let (condition, _) = phase.condition_beyond(0.0, &y, 0.0).expect("finite").expect("beyond nothing");
    assert!((1.0..10.0).contains(&condition), "{condition}");
}
