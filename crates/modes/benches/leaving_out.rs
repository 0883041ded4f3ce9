//! Time of a simulated second of a human, with (`true`) and without leaving out what nothing depends on: `cargo bench -p
//! solaris-modes --bench leaving_out`.

use divan::Bencher;
use nalgebra::Vector3;
use solaris_model::human;
use solaris_modes::{Drive, LimitLaw, Method, Rule, Run, Settings, Shape, Simulation};

fn main() {
    divan::main();
}

#[divan::bench(args = [true, false])]
fn loose_arm(bencher: Bencher<'_, '_>, leave_out: bool) {
    let others = Drive::Move { to: 0.2, over: 1.0, along: Shape::MinimumJerk };
    let simulation = scene(&others, &["left_shoulder", "left_elbow", "left_wrist"]);
    bencher.bench_local(|| run(&simulation, leave_out));
}

#[divan::bench(args = [true, false])]
fn all_but_a_leg_frozen(bencher: Bencher<'_, '_>, leave_out: bool) {
    let simulation = scene(&Drive::Frozen, &["left_hip", "left_knee", "left_ankle", "left_toes"]);
    bencher.bench_local(|| run(&simulation, leave_out));
}

#[divan::bench(args = [true, false])]
fn kinematic_only(bencher: Bencher<'_, '_>, leave_out: bool) {
    let all = Drive::Move { to: 0.2, over: 1.0, along: Shape::MinimumJerk };
    let simulation = scene(&all, &[]);
    bencher.bench_local(|| run(&simulation, leave_out));
}

/// A floating human; the joints `loose` have no drive, all others this one.
fn scene(others: &Drive, loose: &[&str]) -> Simulation {
    let figure = human(1.75, 73.0).expect("within range");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_limits(LimitLaw::Ignore).expect("no numbers");
    for link in figure.links() {
        let joint = link.joint().name();
        let is_loose = loose.contains(&joint);
        let drive = if is_loose { Drive::Free } else { others.clone() };
        simulation.drive(joint, [drive]).expect("a joint of the human");
    }
    simulation
}

/// A second by Runge-Kutta 4 at 1/240 s, in 60 frames.
fn run(simulation: &Simulation, leave_out: bool) -> Run {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 1.0 / 240.0 };
    let settings = Settings { method, estimate: false, forces: false, leave_out, ..Settings::new(1.0, 60.0) };
    simulation.run(&settings).expect("no trouble")
}
