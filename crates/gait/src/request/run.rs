//! The request for a run, with its ranges.

use super::pace::{STEP_FREQUENCY, WALK_RATIO};
use super::walk::Extent;
use crate::error::RequestError;

/// Speeds that runs are planned at (m/s); up to about 2.2 m/s it is a jog.
#[doc(alias = "velocity")]
pub const RUN_SPEED: (f64, f64) = (1.0, 6.0);
/// The speed when none is asked (m/s).
pub const DEFAULT_RUN_SPEED: f64 = 3.5;

/// The most steps of a run that changes its speed, or begins or ends otherwise than in full run, walks beside it not counted: it is planned whole.
pub const CHANGING_RUN_STEPS: usize = 60;

/// The fastest run on the forefoot (m/s).
pub const FOREFOOT_SPEED: f64 = 3.5;

/// By how much a sole may give in the middle of a runner's stance (m).
pub const SOLE_GIVE: (f64, f64) = (0.0, 0.015);

/// Speeds that the numbers of running are known at (m/s).
const COLUMNS: [f64; 3] = [2.5, 3.5, 4.5];

/// A number of running at a speed (m/s), linear between those at 2.5, 3.5 and 4.5 m/s and beyond them.
pub(crate) fn at_speed([slow, middle, fast]: [f64; 3], speed: f64) -> f64 {
    if speed < COLUMNS[1] {
        slow + (middle - slow) * (speed - COLUMNS[0])
    } else {
        middle + (fast - middle) * (speed - COLUMNS[1])
    }
}

/// What is asked of a run.
///
/// ```
/// use solaris_gait::{Extent, RunRequest, run};
/// use solaris_model::Trajectory;
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let plan = run(&ann, &RunRequest { speed: 3.0, extent: Extent::Steps(6), ..RunRequest::default() })?;
/// let mut q = vec![0.0; ann.layout().nq()];
/// plan.configuration(0.5 * plan.duration(), &mut q);
/// assert!(q[2] > 2.0); // half way she has come more than two metres forward (root.tz)
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "gait parameters")]
pub struct RunRequest {
    /// Speed (m/s).
    #[doc(alias = "velocity")]
    pub speed: f64,
    /// How far: so many steps, or as many whole steps as it takes to go at least so far.
    pub extent: Extent,
    /// What is run next, at other speeds: up to 60 steps in all, as where it begins or ends otherwise than in full run.
    pub then: Vec<RunPart>,
    /// How it begins.
    pub from: RunEnd,
    /// How it ends.
    pub to: RunEnd,
    /// Whether the left foot touches first, in the walk before it where there is one; else the right one.
    pub left_first: bool,
    /// Whether it lands on the forefoot, up to 3.5 m/s ([`FOREFOOT_SPEED`]), in full run alone and without a load in one hand; else on the heel.
    #[doc(alias = "forefoot strike")]
    pub forefoot: bool,
    /// By how much shoe, heel pad and floor give in the middle of a stance (m, up to 0.015: [`SOLE_GIVE`]), in full run alone and without a load in one hand. The
    /// whole foot sinks by `give · sin³ πs` over the part s of the stance and rises again, so that the standing knee and ankle bend by up to 4° less.
    #[doc(alias = "compliance")]
    pub give: f64,
    /// How finely to plan.
    pub resolution: RunResolution,
}

impl Default for RunRequest {
    fn default() -> Self {
        Self {
            speed: DEFAULT_RUN_SPEED,
            extent: Extent::Steps(10),
            then: Vec::new(),
            from: RunEnd::Running,
            to: RunEnd::Running,
            left_first: false,
            forefoot: false,
            give: 0.0,
            resolution: RunResolution::default(),
        }
    }
}

/// How a run begins or ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum RunEnd {
    /// In full run, with a contact.
    #[default]
    Running,
    /// In standing.
    Standing,
    /// In a walk, which itself begins or ends in standing.
    Walking(RunWalk),
}

/// A walk out of which a run comes, or into which it goes over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunWalk {
    /// How many steps, 3 to 30. The last one before the run leaves the ground as a runner's does; after it they count from where the runner has landed.
    pub steps: usize,
    /// Speed (m/s), no more than the run's beside it; people's usual one where it is left out.
    #[doc(alias = "velocity")]
    pub speed: Option<f64>,
}

impl Default for RunWalk {
    fn default() -> Self {
        Self { steps: 6, speed: None }
    }
}

/// How many steps a walk beside a run may have.
pub(crate) const RUN_WALK_STEPS: (usize, usize) = (3, 30);
/// The slowest walk beside a run (m/s), at a height of 1.75 m; others' goes with its root.
const SLOWEST_RUN_WALK: f64 = 0.95;

impl RunWalk {
    /// Refuses what is out of range, for somebody of this height (m).
    pub(crate) fn check(&self, height: f64) -> Result<(), RequestError> {
        let (fewest, most) = RUN_WALK_STEPS;
        if !(fewest..=most).contains(&self.steps) {
            return Err(RequestError::RunWalkSteps { steps: self.steps, fewest, most });
        }
        // At the quickest steps of all: v = W·H·f²/60.
        let most = WALK_RATIO * height * STEP_FREQUENCY.1.powi(2) / 60.0;
        let least = SLOWEST_RUN_WALK * (height / 1.75).sqrt();
        match self.speed {
            Some(speed) if !(least..=most).contains(&speed) => {
                Err(RequestError::RunWalkSpeed { speed, least, most })
            }
            _ => Ok(()),
        }
    }
}

/// Some more steps of a run. Its speed changes from its first step on, as fast as a run's may; what steps are left then go on at it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunPart {
    /// How many.
    pub steps: usize,
    /// Speed (m/s).
    #[doc(alias = "velocity")]
    pub speed: f64,
}

/// How finely a run is planned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RunResolution {
    /// Nodes a stride; even, 60 to 2000.
    pub nodes: usize,
    /// Passes in which body and forces come to agree.
    pub passes: usize,
}

impl Default for RunResolution {
    /// With 200 nodes and 25 passes the body's own force is within 0.3 N of the law's at the nodes.
    fn default() -> Self {
        Self { nodes: 200, passes: 25 }
    }
}

/// Nodes that a stride of a run may have.
const NODES: (usize, usize) = (60, 2000);
/// Passes that it may have.
const PASSES: (usize, usize) = (1, 1000);

impl RunResolution {
    pub(crate) fn check(self) -> Result<(), RequestError> {
        let (nodes, passes) = (self.nodes, self.passes);
        let (lower, upper) = NODES;
        if !(lower..=upper).contains(&nodes) || !nodes.is_multiple_of(2) {
            return Err(RequestError::RunNodes { nodes, lower, upper });
        }
        let (lower, upper) = PASSES;
        if !(lower..=upper).contains(&passes) {
            return Err(RequestError::RunPasses { passes, lower, upper });
        }
        Ok(())
    }
}
