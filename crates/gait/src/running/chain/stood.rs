//! The first and the last stance of a run that begins or ends in standing: both feet are on the ground, and the laws are of both.

use super::basis::{Basis, Priors, ROLLS};
use super::moving::{Moving, Ramp, hump};
use solaris_profiles::step;

/// Centre of pressure of standing feet, from the heel over the foot's length.
pub(super) const STANDING_PRESSURE: f64 = 0.365;
/// Distance of a standing foot's heel from the middle (m, at a height of 1.75 m).
const BESIDE: f64 = 0.04;

/// How horizontal forces come and go.
const RAMP: Ramp = Ramp { parts: [0.10; 2], soft: false };
/// Middles and half widths of what lifts, rolls and shifts do, in parts of the moving time.
const BEGIN_LIFTS: [(f64, f64); 2] = [(0.66, 0.20), (0.82, 0.18)];
const FINISH_LIFTS: [(f64, f64); 2] = [(0.09, 0.09), (0.32, 0.28)];
const BEGIN_ROLLS: [(f64, f64); ROLLS] = [(0.25, 0.25), (0.5, 0.25), (0.75, 0.25)];
const FINISH_ROLLS: [(f64, f64); ROLLS] = [(0.25, 0.2), (0.45, 0.25), (0.70, 0.30)];
const ASIDE_SPREAD: f64 = 1e-4;
/// How long the vertical force takes to end as the foot leaves, and to come as it lands (s).
const LEAVING: f64 = 0.10;
const LANDING: f64 = 0.09;

/// By how much the body is lower in moving than in standing (m), and how long it takes to sink and to rise (s).
const SUNK: f64 = 0.03;
const LOWERING: f64 = 0.40;
const RISING: f64 = 0.60;

/// Vertical force over the weight that makes the body sink by the knees' bend within so long (s).
fn sinking(time: f64, within: f64) -> f64 {
    -SUNK * step::quintic(time / within).acceleration / (within * within * crate::walking::G)
}

/// Standing, leaning forward, and the push of the foot that leaves last.
#[derive(Clone, Debug)]
pub(super) struct Begin {
    moving: Moving,
    /// How long it stands still, when the first foot begins to be unloaded and leaves, and when the last one leaves (s).
    pub(super) still: f64,
    pub(super) unloading: f64,
    pub(super) first: f64,
    pub(super) last: f64,
    pub(super) beside: f64,
}

impl Begin {
    pub(super) fn new(height: f64) -> Self {
        let time = (height / 1.75).sqrt();
        let (still, unloading, first, last) = (0.15 * time, 0.50 * time, 0.90 * time, 1.30 * time);
        Self {
            moving: Moving::new(last - still, true, RAMP),
            still,
            unloading,
            first,
            last,
            beside: BESIDE * height / 1.75,
        }
    }

    pub(super) fn priors(&self) -> Priors {
        Moving::priors([(-0.2, 0.3), (0.9, 0.5)], (self.beside, ASIDE_SPREAD))
    }

    pub(super) fn basis(&self, time: f64) -> Basis {
        if time >= self.last {
            return Basis::default();
        }
        let x = (time - self.still) / self.moving.lasts;
        let gone = |from: f64, to: f64| step::quintic((time - from) / (to - from)).position;
        let mut basis = Basis {
            fixed: (1.0 + sinking(time - self.still, LOWERING))
                * (1.0 - gone(self.last - LEAVING, self.last)),
            lifts: BEGIN_LIFTS.map(|at| hump(x, at)),
            pressure: STANDING_PRESSURE + (0.93 - STANDING_PRESSURE) * gone(self.first, self.last),
            rolls: BEGIN_ROLLS.map(|at| hump(x, at)),
            other: 0.5 * (1.0 - gone(self.unloading, self.first)),
            shift: hump(time, (0.5 * (self.still + self.first), 0.5 * (self.first - self.still))),
            ..Basis::default()
        };
        self.moving.horizontal(time - self.still, &mut basis);
        basis
    }
}

/// The landing of the foot that stops, the other one's beside it, and standing.
#[derive(Clone, Debug)]
pub(super) struct Finish {
    moving: Moving,
    /// When the other foot lands, and when all is at rest, after the landing (s).
    pub(super) beside: f64,
    pub(super) rest: f64,
    pub(super) aside: f64,
}

impl Finish {
    pub(super) fn new(height: f64) -> Self {
        let time = (height / 1.75).sqrt();
        let (beside, moving) = (0.42 * time, 1.2 * time);
        let aside = BESIDE * height / 1.75;
        Self { moving: Moving::new(moving, false, RAMP), beside, rest: moving + 0.2 * time, aside }
    }

    pub(super) fn priors(&self) -> Priors {
        Moving::priors([(1.2, 0.5), (0.0, 0.3)], (self.aside, 0.01))
    }

    /// `time` counts from the landing.
    pub(super) fn basis(&self, time: f64) -> Basis {
        if time <= 0.0 {
            return Basis::default();
        }
        let x = time / self.moving.lasts;
        let come = |from: f64, to: f64| step::quintic((time - from) / (to - from)).position;
        let mut basis = Basis {
            fixed: come(0.0, LANDING) - sinking(time - (self.moving.lasts - RISING), RISING),
            lifts: FINISH_LIFTS.map(|at| hump(x, at)),
            pressure: STANDING_PRESSURE * come(0.03, 0.16),
            rolls: FINISH_ROLLS.map(|at| hump(x, at)),
            other: 0.5 * come(self.beside, self.beside + 0.35),
            shift: hump(time, (self.beside + 0.25, 0.24)),
            ..Basis::default()
        };
        self.moving.horizontal(time, &mut basis);
        basis
    }
}
