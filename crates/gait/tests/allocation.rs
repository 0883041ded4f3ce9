//! Frames of a live walker allocate nothing.

#![allow(
    unsafe_code,
    reason = "an allocator cannot be written without; this one passes everything on to the system's"
)]

use nalgebra::Vector3;
use solaris_analysis::Goal;
use solaris_gait::{Command, Walker};
use solaris_model::{Human, RootOrder};
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

#[test]
fn frames_allocate_nothing() {
    let figure = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person");
    let mut walker = Walker::new(&figure).expect("a walker");
    let (mut v, mut a) = (vec![0.0; figure.layout().nv()], vec![0.0; figure.layout().nv()]);
    // To hang and to be pushed take room once.
    let push = |walker: &mut Walker, newtons: f64| {
        walker.push("thorax", Vector3::zeros(), Vector3::new(newtons, 0.0, 0.5 * newtons)).expect("a push");
    };
    push(&mut walker, 20.0);
    for joint in ["left_elbow", "head"] {
        walker.loosen(joint).expect("a joint");
    }
    // To reach and to be asked for forces as well.
    let palm = Vector3::new(0.0, -0.08, 0.0);
    let reach = |walker: &mut Walker, at: f64| {
        let goal = Goal::Place(walker.com() + Vector3::new(-0.3 - at, 0.1, 0.2 + at));
        walker.reach("right_hand", palm, &[], goal).expect("a reach");
    };
    reach(&mut walker, 0.0);
    walker.step(1.0 / 60.0, &Command::stop()).expect("a frame");
    walker.forces(&mut v).expect("slices");
    let before = ALLOCATIONS.with(Cell::get);
    for k in 0..2000 {
        let angle = 0.01 * f64::from(k);
        let command = match k / 400 {
            0 => Command::velocity(0.0, 1.2),
            1 => Command::velocity(angle.sin(), angle.cos()),
            2 => Command::own_velocity(0.2, 0.0),
            3 => Command::to_point(0.0, 0.0, 1.0),
            _ => Command::stop(),
        };
        if k % 300 == 150 {
            // Another joint comes back while one hangs.
            walker.tighten("left_elbow").expect("a joint");
        }
        push(&mut walker, 40.0 * angle.cos());
        // Out of reach at times.
        reach(&mut walker, 0.3 * angle.sin());
        walker.step(1.0 / 60.0, &command).expect("a frame");
        walker.derivatives(&mut v, &mut a).expect("slices");
        walker.forces(&mut v).expect("slices");
    }
    assert_eq!(ALLOCATIONS.with(Cell::get) - before, 0);
}
