//! Positions between the frames of a motion, and how well they are found again.

use super::solutions::{self, Solution};
use solaris_profiles::{Boundary, CubicHermite, Curve, Quintic};
use std::f64::consts::FRAC_PI_2;

/// Frames a second (1/s).
pub(super) const RATES: [f64; 5] = [25.0, 30.0, 60.0, 120.0, 240.0];

/// What is drawn through the frames.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    Lines,
    Cubics,
    Quintics,
}

pub(super) const KINDS: [Kind; 3] = [Kind::Lines, Kind::Cubics, Kind::Quintics];

/// The greatest error (rad) at nine places in each frame of a pendulum's period.
pub(super) fn error(kind: Kind, rate: f64) -> f64 {
    let gravity = 9.81_f64;
    let swing = solutions::pendulum(FRAC_PI_2, gravity.sqrt());
    let frames = (2.4 * rate) as usize;
    let at = |frame: usize| boundary(&swing, gravity, frame as f64 / rate);
    let ends = (0..frames).map(|frame| (frame as f64 / rate, at(frame), at(frame + 1)));
    let mut worst = 0.0_f64;
    for (start, from, to) in ends {
        for part in 1..10 {
            let share = f64::from(part) / 10.0;
            let duration = rate.recip();
            let found = match kind {
                Kind::Lines => from.position + share * (to.position - from.position),
                Kind::Cubics => {
                    let ends = [(from.position, from.velocity), (to.position, to.velocity)];
                    CubicHermite::new(duration, ends[0], ends[1])
                        .map_or(f64::NAN, |c| c.at(share * duration).position)
                }
                Kind::Quintics => {
                    Quintic::new(duration, from, to).map_or(f64::NAN, |c| c.at(share * duration).position)
                }
            };
            let right = boundary(&swing, gravity, start + share * duration).position;
            worst = if found.is_nan() { f64::INFINITY } else { worst.max((found - right).abs()) };
        }
    }
    worst
}

fn boundary(swing: &Solution, gravity: f64, time: f64) -> Boundary {
    let (mut q, mut v) = ([0.0], [0.0]);
    swing(time, &mut q, &mut v);
    Boundary { position: q[0], velocity: v[0], acceleration: -gravity * q[0].sin() }
}
