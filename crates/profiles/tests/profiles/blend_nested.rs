//! Blends of blends: what their answers cost, in evaluations of the curves within.

use solaris_profiles::blend::{Blend, Fade, FadeKind, Leaving};
use solaris_profiles::{Answers, Clip, Curve, Quantity, Quintic, Sample, Stationary};
use std::cell::Cell;
use std::rc::Rc;

/// A minimum-jerk movement that counts how often it is looked at.
struct Counted(Quintic, Rc<Cell<u64>>);

impl Curve<f64> for Counted {
    fn duration(&self) -> f64 {
        self.0.duration()
    }

    fn at(&self, t: f64) -> Sample {
        self.1.set(self.1.get() + 1);
        self.0.at(t)
    }

    fn before(&self, t: f64) -> Sample {
        self.1.set(self.1.get() + 1);
        self.0.before(t)
    }

    fn extrapolated(&self, t: f64) -> Sample {
        self.0.extrapolated(t)
    }
}

impl Answers for Counted {
    fn stationary(&self) -> Stationary {
        self.0.stationary()
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        self.0.critical(quantity)
    }
}

/// Blends in blends, so many deep, of movements of their own: in the first place, or in both.
fn nested(depth: u32, in_both: bool, count: &Rc<Cell<u64>>, to: f64) -> Box<dyn Answers> {
    let movement = |to: f64| {
        let quintic = Quintic::minimum_jerk(2.0, 0.0, to).expect("a movement");
        Box::new(Counted(quintic, Rc::clone(count)))
    };
    if depth == 0 {
        return movement(to);
    }
    let first = nested(depth - 1, in_both, count, to + 1.0);
    let second = if in_both { nested(depth - 1, true, count, -to) } else { movement(-to) };
    let fade = Fade::new(FadeKind::Smooth, 0.1 * f64::from(depth), 1.9 - 0.1 * f64::from(depth));
    let blend = Blend::between(Clip::new(first), Clip::new(second), fade.expect("a fade"), Leaving::Refuse);
    Box::new(blend.expect("a blend"))
}

/// How often movements are looked at for the answers about blends of 1 to `most` in each other.
fn costs(most: u32, in_both: bool) -> Vec<u64> {
    let cost = |depth| {
        let count = Rc::new(Cell::new(0));
        let curve = nested(depth, in_both, &count, 1.0);
        assert!(curve.peaks().velocity.value > 0.0 && !curve.is_monotone());
        count.get()
    };
    (1..=most).map(cost).collect()
}

#[test]
fn a_blend_in_a_blend_costs_no_multiple_of_it() {
    // Pieces are added, not multiplied: as the third power of the depth at most.
    let costs = costs(5, false);
    assert!(costs[4] < 125 * costs[0], "{costs:?}");
}

#[test]
fn blends_in_both_places_of_blends_cost_little_more_than_the_square_of_their_number() {
    let costs = costs(4, true);
    assert!(costs[3] < 20 * 20 * costs[0], "{costs:?}");
}

/// The text of blends in each other, so many deep.
fn text_of(depth: usize) -> String {
    let line = "Line(from: 0, to: 1, duration: 2)";
    let blend = |inner: String, _| {
        format!("Blend(first: {inner}, second: {line}, fade: Fade(kind: Smooth, start: 0, end: 1))")
    };
    (0..depth).fold(line.to_owned(), blend)
}

#[test]
fn blends_deeper_in_each_other_than_six_are_refused() {
    assert!(solaris_profiles::text::read(&text_of(6)).is_ok());
    let error = solaris_profiles::text::read(&text_of(7)).expect_err("too deep").to_string();
    assert!(error.contains("number of blends in each other"), "{error}");
}
