//! What every walk is, whoever plans it: a trajectory that says when its feet stand, one stride of it repeated, and the same on
//! the spot.

mod on_the_spot;
mod stride_loop;

pub use on_the_spot::on_the_spot;
pub use stride_loop::StrideLoop;

use solaris_model::{Event, Figure, Interval, Motion, Trajectory};

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
