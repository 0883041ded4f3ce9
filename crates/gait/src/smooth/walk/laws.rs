//! The laws over a whole walk: height, load share and centre of pressure.

use super::cane::CaneWay;
use super::course::{Course, Episode, Kind, Print, Step};
use super::gaits::Gaits;
use super::grounded::Grounded;
use super::heights::Heights;
use super::numbers::{
    BEGIN, COUNTS_AHEAD, EDGES, FIRST_COP, FIRST_FREED, FIRST_SHIFTS, LAST_COP_FROM, LAST_COP_ROLL,
    LEAST_SHARE, LOAD_SETTLES, LOAD_SHIFT_FROM, LOOKS_AHEAD, MOST_AHEAD, SETTLE, STAIR_EDGES, WalkNumbers,
};
use crate::body::Body;
use crate::body::cane::Held;
use crate::body::foot::{FootPlane, turned};
use crate::body::rotations::Euler;
use crate::error::GaitError;
use crate::smooth::laws::{self, Swings};
use crate::smooth::prescribed::{CaneNode, normal_of};
use crate::smooth::stride::StridePlan;
use crate::smooth::style::Style;
use nalgebra::Vector3;
use solaris_analysis::FootSupport;
use solaris_model::Relief;
use solaris_profiles::step;

/// Amplitudes of the shifts of load at both ends, from the solve.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Amplitudes {
    /// Fore and aft, at the start and at the end (m).
    pub(crate) sagittal: [f64; 2],
    /// Sideways, in step widths.
    pub(crate) lateral: [f64; 2],
}

/// The laws of a walk.
pub(crate) struct WalkLaws {
    pub(crate) course: Course,
    /// Ground that is not level.
    pub(crate) relief: Option<Relief>,
    /// How near to an edge of it the ground counts as high as the edge for a foot in the air (m).
    edges: f64,
    pub(super) gaits: Gaits,
    pub(super) heights: Heights,
    /// Where a cane goes that a hand holds.
    pub(super) cane: Option<CaneWay>,
    pub(super) numbers: WalkNumbers,
    pub(super) amplitudes: Amplitudes,
    /// The plane of the left foot on its print.
    pub(super) plane: FootPlane,
    leg_length: f64,
    foot_length: f64,
    /// Of the first stride, in seconds of somebody of the reference height: as long as a pendulum's.
    first_stride: f64,
}

impl WalkLaws {
    /// Of `steps` of some strides, from standing as the pace `standing` does.
    pub(super) fn new(
        body: &Body,
        strides: &[StridePlan],
        standing: usize,
        steps: &[Step],
        (numbers, cane_load): (&WalkNumbers, f64),
        ground: Option<&Grounded>,
    ) -> Result<Self, GaitError> {
        let gaits = match ground {
            Some(ground) => Gaits::on_ground(&ground.contacts, &ground.swings, steps)?,
            None => Gaits::new(strides, standing, steps)?,
        };
        let style = &gaits.of_contact(0).style;
        let first_stride = style.stride_time / body.scale().sqrt();
        let begin = numbers.start_time.map_or(BEGIN, |time| style.double_support - time / first_stride);
        let beside = 0.5 * strides[standing].style.step_width;
        let course = Course::new(steps, beside, ground.map_or(0.0, |ground| ground.standing), begin);
        let stairs = (0..=steps.len()).any(|k| gaits.landing(k).style.stairs.is_some());
        Ok(Self {
            edges: if stairs { STAIR_EDGES } else { EDGES.0 },
            heights: Heights::new(&course, numbers, first_stride),
            cane: CaneWay::new(
                &course,
                body,
                [0, steps.len()].map(|k| &gaits.of_contact(k).standing),
                cane_load,
            ),
            course,
            relief: ground.map(|ground| ground.relief.clone()),
            gaits,
            numbers: *numbers,
            amplitudes: Amplitudes::default(),
            plane: FootPlane::new(strides[standing].style.foot_yaw),
            leg_length: body.leg.length(),
            foot_length: body.leg.foot_length(),
            first_stride,
        })
    }

    /// The style of contact `k`.
    pub(crate) fn style(&self, k: usize) -> &Style {
        &self.gaits.of_contact(k).style
    }

    /// How long a stride of the style of contact `k` lasts (s), of somebody of the reference height.
    pub(super) fn stride_of(&self, k: usize) -> f64 {
        self.first_stride * self.gaits.landing(k).style.stride_time / self.style(0).stride_time
    }

    /// 0 while standing, 1 while walking.
    pub(super) fn walking(&self, u: f64) -> f64 {
        let (from, time) = self.numbers.height_in;
        let rise = (from.max(self.course.begin), time);
        fade(u, self.course.finish(u), rise, self.numbers.height_out)
    }

    /// The envelope of something that swings until a fade on the finish clock.
    fn swinging(&self, u: f64, out: (f64, f64)) -> f64 {
        fade(u, self.course.finish(u), self.numbers.swing_in, out)
    }

    /// The envelope of the arms.
    fn arms_swinging(&self, u: f64) -> f64 {
        fade(u, self.course.finish(u), self.numbers.arms_in, self.numbers.arms_out)
    }

    /// The envelope of the height's harmonics.
    pub(super) fn bobbing(&self, u: f64) -> f64 {
        self.swinging(u, self.numbers.harmonics_out)
    }

    fn swings(&self, u: f64) -> Swings {
        let WalkNumbers { pelvis_out, thorax_out, .. } = self.numbers;
        let [pelvis, thorax] = [pelvis_out, thorax_out].map(|out| self.swinging(u, out));
        Swings { pelvis, thorax, arms: self.arms_swinging(u) }
    }

    /// Angles of trunk and both arms, against the way the body faces.
    pub(super) fn angles(&self, u: f64) -> ([Euler; 5], [[f64; 2]; 2]) {
        let swings = self.swings(u);
        let of = |style: &Style| (laws::trunk(style, u, swings), laws::arms(style, u, swings));
        let (pace, other) = self.gaits.at(u);
        let (mut trunk, mut arms) = of(&pace.style);
        if let Some((next, part)) = other {
            let (trunk_after, arms_after) = of(&next.style);
            let angles = trunk.iter_mut().flatten().chain(arms.iter_mut().flatten());
            let after = trunk_after.iter().flatten().chain(arms_after.iter().flatten());
            angles.zip(after).for_each(|(angle, after)| *angle += (after - *angle) * part);
        }
        // Neck and head turn into a turn before the body does.
        let ahead = self.looking_ahead(u);
        trunk[3][1] += 0.5 * ahead;
        trunk[4][1] += ahead;
        (trunk, arms)
    }

    /// The arm that holds the cane at a clock, for the pelvis there and the angles of the trunk; its fist in the world.
    fn held(&self, body: &Body, u: f64, pelvis: &Vector3<f64>, trunk: &[Euler; 5]) -> Option<(usize, Held)> {
        let (cane, way) = (body.cane?, self.cane.as_ref()?);
        let (heading, carriage) = (self.course.heading(u), self.style(0).manner.carriage());
        let tip = turned(-heading, &(way.tip(u) - pelvis));
        let held = cane.hold(body, trunk, &carriage, &tip);
        Some((cane.side, Held { fist: pelvis + turned(heading, &held.fist), ..held }))
    }

    /// Angles of trunk and both arms, of which one may hold a cane, and the cane's, for the pelvis at a clock.
    pub(super) fn upper(
        &self,
        body: &Body,
        u: f64,
        pelvis: &Vector3<f64>,
    ) -> ([Euler; 5], [[f64; 2]; 2], [f64; 2]) {
        let (trunk, mut arms) = self.angles(u);
        let cane = self.held(body, u, pelvis, &trunk).map_or([0.0; 2], |(side, held)| {
            arms[side] = held.arm;
            held.cane
        });
        (trunk, arms, cane)
    }

    /// The cane at a clock, for the pelvis there.
    pub(super) fn cane_at(&self, body: &Body, u: f64, pelvis: &Vector3<f64>) -> Option<CaneNode> {
        let (_, held) = self.held(body, u, pelvis, &self.angles(u).0)?;
        let (share, tip) = self.cane_share(u);
        Some(CaneNode { cane: body.cane?, share, tip, fist: held.fist })
    }

    /// The part of the whole vertical force that a cane bears, and where its tip is.
    pub(super) fn cane_share(&self, u: f64) -> (f64, Vector3<f64>) {
        let cane = self.cane.as_ref().filter(|_| cfg!(feature = "cane"));
        cane.map_or((0.0, Vector3::zeros()), |cane| (cane.share(u), cane.tip(u)))
    }

    /// By how much the head is turned to where the body will face a little later (rad).
    fn looking_ahead(&self, u: f64) -> f64 {
        if self.course.is_straight() {
            return 0.0;
        }
        let strides = LOOKS_AHEAD / self.gaits.number(u, |pace| pace.style.stride_time);
        MOST_AHEAD * ((self.course.heading(u + strides) - self.course.heading(u)) / MOST_AHEAD).tanh()
    }

    /// Height of the centre of mass without corrections (m).
    pub(super) fn height(&self, u: f64) -> f64 {
        let (walking, bobbing) = (self.walking(u), self.bobbing(u));
        self.course.rise(u)
            + self.gaits.number(u, |pace| {
                let standing = pace.standing.com.y;
                standing
                    + (pace.mean_height - standing) * walking
                    + bobbing * laws::height(&pace.style, self.leg_length, u).0
            })
    }

    /// Height of the point that the feet's forces point at, over the height of the centre of mass.
    pub(super) fn pivot(&self, u: f64) -> f64 {
        self.gaits.number(u, |pace| pace.style.pivot)
    }

    /// When the heel of the foot that stands rises while the other makes the first step.
    pub(super) fn standing_heel_off(&self) -> f64 {
        let (at, later) = self.numbers.standing_heel_off;
        at + later * self.style(0).double_support
    }

    /// How long before toe-off the heel of the foot that makes the first step rises.
    pub(super) fn first_heel_off(&self) -> f64 {
        let (clock, time) = self.numbers.first_heel_off;
        clock.min(time / self.first_stride)
    }

    /// Where a foot lifts off a print, on its own clock.
    pub(super) fn toe_off(&self, episode: &Episode) -> f64 {
        self.gaits.stance(episode).style.toe_off()
    }

    /// Which way a foot's plane points: as its print, in the air from one print to the next.
    pub(super) fn foot_heading(&self, side: usize, u: f64) -> f64 {
        let j = self.course.episode_at(side, u);
        let from = self.course.episode(side, j);
        let toe_off = self.toe_off(&from);
        let v = u - from.contact;
        if v <= toe_off || j + 1 == self.course.episode_count(side) {
            return from.print.heading;
        }
        let to = self.course.episode(side, j + 1).print.heading;
        from.print.heading
            + (to - from.print.heading) * step::quintic((v - toe_off) / (1.0 - toe_off)).position
    }

    /// Pitch of the ground that a foot is turned in: that of its print, in the air from one print to the next.
    pub(super) fn foot_tilt(&self, side: usize, u: f64) -> f64 {
        let j = self.course.episode_at(side, u);
        let from = self.course.episode(side, j);
        let toe_off = self.toe_off(&from);
        let v = u - from.contact;
        if v <= toe_off || j + 1 == self.course.episode_count(side) {
            return from.print.tilt;
        }
        let to = self.course.episode(side, j + 1).print.tilt;
        from.print.tilt + (to - from.print.tilt) * step::quintic((v - toe_off) / (1.0 - toe_off)).position
    }

    /// Height of a point of the world over the ground (m), whose edges reach a little farther.
    pub(super) fn above_ground(&self, point: &Vector3<f64>) -> f64 {
        let Some(relief) = &self.relief else { return point.y };
        let (here, near) = (relief.height(point.z), relief.highest_near(point.z, self.edges));
        point.y - if near - here > EDGES.1 { near } else { here }
    }

    /// Load share of the left foot without the shifts.
    fn share(&self, u: f64) -> f64 {
        let last = self.course.steps + 1;
        let k = ((2.0 * u).floor().max(0.0) as usize).min(last);
        if k == 0 {
            let (begin, d) = (self.course.begin, self.style(0).double_support);
            let from = begin + LOAD_SHIFT_FROM * (d - begin);
            return if u < d { 0.5 + 0.5 * step::cubic((u - from) / (d - from)).position } else { 1.0 };
        }
        let v = u - k as f64 / 2.0;
        let risen = if k < last {
            laws::share_rise(self.style(k), v)
        } else {
            0.5 * step::cubic(v / (LOAD_SETTLES * SETTLE)).position
        };
        if k % 2 == 1 { 1.0 - risen } else { risen }
    }

    /// Share and centre of pressure of a foot.
    fn foot(&self, side: usize, u: f64, share: f64) -> FootSupport {
        let course = &self.course;
        let j = course.episode_at(side, u);
        let episode = course.episode(side, j);
        let stance = self.gaits.stance(&episode);
        let v = u - episode.contact;
        let standing = self.gaits.of_contact(episode.index).standing.com.z
            / (self.foot_length * self.plane.forward.z * episode.print.tilt.cos());
        let law = |v: f64| stance.cop.at(v.clamp(0.0, stance.style.toe_off())).position;
        let mix = |s: f64, a: f64, b: f64| a + (b - a) * step::quintic(s).position;
        let (flat, toe_off) = (stance.style.foot_flat, stance.style.toe_off());
        let (from, to) = if side == 0 {
            (course.begin, self.numbers.standing_cop_until)
        } else {
            let faster = self.first_heel_off() / self.numbers.first_heel_off.0;
            (toe_off - FIRST_COP.0 * faster, toe_off - FIRST_COP.1 * faster)
        };
        let fraction = match episode.kind {
            Kind::Step => law(v),
            Kind::First => {
                if v < to {
                    mix((v - from) / (to - from), standing, law(to))
                } else {
                    law(v)
                }
            }
            Kind::Last => {
                let rolled = mix((v - flat) / LAST_COP_ROLL.0, law(v.min(flat)), LAST_COP_ROLL.1);
                mix((v - LAST_COP_FROM) / (course.end - episode.contact - LAST_COP_FROM), rolled, standing)
            }
            Kind::Close => standing,
        };
        let outward = |v: f64| stance.style.footfall.outward(v.clamp(0.0, toe_off), toe_off);
        let outward = match episode.kind {
            Kind::Step => outward(v),
            Kind::First => outward(v) * step::quintic((v - from) / (to - from)).position,
            Kind::Last => outward(v.min(flat)) * (1.0 - step::quintic((v - flat) / LAST_COP_ROLL.0).position),
            Kind::Close => 0.0,
        };
        // A foot in the air counts for its next print shortly before it lands, where its share is zero.
        let next = (j + 1 < course.episode_count(side)).then(|| course.episode(side, j + 1));
        let on = next.filter(|next| u >= next.contact - COUNTS_AHEAD).unwrap_or(episode);
        let beside = self.style(on.index).step_width / 2.0;
        let axes = self.plane.tilted(on.print.tilt);
        let at = Vector3::x() * beside
            + axes.column(2) * (fraction * self.foot_length)
            + axes.column(0) * (outward * self.foot_length);
        let normal = normal_of(on.print.tilt).map(|normal| turned(on.print.heading, &normal));
        FootSupport { share, cop: on.print.world(side, &at), normal }
    }

    /// Share and centre of pressure of both feet without the shifts.
    pub(super) fn unshifted(&self, u: f64) -> [FootSupport; 2] {
        let share = self.share(u);
        [self.foot(0, u, share), self.foot(1, u, 1.0 - share)]
    }

    /// Shapes of the shifts: fore and aft at the start and the end, sideways at the start and the end (m).
    pub(super) fn shifts(&self, u: f64) -> [f64; 4] {
        let (n, begin, f) = (self.course.steps, self.course.begin, self.course.finish(u));
        let (standing, last) = (self.style(0), self.style(n));
        let (d, e) = (standing.double_support, last.double_support);
        let bump = |x: f64| step::bump(x).position;
        let ramp = self.numbers.first_shift_ramp;
        let plateau = |x: f64| step::quintic(x / ramp).position * step::quintic((1.0 - x) / ramp).position;
        let first = |x: f64| if ramp > 0.0 { plateau(x) } else { bump(x) };
        let towards_last = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        [
            -first((u - begin) / (d + FIRST_SHIFTS.0 - begin)),
            bump((f - 0.5 - 0.5 * e) / (0.5 + self.numbers.last_shift * SETTLE - 0.5 * e)),
            -bump((u - begin) / (d - begin - FIRST_SHIFTS.1)) * standing.step_width,
            -towards_last * bump((f - 1.0) / SETTLE) * last.step_width,
        ]
    }

    /// Directions of the shifts: along and across the way at the start and the end.
    pub(super) fn shift_axes(&self) -> [Vector3<f64>; 4] {
        let end = self.course.last().heading;
        // Along the ground.
        let along = |print: &Print| turned(print.heading, &Vector3::new(0.0, print.tilt.tan(), 1.0));
        [along(&self.course.first()), along(&self.course.last()), Vector3::x(), turned(end, &Vector3::x())]
    }

    /// Share and centre of pressure of both feet. The sideways shifts are shifts of load between the feet.
    pub(super) fn support(&self, u: f64) -> [FootSupport; 2] {
        let mut feet = self.unshifted(u);
        let (steps, finish) = (self.course.steps, self.course.finish(u));
        let ([a1, a2], [c1, c2]) = (self.amplitudes.sagittal, self.amplitudes.lateral);
        let shapes = self.shifts(u);
        let axes = self.shift_axes();
        let [start, end, start_across, end_across]: [Vector3<f64>; 4] =
            std::array::from_fn(|i| axes[i] * ([a1, a2, c1, c2][i] * shapes[i]));
        let centre = |feet: &[FootSupport; 2]| feet[0].cop * feet[0].share + feet[1].cop * feet[1].share;
        let solved = centre(&feet) + start_across + end_across + start + end;
        let last = usize::from(steps % 2 == 1);
        for (side, foot) in feet.iter_mut().enumerate() {
            foot.cop += start;
            if side == last || finish > 0.9 {
                foot.cop += end;
            }
        }
        let starting = u < self.style(0).double_support;
        if starting || finish > 1.0 {
            let across = axes[if starting { 2 } else { 3 }];
            let between = (feet[0].cop - feet[1].cop).dot(&across);
            let share = ((solved - feet[1].cop).dot(&across) / between).clamp(0.0, 1.0);
            (feet[0].share, feet[1].share) = (share, 1.0 - share);
        }
        // The solved centre of pressure holds: both feet give way by what their new shares leave.
        let shift = solved - centre(&feet);
        for foot in &mut feet {
            foot.cop += shift;
        }
        if starting && self.numbers.first_shift_ramp > 0.0 {
            // Once its heel rises the foot that is about to lift is pressed where a step's is; the other one takes the shift.
            let heel_off = self.style(0).double_support - self.first_heel_off();
            let part = step::quintic((u - heel_off - FIRST_FREED.0) / FIRST_FREED.1).position;
            feet[1].cop -= (start + shift) * part;
            let share = feet[0].share.max(LEAST_SHARE);
            feet[0].cop = (solved - feet[1].cop * feet[1].share) / share;
        }
        feet
    }
}

/// Rises on one clock and falls on another: begin and duration of each.
fn fade(u: f64, finish: f64, rise: (f64, f64), fall: (f64, f64)) -> f64 {
    step::quintic((u - rise.0) / rise.1).position * (1.0 - step::quintic((finish - fall.0) / fall.1).position)
}
