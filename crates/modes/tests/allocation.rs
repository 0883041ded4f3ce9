//! To evaluate the equations of motion allocates nothing.

#![allow(
    unsafe_code,
    reason = "an allocator cannot be written without; this one passes everything on to the system's"
)]

use nalgebra::Vector3;
use solaris_model::{Human, human};
use solaris_modes::time::Stepping;
use solaris_modes::{
    Aim, Anchor, ContactLaw, Drive, GroundPlane, Hanging, LimitLaw, Method, PointSpring, Push, Rule, Servo,
    Settings, Shape, Simulation, contact_points,
};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The system's allocator, counting on each thread what is asked of it.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

fn count() {
    ALLOCATIONS.with(|allocations| allocations.set(allocations.get() + 1));
}

// SAFETY: every call is passed on to the system's allocator unchanged; counting neither allocates nor unwinds, for the
// counter is a constant without a destructor.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A floating human with a loose arm on a spring, everything else on curves or frozen.
fn scene() -> Simulation {
    let figure = human(1.75, 73.0).expect("within range");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_limits(LimitLaw::Spring { stiffness: 50.0, damping: 1.0 }).expect("valid");
    let drive = Drive::Move { to: 0.2, over: 1.0, along: Shape::MinimumJerk };
    for link in figure.links() {
        let joint = link.joint().name();
        let drive = match joint {
            "left_shoulder" | "left_elbow" => Drive::Free,
            "left_wrist" | "left_hip" => Drive::Frozen,
            _ => drive.clone(),
        };
        simulation.drive(joint, [drive]).expect("a joint of the human");
    }
    let end = |link: &str| Anchor { link: figure.link_index(link), point: Vector3::zeros() };
    let between = [end("left_hand"), end("left_foot")];
    simulation.add_spring(PointSpring { between, stiffness: 5.0, damping: 1.0, rest: 0.1 }).expect("valid");
    simulation
}

#[test]
fn ten_times_as_many_steps_allocate_as_much() {
    let simulation = scene();
    for rule in Rule::ALL {
        let run = |step: f64| {
            let method = Method::Fixed { rule, step };
            let settings = Settings { method, estimate: false, forces: false, ..Settings::new(0.1, 20.0) };
            let before = ALLOCATIONS.get();
            let run = simulation.run(&settings).expect("no trouble");
            (ALLOCATIONS.get() - before, run.report.cost.counts.evaluations)
        };
        let ((few, short), (many, long)) = (run(0.005), run(0.0005));
        assert!(long >= 9 * short && short >= 20, "{short} and {long} evaluations");
        assert_eq!(few, many, "{rule}");
    }
}

#[test]
fn a_step_of_a_running_simulation_allocates_nothing() {
    let rules = Rule::ALL.map(|rule| Stepping::Fixed { rule, step: 1e-3 });
    for stepping in rules.into_iter().chain([Stepping::Impulses { step: 1e-3 }]) {
        let mut running = scene().start(stepping).expect("begins");
        // Within the curves' one second nothing happens but touches of limits, which are events.
        running.step(0.01).expect("goes on");
        let mut quiet = 0;
        for _ in 0..50 {
            let before = ALLOCATIONS.get();
            running.step(1.0 / 240.0).expect("goes on");
            quiet += usize::from(ALLOCATIONS.get() == before);
        }
        assert!(quiet >= 45, "{stepping:?}: {quiet} of 50 steps without an allocation");
    }
}

#[test]
fn pushes_targets_and_what_acts_allocate_nothing_once_there_is_room() {
    let figure = human(1.75, 73.0).expect("within range");
    let elbow = figure.layout().dof_index("left_elbow.rx").expect("a dof of the human");
    let hand = figure.link_index("left_hand").expect("a hand");
    let servo = Servo { aim: Aim::At(-0.3), stiffness: 40.0, damping: 2.0, limit: Some(30.0) };
    for stepping in
        [Stepping::Fixed { rule: Rule::RungeKutta4, step: 1e-3 }, Stepping::Impulses { step: 1e-3 }]
    {
        let mut simulation = scene();
        simulation.set_limits(LimitLaw::Ignore).expect("valid");
        simulation.drive("left_elbow", [Drive::Servo(servo.clone())]).expect("a joint of the human");
        let mut running = simulation.start(stepping).expect("begins");
        let push = |force: f64| [Push::steady(hand, Vector3::zeros(), Vector3::new(0.0, force, force))];
        running.set_pushes(&push(1.0)).expect("valid");
        running.step(0.01).expect("goes on");
        running.forces().expect("forces");
        running.contacts().expect("contacts");
        let mut quiet = 0;
        for frame in 0..50 {
            let before = ALLOCATIONS.get();
            running.set_pushes(&push(0.2 * f64::from(frame))).expect("valid");
            running.set_target(elbow, -0.3 - 0.01 * f64::from(frame)).expect("a servo");
            running.step(1.0 / 240.0).expect("goes on");
            running.forces().expect("forces");
            running.contacts().expect("contacts");
            quiet += usize::from(ALLOCATIONS.get() == before);
        }
        // A servo comes to its limit and leaves it, which are events.
        assert!(quiet >= 45, "{stepping:?}: {quiet} of 50 frames without an allocation");
    }
}

/// A limp person who stands on rigid ground.
fn falling() -> Simulation {
    let figure = Human::new(1.75, 73.0).limp().build().expect("within range");
    let gravity = Vector3::new(0.0, -9.81, 0.0);
    let mut simulation = Simulation::new(&figure, gravity);
    let mut plane = GroundPlane::under(&figure, &gravity, 0.8).expect("gravity");
    plane.law = ContactLaw::Rigid;
    simulation.set_ground(plane, contact_points(&figure)).expect("valid");
    simulation.stand().expect("a free root");
    simulation
}

/// A person who falls and lies, every step with contacts.
#[test]
fn a_step_by_impulses_allocates_nothing() {
    let simulation = falling();
    let mut running = simulation.start(Stepping::Impulses { step: 1e-3 }).expect("begins");
    running.step(0.01).expect("goes on");
    let before = ALLOCATIONS.get();
    for _ in 0..120 {
        running.step(1.0 / 60.0).expect("goes on");
    }
    assert_eq!(ALLOCATIONS.get(), before);
}

/// A limp person who falls, with limbs that touch each other and hands that hold each other.
#[cfg(feature = "collide")]
#[test]
fn links_that_touch_and_are_held_together_allocate_nothing_once_there_is_room() {
    let mut simulation = falling();
    let figure = simulation.figure().clone();
    simulation.set_collisions(solaris_modes::Collisions::of(&figure, 0.5).expect("valid")).expect("valid");
    let hand = |name: &str| Anchor { link: figure.link_index(name), point: Vector3::zeros() };
    let between = [hand("left_hand"), hand("right_hand")];
    simulation.add_loop(solaris_modes::Loop::new(between, solaris_modes::LoopKind::Connect)).expect("valid");
    let mut running = simulation.start(Stepping::Impulses { step: 1e-3 }).expect("begins");
    // What touches anew finds room for it in the crate of shapes.
    let mut quiet = 0;
    for _ in 0..120 {
        let before = ALLOCATIONS.get();
        running.step(1.0 / 60.0).expect("goes on");
        quiet += usize::from(ALLOCATIONS.get() == before);
    }
    assert!(quiet >= 100, "{quiet} of 120 frames without an allocation");
}

#[test]
fn what_hangs_loose_allocates_nothing_in_a_frame() {
    let figure = human(1.75, 73.0).expect("within range");
    let nv = figure.layout().nv();
    let mut hanging = Hanging::new(&figure, Vector3::new(0.0, -9.81, 0.0)).expect("a figure");
    let (mut q, mut v, a) = (vec![0.1; nv], vec![0.0; nv], vec![0.0; nv]);
    for joint in ["left_shoulder", "left_elbow", "left_wrist", "head"] {
        hanging.loosen(joint, &q, &v).expect("a joint");
    }
    let before = ALLOCATIONS.get();
    for _ in 0..200 {
        hanging.step(1.0 / 60.0, &mut q, &mut v, &a).expect("a frame");
    }
    assert_eq!(ALLOCATIONS.get(), before);
}
