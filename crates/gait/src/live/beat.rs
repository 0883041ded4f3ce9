//! What is decided of one step before it is made: which foot stands where, which lands where and when; and the laws that follow.

use super::balance::Pull;
use super::ease::{Bridge, jets};
use super::paces::{Mix, Paces};
use super::print::{Print, seen, sign};
use crate::body::rotations::Euler;
use crate::limbs::sole::not_below_zero;
use crate::smooth::Style;
use crate::smooth::laws::{self, Swings};
use crate::walking::G;
use nalgebra::Vector3;
use solaris_analysis::FootSupport;
use solaris_profiles::step;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Numbers of the posture that a law gives: five trunk orientations, two arms, the centre of mass against the pelvis (left, up, forward of the
/// heading) and its height.
pub(super) const NUMBERS: usize = 23;
/// Where the height stands among them.
pub(super) const HEIGHT: usize = 22;
/// The own clock in mid-stance, at which a foot is flat in every pace.
const FLAT_AT: f64 = 0.14;
/// Pitches that are taken for none: curves through samples ring so far (rad).
const RINGING: f64 = 0.002;
/// How far ahead the head looks (s), and how far at most: as each step takes over from the one before, it turns a quarter of a second before the body.
const LOOKS_AHEAD: f64 = 0.33;
const MOST_AHEAD: f64 = 25.0 * DEGREE;
/// When the load begins to shift before the first step, as a part of the time to the lift.
const SHIFTS_FROM: f64 = 0.35;
/// How long the centre of pressure takes to come to its place as the walk ends (s, for the reference height).
pub(super) const SETTLES: f64 = 0.6;

/// A foot and its print.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Foot {
    pub(super) print: Print,
    /// How it has landed; a foot that has stood there all along has none.
    pub(super) landed: Option<Landed>,
}

/// How and when a foot has landed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Landed {
    pub(super) mix: Mix,
    /// By the time of the step (s).
    pub(super) at: f64,
    /// Rate of its own clock (1/s).
    pub(super) rate: f64,
}

impl Foot {
    /// The same seen from a step that begins so much later.
    pub(super) fn later(self, time: f64) -> Self {
        let landed = self.landed.map(|landed| Landed { at: landed.at - time, ..landed });
        Self { landed, ..self }
    }

    /// Own clock since it has landed; without an end for a foot that has not.
    fn clock(&self, t: f64) -> f64 {
        self.landed.map_or(f64::INFINITY, |landed| (t - landed.at) * landed.rate)
    }

    /// Whether it has come down all the way at a time.
    pub(super) fn is_flat(&self, t: f64) -> bool {
        self.clock(t) >= FLAT_AT
    }
}

/// What a step is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Both feet stand.
    Stand,
    /// The first step from standing: the load shifts first.
    Start,
    /// One foot swings.
    Walk,
}

/// One step, as decided.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beat {
    pub(super) kind: Kind,
    /// The side that bears the swing.
    pub(super) leading: usize,
    /// Where the feet stand as it begins (left, right).
    pub(super) feet: [Foot; 2],
    /// Where the swinging foot lands.
    pub(super) landing: Foot,
    /// Whether the heel of the bearing foot rises, as the next step goes on.
    pub(super) pushes: bool,
    pub(super) mix: Mix,
    pub(super) style: Style,
    pub(super) mean_height: f64,
    /// How long it lasts, when the foot lifts, and the time of a step of this pace (s).
    pub(super) time: f64,
    pub(super) lift: f64,
    pub(super) step_time: f64,
    /// The part of its pace's pitch with which a foot pushes off that is less far behind.
    pub(super) push: f64,
    /// How far the pressure rolls along a foot, as a part of what it does in people's steps: less in short ones, the other way backward.
    pub(super) roll: f64,
    /// The way the body faces (rad).
    pub(super) heading: Bridge<1>,
    /// Heading and its rate at the end.
    pub(super) faces: [f64; 2],
    /// Lean of the trunk to the left (rad).
    pub(super) lean: f64,
    /// Where the body comes to stand (x, z).
    pub(super) stands_at: [f64; 2],
}

impl Beat {
    pub(super) fn walks(&self) -> bool {
        self.kind != Kind::Stand
    }

    /// The side of the foot that swings.
    pub(super) fn trailing(&self) -> usize {
        1 - self.leading
    }

    /// Own clock of the bearing foot.
    pub(super) fn leading_clock(&self, t: f64) -> f64 {
        if self.walks() { 0.5 - 0.5 * (self.time - t) / self.step_time } else { 0.5 * t / self.step_time }
    }

    /// Own clock of the foot that swings: 1 as it lands.
    pub(super) fn trailing_clock(&self, t: f64) -> f64 {
        1.0 - 0.5 * (self.time - t) / self.step_time
    }

    /// The clock of the body, as if the left foot led. Before the first step it begins at rest.
    fn body_clock(&self, t: f64) -> f64 {
        if self.kind == Kind::Start && t < self.lift {
            let lift = 0.5 - 0.5 * (self.time - self.lift) / self.step_time;
            let speed = 0.5 / self.step_time;
            return lift + speed * (0.5 * t * t / self.lift - 0.5 * self.lift);
        }
        self.leading_clock(t)
    }

    /// Which way the body faces; it goes on beyond the end.
    pub(super) fn heading(&self, t: f64) -> f64 {
        if t <= self.time { self.heading.at(t)[0] } else { self.faces[0] + self.faces[1] * (t - self.time) }
    }

    /// The numbers of the posture by the laws alone, see [`NUMBERS`].
    pub(super) fn law(&self, paces: &Paces, t: f64) -> [f64; NUMBERS] {
        let mut law = [0.0; NUMBERS];
        let swings = if self.walks() { Swings::ALL } else { Swings::NONE };
        let u = self.body_clock(t);
        let (mut trunk, mut arms) = (laws::trunk(&self.style, u, swings), laws::arms(&self.style, u, swings));
        let offset = if self.walks() {
            paces.carried(self.mix, u).0
        } else {
            paces.standing.com - paces.standing.pelvis
        };
        if self.leading == 1 {
            trunk = trunk.map(|[z, y, x]| [-z, -y, x]);
            arms = [arms[1], arms[0]];
        }
        // Neck and head turn before the body does; abdomen and thorax lean into the bend.
        let ahead = self.heading(t + LOOKS_AHEAD) - self.heading(t);
        let ahead = MOST_AHEAD * (ahead / MOST_AHEAD).tanh();
        trunk[3][1] += 0.5 * ahead;
        trunk[4][1] += ahead;
        trunk[1][0] -= 0.5 * self.lean;
        trunk[2][0] -= self.lean;
        trunk[3][0] -= 0.5 * self.lean;
        for (i, angles) in trunk.iter().enumerate() {
            law[3 * i..3 * i + 3].copy_from_slice(angles);
        }
        for (i, angles) in arms.iter().enumerate() {
            law[15 + 2 * i..17 + 2 * i].copy_from_slice(angles);
        }
        let offset = seen(self.leading, &offset);
        law[19..22].copy_from_slice(offset.as_slice());
        law[HEIGHT] = self.height(paces, t);
        law
    }

    /// Height of the centre of mass by the laws alone (m).
    pub(super) fn height(&self, paces: &Paces, t: f64) -> f64 {
        if !self.walks() {
            return paces.standing.com.y;
        }
        self.mean_height + self.style.height(paces.body.leg.length(), self.body_clock(t)).0
    }

    /// The share of the load on the bearing foot.
    pub(super) fn share(&self, t: f64) -> f64 {
        let x = t / self.lift;
        match self.kind {
            Kind::Stand => 0.5,
            Kind::Start => 0.5 + 0.5 * step::cubic((x - SHIFTS_FROM) / (1.0 - SHIFTS_FROM)).position,
            Kind::Walk => laws::share_rise(&self.style, self.style.double_support * x.max(0.0)),
        }
    }

    /// The centre of pressure of a foot.
    fn pressed(&self, paces: &Paces, side: usize, clock: f64) -> Vector3<f64> {
        let [along, outward] = paces.press(self.mix, clock.max(0.0));
        let middle = paces.standing.com.z / paces.plane.forward.z;
        let along = middle + self.roll * (along - middle);
        let plane = &paces.plane;
        self.feet[side].print.world(side, &(plane.forward * along + plane.left * outward))
    }

    /// The share and the centre of pressure of each foot (left, right) by the law, for a body that presses at `at` (x, z).
    pub(super) fn supports(&self, paces: &Paces, t: f64, at: [f64; 2]) -> [FootSupport; 2] {
        let middle = paces.plane.forward * (paces.standing.com.z / paces.plane.forward.z);
        let stood = |side: usize| self.feet[side].print.world(side, &middle);
        let place = |side: usize| match self.kind {
            Kind::Stand => stood(side),
            _ if side == self.leading => self.pressed(paces, side, self.leading_clock(t)),
            _ => self.pressed(paces, side, self.trailing_clock(t)),
        };
        let cop = [place(0), place(1)];
        let apart = cop[1] - cop[0];
        let right = if self.walks() {
            let share = self.share(t).clamp(0.0, 1.0);
            if self.leading == 1 { share } else { 1.0 - share }
        } else {
            // Who stands bears the load with the foot that is nearer.
            let way = Vector3::new(at[0], 0.0, at[1]) - cop[0];
            (way.dot(&apart) / apart.norm_squared()).clamp(0.0, 1.0)
        };
        [FootSupport::level(1.0 - right, cop[0]), FootSupport::level(right, cop[1])]
    }

    /// The centre of pressure by the law, and with what the angular momentum does to it (x, z): `P + (−Ḣ_z, Ḣ_x)/F_y`.
    pub(super) fn pressure(&self, paces: &Paces, t: f64) -> [[f64; 2]; 2] {
        if !self.walks() {
            return [self.stands_at; 2];
        }
        let lead = self.pressed(paces, self.leading, self.leading_clock(t));
        let share = self.share(t);
        let at = if share < 1.0 {
            let trail = self.pressed(paces, self.trailing(), self.trailing_clock(t));
            lead * share + trail * (1.0 - share)
        } else {
            lead
        };
        let clock = self.body_clock(t);
        let [hx, hz] = paces.carried(self.mix, clock).1;
        let rate = Vector3::new(hx, 0.0, sign(self.leading) * hz);
        let rate = crate::body::foot::turned(self.faces[0], &rate);
        let part = if self.kind == Kind::Start { step::quintic(t / self.lift).position } else { 1.0 };
        let vertical = paces.body.mass * (G + self.style.height(paces.body.leg.length(), clock).1);
        let part = part / vertical;
        [[at.x, at.z], [at.x - rate.z * part, at.z + rate.x * part]]
    }

    /// How much of the shift of the pressure there is: a bump over the step; before the first one while both feet stand.
    pub(super) fn bump(&self, t: f64) -> f64 {
        match self.kind {
            Kind::Start => step::bump(t / self.lift).position,
            Kind::Walk | Kind::Stand => step::bump(t / self.time).position,
        }
    }

    /// The pull by the laws alone, on footholds of which this part is shifted.
    pub(super) fn pull(&self, paces: &Paces, t: f64, first: bool) -> Pull {
        let shifted = if first { self.share(t) } else { 1.0 };
        Pull { stiffness: self.stiffness(paces, t), pressure: self.pressure(paces, t)[1], bump: 0.0, shifted }
    }

    /// Stiffness of the pull by the laws alone: `(g + ÿ)/y`.
    pub(super) fn stiffness(&self, paces: &Paces, t: f64) -> f64 {
        if !self.walks() {
            return G / paces.standing.com.y;
        }
        let (y, acceleration) = self.style.height(paces.body.leg.length(), self.body_clock(t));
        (G + acceleration) / (self.mean_height + y)
    }

    /// Pitches of a foot on the ground and of its toes, by the laws alone.
    pub(super) fn pitches(&self, paces: &Paces, side: usize, t: f64) -> [f64; 2] {
        let (foot, bears) = (&self.feet[side], side == self.leading);
        if let (Some(landed), false) = (foot.landed, foot.is_flat(t)) {
            let pitch = -distinct(-paces.leg(landed.mix, foot.clock(t).max(0.0)).pitch);
            return [pitch, pitch];
        }
        let clock = if bears { self.leading_clock(t) } else { self.trailing_clock(t) };
        if clock < FLAT_AT || !self.walks() || (bears && !self.pushes) {
            return [0.0; 2];
        }
        let law = paces.leg(self.mix, clock);
        let part = if bears { 1.0 } else { self.push };
        [part * distinct(law.pitch), part * distinct(law.toes)]
    }

    /// Jets of a landing foot's ankle against its heel and of its pitch, by time.
    pub(super) fn landing_jets(&self, paces: &Paces) -> [[f64; 4]; 3] {
        let [p, v, a] = paces.landing(self.mix);
        let rate = 0.5 / self.step_time;
        let sole = paces.sole();
        jets(0.0, |t| {
            let u = t * rate;
            let pitch = -distinct(-(p + u * (v + 0.5 * u * a)));
            let ankle = sole.ankle_on_heel(pitch);
            [ankle.x, ankle.y, ankle.z, pitch]
        })
    }
}

/// A pitch above what curves ring, from there on: none below zero.
fn distinct(pitch: f64) -> f64 {
    not_below_zero(pitch - RINGING, RINGING)
}

/// The trunk among the numbers of a posture.
pub(super) fn trunk_of(law: &[f64; NUMBERS]) -> [Euler; 5] {
    std::array::from_fn(|i| [law[3 * i], law[3 * i + 1], law[3 * i + 2]])
}
