//! The feet of a figure in a motion, placed once.

use super::balance;
use super::total::bad_level;
use crate::ground::{BalanceFrame, GroundError, Sole};
use crate::prepared::PreparedMotion;
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, velocities};
use std::sync::OnceLock;

/// The feet of a figure in its motion, on which all questions about them are asked: soles that are the figure's, and how
/// their points move, found once for all frames.
///
/// It takes about 150 bytes a frame and foot, less than the motion itself.
#[derive(Debug)]
pub struct PlacedFeet<'a> {
    prepared: &'a PreparedMotion<'a>,
    soles: Vec<Sole>,
    /// By frame, by foot.
    frames: Vec<Vec<PlacedSole>>,
    /// The whole wrench, found when it is first asked for; its centres of pressure are at height 0.
    whole: OnceLock<Vec<BalanceFrame>>,
}

/// A sole in one frame: heel, ball and tip in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedSole {
    /// Where they are (m).
    pub points: [Vector3<f64>; 3],
    /// Their velocities (m/s).
    pub velocities: [Vector3<f64>; 3],
}

impl<'a> PlacedFeet<'a> {
    /// Places `soles` of the figure in every frame of its motion. Frames are independent of each other and placed on all cores
    /// where the feature `parallel` is on.
    ///
    /// # Errors
    ///
    /// No gravity, no mass, no frames, times that do not rise, no soles or soles that are none, and the first state that the
    /// kernel refuses.
    #[doc(alias = "forward kinematics")]
    pub fn new(prepared: &'a PreparedMotion<'a>, soles: impl Into<Vec<Sole>>) -> Result<Self, GroundError> {
        let soles = soles.into();
        prepared.check_ground()?;
        prepared.check_soles(&soles)?;
        let frames = prepared.frames(|workspace, row| {
            velocities(&prepared.tree, workspace, prepared.q(row), prepared.v(row))?;
            Ok(soles.iter().map(|sole| PlacedSole::new(sole, workspace)).collect())
        })?;
        Ok(Self { prepared, soles, frames, whole: OnceLock::new() })
    }

    /// The motion.
    pub fn prepared(&self) -> &'a PreparedMotion<'a> {
        self.prepared
    }

    /// The soles.
    pub fn soles(&self) -> &[Sole] {
        &self.soles
    }

    /// All of them in a frame, in the order of the soles.
    pub fn frame(&self, row: usize) -> &[PlacedSole] {
        &self.frames[row]
    }

    /// The whole wrench of the ground in all frames ([`balance`](super::balance)), found once for all questions; its centres of pressure are at
    /// height 0.
    pub(crate) fn whole(&self) -> Result<&[BalanceFrame], GroundError> {
        if let Some(whole) = self.whole.get() {
            return Ok(whole);
        }
        let whole = balance(self.prepared, 0.0)?;
        Ok(self.whole.get_or_init(|| whole))
    }

    /// The same with centres of pressure on the ground at `level` (m, along up).
    pub(crate) fn whole_at(&self, level: f64) -> Result<Vec<BalanceFrame>, GroundError> {
        if !level.is_finite() {
            return Err(bad_level(level));
        }
        let up = &self.prepared.up;
        let at = |frame: &BalanceFrame| BalanceFrame {
            cop: frame.wrench().center_of_pressure(up, level),
            ..*frame
        };
        Ok(self.whole()?.iter().map(at).collect())
    }

    /// Frame after frame.
    pub fn frames(&self) -> impl ExactSizeIterator<Item = &[PlacedSole]> {
        self.frames.iter().map(Vec::as_slice)
    }
}

impl PlacedSole {
    /// Where `workspace` has placed the links, and knows their velocities.
    fn new(sole: &Sole, workspace: &Workspace<f64>) -> Self {
        let toes = sole.toes.unwrap_or(sole.foot);
        let on = [(sole.foot, sole.heel), (sole.foot, sole.ball), (toes, sole.tip)];
        let points = on.map(|(link, point)| workspace.pose(link).transform(&point));
        let velocities = [0, 1, 2].map(|i| {
            let (twist, pose) = (workspace.velocity(on[i].0), workspace.pose(on[i].0));
            twist.linear + twist.angular.cross(&(points[i] - pose.translation))
        });
        Self { points, velocities }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ground::{
        ConsistencyOptions, GroundOptions, Split, StanceOptions, balance, consistent_shift, find_stances,
        ground_forces, judge, share, soles,
    };
    use solaris_model::{Figure, Motion, MotionInfo, human};
    use std::sync::atomic::Ordering;

    /// A person of whom every coordinate swings by `size` (rad, and a tenth of it in m), each at its own pace, at these times (s).
    fn swaying(figure: &Figure, size: f64, time: Vec<f64>) -> Motion {
        let [mut q, mut v, mut a] = [(); 3].map(|()| Vec::new());
        for t in &time {
            for dof in 0..figure.layout().nv() {
                let (pace, size) = (3.0 + 0.37 * dof as f64, if dof < 3 { 0.1 * size } else { size });
                let angle = pace * t + dof as f64;
                q.push(size * angle.sin() + if dof == 1 { 0.9 } else { 0.0 });
                v.push(size * pace * angle.cos());
                a.push(-size * pace * pace * angle.sin());
            }
        }
        let info = MotionInfo::on_earth(figure, 1.0 / (time[1] - time[0]));
        Motion::new(figure, info, time, [q, v, a]).expect("a motion")
    }

    #[test]
    fn no_question_places_them_anew() {
        let figure = human(1.75, 73.0).expect("a person");
        let motion = swaying(&figure, 0.01, (0..50).map(|i| f64::from(i) / 100.0).collect());
        let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
        let passes = || prepared.passes.load(Ordering::Relaxed);
        let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
        assert_eq!(passes(), 1, "feet");
        let stances = find_stances(&feet, &StanceOptions::default()).expect("stances");
        // They need the whole wrench, which is kept.
        assert_eq!((passes(), stances.list.len()), (2, 2), "stances");
        let total = balance(&prepared, stances.level).expect("a whole wrench");
        assert_eq!(passes(), 3, "the whole wrench anew");
        share(Split::Transition, &feet, &stances, &total).expect("shares");
        let shared = share(Split::Pivot, &feet, &stances, &total).expect("shares");
        judge(&feet, &stances, &total, &shared.contacts).expect("checks");
        let before = passes();
        ground_forces(&feet, &GroundOptions::default()).expect("forces");
        consistent_shift(&feet, &stances, &ConsistencyOptions::default()).expect("a shift");
        // The split asks for what the joints need where two feet stand.
        assert_eq!(passes() - before, 1, "forces and a shift");
    }

    /// Of a force that is not upright it lies further along the force, the higher the ground is: `P(h) = P(0) + h F/Fₙ`.
    #[test]
    fn the_centre_of_pressure_is_on_the_ground_that_is_asked_for() {
        let figure = human(1.75, 73.0).expect("a person");
        let motion = swaying(&figure, 0.1, (0..20).map(|i| f64::from(i) / 100.0).collect());
        let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
        let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
        let low = feet.whole().expect("a whole wrench");
        for level in [0.0, 0.3, -0.2] {
            let found = feet.whole_at(level).expect("a whole wrench");
            assert_eq!(found.len(), 20);
            for (found, low) in found.iter().zip(low) {
                let expected = low.cop.expect("pressed") + low.force * (level / low.force.y);
                let cop = found.cop.expect("pressed");
                assert!((cop - expected).norm() < 1e-12 && low.force.x.abs() > 1e-3, "{cop} {expected}");
                assert_eq!(BalanceFrame { cop: low.cop, ..*found }, *low);
            }
        }
    }

    #[test]
    fn points_move_as_their_velocities_say() {
        let figure = human(1.75, 73.0).expect("a person");
        let step = 1e-5;
        let motion = swaying(&figure, 0.3, vec![0.5 - step, 0.5, 0.5 + step]);
        let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
        let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
        for foot in 0..2 {
            let [before, here, after] = [0, 1, 2].map(|row| feet.frame(row)[foot]);
            for point in 0..3 {
                let moved = (after.points[point] - before.points[point]) / (2.0 * step);
                let off = (moved - here.velocities[point]).norm();
                // The step's square times a sixth of the jerk, which is some 10³ m/s³.
                assert!(off < 1e-6 && moved.norm() > 0.1, "foot {foot}, point {point}: {off:e} of {moved:?}");
            }
        }
    }
}
