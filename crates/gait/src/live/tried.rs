//! A step that is tried: what it would take of footholds and pressure.

use super::balance::{Bounded, NODES, Pulls, Shifts};
use super::beat::{Beat, Kind, SETTLES};
use super::command::{Command, ahead, own};
use super::footholds::{Bends, Bent, Course, apart};
use super::paces::Paces;
use super::print::{Print, sign};
use super::step::{Before, Step};
use crate::body::foot::turned;
use crate::walking::G;
use nalgebra::Vector3;
use solaris_profiles::step;

/// Steps that are looked ahead, with the one that is made.
const PREVIEW: usize = 3;
/// Pieces of a step that is only looked at.
const COARSE: usize = 12;
/// By how much the pressure under a foot and the next foothold are shifted alike where they share (m).
const SHARES: [f64; 2] = [0.02, 0.05];
/// How far a foothold is shifted at most: forward and aside (m, for the reference height).
const MOST_SHIFTED: [f64; 2] = [0.10, 0.05];
/// How much longer than its pace's a step may become by that.
const LONGER: f64 = 1.05;
/// How far the pressure may be shifted aside and along under one foot, and before the first step (m, likewise).
const PRESSED: [f64; 2] = [0.03, 0.07];
const SHIFTED: [f64; 2] = [0.09, 0.11];

/// A step that is tried: looks a few footholds ahead, finds the way of the centre of mass that stays with them, and what must be shifted
/// for it.
pub(super) struct Tried {
    pub(super) step: Step,
    pub(super) course: Course,
    pulls: Pulls,
    bounded: [Bounded; NODES + 1],
    shifts: Shifts,
    bent: Bends,
    /// The greatest shift over what may be.
    pub(super) strain: f64,
}

impl Tried {
    pub(super) fn new(
        paces: &Paces,
        beat: &Beat,
        course: Course,
        command: &Command,
        before: &Before,
        bent: Bends,
    ) -> Self {
        let ahead = looked_ahead(paces, beat, &course, command);
        let step = Step::eased(paces, beat, before);
        let (pulls, bounded) = step.bounded(paces, &ahead);
        let mut tried = Self { step, course, pulls, bounded, shifts: Shifts::default(), bent, strain: 0.0 };
        tried.shift(paces, before);
        tried
    }

    /// Shares out what the velocity is off by: `c = b_A A + b_D D`, with `(A/α)² + (D/δ)²` least.
    fn shift(&mut self, paces: &Paces, before: &Before) {
        let (beat, first) = (&mut self.step.beat, &self.bounded[0]);
        let scale = paces.body.scale();
        let [at, velocity] = before.com;
        let missing = [0, 1].map(|i| velocity[i] + first.rate * at[i] - first.level[i]);
        if beat.kind == Kind::Walk && beat.pushes {
            let [pressure, foothold] = [SHARES[0] * first.bump, SHARES[1] * first.shift];
            let part = SHARES[1] * foothold / (pressure * pressure + foothold * foothold);
            let wanted = own(beat.faces[0], missing.map(|x| x * part));
            // Farther ahead up to a step of the pace.
            let length = beat.step_time * self.course.velocity[1];
            let farther = (LONGER * beat.style.step_length - length).max(MOST_SHIFTED[0] * scale);
            let most =
                [MOST_SHIFTED[1] * scale, if wanted[1] > 0.0 { farther } else { MOST_SHIFTED[0] * scale }];
            let [x, z] = ahead(beat.faces[0], [0, 1].map(|i| wanted[i].clamp(-most[i], most[i])));
            let print = beat.landing.print;
            let moved = Print { heel: print.heel + Vector3::new(x, 0.0, z), ..print };
            let side = beat.trailing();
            let moved = apart(paces, &beat.feet[beat.leading].print, moved, side, &mut self.bent);
            let shift = moved.heel - print.heel;
            self.shifts.foothold = [shift.x, shift.z];
            beat.landing.print = moved;
            self.course.feet[side].print = moved;
            self.course.center += shift;
        }
        for i in [0, 1] {
            self.shifts.pressure[i] = (missing[i] - first.shift * self.shifts.foothold[i]) / first.bump;
        }
        let [aside, along] = own(beat.faces[0], self.shifts.pressure);
        let most = if beat.kind == Kind::Walk { PRESSED } else { SHIFTED };
        self.strain = (aside / most[0]).hypot(along / most[1]) / scale;
        if self.strain > 1.0 {
            self.bent.add(Bent::Balance);
        }
    }

    pub(super) fn finished(self, paces: &Paces, before: &Before) -> (Step, Course, Bends) {
        let step = self.step.made(paces, before, (&self.pulls, &self.bounded), self.shifts);
        (step, self.course, self.bent)
    }
}

/// `a` and `b` at the end of a step, from the steps that the command would make after it.
fn looked_ahead(paces: &Paces, beat: &Beat, course: &Course, command: &Command) -> Bounded {
    let mut beats = [*beat; PREVIEW];
    let (mut count, mut at) = (1, *course);
    while count < PREVIEW && beats[count - 1].walks() {
        let faces = beats[count - 1].faces;
        let (next, after) = at.next(paces, command, &[[faces[0]], [faces[1]], [0.0]], &mut Bends::default());
        beats[count] = next;
        at = after;
        count += 1;
    }
    let end = &beats[count - 1];
    let mut bounded = if end.walks() {
        settled(paces, end, &at)
    } else {
        let mut bounded = Bounded::through(end.stands_at, [0.0; 2], end.stiffness(paces, 0.0));
        if count > 1 {
            // The pressure goes from the foot that bore to where the body stands.
            let (from, time) = (beats[count - 2].pressure(paces, beats[count - 2].time)[1], SETTLES);
            bounded = bounded.before_step(time, COARSE, |t| {
                let left = 1.0 - step::quintic(t / time).position;
                let mut pull = end.pull(paces, t, false);
                for i in [0, 1] {
                    pull.pressure[i] += left * (from[i] - pull.pressure[i]);
                }
                pull
            });
        }
        bounded
    };
    let walked = if end.walks() { count } else { count - 1 };
    for k in (1..walked.max(1)).rev() {
        bounded = bounded.before_step(beats[k].time, COARSE, |t| beats[k].pull(paces, t, k == 1));
    }
    bounded
}

/// As a step ends, by the steady stride of its pace.
fn settled(paces: &Paces, beat: &Beat, course: &Course) -> Bounded {
    let side = beat.trailing();
    let [at, velocity] = paces.contact(beat.mix);
    let [aside, forward] = course.velocity;
    let faces = beat.landing.print.heading;
    let style = &beat.style;
    let pace = style.step_length / beat.step_time;
    let lag = 0.5 * (style.step_length - forward * beat.step_time);
    let place = course.center + {
        let local = Vector3::new(sign(side) * (at[0] + 0.5 * style.step_width), 0.0, at[1] + lag);
        turned(faces, &local)
    };
    let faster = 0.5 * style.stride_time / beat.step_time;
    let own = [aside + sign(side) * velocity[0] * faster, forward + velocity[1] * faster - pace];
    let stiffness = G / beat.mean_height;
    Bounded::through([place.x, place.z], ahead(faces, own), stiffness)
}
