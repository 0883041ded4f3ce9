//! Closed loops by impulses: closed forms, and how well they hold.

use approx::assert_relative_eq;
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{Anchor, LimitLaw, Loop, LoopKind, Method, Rule, Run, Settings, Simulation};

pub(crate) const G: f64 = 9.81;

fn settings(duration: f64, step: f64) -> Settings {
    Settings { method: Method::Impulses { step }, estimate: false, ..Settings::new(duration, 100.0) }
}

/// A uniform rod of 1 kg and 0.5 m, down from its joint.
pub(crate) fn rod(link: LinkSpec) -> LinkSpec {
    let across = 0.25 / 12.0;
    link.mass(1.0).com(Vector3::y() * -0.25).inertia(Inertia::diagonal(across, 1e-3 * across, across))
}

/// Two such rods for cranks, 0.8 m apart, with a coupler of 2 kg between their ends; open where the coupler meets the second.
pub(crate) fn four_bar() -> Figure {
    let coupler = LinkSpec::child("coupler", "first", Joint::new("coupler").at(Vector3::y() * -0.5).rz());
    FigureBuilder::new("four-bar")
        .link(LinkSpec::root("frame", Joint::new("frame")).mass(1.0))
        .link(rod(LinkSpec::child("first", "frame", Joint::new("first").rz())))
        .link(coupler.mass(2.0).com(Vector3::x() * 0.4).inertia(Inertia::diagonal(1e-4, 0.1, 0.1)))
        .link(rod(LinkSpec::child("second", "frame", Joint::new("second").at(Vector3::x() * 0.8).rz())))
        .build()
        .expect("valid")
}

pub(crate) fn closed(figure: &Figure, kind: LoopKind, [first, second]: [(&str, Vector3<f64>); 2]) -> Loop {
    let anchor = |(name, point): (&str, Vector3<f64>)| Anchor { link: figure.link_index(name), point };
    Loop::new([anchor(first), anchor(second)], kind)
}

/// The angle after `seconds` of a pendulum that is let go at `angle`, `θ̈ = −k·sin θ`, by Runge and Kutta's rule, fine enough.
pub(crate) fn swung(mut angle: f64, k: f64, seconds: f64) -> f64 {
    let (mut rate, h) = (0.0, 1e-4);
    let acceleration = |angle: f64| -k * angle.sin();
    for _ in 0..(seconds / h).round() as usize {
        let (k1, l1) = (rate, acceleration(angle));
        let (k2, l2) = (rate + 0.5 * h * l1, acceleration(angle + 0.5 * h * k1));
        let (k3, l3) = (rate + 0.5 * h * l2, acceleration(angle + 0.5 * h * k2));
        let (k4, l4) = (rate + h * l3, acceleration(angle + h * k3));
        angle += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        rate += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
    angle
}

/// Cranks of 1 kg, a coupler of 2 kg: `θ̈ = −g·(m + M)/(2m/3 + M)·sin θ/L`.
pub(crate) const RATE: f64 = G * 3.0 / (2.0 / 3.0 + 2.0) / 0.5;

#[test]
fn a_parallelogram_swings_as_one_pendulum_and_stays_closed() {
    let figure = four_bar();
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    let start = 1.0;
    simulation.set_start(&[start, -start, start], &[0.0; 3]).expect("valid");
    let ends = [("coupler", Vector3::x() * 0.8), ("second", Vector3::y() * -0.5)];
    simulation.add_loop(closed(&figure, LoopKind::Connect, ends)).expect("valid");
    let run = |step| simulation.run(&settings(5.0, step)).expect("never refused");
    let angle = swung(start, RATE, 5.0);
    let off = |run: &Run| (run.motion.q(500)[0] - angle).abs();
    let (coarse, fine) = (run(1e-3), run(5e-4));
    assert!(off(&coarse) < 0.03 && off(&fine) < 0.6 * off(&coarse), "{} {}", off(&coarse), off(&fine));
    for run in [&coarse, &fine] {
        let report = &run.report.loops[0];
        assert_eq!(report.links, ["coupler", "second"]);
        assert!(report.apart < 1e-6, "{report:?}");
        assert!(run.report.energy.imbalance < 5e-3 * run.report.energy.scale, "{:?}", run.report.energy);
    }
}

/// A free body of 3 kg that is welded to the world beside its middle: the weld bears its weight and its moment.
#[test]
fn a_weld_bears_forces_and_moments() {
    let figure = FigureBuilder::new("body")
        .link(LinkSpec::root("body", Joint::free("root")).mass(3.0).inertia(Inertia::diagonal(0.1, 0.1, 0.1)))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    let held = Vector3::new(0.4, 0.0, 0.0);
    let between = [Anchor { link: Some(0), point: held }, Anchor { link: None, point: held }];
    simulation.add_loop(Loop::new(between, LoopKind::Weld)).expect("valid");
    let run = simulation.run(&settings(2.0, 1e-3)).expect("never refused");
    let q = run.motion.q(200);
    assert!(q[..6].iter().all(|x| x.abs() < 1e-6), "{q:?}");
    let contact = run.motion.contact("body").expect("a track").samples[200];
    assert_relative_eq!(contact.force.y, 3.0 * G, max_relative = 1e-6);
    // About its middle, where its weight acts.
    assert!(contact.moment.norm() < 1e-5, "{}", contact.moment);
    assert_relative_eq!(run.report.loops[0].force, 3.0 * G, max_relative = 1e-2);
}

/// What begins a centimetre apart is drawn together at 0.1 m/s, and stays so.
#[test]
fn what_begins_apart_is_drawn_together() {
    let figure = four_bar();
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    simulation.set_start(&[0.3, -0.3, 0.28], &[0.0; 3]).expect("valid");
    let ends = [("coupler", Vector3::x() * 0.8), ("second", Vector3::y() * -0.5)];
    simulation.add_loop(closed(&figure, LoopKind::Connect, ends)).expect("valid");
    let run = simulation.run(&settings(1.0, 1e-3)).expect("never refused");
    assert_relative_eq!(run.report.loops[0].apart, 0.01, max_relative = 0.01);
    let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("valid");
    let mut workspace = Workspace::new(&tree);
    let mut apart = |frame: usize| {
        forward_kinematics(&tree, &mut workspace, run.motion.q(frame)).expect("valid");
        let at = |link: usize, point: Vector3<f64>| workspace.pose(link).transform(&point);
        (at(2, ends[0].1) - at(3, ends[1].1)).norm()
    };
    assert_relative_eq!(apart(5), 0.005, max_relative = 0.05);
    assert!(apart(12) < 1e-6 && apart(100) < 1e-6);
}

/// Two rods on one axis, welded: they swing as one pendulum does. A turn that is none but for rounding was NaN.
#[test]
fn welded_rods_swing_as_one() {
    let joint = |name: &str, z: f64| Joint::new(name).at(Vector3::z() * z).rz();
    let figure = FigureBuilder::new("twins")
        .link(LinkSpec::root("frame", Joint::new("frame")).mass(1.0))
        .link(rod(LinkSpec::child("first", "frame", joint("first", 0.0))))
        .link(rod(LinkSpec::child("second", "frame", joint("second", 0.3))))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    simulation.set_start(&[0.5, 0.5], &[0.0; 2]).expect("valid");
    let ends = [("first", Vector3::new(0.0, -0.2, 0.3)), ("second", Vector3::new(0.0, -0.2, 0.0))];
    simulation.add_loop(closed(&figure, LoopKind::Weld, ends)).expect("valid");
    let run = simulation.run(&settings(2.0, 1e-3)).expect("never refused");
    let mut alone = Simulation::new(&figure, Vector3::y() * -G);
    alone.set_start(&[0.5, 0.5], &[0.0; 2]).expect("valid");
    let rule = Method::Fixed { rule: Rule::RungeKutta4, step: 1e-3 };
    let single = alone.run(&Settings { method: rule, ..Settings::new(2.0, 100.0) }).expect("valid");
    for frame in 0..=200 {
        let (both, one) = (run.motion.q(frame), single.motion.q(frame));
        assert!((both[0] - one[0]).abs() < 5e-3, "{frame}: {both:?} {one:?}");
        assert!((both[0] - both[1]).abs() < 1e-6, "{frame}: {both:?}");
    }
}

/// Masses of 1e±6 beside each other.
#[test]
fn masses_far_apart_stay_together() {
    for (light, heavy) in [(1e-6, 1.0), (1.0, 1e6), (1e-3, 1e3)] {
        let body = |name: &str, mass: f64| {
            let own = 0.01 * mass;
            LinkSpec::child(name, "world", Joint::free(name))
                .mass(mass)
                .inertia(Inertia::diagonal(own, own, own))
        };
        let figure = FigureBuilder::new("pair")
            .link(LinkSpec::root("world", Joint::new("world")).inertia(Inertia::Point))
            .link(body("light", light))
            .link(body("heavy", heavy))
            .build()
            .expect("valid");
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        let (at, link) = (|x: f64| Vector3::new(x, 0.0, 0.0), |name: &str| figure.link_index(name));
        // The light one hangs from the world, and the heavy one from it.
        let chain = [
            [Anchor { link: None, point: at(-0.2) }, Anchor { link: link("light"), point: at(-0.2) }],
            [Anchor { link: link("light"), point: at(0.2) }, Anchor { link: link("heavy"), point: at(0.2) }],
        ];
        for between in chain {
            simulation.add_loop(Loop::new(between, LoopKind::Connect)).expect("valid");
        }
        // It cracks like a whip where both are in one line, with 34 times the weight of the heavy one.
        for (step, most) in [(1e-3, 1e-4), (2.5e-4, 4e-6)] {
            let run = simulation.run(&settings(1.0, step)).expect("never refused");
            for report in &run.report.loops {
                assert!(report.apart < most, "{light} {heavy}: {report:?}");
            }
        }
    }
}

#[test]
fn loops_of_nothing_are_refused() {
    let figure = four_bar();
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    let of = |link, x| Anchor { link, point: Vector3::new(x, 0.0, 0.0) };
    let mut refused =
        |between| simulation.add_loop(Loop::new(between, LoopKind::Weld)).expect_err("refused").to_string();
    let itself =
        "a loop holds two links together, or a link and the world, and both ends of this one are on the same";
    assert_eq!(refused([of(Some(1), 0.0), of(Some(1), 1.0)]), itself);
    assert_eq!(refused([of(None, 0.0), of(None, 1.0)]), itself);
    assert_eq!(refused([of(Some(9), 0.0), of(None, 1.0)]), "figure 'four-bar' has no link 'number 9'");
    assert_eq!(
        refused([of(Some(1), f64::INFINITY), of(None, 1.0)]),
        "a point of a loop is inf; it must be finite numbers"
    );
    simulation.add_loop(Loop::new([of(Some(1), 0.0), of(None, 0.0)], LoopKind::Weld)).expect("valid");
}

/// Both cranks of a parallelogram come to springs at the same instant, over and over: what forces find, with less of an error in smaller steps, and the energy balances.
#[test]
fn limits_with_springs_that_are_met_together_need_no_events() {
    let rod_to = |name: &str, at: f64| {
        let joint = Joint::new(name).at(Vector3::x() * at).rz().limited(-0.4, 2.0);
        rod(LinkSpec::child(name, "frame", joint))
    };
    let coupler = LinkSpec::child("coupler", "first", Joint::new("coupler").at(Vector3::y() * -0.5).rz());
    let figure = FigureBuilder::new("four-bar")
        .link(LinkSpec::root("frame", Joint::new("frame")).mass(1.0))
        .link(rod_to("first", 0.0))
        .link(coupler.mass(2.0).com(Vector3::x() * 0.4).inertia(Inertia::diagonal(1e-4, 0.1, 0.1)))
        .link(rod_to("second", 0.8))
        .build()
        .expect("valid");
    for damping in [0.0, 1e-3, 2.0] {
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        simulation.set_start(&[1.0, -1.0, 1.0], &[0.0; 3]).expect("valid");
        let ends = [("coupler", Vector3::x() * 0.8), ("second", Vector3::y() * -0.5)];
        simulation.add_loop(closed(&figure, LoopKind::Connect, ends)).expect("valid");
        for dof in ["first.rz", "second.rz"] {
            simulation.set_limit(dof, LimitLaw::Spring { stiffness: 400.0, damping }).expect("valid");
        }
        let exact = Settings { method: Method::Automatic { tolerance: 1e-8 }, ..Settings::new(3.0, 100.0) };
        let exact = simulation.run(&exact).expect("runs").motion;
        let off = |step: f64| {
            let run = simulation.run(&settings(3.0, step)).expect("runs");
            let energy = &run.report.energy;
            assert!(energy.imbalance < 150.0 * step * energy.scale, "{damping} {step}: {energy:?}");
            let off = (0..run.motion.len()).map(|k| (run.motion.q(k)[0] - exact.q(k)[0]).abs());
            off.fold(0.0, f64::max)
        };
        let [coarse, fine] = [1e-3, 1e-4].map(off);
        assert!(fine < 0.02 && fine < 0.3 * coarse, "{damping}: {coarse} {fine}");
    }
}
