//! The check of a plan: soles and legs can do what it asks of them.

use crate::body::FEET;
use crate::error::{GaitError, PlanError};
use crate::measure::measure;
use crate::request::pace::tidy;
use crate::smooth::prescribed::friction;
use crate::smooth::route::Route;
use crate::smooth::walk::WalkPlan;
use solaris_analysis::ground_reactions;
use solaris_model::{Figure, Motion};

/// Friction that a plan may need: in total, and of one foot that bears more than 5 % of the weight.
#[doc(alias = "friction coefficient")]
#[doc(alias = "required coefficient of friction")]
#[doc(alias = "rcof")]
pub const FRICTION: (f64, f64) = (0.5, 0.6);
/// The most by which a knee may be hyperextended before a walk is refused (rad).
const HYPEREXTENSION: f64 = 1.0 * std::f64::consts::PI / 180.0;
/// How far outside of a foot's rounded edges its pressure may lie (m).
const OUTSIDE: f64 = 1e-3;
/// How far a joint may be beyond its range (rad), and above which step frequency (steps/min) how far.
const BEYOND: (f64, f64) = (0.5 * std::f64::consts::PI / 180.0, 3.0 * std::f64::consts::PI / 180.0);
const FAST: f64 = 118.0;
/// How often a walk that changes on the way is looked at (1/s).
const RATE: f64 = 120.0;
/// How often one that deviates is (1/s): what a foot that lands too flat presses beside its heel lasts for 3 ms.
const FINE_RATE: f64 = 240.0;

/// Judges plans of a route.
pub(crate) struct PlanCheck<'a> {
    pub(crate) figure: &'a Figure,
    pub(crate) route: &'a Route,
    /// Whether it is another walk than an adult's of even steps in no manner.
    pub(crate) deviates: bool,
    /// Its step frequencies over adults'.
    pub(crate) tempo: f64,
}

impl PlanCheck<'_> {
    /// Whether the plan holds. One whose parts differ is held against its own inverse dynamics too: what steps of one pace are
    /// known to keep, a sudden change may not.
    pub(crate) fn check(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        self.check_forces(plan)?;
        self.check_legs(plan)?;
        if self.route.is_even() && !self.deviates { Ok(()) } else { self.check_motion(plan) }
    }

    /// The prescribed forces press, and need no more friction than soles have.
    fn check_forces(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        let (_, (first, last)) = plan.nodes();
        let (mut total, mut single) = ((0.0_f64, first), (0.0_f64, first));
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
            worse(&mut total, friction(&force));
            for foot in feet.iter().filter(|foot| foot.force.y > 0.05 * plan.weight()) {
                worse(&mut single, friction(&foot.force));
            }
        }
        for (whose, (friction, node), limit) in [("the", total, FRICTION.0), ("a foot's", single, FRICTION.1)]
        {
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
                let what = format!("{whose} friction would have to be {friction:.2}, and soles hold {limit}");
                return Err(if self.route.is_even() {
                    error
                } else {
                    self.refusal(plan, plan.clock(node), what)
                });
            }
        }
        Ok(())
    }

    /// The legs reach their feet, the knees bend the right way, the feet stay above the ground.
    fn check_legs(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        let legs = plan.legs();
        let fails = |bad: bool, clock: f64, what: String| {
            if bad { Err(self.refusal(plan, clock, what)) } else { Ok(()) }
        };
        let ((knee, bent), (lowest, sunk), (short, reaching)) = (legs.least_knee, legs.lowest, legs.short);
        fails(
            knee.is_nan() || knee < -HYPEREXTENSION,
            bent,
            format!("a knee would be hyperextended by {:.1}°", -knee.to_degrees()),
        )?;
        fails(
            lowest.is_nan() || lowest < -1e-3,
            sunk,
            format!("a foot would sink {:.1} mm into the ground", -lowest * 1e3),
        )?;
        fails(
            short.is_nan() || short > 1e-4,
            reaching,
            format!("a leg is {:.1} mm too short to reach its foot on the ground", short * 1e3),
        )
    }

    /// The forces that the motion itself needs press inside of the feet, and where it deviates no joint leaves its range.
    fn check_motion(&self, plan: &WalkPlan) -> Result<(), GaitError> {
        let rate = if self.deviates { FINE_RATE } else { RATE };
        let mut motion = plan.motion(self.figure, rate)?;
        ground_reactions(self.figure, &mut motion, FEET, plan)?;
        if self.deviates {
            self.check_ranges(plan, &motion)?;
        }
        let outside = measure(self.figure, &motion)?.extremes.cop_outside;
        if outside.value <= OUTSIDE {
            return Ok(());
        }
        let what = format!("the ground would have to press {:.0} mm beside a foot", outside.value * 1e3);
        Err(self.refusal(plan, plan.clock_at(outside.time), what))
    }

    /// No joint is farther beyond its range than those of the plain walk are.
    fn check_ranges(&self, plan: &WalkPlan, motion: &Motion) -> Result<(), GaitError> {
        let fast = plan.style().step_frequency > FAST * self.tempo;
        let limit = if fast { BEYOND.1 } else { BEYOND.0 };
        for (frame, time) in motion.time().iter().enumerate() {
            let excess = self.figure.limit_excess(motion.q(frame));
            if let Some(beyond) = excess.into_iter().find(|beyond| beyond.by.abs() > limit) {
                let (name, by) = (&self.figure.layout().v_names()[beyond.dof], beyond.by.to_degrees());
                let what = format!("{name} would be {by:.1}° beyond its range");
                return Err(self.refusal(plan, plan.clock_at(*time), what));
            }
        }
        Ok(())
    }

    /// Why the plan does not hold: of a walk that changes on the way, where.
    fn refusal(&self, plan: &WalkPlan, clock: f64, what: String) -> GaitError {
        if self.route.is_even() {
            let pace = self.route.pace();
            let (step_length, step_frequency) = (pace.step_length, tidy(pace.step_frequency));
            return PlanError::NotWalkable { step_length, step_frequency, what }.into();
        }
        let step = ((2.0 * clock).floor().max(0.0) as usize + 1).min(plan.steps());
        PlanError::AbruptChange { part: self.route.part_of(step), step, time: plan.time(clock), what }.into()
    }
}
