//! What is prescribed over a whole walk: contacts, height, load share and centre of pressure.

use super::numbers::{BEGIN, CORRECTION_AT, HEIGHT_IN, HEIGHT_OUT, SETTLE, SWING_IN, SWING_OUT};
use super::standing::Standing;
use super::steps;
use crate::body::Body;
use crate::error::GaitError;
use crate::foot::{FootPlane, mirror};
use crate::laws;
use crate::style::Style;
use nalgebra::Vector3;
use solaris_modes::FootSupport;
use solaris_profiles::spline::CubicSpline;
use solaris_profiles::{Clip, step};

/// What a foot does on one print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// It stands from the begin.
    First,
    /// It lands, rolls and pushes off.
    Step,
    /// It lands and stays.
    Last,
    /// It is set down flat beside the other one.
    Close,
}

/// One foot on one print.
#[derive(Clone, Copy, Debug)]
pub(super) struct Episode {
    /// Its contact on the walk's clock.
    pub(super) contact: f64,
    /// The print's heel along z (m).
    pub(super) print: f64,
    pub(super) kind: Kind,
    /// Number of the contact: odd ones are right.
    pub(super) index: usize,
}

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
    pub(crate) style: Style,
    pub(crate) steps: usize,
    /// Rest before and after these clocks.
    pub(super) begin: f64,
    pub(super) end: f64,
    pub(super) standing: Standing,
    pub(super) amplitudes: Amplitudes,
    mean_height: f64,
    leg_length: f64,
    foot_length: f64,
    plane: FootPlane,
    prints: Vec<f64>,
    cop: Clip<CubicSpline>,
}

impl WalkLaws {
    pub(super) fn new(
        body: &Body,
        style: &Style,
        steps: usize,
        mean_height: f64,
        standing: Standing,
    ) -> Result<Self, GaitError> {
        let mut prints = vec![0.0];
        for length in steps::lengths(steps, style.step_length) {
            prints.push(prints[prints.len() - 1] + length);
        }
        prints.push(prints[steps]);
        Ok(Self {
            style: *style,
            steps,
            begin: BEGIN,
            end: 0.5 * (steps as f64 + 1.0) + SETTLE,
            standing,
            amplitudes: Amplitudes::default(),
            mean_height,
            leg_length: body.leg.length(),
            foot_length: body.leg.foot_length(),
            plane: FootPlane::new(style.foot_yaw),
            prints,
            cop: laws::cop(style)?,
        })
    }

    /// The clock that runs alike at the end of every walk.
    pub(super) fn finish(&self, u: f64) -> f64 {
        u - (self.steps as f64 - 1.0) / 2.0
    }

    /// Heel prints along z of both feet standing, of each step, and of the closing foot.
    pub(super) fn prints(&self) -> &[f64] {
        &self.prints
    }

    /// 0 while standing, 1 while walking.
    pub(super) fn walking(&self, u: f64) -> f64 {
        fade(u, self.finish(u), HEIGHT_IN, HEIGHT_OUT)
    }

    /// The envelope of what swings.
    pub(super) fn swinging(&self, u: f64) -> f64 {
        fade(u, self.finish(u), SWING_IN, SWING_OUT)
    }

    /// Angles of trunk and both arms.
    pub(super) fn angles(&self, u: f64) -> ([laws::Euler; 5], [[f64; 2]; 2]) {
        let (style, envelope) = (&self.style, self.swinging(u));
        let arms = [laws::arm(style, u, envelope), laws::arm(style, u + 0.5, envelope)];
        (laws::trunk(style, u, envelope), arms)
    }

    /// Height of the centre of mass without corrections (m).
    pub(super) fn height(&self, u: f64) -> f64 {
        let standing = self.standing.com.y;
        standing
            + (self.mean_height - standing) * self.walking(u)
            + self.swinging(u) * laws::height(&self.style, self.leg_length, u).0
    }

    /// How much the correction of contact `k` lowers the body: a partition of unity.
    pub(super) fn correction(&self, u: f64, k: usize) -> f64 {
        if k == 0 && u < CORRECTION_AT {
            return step::quintic((u - self.begin) / 0.4).position;
        }
        let x = 2.0 * (u - 0.5 * k as f64 - CORRECTION_AT);
        if x < 0.0 { step::quintic(x + 1.0).position } else { 1.0 - step::quintic(x).position }
    }

    /// The corrections that are not zero anywhere in `u ± reach`.
    pub(super) fn corrections_near(&self, u: f64, reach: f64) -> std::ops::RangeInclusive<usize> {
        let number = |u: f64| (2.0 * (u - CORRECTION_AT)).floor().clamp(-1.0, self.steps as f64);
        let (from, to) = (number(u - reach).max(0.0), number(u + reach) + 1.0);
        from as usize..=(to as usize).min(self.steps)
    }

    /// Number of prints of a foot.
    pub(super) fn episode_count(&self, side: usize) -> usize {
        (self.steps + 1 + side) / 2 + 1
    }

    /// A foot's `j`-th print; 0 is where it stands at first.
    pub(super) fn episode(&self, side: usize, j: usize) -> Episode {
        if j == 0 {
            let contact = if side == 0 { 0.0 } else { -0.5 };
            return Episode { contact, print: 0.0, kind: Kind::First, index: 0 };
        }
        let index = 2 * j - side;
        let kind = match index {
            k if k < self.steps => Kind::Step,
            k if k == self.steps => Kind::Last,
            _ => Kind::Close,
        };
        Episode { contact: index as f64 / 2.0, print: self.prints[index], kind, index }
    }

    /// The print that a foot stands on or has left last, at the clock `u`.
    pub(super) fn episode_at(&self, side: usize, u: f64) -> usize {
        let j = if side == 0 { u.floor() } else { (u + 0.5).floor() };
        (j.max(0.0) as usize).min(self.episode_count(side) - 1)
    }

    /// Load share of the left foot without the shifts.
    fn share(&self, u: f64) -> f64 {
        let d = self.style.double_support;
        let last = self.steps + 1;
        let k = ((2.0 * u).floor().max(0.0) as usize).min(last);
        if k == 0 {
            let from = self.begin + 0.45 * (d - self.begin);
            return if u < d { 0.5 + 0.5 * step::cubic((u - from) / (d - from)).position } else { 1.0 };
        }
        let v = u - k as f64 / 2.0;
        let risen = if k < last {
            laws::share_rise(&self.style, v)
        } else {
            0.5 * step::cubic(v / (0.75 * SETTLE)).position
        };
        if k % 2 == 1 { 1.0 - risen } else { risen }
    }

    /// Centre of pressure along a foot, as a fraction of its length, and the print it belongs to.
    fn cop_fraction(&self, side: usize, u: f64) -> (f64, f64) {
        let j = self.episode_at(side, u);
        let episode = self.episode(side, j);
        let v = u - episode.contact;
        let standing = self.standing.com.z / (self.foot_length * self.plane.forward.z);
        let law = |v: f64| self.cop.at(v.clamp(0.0, self.style.toe_off())).position;
        let mix = |s: f64, a: f64, b: f64| a + (b - a) * step::quintic(s).position;
        let (flat, toe_off) = (self.style.foot_flat, self.style.toe_off());
        let fraction = match episode.kind {
            Kind::Step => law(v),
            Kind::First => {
                let (from, to) =
                    if side == 0 { (self.begin, 0.30) } else { (toe_off - 0.26, toe_off - 0.06) };
                if v < to { mix((v - from) / (to - from), standing, law(to)) } else { law(v) }
            }
            Kind::Last => {
                let rolled = mix((v - flat) / 0.30, law(v.min(flat)), 0.60);
                mix((v - 0.45) / (self.end - episode.contact - 0.45), rolled, standing)
            }
            Kind::Close => standing,
        };
        // A foot in the air counts for its next print shortly before it lands, where its share is zero.
        let next = j + 1;
        let print = if next < self.episode_count(side) && u >= self.episode(side, next).contact - 0.15 {
            self.episode(side, next).print
        } else {
            episode.print
        };
        (fraction, print)
    }

    /// Share and centre of pressure of both feet without the shifts.
    pub(super) fn unshifted(&self, u: f64) -> [FootSupport; 2] {
        let share = self.share(u);
        [0, 1].map(|side| {
            let (fraction, print) = self.cop_fraction(side, u);
            let left = Vector3::new(self.style.step_width / 2.0, 0.0, print)
                + self.plane.forward * (fraction * self.foot_length);
            if side == 0 {
                FootSupport { share, cop: left }
            } else {
                FootSupport { share: 1.0 - share, cop: mirror(&left) }
            }
        })
    }

    /// Shapes of the shifts: fore and aft at the start and the end, sideways at the start and the end (m).
    pub(super) fn shifts(&self, u: f64) -> [f64; 4] {
        let (d, w, f) = (self.style.double_support, self.style.step_width, self.finish(u));
        let bump = |x: f64| step::bump(x).position;
        let towards_last = if self.steps.is_multiple_of(2) { 1.0 } else { -1.0 };
        [
            -bump((u - self.begin) / (d + 0.05 - self.begin)),
            bump((f - 0.5 - 0.5 * d) / (0.5 + 0.55 * SETTLE - 0.5 * d)),
            -bump((u - self.begin) / (d - self.begin - 0.02)) * w,
            -towards_last * bump((f - 1.0) / SETTLE) * w,
        ]
    }

    /// Share and centre of pressure of both feet. The sideways shifts are shifts of load between the feet.
    pub(super) fn support(&self, u: f64) -> [FootSupport; 2] {
        let mut feet = self.unshifted(u);
        let ([a1, a2], [c1, c2]) = (self.amplitudes.sagittal, self.amplitudes.lateral);
        let [start, end, start_x, end_x] = self.shifts(u);
        let centre = |feet: &[FootSupport; 2]| feet[0].cop * feet[0].share + feet[1].cop * feet[1].share;
        let solved = centre(&feet) + Vector3::new(c1 * start_x + c2 * end_x, 0.0, a1 * start + a2 * end);
        let last = usize::from(self.steps % 2 == 1);
        for (side, foot) in feet.iter_mut().enumerate() {
            let with_last = side == last || self.finish(u) > 0.9;
            foot.cop.z += a1 * start + if with_last { a2 * end } else { 0.0 };
        }
        if u < self.style.double_support || self.finish(u) > 1.0 {
            let share = ((solved.x - feet[1].cop.x) / (feet[0].cop.x - feet[1].cop.x)).clamp(0.0, 1.0);
            (feet[0].share, feet[1].share) = (share, 1.0 - share);
        }
        // The solved centre of pressure holds: both feet give way by what their new shares leave.
        let shift = solved - centre(&feet);
        for foot in &mut feet {
            foot.cop += shift;
        }
        feet
    }
}

/// Rises on one clock and falls on another: begin and duration of each.
fn fade(u: f64, finish: f64, rise: (f64, f64), fall: (f64, f64)) -> f64 {
    step::quintic((u - rise.0) / rise.1).position * (1.0 - step::quintic((finish - fall.0) / fall.1).position)
}
