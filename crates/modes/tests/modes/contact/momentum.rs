//! Momentum and energy of figures that touch the ground.

use crate::contact::G;
use approx::assert_abs_diff_eq;
use solaris_dynamics::{Tree, Workspace, momentum};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind, Vector3};
use solaris_modes::{ContactLaw, GroundPlane, Method, Rule, Settings, Simulation, contact_points};

/// Three thick rods of 1 kg, hinged to each other, free in space.
fn chain() -> Figure {
    let kind = ShapeKind::Capsule { radius: 0.08, length: 0.4 };
    let solid = Shape { kind, placement: Placement::translation(0.0, -0.2, 0.0) };
    let down = Vector3::new(0.0, -0.4, 0.0);
    let mut builder = FigureBuilder::new("chain");
    for i in 0..3 {
        let (name, joint) = (format!("rod{i}"), Joint::new(format!("hinge{i}")));
        let link = match i {
            0 => LinkSpec::root(&name, Joint::free("root")),
            _ => LinkSpec::child(&name, format!("rod{}", i - 1), joint.at(down).rx().rz()),
        };
        builder = builder.link(link.mass(1.0).inertia(Inertia::Uniform(solid)).shape(solid));
    }
    builder.build().expect("valid")
}

fn linear(figure: &Figure, q: &[f64], v: &[f64]) -> Vector3<f64> {
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("valid");
    momentum(&tree, &mut Workspace::new(&tree), q, v).expect("finite").linear
}

/// A chain thrown to the ground, turning.
fn thrown(friction: f64) -> Simulation {
    let figure = chain();
    let gravity = Vector3::new(0.0, -G, 0.0);
    let mut simulation = Simulation::new(&figure, gravity);
    let plane = GroundPlane::under(&figure, &gravity, friction).expect("gravity");
    let ContactLaw::Compliant { stiffness, damping, .. } = plane.law else { panic!("a spring") };
    // Softer friction than usual, so that an explicit rule is exact.
    let plane = GroundPlane { law: ContactLaw::Compliant { stiffness, damping, slip: 0.1 }, ..plane };
    simulation.set_ground(plane, contact_points(&figure)).expect("valid");
    let (mut q, mut v) = (simulation.state().0.to_vec(), simulation.state().1.to_vec());
    q[..7].copy_from_slice(&[0.0, 1.6, 0.0, 0.1, 0.2, 0.3, 0.9]);
    q[7..].copy_from_slice(&[0.4, -0.2, -0.5, 0.3]);
    v[..6].copy_from_slice(&[1.0, 0.5, -0.4, 1.0, -2.0, 3.0]);
    v[6..].copy_from_slice(&[1.0, 0.5, -2.0, 0.0]);
    simulation.set_start(&q, &v).expect("valid");
    simulation
}

fn settings(step: f64) -> Settings {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step };
    Settings { method, estimate: false, ..Settings::new(1.2, 2000.0) }
}

/// `impulse of the ground + m·g·T = change of momentum`, in each frame's forces too.
#[test]
fn the_impulse_of_the_ground_is_the_change_of_momentum() {
    for friction in [0.0, 0.8] {
        let simulation = thrown(friction);
        let figure = simulation.figure();
        let run = simulation.run(&settings(2.5e-5)).expect("runs");
        let (motion, report) = (&run.motion, &run.report);
        let ground = report.ground.as_ref().expect("a ground");
        let last = motion.len() - 1;
        let change =
            linear(figure, motion.q(last), motion.v(last)) - linear(figure, motion.q(0), motion.v(0));
        let weight = Vector3::new(0.0, -3.0 * G * 1.2, 0.0);
        // The accounts are as exact as the steps are: contacts begin within them.
        assert_abs_diff_eq!(Vector3::from(ground.impulse) + weight, change, epsilon = 1e-5);
        assert!(ground.impulse[1] > 20.0, "{ground:?}");
        assert!((friction > 0.0) == (ground.friction > 1.0), "{ground:?}");
        assert!(report.energy.imbalance < 1e-5 * report.energy.scale, "{:?}", report.energy);
        // Nothing drives it: with the ground's forces known there is nothing left, in flight and on the ground.
        let tau = (0..motion.len()).flat_map(|frame| motion.tau(frame).expect("forces"));
        let left = tau.fold(0.0_f64, |most, tau| most.max(tau.abs()));
        assert!(left < 1e-7, "{left:e} N m");
        // The forces of the frames add up to the impulse, but for up to Ḟ·Δt²/8 = 0.014 N s of each touch that begins or ends
        // between two frames, where the force leaps to k·u·(1 + b·u) = 450 N/ms.
        let force = |frame: usize| {
            motion.contacts.iter().map(|track| track.samples[frame].force).sum::<Vector3<f64>>()
        };
        let sum: Vector3<f64> = (1..=last).map(|frame| (force(frame - 1) + force(frame)) / 4000.0).sum();
        assert_abs_diff_eq!(sum, Vector3::from(ground.impulse), epsilon = 6e-2);
    }
}

/// Until it touches, nothing but gravity acts: momentum falls with the weight, exactly, and so it is after every bounce.
#[test]
fn in_flight_momentum_is_exact() {
    let simulation = thrown(0.5);
    let figure = simulation.figure();
    let run = simulation.run(&settings(5e-5)).expect("runs");
    let (motion, mut flights) = (&run.motion, 0);
    let contact_points =
        |frame: usize| motion.contacts.iter().any(|track| track.samples[frame].force != Vector3::zeros());
    for frame in 1..motion.len() {
        if contact_points(frame - 1) || contact_points(frame) {
            continue;
        }
        let [before, after] =
            [frame - 1, frame].map(|frame| linear(figure, motion.q(frame), motion.v(frame)));
        let expected = Vector3::new(0.0, -3.0 * G / 2000.0, 0.0);
        assert_abs_diff_eq!(after - before, expected, epsilon = 1e-9);
        flights += 1;
    }
    assert!(flights > 500, "{flights} frames in flight");
}

/// Energy is never found: what there is falls from frame to frame but for the error of the steps.
#[test]
fn energy_never_grows() {
    let simulation = thrown(0.8);
    let figure = simulation.figure();
    let run = simulation.run(&settings(2.5e-5)).expect("runs");
    let report = &run.report;
    let allowed = report.energy.imbalance;
    assert!(allowed < 1e-5 * report.energy.scale, "{:?}", report.energy);
    let gravity = *simulation.gravity();
    let tree = Tree::<f64>::new(figure, gravity).expect("valid");
    let mut workspace = Workspace::new(&tree);
    let mut energy = |frame: usize| {
        let (q, v) = (run.motion.q(frame), run.motion.v(frame));
        let moving = solaris_dynamics::kinetic_energy(&tree, &mut workspace, q, v).expect("finite");
        moving + solaris_dynamics::potential_energy(&tree, &mut workspace, q).expect("finite")
    };
    let stiffness = ContactLaw::stiffness_for(figure, &gravity).expect("gravity");
    let all = contact_points(figure);
    let mut before = f64::INFINITY;
    for frame in 0..run.motion.len() {
        let tree = Tree::<f64>::new(figure, gravity).expect("valid");
        let mut placed = Workspace::new(&tree);
        solaris_dynamics::forward_kinematics(&tree, &mut placed, run.motion.q(frame)).expect("finite");
        let depth = |touch: &solaris_modes::ContactPoint| {
            (touch.radius - placed.pose(touch.link).transform(&touch.center).y).max(0.0)
        };
        let elastic: f64 = all.iter().map(|touch| 0.5 * stiffness * depth(touch).powi(2)).sum();
        let now = energy(frame) + elastic;
        assert!(now <= before + allowed, "frame {frame}: {before} to {now}, {allowed:e} allowed");
        before = now;
    }
}
