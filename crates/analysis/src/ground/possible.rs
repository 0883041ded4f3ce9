//! The shift after which the ground can bear a motion.

use crate::ground::outline::around;
use crate::ground::{
    Consistency, ConsistencyError, ConsistencyOptions, GroundError, PlacedFeet, Stances, consistent,
};
use solaris_model::GroundAxes;

/// How far (of a frame) a time may be from where equal frames have it: what printed digits leave.
const EVEN: f64 = 1e-2;

/// Finds the smallest shift of the root's path after which the centre of pressure stays within the feet that stand, and the
/// ground need not pull: see [`consistent`]. [`shift_root`](super::shift_root) then makes it; everything else stays, so that
/// planted feet move with the root.
///
/// # Errors
///
/// What [`balance`](super::balance) and [`consistent`] refuse, stances that are none or not on level ground, soles without breadth, and frames that are not equally
/// far apart.
#[doc(alias = "residual reduction")]
#[doc(alias = "rra")]
#[doc(alias = "zmp")]
pub fn consistent_shift(
    feet: &PlacedFeet<'_>,
    stances: &Stances,
    options: &ConsistencyOptions,
) -> Result<Consistency, GroundError> {
    let (prepared, soles, level) = (feet.prepared(), feet.soles(), stances.level);
    let total = feet.whole_at(level)?;
    stances.check(soles.len())?;
    if let Some((lowest, highest)) = stances.heights(&prepared.up) {
        return Err(GroundError::NotLevel { apart: highest - lowest });
    }
    if let Some(sole) = soles.iter().find(|sole| sole.width.is_none()) {
        return Err(GroundError::NoBreadth { sole: sole.name.clone() });
    }
    let rate = rate(prepared.time())?;
    let ground = GroundAxes::new(&prepared.up);
    let outlines = prepared.time().iter().enumerate().map(|(row, time)| {
        let standing = (0..soles.len()).filter(|foot| stances.stands(*foot, *time));
        around(standing.flat_map(|foot| feet.outline(row, foot, level)), &ground, level)
    });
    let (mass, gravity) = (prepared.tree.mass(), prepared.motion.info.gravity);
    Ok(consistent(rate, mass, &gravity, level, &total, &outlines.collect::<Vec<_>>(), options)?)
}

/// Frames a second, where they are equally far apart; the frame that is refused comes after the step that differs most.
fn rate(time: &[f64]) -> Result<f64, GroundError> {
    let frames = time.len();
    if frames < 3 {
        return Err(ConsistencyError::TooShort { frames }.into());
    }
    let (first, last) = (time[0], time[frames - 1]);
    let step = (last - first) / (frames - 1) as f64;
    if time.iter().enumerate().all(|(i, t)| ((t - first) / step - i as f64).abs() < EVEN) {
        return Ok(step.recip());
    }
    // Most steps are right, and a gap shifts their mean: the middle one is what the others are held against.
    let steps: Vec<f64> = time.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let off = |step: &usize| (steps[*step] - sorted[steps.len() / 2]).abs();
    let worst = (0..steps.len()).max_by(|a, b| off(a).total_cmp(&off(b)));
    let frame = worst.map_or(0, |step| step + 1);
    Err(GroundError::Uneven { frame, time: time[frame] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_that_is_missing_is_found() {
        let even: Vec<f64> = (0..101).map(|k| f64::from(k) / 50.0).collect();
        assert!((rate(&even).expect("even") - 50.0).abs() < 1e-9);
        assert_eq!(rate(&[0.0]), Err(ConsistencyError::TooShort { frames: 1 }.into()));
        let gap = [&even[..25], &even[26..]].concat();
        assert_eq!(rate(&gap), Err(GroundError::Uneven { frame: 25, time: 0.52 }));
    }
}
