//! What acts at an instant of a run on its way, and what is changed there without a new drive: the same as in a whole run, and Newton's law.

use crate::running::{FIXED, RATE, STEP, arm, bits, bouncing, down, driven, falling};
use solaris_dynamics::{Tree, Workspace, center_of_mass};
use solaris_model::{EventKind, Human, Vector3};
use solaris_modes::time::Stepping;
use solaris_modes::{
    Aim, ContactLaw, Drive, EndCondition, GroundPlane, LimitLaw, Method, Push, PushLaw, Rule, RunError,
    Running, Servo, Settings, SetupError, Simulation, Step, contact_points,
};
use solaris_profiles::Profile;

const BY_IMPULSES: Stepping = Stepping::Impulses { step: STEP };

fn settings(stepping: Stepping, duration: f64) -> Settings {
    let method = match stepping {
        Stepping::Impulses { step } => Method::Impulses { step },
        _ => Method::Fixed { rule: Rule::RungeKutta4, step: STEP },
    };
    Settings { method, estimate: false, ..Settings::new(duration, RATE) }
}

/// How near two runs are whose steps fall on the same times, but not what is found on the way: steps by impulses begin anew where something
/// changes, are of order one, and bounce.
fn near(stepping: Stepping) -> f64 {
    if matches!(stepping, Stepping::Impulses { .. }) { 1e-3 } else { 1e-9 }
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn forces_and_contacts_are_those_of_a_whole_run() {
    let scenes = [
        ("bouncing", bouncing(), 1.0, FIXED),
        ("driven", driven(), 1.0, FIXED),
        ("on springs", falling(None), 0.3, FIXED),
        ("on rigid ground", falling(Some(ContactLaw::Rigid)), 0.3, FIXED),
        ("bouncing, by impulses", bouncing(), 1.0, BY_IMPULSES),
        ("falling, by impulses", falling(Some(ContactLaw::Rigid)), 0.6, BY_IMPULSES),
    ];
    for (name, simulation, duration, stepping) in scenes {
        let run = simulation.run(&settings(stepping, duration)).expect("runs");
        let mut running = simulation.start(stepping).expect("begins");
        let mut pressed = 0;
        for (frame, time) in run.motion.time().iter().enumerate().take(run.motion.len() - 1) {
            running.advance_to(*time).expect("goes on");
            let tau = running.forces().expect("forces").to_vec();
            assert_eq!(bits(&tau), bits(run.motion.tau(frame).expect("forces")), "{name}: tau at {time}");
            let figure = running.simulation().figure().clone();
            let found = running.contacts().expect("contacts").to_vec();
            for track in &run.motion.contacts {
                let link = figure.link_index(&track.link);
                let own = found.iter().find(|touching| Some(touching.link) == link);
                let own = own.map(|touching| touching.contact).unwrap_or_default();
                let expected = &track.samples[frame];
                assert!((own.force - expected.force).norm() < 1e-9, "{name} at {time}: {own:?} {expected:?}");
                assert!((own.moment - expected.moment).norm() < 1e-9, "{name} at {time}: {own:?}");
                assert!((own.cop - expected.cop).norm() < 1e-9, "{name} at {time}: {own:?} {expected:?}");
                pressed += usize::from(own.force.norm() > 1.0);
            }
        }
        assert!(pressed > 20 || run.motion.contacts.is_empty(), "{name}: {pressed}");
    }
}

/// Somebody limp, or as stiff as servos are, falls from a step: `m·c̈ = ΣF + m·g`, with `c̈` by differences of the centre of mass.
#[test]
fn contacts_carry_and_brake_the_body_by_newtons_law() {
    for (law, stepping) in [
        (None, FIXED),
        (Some(ContactLaw::Rigid), FIXED),
        (Some(ContactLaw::Rigid), Stepping::Impulses { step: 1e-3 }),
    ] {
        let simulation = falling(law);
        let figure = simulation.figure().clone();
        let tree: Tree<f64> = Tree::new(&figure, down()).expect("a tree");
        let mass = figure.mass();
        let mut workspace = Workspace::new(&tree);
        let mut running = simulation.start(stepping).expect("begins");
        let mut pressed = 0.0_f64;
        for _ in 0..30 {
            running.step(0.01).expect("goes on");
            let (q, v) = (running.q().to_vec(), running.v().to_vec());
            let a = running.accelerations().expect("finite").to_vec();
            let h = 1e-4;
            let mut at = |t: f64| {
                let moved: Vec<f64> = (0..q.len()).map(|i| q[i] + v[i] * t + 0.5 * a[i] * t * t).collect();
                center_of_mass(&tree, &mut workspace, &moved).expect("a posture")
            };
            let acceleration = (at(h) - 2.0 * at(0.0) + at(-h)) / (h * h);
            let found = running.contacts().expect("contacts");
            let force: Vector3<f64> = found.iter().map(|touching| touching.contact.force).sum();
            let missing = acceleration * mass - force - down() * mass;
            assert!(missing.norm() < 2.0, "{stepping:?}: {missing:?} of {force:?}");
            for touching in found {
                // About the centre of pressure the moment is normal to the ground.
                let contact = touching.contact;
                let about = contact.moment - contact.cop.cross(&contact.force);
                assert!(Vector3::new(about.x, 0.0, about.z).norm() < 1e-6, "{contact:?}");
            }
            pressed = pressed.max(force.y);
            // Nothing holds the root: its forces are none.
            let tau = running.forces().expect("forces");
            assert!(tau[..3].iter().all(|force| force.abs() < 1e-6 * mass * 9.8), "{:?}", &tau[..3]);
        }
        assert!(pressed > 0.5 * mass * 9.8, "{pressed}");
    }
}

/// Pushes over windows, along a curve and as blows, set on the way or written in a script.
#[test]
fn pushes_that_are_set_are_those_of_a_script() {
    let on = |from, law| Push { link: 2, point: Vector3::new(0.0, -0.3, 0.1), from, law };
    let force = Vector3::new(0.0, 3.0, -8.0);
    let bump = Profile::Line { from: 0.0, to: 2.0, duration: 0.2 };
    let pushes = [
        on(0.3, PushLaw::Force { force, over: 0.2 }),
        on(0.35, PushLaw::Along { force, profile: bump }),
        on(0.3, PushLaw::Impulse { impulse: 0.1 * force, over: 0.0 }),
        on(0.6, PushLaw::Impulse { impulse: -0.2 * force, over: 0.0 }),
    ];
    for (scene, stepping) in
        [(bouncing(), FIXED), (driven(), FIXED), (bouncing(), BY_IMPULSES), (driven(), BY_IMPULSES)]
    {
        let mut scripted = scene.clone();
        for push in &pushes {
            scripted.add_push(push.clone()).expect("valid");
        }
        let run = scripted.run(&settings(stepping, 1.0)).expect("runs");
        let mut running = scene.start(stepping).expect("begins");
        running.advance_to(0.3).expect("goes on");
        let before = running.clone();
        running.set_pushes(&pushes).expect("valid");
        for frame in 31..100 {
            running.advance_to(run.motion.time()[frame]).expect("goes on");
            let off = apart(running.q(), run.motion.q(frame)).max(apart(running.v(), run.motion.v(frame)));
            assert!(off < near(stepping), "{stepping:?}, frame {frame}: {off}");
        }
        // A blow that is over does not come again.
        running.set_pushes(&pushes[2..]).expect("valid");
        let blows = |running: &Running| {
            let is_blow =
                |kind: &EventKind| matches!(kind, EventKind::DriveChange { what } if what.contains("blow"));
            running.happened().events.iter().filter(|event| is_blow(&event.kind)).count()
        };
        assert_eq!(blows(&running), 0);
        // Nor does anything of what is taken away.
        let mut quiet = before.clone();
        quiet.set_pushes(&pushes).expect("valid");
        quiet.set_pushes(&[]).expect("valid");
        let mut struck = before;
        struck.set_pushes(&pushes[2..3]).expect("valid");
        struck.set_pushes(&[]).expect("valid");
        for running in [&mut quiet, &mut struck] {
            running.advance_to(0.55).expect("goes on");
        }
        assert!(apart(quiet.q(), struck.q()) < 1e-9);
    }
}

/// Whoever drags a point gives it another force in every frame.
#[test]
fn a_force_that_is_set_each_frame_is_a_script_of_windows() {
    for (scene, stepping, duration) in [
        (bouncing(), FIXED, 0.8),
        (bouncing(), BY_IMPULSES, 0.8),
        (falling(Some(ContactLaw::Rigid)), FIXED, 0.2),
        (falling(None), FIXED, 0.2),
    ] {
        let link = scene.figure().links().len() / 2;
        let point = Vector3::new(0.05, -0.1, 0.0);
        let force = |frame: usize| {
            let phase = 0.7 * frame as f64;
            20.0 * Vector3::new(0.3 * phase.cos(), phase.sin(), (2.0 * phase).cos())
        };
        let frames = (duration * RATE) as usize;
        let mut scripted = scene.clone();
        for frame in 0..frames {
            let law = PushLaw::Force { force: force(frame), over: 1.0 / RATE };
            scripted.add_push(Push { link, point, from: frame as f64 / RATE, law }).expect("valid");
        }
        let run = scripted.run(&settings(stepping, duration)).expect("runs");
        let mut running = scene.start(stepping).expect("begins");
        for frame in 0..frames {
            running.set_pushes(&[Push::steady(link, point, force(frame))]).expect("valid");
            running.advance_to(run.motion.time()[frame + 1]).expect("goes on");
            let off =
                apart(running.q(), run.motion.q(frame + 1)).max(apart(running.v(), run.motion.v(frame + 1)));
            assert!(off < 1e-8, "{stepping:?}, frame {frame}: {off}");
        }
    }
}

/// The arm held by servos.
fn led(limit: Option<f64>) -> Simulation {
    let mut simulation = Simulation::new(&arm(), down());
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    for joint in ["a_joint", "b_joint", "c_joint"] {
        simulation.drive(joint, [servo(0.4, limit)]).expect("valid");
    }
    simulation
}

fn servo(to: f64, limit: Option<f64>) -> Drive {
    Drive::Servo(Servo { aim: Aim::At(to), stiffness: 60.0, damping: 3.0, limit })
}

#[test]
fn a_target_that_is_set_is_the_next_servo_of_a_script() {
    for (limit, stepping) in
        [(None, FIXED), (Some(6.0), FIXED), (None, BY_IMPULSES), (Some(6.0), BY_IMPULSES)]
    {
        let mut scripted = led(limit);
        let first = Step { drive: servo(0.4, limit), until: EndCondition::Time(0.3) };
        scripted.drive("b_joint", [first, servo(-0.6, limit).into()]).expect("valid");
        let run = scripted.run(&settings(stepping, 1.0)).expect("runs");
        let mut running = led(limit).start(stepping).expect("begins");
        running.advance_to(0.3).expect("goes on");
        running.set_target(1, -0.6).expect("a servo");
        for frame in 31..100 {
            running.advance_to(run.motion.time()[frame]).expect("goes on");
            let off = apart(running.q(), run.motion.q(frame));
            assert!(off < near(stepping), "{limit:?}, {stepping:?}, frame {frame}: {off}");
        }
        assert!(running.q()[1] < 0.0);
    }
}

#[test]
fn what_is_no_target_and_no_push_is_refused_and_changes_nothing() {
    let mut simulation = led(None);
    let along = Aim::Along(Profile::Line { from: 0.0, to: 1.0, duration: 2.0 });
    let follows = Drive::Servo(Servo { aim: along, stiffness: 60.0, damping: 3.0, limit: None });
    simulation.drive("a_joint", [follows]).expect("valid");
    let held = Drive::Sum(vec![
        Drive::Torque(Profile::Line { from: 1.0, to: 1.0, duration: 9.0 }),
        servo(0.1, None),
    ]);
    simulation.drive("b_joint", [held]).expect("valid");
    simulation.drive("c_joint", [Drive::Free]).expect("valid");
    let mut running = simulation.start(FIXED).expect("begins");
    running.step(0.1).expect("goes on");
    let before = running.clone();
    for dof in [0, 2] {
        let error = running.set_target(dof, 0.3).expect_err("no servo to a place");
        assert!(matches!(error, RunError::Setup(SetupError::NotAServo { .. })), "{error}");
    }
    assert!(running.set_target(7, 0.3).is_err() && running.set_target(1, f64::NAN).is_err());
    let bad = Push::steady(9, Vector3::zeros(), Vector3::zeros());
    assert!(running.set_pushes(&[bad]).is_err());
    let nan = Push::steady(0, Vector3::zeros(), Vector3::new(f64::NAN, 0.0, 0.0));
    assert!(running.set_pushes(&[nan]).is_err());
    running.step(0.2).expect("goes on");
    let mut untouched = before.clone();
    untouched.step(0.2).expect("goes on");
    assert_eq!(bits(running.q()), bits(untouched.q()));
    // The servo in a sum is led elsewhere.
    running.set_target(1, 0.9).expect("a servo in a sum");
    running.step(0.2).expect("goes on");
    assert!(running.q()[1] > untouched.q()[1]);
}

/// A limp person on the ground is dragged by a wrist: pushes by impulses, in every frame another one.
#[test]
fn a_limp_person_can_be_dragged() {
    let figure = Human::new(1.75, 73.0).limp().build().expect("within range");
    let mut simulation = Simulation::new(&figure, down());
    let mut plane = GroundPlane::under(&figure, &down(), 0.6).expect("gravity");
    plane.law = ContactLaw::Rigid;
    simulation.set_ground(plane, contact_points(&figure)).expect("valid");
    simulation.stand().expect("a free root");
    let mut running = simulation.start(Stepping::Impulses { step: 1.0 / 240.0 }).expect("begins");
    let hand = figure.link_index("right_hand").expect("a hand");
    for frame in 0..240 {
        let pull = if frame < 60 { 0.0 } else { 250.0 };
        running
            .set_pushes(&[Push::steady(hand, Vector3::zeros(), Vector3::new(0.0, 80.0, pull))])
            .expect("valid");
        running.step(1.0 / 60.0).expect("goes on");
        assert!(running.q().iter().all(|q| q.is_finite()));
    }
    let pelvis = running.q()[2];
    assert!(pelvis > 0.5, "dragged by {pelvis} m");
}
