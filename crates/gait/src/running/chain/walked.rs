//! The stance of a foot that a walk has set down and a run leaves, and of one that a run sets down and a walk leaves.

use super::basis::{Basis, Priors, ROLLS};
use super::moving::{Moving, Ramp, hump};
use super::seam::Seam;
use nalgebra::Vector3;
use solaris_profiles::step;
use std::sync::Arc;

/// How long what carries the walk takes to go, and to come (s).
const FADE: f64 = 0.15;
/// From the seam to the flight and from the landing to the seam (s), and the speed (m/s, at a height of 1.75 m) below which the first takes longer,
/// by which factor at most, and the second less, by which part of itself at most.
const PUSHES: f64 = 0.37;
const LANDS: f64 = 0.25;
const SLOW: f64 = 1.3;
const LONGER: f64 = 1.25;
const LESS: f64 = 0.12;
/// By how much slower than that it is least (m/s).
const SLOWER: f64 = 0.3;
/// Middles and half widths of what lifts and rolls do, in parts of the time between the seam and the flight.
const LAUNCH_LIFTS: [(f64, f64); 2] = [(0.25, 0.25), (0.60, 0.38)];
const ARRIVAL_LIFTS: [(f64, f64); 2] = [(0.22, 0.22), (0.55, 0.45)];
const LAUNCH_ROLLS: [(f64, f64); ROLLS] = [(0.25, 0.25), (0.5, 0.25), (0.75, 0.25)];
const ARRIVAL_ROLLS: [(f64, f64); ROLLS] = [(0.35, 0.25), (0.5, 0.25), (0.75, 0.25)];
/// Where the foot presses as it leaves, over its length from the heel.
const LEFT: f64 = 0.93;
/// How long the vertical force takes to end as the foot leaves, and to come as it lands (s).
const LEAVING: f64 = 0.12;
const LANDING: f64 = 0.06;
/// When the pressure begins to roll forward from the heel of a foot that lands, and when it is where it is in the walk (s).
const ROLLING: (f64, f64) = (0.03, 0.16);
/// How horizontal forces come and go at the seam and at the flight: there as the vertical one does.
const RAMPS: [f64; 2] = [0.15, 0.35];
/// What is expected of how the pressure rolls over the foot, in parts of its length.
const ROLL_SPREAD: f64 = 0.10;
/// How exactly the print is where the walk has it (m).
const ASIDE_SPREAD: f64 = 1e-6;
/// How long before the other foot lands in the walk what would carry it is taken for the last time (s).
const BEFORE_LANDING: f64 = 0.02;

fn risen(time: f64, from: f64, to: f64) -> f64 {
    step::quintic((time - from) / (to - from)).position
}

/// Lays over the laws of a stance what carries the walk: `walks` is its part. Its direction and its pressure are those of the instant `held` by the
/// part `stays`.
fn lay(seam: &Seam, time: f64, walks: f64, (held, stays): (f64, f64), basis: &mut Basis) {
    let of = |time: f64| {
        let carried = seam.carrying(time);
        let force = carried.force / carried.force.y;
        [force.x, force.z, carried.pressure, carried.outward]
    };
    let at_rest = of(held);
    let now = if stays < 1.0 { of(time) } else { at_rest };
    let [x, z, pressure, outward]: [f64; 4] = std::array::from_fn(|k| now[k] + (at_rest[k] - now[k]) * stays);
    basis.towards = Vector3::new(x, 0.0, z);
    (basis.pressure, basis.outward) = (pressure, outward);
    if walks > 0.0 {
        let carried = seam.carrying(time);
        basis.fixed += (carried.force.y - 1.0) * walks;
        basis.given_twist = carried.twist * walks;
    }
}

/// Out of a walk, into a flight.
#[derive(Clone, Debug)]
pub(super) struct Launch {
    pub(super) seam: Arc<Seam>,
    moving: Moving,
    /// When the foot leaves (s).
    pub(super) last: f64,
    /// When the other foot would land in the walk (s): from then on its force would no longer be that of this foot.
    held: f64,
}

impl Launch {
    /// `lands` is when the other foot would land in the walk (s).
    pub(super) fn new(seam: Arc<Seam>, height: f64, lands: f64) -> Self {
        let (_, rate) = seam.com(seam.at);
        let lasts = PUSHES * (SLOW * (height / 1.75).sqrt() / rate.z).clamp(1.0, LONGER);
        let moving = Moving::new(lasts, true, Ramp { parts: RAMPS, soft: true });
        Self { moving, last: seam.at + lasts, seam, held: lands - BEFORE_LANDING }
    }

    /// Until when it is asked what would carry the walk (s).
    pub(super) fn asked(at: f64, lands: f64) -> f64 {
        lands.max(at + FADE)
    }

    pub(super) fn priors(&self) -> Priors {
        priors([(-0.2, 0.4), (0.9, 0.5)], &self.seam)
    }

    pub(super) fn basis(&self, time: f64) -> Basis {
        if time >= self.last {
            return Basis::default();
        }
        let (at, held) = (self.seam.at, self.held);
        let x = (time - at) / self.moving.lasts;
        let mut basis = Basis {
            lifts: LAUNCH_LIFTS.map(|at| hump(x, at)),
            rolls: LAUNCH_ROLLS.map(|at| hump(x, at)),
            fixed: 1.0 - risen(time, self.last - LEAVING, self.last),
            ..Basis::default()
        };
        let stays = risen(time, at + 0.4 * (held - at), held);
        lay(&self.seam, time, 1.0 - risen(time, at, at + FADE), (held, stays), &mut basis);
        let left = risen(time, at, self.last);
        basis.pressure += (LEFT - basis.pressure) * left;
        basis.outward *= 1.0 - left;
        self.moving.horizontal(time - at, &mut basis);
        basis
    }
}

/// Out of a flight, into a walk.
#[derive(Clone, Debug)]
pub(super) struct Arrival {
    pub(super) seam: Arc<Seam>,
    moving: Moving,
    /// When the foot lands (s).
    pub(super) lands: f64,
    /// When the other foot has left in the walk (s).
    held: f64,
}

impl Arrival {
    /// From the landing to the seam (s), into a walk of this speed (m/s).
    pub(super) fn lasts(height: f64, speed: f64) -> f64 {
        let slower = SLOW - speed / (height / 1.75).sqrt();
        LANDS * (1.0 - LESS * (slower / SLOWER).clamp(0.0, 1.0))
    }

    /// `left` is when the other foot has left in the walk (s).
    pub(super) fn new(seam: Arc<Seam>, lands: f64, left: f64) -> Self {
        let [at_seam, at_flight] = RAMPS;
        let moving = Moving::new(seam.at - lands, false, Ramp { parts: [at_flight, at_seam], soft: true });
        Self { moving, lands, seam, held: left }
    }

    /// From when on it is asked what carries the walk (s).
    pub(super) fn asked(at: f64, left: f64) -> f64 {
        left.min(at - FADE)
    }

    pub(super) fn priors(&self) -> Priors {
        priors([(0.9, 0.5), (-0.2, 0.4)], &self.seam)
    }

    pub(super) fn basis(&self, time: f64) -> Basis {
        if time <= self.lands {
            return Basis::default();
        }
        let (at, held) = (self.seam.at, self.held);
        let x = (time - self.lands) / self.moving.lasts;
        let come = risen(time, self.lands, self.lands + LANDING);
        let mut basis = Basis {
            lifts: ARRIVAL_LIFTS.map(|at| hump(x, at)),
            rolls: ARRIVAL_ROLLS.map(|at| hump(x, at)),
            fixed: 1.0,
            ..Basis::default()
        };
        let stays = 1.0 - risen(time, held, held + 0.6 * (at - held));
        lay(&self.seam, time, risen(time, at - FADE, at), (held, stays), &mut basis);
        basis.fixed *= come;
        let come = risen(time, self.lands + ROLLING.0, self.lands + ROLLING.1);
        basis.pressure *= come;
        basis.outward *= come;
        self.moving.horizontal(time - self.lands, &mut basis);
        basis
    }
}

fn priors(lifts: [(f64, f64); 2], seam: &Seam) -> Priors {
    Priors { rolls: [(0.0, ROLL_SPREAD); ROLLS], ..Moving::priors(lifts, (seam.print.x, ASIDE_SPREAD)) }
}
