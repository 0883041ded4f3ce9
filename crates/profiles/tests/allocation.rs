//! To evaluate a curve allocates nothing. A binary of its own: the allocator that counts is that of a whole program.

#![allow(
    unsafe_code,
    reason = "an allocator cannot be written without; this one passes everything on to the system's"
)]

#[path = "support/families.rs"]
mod families;

use solaris_profiles::spline::CubicSpline;
use solaris_profiles::{Clip, Curve, NaturalSpline, Outside, UniformSpline, step};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

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

fn allocations(of: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    of();
    ALLOCATIONS.get() - before
}

/// Before, at the ends of, in and after a span of 1.
const TIMES: [f64; 8] = [-1.0, 0.0, 0.1, 0.3, 0.5, 0.95, 1.0, 2.0];

#[test]
fn the_count_sees_an_allocation() {
    assert_eq!(allocations(|| drop(black_box(vec![1.0, 2.0]))), 1);
}

#[test]
fn no_curve_allocates_when_it_is_evaluated() {
    for (name, curve) in families::families().expect("curves") {
        let found = allocations(|| {
            for t in TIMES {
                black_box((curve.at(t), curve.at_time(t), curve.before(t), curve.extrapolated(t)));
                let _ = black_box(curve.try_at(t));
            }
        });
        assert_eq!(found, 0, "{name}");
    }
}

#[test]
fn nor_do_clips_cursors_and_quintic_splines() {
    let keys = [(0.0, 0.0), (0.2, 1.0), (0.3, 0.5), (1.0, 2.0)];
    let spline = CubicSpline::natural(&keys).expect("a spline");
    let smooth = NaturalSpline::new(&keys.map(|key| key.0), &keys.map(|key| key.1)).expect("a spline");
    let uniform = UniformSpline::periodic(0.0, 0.25, &[[0.0], [1.0], [0.5], [0.7]]).expect("a spline");
    let clips = [Outside::Hold, Outside::Extrapolate, Outside::Repeat, Outside::Mirror]
        .map(|outside| Clip::new(spline.clone()).outside(outside));
    let found = allocations(|| {
        let mut cursor = spline.cursor();
        for t in TIMES {
            black_box((cursor.at_time(t), smooth.at(t), uniform.at(0, t), uniform.jet(t), step::quintic(t)));
            for clip in &clips {
                black_box(clip.at(t));
            }
        }
    });
    assert_eq!(found, 0);
}
