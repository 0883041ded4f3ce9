//! The motion on the spot, as on a belt.

use nalgebra::Vector3;
use solaris_model::{Figure, Motion, MotionError};

/// A motion on the spot: without the way along z that its root makes from first to last frame, as on a belt. Forces stay; nothing
/// is planted any more.
///
/// # Errors
///
/// A motion of another figure.
#[doc(alias = "in place")]
#[doc(alias = "treadmill")]
#[doc(alias = "root motion")]
pub fn on_the_spot(figure: &Figure, motion: &Motion) -> Result<Motion, MotionError> {
    motion.check_figure(figure)?;
    let (first, last) = (0, motion.len() - 1);
    let lasts = motion.time()[last] - motion.time()[first];
    // The root of a walker slides along x, y, z first.
    let along = figure.layout().joints()[0];
    let speed =
        if lasts > 0.0 { (motion.q(last)[along.q + 2] - motion.q(first)[along.q + 2]) / lasts } else { 0.0 };
    let rows = |of: &dyn Fn(usize) -> Vec<f64>| (0..motion.len()).flat_map(of).collect::<Vec<f64>>();
    let back = |frame: usize| speed * (motion.time()[frame] - motion.time()[first]);
    let shifted = |row: &[f64], index: usize, by: f64| {
        let mut row = row.to_vec();
        row[index] -= by;
        row
    };
    let columns = [
        rows(&|frame| shifted(motion.q(frame), along.q + 2, back(frame))),
        rows(&|frame| shifted(motion.v(frame), along.v + 2, speed)),
        rows(&|frame| motion.a(frame).to_vec()),
    ];
    let mut still = Motion::new(figure, motion.info.clone(), motion.time().to_vec(), columns)?;
    if motion.tau(0).is_some() {
        still.set_tau(rows(&|frame| motion.tau(frame).unwrap_or_default().to_vec()))?;
    }
    still.events.clone_from(&motion.events);
    still.contacts.clone_from(&motion.contacts);
    for track in &mut still.contacts {
        for (frame, contact) in track.samples.iter_mut().enumerate() {
            let shift = Vector3::new(0.0, 0.0, -back(frame));
            contact.moment += shift.cross(&contact.force);
            if contact.force != Vector3::zeros() {
                contact.cop += shift;
            }
        }
    }
    Ok(still)
}
