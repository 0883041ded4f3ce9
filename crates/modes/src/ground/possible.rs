//! A motion that the ground cannot bear, moved until it can.

use crate::complete::Completed;
use crate::ground::given::Given;
use crate::ground::outline::around;
use crate::ground::{
    Consistency, ConsistencyOptions, GroundError, Sole, Stances, balance, consistent, shift_root,
};
use nalgebra::Vector3;
use solaris_dynamics::forward_kinematics;
use solaris_model::Figure;

/// How far (of a frame) a time may be from where equal frames have it: what printed digits leave.
const EVEN: f64 = 1e-2;

/// Moves the root of a motion of `figure` under `gravity` (m/s², world axes) by the smallest shift after which the centre of
/// pressure stays within the soles that stand, and the ground need not pull: see [`consistent`]. Everything else stays, so
/// that planted feet move with the root; what was changed is in the answer.
///
/// # Errors
///
/// What [`balance`] and [`consistent`] refuse, soles without breadth, frames that are not equally far apart, and roots that
/// cannot be moved ([`shift_root`]). The motion is then as it was.
pub fn make_consistent(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &mut Completed,
    soles: &[Sole],
    stances: &Stances,
    options: &ConsistencyOptions,
) -> Result<Consistency, GroundError> {
    let total = balance(figure, gravity, states, stances.level)?;
    let found = {
        let given = Given::new(figure, gravity, states)?;
        given.check_soles(soles)?;
        stances.check(soles.len())?;
        if let Some(sole) = soles.iter().find(|sole| sole.width.is_none()) {
            return Err(GroundError::NoBreadth { sole: sole.name.clone() });
        }
        let rate = rate(&states.time)?;
        let outlines = given.frames(|workspace, row| {
            forward_kinematics(&given.tree, workspace, given.q(row))?;
            let standing =
                soles.iter().enumerate().filter(|(foot, _)| stances.stands(*foot, states.time[row]));
            let corners = standing.flat_map(|(_, sole)| sole.outline(workspace, &given.up, stances.level));
            Ok(around(corners, &given.up, stances.level))
        })?;
        consistent(rate, given.tree.mass(), &gravity, stances.level, &total, &outlines, options)?
    };
    shift_root(figure, states, &found)?;
    Ok(found)
}

/// Frames a second, where they are equally far apart.
fn rate(time: &[f64]) -> Result<f64, GroundError> {
    let (first, last) = (time[0], time[time.len() - 1]);
    let step = (last - first) / (time.len().max(2) - 1) as f64;
    let even = |i: usize| ((time[i] - first) / step - i as f64).abs() < EVEN;
    match (1..time.len()).find(|i| !even(*i)) {
        None => Ok(step.recip()),
        Some(frame) => Err(GroundError::Uneven { frame, time: time[frame] }),
    }
}
