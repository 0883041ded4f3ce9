//! Figures that leave a ground that plants what touches it, and come down on it: momentum and energy.

use crate::contact::planted::{forces, ground, kinds};
use crate::contact::{G, fixed, simulation};
use approx::assert_abs_diff_eq;
use solaris_model::{
    EventKind, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement, ShapeKind, Vector3,
};
use solaris_modes::{
    ContactPoint, Drive, EndCondition, Run, Settings, Shape, Simulation, Step, contact_points,
};
use solaris_profiles::Profile;

/// An upright trunk on a bent leg that a torque of the knee straightens: the ground lets go when it would pull, what flies keeps
/// its momentum, and it lands and stays.
fn jumper() -> Simulation {
    let solid = |mass: f64| Inertia::diagonal(0.02 * mass, 0.005 * mass, 0.02 * mass);
    let below = |y: f64| Vector3::new(0.0, y, 0.0);
    let link = |spec: LinkSpec, mass: f64, com: f64| spec.mass(mass).inertia(solid(mass)).com(below(com));
    let hip = Joint::new("hip").rx();
    let knee = Joint::new("knee").at(below(-0.4)).rx();
    let figure = FigureBuilder::new("jumper")
        .link(link(LinkSpec::root("trunk", Joint::new("root").tz().ty()), 50.0, 0.3))
        .link(link(LinkSpec::child("thigh", "trunk", hip), 12.0, -0.2))
        .link(link(LinkSpec::child("shank", "thigh", knee), 6.0, -0.2))
        .build()
        .expect("valid");
    let toe = ContactPoint { link: 2, center: below(-0.4), radius: 0.04 };
    let mut simulation = simulation(&figure, G, ground(0.8), vec![toe]);
    let straight =
        |drive: Drive| Step { drive, until: EndCondition::Position { dof: "knee".to_owned(), value: 0.25 } };
    let bend = |to: f64| Step::from(Drive::Move { to, over: 0.15, along: Shape::default() });
    let push = Drive::Torque(Profile::Line { from: -300.0, to: -300.0, duration: 5.0 });
    let hold = || Step::from(Drive::Frozen);
    simulation.drive("hip", [straight(Drive::Free), bend(-0.35), hold()]).expect("valid");
    simulation.drive("knee", [straight(push), bend(0.7), hold()]).expect("valid");
    let (hip, knee) = (-0.7_f64, 1.4_f64);
    let height = 0.4 * hip.cos() + 0.4 * (hip + knee).cos() + 0.04;
    simulation.set_start(&[0.0, height, hip, knee], &[0.0; 4]).expect("valid");
    simulation
}

fn momentum_of(run: &Run, figure: &Figure, frame: usize) -> Vector3<f64> {
    let tree = solaris_dynamics::Tree::<f64>::new(figure, Vector3::zeros()).expect("valid");
    let workspace = &mut solaris_dynamics::Workspace::new(&tree);
    solaris_dynamics::momentum(&tree, workspace, run.motion.q(frame), run.motion.v(frame))
        .expect("finite")
        .linear
}

#[test]
fn a_jumper_pushes_off_flies_and_lands() {
    let simulation = jumper();
    let run = simulation.run(&fixed(1.2, 200.0, 5e-4)).expect("runs");
    let events = kinds(&run.motion.events);
    assert_eq!(&events[..2], [(false, "shank"), (true, "shank")], "{:?}", run.motion.events);
    let times: Vec<f64> = run
        .motion
        .events
        .iter()
        .filter(|event| matches!(event.kind, EventKind::LiftOff { .. } | EventKind::TouchDown { .. }))
        .map(|event| event.time)
        .collect();
    let mass = simulation.figure().mass();
    // In flight the momentum changes by the weight alone.
    let flying: Vec<usize> = (0..run.motion.len())
        .filter(|frame| run.motion.time()[*frame] > times[0] && run.motion.time()[*frame] < times[1])
        .collect();
    assert!(flying.len() > 10, "{times:?}");
    let first = momentum_of(&run, simulation.figure(), flying[0]);
    for &frame in &flying {
        let passed = run.motion.time()[frame] - run.motion.time()[flying[0]];
        let expected = first - Vector3::y() * (mass * G * passed);
        assert_abs_diff_eq!(momentum_of(&run, simulation.figure(), frame), expected, epsilon = 1e-8 * mass);
        assert_eq!(forces(&run.motion, "shank")[frame], Vector3::zeros());
    }
    // Over all of it, by what the ground did.
    let last = run.motion.len() - 1;
    let ground = run.report.ground.as_ref().expect("a ground");
    let change = momentum_of(&run, simulation.figure(), last);
    assert_abs_diff_eq!(ground.impulse[1] - mass * G * 1.2, change.y, epsilon = 1e-7 * mass);
    assert_abs_diff_eq!(ground.impulse[2], change.z, epsilon = 1e-7 * mass);
    assert!(!ground.landings.is_empty());
    // The ground never pulls with more than a few millionths of the weight.
    assert!(forces(&run.motion, "shank").iter().all(|force| force.y >= -2e-6 * mass * G));
    assert!(ground.deepest().expect("it touches").depth < 1e-6);
    assert!(run.report.energy.imbalance < 1e-6 * run.report.energy.scale, "{:?}", run.report.energy);
    // The forces of the drives are those that were asked for, and nothing acts on the root.
    let tau = run.motion.tau(3).expect("forces");
    for (found, given) in tau.iter().zip([0.0, 0.0, 0.0, -300.0]) {
        assert_abs_diff_eq!(*found, given, epsilon = 1e-8);
    }
}

#[test]
fn what_is_left_out_changes_nothing() {
    let simulation = jumper();
    let settings = fixed(1.0, 100.0, 1e-3);
    let whole = simulation.run(&Settings { leave_out: false, ..settings.clone() }).expect("runs");
    let lean = simulation.run(&settings).expect("runs");
    for frame in 0..lean.motion.len() {
        for (a, b) in lean.motion.q(frame).iter().zip(whole.motion.q(frame)) {
            assert_abs_diff_eq!(*a, *b, epsilon = 1e-8);
        }
    }
    assert_eq!(kinds(&lean.motion.events), kinds(&whole.motion.events));
}

/// Chains of thick rods, thrown to the ground turning: what the ground does never adds energy, whatever lands on what, and momentum is
/// accounted for.
#[test]
fn what_is_thrown_loses_energy_only() {
    let mut landings = 0;
    for seed in 0..12_u32 {
        let (angle, ratio) = (0.5 * f64::from(seed), [1.0, 1e-3, 1e3][seed as usize % 3]);
        let solid = |radius: f64| solaris_model::Shape {
            kind: ShapeKind::Capsule { radius, length: 0.4 },
            placement: Placement::translation(0.0, -0.2, 0.0),
        };
        let down = Vector3::new(0.0, -0.4, 0.0);
        let rod = |link: LinkSpec, mass: f64| {
            link.mass(mass).inertia(Inertia::Uniform(solid(0.08))).shape(solid(0.08))
        };
        let hinge = Joint::new("hinge").at(down).rx().rz();
        let figure = FigureBuilder::new("chain")
            .link(rod(LinkSpec::root("first", Joint::free("root")), 1.0))
            .link(rod(LinkSpec::child("second", "first", hinge), ratio))
            .build()
            .expect("valid");
        let mut simulation = simulation(&figure, G, ground(0.8), contact_points(&figure));
        let turn = [0.3 * angle.sin(), 0.2, 0.1 * angle, 0.9];
        let length = turn.iter().map(|x| x * x).sum::<f64>().sqrt();
        let turn = turn.map(|x| x / length);
        let q = [0.0, 1.5, 0.0, turn[0], turn[1], turn[2], turn[3], 0.4, -0.2];
        let v = [1.0, 0.5, -0.4, angle.cos(), -1.0, 2.0, 1.0, 0.5];
        simulation.set_start(&q, &v).expect("valid");
        let settings = Settings { forces: false, ..fixed(1.0, 200.0, 5e-4) };
        let run = simulation.run(&settings).unwrap_or_else(|error| panic!("chain {seed}: {error}"));
        let (ground, energy) = (run.report.ground.as_ref().expect("a ground"), &run.report.energy);
        landings += ground.landings.len();
        eprintln!(
            "chain {seed}: {} landings, {:.1e} of the energy unaccounted for, deepest {:.1e} m",
            ground.landings.len(),
            energy.imbalance / energy.scale,
            ground.deepest().map_or(0.0, |link| link.depth),
        );
        for landing in &ground.landings {
            assert!(landing.loss >= -1e-9 * energy.scale, "chain {seed}: {landing:?}");
        }
        assert!(energy.imbalance < 1e-6 * energy.scale, "chain {seed}: {energy:?}");
        assert!(ground.deepest().expect("it falls").depth < 1e-8, "chain {seed}");
        let last = run.motion.len() - 1;
        let momentum = momentum_of(&run, &figure, last) - momentum_of(&run, &figure, 0);
        let weight = figure.mass() * G;
        let impulse = Vector3::from(ground.impulse) - Vector3::y() * weight;
        assert_abs_diff_eq!(impulse, momentum, epsilon = 1e-6 * weight);
    }
    assert!(landings > 30, "{landings}");
}
