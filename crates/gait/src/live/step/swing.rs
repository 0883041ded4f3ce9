//! A foot in the air.

use super::Step;
use crate::body::foot::turned;
use crate::limbs::sole::not_below_zero;
use crate::live::ease::{Ease, jets};
use crate::live::paces::Paces;
use crate::live::print::sign;
use nalgebra::{Vector2, Vector3};
use solaris_profiles::step;

/// How far forward a foot swings at least and at most, over its pace's way.
const MOST_WAY: [f64; 2] = [-1.5, 1.6];
/// How near the line of a swinging foot comes to that of the other one, over the reference height (m).
const PASSES: f64 = 0.08;
/// Instants at which it is looked at, and the least part of the way outward that it has then.
const INSTANTS: i32 = 12;
const LEAST_HUMP: f64 = 0.3;
/// The greatest lift of a sole that would go through the ground softly (m), and over which part of a swing it comes to be.
const CLEARS: (f64, f64) = (0.004, 0.12);

/// A foot in the air: its pace's own swing, with what it differs by at its two ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Swing {
    start: Ease<5>,
    end: Ease<5>,
    outward: f64,
    /// Its way forward over the pace's.
    way: f64,
    /// How far forward the pace has it as it lifts (m).
    from: f64,
}

impl Swing {
    /// The pace's own.
    pub(super) const NONE: Self =
        Self { start: Ease::NONE, end: Ease::NONE, outward: 0.0, way: 1.0, from: 0.0 };
}

impl Step {
    /// Ankle of the swinging foot (world), and its pitches.
    pub(super) fn swung(&self, paces: &Paces, t: f64) -> (Vector3<f64>, f64, f64) {
        let side = self.beat.trailing();
        let [x, y, z, pitch, toes] = self.swung_in(paces, t);
        (self.beat.feet[side].print.world(side, &Vector3::new(x, y, z)), pitch, toes)
    }

    /// The same in the frame of the print that it has left, as five numbers.
    pub(super) fn swung_in(&self, paces: &Paces, t: f64) -> [f64; 5] {
        let since = t - self.beat.lift;
        let (start, end) = (self.swing.start.at(since), self.swing.end.at(self.beat.time - t));
        let mut at = self.swing_law(paces, t);
        for i in 0..5 {
            at[i] += start[i] + end[i];
        }
        let x = (since / (self.beat.time - self.beat.lift)).clamp(0.0, 1.0);
        at[0] += self.swing.outward * hump(x);
        // Never through the ground.
        let leg = &paces.body.leg;
        let soft = CLEARS.0 * step::quintic(x.min(1.0 - x) / CLEARS.1).position;
        if soft > 0.0 {
            at[1] += not_below_zero(soft - leg.lowest(leg.toe_polar(), at[1], at[3], at[4]), soft);
        }
        at
    }

    /// Joins the swing to the stances before and after it.
    pub(super) fn swing(&mut self, paces: &Paces) {
        let beat = self.beat;
        let side = beat.trailing();
        let time = beat.time - beat.lift;
        let local = |at: Vector3<f64>| {
            let world = beat.landing.print.world(side, &at);
            beat.feet[side].print.local(side, &world)
        };
        let [at, rate, _] = beat.landing_jets(paces);
        let point = |jet: &[f64; 4]| Vector3::new(jet[0], jet[1], jet[2]);
        let [from, to] = [beat.lift, beat.time].map(|t| paces.leg(beat.mix, beat.trailing_clock(t)).ankle.z);
        let way = ((local(point(&at)).z - from) / (to - from)).clamp(MOST_WAY[0], MOST_WAY[1]);
        (self.swing.from, self.swing.way) = (from, way);
        let by_law = [
            jets(beat.lift, |t| self.swing_law(paces, t)),
            jets(0.0, |s| self.swing_law(paces, beat.time - s)),
        ];
        let lifted = jets(beat.lift, |t| {
            let hip = beat.feet[side].print.local(side, &self.hips(paces, t).1[side]);
            let (ankle, pitch, toes) = self.grounded(paces, side, t, &hip);
            [ankle.x, ankle.y, ankle.z, pitch, toes]
        });
        self.swing.start = Ease::of_rates(&lifted, &by_law[0], time);
        let origin = local(Vector3::zeros());
        let jet = |at: Vector3<f64>, pitch: f64, sign: f64| {
            [sign * at.x, at.y * sign, at.z * sign, sign * pitch, sign * pitch]
        };
        // On a clock that runs backwards from the contact rates have the other sign.
        let landed =
            [jet(local(point(&at)), at[3], 1.0), jet(local(point(&rate)) - origin, rate[3], -1.0), [0.0; 5]];
        self.swing.end = Ease::of_rates(&landed, &by_law[1], time);
        self.swing.outward = 0.0;
        self.swing.outward = self.passes(paces);
    }

    /// The swing of the pace, as far forward as this one goes: ankle in the frame of the print that was left, pitches.
    fn swing_law(&self, paces: &Paces, t: f64) -> [f64; 5] {
        let law = paces.leg(self.beat.mix, self.beat.trailing_clock(t));
        let Swing { from, way, .. } = self.swing;
        [law.ankle.x, law.ankle.y, from + way * (law.ankle.z - from), law.pitch, law.toes]
    }

    /// By how much a swinging foot goes outward to pass the other one: so that both feet's lines, from heel to tip, stay apart.
    fn passes(&self, paces: &Paces) -> f64 {
        let (beat, leg) = (&self.beat, &paces.body.leg);
        let (side, time) = (beat.trailing(), beat.time - beat.lift);
        let (from, other) = (&beat.feet[side].print, &beat.feet[beat.leading].print);
        let apart = PASSES * paces.body.scale();
        let local = |along: f64| {
            let at = from.local(side, &other.world(beat.leading, &(paces.plane.forward * along)));
            Vector2::new(at.x, at.z)
        };
        let standing = [0.0, leg.foot_length()].map(local);
        let turn = sign(side) * (beat.landing.print.heading - from.heading);
        let mut outward = 0.0_f64;
        for i in 1..INSTANTS {
            let x = f64::from(i) / f64::from(INSTANTS);
            let at = self.swung_in(paces, beat.lift + x * time);
            let forward = turned(turn * step::quintic(x).position, &paces.plane.forward);
            let along = |way: f64| Vector2::new(at[0] + way * forward.x, at[2] + way * forward.z);
            let swinging = [-leg.heel_behind, leg.ball_ahead + leg.toe].map(along);
            let near = standing.map(|point| distance(&swinging, &point));
            let near_too = swinging.map(|point| distance(&standing, &point));
            let missing = apart - near.into_iter().chain(near_too).fold(f64::INFINITY, f64::min);
            if missing > 0.0 {
                outward = outward.max(missing / hump(x).max(LEAST_HUMP));
            }
        }
        outward.min(2.0 * apart)
    }
}

/// Distance of a point from the line between two others.
fn distance([from, to]: &[Vector2<f64>; 2], point: &Vector2<f64>) -> f64 {
    let along = to - from;
    let part = ((point - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    (from + along * part - point).norm()
}

/// 0 at both ends of a swing, 1 in its middle.
fn hump(x: f64) -> f64 {
    (4.0 * x * (1.0 - x)).powi(3)
}
