//! Time of one answer: position, velocity, acceleration and jerk. `cargo bench -p solaris-profiles`.
//!
//! Every benchmark answers 1000 times, so that microseconds of a run are nanoseconds of an answer.

#[path = "../tests/support/families.rs"]
mod families;

use divan::{Bencher, black_box};
use solaris_profiles::spline::CubicSpline;
use solaris_profiles::{Boundary, Curve, Quintic, Sample};

const ANSWERS: usize = 1000;

fn main() {
    divan::main();
}

/// Numbers in [0, 1) without order.
fn shuffled(count: usize) -> impl Iterator<Item = f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    (0..count).map(move |_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    })
}

/// Keys at unequal times.
fn keys(count: usize) -> Vec<(f64, f64)> {
    let positions = shuffled(2 * count).skip(count);
    let times = shuffled(count).scan(0.0, |time, step| {
        *time += 0.5 + step;
        Some(*time)
    });
    times.zip(positions).collect()
}

/// At times of the span in no order.
fn answer(bencher: Bencher<'_, '_>, curve: &(impl Curve + ?Sized)) {
    let times: Vec<f64> = shuffled(ANSWERS).map(|share| share * curve.duration()).collect();
    bencher.bench_local(|| {
        for &t in &times {
            black_box(curve.at(black_box(t)));
        }
    });
}

/// What the loop itself takes: the time is read, and four numbers are written.
#[divan::bench]
fn nothing(bencher: Bencher<'_, '_>) {
    let times: Vec<f64> = shuffled(ANSWERS).collect();
    bencher.bench_local(|| {
        for &t in &times {
            black_box(Sample::rest(black_box(t)));
        }
    });
}

/// Without a call in between, as it is where a curve is used.
#[divan::bench]
fn quintic(bencher: Bencher<'_, '_>) {
    let curve = Quintic::new(1.0, Boundary::new(0.0, 0.5, 1.0), Boundary::new(1.0, -0.25, 2.0));
    let curve = black_box(curve.expect("a curve"));
    let times: Vec<f64> = shuffled(ANSWERS).collect();
    bencher.bench_local(|| {
        for &t in &times {
            black_box(curve.at(black_box(t)));
        }
    });
}

/// The names of all families.
fn names() -> Vec<&'static str> {
    families::families().expect("curves").into_iter().map(|family| family.0).collect()
}

/// Through a pointer, which takes some nanoseconds by itself: the quintic is there with and without it.
#[divan::bench(args = names())]
fn family(bencher: Bencher<'_, '_>, name: &str) {
    let found = families::families().expect("curves").into_iter().find(|family| family.0 == name);
    answer(bencher, &*found.expect("a name of the list").1);
}

mod spline {
    use super::{ANSWERS, Bencher, CubicSpline, Curve, black_box, keys, shuffled};

    /// Sixty times a second through keys half a second apart and more.
    fn sequence() -> (CubicSpline, Vec<f64>) {
        let spline = CubicSpline::catmull_rom(&keys(100)).expect("keys rise");
        (spline, (0..ANSWERS).map(|i| i as f64 / 60.0).collect())
    }

    #[divan::bench]
    fn in_sequence_by_cursor(bencher: Bencher<'_, '_>) {
        let (spline, times) = sequence();
        bencher.bench_local(|| {
            let mut cursor = spline.cursor();
            for &t in &times {
                black_box(cursor.at_time(black_box(t)));
            }
        });
    }

    #[divan::bench]
    fn in_sequence_by_search(bencher: Bencher<'_, '_>) {
        let (spline, times) = sequence();
        bencher.bench_local(|| {
            for &t in &times {
                black_box(spline.at_time(black_box(t)));
            }
        });
    }

    /// More times than the caches hold pieces, a thousand of them in each run.
    fn random(bencher: Bencher<'_, '_>, keys: &[(f64, f64)], mut answer: impl FnMut(f64)) {
        let span = keys[keys.len() - 1].0 - keys[0].0;
        let times: Vec<f64> = shuffled(1 << 16).map(|share| share * span).collect();
        let mut runs = times.chunks_exact(ANSWERS).cycle();
        bencher.bench_local(|| runs.next().into_iter().flatten().for_each(|&t| answer(black_box(t))));
    }

    #[divan::bench(args = [10_000, 1_000_000])]
    fn at_random(bencher: Bencher<'_, '_>, count: usize) {
        let keys = keys(count);
        let spline = CubicSpline::catmull_rom(&keys).expect("keys rise");
        random(bencher, &keys, |t| {
            black_box(spline.at_time(t));
        });
    }

    /// The least that random access can take: to find the key, and to fetch one number of it.
    #[divan::bench(args = [10_000, 1_000_000])]
    fn bare_search_and_fetch(bencher: Bencher<'_, '_>, count: usize) {
        let keys = keys(count);
        let (times, positions): (Vec<f64>, Vec<f64>) =
            keys.iter().map(|key| (key.0 - keys[0].0, key.1)).unzip();
        random(bencher, &keys, |t| {
            black_box(positions[times[1..].partition_point(|&time| time <= t)]);
        });
    }
}
