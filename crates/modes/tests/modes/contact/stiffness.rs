//! Stiff grounds, light links on heavy ones, hard cases of the law.

use crate::contact::{G, at, fixed, floor, point, simulation};
use approx::assert_relative_eq;
use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{ContactPoint, Settings};

/// From sand to steel: it comes to rest as deep as its weight presses it.
#[test]
fn a_mass_comes_to_rest_at_the_depth_of_its_weight() {
    for stiffness in [1e3, 1e4, 1e5, 1e6] {
        let damping = 20.0;
        let mut simulation =
            simulation(&point(), G, floor(0.8, stiffness, damping, 1e-2), vec![at(Vector3::zeros(), 0.0)]);
        simulation.set_start(&[0.0, 1e-3], &[0.3, 0.0]).expect("valid");
        let run = simulation.run(&fixed(3.0, 100.0, 0.01 * (2.0 / stiffness).sqrt())).expect("runs");
        let last = run.motion.len() - 1;
        assert_relative_eq!(-run.motion.q(last)[1], 2.0 * G / stiffness, max_relative = 1e-2);
        let energy = &run.report.energy;
        assert!(energy.imbalance < 1e-4 * energy.scale, "{stiffness}: {energy:?}");
    }
}

/// A light foot under a heavy body, a thousand times as heavy: the ground carries both.
#[test]
fn a_light_foot_carries_a_heavy_body() {
    for ratio in [1.0, 1e-1, 1e-2, 1e-3] {
        let body = LinkSpec::root("body", Joint::new("up").ty()).mass(2.0);
        let foot = LinkSpec::child("foot", "body", Joint::new("leg").ty()).mass(2.0 * ratio);
        let mut figure = FigureBuilder::new("pogo").link(body).link(foot);
        figure = figure.gravity(Vector3::new(0.0, -G, 0.0));
        let figure = figure.build().expect("valid");
        let touch = ContactPoint { link: 1, center: Vector3::zeros(), radius: 0.0 };
        let mut simulation = simulation(&figure, G, floor(0.5, 2e4, 1.0, 1e-2), vec![touch]);
        let spring = solaris_modes::PointSpring {
            between: [0, 1].map(|link| solaris_modes::Anchor { link: Some(link), point: Vector3::zeros() }),
            stiffness: 500.0,
            damping: 30.0,
            rest: 0.4,
        };
        simulation.add_spring(spring).expect("valid");
        simulation.set_start(&[0.45, -0.4], &[0.0, 0.0]).expect("valid");
        let run = simulation.run(&Settings::new(4.0, 50.0)).expect("runs");
        let last = run.motion.len() - 1;
        let contact = run.motion.contact("foot").expect("it stands").samples[last];
        assert_relative_eq!(contact.force.y, 2.0 * (1.0 + ratio) * G, max_relative = 1e-4);
        let error = run.report.error.expect("an estimate").position;
        assert!(error <= 1e-6, "{ratio}: {error:e}, {}", run.report.method);
    }
}
