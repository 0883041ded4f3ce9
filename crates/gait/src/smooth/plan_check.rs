//! The check of a plan: soles and legs can do what it asks of them.

use crate::body::FEET;
use crate::error::{GaitError, PlanError};
use crate::measure::{Peak, extremes};
use crate::request::pace::{Pace, tidy};
use crate::smooth::prescribed::{friction, friction_on};
use crate::smooth::route::Route;
use crate::smooth::walk::{Excerpt, LegsCheck, WalkPlan};
use nalgebra::Vector3;
use solaris_analysis::{ReactionError, ground_reactions};
use solaris_model::{Contact, Figure, Motion, Trajectory};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Friction that a plan may need: in total, and of one foot that bears more than 5 % of the weight.
#[doc(alias = "friction coefficient")]
#[doc(alias = "required coefficient of friction")]
#[doc(alias = "rcof")]
pub const FRICTION: (f64, f64) = (0.5, 0.6);
/// The least flexion of a knee where steps have the style of a steady gait (rad): a leg that passes straight presses beside its foot.
const NOT_STRAIGHT: f64 = 0.2 * DEGREE;
/// The most by which a knee may be hyperextended before a walk is refused (rad).
const HYPEREXTENSION: f64 = DEGREE;
/// How far outside of a foot's rounded edges its pressure may lie (m): where a walk changes on the way, and where options of the style
/// are given or the ground is not level, or for a moment around a landing.
const OUTSIDE: (f64, f64) = (1e-3, 5e-3);
/// What a person presses with at most over the weight where the ground is not level: people on steep stairs do (A. Stacoff et al., *Gait & Posture*
/// 21 (2005) 24–38); and how far the force may be from the prescribed one, over the weight.
const PRESSED: f64 = 1.6;
const BESIDE: f64 = 0.05;
/// How far the soles may sink (m).
const SUNK: f64 = 1e-3;
/// How far a joint may be beyond its range (rad): in a manner; above a step frequency (steps/min), where the ankle of the plain walk
/// leaves it by 2.8°; where the ground is not level: there an ankle bends under a bent leg, which lets it by up to 20° farther than the 30°
/// of its range (standing lunges: 38 to 50°, from memory); and with options and in the first step at another pace.
/// The report names what is beyond.
const BEYOND: [f64; 4] = [0.5 * DEGREE, 3.0 * DEGREE, 20.0 * DEGREE, 25.0 * DEGREE];
const FAST: f64 = 118.0;
/// How often a walk that changes on the way is looked at (1/s).
const RATE: f64 = 120.0;
/// How often one that deviates, or has options, is (1/s): what a foot that lands too flat presses beside its heel lasts for 3 ms.
pub(super) const FINE_RATE: f64 = 240.0;
/// The same of somebody of unusual height, and around landings on level ground (1/s).
pub(super) const FINER_RATE: f64 = 480.0;
/// A knee that comes nearer to being straight than this (rad) has accelerations without bound for a few milliseconds, and how often it is
/// looked at, as landings are where the ground is not level (1/s).
const NEARLY_STRAIGHT: f64 = DEGREE;
pub(super) const FINEST_RATE: f64 = 960.0;
/// From before a foot lands to after it (u): there a motion is looked at more finely, [`FINER_RATE`] on level ground, [`FINEST_RATE`] elsewhere. What
/// is asked of the ground for some milliseconds only was asked from 0.012 before a landing to 0.043 after it in 16 of 16 walks on ground that is not level.
const LANDING: [f64; 2] = [-0.03, 0.08];

/// Judges plans of a route.
#[derive(Clone, Copy)]
pub(crate) struct PlanCheck<'a> {
    pub(crate) figure: &'a Figure,
    pub(crate) route: &'a Route,
    /// What to try where the ground is too steep.
    pub(crate) nearest: &'static str,
    /// Whether it is another walk than an adult's of even steps in no manner.
    pub(crate) deviates: bool,
    /// Its step frequencies over adults'.
    pub(crate) tempo: f64,
    /// Whether steps have the style of a steady gait.
    pub(crate) has_steady: bool,
    /// Whether one leg is shorter: it comes nearer to being straight, where its acceleration is without bound.
    pub(crate) legs_differ: bool,
    /// How often its motion is looked at, at least (1/s).
    pub(crate) least_rate: f64,
}

/// Why steps of a pace cannot be walked.
pub(super) fn not_walkable(pace: Pace, what: String) -> PlanError {
    let Pace { step_length, step_frequency } = pace;
    PlanError::NotWalkable { step_length, step_frequency: tidy(step_frequency), what }
}

impl PlanCheck<'_> {
    /// Whether what the plan prescribes holds.
    pub(crate) fn check(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        let legs = plan.legs();
        let (apart, clock) = legs.cane;
        if apart.is_nan() || apart > 1e-4 {
            let what = "a hand would not reach its cane".to_owned();
            return Err(self.refusal(plan, clock, what));
        }
        self.check_forces(plan)?;
        self.check_legs(plan, &legs)
    }

    /// What friction asks for.
    pub(crate) fn friction(whose: &str, friction: f64, limit: f64) -> String {
        format!("{whose} friction would have to be {friction:.2}, and soles hold {limit}")
    }

    /// The prescribed forces press, and need no more friction than soles have.
    fn check_forces(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        let (_, (first, last)) = plan.nodes();
        let [mut total, mut single, mut cane] = [(0.0_f64, first); 3];
        for node in first..=last {
            let feet = plan.forces(node);
            let force = feet[0].force + feet[1].force;
            if force.y.is_nan() || force.y <= 0.0 {
                let what = "the ground would have to pull at the feet".to_owned();
                return Err(self.refusal(plan, plan.clock(node), what));
            }
            let worse = |worst: &mut (f64, usize), friction: f64| {
                if friction.is_nan() || friction > worst.0 {
                    *worst = (friction, node);
                }
            };
            let normals = plan.normals(plan.clock(node));
            let loaded = |foot: &&(Contact, Vector3<f64>)| foot.0.force.y > 0.05 * plan.weight();
            let both: Vec<(Contact, Vector3<f64>)> = feet.into_iter().zip(normals).collect();
            let mean: Vector3<f64> = both.iter().map(|(foot, normal)| normal * foot.force.y).sum();
            worse(
                &mut total,
                if plan.is_level() { friction(&force) } else { friction_on(&force, &mean.normalize()) },
            );
            for (foot, normal) in both.iter().filter(loaded) {
                let friction =
                    if plan.is_level() { friction(&foot.force) } else { friction_on(&foot.force, normal) };
                worse(&mut single, friction);
            }
            let on_cane = plan.cane(plan.clock(node)).unwrap_or_default().force;
            if on_cane.y > 0.0 {
                worse(&mut cane, friction(&on_cane));
            }
        }
        let limits =
            [("the", total, FRICTION.0), ("a foot's", single, FRICTION.1), ("the cane's", cane, FRICTION.0)];
        for (whose, (friction, node), limit) in limits {
            if friction.is_nan() || friction > limit {
                let pace = self.route.pace();
                let error = PlanError::Friction {
                    step_length: pace.step_length,
                    step_frequency: tidy(pace.step_frequency),
                    whose,
                    friction,
                    limit,
                    longest: String::new(),
                }
                .into();
                let what = Self::friction(whose, friction, limit);
                return Err(if self.route.is_even() && self.route.is_level() {
                    error
                } else {
                    self.refusal(plan, plan.clock(node), what)
                });
            }
        }
        Ok(())
    }

    /// The legs reach their feet, the knees bend the right way, the feet stay above the ground.
    fn check_legs(&self, plan: &WalkPlan, legs: &LegsCheck) -> Result<(), GaitError> {
        let fails = |bad: bool, clock: f64, what: String| {
            if bad { Err(self.refusal(plan, clock, what)) } else { Ok(()) }
        };
        let ((knee, bent), (lowest, sunk), (short, reaching)) = (legs.least_knee, legs.lowest, legs.short);
        fails(
            knee.is_nan() || knee < if self.has_steady { NOT_STRAIGHT } else { -HYPEREXTENSION },
            bent,
            format!("a knee would be hyperextended by {:.1}°", -knee.to_degrees()),
        )?;
        fails(
            lowest.is_nan() || lowest < -SUNK,
            sunk,
            format!("a foot would sink {:.1} mm into the ground", -lowest * 1e3),
        )?;
        fails(
            short.is_nan() || short > 1e-4,
            reaching,
            format!("a leg is {:.1} mm too short to reach its foot on the ground", short * 1e3),
        )
    }

    /// Holds the motion against its own inverse dynamics: what steps of one pace in people's style are known to keep, a sudden change or
    /// an option may not.
    pub(crate) fn check_motion(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        // In bends of half a metre the last leg is straight as the other one closes beside it.
        let is_straight = self.route.is_even() && plan.legs().least_knee.0 < NEARLY_STRAIGHT;
        let rate = match (is_straight, self.deviates) {
            (true, _) => FINEST_RATE,
            (false, true) => FINE_RATE,
            (false, false) => RATE,
        };
        let rate = rate.max(self.least_rate);
        let edge = if self.route.is_even() { OUTSIDE.1 } else { OUTSIDE.0 };
        self.check_excerpt(plan, (0.0, plan.duration()), rate, edge)?;
        let finely = if self.route.is_level() { FINER_RATE } else { FINEST_RATE };
        if rate >= finely {
            return Ok(());
        }
        // Of each step, and of the closing foot.
        for step in 1..=plan.steps() + 1 {
            let lands = 0.5 * step as f64;
            let span = LANDING.map(|clock| plan.time(lands + clock));
            self.check_excerpt(plan, span.into(), finely, OUTSIDE.1)?;
        }
        Ok(())
    }

    /// The same from a time to a later one (s), with pressure that far outside of a foot at most (m).
    fn check_excerpt(
        &self,
        plan: &WalkPlan,
        (from, to): (f64, f64),
        rate: f64,
        edge: f64,
    ) -> Result<(), GaitError> {
        let excerpt = Excerpt::new(plan, from, to);
        let mut motion = excerpt.samples(self.figure, rate)?;
        let clock_at = |time: f64| plan.clock_at(from + time);
        let reactions = ground_reactions(self.figure, &mut motion, FEET, &excerpt);
        let reactions = reactions.map_err(|error| match error {
            ReactionError::Pulls { time, .. } => {
                self.refusal(plan, clock_at(time), "the ground would have to pull at the feet".to_owned())
            }
            error => error.into(),
        })?;
        self.check_ranges(plan, &motion, clock_at)?;
        let found = extremes(self.figure, &motion)?;
        let fails = |bad: bool, peak: Peak, what: String| {
            if bad { Err(self.refusal(plan, clock_at(peak.time), what)) } else { Ok(()) }
        };
        if !self.route.is_level() {
            let (pressed, weight) = (found.vertical, 100.0);
            let heavy = format!("a person would press with {:.2} times the weight", pressed.value / weight);
            fails(pressed.value.is_nan() || pressed.value > PRESSED * weight, pressed, heavy)?;
        }
        if !self.route.is_level() || self.legs_differ {
            let beside = reactions.from_prescribed.map_or(f64::NAN, |peak| peak.value / plan.weight());
            let peak = Peak { value: beside, time: reactions.from_prescribed.map_or(0.0, |peak| peak.time) };
            let what = format!(
                "the body would not move as its forces have it, by {:.0} % of the weight",
                100.0 * beside
            );
            fails(beside.is_nan() || beside > BESIDE, peak, what)?;
        }
        let outside = found.cop_outside;
        let beside = format!("the ground would have to press {:.0} mm beside a foot", outside.value * 1e3);
        fails(outside.value.is_nan() || outside.value > edge, outside, beside)?;
        // Where the ground leans, that of both feet together was judged by the forces that are prescribed.
        let frictions = if self.route.is_level() {
            [Some(("the", found.friction, FRICTION.0)), Some(("a foot's", found.foot_friction, FRICTION.1))]
        } else {
            [None, Some(("a foot's", Self::friction_on_ground(plan, &motion, clock_at), FRICTION.1))]
        };
        for (whose, peak, limit) in frictions.into_iter().flatten() {
            let what = Self::friction(whose, peak.value, limit);
            fails(peak.value.is_nan() || peak.value > limit, peak, what)?;
        }
        let (knee, sink) = (found.least_knee, found.sink);
        let bent = format!("a knee would be hyperextended by {:.1}°", -knee.value.to_degrees());
        fails(knee.value.is_nan() || knee.value < -HYPEREXTENSION, knee, bent)?;
        let sunk = format!("a foot would sink {:.1} mm into the ground", sink.value * 1e3);
        fails(sink.value.is_nan() || sink.value > SUNK, sink, sunk)
    }

    /// The greatest friction of a foot that bears more than 5 % of the weight, by its own normal.
    fn friction_on_ground(plan: &WalkPlan, motion: &Motion, clock_at: impl Fn(f64) -> f64) -> Peak {
        let mut greatest = Peak { value: 0.0, time: 0.0 };
        for (side, foot) in FEET.iter().enumerate() {
            let track = motion.contacts.iter().find(|track| track.link == *foot);
            for (contact, &time) in track.iter().flat_map(|track| &track.samples).zip(motion.time()) {
                if contact.force.y <= 0.05 * plan.weight() {
                    continue;
                }
                let value = friction_on(&contact.force, &plan.normals(clock_at(time))[side]);
                if value.is_nan() || value > greatest.value {
                    greatest = Peak { value, time };
                }
            }
        }
        greatest
    }

    /// No joint is farther beyond its range than it may be.
    fn check_ranges(
        &self,
        plan: &WalkPlan,
        motion: &Motion,
        clock_at: impl Fn(f64) -> f64,
    ) -> Result<(), GaitError> {
        let fast = plan.style().step_frequency > FAST * self.tempo;
        let limit = match (self.route.is_level(), self.deviates) {
            (false, _) => BEYOND[2],
            (true, true) => BEYOND[usize::from(fast)],
            (true, false) => BEYOND[3],
        };
        let all = motion.time().iter().enumerate().flat_map(|(frame, &time)| {
            self.figure.limit_excess(motion.q(frame)).into_iter().map(move |beyond| (time, beyond))
        });
        let Some((time, beyond)) = all
            .max_by(|(_, a), (_, b)| a.by.abs().total_cmp(&b.by.abs()))
            .filter(|(_, beyond)| beyond.by.abs() > limit)
        else {
            return Ok(());
        };
        let (name, by) = (&self.figure.layout().v_names()[beyond.dof], beyond.by.to_degrees());
        let what = format!("{name} would be {by:.1}° beyond its range");
        Err(self.refusal(plan, clock_at(time), what))
    }

    /// Why the plan does not hold: of a walk that changes on the way, where.
    fn refusal(&self, plan: &WalkPlan, clock: f64, what: String) -> GaitError {
        if !self.route.is_level() {
            let step = ((2.0 * clock).floor().max(0.0) as usize + 1).min(plan.steps());
            let nearest = self.nearest.to_owned();
            return PlanError::TooSteep { step, time: plan.time(clock), what, nearest }.into();
        }
        if self.route.is_even() {
            return not_walkable(self.route.pace(), what).into();
        }
        let step = ((2.0 * clock).floor().max(0.0) as usize + 1).min(plan.steps());
        PlanError::AbruptChange { part: self.route.part_of(step), step, time: plan.time(clock), what }.into()
    }
}
