//! Velocities and accelerations against differences of the positions that are written.
//!
//! The simplest central differences over the planner's own step h differ from a sixth-order formula's by terms that the
//! step bounds: its velocity lies within `0.3·M₃/h` of `(q₊ − q₋)/2h`, its acceleration within `23/180·M₄/h²` of
//! `(q₊ − 2q + q₋)/h²`, where `M₃` and `M₄` are the greatest third and fourth differences within ±3 steps. Where a curve
//! has a kink the bounds grow with it, by themselves.

use crate::cases::{RATE, person, steps, walked};
use crate::criteria::seconds;
use crate::worst::Worst;
use solaris::model::{DifferenceStep, Figure, Motion, Trajectory};

pub(crate) const VELOCITY: &str = "v off difference, bounds";
pub(crate) const ACCELERATION: &str = "a off difference, bounds";
pub(crate) const ROOT: &str = "root a off difference, m/s²";
pub(crate) const SUM: &str = "v summed off way, m or rad";
pub(crate) const SUM_A: &str = "a summed, m/s or rad/s";
const ROOT_SUM_A: &str = "root a summed, m/s";
/// How far the root's accelerations may be corrected from their sixth-order differences (m/s²).
const CORRECTION: f64 = 0.03;
/// Rounding of a difference of positions of some ten metres.
const ROUNDING: f64 = 1e-14;

/// Checks `v` and `a` of all samples, for differences over `stride` samples.
pub(crate) fn derivatives(figure: &Figure, motion: &Motion, stride: usize) -> Worst {
    let mut worst = Worst::default();
    let frame = motion.time()[1] - motion.time()[0];
    let (h, names) = (frame * stride as f64, figure.layout().v_names());
    let last = motion.len() - 1;
    for (j, name) in names.iter().enumerate() {
        let q = |i: usize| motion.q(i)[j];
        let slides = name.starts_with("root.t");
        let (mut way, mut change) = (0.0, 0.0);
        for (i, &time) in motion.time().iter().enumerate() {
            let (v, a) = (motion.v(i)[j], motion.a(i)[j]);
            way += v * frame;
            change += a * frame;
            if i < 3 * stride || i + 3 * stride > last {
                continue;
            }
            let at = |k: isize| q(i.wrapping_add_signed(k * stride.cast_signed()));
            let third = |k: isize| at(k + 2) - 3.0 * at(k + 1) + 3.0 * at(k) - at(k - 1);
            let fourth = |k: isize| at(k + 2) - 4.0 * at(k + 1) + 6.0 * at(k) - 4.0 * at(k - 1) + at(k - 2);
            let most = |values: &[f64]| values.iter().fold(ROUNDING, |most: f64, x| most.max(x.abs()));
            let m3 = most(&[third(-2), third(-1), third(0), third(1)]);
            let m4 = most(&[fourth(-1), fourth(0), fourth(1)]);
            let v_off = (v - (at(1) - at(-1)) / (2.0 * h)).abs();
            let a_off = (a - (at(1) - 2.0 * at(0) + at(-1)) / (h * h)).abs();
            let bounds = (0.3 * m3 / h, 23.0 / 180.0 * m4 / (h * h));
            let rounding = (10.0 * ROUNDING / h, 10.0 * ROUNDING / (h * h));
            let here = || format!("{name} {}", seconds(time));
            worst.note(VELOCITY, v_off / (bounds.0 + rounding.0), 1.0, here);
            if slides {
                let pair = |k: isize| at(k) + at(-k) - 2.0 * at(0);
                let sixth = (270.0 * pair(1) - 27.0 * pair(2) + 2.0 * pair(3)) / (180.0 * h * h);
                worst.note(ROOT, (a - sixth).abs(), CORRECTION, here);
            } else {
                worst.note(ACCELERATION, a_off / (bounds.1 + rounding.1), 1.0, here);
            }
        }
        // From rest to rest.
        worst.note(SUM, (way - (q(last) - q(0))).abs(), 1e-6, || name.clone());
        let (sum, limit) = if slides { (ROOT_SUM_A, 1e-3) } else { (SUM_A, 1e-5) };
        worst.note(sum, change.abs(), limit, || name.clone());
    }
    worst
}

/// Samples a step of differences: the planner works on nodes, and below their distance it says nothing.
pub(crate) fn stride(plan: &impl Trajectory, rate: f64) -> usize {
    let samples = DifferenceStep::new(plan.resolution(), rate).length * rate;
    assert!(samples > 0.999, "frames are coarser than the planner's nodes");
    samples.round() as usize
}

#[test]
fn velocities_and_accelerations_are_those_of_the_positions() {
    let mut worst = Worst::default();
    for (height, frequency, n, rate) in
        [(1.75, 95.0, 10, RATE), (1.75, 110.0, 4, RATE), (1.5, 60.0, 3, RATE), (2.0, 118.0, 2, 480.0)]
    {
        let figure = person(height);
        let (plan, motion) = walked(&figure, &steps(frequency, n), rate);
        let found = derivatives(&figure, &motion, stride(&plan, rate));
        worst.merge(&format!("{height} m, {frequency}/min, {n} steps, {rate}/s"), &found);
    }
    worst.assert_all("derivatives");
}

/// The bounds would be no test where they are wide: but for kinks, they are a few per cent of what a joint reaches.
#[test]
#[expect(clippy::print_stdout, reason = "captured unless somebody asks for it")]
fn differences_are_close_but_for_the_kinks() {
    let figure = person(1.75);
    let (plan, motion) = walked(&figure, &steps(110.0, 4), RATE);
    let step = stride(&plan, RATE);
    let h = (motion.time()[1] - motion.time()[0]) * step as f64;
    let (mut all, mut far) = (0, Vec::new());
    for (j, name) in figure.layout().v_names().iter().enumerate() {
        let peak = (0..motion.len()).map(|i| motion.v(i)[j].abs()).fold(0.0, f64::max);
        for i in (0..motion.len()).filter(|i| *i >= step && i + step < motion.len() && peak > 0.1) {
            let off = motion.v(i)[j] - (motion.q(i + step)[j] - motion.q(i - step)[j]) / (2.0 * h);
            all += 1;
            if off.abs() > 0.05 * peak {
                far.push((off.abs() / peak, name, motion.time()[i]));
            }
        }
    }
    far.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (off, name, time) in far.iter().take(12) {
        let event = motion.events.iter().map(|event| (event.time - time).abs()).fold(f64::INFINITY, f64::min);
        println!(
            "v of {name} at {time:.3} s is {:.1} % of its peak off, {:.1} steps from an event",
            100.0 * off,
            event / h
        );
    }
    assert!(100 * far.len() < all, "{} of {all} velocities are more than 5 % off", far.len());
}
