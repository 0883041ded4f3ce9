//! What every walk is, whoever plans it: a trajectory that says when its feet stand, one stride of it repeated, and the same on
//! the spot.

mod on_the_spot;
mod stood;
mod stride_loop;

pub use on_the_spot::on_the_spot;
pub use stride_loop::StrideLoop;

pub(crate) use stood::Stood;

use solaris_analysis::{ReactionError, balance_momentum};
use solaris_model::{Contact, Event, Figure, Interval, Motion, MotionInfo, Trajectory};

/// Acceleration of gravity that walks are planned for (m/s²): the standard one.
pub(crate) const G: f64 = 9.80665;

/// A walk that says when its feet touch and stand.
#[doc(alias = "foot contacts")]
#[doc(alias = "gait events")]
pub trait Walking: Trajectory {
    /// Touch-downs and lift-offs in the order of time.
    fn events(&self) -> Vec<Event>;
    /// When which point of the soles is planted.
    fn planted(&self, figure: &Figure) -> Vec<Interval>;
}

/// A walk that prescribes all of the ground's force.
#[doc(alias = "grf")]
pub trait Prescribing {
    /// The wrenches on left and right foot at time `t` (s), with moments about the world's origin; zero on a foot in the air.
    fn contacts(&self, t: f64) -> [Contact; 2];
}

/// A walk of the figure with this fingerprint sampled `rate` times a second, with its events and planted points.
pub(crate) fn sampled(
    figure: &Figure,
    walk: &impl Walking,
    fingerprint: u64,
    rate: f64,
) -> Result<Motion, ReactionError> {
    let mut motion = balanced(figure, walk, fingerprint, rate)?;
    annotate(&mut motion, walk, figure);
    Ok(motion)
}

/// The samples alone, compiled once for all walks.
pub(crate) fn balanced(
    figure: &Figure,
    walk: &dyn Trajectory,
    fingerprint: u64,
    rate: f64,
) -> Result<Motion, ReactionError> {
    let info = MotionInfo { fingerprint, ..MotionInfo::on_earth(figure, rate) };
    let mut motion = Motion::sample(figure, walk, info)?;
    balance_momentum(figure, walk, &mut motion)?;
    Ok(motion)
}

/// Notes in the samples of a walk when its feet touch and stand.
pub(crate) fn annotate(motion: &mut Motion, walk: &impl Walking, figure: &Figure) {
    motion.events = walk.events();
    motion.planted = walk.planted(figure);
    // The last frame lies at or after the end, and the feet still stand.
    let (end, last) = (walk.duration(), motion.time()[motion.len() - 1]);
    for planted in motion.planted.iter_mut().filter(|planted| planted.end >= end) {
        planted.end = last;
    }
}
