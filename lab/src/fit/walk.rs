//! A whole walk from standing to standing as it ships, measured as a motion.

use super::stride::{Case, facts};
use solaris_analysis::ground_reactions;
use solaris_gait::{Extent, FEET, RECIPE_BANDS, WalkRequest, check_bands, free_moment, measure};

/// Samples a second.
const RATE: f64 = 200.0;

/// What a walk came to.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// Friction of both feet and of one that bears more than 5 % of the weight; when the first is greatest, in u from the end.
    pub(crate) friction: (f64, f64),
    pub(crate) friction_at: f64,
    /// Greatest free moment of a foot (N m), and when, in u after the closing contact.
    pub(crate) free_moment: f64,
    pub(crate) free_moment_at: f64,
    /// Greatest knee flexion after the first contact, in any stance, and least flexion at all (°).
    pub(crate) first_knee: f64,
    pub(crate) stance_knee: f64,
    pub(crate) least_knee: f64,
    /// Depth of a sole below the ground (mm).
    pub(crate) sink: f64,
    /// Vertical and fore-and-aft force of both feet (% of the weight).
    pub(crate) vertical: (f64, f64),
    pub(crate) along: (f64, f64),
    /// The stride in the middle of ten steps: bands of 22, facts of people, and its knee at contact (°).
    pub(crate) steady: Option<(usize, usize, f64)>,
}

impl Found {
    pub(crate) fn of(case: &Case, steps: usize) -> Result<Self, String> {
        let request = WalkRequest {
            step_frequency: Some(case.step_frequency),
            step_length: Some(case.step_length),
            extent: Extent::Steps(steps),
            ..WalkRequest::default()
        };
        let plan = solaris_gait::walk(&case.figure, &request).map_err(|error| error.to_string())?;
        let figure = &case.figure;
        let mut motion = plan.motion(figure, RATE).map_err(|error| error.to_string())?;
        ground_reactions(figure, &mut motion, FEET, &plan).map_err(|error| error.to_string())?;
        let measures = measure(figure, &motion).map_err(|error| error.to_string())?;
        let twist = free_moment(&motion);
        let closing = 0.5 * (steps as f64 + 1.0);
        let from_closing = |time: f64| plan.clock_at(time) - closing;
        let most_bent = |from: f64, to: f64, side: usize| {
            let clocks = (0..=60).map(|i| from + (to - from) * f64::from(i) / 60.0);
            clocks.map(|u| plan.knees(u)[side].to_degrees()).fold(f64::NEG_INFINITY, f64::max)
        };
        let stances = (1..=steps).map(|k| most_bent(0.5 * k as f64, 0.5 * k as f64 + 0.28, k % 2));
        let weight = figure.mass() * motion.info.gravity.norm();
        let range = |axis: usize| {
            let sums = (0..motion.len()).map(|i| {
                let force = motion.contacts[0].samples[i].force + motion.contacts[1].samples[i].force;
                force[axis] * 100.0 / weight
            });
            sums.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
        };
        Ok(Self {
            friction: (measures.extremes.friction.value, measures.extremes.foot_friction.value),
            friction_at: from_closing(measures.extremes.friction.time),
            free_moment: twist.value,
            free_moment_at: from_closing(twist.time),
            first_knee: most_bent(0.5, 0.78, 1),
            stance_knee: stances.fold(f64::NEG_INFINITY, f64::max),
            least_knee: measures.extremes.least_knee.value.to_degrees(),
            sink: measures.extremes.sink.value * 1e3,
            vertical: range(1),
            along: range(2),
            steady: measures.steady.map(|steady| {
                let bands = check_bands(RECIPE_BANDS, &steady).iter().filter(|check| check.inside).count();
                (bands, facts(case, &steady), steady.knee_contact)
            }),
        })
    }
}
