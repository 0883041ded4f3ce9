//! Time to plan a walk, by its number of steps, and to find its forces: `cargo bench -p solaris-gait`.
//!
//! Planning a smooth walk grows in proportion to the number of steps up to 42, and hardly from there on, for the steady stride is
//! planned once; compare times of one run only.

use divan::{Bencher, black_box};
use solaris_analysis::ground_reactions;
use solaris_gait::determinants::Determinants;
use solaris_gait::{
    Extent, FEET, Resolution, StridePlan, Style, ThesisRequest, WALK_RATIO, WalkPlan, WalkRequest, measure,
    thesis_walk, walk,
};
use solaris_model::{Figure, human};

fn main() {
    divan::main();
}

fn person() -> Figure {
    human(1.75, 73.0).expect("an ordinary person")
}

fn plan_of(figure: &Figure, steps: usize) -> WalkPlan {
    let request = WalkRequest { extent: Extent::Steps(steps), ..WalkRequest::default() };
    walk(figure, &request).expect("an ordinary walk")
}

/// One periodic stride, 100 nodes and 5 passes.
#[divan::bench]
fn plan_stride(bencher: Bencher<'_, '_>) {
    let figure = person();
    let leg = solaris_gait::LegGeometry::of(&figure).expect("legs");
    let style = Style::of(&leg, 1.75, 110.0, WALK_RATIO * 1.75 * 110.0);
    bencher.bench(|| StridePlan::new(black_box(&figure), &style, Resolution::default()));
}

/// A whole walk with its stride and checks, 100 nodes a stride.
#[divan::bench(args = [1, 10, 40, 100, 400, 1600])]
fn plan_walk(bencher: Bencher<'_, '_>, steps: usize) {
    let figure = person();
    bencher.bench(|| plan_of(black_box(&figure), steps));
}

/// A walk in the thesis's style, five determinants.
#[divan::bench(args = [1, 10, 100, 1000])]
fn plan_thesis_walk(bencher: Bencher<'_, '_>, steps: usize) {
    let figure = person();
    let request = ThesisRequest {
        determinants: Determinants::Five,
        extent: Extent::Steps(steps),
        ..ThesisRequest::default()
    };
    bencher.bench(|| thesis_walk(black_box(&figure), &request));
}

/// The frames of ten steps at 120 a second: positions, derivatives, momentum.
#[divan::bench]
fn sample_frames(bencher: Bencher<'_, '_>) {
    let figure = person();
    let plan = plan_of(&figure, 10);
    bencher.bench(|| plan.motion(black_box(&figure), 120.0));
}

/// Ground reactions and joint forces of these frames.
#[divan::bench]
fn find_forces(bencher: Bencher<'_, '_>) {
    let figure = person();
    let plan = plan_of(&figure, 10);
    let motion = plan.motion(&figure, 120.0).expect("frames");
    bencher.with_inputs(|| motion.clone()).bench_local_values(|mut motion| {
        ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        motion
    });
}

/// What the walk came to.
#[divan::bench]
fn measure_walk(bencher: Bencher<'_, '_>) {
    let figure = person();
    let plan = plan_of(&figure, 10);
    let mut motion = plan.motion(&figure, 120.0).expect("frames");
    ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
    bencher.bench(|| measure(black_box(&figure), &motion));
}
