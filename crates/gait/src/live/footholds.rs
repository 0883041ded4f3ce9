//! Where the coming feet land: from what is wished to what can be walked.

use super::beat::{Beat, Foot, Kind, Landed, SETTLES};
use super::command::{Command, SLOWEST, Wish, ahead, own};
use super::ease::{Bridge, Jets};
use super::paces::Paces;
use super::print::{Print, sign};
use crate::body::foot::turned;
use crate::walking::G;
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};

const DEGREE: f64 = PI / 180.0;

/// The farthest turn of a step, and of the first one (rad).
const TURN: [f64; 2] = [25.0 * DEGREE, 20.0 * DEGREE];
/// A turn that is none.
const LEAST_TURN: f64 = 0.5 * DEGREE;
/// How far a foot opens beside a turn, as a part of it.
const OPENED: f64 = 0.35;
/// The fastest walk aside and backward (m/s, for the reference height).
const ASIDE: f64 = 0.22;
const BACKWARD: f64 = 0.45;
/// By how much a step may be faster and slower than the one before, and the first one than standing (m/s, likewise).
const FASTER: f64 = 0.35;
const SLOWER: f64 = 0.55;
/// By how much less the speed of its cadence falls (m/s, likewise).
const LAGS: f64 = 0.1;
const FIRST: f64 = 0.85;
/// And farther aside.
const SIDEWAYS: f64 = 0.15;
/// The drift that makes somebody step who stands (m/s): below it he sways where he is.
const STIRS: f64 = 0.1;
/// The radius below which bends are walked slower (m): by the third root, as people do.
const BEND: f64 = 4.0;
/// The least part of a speed that is left while the body turns to where it goes.
const TURNING: f64 = 0.2;
/// The cadence to which slow steps are hastened that turn, go aside or back (steps/min).
const HASTENED: f64 = 84.0;
/// The deceleration by which a walk to a point comes to its end (m/s²).
const BRAKES: f64 = 0.45;
/// The least distance of two heels aside, as a part of the step width.
const BESIDE: f64 = 0.86;
/// The load shifts so long before the first step (s, for the reference height).
const SHIFT_TIME: f64 = 0.62;
/// What a backward step takes of the pace's stride: it lands flat and hardly pushes.
const BACK_PACE: f64 = 0.3;
/// How far the body is lowered for a foot that is set down aside or behind, over the square of how far (1/m, for the reference height).
const BOWS: f64 = 0.33;
/// How far the trunk leans into a bend, as a part of what would be in balance.
const LEAN: f64 = 0.6;
/// How far the pressure rolls back along a foot in backward steps.
const LEAST_ROLL: f64 = -0.5;
/// The least push of a foot that is hardly behind.
const LEAST_PUSH: f64 = 0.45;

/// In what a wish was bent to what can be walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Bent {
    /// It was to be faster than the figure walks.
    Fast,
    /// It was to go aside or backward faster than it can.
    Aside,
    /// It was to turn farther than a step does: it takes more of them.
    Sharp,
    /// Speed changes over several steps.
    Sudden,
    /// A foot lands elsewhere than the speed alone would have it, for balance or past the other foot.
    Balance,
}

impl Bent {
    const ALL: [Self; 5] = [Self::Fast, Self::Aside, Self::Sharp, Self::Sudden, Self::Balance];
}

/// Any of [`Bent`].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bends(u8);

impl Bends {
    pub(super) fn add(&mut self, bent: Bent) {
        self.0 |= 1 << bent as u8;
    }

    pub(super) fn all(self) -> impl Iterator<Item = Bent> {
        Bent::ALL.into_iter().filter(move |bent| self.0 & (1 << *bent as u8) != 0)
    }
}

/// Where a walk is as a step begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    /// The side that has landed last, or would bear the first step.
    pub(super) leading: usize,
    pub(super) feet: [Foot; 2],
    /// The way of both feet's prints before they were opened (rad).
    pub(super) headings: [f64; 2],
    /// Middle of the feet (m).
    pub(super) center: Vector3<f64>,
    /// To the left and forward (m/s).
    pub(super) velocity: [f64; 2],
    pub(super) stands: bool,
    /// Whether the feet have closed, so that it is to stand next.
    pub(super) closed: bool,
    /// The speed whose cadence and manner its last step had (m/s).
    pub(super) pace: f64,
    /// The part of a change of speed that a step makes.
    pub(super) gain: f64,
}

impl Course {
    /// Whether a step follows.
    pub(super) fn walks_on(&self) -> bool {
        !self.stands
    }

    /// Which way the body faces.
    fn faces(&self) -> f64 {
        0.5 * (self.headings[0] + self.headings[1])
    }

    /// Whether a command asks for a step of somebody who stands.
    pub(super) fn is_moved_by(&self, command: &Command) -> bool {
        let wish = command.wish([self.center.x, self.center.z], self.faces());
        wish.speed > SLOWEST
            || wish.drift[0].hypot(wish.drift[1]) > STIRS
            || wrapped(wish.facing - self.faces()).abs() > 4.0 * LEAST_TURN
    }

    /// The next step, from this heading of the body on, and the course after it. The first step leads with the foot on the side that
    /// it goes or turns to.
    pub(super) fn next(
        &self,
        paces: &Paces,
        command: &Command,
        heading: &Jets<1>,
        bent: &mut Bends,
    ) -> (Beat, Self) {
        if self.closed || (self.stands && !self.is_moved_by(command)) {
            return self.standing(paces, heading);
        }
        let scale = paces.body.scale();
        let place = [self.center.x, self.center.z];
        let before = self.headings[self.leading];
        let wish = command.wish(place, if self.stands { self.faces() } else { before });
        let left = wrapped(wish.facing - before);
        let most = TURN[usize::from(self.stands)];
        let turn = if left.abs() < LEAST_TURN { 0.0 } else { left.clamp(-most, most) };
        if turn.abs() < left.abs() && turn != 0.0 {
            bent.add(Bent::Sharp);
        }
        let facing = before + turn;
        let velocity = self.velocity(&wish, before, turn, paces, bent);
        let [aside, forward] = velocity;
        let pace = if forward < 0.0 { -BACK_PACE * forward } else { forward };
        // Slowing down shortens steps at once, and takes its time with the cadence.
        let pace = if self.stands { pace } else { pace.max(self.pace - LAGS * paces.body.scale().sqrt()) };
        let mix = paces.at(pace);
        let style = paces.style(mix);
        let need = (aside.abs() / (ASIDE * scale.sqrt()))
            .max(turn.abs() / TURN[0])
            .max(-forward / (BACKWARD * scale.sqrt()))
            .clamp(0.0, 1.0);
        let slowest = super::paces::CADENCE.0 + (HASTENED - super::paces::CADENCE.0) * need;
        let step_time = 60.0 / style.step_frequency.max(slowest);
        let closes = !self.stands && aside.hypot(forward) < SLOWEST && turn == 0.0;
        let mut course = *self;
        if self.stands {
            // The inner foot goes first.
            let to = if aside.abs() > 0.3 * forward.abs() { aside } else { turn };
            course.leading = usize::from(to > 0.0);
        }
        let (leading, trailing) = (course.leading, 1 - course.leading);
        let time = if self.stands { step_time * 0.88 } else { step_time };
        let mut way = [aside * time, forward * time];
        let length = way[0].hypot(way[1]);
        let most = wish.left + wish.drift[0].hypot(wish.drift[1]) * time;
        if length > most {
            way = way.map(|x| x * most / length);
        }
        let [x, z] = ahead(before + 0.5 * turn, way);
        let center = self.center + Vector3::new(x, 0.0, z);
        // Feet that go aside stand wider, so that the one that closes does not step on the other.
        let width = style.step_width;
        let half = (0.5 * width).max(0.5 * (BESIDE * width + way[0].abs()));
        let heel = center + turned(facing, &Vector3::new(sign(trailing) * half, 0.0, 0.0));
        let print = Print { heel, heading: facing + sign(trailing) * OPENED * turn.abs() };
        let lift =
            if self.stands { SHIFT_TIME * scale.sqrt() } else { 2.0 * style.double_support * step_time };
        let duration = lift + (1.0 - 2.0 * style.double_support) * step_time;
        course.feet[trailing].print = apart(paces, &course.feet[leading].print, print, trailing, bent);
        course.center = center;
        course.headings[trailing] = facing;
        course.velocity = velocity;
        course.pace = pace;
        course.stands = false;
        course.closed = closes;
        let ends = course.faces();
        let after = wrapped(wish.facing - facing).clamp(-TURN[0], TURN[0]);
        let rate = if closes { 0.0 } else { 0.25 * (2.0 * turn + after) / step_time };
        let behind = own(before, {
            let apart = self.feet[leading].print.heel - self.feet[trailing].print.heel;
            [apart.x, apart.z]
        })[1];
        let push = ((behind + 0.3) / (style.step_length + 0.3)).clamp(LEAST_PUSH, 1.0);
        let landing = Foot {
            print: course.feet[trailing].print,
            landed: Some(Landed { mix, at: duration, rate: 0.5 / step_time }),
        };
        let beat = Beat {
            kind: if self.stands { Kind::Start } else { Kind::Walk },
            leading,
            feet: self.feet,
            landing,
            pushes: !closes,
            mix,
            mean_height: paces.mean_height(mix)
                - BOWS / scale * ((2.0 * way[0]).powi(2) + way[1].min(0.0).powi(2)),
            time: duration,
            lift,
            step_time,
            push,
            roll: (way[1] / paces.shortest()).clamp(LEAST_ROLL, 1.0),
            heading: Bridge::new(heading, &[[ends], [rate], [0.0]], duration),
            faces: [ends, rate],
            lean: LEAN * (forward * turn / step_time / G).atan(),
            stands_at: place,
            style,
        };
        course.feet = [0, 1].map(|side| {
            if side == trailing { landing.later(duration) } else { self.feet[side].later(duration) }
        });
        course.leading = trailing;
        (beat, course)
    }

    /// Coming to a stand with the feet as they are.
    fn standing(&self, paces: &Paces, heading: &Jets<1>) -> (Beat, Self) {
        let mix = paces.at(0.0);
        let style = paces.style(mix);
        let time = SETTLES * paces.body.scale().sqrt() * 1.2;
        let faces = self.faces();
        let middle = 0.5 * (self.feet[0].print.heel + self.feet[1].print.heel);
        let at = middle + turned(faces, &Vector3::new(0.0, 0.0, paces.standing.com.z));
        let beat = Beat {
            kind: Kind::Stand,
            leading: self.leading,
            feet: self.feet,
            landing: self.feet[self.leading],
            pushes: false,
            mix,
            mean_height: paces.mean_height(mix),
            time,
            lift: time,
            step_time: 60.0 / style.step_frequency,
            push: 1.0,
            roll: 0.0,
            heading: Bridge::new(heading, &[[faces], [0.0], [0.0]], time),
            faces: [faces, 0.0],
            lean: 0.0,
            stands_at: [at.x, at.z],
            style,
        };
        let course = Self {
            velocity: [0.0; 2],
            pace: 0.0,
            stands: true,
            closed: false,
            feet: self.feet.map(|foot| foot.later(time)),
            headings: [faces; 2],
            center: middle,
            ..*self
        };
        (beat, course)
    }

    /// The velocity of the next step to the left and forward, of what is wished.
    fn velocity(&self, wish: &Wish, before: f64, turn: f64, paces: &Paces, bent: &mut Bends) -> [f64; 2] {
        let scale = paces.body.scale().sqrt();
        let speed = wish.speed.min((2.0 * BRAKES * wish.left).sqrt());
        let part = if wish.speed > 0.0 { speed / wish.speed } else { 0.0 };
        let wished = wish.velocity.map(|v| v * part);
        let mut velocity = own(before + 0.5 * turn, wished);
        if wish.by_way {
            // It goes where it faces, slower while it turns and round bends.
            let left = wrapped(wish.facing - before - turn);
            velocity = if left.abs() > LEAST_TURN || velocity[1] <= 0.0 {
                [0.0, speed * left.cos().max(TURNING)]
            } else {
                [0.0, speed]
            };
            let length = velocity[1] * 0.6;
            velocity[1] *= (length / turn.abs().max(1e-3) / BEND).cbrt().min(1.0);
        }
        let drift = own(before + 0.5 * turn, wish.drift);
        velocity = [velocity[0] + drift[0], velocity[1] + drift[1]];
        let fastest = paces.fastest();
        if velocity[1] > fastest {
            velocity[1] = fastest;
            bent.add(Bent::Fast);
        }
        let (aside, back) = (ASIDE * scale, BACKWARD * scale);
        let over = (velocity[0] / aside).abs().hypot(if velocity[1] < 0.0 {
            velocity[1] / back
        } else {
            velocity[1] / (1.2 * fastest)
        });
        if over > 1.0 {
            velocity = velocity.map(|v| v / over);
            bent.add(Bent::Aside);
        }
        let (was, faster) = if self.stands { ([0.0; 2], FIRST) } else { (self.velocity, FASTER) };
        let limits = [
            (-SIDEWAYS, SIDEWAYS),
            if was[1] > 0.0 { (-SLOWER, faster) } else { (-faster.min(SLOWER), faster.max(SLOWER)) },
        ];
        for i in [0, 1] {
            let (least, most) = limits[i];
            let change = (velocity[i] - was[i]).clamp(least * scale, most * scale) * self.gain;
            if (was[i] + change - velocity[i]).abs() > 1e-9 {
                bent.add(Bent::Sudden);
                velocity[i] = was[i] + change;
            }
        }
        velocity
    }
}

/// A print that is not nearer to the other foot's than feet are wide: pushed outward otherwise.
pub(super) fn apart(paces: &Paces, other: &Print, print: Print, side: usize, bent: &mut Bends) -> Print {
    let least = BESIDE * paces.style(paces.at(0.0)).step_width;
    let length = paces.body.leg.foot_length();
    let mut print = print;
    // Both ends of each foot against the line of the other one.
    let ends =
        |print: &Print| [print.heel, print.heel + turned(print.heading, &Vector3::new(0.0, 0.0, length))];
    let mut missing = 0.0_f64;
    let [other_ends, own_ends] = [ends(other), ends(&print)];
    for (line, from, points, towards) in
        [(other, other.heel, own_ends, sign(side)), (&print, print.heel, other_ends, -sign(side))]
    {
        for point in points {
            let at = turned(-line.heading, &(point - from));
            let (beside, beyond) = (towards * at.x, (-at.z).max(at.z - length).max(0.0));
            let wanted = (least * least - beyond * beyond).max(0.0).sqrt();
            if wanted > 0.0 && beyond < 0.5 * length {
                missing = missing.max(wanted - beside);
            }
        }
    }
    if missing > 1e-9 {
        print.heel += turned(print.heading, &Vector3::new(sign(side) * missing, 0.0, 0.0));
        if missing > 0.01 {
            bent.add(Bent::Balance);
        }
    }
    print
}

/// An angle within half a turn.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
