//! Simulations that are stepped bit by bit.

use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Vector3, human};
use solaris_modes::time::Stepping;
use solaris_modes::{
    ContactLaw, Course, Drive, EndCondition, GroundPlane, Law, LimitLaw, Method, OutcomeKind, Rule, RunError,
    Running, Settings, SetupError, Shape, Simulation, Step, Target, contact_points,
};
use solaris_profiles::Profile;

pub(crate) const STEP: f64 = 5e-4;
pub(crate) const RATE: f64 = 100.0;
pub(crate) const FIXED: Stepping = Stepping::Fixed { rule: Rule::RungeKutta4, step: STEP };

pub(crate) fn down() -> Vector3<f64> {
    Vector3::new(0.0, -9.80665, 0.0)
}

/// Three rods on hinges, with limits.
pub(crate) fn arm() -> Figure {
    let rod = |name: &str, parent: Option<&str>| {
        let joint = Joint::new(format!("{name}_joint")).rx().limited(-1.2, 1.0);
        let link = match parent {
            None => LinkSpec::root(name, joint),
            Some(parent) => LinkSpec::child(name, parent, joint.at(Vector3::new(0.0, -0.4, 0.0))),
        };
        link.mass(1.5).com(Vector3::new(0.0, -0.2, 0.0))
    };
    let builder = FigureBuilder::new("arm").link(rod("a", None)).link(rod("b", Some("a")));
    builder.link(rod("c", Some("b"))).build().expect("valid")
}

/// What falls into its limits, and bounces.
pub(crate) fn bouncing() -> Simulation {
    let mut simulation = Simulation::new(&arm(), down());
    simulation.set_start(&[0.9, 0.3, -0.5], &[1.0, -2.0, 3.0]).expect("valid");
    simulation.set_limits(LimitLaw::Hard { restitution: 0.4 }).expect("valid");
    simulation
}

/// One drive after the other, by the clock, by themselves and by what others do.
pub(crate) fn driven() -> Simulation {
    let mut simulation = Simulation::new(&arm(), down());
    simulation.set_limits(LimitLaw::Spring { stiffness: 40.0, damping: 2.0 }).expect("valid");
    let simple = Drive::Simple { target: Target::at(0.6), course: Course::HalfCosine };
    let passes = EndCondition::Position { dof: "b_joint.rx".to_owned(), value: -0.2 };
    simulation
        .drive(
            "a_joint",
            [Step { drive: Drive::Free, until: EndCondition::Time(0.2) }, simple.into(), Drive::Free.into()],
        )
        .expect("valid");
    let quick = Drive::Move { to: -0.7, over: 0.45, along: Shape::MinimumJerk };
    simulation.drive("b_joint", [quick, Drive::Frozen]).expect("valid");
    let torque = Drive::Torque(Profile::Line { from: 0.0, to: 3.0, duration: 0.3 });
    simulation
        .drive("c_joint", [Step { drive: torque, until: passes }, Step::from(Drive::Free)])
        .expect("valid");
    simulation
}

/// A person who falls over, on ground of springs or rigid.
pub(crate) fn falling(law: Option<ContactLaw>) -> Simulation {
    let figure = human(1.75, 73.0).expect("within range");
    let mut simulation = Simulation::new(&figure, down());
    let mut plane = GroundPlane::under(&figure, &down(), 0.8).expect("gravity");
    plane.law = law.unwrap_or(plane.law);
    simulation.set_ground(plane, contact_points(&figure)).expect("valid");
    for link in figure.links() {
        let joint = link.joint().name();
        if joint != "root" {
            simulation.drive(joint, [Drive::Frozen]).expect("a joint");
        }
    }
    simulation.stand().expect("a root that slides");
    let (mut q, mut v) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nv()]);
    q.copy_from_slice(simulation.state().0);
    v[2] = 0.6;
    simulation.set_start(&q, &v).expect("valid");
    simulation
}

pub(crate) fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|x| x.to_bits()).collect()
}

#[test]
fn what_is_stepped_is_what_is_run_to_the_bit() {
    let scenes = [
        ("bouncing", bouncing(), 2.0),
        ("driven", driven(), 1.5),
        ("on springs", falling(None), 0.3),
        ("on rigid ground", falling(Some(ContactLaw::Rigid)), 0.3),
    ];
    let fixed = scenes.map(|(name, simulation, duration)| (name, simulation, duration, FIXED));
    let by_impulses = Stepping::Impulses { step: STEP };
    let others = [
        ("bouncing, by impulses", bouncing(), 1.0, by_impulses),
        ("driven, by impulses", driven(), 1.5, by_impulses),
        ("falling, by impulses", falling(Some(ContactLaw::Rigid)), 1.0, by_impulses),
    ];
    for (name, simulation, duration, stepping) in fixed.into_iter().chain(others) {
        let method = match stepping {
            Stepping::Impulses { step } => Method::Impulses { step },
            _ => Method::Fixed { rule: Rule::RungeKutta4, step: STEP },
        };
        let settings = Settings { method, estimate: false, ..Settings::new(duration, RATE) };
        let run = simulation.run(&settings).expect("runs");
        let mut running = simulation.start(stepping).expect("begins");
        let (mut impacts, mut outcomes, mut events) = (Vec::new(), Vec::new(), Vec::new());
        for (frame, time) in run.motion.time().iter().enumerate() {
            running.advance_to(*time).expect("goes on");
            let happened = running.happened();
            impacts.extend_from_slice(happened.impacts);
            outcomes.extend_from_slice(happened.outcomes);
            events.extend_from_slice(happened.events);
            assert_eq!(bits(running.q()), bits(run.motion.q(frame)), "{name}: q at {time}");
            assert_eq!(bits(running.v()), bits(run.motion.v(frame)), "{name}: v at {time}");
            let a = running.accelerations().expect("finite").to_vec();
            // At the end of a run nothing begins any more.
            if frame + 1 < run.motion.len() {
                assert_eq!(bits(&a), bits(run.motion.a(frame)), "{name}: a at {time}");
            }
        }
        assert_eq!(impacts, run.report.impacts, "{name}");
        for outcome in &run.report.outcomes {
            let unfinished = [OutcomeKind::Unfinished, OutcomeKind::NotBegun].contains(&outcome.result);
            assert!(unfinished || outcomes.contains(outcome), "{name}: {outcome:?}");
        }
        let drives = |events: &[solaris_model::Event]| {
            let is_drive = |event: &&solaris_model::Event| {
                matches!(event.kind, solaris_model::EventKind::DriveChange { .. }) && event.time < duration
            };
            events.iter().filter(is_drive).cloned().collect::<Vec<_>>()
        };
        assert_eq!(drives(&events), drives(&run.motion.events), "{name}");
    }
}

#[test]
fn a_clone_goes_on_to_the_same_bits_and_does_not_disturb() {
    for simulation in [bouncing(), driven(), falling(Some(ContactLaw::Rigid))] {
        let mut running = simulation.start(FIXED).expect("begins");
        running.step(0.1234).expect("goes on");
        let snapshot = running.clone();
        let on = |mut running: Running| {
            let times = [0.01, 0.0033, 1.0 / 60.0, 0.05];
            for dt in times {
                running.step(dt).expect("goes on");
            }
            (bits(running.q()), bits(running.v()))
        };
        let (first, again) = (on(running), on(snapshot.clone()));
        assert_eq!(first, again);
        assert_eq!(first, on(snapshot));
    }
}

#[test]
fn steps_of_any_length_come_to_the_same_motion() {
    // Where the steps of the caller end changes no more than the steps of the rule do.
    let at_the_end = |dt: f64| {
        let mut running = bouncing().start(FIXED).expect("begins");
        while running.time() < 1.0 - 1e-9 {
            running.step(dt.min(1.0 - running.time())).expect("goes on");
        }
        running.q().to_vec()
    };
    let whole = at_the_end(1.0);
    for dt in [0.5, 1.0 / 60.0, 0.0017, 0.0004] {
        for (q, expected) in at_the_end(dt).iter().zip(&whole) {
            assert!((q - expected).abs() < 1e-6, "{dt}: {q} and {expected}");
        }
    }
}

#[test]
fn a_force_acts_from_when_it_is_set() {
    // 2 kg on a rail: 4 N for 0.5 s, then −8 N for 0.25 s: it stands again after 1/4 + 1/8 m.
    let figure = FigureBuilder::new("cart")
        .link(LinkSpec::root("cart", Joint::new("rail").tx()).mass(2.0))
        .build()
        .expect("valid");
    let simulation = Simulation::new(&figure, Vector3::zeros());
    let mut running = simulation.start(FIXED).expect("begins");
    running.set_force(0, 4.0).expect("free");
    running.step(0.5).expect("goes on");
    assert!((running.q()[0] - 0.25).abs() < 1e-12 && (running.v()[0] - 1.0).abs() < 1e-12);
    running.set_force(0, -8.0).expect("free");
    assert!((running.accelerations().expect("finite")[0] + 4.0).abs() < 1e-12);
    running.step(0.25).expect("goes on");
    assert!((running.q()[0] - 0.375).abs() < 1e-12 && running.v()[0].abs() < 1e-12);
    // A force lifts what rests at a limit off it.
    let mut hanging = Simulation::new(&arm(), down());
    hanging.set_start(&[1.0, 0.0, 0.0], &[0.0; 3]).expect("valid");
    let mut running = hanging.start(FIXED).expect("begins");
    running.set_force(0, 60.0).expect("free");
    running.step(0.1).expect("goes on");
    assert_eq!(running.q()[0].to_bits(), 1.0_f64.to_bits());
    running.set_force(0, 0.0).expect("free");
    running.step(0.1).expect("goes on");
    assert!(running.q()[0] < 0.99);
}

#[test]
fn drives_limits_and_states_may_change_on_the_way() {
    let mut running = bouncing().start(FIXED).expect("begins");
    running.step(0.2).expect("goes on");
    let target = Target::at(0.5);
    let simple = Drive::Intensive { target, duration: 0.5, law: Law::Cubic, limit: None };
    running.drive("b_joint", [simple, Drive::Frozen]).expect("valid");
    assert_eq!(running.happened().outcomes.len(), 1);
    for _ in 0..60 {
        running.step(0.01).expect("goes on");
    }
    assert!((running.q()[1] - 0.5).abs() < 0.02, "{:?}", running.q());
    assert_eq!(running.v()[1].to_bits(), 0.0_f64.to_bits());
    // Without its limits the first joint goes through.
    running.drive("a_joint", [Drive::Free]).expect("valid");
    running.set_limit("a_joint", LimitLaw::Ignore).expect("valid");
    running.set_force(0, 50.0).expect("free");
    running.step(0.5).expect("goes on");
    assert!(running.q()[0] > 1.1, "{:?}", running.q());
    running.set_state(&[0.1, 0.5, 0.3], &[0.0; 3]).expect("valid");
    assert_eq!(running.q(), [0.1, 0.5, 0.3]);
    running.step(0.01).expect("goes on");
    assert!((running.q()[0] - 0.1).abs() < 0.05);
}

/// A refused force cleared what had happened before.
#[test]
fn a_refused_force_leaves_what_happened() {
    let mut running = driven().start(FIXED).expect("begins");
    running.step(1.0).expect("goes on");
    let outcomes = running.happened().outcomes.len();
    assert!(outcomes > 0);
    assert!(running.set_force(1, 1.0).is_err());
    assert_eq!(running.happened().outcomes.len(), outcomes);
    running.set_force(0, 1.0).expect("free");
    assert_eq!(running.happened().outcomes.len(), 0);
}

#[test]
fn what_is_no_time_no_force_and_no_joint_is_refused_and_loses_nothing() {
    let mut running = driven().start(FIXED).expect("begins");
    running.step(0.1).expect("goes on");
    let before = running.clone();
    for dt in [0.0, -0.1, f64::NAN, f64::INFINITY, 1e9] {
        let error = running.step(dt).expect_err("no time").to_string();
        assert!(error.contains("the time to step on by"), "{error}");
    }
    for time in [0.05, f64::NAN, f64::INFINITY] {
        assert!(matches!(running.advance_to(time), Err(RunError::Setup(SetupError::Range { .. }))));
    }
    let error = running.set_force(0, f64::NAN).expect_err("no force").to_string();
    assert!(error.contains("'a_joint.rx'"), "{error}");
    let error = running.set_force(1, 1.0).expect_err("on a curve").to_string();
    assert!(error.contains("'b_joint.rx'") && error.contains("Free"), "{error}");
    assert!(running.set_force(7, 1.0).is_err());
    assert!(running.drive("d_joint", [Drive::Free]).is_err());
    assert!(running.set_limit("a_joint", LimitLaw::Hard { restitution: 2.0 }).is_err());
    assert!(running.set_state(&[0.0; 2], &[0.0; 3]).is_err());
    let far = Drive::Kinematic(Profile::Line { from: 3.0, to: 4.0, duration: 1.0 });
    assert!(matches!(running.drive("a_joint", [far]), Err(RunError::Failed(_))));
    assert_eq!((running.time(), running.q(), running.v()), (before.time(), before.q(), before.v()));
    running.step(0.1).expect("goes on");
    assert!(driven().start(Stepping::Fixed { rule: Rule::RungeKutta4, step: 0.0 }).is_err());
    let mut stiff = bouncing();
    stiff.set_limits(LimitLaw::Spring { stiffness: 1e9, damping: 1.0 }).expect("valid");
    stiff.set_start(&[1.01, 0.0, 0.0], &[0.0; 3]).expect("valid");
    let error = stiff.start(FIXED).expect_err("a step that is too long").to_string();
    assert!(error.contains("step"), "{error}");
}
