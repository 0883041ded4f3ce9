//! One stride for a game: as many frames a second as are asked for, and its first frame not a second time as its last.

use crate::error::CliError;
use solaris::gait::{STEP_FREQUENCY, StyledRequest, THESIS_STEP_FREQUENCY};
use solaris::model::{Figure, Motion};

/// The request at the step frequency (steps/min) next to its own at which a stride lasts a whole number of frames; none where
/// it does so already.
///
/// ```text
/// N = 120·rate/f frames a stride of two steps, rounded;  f = 120·rate/N
/// ```
pub(super) fn in_step(request: &StyledRequest, step_frequency: f64, rate: f64) -> Option<StyledRequest> {
    let (lower, upper) = match request {
        StyledRequest::Thesis(_) => THESIS_STEP_FREQUENCY,
        _ => STEP_FREQUENCY,
    };
    let frames = (120.0 * rate / step_frequency).round();
    let mut fitted = [frames, frames + 1.0, frames - 1.0].into_iter().map(|count| 120.0 * rate / count);
    let fitted = fitted.find(|fitted| (lower..=upper).contains(fitted))?;
    if (fitted - step_frequency).abs() <= 1e-9 * step_frequency {
        return None;
    }
    let mut request = request.clone();
    let (frequency, length, speed) = match &mut request {
        StyledRequest::Smooth(walk) => (&mut walk.step_frequency, &walk.step_length, &mut walk.speed),
        StyledRequest::Thesis(walk) => (&mut walk.step_frequency, &walk.step_length, &mut walk.speed),
        // A run's step frequency follows from its speed.
        StyledRequest::Sequence(_) | StyledRequest::Run(_) => return None,
    };
    // Two of the three decide: of length and speed, the length stays.
    if length.is_some() {
        *speed = None;
    }
    *frequency = Some(fitted);
    Some(request)
}

/// The motion without its last frame: of a loop that is the first one again.
pub(super) fn without_last(figure: &Figure, motion: &Motion) -> Result<Motion, CliError> {
    let frames = motion.len().saturating_sub(1);
    let rows = |row: &dyn Fn(usize) -> Vec<f64>| (0..frames).flat_map(row).collect::<Vec<f64>>();
    let columns = [
        rows(&|frame| motion.q(frame).to_vec()),
        rows(&|frame| motion.v(frame).to_vec()),
        rows(&|frame| motion.a(frame).to_vec()),
    ];
    let time = motion.time()[..frames].to_vec();
    let mut shorter = Motion::new(figure, motion.info.clone(), time, columns).map_err(CliError::other)?;
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

#[cfg(test)]
mod tests {
    use super::*;
    use solaris::gait::WalkRequest;

    #[test]
    fn a_stride_is_a_whole_number_of_frames() {
        for (frequency, rate) in [(110.0, 30.0), (95.0, 24.0), (130.0, 30.0), (60.0, 25.0), (111.3, 60.0)] {
            let request = StyledRequest::Smooth(WalkRequest { speed: Some(1.2), ..WalkRequest::default() });
            let Some(StyledRequest::Smooth(walk)) = in_step(&request, frequency, rate) else { continue };
            let fitted = walk.step_frequency.expect("a step frequency");
            let frames = 120.0 * rate / fitted;
            assert!((frames - frames.round()).abs() < 1e-9, "{frequency} {rate}: {frames}");
            assert!((60.0..=130.0).contains(&fitted) && (fitted / frequency - 1.0).abs() < 0.04, "{fitted}");
            assert_eq!(walk.speed, Some(1.2));
        }
    }

    #[test]
    fn a_stride_that_fits_stays() {
        let request = StyledRequest::Smooth(WalkRequest::default());
        assert!(in_step(&request, 120.0, 30.0).is_none());
    }
}
