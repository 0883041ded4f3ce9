//! One step as it is made: the decided beat, the way of the centre of mass through it, and what takes over from the step before.

mod reach;
mod swing;

use super::balance::{Bounded, NODES, Pull, Pulls, Shifts, Way};
use super::beat::{Beat, HEIGHT, Kind, NUMBERS, SETTLES, trunk_of};
use super::ease::{Ease, Jets, jets};
use super::paces::Paces;
use super::print::seen;
use crate::body::foot::turned;
use crate::body::leg::LegPose;
use crate::body::posture::Posture;
use crate::body::rotations;
use crate::limbs::sole::not_below_zero;
use crate::walking::G;
use nalgebra::Vector3;
use reach::{HATS, above};
use solaris_profiles::step;
use swing::Swing;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// How long the posture takes to go over to a new step's laws, as a part of the step.
const EASES: f64 = 0.8;
/// Knees to which heels rise, and at which the body gives way at once.
const KNEES: [f64; 2] = [3.0 * DEGREE, 1.5 * DEGREE];
/// Over which pitch a heel comes to rise early (rad), and from when to when of the own clock it may.
const RISES: (f64, f64, f64) = (0.4 * DEGREE, 0.22, 0.30);
/// From when on of the own clock such a knee bends, and how much more it is bent as the foot lifts (rad).
const BENDS: f64 = 0.44;
const BENT: f64 = 16.0 * DEGREE;
/// The steepest pitch of a foot, and over which range it comes to it (rad).
const STEEPEST: (f64, f64) = (72.0 * DEGREE, 8.0 * DEGREE);
/// Over which height the body gives way at once (m).
const GIVES_WAY: f64 = 0.001;
/// Until when of the swing, and over which part of it, a foot is drawn up to a leg that is too short.
const DRAWN: (f64, f64) = (0.93, 0.07);
/// Over which part of its time on the ground a foot that is about to swing comes to do so.
const LEAVES: f64 = 0.6;

/// A step that is under way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) beat: Beat,
    /// When it was left, by its own time (s).
    pub(super) ended: f64,
    ease: Ease<NUMBERS>,
    pressure: Ease<2>,
    pub(super) shifts: Shifts,
    /// Of the pitches of foot and toes that push off.
    pitch: Ease<2>,
    /// Of what the hips add to the pitch of the foot that pushes off.
    risen: Ease<1>,
    way: Way,
    pub(super) lowered: [f64; HATS],
    swing: Swing,
}

/// What a step takes over.
#[derive(Clone, Copy, Debug)]
pub(super) struct Before {
    /// Place and velocity of the centre of mass (x, z).
    pub(super) com: [[f64; 2]; 2],
    numbers: Jets<NUMBERS>,
    pub(super) pressure: [f64; 2],
    pitch: [Jets<2>; 2],
    /// Pitches of the feet with what the hips add.
    risen: [Jets<1>; 2],
}

/// A posture on the way to coordinates.
pub(super) struct Placed {
    pub(super) com: Vector3<f64>,
    pub(super) posture: Posture,
}

impl Step {
    /// Standing where the beat says.
    pub(super) fn standing(beat: &Beat) -> Self {
        Self {
            ended: beat.time,
            ease: Ease::NONE,
            pressure: Ease::NONE,
            shifts: Shifts::default(),
            pitch: Ease::NONE,
            risen: Ease::NONE,
            way: Way::resting(beat.stands_at),
            lowered: [0.0; HATS],
            swing: Swing::NONE,
            beat: *beat,
        }
    }

    /// What a step at the time `t` of this one would take over.
    pub(super) fn before(&self, paces: &Paces, t: f64) -> Before {
        let [place, velocity, _] = jets(t, |t| self.place(paces, t));
        let exact = if (t - self.beat.time).abs() < 1e-9 && self.beat.walks() {
            let end = self.way.end();
            [end[0], end[1]]
        } else {
            [place, velocity]
        };
        Before {
            com: exact,
            numbers: jets(t, |t| self.numbers(paces, t)),
            pressure: self.pressure(paces, t),
            pitch: [0, 1].map(|side| jets(t, |t| self.pitches(paces, side, t))),
            risen: [0, 1].map(|side| jets(t, |t| self.risen(paces, side, t))),
        }
    }

    /// The rest of it: the way through these pulls, and the legs.
    pub(super) fn made(
        mut self,
        paces: &Paces,
        before: &Before,
        (pulls, bounded): (&Pulls, &[Bounded; NODES + 1]),
        shifts: Shifts,
    ) -> Self {
        self.shifts = shifts;
        self.way = Way::new(before.com[0], self.beat.time, pulls, bounded, &shifts);
        if self.beat.walks() {
            let side = self.beat.trailing();
            let law = jets(0.0, |t| self.risen(paces, side, t));
            self.risen = Ease::of_rates(&before.risen[side], &law, self.beat.lift);
            self.swing(paces);
        }
        self.lower(paces);
        if self.beat.walks() {
            self.swing(paces);
        }
        self
    }

    /// The laws of a beat, taken over from what was before.
    pub(super) fn eased(paces: &Paces, beat: &Beat, before: &Before) -> Self {
        let mut step = Self::standing(beat);
        let time = EASES * beat.time;
        step.ease = Ease::new(&before.numbers, &jets(0.0, |t| beat.law(paces, t)), time);
        let settles = if beat.walks() { beat.lift } else { SETTLES * paces.body.scale().sqrt() };
        // Of the pressure the place alone: its rate jumps as the load begins to shift.
        let at = |place: [f64; 2]| [place, [0.0; 2], [0.0; 2]];
        step.pressure = Ease::new(&at(before.pressure), &at(beat.pressure(paces, 0.0)[1]), settles);
        if beat.walks() {
            let side = beat.trailing();
            let law = jets(0.0, |t| beat.pitches(paces, side, t));
            step.pitch = Ease::new(&before.pitch[side], &law, beat.lift);
        }
        step
    }

    /// What pulls over the step, and `a` and `b` at its nodes.
    pub(super) fn bounded(&self, paces: &Paces, ahead: &Bounded) -> (Pulls, [Bounded; NODES + 1]) {
        let h = self.beat.time / NODES as f64;
        let pulls: Pulls = std::array::from_fn(|i| self.pull(paces, 0.5 * h * i as f64));
        let mut bounded = [*ahead; NODES + 1];
        for j in (0..NODES).rev() {
            bounded[j] = bounded[j + 1].before([&pulls[2 * j], &pulls[2 * j + 1], &pulls[2 * j + 2]], h);
        }
        (pulls, bounded)
    }

    fn pull(&self, paces: &Paces, t: f64) -> Pull {
        let [[y], _, [acceleration]] = jets(t, |t| [self.beat.height(paces, t) + self.ease.of(HEIGHT, t)]);
        Pull {
            stiffness: (G + acceleration) / y,
            pressure: self.pressure(paces, t),
            bump: self.beat.bump(t),
            shifted: 0.0,
        }
    }

    /// The pressure without its shift.
    fn pressure(&self, paces: &Paces, t: f64) -> [f64; 2] {
        let (law, left) = (self.beat.pressure(paces, t)[1], self.pressure.at(t));
        [law[0] + left[0], law[1] + left[1]]
    }

    /// The centre of pressure that the plan has on the ground, with its shift: x and z (m).
    pub(super) fn pressed(&self, paces: &Paces, t: f64) -> [f64; 2] {
        let [law, pulled] = self.beat.pressure(paces, t);
        let (at, bump) = (self.pressure(paces, t), self.beat.bump(t));
        [0, 1].map(|i| law[i] + at[i] - pulled[i] + bump * self.shifts.pressure[i])
    }

    fn numbers(&self, paces: &Paces, t: f64) -> [f64; NUMBERS] {
        let (mut law, left) = (self.beat.law(paces, t), self.ease.at(t));
        law.iter_mut().zip(left).for_each(|(law, left)| *law += left);
        law[HEIGHT] -= self.lowering(t);
        law
    }

    /// The centre of mass from above (x, z). Standing, it comes to rest by itself.
    fn place(&self, paces: &Paces, t: f64) -> [f64; 2] {
        if self.beat.kind == Kind::Stand && t > self.beat.time {
            // On the bounded way ẋ = ω (x̄ − x).
            let ([at, ..], rate) = (self.way.end(), self.beat.stiffness(paces, t).sqrt());
            let fallen = (-rate * (t - self.beat.time)).exp();
            return [0, 1].map(|i| self.beat.stands_at[i] + (at[i] - self.beat.stands_at[i]) * fallen);
        }
        self.way.at(t)
    }

    /// Pitches of a foot on the ground and of its toes, without what a hip that is far ahead adds.
    fn pitches(&self, paces: &Paces, side: usize, t: f64) -> [f64; 2] {
        let [pitch, toes] = self.beat.pitches(paces, side, t);
        if self.beat.walks() && side == self.beat.trailing() {
            let left = self.pitch.at(t);
            return [(pitch + left[0]).max(0.0), (toes + left[1]).max(0.0)];
        }
        [pitch, toes]
    }

    /// Pitch of a foot on the ground for the hips as they are then.
    fn risen(&self, paces: &Paces, side: usize, t: f64) -> [f64; 1] {
        let hip = self.beat.feet[side].print.local(side, &self.hips(paces, t).1[side]);
        [self.grounded(paces, side, t, &hip).1]
    }

    /// Ankle of a foot on the ground, and its pitches, in its print's frame, for the hip there.
    pub(super) fn grounded(
        &self,
        paces: &Paces,
        side: usize,
        t: f64,
        hip: &Vector3<f64>,
    ) -> (Vector3<f64>, f64, f64) {
        let [pitch, toes] = self.pitches(paces, side, t);
        let sole = paces.sole();
        if pitch < 0.0 {
            return (sole.ankle_on_heel(pitch), pitch, pitch);
        }
        let bears = side == self.beat.leading;
        let clock = if bears { self.beat.leading_clock(t) } else { self.beat.trailing_clock(t) };
        let ball = sole.ball(toes);
        let mut pitch = pitch;
        if self.beat.walks() && (!bears || self.beat.pushes) && clock > RISES.1 {
            let bends = ((clock - BENDS) / (self.beat.style.toe_off() - BENDS)).clamp(0.0, 1.0);
            let knee = KNEES[0] + BENT * bends * bends * (3.0 - 2.0 * bends);
            let needed = sole.pitch_on_ball(hip, &ball, knee) - pitch;
            let may = step::quintic((clock - RISES.1) / (RISES.2 - RISES.1)).position;
            pitch += may * not_below_zero(needed, RISES.0);
            if !bears {
                pitch = (pitch + self.risen.of(0, t)).max(0.0);
            }
            pitch = STEEPEST.0 - not_below_zero(STEEPEST.0 - pitch, STEEPEST.1);
        }
        (sole.ankle_on_ball(&ball, pitch), pitch, toes)
    }

    /// Where the body is: its numbers, pelvis and hips before it gives way.
    pub(super) fn hips(&self, paces: &Paces, t: f64) -> ([f64; NUMBERS], [Vector3<f64>; 2], Vector3<f64>) {
        let numbers = self.numbers(paces, t);
        let [x, z] = self.place(paces, t);
        let heading = self.beat.heading(t);
        let com = Vector3::new(x, numbers[HEIGHT], z);
        let pelvis = com - turned(heading, &Vector3::new(numbers[19], numbers[20], numbers[21]));
        let turn = rotations::about_y(heading) * rotations::matrix(trunk_of(&numbers)[0]);
        let hips = [0, 1].map(|side| pelvis + turn * paces.body.legs[side][0].offset);
        (numbers, hips, pelvis)
    }

    /// The whole posture at a time of the step.
    pub(super) fn placed(&self, paces: &Paces, t: f64) -> Placed {
        let beat = &self.beat;
        let (numbers, mut hips, mut pelvis) = self.hips(paces, t);
        let heading = beat.heading(t);
        let mut feet = [(Vector3::zeros(), 0.0, 0.0, 0.0); 2];
        for side in [0, 1] {
            let print = beat.feet[side].print;
            feet[side] = if beat.walks() && side == beat.trailing() && t > beat.lift {
                let (ankle, pitch, toes) = self.swung(paces, t);
                let x = (t - beat.lift) / (beat.time - beat.lift);
                let turn = beat.landing.print.heading - print.heading;
                (ankle, pitch, toes, print.heading + turn * step::quintic(x).position)
            } else {
                let (ankle, pitch, toes) = self.grounded(paces, side, t, &print.local(side, &hips[side]));
                (print.world(side, &ankle), pitch, toes, print.heading)
            };
        }
        // A leg that would be too short all the same lets the body give way.
        let short = [0, 1]
            .map(|side| not_below_zero(above(paces, &(hips[side] - feet[side].0), KNEES[1]), GIVES_WAY));
        let mut down = short;
        if beat.walks() {
            // A leg that swings, or is about to, draws its foot up instead, until shortly before it lands.
            let side = beat.trailing();
            let x = (t - beat.lift) / (beat.time - beat.lift);
            let lands = step::quintic((x - DRAWN.0) / DRAWN.1).position;
            down[side] *= 1.0 - step::quintic(t / (LEAVES * beat.lift)).position + lands;
            let down = down[0].max(down[1]);
            feet[side].0.y += (short[side] - down).max(0.0) * (1.0 - lands);
        }
        let down = down[0].max(down[1]);
        pelvis.y -= down;
        let mut legs = [LegPose::default(); 2];
        for side in [0, 1] {
            hips[side].y -= down;
            let (ankle, pitch, toes, turn) = feet[side];
            let hip = seen(side, &turned(-turn, &(hips[side] - ankle)));
            legs[side] = paces.plane.pose(&paces.body.leg, &hip, pitch, toes);
        }
        let com = pelvis + turned(heading, &Vector3::new(numbers[19], numbers[20], numbers[21]));
        let posture = Posture {
            pelvis,
            trunk: trunk_of(&numbers),
            arms: [[numbers[15], numbers[16]], [numbers[17], numbers[18]]],
            cane: [0.0; 2],
            carriage: beat.style.manner.carriage(),
            legs,
            heading,
            feet: [0, 1].map(|side| feet[side].3 - heading),
        };
        Placed { com, posture }
    }
}
