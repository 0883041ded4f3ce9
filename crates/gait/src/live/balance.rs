//! The way of the centre of mass over the coming footholds.
//!
//! With `k = F_y/(m y)` and the pressure `P` (with what the angular momentum does to it) every direction obeys
//!
//! ```text
//! ẍ = k (x − P)
//! ```
//!
//! One of its two solutions grows by a factor of five a step. The one that does not obeys, with `a > 0` and `b` found backwards in time from where
//! the walk is to be,
//!
//! ```text
//! ẋ = b − a x      ȧ = a² − k      ḃ = a b − k P
//! ```
//!
//! Backwards both die down to their own, so that a few footholds of preview do. A body that has another velocity than `b − a x` is taken over by
//! two amplitudes, in which `b` is linear: a shift of the pressure in this step, and one of the foothold that is next, and of all behind it.

use super::ease::{Bridge, Jets};

/// Pieces of the way over a step.
pub(super) const NODES: usize = 24;

/// What acts at an instant.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pull {
    /// `k` (1/s²).
    pub(super) stiffness: f64,
    /// `P`: x and z (m).
    pub(super) pressure: [f64; 2],
    /// How much of the shift of the pressure there is now.
    pub(super) bump: f64,
    /// How much of the load stands on footholds that are shifted.
    pub(super) shifted: f64,
}

/// `a` and `b` at an instant: of the law, and what shifts of 1 m of pressure and of footholds add to `b`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bounded {
    pub(super) rate: f64,
    pub(super) level: [f64; 2],
    pub(super) bump: f64,
    pub(super) shift: f64,
}

impl Bounded {
    /// On the way that a centre of mass at `at` with this velocity is on, for a stiffness; footholds shift it with them.
    pub(super) fn through(at: [f64; 2], velocity: [f64; 2], stiffness: f64) -> Self {
        let rate = stiffness.sqrt();
        let level = [0, 1].map(|i| velocity[i] + rate * at[i]);
        Self { rate, level, bump: 0.0, shift: rate }
    }

    fn rates(&self, pull: &Pull) -> [f64; 5] {
        let (a, k) = (self.rate, pull.stiffness);
        [
            a * a - k,
            a * self.level[0] - k * pull.pressure[0],
            a * self.level[1] - k * pull.pressure[1],
            a * self.bump - k * pull.bump,
            a * self.shift - k * pull.shifted,
        ]
    }

    fn moved(&self, rates: &[f64; 5], time: f64) -> Self {
        Self {
            rate: self.rate + rates[0] * time,
            level: [self.level[0] + rates[1] * time, self.level[1] + rates[2] * time],
            bump: self.bump + rates[3] * time,
            shift: self.shift + rates[4] * time,
        }
    }

    /// A time `h` earlier, by the rule of Runge and Kutta; pulls at the beginning, the middle and the end of it.
    pub(super) fn before(&self, [from, middle, to]: [&Pull; 3], h: f64) -> Self {
        let first = self.rates(to);
        let second = self.moved(&first, -0.5 * h).rates(middle);
        let third = self.moved(&second, -0.5 * h).rates(middle);
        let fourth = self.moved(&third, -h).rates(from);
        let mean = std::array::from_fn(|i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0);
        self.moved(&mean, -h)
    }

    /// At the beginning of a step in `nodes` pieces.
    pub(super) fn before_step(&self, time: f64, nodes: usize, pull: impl Fn(f64) -> Pull) -> Self {
        let h = time / nodes as f64;
        let mut at = *self;
        let mut to = pull(time);
        for i in (0..nodes).rev() {
            let (from, middle) = (pull(i as f64 * h), pull((i as f64 + 0.5) * h));
            at = at.before([&from, &middle, &to], h);
            to = from;
        }
        at
    }
}

/// What acts over a step, at the nodes and half way between them.
pub(super) type Pulls = [Pull; 2 * NODES + 1];

/// The way of the centre of mass over a step: x and z (m).
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    spacing: f64,
    nodes: [Jets<2>; NODES + 1],
}

impl Way {
    /// Standing still.
    pub(super) fn resting(at: [f64; 2]) -> Self {
        Self { spacing: 1.0, nodes: [[at, [0.0; 2], [0.0; 2]]; NODES + 1] }
    }

    /// From a place on, with the pulls as they are after the shifts; `bounded` are `a` and `b` at the nodes.
    pub(super) fn new(
        at: [f64; 2],
        time: f64,
        pulls: &Pulls,
        bounded: &[Bounded; NODES + 1],
        shifts: &Shifts,
    ) -> Self {
        let h = time / NODES as f64;
        let mut way = Self { spacing: h, ..Self::resting(at) };
        let mut at = at;
        for j in 0..=NODES {
            let here = &bounded[j];
            let velocity: [f64; 2] = std::array::from_fn(|i| {
                let level = here.level[i] + here.bump * shifts.pressure[i] + here.shift * shifts.foothold[i];
                level - here.rate * at[i]
            });
            let acceleration = |i: usize, pull: &Pull, x: f64| {
                pull.stiffness * (x - pull.pressure[i] - pull.bump * shifts.pressure[i])
            };
            let now = std::array::from_fn(|i| acceleration(i, &pulls[2 * j], at[i]));
            way.nodes[j] = [at, velocity, now];
            if j < NODES {
                let middle = &pulls[2 * j + 1];
                at = std::array::from_fn(|i| {
                    // ẍ = k (x − P) by the rule of Runge and Kutta, of which only the place is taken.
                    let (x, v, first) = (at[i], velocity[i], now[i]);
                    let second = acceleration(i, middle, x + 0.5 * h * v);
                    let third = acceleration(i, middle, x + 0.5 * h * v + 0.25 * h * h * first);
                    x + h * v + h * h * (first + second + third) / 6.0
                });
            }
        }
        way
    }

    /// At a time of the step, a little beyond its ends too.
    pub(super) fn at(&self, t: f64) -> [f64; 2] {
        let j = ((t / self.spacing).max(0.0) as usize).min(NODES - 1);
        Bridge::new(&self.nodes[j], &self.nodes[j + 1], self.spacing).at(t - j as f64 * self.spacing)
    }

    /// Place, velocity and acceleration at its end.
    pub(super) fn end(&self) -> &Jets<2> {
        &self.nodes[NODES]
    }
}

/// By how much the pressure of this step and the footholds after it are shifted: x and z (m).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shifts {
    pub(super) pressure: [f64; 2],
    pub(super) foothold: [f64; 2],
}
