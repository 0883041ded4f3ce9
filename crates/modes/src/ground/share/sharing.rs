//! What every split knows: the frames, the soles in the world, the smooth shares and nominal centres of pressure.

use super::load::Load;
use crate::ground::given::Given;
use crate::ground::{BalanceFrame, GroundError, Sole, Stance, Stances};
use crate::split::{FootSupport, TotalWrench};
use nalgebra::Vector3;
use solaris_dynamics::forward_kinematics;
use solaris_model::Contact;
use solaris_profiles::step::cubic;

/// What each foot gets in a frame.
pub(super) type Parts = Vec<TotalWrench>;

/// Less than this share is none.
const LEAST: f64 = 1e-9;

/// All that a split is made of.
pub(super) struct Sharing<'a> {
    pub(super) given: &'a Given<'a>,
    pub(super) soles: &'a [Sole],
    pub(super) stances: &'a Stances,
    pub(super) total: &'a [BalanceFrame],
    /// Heel, ball and tip in the world (m), by frame and foot.
    points: Vec<Vec<[Vector3<f64>; 3]>>,
    loads: Vec<Load>,
    doubles: Vec<Double>,
    /// Of each load, when (s) and where (m) it pressed alone, as near as possible to the beginning and the end of its full share.
    alone: Vec<[Option<(f64, Vector3<f64>)>; 2]>,
}

/// A double support between two single ones: trailing foot and leading foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Double {
    pub(super) trailing: usize,
    pub(super) leading: usize,
    pub(super) start: f64,
    pub(super) end: f64,
}

impl<'a> Sharing<'a> {
    pub(super) fn new(
        given: &'a Given<'a>,
        soles: &'a [Sole],
        stances: &'a Stances,
        total: &'a [BalanceFrame],
    ) -> Result<Self, GroundError> {
        let points = given.frames(|workspace, row| {
            forward_kinematics(&given.tree, workspace, given.q(row))?;
            Ok(soles.iter().map(|sole| sole.points(workspace)).collect())
        })?;
        let loads = Load::all(&stances.list);
        let doubles = doubles(&stances.list, &given.states.time);
        let mut out = Self { given, soles, stances, total, points, loads, doubles, alone: Vec::new() };
        out.alone = (0..out.loads.len()).map(|i| out.pressed_alone(i)).collect();
        Ok(out)
    }

    fn pressed_alone(&self, index: usize) -> [Option<(f64, Vector3<f64>)>; 2] {
        let Load { stance, full } = self.loads[index];
        let time = &self.given.states.time;
        let after = time.partition_point(|t| *t < full.0);
        let before = time.partition_point(|t| *t <= full.1).checked_sub(1);
        [(after < time.len()).then_some(after), before].map(|row| {
            let t = time[row?];
            let others = self.loads.iter().filter(|load| load.stance.foot != stance.foot);
            let alone = (stance.start..=stance.end).contains(&t)
                && others.into_iter().all(|load| load.weight(t) <= 0.0);
            self.total[row?].cop.filter(|_| alone).map(|cop| (t, cop))
        })
    }

    /// Share and nominal centre of pressure of every foot in a frame; `None` where none stands.
    pub(super) fn supports(&self, row: usize) -> Option<Vec<FootSupport>> {
        let t = self.given.states.time[row];
        let mut feet = vec![FootSupport::default(); self.soles.len()];
        let mut standing = Vec::new();
        for (index, load) in self.loads.iter().enumerate() {
            let foot = load.stance.foot;
            if (load.stance.start..=load.stance.end).contains(&t) && !standing.contains(&foot) {
                feet[foot] = FootSupport { share: load.weight(t), cop: self.nominal(index, row) };
                standing.push(foot);
            }
        }
        let sum: f64 = feet.iter().map(|foot| foot.share).sum();
        for foot in &standing {
            // Where all are nothing, one comes as the other leaves, in this very instant.
            let share = &mut feet[*foot].share;
            *share = if sum > LEAST { *share / sum } else { 1.0 / standing.len() as f64 };
        }
        if let (&[a, b], Some(cop)) = (&standing[..], self.total[row].cop) {
            self.lean(&mut feet, [a, b], &cop, t);
        }
        (!standing.is_empty()).then_some(feet)
    }

    /// Shares of two feet as the centre of pressure of both tells them:
    ///
    /// ```text
    /// s_b = (P − N_a)·(N_b − N_a)/|N_b − N_a|², from 0 to 1      s_a = 1 − s_b
    /// ```
    ///
    /// In a double support between two single ones that leads from 0 to 1, since there the nominal centres begin and end where the
    /// foot presses alone. Elsewhere nothing says so, and the smooth shares are factors.
    fn lean(&self, feet: &mut [FootSupport], [a, b]: [usize; 2], cop: &Vector3<f64>, t: f64) {
        let line = feet[b].cop - feet[a].cop;
        let along = (cop - feet[a].cop).dot(&line) / line.norm_squared();
        if !along.is_finite() {
            return;
        }
        let told = along.clamp(0.0, 1.0);
        let [of_a, of_b] = if self.is_regular(t) {
            [1.0 - told, told]
        } else {
            [(1.0 - told) * feet[a].share, told * feet[b].share]
        };
        if of_a + of_b > LEAST {
            feet[a].share = of_a / (of_a + of_b);
            feet[b].share = of_b / (of_a + of_b);
        }
    }

    /// Where a foot is expected to press: from the heel to where it presses alone, and from there to the tip.
    fn nominal(&self, index: usize, row: usize) -> Vector3<f64> {
        let (load, t) = (&self.loads[index], self.given.states.time[row]);
        let [heel, ball, tip] = self.points[row][load.stance.foot].map(|point| self.on_ground(point));
        let at = |end: usize| {
            self.alone[index][end]
                .map_or_else(|| heel.lerp(&ball, 0.5), |(time, cop)| cop + self.stances.belt * (t - time))
        };
        let (from, to) = load.full;
        if t < from {
            heel.lerp(&at(0), load.taken(t))
        } else if t > to {
            tip.lerp(&at(1), load.kept(t))
        } else {
            at(0).lerp(&at(1), if to > from { cubic((t - from) / (to - from)).position } else { 0.0 })
        }
    }

    /// The point of the ground below a point.
    pub(super) fn on_ground(&self, point: Vector3<f64>) -> Vector3<f64> {
        let up = &self.given.up;
        point + up * (self.stances.level - point.dot(up))
    }

    /// Height of the centre of mass above the ground (m).
    pub(super) fn height(&self, row: usize) -> f64 {
        self.total[row].com.dot(&self.given.up) - self.stances.level
    }

    /// From the heel over the ball to the tip (m).
    pub(super) fn length_of_sole(&self, row: usize, foot: usize) -> f64 {
        let [heel, ball, tip] = self.points[row][foot];
        (ball - heel).norm() + (tip - ball).norm()
    }

    /// No foot has anything.
    pub(super) fn nothing(&self) -> Parts {
        vec![TotalWrench::default(); self.soles.len()]
    }

    /// The only foot that stands, or bears all but a billionth.
    pub(super) fn only(feet: &[FootSupport]) -> Option<usize> {
        feet.iter().position(|foot| foot.share >= 1.0 - LEAST)
    }

    /// The whole wrench on one foot.
    pub(super) fn whole(&self, row: usize, foot: usize) -> Parts {
        let mut parts = self.nothing();
        parts[foot] = self.total[row].wrench();
        parts
    }

    /// The wrench with its centre of pressure; zero where there is none.
    pub(super) fn contact(&self, part: &TotalWrench) -> Contact {
        let (up, level) = (&self.given.up, self.stances.level);
        let normal = part.force.dot(up);
        let cop = (up.cross(&part.moment) + part.force * level) / normal;
        let cop = if cop.iter().all(|x| x.is_finite()) { cop } else { Vector3::zeros() };
        Contact { force: part.force, moment: part.moment, cop }
    }

    /// The double supports between two single ones.
    pub(super) fn doubles(&self) -> &[Double] {
        &self.doubles
    }

    fn is_regular(&self, t: f64) -> bool {
        self.doubles.iter().any(|double| (double.start..=double.end).contains(&t))
    }

    /// Feet that stand in a frame.
    pub(super) fn standing(&self, row: usize) -> usize {
        let t = self.given.states.time[row];
        (0..self.soles.len()).filter(|foot| self.stances.stands(*foot, t)).count()
    }

    /// Frames in which several feet stand outside of such double supports.
    pub(super) fn irregular(&self) -> usize {
        let time = &self.given.states.time;
        (0..time.len()).filter(|row| self.standing(*row) > 1 && !self.is_regular(time[*row])).count()
    }
}

/// Double supports between two single ones, neither cut off by an end of the motion.
fn doubles(list: &[Stance], time: &[f64]) -> Vec<Double> {
    let (Some(&first), Some(&last)) = (time.first(), time.last()) else { return Vec::new() };
    let mut out = Vec::new();
    for (i, a) in list.iter().enumerate() {
        for (k, b) in list.iter().enumerate() {
            let (start, end) = (b.start, a.end);
            let overlap = a.foot != b.foot && a.start < start && start < end && end < b.end;
            let among = |(n, c): (usize, &Stance)| n != i && n != k && c.start <= end && c.end >= start;
            if overlap && start > first && end < last && !list.iter().enumerate().any(among) {
                out.push(Double { trailing: a.foot, leading: b.foot, start, end });
            }
        }
    }
    out
}
