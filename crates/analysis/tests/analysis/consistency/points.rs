//! Shifts of a point mass against closed forms; what must not matter.

use crate::consistency::support::{GRAVITY, WEIGHT, balance, random, rectangle, say};
use approx::assert_relative_eq;
use nalgebra::Vector3;
use solaris_analysis::ground::{
    BalanceFrame, Consistency, ConsistencyOptions, ConsistencyOutcome, consistent,
};
use std::f64::consts::PI;
use std::time::Instant;

const FREE: ConsistencyOptions = ConsistencyOptions {
    limit: f64::INFINITY,
    margin: 0.0,
    least_force: 0.01,
    smoothing: 0.1,
    iterations: 100,
    tolerance: 1e-8,
};

/// A mass at `place`, pushed by `push` (m/s²) at every frame, over a square of 2 × 0.1 m.
fn pushed(
    frames: usize,
    mass: f64,
    place: Vector3<f64>,
    push: Vector3<f64>,
) -> (Vec<BalanceFrame>, Vec<Vec<Vector3<f64>>>) {
    let ground = Vector3::new(place.x, 0.0, place.z);
    let frame = balance(mass, place, push, Vector3::zeros());
    (vec![frame; frames], vec![rectangle(ground, [0.1, 0.1], 0.0); frames])
}

/// `½ A k²` less the straight line that comes closest to it: the least path of which every second difference is A.
fn parabola(frames: usize, second: f64) -> impl Iterator<Item = f64> {
    let count = frames as f64;
    (0..frames).map(move |k| {
        let from_middle = k as f64 - 0.5 * (count - 1.0);
        0.5 * second * (from_middle * from_middle - (count * count - 1.0) / 12.0)
    })
}

#[test]
fn what_is_possible_stays() {
    let (frames, outlines) = pushed(50, 70.0, Vector3::new(3.0, 1.0, -2.0), Vector3::new(0.9, 0.3, -0.9));
    let found = consistent(100.0, 70.0, &GRAVITY, 0.0, &frames, &outlines, &FREE).expect("fine");
    assert!(
        found.shift.iter().chain(&found.velocity).chain(&found.acceleration).all(|v| *v == Vector3::zeros())
    );
    assert_eq!((found.iterations, found.outcome), (0, ConsistencyOutcome::Reached));
    assert_eq!((found.before, found.before.frames), (found.after, 0));
}

#[test]
fn a_constant_push_is_met_by_a_parabola() {
    // Centre of pressure at c − h a/g = −0.1529 m from below the mass; the edge is at −0.1 m.
    let (rate, count, height, push) = (100.0, 201, 1.0, 1.5);
    let (frames, outlines) =
        pushed(count, 70.0, Vector3::new(0.2, height, 0.4), Vector3::new(push, 0.0, 0.0));
    let found = consistent(rate, 70.0, &GRAVITY, 0.0, &frames, &outlines, &FREE).expect("solved");
    assert_relative_eq!(found.before.outside, height * push / WEIGHT - 0.1, epsilon = 1e-12);
    assert_eq!(found.before.frames, count);
    assert_eq!((found.outcome, found.after.frames), (ConsistencyOutcome::Reached, 0));
    let acceleration = -(push - 0.1 * WEIGHT / height);
    let worst = found.shift.iter().zip(parabola(count, acceleration / (rate * rate))).map(|(shift, x)| {
        assert!(shift.y.abs() + shift.z.abs() < 1e-9);
        (shift.x - x).abs()
    });
    let worst = worst.fold(0.0, f64::max);
    say(&format!("parabola: {worst:.1e} m, {} iterations", found.iterations));
    assert!(worst < 1e-8, "{worst}");
}

#[test]
fn a_pulling_ground_is_met_by_a_parabola_upwards() {
    let (rate, count, mass) = (60.0, 61, 5.0);
    let (frames, outlines) =
        pushed(count, mass, Vector3::new(0.0, 0.8, 0.0), Vector3::new(0.0, -WEIGHT - 2.0, 0.0));
    let found = consistent(rate, mass, &GRAVITY, 0.0, &frames, &outlines, &FREE).expect("solved");
    assert_relative_eq!(found.before.pull, 10.0, epsilon = 1e-12);
    assert_eq!(
        (found.before.frames, found.after.frames, found.outcome),
        (count, 0, ConsistencyOutcome::Reached)
    );
    let acceleration = 2.0 + 0.01 * WEIGHT;
    for (shift, y) in found.shift.iter().zip(parabola(count, acceleration / (rate * rate))) {
        assert_relative_eq!(*shift, Vector3::new(0.0, y, 0.0), epsilon = 1e-8);
    }
}

/// A mass that sways in both directions, on a foot that it leaves now and then, and jumps a little.
fn swaying(frames: usize, rate: f64, mass: f64, sway: f64) -> (Vec<BalanceFrame>, Vec<Vec<Vector3<f64>>>) {
    let at = |k: usize| {
        let t = k as f64 / rate;
        let push = Vector3::new(
            sway * (2.0 * PI * t).sin(),
            11.0 * (2.0 * PI * 0.7 * t).sin().powi(9),
            0.6 * sway * (2.0 * PI * 1.3 * t + 1.0).cos(),
        );
        let com = Vector3::new(1.3 * t, 0.9, 0.02 * (2.0 * PI * t).cos());
        let spin = Vector3::new(0.1, 0.2, -0.1) * (mass * (2.0 * PI * 0.5 * t).sin());
        let foot = rectangle(Vector3::new(com.x, 0.0, com.z), [0.12, 0.05], 0.3 * t);
        (balance(mass, com, push, spin), if t % 1.7 < 1.3 { foot } else { vec![] })
    };
    (0..frames).map(at).unzip()
}

fn solve(frames: usize, rate: f64, mass: f64, options: &ConsistencyOptions) -> Consistency {
    let (balances, outlines) = swaying(frames, rate, mass, 2.0);
    consistent(rate, mass, &GRAVITY, 0.0, &balances, &outlines, options).expect("solved")
}

#[test]
fn mass_does_not_matter() {
    let (one, heavy) = (solve(400, 100.0, 1.0, &FREE), solve(400, 100.0, 1e6, &FREE));
    assert_eq!((one.outcome, heavy.outcome), (ConsistencyOutcome::Reached, ConsistencyOutcome::Reached));
    for (one, heavy) in one.shift.iter().zip(&heavy.shift) {
        assert_relative_eq!(one, heavy, epsilon = 1e-8);
    }
    assert_relative_eq!(one.before.pull * 1e6, heavy.before.pull, max_relative = 1e-9);
}

#[test]
fn places_do_not_matter_nor_which_way_is_up() {
    use nalgebra::{Rotation3, Vector3 as V};
    let (balances, outlines) = swaying(300, 100.0, 70.0, 2.0);
    let here = consistent(100.0, 70.0, &GRAVITY, 0.0, &balances, &outlines, &FREE).expect("solved");
    let (turn, way) = (Rotation3::from_scaled_axis(V::new(1.0, -0.4, 2.0)), V::new(20.0, 7.0, -3.0));
    let moved: Vec<BalanceFrame> = balances
        .iter()
        .map(|b| {
            let moment = turn * (b.moment + way.cross(&b.force));
            BalanceFrame {
                force: turn * b.force,
                moment,
                com: turn * (b.com + way),
                ..BalanceFrame::default()
            }
        })
        .collect();
    let place = |outline: &Vec<V<f64>>| outline.iter().map(|p| turn * (p + way)).collect();
    let outlines: Vec<Vec<V<f64>>> = outlines.iter().map(place).collect();
    let there = consistent(100.0, 70.0, &(turn * GRAVITY), 7.0, &moved, &outlines, &FREE).expect("solved");
    assert_eq!((here.before.frames, here.after.frames), (there.before.frames, there.after.frames));
    for (here, there) in here.shift.iter().zip(&there.shift) {
        assert_relative_eq!(turn * here, *there, epsilon = 1e-8);
    }
}

#[test]
fn rates_from_30_to_1000() {
    let coarse = solve(151, 30.0, 70.0, &FREE);
    for (rate, frames) in [(30.0, 5000), (100.0, 500), (100.0, 5000), (1000.0, 5000)] {
        let clock = Instant::now();
        let found = solve(frames, rate, 70.0, &FREE);
        say(&format!(
            "{frames} frames at {rate}: {} iterations, {:.3} s, greatest {:.4} m, frames at fault {} to {}, outside {:.1e} m",
            found.iterations,
            clock.elapsed().as_secs_f64(),
            found.greatest,
            found.before.frames,
            found.after.frames,
            found.after.outside
        ));
        assert_eq!((found.outcome, found.after.frames), (ConsistencyOutcome::Reached, 0));
        assert!(found.before.frames > frames / 10);
    }
    // The same curve, within what sampling makes of it.
    let fine = solve(4995, 999.0, 70.0, &FREE);
    let share = (fine.rms / coarse.rms - 1.0).abs();
    say(&format!("rms {} m at 30, {} m at 999 frames/s", coarse.rms, fine.rms));
    assert!(share < 0.1, "{share}");
}

/// What is least: `Σ |δ|² + θ⁴ |δ̈|²`.
fn cost(found: &Consistency) -> f64 {
    let pairs = found.shift.iter().zip(&found.acceleration);
    pairs.map(|(shift, a)| shift.norm_squared() + FREE.smoothing.powi(4) * a.norm_squared()).sum()
}

#[test]
fn a_limit_is_kept_where_it_can_be() {
    let free = solve(400, 100.0, 70.0, &FREE);
    for share in [0.99, 0.9] {
        let limit = share * free.greatest;
        let found = solve(400, 100.0, 70.0, &ConsistencyOptions { limit, ..FREE });
        say(&format!(
            "limit {limit:.5}: {:?}, {} iterations, rms {:.5} {:.5}",
            found.outcome, found.iterations, free.rms, found.rms
        ));
        assert_eq!((found.outcome, found.after.frames), (ConsistencyOutcome::Reached, 0));
        assert!(found.greatest < limit + 1e-6 && found.greatest > limit - 1e-6);
        assert!(cost(&found) > cost(&free));
    }
}

#[test]
fn a_limit_that_cannot_be_kept_is_told() {
    // Bent by A in all of the time T, no path keeps closer to zero than |A| T²/16; the least squares leave |A| T²/12 at the ends.
    let (rate, count, height, push) = (100.0, 101, 1.0, 1.5);
    let (frames, outlines) =
        pushed(count, 70.0, Vector3::new(0.0, height, 0.0), Vector3::new(push, 0.0, 0.0));
    let best = (push - 0.1 * WEIGHT / height) / 16.0;
    for (limit, short) in
        [(1.3 * best, false), (1.001 * best, false), (0.99 * best, true), (0.5 * best, true)]
    {
        let options = ConsistencyOptions { limit, ..FREE };
        let found = consistent(rate, 70.0, &GRAVITY, 0.0, &frames, &outlines, &options).expect("solved");
        say(&format!(
            "{:.4} of the least limit: {:?}, {} iterations, outside {:.1e} m",
            limit / best,
            found.outcome,
            found.iterations,
            found.after.outside
        ));
        match found.outcome {
            ConsistencyOutcome::Short { frame, by } if short => {
                // It stops at the limit, and leaves as much undone as the limit is short.
                assert_relative_eq!(found.shift[frame].norm(), limit, epsilon = 1e-12);
                let left = found.before.outside * by / (limit + by);
                assert!(
                    found.after.frames > 0 && found.after.outside < 1.001 * left + 1e-9,
                    "{:?}",
                    found.after
                );
                assert!(by > best - limit - 1e-9 && by < 2.5 * best, "{by}");
            }
            outcome => {
                assert_eq!((outcome, short, found.after.frames), (ConsistencyOutcome::Reached, false, 0));
            }
        }
    }
}

#[test]
fn few_iterations_are_told() {
    let found = solve(400, 100.0, 70.0, &ConsistencyOptions { iterations: 2, ..FREE });
    assert_eq!(found.outcome, ConsistencyOutcome::Unsettled);
    assert!(found.shift.iter().all(|v| v.iter().all(|x| x.is_finite())));
}

/// Seven digits of the shift are fourteen of the gap, which steps to three tenths of it would take 27 iterations for.
#[test]
fn more_digits_take_few_iterations() {
    let (frames, outlines) = pushed(201, 70.0, Vector3::new(0.2, 1.0, 0.4), Vector3::new(1.5, 0.0, 0.0));
    let [few, many] = [1e-3, 1e-10].map(|tolerance| {
        let options = ConsistencyOptions { tolerance, ..FREE };
        let found = consistent(100.0, 70.0, &GRAVITY, 0.0, &frames, &outlines, &options).expect("solved");
        assert_eq!(found.outcome, ConsistencyOutcome::Reached);
        found.iterations
    });
    say(&format!("{few} iterations to a millimetre, {many} to a ten millionth of it"));
    assert!(few < many && many - few <= 13, "{few} and {many}");
}

#[test]
fn noise_is_met() {
    let mut seed = 5;
    let (mut frames, outlines) = pushed(1000, 70.0, Vector3::new(0.0, 1.0, 0.0), Vector3::zeros());
    for frame in &mut frames {
        let push = Vector3::new(random(&mut seed), 1.2 * random(&mut seed), random(&mut seed)) * 10.0;
        *frame = balance(70.0, frame.com, push, Vector3::zeros());
    }
    let found = consistent(200.0, 70.0, &GRAVITY, 0.0, &frames, &outlines, &FREE).expect("solved");
    say(&format!(
        "noise: {:?} {} iterations, {:?} to {:?}, greatest {:.4} m",
        found.outcome, found.iterations, found.before, found.after, found.greatest
    ));
    assert_eq!((found.outcome, found.after.frames), (ConsistencyOutcome::Reached, 0));
}

#[test]
fn random_problems_settle() {
    let mut seed = 3;
    let (mut ends, mut most) = ([0; 2], 0);
    for case in 0..120 {
        let mut between = |low: f64, high: f64| low * (high / low).powf(0.5 + 0.5 * random(&mut seed));
        let (rate, mass, sway) = (between(20.0, 1000.0), between(0.01, 1e4), between(0.3, 8.0));
        let options = ConsistencyOptions {
            limit: if case % 3 == 0 { f64::INFINITY } else { between(0.003, 0.3) },
            margin: if case % 2 == 0 { 0.0 } else { between(1e-4, 0.049) },
            least_force: between(1e-3, 0.5),
            smoothing: between(0.02, 1.0),
            ..Default::default()
        };
        let frames = between(3.0, 500.0) as usize;
        let (balances, outlines) = swaying(frames, rate, mass, sway);
        let found = consistent(rate, mass, &GRAVITY, 0.0, &balances, &outlines, &options).expect("solved");
        most = most.max(found.iterations);
        match found.outcome {
            ConsistencyOutcome::Reached => {
                assert_eq!(found.after.frames, 0, "case {case}: {:?} {options:?}", found.after);
                ends[0] += 1;
            }
            ConsistencyOutcome::Short { by, .. } => {
                assert!(by > 0.0 && options.limit.is_finite(), "case {case}");
                ends[1] += 1;
            }
            outcome => panic!("case {case}: {outcome:?} {rate} {frames} {sway} {options:?} {found:?}"),
        }
        assert!(found.greatest <= options.limit + 1.1e-6, "case {case}: {}", found.greatest);
    }
    say(&format!(
        "120 random problems: {} within the limit, {} short of it, at most {most} iterations",
        ends[0], ends[1]
    ));
    assert!(ends[0] > 20 && ends[1] > 3);
}
