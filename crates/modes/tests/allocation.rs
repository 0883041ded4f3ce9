//! To evaluate the equations of motion allocates nothing.

#![allow(
    unsafe_code,
    reason = "an allocator cannot be written without; this one passes everything on to the system's"
)]

use nalgebra::Vector3;
use solaris_model::human;
use solaris_modes::time::Stepping;
use solaris_modes::{Anchor, Drive, LimitLaw, Method, PointSpring, Rule, Settings, Shape, Simulation};
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
    for rule in Rule::ALL {
        let mut running = scene().start(Stepping::Fixed { rule, step: 1e-3 }).expect("begins");
        // Within the curves' one second nothing happens but touches of limits, which are events.
        running.step(0.01).expect("goes on");
        let mut quiet = 0;
        for _ in 0..50 {
            let before = ALLOCATIONS.get();
            running.step(1.0 / 240.0).expect("goes on");
            quiet += usize::from(ALLOCATIONS.get() == before);
        }
        assert!(quiet >= 45, "{rule}: {quiet} of 50 steps without an allocation");
    }
}
