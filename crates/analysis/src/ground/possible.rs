//! A motion that the ground cannot bear, moved until it can.

use crate::ground::outline::around;
use crate::ground::{
    Consistency, ConsistencyError, ConsistencyOptions, GroundError, Sole, Stances, balance, consistent,
    shift_root,
};
use crate::prepared::PreparedMotion;
use solaris_dynamics::forward_kinematics;
use solaris_model::{Figure, GroundAxes, Motion};

/// How far (of a frame) a time may be from where equal frames have it: what printed digits leave.
const EVEN: f64 = 1e-2;

/// Moves the root of a `motion` of `figure` by the smallest shift after which the centre of
/// pressure stays within the soles that stand, and the ground need not pull: see [`consistent`]. Everything else stays, so
/// that planted feet move with the root; what was changed is in the answer.
///
/// # Errors
///
/// What [`balance`] and [`consistent`] refuse, soles without breadth, frames that are not equally far apart, and roots that
/// cannot be moved ([`shift_root`]). The motion is then as it was.
#[doc(alias = "residual reduction")]
#[doc(alias = "rra")]
#[doc(alias = "zmp")]
pub fn make_consistent(
    figure: &Figure,
    motion: &mut Motion,
    soles: &[Sole],
    stances: &Stances,
    options: &ConsistencyOptions,
) -> Result<Consistency, GroundError> {
    let found = {
        let prepared = PreparedMotion::new(figure, motion)?;
        let total = balance(&prepared, stances.level)?;
        prepared.check_soles(soles)?;
        stances.check(soles.len())?;
        if let Some(sole) = soles.iter().find(|sole| sole.width.is_none()) {
            return Err(GroundError::NoBreadth { sole: sole.name.clone() });
        }
        let rate = rate(prepared.time())?;
        let (tree, up, level) = (&prepared.tree, prepared.up, stances.level);
        let ground = GroundAxes::new(&up);
        let outlines = prepared.frames(|workspace, row| {
            forward_kinematics(tree, workspace, prepared.q(row))?;
            let time = prepared.time()[row];
            let standing = soles.iter().enumerate().filter(|(foot, _)| stances.stands(*foot, time));
            let corners = standing.flat_map(|(_, sole)| sole.outline(workspace, &up, level));
            Ok(around(corners, &ground, level))
        })?;
        consistent(rate, tree.mass(), &motion.info.gravity, level, &total, &outlines, options)?
    };
    shift_root(figure, motion, &found)?;
    Ok(found)
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
