//! Pushes of the world against Newton's laws: constant, along a curve, as an impulse over a time and in an instant.

use approx::assert_abs_diff_eq;
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{
    ContactLaw, Drive, GroundPlane, LimitLaw, Method, Push, PushLaw, Rule, Run, Settings, Shape, Simulation,
    contact_points,
};
use solaris_profiles::Profile;

fn settings(duration: f64, rate: f64, step: f64) -> Settings {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step };
    Settings { method, estimate: false, ..Settings::new(duration, rate) }
}

/// A block of 2 kg that slides along x.
fn block() -> Simulation {
    let link = LinkSpec::root("block", Joint::new("slide").tx()).mass(2.0);
    let figure = FigureBuilder::new("block").link(link).build().expect("valid");
    Simulation::new(&figure, Vector3::zeros())
}

/// A free body of 3 kg with the inertias 0.2, 0.3 and 0.4 kg m² about its axes.
fn body() -> Figure {
    let link =
        LinkSpec::root("body", Joint::free("root")).mass(3.0).inertia(Inertia::diagonal(0.2, 0.3, 0.4));
    FigureBuilder::new("free").link(link).build().expect("valid")
}

fn balanced(run: &Run, most: f64) {
    let energy = &run.report.energy;
    assert!(energy.imbalance <= most * energy.scale, "{energy:?}");
    let found = energy.start.total() + energy.work + energy.pushes - energy.heat - energy.impacts;
    assert_abs_diff_eq!(energy.end.total(), found, epsilon = most * energy.scale);
}

/// 4 N on 2 kg from 0.235 to 0.735 s: 1 m/s, 0.25 m, 1 J, whether frames and steps fall on its ends or not.
#[test]
fn a_force_over_a_window_gives_its_impulse_and_its_work() {
    let mut simulation = block();
    let law = PushLaw::Force { force: Vector3::new(4.0, 7.0, 0.0), over: 0.5 };
    simulation
        .add_push(Push { link: 0, point: Vector3::new(0.0, 0.3, 0.0), from: 0.235, law })
        .expect("valid");
    let run = simulation.run(&settings(1.0, 100.0, 1e-2)).expect("runs");
    for frame in 0..=100 {
        let t = frame as f64 / 100.0;
        let on = (t - 0.235).clamp(0.0, 0.5);
        let x = on * on + (t - 0.735).max(0.0);
        assert_abs_diff_eq!(run.motion.v(frame)[0], 2.0 * on, epsilon = 1e-12);
        assert_abs_diff_eq!(run.motion.q(frame)[0], x, epsilon = 1e-12);
        // Nothing drives it.
        assert_abs_diff_eq!(run.motion.tau(frame).expect("forces")[0], 0.0, epsilon = 1e-12);
    }
    assert_abs_diff_eq!(run.report.energy.pushes, 1.0, epsilon = 1e-12);
    assert_abs_diff_eq!(run.report.energy.work, 0.0, epsilon = 1e-12);
    balanced(&run, 1e-12);
}

/// The same impulse along a curve, over a time, in an instant at the beginning and later: the same velocity.
#[test]
fn impulses_are_what_they_say_however_long_they_take() {
    // ∫ of a quintic from 0 to 1 over T is T/2.
    let profile = Profile::MinimumJerk { from: 0.0, to: 1.0, duration: 0.5 };
    let laws = [
        (0.2, PushLaw::Along { force: Vector3::new(12.0, 0.0, 0.0), profile }),
        (0.2, PushLaw::Impulse { impulse: Vector3::new(3.0, 0.0, 0.0), over: 0.3 }),
        (0.2, PushLaw::Impulse { impulse: Vector3::new(3.0, 0.0, 0.0), over: 0.0 }),
        (0.0, PushLaw::Impulse { impulse: Vector3::new(3.0, 0.0, 0.0), over: 0.0 }),
    ];
    for (from, law) in laws {
        let mut simulation = block();
        simulation.set_start(&[0.0], &[0.5]).expect("valid");
        simulation
            .add_push(Push { link: 0, point: Vector3::zeros(), from, law: law.clone() })
            .expect("valid");
        let run = simulation.run(&settings(1.0, 100.0, 1e-3)).expect("runs");
        assert_abs_diff_eq!(run.motion.v(100)[0], 0.5 + 1.5, epsilon = 1e-10);
        // ½·2·(2² − 0.5²)
        assert_abs_diff_eq!(run.report.energy.pushes, 3.75, epsilon = 1e-9);
        assert_abs_diff_eq!(run.report.energy.start.kinetic, 0.25, epsilon = 1e-12);
        balanced(&run, 1e-9);
    }
}

/// A blow off the centre of a body that floats and turns: `Δv = p/m`, `Δω = I⁻¹·(r × p)`, both in the world's axes.
#[test]
fn a_blow_off_the_centre_turns_a_free_body() {
    let mut simulation = Simulation::new(&body(), Vector3::zeros());
    // A quarter turn about z: the body's x is the world's y.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    simulation.set_start(&[0.0, 0.0, 0.0, 0.0, 0.0, half, half], &[0.0; 6]).expect("valid");
    let impulse = Vector3::new(0.0, 0.0, 1.5);
    let law = PushLaw::Impulse { impulse, over: 0.0 };
    // 0.4 m along the body's x, the world's y: r × p = (0.4·1.5, 0, 0) in the world, −y in the body.
    simulation.add_push(Push { link: 0, point: Vector3::new(0.4, 0.0, 0.0), from: 0.1, law }).expect("valid");
    let run = simulation.run(&settings(0.1 + 1e-6, 1e4, 1e-6)).expect("runs");
    let v = run.motion.v(run.motion.len() - 1);
    let expected = [0.0, 0.0, 0.5, 0.0, -0.6 / 0.3, 0.0];
    for (found, expected) in v.iter().zip(expected) {
        assert_abs_diff_eq!(*found, expected, epsilon = 1e-5);
    }
    // ½·p²/m + ½·0.6²/0.3
    assert_abs_diff_eq!(run.report.energy.pushes, 0.5 * 2.25 / 3.0 + 0.5 * 0.36 / 0.3, epsilon = 1e-12);
}

/// What is prescribed does not give way: its drive has the force on it, `τ = m·a − F`.
#[test]
fn what_has_a_motion_of_its_own_is_held_against_it() {
    let mut simulation = block();
    let drive = Drive::Move { to: 1.0, over: 1.0, along: Shape::MinimumJerk };
    simulation.drive("slide", [drive]).expect("valid");
    let law = PushLaw::Force { force: Vector3::new(5.0, 0.0, 0.0), over: 0.4 };
    simulation.add_push(Push { link: 0, point: Vector3::zeros(), from: 0.3, law }).expect("valid");
    let run = simulation.run(&settings(1.0, 10.0, 1e-2)).expect("runs");
    for frame in 0..=10 {
        let pushed = if (3..7).contains(&frame) { 5.0 } else { 0.0 };
        let tau = 2.0 * run.motion.a(frame)[0] - pushed;
        assert_abs_diff_eq!(run.motion.tau(frame).expect("forces")[0], tau, epsilon = 1e-10);
    }
}

/// A push on a link of a tree, with and without what can be left out: the same motion; the stiff method has its derivatives.
#[test]
fn leaving_out_changes_nothing() {
    let rod = |name: &str, parent: Option<&str>| {
        let joint = Joint::new(format!("{name}_hinge")).rx().at(Vector3::new(0.0, -0.4, 0.0));
        let link = match parent {
            None => LinkSpec::root(name, joint),
            Some(parent) => LinkSpec::child(name, parent, joint),
        };
        link.mass(1.0).com(Vector3::new(0.0, -0.2, 0.0)).inertia(Inertia::diagonal(0.01, 0.01, 0.01))
    };
    let figure = FigureBuilder::new("three")
        .link(rod("a", None))
        .link(rod("b", Some("a")))
        .link(rod("c", Some("b")))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let drive = Drive::Move { to: 0.6, over: 0.5, along: Shape::MinimumJerk };
    simulation.drive("a_hinge", [drive]).expect("valid");
    simulation.drive("b_hinge", [Drive::Frozen]).expect("valid");
    for (link, from) in [(2, 0.13), (1, 0.2), (0, 0.0)] {
        let law = PushLaw::Force { force: Vector3::new(0.0, 3.0, 8.0), over: 0.3 };
        simulation.add_push(Push { link, point: Vector3::new(0.0, -0.4, 0.1), from, law }).expect("valid");
    }
    let reduced = simulation.run(&settings(0.6, 100.0, 1e-3)).expect("runs");
    let whole = Settings { leave_out: false, ..settings(0.6, 100.0, 1e-3) };
    let whole = simulation.run(&whole).expect("runs");
    for frame in 0..=60 {
        assert_abs_diff_eq!(reduced.motion.q(frame)[2], whole.motion.q(frame)[2], epsilon = 1e-10);
        for dof in 0..3 {
            let tau = [&reduced, &whole].map(|run| run.motion.tau(frame).expect("forces")[dof]);
            assert_abs_diff_eq!(tau[0], tau[1], epsilon = 1e-9);
        }
    }
    balanced(&reduced, 1e-8);
    #[cfg(feature = "stiff")]
    {
        let method = Method::Stiff { tolerance: 1e-10 };
        let stiff = simulation.run(&Settings { method, ..settings(0.6, 100.0, 1e-3) }).expect("runs");
        assert_abs_diff_eq!(stiff.motion.q(60)[2], reduced.motion.q(60)[2], epsilon = 1e-6);
    }
}

/// A block of 3 kg on rigid ground: 20 N sideways for 0.1 s on what may not slide moves nothing, a blow up of 6 N s throws it with
/// 2 m/s, and one down is the ground's.
#[test]
fn on_ground_a_blow_down_is_taken_and_one_up_throws() {
    let gravity = 9.81;
    let throw = |impulse: f64| {
        let link =
            LinkSpec::root("block", Joint::new("slide").tx().ty()).mass(3.0).shape(solaris_model::Shape {
                kind: solaris_model::ShapeKind::Box { size: Vector3::new(0.2, 0.2, 0.2) },
                placement: solaris_model::Placement::identity(),
            });
        let figure = FigureBuilder::new("block").link(link).build().expect("valid");
        let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -gravity, 0.0));
        let plane = GroundPlane::under(&figure, &Vector3::new(0.0, -gravity, 0.0), 1.0).expect("a plane");
        let plane = GroundPlane { law: ContactLaw::Rigid, ..plane };
        let points = contact_points(&figure);
        simulation.set_ground(plane, points).expect("valid");
        simulation.stand().expect("it slides down");
        let law = PushLaw::Impulse { impulse: Vector3::new(0.0, impulse, 0.0), over: 0.0 };
        simulation.add_push(Push { link: 0, point: Vector3::zeros(), from: 0.1, law }).expect("valid");
        let run = simulation.run(&settings(0.25, 100.0, 1e-3)).expect("runs");
        (run.motion.q(25)[1] - run.motion.q(0)[1], run.motion.v(25)[1])
    };
    let (rise, speed) = throw(6.0);
    assert_abs_diff_eq!(rise, 2.0 * 0.15 - 0.5 * gravity * 0.15 * 0.15, epsilon = 1e-9);
    assert_abs_diff_eq!(speed, 2.0 - gravity * 0.15, epsilon = 1e-9);
    let (rise, speed) = throw(-6.0);
    assert_abs_diff_eq!(rise, 0.0, epsilon = 1e-9);
    assert_abs_diff_eq!(speed, 0.0, epsilon = 1e-6);
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let mut simulation = block();
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    let force = |over| PushLaw::Force { force: Vector3::x(), over };
    for (push, said) in [
        (
            Push { link: 3, point: Vector3::zeros(), from: 0.0, law: force(1.0) },
            "figure 'block' has no link 'number 3'",
        ),
        (
            Push { link: 0, point: Vector3::zeros(), from: -1.0, law: force(1.0) },
            "the beginning of the push on 'block' is -1; it must be a finite number, zero or more",
        ),
        (
            Push { link: 0, point: Vector3::zeros(), from: 0.0, law: force(0.0) },
            "the time of the push on 'block' is 0; it must be a finite number above zero",
        ),
        (
            Push { link: 0, point: Vector3::zeros(), from: 0.0, law: force(1e-12) },
            "the time of the push on 'block' is 0.000000000001; it must be 1e-9 s and more",
        ),
        (
            Push { link: 0, point: Vector3::new(0.0, f64::NAN, 0.0), from: 0.0, law: force(1.0) },
            "the point of the push on 'block' is NaN; it must be a finite number",
        ),
    ] {
        assert_eq!(simulation.add_push(push).expect_err("refused").to_string(), said);
    }
}
