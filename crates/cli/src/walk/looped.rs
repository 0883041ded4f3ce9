//! One stride for a game: its first frame not a second time as its last.

use crate::error::CliError;
use solaris::model::{Figure, Motion};

/// The motion without its last frame: of a loop that is the first one again.
pub(crate) fn without_last(figure: &Figure, motion: &Motion) -> Result<Motion, CliError> {
    let frames = motion.len().saturating_sub(1);
    let rows = |row: &dyn Fn(usize) -> Vec<f64>| (0..frames).flat_map(row).collect::<Vec<f64>>();
    let columns = [
        rows(&|frame| motion.q(frame).to_vec()),
        rows(&|frame| motion.v(frame).to_vec()),
        rows(&|frame| motion.a(frame).to_vec()),
    ];
    let time = motion.time()[..frames].to_vec();
    let known = motion.known().clone();
    let mut shorter =
        Motion::recorded(figure, motion.info.clone(), time, columns, known).map_err(CliError::other)?;
    if motion.tau(0).is_some() {
        let tau = rows(&|frame| motion.tau(frame).unwrap_or_default().to_vec());
        shorter.set_tau(tau).map_err(CliError::other)?;
    }
    shorter.events.clone_from(&motion.events);
    shorter.planted.clone_from(&motion.planted);
    shorter.contacts.clone_from(&motion.contacts);
    shorter.contacts.iter_mut().for_each(|track| track.samples.truncate(frames));
    Ok(shorter)
}
