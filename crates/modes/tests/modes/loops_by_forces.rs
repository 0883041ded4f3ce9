//! Closed loops by methods that know no impulses: forces hold them, as exactly as the method is.

use crate::loops::{G, RATE, closed, four_bar, rod, swung};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{
    Anchor, Drive, LimitLaw, Loop, LoopKind, Method, Rule, Run, Settings, Shape, Simulation,
};

const ENDS: [(&str, Vector3<f64>); 2] =
    [("coupler", Vector3::new(0.8, 0.0, 0.0)), ("second", Vector3::new(0.0, -0.5, 0.0))];

fn parallelogram(figure: &Figure, start: f64) -> Simulation {
    let mut simulation = Simulation::new(figure, Vector3::y() * -G);
    simulation.set_start(&[start, -start, start], &[0.0; 3]).expect("valid");
    simulation.add_loop(closed(figure, LoopKind::Connect, ENDS)).expect("valid");
    simulation
}

fn by(method: Method, duration: f64) -> Settings {
    Settings { method, ..Settings::new(duration, 100.0) }
}

#[test]
fn a_parallelogram_is_as_exact_as_the_tolerance() {
    let figure = four_bar();
    let simulation = parallelogram(&figure, 1.0);
    let known = swung(1.0, RATE, 5.0);
    for tolerance in [1e-5, 1e-8] {
        let run = simulation.run(&by(Method::Automatic { tolerance }, 5.0)).expect("runs");
        let off = (run.motion.q(500)[0] - known).abs();
        assert!(off < tolerance, "{tolerance}: {off}");
        let report = &run.report.loops[0];
        assert!(report.apart < 10.0 * tolerance && report.force > 1.0, "{report:?}");
        assert!(run.report.energy.imbalance < tolerance * run.report.energy.scale, "{:?}", run.report.energy);
    }
}

/// Forces of loops are forces of the motion: joint forces know of them, so that what nobody drives needs no force.
#[test]
fn joints_that_nobody_drives_need_no_force() {
    let figure = four_bar();
    let run = parallelogram(&figure, 1.0).run(&by(Method::Adaptive { tolerance: 1e-10 }, 1.0)).expect("runs");
    for frame in 0..run.motion.len() {
        let tau = run.motion.tau(frame).expect("forces");
        assert!(tau.iter().all(|force| force.abs() < 1e-7), "{frame}: {tau:?}");
    }
    let of = |link| run.motion.contact(link).expect("held").samples[50].force;
    assert!(of("coupler").norm() > 1.0);
    assert_abs_diff_eq!((of("coupler") + of("second")).norm(), 0.0, epsilon = 1e-9);
}

#[test]
fn fixed_rules_keep_their_order() {
    let figure = four_bar();
    let simulation = parallelogram(&figure, 1.0);
    let known = swung(1.0, RATE, 1.0);
    for (rule, order) in [(Rule::SemiImplicitEuler, 1), (Rule::RungeKutta4, 4)] {
        let off = |step: f64| {
            let run = simulation.run(&by(Method::Fixed { rule, step }, 1.0)).expect("runs");
            (run.motion.q(100)[0] - known).abs()
        };
        let offs = [1e-2, 5e-3].map(off);
        let ratio = offs[0] / offs[1];
        let expected = 2_f64.powi(order);
        assert!(ratio > 0.7 * expected && ratio < 1.5 * expected, "{rule}: {ratio}");
    }
}

/// A free body that is welded to the world beside its middle, and one that is welded to that.
#[test]
fn welds_bear_forces_and_moments() {
    let body = |name: &str, parent: &str, x: f64| {
        let joint = Joint::free(name).at(Vector3::x() * x);
        LinkSpec::child(name, parent, joint).mass(3.0).inertia(Inertia::diagonal(0.1, 0.1, 0.1))
    };
    let figure = FigureBuilder::new("bodies")
        .link(LinkSpec::root("frame", Joint::new("frame")).mass(1.0))
        .link(body("near", "frame", 0.0))
        .link(body("far", "frame", 0.5))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    let held = [("near", Vector3::x() * -0.4), ("frame", Vector3::x() * -0.4)];
    simulation.add_loop(closed(&figure, LoopKind::Weld, held)).expect("valid");
    let beside = [("near", Vector3::x() * 0.25), ("far", Vector3::x() * -0.25)];
    simulation.add_loop(closed(&figure, LoopKind::Weld, beside)).expect("valid");
    let run = simulation.run(&by(Method::Fixed { rule: Rule::RungeKutta4, step: 1e-2 }, 1.0)).expect("runs");
    let last = run.motion.q(100);
    let start = run.motion.q(0);
    assert!(last.iter().zip(start).all(|(a, b)| (a - b).abs() < 1e-12), "{last:?}");
    assert_relative_eq!(run.report.loops[0].force, 6.0 * G, max_relative = 1e-12);
    assert_relative_eq!(run.report.loops[1].force, 3.0 * G, max_relative = 1e-12);
}

/// Two free bodies, welded, spin as one body of both does: the same momentum, and no more apart than rounding.
#[test]
fn welded_bodies_tumble_as_one() {
    let body = |name: &str, x: f64| {
        let joint = Joint::free(name).at(Vector3::x() * x);
        LinkSpec::child(name, "world", joint).mass(2.0).inertia(Inertia::diagonal(0.02, 0.03, 0.04))
    };
    let figure = FigureBuilder::new("pair")
        .link(LinkSpec::root("world", Joint::new("world")).inertia(Inertia::Point))
        .link(body("left", 0.3))
        .link(body("right", -0.3))
        .build()
        .expect("valid");
    let spin = Vector3::new(1.0, 0.5, 5.0);
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    let velocity = |x: f64| spin.cross(&(Vector3::x() * x));
    let v: Vec<f64> =
        [0.3, -0.3].iter().flat_map(|x| [velocity(*x), spin]).flat_map(|v| [v.x, v.y, v.z]).collect();
    let q = simulation.state().0.to_vec();
    simulation.set_start(&q, &v).expect("valid");
    let weld = [("left", Vector3::x() * -0.3), ("right", Vector3::x() * 0.3)];
    simulation.add_loop(closed(&figure, LoopKind::Weld, weld)).expect("valid");
    let run = simulation.run(&by(Method::Automatic { tolerance: 1e-8 }, 2.0)).expect("runs");
    // I = 2·(I₁ + m·x²) across, of one body about its middle.
    let across = 2.0 * 2.0 * 0.09;
    let one = LinkSpec::root("one", Joint::ball("pivot")).mass(4.0).inertia(Inertia::diagonal(
        0.04,
        0.06 + across,
        0.08 + across,
    ));
    let alone = FigureBuilder::new("one").link(one).build().expect("valid");
    let mut single = Simulation::new(&alone, Vector3::zeros());
    single.set_start(&[0.0, 0.0, 0.0, 1.0], spin.as_slice()).expect("valid");
    let known = single.run(&by(Method::Automatic { tolerance: 1e-10 }, 2.0)).expect("runs");
    let (ours, theirs) = (&run.motion.q(200)[3..7], known.motion.q(200));
    let dot: f64 = ours.iter().zip(theirs).map(|(a, b)| a * b).sum();
    assert!(ours.iter().zip(theirs).all(|(a, b)| (a - b * dot.signum()).abs() < 1e-7), "{ours:?} {theirs:?}");
    assert!(run.report.loops[0].apart < 1e-7, "{:?}", run.report.loops[0]);
}

/// Masses of 1e±6 hang from each other.
#[test]
fn masses_far_apart_stay_together() {
    for (light, heavy) in [(1e-6, 1.0), (1.0, 1e6), (1e6, 1.0)] {
        let body = |name: &str, mass: f64, x: f64| {
            let own = 0.01 * mass;
            let joint = Joint::free(name).at(Vector3::x() * x);
            LinkSpec::child(name, "world", joint).mass(mass).inertia(Inertia::diagonal(own, own, own))
        };
        let figure = FigureBuilder::new("pair")
            .link(LinkSpec::root("world", Joint::new("world")).inertia(Inertia::Point))
            .link(body("upper", light, 0.2))
            .link(body("lower", heavy, 0.6))
            .build()
            .expect("valid");
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        let chain = [
            [("upper", Vector3::x() * -0.2), ("world", Vector3::zeros())],
            [("upper", Vector3::x() * 0.2), ("lower", Vector3::x() * -0.2)],
        ];
        for between in chain {
            simulation.add_loop(closed(&figure, LoopKind::Connect, between)).expect("valid");
        }
        let run = simulation.run(&by(Method::Automatic { tolerance: 1e-6 }, 0.5)).expect("runs");
        for report in &run.report.loops {
            assert!(report.apart < 1e-6, "{light} {heavy}: {report:?}");
        }
        assert!(run.report.energy.imbalance < 1e-5 * run.report.energy.scale, "{:?}", run.report.energy);
    }
}

/// A crank on a curve, a coupler and a rocker that dynamics move: nothing is left free, and where the rocker is follows from the lengths.
#[test]
fn what_a_crank_leads_follows() {
    let figure = four_bar();
    let mut simulation = parallelogram(&figure, 0.3);
    simulation
        .drive("first.rz", vec![Drive::Move { to: 1.3, over: 1.0, along: Shape::MinimumJerk }])
        .expect("valid");
    let run = simulation.run(&by(Method::Automatic { tolerance: 1e-7 }, 1.0)).expect("runs");
    for frame in 0..run.motion.len() {
        let q = run.motion.q(frame);
        assert!((q[0] - q[2]).abs() < 1e-6 && (q[0] + q[1]).abs() < 1e-6, "{frame}: {q:?}");
    }
    assert!(apart(&figure, &run) < 1e-6);
}

fn apart(figure: &Figure, run: &Run) -> f64 {
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("valid");
    let mut workspace = Workspace::new(&tree);
    let mut most = 0.0_f64;
    for frame in 0..run.motion.len() {
        forward_kinematics(&tree, &mut workspace, run.motion.q(frame)).expect("valid");
        let [first, second] = ENDS
            .map(|(name, point)| workspace.pose(figure.link_index(name).expect("a link")).transform(&point));
        most = most.max((first - second).norm());
    }
    most
}

/// A crank that comes to its limit throws back all that hangs on it.
#[test]
fn a_limit_turns_the_whole_linkage_round() {
    let figure = FigureBuilder::new("four-bar")
        .link(LinkSpec::root("frame", Joint::new("frame")).mass(1.0))
        .link(rod(LinkSpec::child("first", "frame", Joint::new("first").rz().limited(-0.5, 2.0))))
        .link(
            LinkSpec::child("coupler", "first", Joint::new("coupler").at(Vector3::y() * -0.5).rz())
                .mass(2.0)
                .com(Vector3::x() * 0.4)
                .inertia(Inertia::diagonal(1e-4, 0.1, 0.1)),
        )
        .link(rod(LinkSpec::child("second", "frame", Joint::new("second").at(Vector3::x() * 0.8).rz())))
        .build()
        .expect("valid");
    let mut simulation = parallelogram(&figure, 1.0);
    simulation.set_limits(LimitLaw::Hard { restitution: 0.8 }).expect("valid");
    let run = simulation.run(&by(Method::Automatic { tolerance: 1e-7 }, 1.0)).expect("runs");
    let impact = run.report.impacts.first().expect("it comes to its limit");
    // ½·v² = k·(cos 0.5 − cos 1), and 0.8 of the speed is left to all three.
    let speed = (2.0 * RATE * (0.5_f64.cos() - 1.0_f64.cos())).sqrt();
    let mass = (2.0 / 3.0 + 2.0) * 0.25;
    assert_relative_eq!(impact.loss, 0.5 * mass * speed * speed * (1.0 - 0.64), max_relative = 1e-5);
    assert!(apart(&figure, &run) < 1e-6);
    let [q, v] = [run.motion.q(100), run.motion.v(100)];
    assert!((q[0] - q[2]).abs() < 1e-6 && (v[0] - v[2]).abs() < 1e-5, "{q:?} {v:?}");
}

/// Where the joints between stand still, a loop holds what holds anyway.
#[test]
fn a_loop_around_what_is_frozen_holds_nothing() {
    let figure = four_bar();
    let mut simulation = parallelogram(&figure, 0.0);
    let within = [("first", Vector3::y() * -0.5), ("coupler", Vector3::zeros())];
    simulation.add_loop(closed(&figure, LoopKind::Weld, within)).expect("valid");
    simulation.drive("coupler.rz", vec![Drive::Frozen]).expect("valid");
    simulation.set_start(&[0.0; 3], &[0.0; 3]).expect("valid");
    let run = simulation.run(&by(Method::Automatic { tolerance: 1e-6 }, 0.2)).expect("runs");
    // The loop of the parallelogram leaves nothing to move then.
    assert!(run.motion.q(20).iter().all(|q| q.abs() < 1e-9), "{:?}", run.motion.q(20));
}

#[test]
fn what_begins_open_is_refused() {
    let figure = four_bar();
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    simulation.set_start(&[0.3, -0.3, 0.28], &[0.0; 3]).expect("valid");
    simulation.add_loop(closed(&figure, LoopKind::Connect, ENDS)).expect("valid");
    let refused = |simulation: &Simulation| {
        simulation.run(&by(Method::Automatic { tolerance: 1e-6 }, 1.0)).expect_err("open").to_string()
    };
    assert_eq!(
        refused(&simulation),
        "coupler and second are held together, but begin 1.000e-2 m and 0.000e0 m/s or rad/s apart, more than 0.0001: start where the \
         loop is closed, or take impulses, which draw them together (method: Impulses(step: 1e-3))"
    );
    simulation.set_start(&[0.3, -0.3, 0.3], &[1.0, 0.0, 0.0]).expect("valid");
    assert!(refused(&simulation).contains("0.000e0 m and"), "{}", refused(&simulation));
}

/// Chains of any joints, tied at their end to the world by a point or as a whole: they run, stay together and keep their energy, or are refused
/// by name; whether anything can move at all is left to chance.
#[test]
fn random_chains_stay_tied() {
    let mut seed = 12_345_u64;
    let mut random = |most: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) as f64 / f64::from(1_u32 << 31) * 2.0 - 1.0) * most
    };
    let (mut refused, mut moved) = (0, 0);
    for case in 0..60 {
        let links = 2 + case % 5;
        let mut builder = FigureBuilder::new("chain");
        for i in 0..links {
            let joint = match (random(1.0) * 2.0).abs() as usize {
                0 => Joint::new(format!("joint{i}")).rz(),
                _ if i % 3 == 2 => Joint::ball(format!("joint{i}")),
                _ => Joint::new(format!("joint{i}")).rx().ry(),
            };
            let joint = joint.at(Vector3::new(random(0.3), random(0.3), -0.3));
            let name = format!("link{i}");
            let link = if i == 0 {
                LinkSpec::root(name, joint)
            } else {
                LinkSpec::child(name, format!("link{}", i - 1), joint)
            };
            let inertia = 0.02 + random(0.01);
            builder = builder.link(
                link.mass(1.0 + random(0.9))
                    .com(Vector3::new(random(0.1), random(0.1), -0.1))
                    .inertia(Inertia::diagonal(inertia, inertia, inertia)),
            );
        }
        let figure = builder.build().expect("valid");
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        let mut q = simulation.state().0.to_vec();
        for dof in 0..figure.layout().nv() {
            if let Some(coordinate) = figure.layout().coordinate(dof) {
                q[coordinate] = random(0.7);
            }
        }
        simulation.set_start(&q, &vec![0.0; figure.layout().nv()]).expect("valid");
        let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("valid");
        let mut workspace = Workspace::new(&tree);
        forward_kinematics(&tree, &mut workspace, &q).expect("valid");
        let tip = Vector3::new(0.0, 0.1, -0.2);
        let between = [
            Anchor { link: Some(links - 1), point: tip },
            Anchor { link: None, point: workspace.pose(links - 1).transform(&tip) },
        ];
        let kind = if case % 4 == 3 { LoopKind::Weld } else { LoopKind::Connect };
        simulation.add_loop(Loop::new(between, kind)).expect("valid");
        match simulation.run(&by(Method::Automatic { tolerance: 1e-5 }, 0.3)) {
            Ok(run) => {
                let report = &run.report.loops[0];
                assert!(report.apart < 1e-5, "{case}: {report:?}");
                let energy = &run.report.energy;
                // What cannot move has no energy to compare with.
                assert!(energy.imbalance < 1e-4 * energy.scale.max(1e-2), "{case}: {energy:?}");
                let last = run.motion.q(30);
                moved += usize::from(last.iter().zip(&q).any(|(a, b)| (a - b).abs() > 1e-3));
            }
            Err(error) => {
                println!("{case}: {error}");
                refused += 1;
            }
        }
    }
    println!("{moved} of 60 moved, {refused} were refused");
    assert!(moved > 25 && refused < 3, "{moved} moved, {refused} refused");
}
