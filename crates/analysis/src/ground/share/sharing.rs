//! The data that every split uses: the frames, the soles in the world, the smooth shares and nominal centres of pressure.

use super::load::Load;
use crate::ground::legs::hips;
use crate::ground::{BalanceFrame, Footing, PlacedFeet, SOLE_BREADTH, Sole, Stance, Stances};
use crate::prepared::PreparedMotion;
use crate::split::FootSupport;
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::Contact;
use solaris_profiles::step::cubic;

/// What each foot gets in a frame.
pub(super) type Parts = Vec<Wrench<f64>>;

/// Two feet that both stand for longer than this (s) do not walk. People do so for 0.4 s at 60 steps/min.
const LONGEST_DOUBLE: f64 = 0.5;

/// How long (s) a foot that stood alone and pressed beside its sole goes on to do so.
const FADES: f64 = 0.15;

/// A foot whose ball is lower than its heel by more than this (m) lands on its ball, and one whose heel is lower than its ball leaves from its heel.
const ON_BALL: f64 = 0.01;

/// Less than this share is none.
const LEAST: f64 = 1e-9;

/// All that a split is made of.
pub(super) struct Sharing<'a> {
    feet: &'a PlacedFeet<'a>,
    pub(super) prepared: &'a PreparedMotion<'a>,
    pub(super) soles: &'a [Sole],
    pub(super) stances: &'a Stances,
    pub(super) total: &'a [BalanceFrame],
    loads: Vec<Load>,
    /// By foot and frame, the stance.
    by_frame: Vec<Vec<Option<usize>>>,
    /// By load, the ends of the sole that land first and leave last.
    ends: Vec<[usize; 2]>,
    /// By foot, the topmost link of its leg: the first that no other foot hangs on.
    pub(super) hips: Vec<usize>,
    doubles: Vec<Double>,
    /// By foot and frame, the last frame up to this one and the first one from this one on in which the foot stands
    /// alone and presses.
    alone: Vec<Vec<[Option<usize>; 2]>>,
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
    pub(super) fn new(feet: &'a PlacedFeet<'a>, stances: &'a Stances, total: &'a [BalanceFrame]) -> Self {
        let (prepared, soles) = (feet.prepared(), feet.soles());
        let loads = Load::all(&stances.list);
        let doubles = doubles(&stances.list, prepared.time());
        let hips = hips(prepared.figure, soles);
        let ends = stances.list.iter().map(|stance| first_and_last(feet, stance, &stances.belt)).collect();
        let time = prepared.time();
        let by_frame = (0..soles.len()).map(|foot| stances.by_frame(foot, time)).collect();
        let mut out = Self {
            feet,
            prepared,
            soles,
            stances,
            total,
            loads,
            by_frame,
            ends,
            hips,
            doubles,
            alone: Vec::new(),
        };
        out.alone = (0..soles.len()).map(|foot| out.stands_alone(foot)).collect();
        out
    }

    fn stands_alone(&self, foot: usize) -> Vec<[Option<usize>; 2]> {
        let time = self.prepared.time();
        let alone = |row: &usize| {
            let here = self.stances.stands(foot, time[*row]) && self.standing(*row) == 1;
            here && self.total[*row].cop.is_some()
        };
        let mut out = vec![[None; 2]; time.len()];
        let mut last = None;
        for row in 0..time.len() {
            last = Some(row).filter(alone).or(last);
            out[row][0] = last;
        }
        let mut next = None;
        for row in (0..time.len()).rev() {
            next = Some(row).filter(alone).or(next);
            out[row][1] = next;
        }
        out
    }

    /// Share and nominal centre of pressure of every foot in a frame; `None` where none stands.
    pub(super) fn supports(&self, row: usize) -> Option<Vec<FootSupport>> {
        let t = self.prepared.time()[row];
        let mut feet = vec![FootSupport::default(); self.soles.len()];
        let mut standing = Vec::new();
        for (index, load) in self.loads.iter().enumerate() {
            let foot = load.stance.foot;
            if (load.stance.start..=load.stance.end).contains(&t) && !standing.contains(&foot) {
                let normal = self.is_uneven().then(|| self.ground(foot, row).normal);
                feet[foot] = FootSupport { share: load.weight(t), cop: self.nominal(index, row), normal };
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
            lean(&mut feet, [a, b], &cop);
        }
        (!standing.is_empty()).then_some(feet)
    }

    /// Where a foot is expected to press: from the heel or the ball, whichever lands, where it comes while others stand, to where it first stands
    /// alone; from there to where it stands alone again; from where it last does to the tip or the heel, whichever leaves, where it leaves while
    /// others stay. In place of what is not there stands the point half-way from heel to ball.
    fn nominal(&self, index: usize, row: usize) -> Vector3<f64> {
        let (load, time) = (&self.loads[index], self.prepared.time());
        let (Stance { foot, start, end }, t) = (load.stance, time[row]);
        let sole = self.on_ground(foot, row);
        let middle = sole[0].lerp(&sole[1], 0.5);
        let [lands, lifts] = self.ends[index].map(|point| sole[point]);
        // When it stands alone next to this frame, the point of its sole that is pressed then, and how far beside it the pressure is.
        let pressed = self.alone[foot][row].map(|row| {
            let time = time[row?];
            let cop = self.total[row?].cop.filter(|_| (start..=end).contains(&time))?;
            let below = self.below(foot, row?, &cop);
            Some((time, below + self.stances.belt * (t - time), cop - below))
        });
        let plain =
            |pressed: Option<(f64, Vector3<f64>, Vector3<f64>)>| pressed.map(|(time, at, _)| (time, at));
        let first = if load.comes() { lands } else { middle };
        let last = if load.leaves() { lifts } else { middle };
        let [(from, a), (to, b)] = match pressed.map(plain) {
            [Some(before), Some(after)] => [before, after],
            [Some(before), None] => [before, (end, last)],
            [None, Some(after)] => [(start, first), after],
            [None, None] if t < start.midpoint(end) => [(start, first), (start.midpoint(end), middle)],
            [None, None] => [(start.midpoint(end), middle), (end, last)],
        };
        // Beside the sole it presses for a moment only, so that nothing jumps.
        let beside = pressed
            .into_iter()
            .flatten()
            .map(|(time, _, beside)| beside * (1.0 - cubic(((t - time).abs() / FADES).min(1.0)).position));
        let on_sole = a.lerp(&b, if to > from { cubic((t - from) / (to - from)).position } else { 0.0 });
        on_sole + beside.sum::<Vector3<f64>>()
    }

    /// The point below a foot that is nearest to a point of the ground: within half a breadth of the line from heel to tip.
    fn below(&self, foot: usize, row: usize, point: &Vector3<f64>) -> Vector3<f64> {
        let [heel, _, tip] = self.on_ground(foot, row);
        let line = tip - heel;
        let along = (point - heel).dot(&line) / line.norm_squared();
        let middle = heel + line * if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
        let half = 0.5 * self.soles[foot].width.unwrap_or(SOLE_BREADTH * line.norm());
        let aside = point - middle;
        middle + aside * (half / aside.norm()).min(1.0)
    }

    /// Whether feet stand on something else than level ground.
    fn is_uneven(&self) -> bool {
        !self.stances.footings.is_empty()
    }

    /// What a foot stands on at a time (s).
    pub(super) fn under(&self, foot: usize, t: f64) -> Footing {
        self.stances.under(foot, t, &self.prepared.up)
    }

    /// The same in a frame.
    fn ground(&self, foot: usize, row: usize) -> Footing {
        self.stances.of(self.by_frame[foot][row], &self.prepared.up)
    }

    /// Heel, ball and tip of a foot in a frame, on the ground below them.
    pub(super) fn on_ground(&self, foot: usize, row: usize) -> [Vector3<f64>; 3] {
        let (up, ground) = (&self.prepared.up, self.ground(foot, row));
        self.feet.frame(row)[foot].points.map(|point| ground.below(point, up))
    }

    /// Height of the centre of mass above the ground (m).
    pub(super) fn height(&self, row: usize) -> f64 {
        let (up, frame) = (&self.prepared.up, &self.total[row]);
        let ground = frame.cop.filter(|_| self.is_uneven()).map_or(self.stances.level, |cop| cop.dot(up));
        frame.com.dot(up) - ground
    }

    /// From the heel over the ball to the tip (m).
    pub(super) fn length_of_sole(&self, row: usize, foot: usize) -> f64 {
        let [heel, ball, tip] = self.feet.frame(row)[foot].points;
        (ball - heel).norm() + (tip - ball).norm()
    }

    /// No foot has anything.
    pub(super) fn nothing(&self) -> Parts {
        vec![Wrench::zero(); self.soles.len()]
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

    /// The wrench on a foot with its centre of pressure; zero where there is none.
    pub(super) fn contact(&self, foot: usize, row: usize, part: &Wrench<f64>) -> Contact {
        let cop = self.ground(foot, row).center_of_pressure(part);
        let cop = if cop.iter().all(|x| x.is_finite()) { cop } else { Vector3::zeros() };
        Contact { force: part.force, moment: part.moment, cop }
    }

    /// The double supports between two single ones.
    pub(super) fn doubles(&self) -> &[Double] {
        &self.doubles
    }

    pub(super) fn is_regular(&self, t: f64) -> bool {
        self.doubles.iter().any(|double| (double.start..=double.end).contains(&t))
    }

    /// Feet that stand in a frame.
    pub(super) fn standing(&self, row: usize) -> usize {
        let t = self.prepared.time()[row];
        (0..self.soles.len()).filter(|foot| self.stances.stands(*foot, t)).count()
    }

    /// Frames in which several feet stand outside of such double supports.
    pub(super) fn irregular(&self) -> usize {
        let time = self.prepared.time();
        (0..time.len()).filter(|row| self.standing(*row) > 1 && !self.is_regular(time[*row])).count()
    }
}

/// Which of heel, ball and tip a foot lands on and leaves from: heel and tip, unless the ball is lower then than the heel, or the heel lower than the ball, against how they
/// lie when it stands.
fn first_and_last(feet: &PlacedFeet<'_>, stance: &Stance, belt: &Vector3<f64>) -> [usize; 2] {
    let (up, time) = (&feet.prepared().up, feet.prepared().time());
    let (from, to) =
        (time.partition_point(|time| *time < stance.start), time.partition_point(|time| *time <= stance.end));
    let Some(lying) = feet.lies(stance, belt) else { return [0, 2] };
    // How much higher the heel is than the ball in the first and in the last frame of it, of which there is one at least.
    let [first, last] = [from, to - 1].map(|row| {
        let [heel, ball, _] = lying.raised(&feet.frame(row)[stance.foot].points, up);
        heel - ball
    });
    [usize::from(first > ON_BALL), if last < -ON_BALL { 0 } else { 2 }]
}

/// Shares of two feet as the centre of pressure of both tells them:
///
/// ```text
/// s_b = (P − N_a)·(N_b − N_a)/|N_b − N_a|², from 0 to 1      s_a = 1 − s_b
/// ```
///
/// Where a foot comes or leaves beside one that stands alone before or after, that is 0 by itself: there the nominal
/// centre of the other is the whole centre of pressure.
fn lean(feet: &mut [FootSupport], [a, b]: [usize; 2], cop: &Vector3<f64>) {
    let line = feet[b].cop - feet[a].cop;
    let along = (cop - feet[a].cop).dot(&line) / line.norm_squared();
    if along.is_finite() {
        feet[b].share = along.clamp(0.0, 1.0);
        feet[a].share = 1.0 - feet[b].share;
    }
}

/// Double supports of walking: between two single ones, none cut off by an end of the motion or too long.
fn doubles(list: &[Stance], time: &[f64]) -> Vec<Double> {
    let (Some(&first), Some(&last)) = (time.first(), time.last()) else { return Vec::new() };
    let mut out = Vec::new();
    for (i, a) in list.iter().enumerate() {
        for (k, b) in list.iter().enumerate() {
            let (start, end) = (b.start, a.end);
            let overlap = a.foot != b.foot && a.start < start && start < end && end < b.end;
            let among = |(n, c): (usize, &Stance)| n != i && n != k && c.start <= end && c.end >= start;
            let walks = end - start < LONGEST_DOUBLE;
            if overlap && walks && start > first && end < last && !list.iter().enumerate().any(among) {
                out.push(Double { trailing: a.foot, leading: b.foot, start, end });
            }
        }
    }
    out
}
