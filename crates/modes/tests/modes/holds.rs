//! Loops that hold for a time: taken hold of and let go, by forces and by impulses.

use crate::loops::{G, RATE, closed, four_bar, swung};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{Loop, LoopKind, Method, Settings, Simulation};

const METHODS: [Method; 3] = [
    Method::Automatic { tolerance: 1e-8 },
    Method::Fixed { rule: solaris_modes::Rule::RungeKutta4, step: 1e-3 },
    Method::Impulses { step: 1e-4 },
];

fn settings(method: Method, duration: f64) -> Settings {
    Settings { method, estimate: false, ..Settings::new(duration, 100.0) }
}

/// How near a method is to what is known (rad, m, or a speed).
fn near(method: Method) -> f64 {
    if matches!(method, Method::Impulses { .. }) { 2e-3 } else { 1e-6 }
}

const ENDS: [(&str, Vector3<f64>); 2] =
    [("coupler", Vector3::new(0.8, 0.0, 0.0)), ("second", Vector3::new(0.0, -0.5, 0.0))];

/// A parallelogram swings as one pendulum; let go, its second crank is a pendulum by itself, and nothing jumps.
#[test]
fn what_is_let_go_goes_on_by_itself() {
    let figure = four_bar();
    let (start, until) = (1.0, 0.63);
    for method in METHODS {
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        simulation.set_start(&[start, -start, start], &[0.0; 3]).expect("valid");
        let ends = closed(&figure, LoopKind::Connect, ENDS);
        simulation.add_loop(Loop { until, ..ends }).expect("valid");
        let run = simulation.run(&settings(method, 1.5)).expect("runs");
        let held = swung(start, RATE, 0.6);
        assert!(
            (run.motion.q(60)[0] - held).abs() < near(method),
            "{method:?}: {} {held}",
            run.motion.q(60)[0]
        );
        // From where and as fast as it is let go: `θ̈ = −g/(2 l/3) sin θ` with `l` = 0.5 m.
        let mut angle = swung(start, RATE, until);
        let falls = swung(start, RATE, until + 1e-3) - angle;
        let mut rate = falls.signum() * (2.0 * RATE * (angle.cos() - f64::cos(start))).sqrt();
        let (steps, length) = (87_000, 0.5 * 2.0 / 3.0);
        let h = 0.87 / f64::from(steps);
        for _ in 0..steps {
            let half = rate - 0.5 * h * G / length * angle.sin();
            angle += h * half;
            rate = half - 0.5 * h * G / length * angle.sin();
        }
        let found = run.motion.q(150)[2];
        assert!((found - angle).abs() < 3.0 * near(method), "{method:?}: {found} {angle}");
        let energy = &run.report.energy;
        assert!(energy.imbalance < near(method) * energy.scale, "{method:?}: {energy:?}");
        let events: Vec<String> = run.motion.events.iter().map(|event| format!("{:?}", event.kind)).collect();
        assert!(events.iter().any(|event| event.contains("coupler: lets go of second")), "{events:?}");
    }
}

/// Two blocks on rails beside each other.
fn blocks() -> Figure {
    let block = |name: &str, parent: &str, mass| {
        let joint = Joint::new(name).tx().tz();
        LinkSpec::child(name, parent, joint).mass(mass).inertia(Inertia::diagonal(0.1, 0.1, 0.1))
    };
    FigureBuilder::new("blocks")
        .link(LinkSpec::root("frame", Joint::new("frame")).mass(1.0))
        .link(block("left", "frame", 2.0))
        .link(block("right", "frame", 3.0))
        .build()
        .expect("valid")
}

/// Who comes by at 1 m/s and is taken hold of where both are at one place goes on with the other, `v⁺ = m₁ v/(m₁ + m₂)`, and loses the energy of a plastic impact.
#[test]
fn what_is_taken_hold_of_is_a_plastic_impact() {
    let figure = blocks();
    for kind in [LoopKind::Connect, LoopKind::Weld] {
        for method in METHODS {
            let mut simulation = Simulation::new(&figure, Vector3::zeros());
            simulation.set_start(&[-0.5, 0.0, 0.0, 0.0], &[1.0, 0.0, 0.0, 0.2]).expect("valid");
            let zero = Vector3::zeros();
            let ends = closed(&figure, kind, [("left", zero), ("right", Vector3::z() * -0.1)]);
            simulation.add_loop(Loop { from: 0.5, until: 1.0, ..ends }).expect("valid");
            let run = simulation.run(&settings(method, 1.5)).expect("runs");
            let (vx, vz) = (2.0 / 5.0, 0.2 * 3.0 / 5.0);
            for (frame, time) in [(80, 0.8), (150, 1.5)] {
                let (q, v) = (run.motion.q(frame), run.motion.v(frame));
                let since: f64 = time - 0.5;
                for (found, known) in [
                    (v[0], vx),
                    (v[2], vx),
                    (v[1], vz),
                    (v[3], vz),
                    (q[0], vx * since),
                    (q[2], vx * since),
                    (q[3], 0.1 + vz * since),
                ] {
                    assert!(
                        (found - known).abs() < near(method),
                        "{kind:?} {method:?} {frame}: {found} {known}"
                    );
                }
            }
            let lost = 0.5 * 2.0 * 3.0 / 5.0 * (1.0 + 0.04);
            let energy = &run.report.energy;
            assert!(energy.imbalance < 1e-3 * lost, "{method:?}: {energy:?}");
            let events: Vec<String> =
                run.motion.events.iter().map(|event| format!("{:?}", event.kind)).collect();
            assert!(events.iter().any(|event| event.contains("left: takes hold of right")), "{events:?}");
            assert!(run.report.loops[0].apart < 1e-6, "{:?}", run.report.loops[0]);
        }
    }
}

#[test]
fn what_is_far_is_refused_by_forces_and_drawn_together_by_impulses() {
    let figure = blocks();
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[-0.05, 0.0, 0.0, 0.0], &[0.0; 4]).expect("valid");
    let zero = Vector3::zeros();
    let ends = closed(&figure, LoopKind::Connect, [("left", zero), ("right", zero)]);
    simulation.add_loop(Loop { from: 0.5, ..ends }).expect("valid");
    let error = simulation.run(&settings(Method::Automatic { tolerance: 1e-6 }, 2.0)).expect_err("open");
    assert!(
        error
            .to_string()
            .contains("left and right are held together from 0.5 s on, but are 5.000e-2 m apart then"),
        "{error}"
    );
    let run = simulation.run(&settings(Method::Impulses { step: 1e-3 }, 2.0)).expect("runs");
    let (before, after) = (run.motion.q(50), run.motion.q(200));
    assert!((before[0] + 0.05).abs() < 1e-12 && (after[0] - after[2]).abs() < 1e-6, "{before:?} {after:?}");
    // Nothing pushes both.
    assert!((2.0 * after[0] + 3.0 * after[2] + 0.1).abs() < 1e-9, "{after:?}");
}

#[test]
fn a_time_that_is_none_is_refused() {
    let figure = blocks();
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    let ends = closed(&figure, LoopKind::Connect, [("left", Vector3::zeros()), ("right", Vector3::zeros())]);
    for (from, until) in [(-1.0, 2.0), (f64::NAN, 2.0), (1.0, 1.0), (1.0, 0.5), (1.0, f64::NAN)] {
        assert!(simulation.add_loop(Loop { from, until, ..ends }).is_err(), "{from} {until}");
    }
}

/// A snapshot of a run that is stepped goes on over both to the same bits, and as the run at once.
#[test]
fn a_running_state_takes_hold_and_lets_go() {
    let figure = blocks();
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[-0.5, 0.0, 0.0, 0.0], &[1.0, 0.0, 0.0, 0.2]).expect("valid");
    let zero = Vector3::zeros();
    let ends = closed(&figure, LoopKind::Connect, [("left", zero), ("right", Vector3::z() * -0.1)]);
    simulation.add_loop(Loop { from: 0.5, until: 1.0, ..ends }).expect("valid");
    for method in [METHODS[1], METHODS[2]] {
        let mut running = simulation.start(simulation.stepping_for(method)).expect("starts");
        running.advance_to(0.3).expect("goes on");
        let mut snapshot = running.clone();
        for to in [0.5, 0.7, 1.0, 1.4] {
            running.advance_to(to).expect("goes on");
            snapshot.advance_to(to).expect("goes on");
        }
        assert!(running.q().iter().zip(snapshot.q()).all(|(a, b)| a.to_bits() == b.to_bits()));
        assert!((running.v()[0] - 0.4).abs() < 1e-6, "{:?}", running.v());
    }
}
