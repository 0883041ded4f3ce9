//! Keys, and how a spline bends at them.

use crate::Elementary;
use crate::error::{ProfileError, check_finite, check_overflow};
use alloc::vec::Vec;

/// A position to be at a time, with the velocities just before and just after it.
#[doc(alias = "keyframe")]
#[doc(alias = "knot")]
#[doc(alias = "waypoint")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Key<F = f64> {
    /// When.
    pub time: f64,
    /// The position.
    pub position: F,
    /// The velocity with which the curve arrives; of no effect at the first key.
    pub velocity_in: F,
    /// The velocity with which it leaves; of no effect at the last key.
    pub velocity_out: F,
}

impl<F: Copy> Key<F> {
    /// Arriving and leaving with the same velocity.
    pub const fn smooth(time: f64, position: F, velocity: F) -> Self {
        Self { time, position, velocity_in: velocity, velocity_out: velocity }
    }
}

/// Tension T, continuity C and bias B of Kochanek and Bartels; all zero bends as
/// [`CubicSpline::catmull_rom`](crate::spline::CubicSpline::catmull_rom) does.
#[doc(alias = "tcb")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bend<F = f64> {
    /// T: 1 stops at every key, −1 doubles the velocities there.
    pub tension: F,
    /// C: the velocity jumps at the keys unless it is 0. With −1 all pieces of equal keys' distance are straight.
    pub continuity: F,
    /// B: 1 takes the slope of the way to the key alone, −1 that of the way from it.
    pub bias: F,
}

/// The way to the next key of each key but the last: its duration and its mean velocity.
///
/// Refuses positions that are not finite, and mean velocities that are not.
pub(super) fn chords<F: Elementary>(keys: &[(f64, F)], times: &[f64]) -> Result<Vec<Chord<F>>, ProfileError> {
    keys.iter().try_for_each(|&(_, position)| check_finite("key", &[position]))?;
    let chords: Vec<_> = (1..keys.len())
        .map(|i| {
            let (duration, way) = (times[i] - times[i - 1], keys[i].1 - keys[i - 1].1);
            Chord { duration, way, slope: way / F::from_f64(duration) }
        })
        .collect();
    chords.iter().try_for_each(|chord| check_overflow("mean velocity between two keys", &[chord.slope]))?;
    Ok(chords)
}

/// The straight way from one key to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord<F> {
    pub(super) duration: f64,
    pub(super) way: F,
    pub(super) slope: F,
}
