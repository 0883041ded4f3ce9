//! The prescribed laws of a stance: its force, its free moment, its centre of pressure.
//!
//! All are zero, with their slopes, at both ends of the stance. Forces are in body weights, of a **left** foot; the right one's are
//! the mirror image half a stride later.

use super::style::RunStyle;
use solaris_profiles::spline::CubicSpline;
use solaris_profiles::{Clip, ProfileError, step};
use std::f64::consts::{FRAC_PI_2, PI};

/// Part of the stance over which its force comes and goes.
const RAMP: f64 = 0.10;
/// When the impact is greatest, and half its duration (parts of the stance).
const IMPACT: (f64, f64) = (0.15, 0.13);
/// Centre of pressure: when, as a part of the stance, and where, as a part of the foot's length from the heel.
const PRESSURE: [(f64, f64); 10] = [
    (0.0, 0.0),
    (0.10, 0.015),
    (0.17, 0.05),
    (0.24, 0.45),
    (0.32, 0.68),
    (0.42, 0.745),
    (0.60, 0.775),
    (0.75, 0.83),
    (0.90, 0.93),
    (1.0, 1.0),
];

/// The same of a foot that lands on its ball: back to the middle as the heel comes down, and forward again.
const PRESSURE_ON_BALL: [(f64, f64); 9] = [
    (0.0, 0.80),
    (0.15, 0.77),
    (0.28, 0.74),
    (0.40, 0.64),
    (0.52, 0.66),
    (0.65, 0.74),
    (0.80, 0.86),
    (0.90, 0.94),
    (1.0, 1.0),
];

/// How many harmonics the fore-aft and the lateral force have, and the free moment.
pub(super) const FORCE: usize = 3;
pub(super) const TWIST: usize = 2;

/// What the harmonics are multiplied by: body weights, and N m for the free moment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Amplitudes {
    pub(super) fore_aft: [f64; FORCE],
    pub(super) lateral: [f64; FORCE],
    pub(super) twist: [f64; TWIST],
}

/// A stance's laws at one instant: the vertical force, and the harmonics of the others.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct StanceLaws {
    pub(super) vertical: f64,
    pub(super) fore_aft: [f64; FORCE],
    pub(super) lateral: [f64; FORCE],
    pub(super) twist: [f64; TWIST],
}

/// The laws of a style.
#[derive(Clone, Debug)]
pub(super) struct ForceLaws {
    skew: f64,
    impact: f64,
    /// Height of the active part.
    active: f64,
    /// What each harmonic of the fore-aft force has of the first half wave, so that its impulse is nothing.
    even: [f64; FORCE],
    pressure: Clip<CubicSpline>,
}

impl ForceLaws {
    /// For a stride of so many nodes, over which the impulses are exact: half the weight's for the vertical force of one foot,
    /// nothing for the fore-aft one.
    pub(super) fn new(style: &RunStyle, nodes: usize) -> Result<Self, ProfileError> {
        let keys = if style.lands_on_ball() { &PRESSURE_ON_BALL[..] } else { &PRESSURE };
        let pressure = CubicSpline::monotone(keys)?.into_clip();
        let mut laws =
            Self { skew: style.skew, impact: style.impact, active: 1.0, even: [0.0; FORCE], pressure };
        let (mut impact, mut active, mut half, mut forces) = (0.0, 0.0, 0.0, [0.0; FORCE]);
        for node in 0..nodes {
            let part = node as f64 / nodes as f64 / style.duty;
            if on_ground(part) {
                impact += laws.impact(part);
                active += laws.active(part);
                half += (PI * part).sin() * ramp(part);
                let at = harmonics(part);
                (0..FORCE).for_each(|k| forces[k] += at[k]);
            }
        }
        laws.active = (0.5 * nodes as f64 - impact) / active;
        laws.even = forces.map(|sum| sum / half);
        Ok(laws)
    }

    /// At a part of the stance; nothing before and after it.
    ///
    /// ```text
    /// F_y = A sin(π(s + skew sin πs)) r + imp cos⁴(π(s − .15)/.26)      F_z = Σ aₙ bₙ
    /// b₁ = −sin 2πs r   b₂ = sin 3πs r   b₃ = −sin 4πs r, each less c sin πs r
    /// F_x = −Σ aₙ sin nπs r      T = Σ tₙ sin nπs r      r = S₃(s/.1) S₃((1 − s)/.1)
    /// ```
    pub(super) fn at(&self, part: f64) -> StanceLaws {
        if !on_ground(part) {
            return StanceLaws::default();
        }
        let ramp = ramp(part);
        let wave = |n: usize| (n as f64 * PI * part).sin() * ramp;
        let (waves, forces) = ([wave(1), wave(2), wave(3)], harmonics(part));
        StanceLaws {
            vertical: self.impact(part) + self.active(part),
            fore_aft: std::array::from_fn(|k| forces[k] - waves[0] * self.even[k]),
            lateral: waves.map(|wave| -wave),
            twist: [waves[0], waves[1]],
        }
    }

    /// Centre of pressure as a part of the foot's length from the heel.
    pub(super) fn pressure(&self, part: f64) -> f64 {
        if on_ground(part) { self.pressure.at(part).position } else { 0.0 }
    }

    fn active(&self, part: f64) -> f64 {
        self.active * (PI * (part + self.skew * (PI * part).sin())).sin() * ramp(part)
    }

    fn impact(&self, part: f64) -> f64 {
        let (at, half) = IMPACT;
        let x = ((part - at) / half).clamp(-1.0, 1.0);
        self.impact * (FRAC_PI_2 * x).cos().powi(4)
    }
}

/// Whether the foot is on the ground at this part of the stance.
pub(super) fn on_ground(part: f64) -> bool {
    part > 0.0 && part < 1.0
}

fn ramp(part: f64) -> f64 {
    step::cubic(part / RAMP).position * step::cubic((1.0 - part) / RAMP).position
}

/// The harmonics of the fore-aft force, before their impulses are taken from them.
fn harmonics(part: f64) -> [f64; FORCE] {
    let ramp = ramp(part);
    let wave = |n: f64| (n * PI * part).sin() * ramp;
    [-wave(2.0), wave(3.0), -wave(4.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impulses_are_exact_and_ends_are_soft() {
        let style = RunStyle::of(1.75, 3.5);
        let (nodes, mut sum) = (200, StanceLaws::default());
        let laws = ForceLaws::new(&style, nodes).expect("laws");
        for node in 0..nodes {
            let at = laws.at(node as f64 / nodes as f64 / style.duty);
            sum.vertical += at.vertical / nodes as f64;
            (0..FORCE).for_each(|k| sum.fore_aft[k] += at.fore_aft[k] / nodes as f64);
        }
        assert!((sum.vertical - 0.5).abs() < 1e-14 && sum.fore_aft.iter().all(|x| x.abs() < 1e-15));
        for part in [1e-4, 1.0 - 1e-4] {
            let at = laws.at(part);
            assert!(at.vertical < 1e-6 && at.fore_aft.iter().chain(&at.lateral).all(|x| x.abs() < 1e-6));
        }
        assert!(laws.at(-0.1).vertical == 0.0 && laws.at(1.1).vertical == 0.0);
    }
}
