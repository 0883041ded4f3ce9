//! Laws of a stance in which the body sets out or comes to a stop, over the time in which it does so.

use super::basis::{Basis, Expected, Priors, ROLLS, WAVES};
use solaris_profiles::step;
use std::f64::consts::{FRAC_PI_2, PI};

/// What is expected of the amplitudes: body weights, parts of the foot's length, N m.
const WAVE_SPREAD: f64 = 0.10;
const LATERAL_SPREAD: f64 = 0.05;
const ROLL_SPREAD: f64 = 0.05;
const SHIFT_SPREAD: f64 = 0.08;
const TWIST_SPREAD: f64 = 6.0;

pub(super) fn hump(x: f64, (at, half): (f64, f64)) -> f64 {
    (FRAC_PI_2 * ((x - at) / half).clamp(-1.0, 1.0)).cos().powi(4)
}

/// Over which parts of the moving time horizontal forces come and go, and whether they do so as softly as the vertical one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ramp {
    pub(super) parts: [f64; 2],
    pub(super) soft: bool,
}

impl Ramp {
    fn at(self, x: f64) -> f64 {
        let rise = |x: f64| if self.soft { step::quintic(x).position } else { step::cubic(x).position };
        rise(x / self.parts[0]) * rise((1.0 - x) / self.parts[1])
    }
}

/// Laws over the moving time that both ends have.
#[derive(Clone, Debug)]
pub(super) struct Moving {
    /// How long it lasts (s).
    pub(super) lasts: f64,
    /// What the fore-aft waves have of the half wave so that their impulse is nothing, and the impulse of the law that makes faster.
    even: [f64; WAVES],
    faster: f64,
    /// Whether its weight is late, as in a beginning.
    late: bool,
    ramp: Ramp,
}

const SUMMED: u32 = 1000;

impl Moving {
    pub(super) fn new(lasts: f64, late: bool, ramp: Ramp) -> Self {
        let mut moving = Self { lasts, even: [0.0; WAVES], faster: 1.0, late, ramp };
        let mean = |of: &dyn Fn(f64) -> f64| {
            (0..SUMMED).map(|i| of((f64::from(i) + 0.5) / f64::from(SUMMED))).sum::<f64>() / f64::from(SUMMED)
        };
        let half = mean(&|x| moving.wave(1, x));
        let even = std::array::from_fn(|n| mean(&|x| moving.wave(n + 2, x)) / half);
        let faster = mean(&|x| moving.getting_faster(x)) * lasts;
        (moving.even, moving.faster) = (even, faster);
        moving
    }

    fn wave(&self, n: usize, x: f64) -> f64 {
        (n as f64 * PI * x).sin() * self.ramp.at(x)
    }

    fn getting_faster(&self, x: f64) -> f64 {
        self.wave(1, x) * if self.late { x * x } else { 1.0 - x }
    }

    pub(super) fn horizontal(&self, time: f64, basis: &mut Basis) {
        let x = time / self.lasts;
        if x <= 0.0 || x >= 1.0 {
            return;
        }
        basis.faster = self.getting_faster(x) / self.faster;
        basis.fore_aft = std::array::from_fn(|n| self.wave(n + 2, x) - self.even[n] * self.wave(1, x));
        basis.lateral = std::array::from_fn(|n| -self.wave(n + 1, x));
        basis.twist = [self.wave(1, x), self.wave(2, x)];
    }

    pub(super) fn priors(lifts: [Expected; 2], aside: Expected) -> Priors {
        Priors {
            lifts,
            fore_aft: [(0.0, WAVE_SPREAD); WAVES],
            lateral: [(0.0, LATERAL_SPREAD); WAVES],
            twist: [(0.0, TWIST_SPREAD); 2],
            rolls: [(0.0, ROLL_SPREAD); ROLLS],
            shift: (0.0, SHIFT_SPREAD),
            aside,
        }
    }
}
