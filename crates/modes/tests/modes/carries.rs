//! Loads that are taken up and let go, against the conservation of momentum.

use approx::assert_abs_diff_eq;
use nalgebra::Matrix3;
use solaris_dynamics::{Tree, Workspace, momentum};
use solaris_model::{EventKind, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Load, Vector3};
use solaris_modes::{Carry, Drive, Method, Rule, Run, Settings, Shape, Simulation};
use solaris_profiles::Profile;

fn settings(duration: f64, rate: f64) -> Settings {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 1e-3 };
    Settings { method, estimate: false, ..Settings::new(duration, rate) }
}

fn block() -> Figure {
    let link = LinkSpec::root("block", Joint::new("slide").tx()).mass(2.0);
    FigureBuilder::new("block").link(link).build().expect("valid")
}

fn point(link: usize, mass: f64, at: Vector3<f64>) -> Load {
    Load { link, mass, at, inertia: Matrix3::zeros() }
}

fn balanced(run: &Run) {
    let energy = &run.report.energy;
    assert!(energy.imbalance <= 1e-9 * energy.scale, "{energy:?}");
    let found = energy.start.total() + energy.work - energy.heat - energy.impacts + energy.moved;
    assert_abs_diff_eq!(energy.end.total(), found, epsilon = 1e-9 * energy.scale);
}

/// 2 kg at 3 m/s take up 4 kg that stand: 1 m/s, 6 J lost; let go, the block goes on as it was.
#[test]
fn a_block_shares_its_momentum_and_keeps_its_velocity_when_it_lets_go() {
    let mut simulation = Simulation::new(&block(), Vector3::zeros());
    simulation.set_start(&[0.0], &[3.0]).expect("valid");
    let load = point(0, 4.0, Vector3::new(0.0, 0.2, 0.0));
    simulation.add_carry(Carry { load, from: 0.5, until: 1.0 }).expect("valid");
    let run = simulation.run(&settings(2.0, 100.0)).expect("runs");
    assert_abs_diff_eq!(run.motion.v(49)[0], 3.0, epsilon = 1e-14);
    assert_abs_diff_eq!(run.motion.v(50)[0], 1.0, epsilon = 1e-14);
    assert_abs_diff_eq!(run.motion.v(200)[0], 1.0, epsilon = 1e-14);
    assert_abs_diff_eq!(run.report.energy.impacts, 6.0, epsilon = 1e-12);
    balanced(&run);
    let told: Vec<String> = run
        .motion
        .events
        .iter()
        .filter_map(|event| match &event.kind {
            EventKind::DriveChange { what } => Some(what.clone()),
            _ => None,
        })
        .collect();
    assert_eq!(told, ["block: takes up 4 kg", "block: lets go of 4 kg"]);
}

/// 6 N: 3 m/s² alone, 1 m/s² with the load; what is carried from the beginning moves with its link at the beginning.
#[test]
fn a_force_moves_what_it_has_to() {
    let mut simulation = Simulation::new(&block(), Vector3::zeros());
    simulation.set_start(&[0.0], &[3.0]).expect("valid");
    let torque = Drive::Torque(Profile::Line { from: 6.0, to: 6.0, duration: 5.0 });
    simulation.drive("slide", [torque]).expect("valid");
    let load = point(0, 4.0, Vector3::zeros());
    simulation.add_carry(Carry { load, from: 0.0, until: 0.505 }).expect("valid");
    let run = simulation.run(&settings(1.0, 100.0)).expect("runs");
    assert_abs_diff_eq!(run.motion.v(50)[0], 3.5, epsilon = 1e-12);
    assert_abs_diff_eq!(run.motion.v(100)[0], 3.505 + 3.0 * 0.495, epsilon = 1e-12);
    assert_abs_diff_eq!(run.motion.tau(20).expect("forces")[0], 6.0, epsilon = 1e-12);
    balanced(&run);
}

/// `I·ω` about a hinge: 0.5 kg m² at 2 rad/s take up a body of 0.5 kg m² and 1 kg, 1 m away.
#[test]
fn about_a_hinge_the_load_has_its_own_inertia_and_its_place() {
    let link =
        LinkSpec::root("wheel", Joint::new("hinge").rz()).mass(1.0).inertia(Inertia::diagonal(0.3, 0.3, 0.5));
    let figure = FigureBuilder::new("wheel").link(link).build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[0.3], &[2.0]).expect("valid");
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.4, 0.4, 0.5));
    let load = Load { link: 0, mass: 1.0, at: Vector3::new(1.0, 0.0, 0.0), inertia };
    simulation.add_carry(Carry { load, from: 0.2, until: f64::INFINITY }).expect("valid");
    let run = simulation.run(&settings(0.4, 100.0)).expect("runs");
    assert_abs_diff_eq!(run.motion.v(40)[0], 0.5, epsilon = 1e-13);
    balanced(&run);
}

/// A tree that floats: linear and angular momentum about the world's origin are those of before, found by the kernel's own question.
#[test]
fn what_floats_keeps_its_momentum() {
    let trunk =
        LinkSpec::root("trunk", Joint::free("root")).mass(5.0).inertia(Inertia::diagonal(0.3, 0.2, 0.4));
    let arm = Joint::new("shoulder").rx().rz().at(Vector3::new(0.2, 0.3, 0.0));
    let arm = LinkSpec::child("arm", "trunk", arm)
        .mass(1.5)
        .com(Vector3::new(0.0, -0.2, 0.0))
        .inertia(Inertia::diagonal(0.02, 0.002, 0.02));
    let figure = FigureBuilder::new("floats").link(trunk).link(arm).build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    let q = [0.1, 0.2, -0.3, 0.1, -0.2, 0.3, f64::sqrt(1.0 - 0.14), 0.4, -0.7];
    let v = [0.5, -0.3, 0.8, 1.0, -2.0, 0.7, 3.0, -1.5];
    simulation.set_start(&q, &v).expect("valid");
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.02, 0.03, 0.04));
    let load = Load { link: 1, mass: 2.0, at: Vector3::new(0.05, -0.4, 0.1), inertia };
    simulation.add_carry(Carry { load: load.clone(), from: 0.1, until: f64::INFINITY }).expect("valid");
    // A frame just before and one at the impact.
    let before = simulation.run(&settings(0.1 - 1e-9, 1e3)).expect("runs");
    let run = simulation.run(&settings(0.2, 1e3)).expect("runs");
    let of = |figure: &Figure, q: &[f64], v: &[f64]| {
        let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("valid");
        momentum(&tree, &mut Workspace::new(&tree), q, v).expect("finite")
    };
    let loaded = figure.carrying(&load).expect("a load");
    let last = before.motion.len() - 1;
    let alone = of(&figure, before.motion.q(last), before.motion.v(last));
    for frame in [100, 200] {
        let both = of(&loaded, run.motion.q(frame), run.motion.v(frame));
        assert_abs_diff_eq!(alone.linear, both.linear, epsilon = 1e-8);
        assert_abs_diff_eq!(alone.angular, both.angular, epsilon = 1e-8);
    }
    assert!(run.report.energy.impacts > 0.1);
    let energy = &run.report.energy;
    assert!(energy.imbalance <= 1e-6 * energy.scale, "{energy:?}");
}

/// What follows a curve is not slowed down: its drive has the force, `m·a` of what it then moves.
#[test]
fn on_a_curve_the_drive_bears_the_load() {
    let mut simulation = Simulation::new(&block(), Vector3::zeros());
    let to = Drive::Move { to: 1.0, over: 1.0, along: Shape::MinimumJerk };
    simulation.drive("slide", [to]).expect("valid");
    let load = point(0, 4.0, Vector3::zeros());
    simulation.add_carry(Carry { load, from: 0.3, until: 0.7 }).expect("valid");
    let run = simulation.run(&settings(1.0, 10.0)).expect("runs");
    for frame in 0..=10 {
        let mass = if (3..7).contains(&frame) { 6.0 } else { 2.0 };
        let force = mass * run.motion.a(frame)[0];
        assert_abs_diff_eq!(run.motion.tau(frame).expect("forces")[0], force, epsilon = 1e-10);
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let mut simulation = Simulation::new(&block(), Vector3::zeros());
    let load = || point(0, 4.0, Vector3::zeros());
    for (carry, said) in [
        (
            Carry { load: load(), from: -1.0, until: 2.0 },
            "the beginning of the load on 'block' is -1; it must be a finite number, zero or more",
        ),
        (
            Carry { load: load(), from: 2.0, until: 1.0 },
            "how long 'block' carries its load is -1; it must be a finite number above zero",
        ),
        (
            Carry { load: point(7, 1.0, Vector3::zeros()), from: 0.0, until: 1.0 },
            "figure 'block' has no link number 7",
        ),
    ] {
        assert_eq!(simulation.add_carry(carry).expect_err("refused").to_string(), said);
    }
}
