//! The options of a walk or a run, all of them optional.

use std::collections::BTreeMap;

/// What is asked of a walk or a run, as plain data. What is left out is what people do, or nothing. Angles are in rad, lengths in m.
///
/// With the feature `serde` it is read and written with these names as keys; a key that means nothing is refused.
///
/// ```
/// use solaris_gait::GaitOptions;
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let options = GaitOptions { step_frequency: Some(100.0), steps: Some(4), manner: Some("sad".into()), ..GaitOptions::default() };
/// let walk = options.make(&ann)?;
/// assert_eq!(walk.measures.steps, 4);
/// // Standing at the end, she is carried.
/// let last = walk.motion.len() - 1;
/// let up: f64 = walk.motion.contacts.iter().map(|foot| foot.samples[last].force.y).sum();
/// assert!((up / (58.0 * 9.80665) - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct GaitOptions {
    /// With or without flight.
    pub gait: GaitKind,
    /// Through the thesis's key postures, of 3 or 5 determinants; else forces first.
    pub determinants: Option<usize>,
    /// Steps a minute; of this, `step_length` and `speed` any one, or two.
    pub step_frequency: Option<f64>,
    /// Length of a step (m).
    pub step_length: Option<f64>,
    /// Speed of the steady part (m/s).
    pub speed: Option<f64>,
    /// So many steps: 10, or of a run as many as it takes to come to its speed, where it is not said how far.
    pub steps: Option<usize>,
    /// So far (m), instead of a number of steps.
    pub distance: Option<f64>,
    /// By how much each step turns to the left (rad).
    pub turn: f64,
    /// Whether it goes backward.
    pub backward: bool,
    /// Points (x left, z ahead, m) to walk along.
    pub path: Option<Vec<[f64; 2]>>,
    /// What comes next.
    pub then: Vec<PartOptions>,
    /// Ground that rises by this angle (rad).
    pub slope: Option<f64>,
    /// Stairs.
    pub stairs: Option<StairOptions>,
    /// Ground through these points (z ahead, height; m).
    pub ground: Option<Vec<[f64; 2]>>,
    /// A place for each foot: z ahead and height (m), then, where they are known, pitch uphill and heading to the left (rad).
    pub footholds: Option<Vec<Vec<f64>>>,
    /// Whose step length: `adult`, `treadmill`, `child` or `older`.
    pub population: Option<String>,
    /// In which manner, such as `sad:0.6,heavy:0.3`.
    pub manner: Option<String>,
    /// What is different of the left side, such as `limp`.
    pub left: Option<String>,
    /// The same of the right side.
    pub right: Option<String>,
    /// How steps differ, over people's.
    pub variability: Option<f64>,
    /// Whose differences.
    pub seed: u64,
    /// Numbers of the style by name ([`crate::PARAMETERS`]), `arm_swing` or `arm-swing`, in their units.
    pub style: BTreeMap<String, f64>,
    /// Whether the left foot makes the first step; else the right one, the inner one of a turn, or the one that a cane helps.
    pub left_first: Option<bool>,
    /// The part of the whole vertical force that the cane of a figure that holds one bears at most.
    pub cane_load: Option<f64>,
    /// Whether a run lands on the forefoot.
    pub forefoot: bool,
    /// By how much a runner's soles give in the middle of a stance (m, 0 to 0.015; 0 by default), in full run alone.
    pub give: Option<f64>,
    /// How a run begins.
    pub from: RunEndOptions,
    /// How a run ends.
    pub to: RunEndOptions,
    /// One stride that repeats itself instead of a walk.
    #[cfg_attr(feature = "serde", serde(rename = "loop"))]
    pub repeats: Option<Repeats>,
    /// Samples a second (1/s), 120 where it is left out. Where a stride repeats itself its step frequency is fitted to whole frames of this
    /// rate; where it is left out, the rate to the stride.
    pub rate: Option<f64>,
}

impl Default for GaitOptions {
    fn default() -> Self {
        Self {
            gait: GaitKind::Walk,
            determinants: None,
            step_frequency: None,
            step_length: None,
            speed: None,
            steps: None,
            distance: None,
            turn: 0.0,
            backward: false,
            path: None,
            then: Vec::new(),
            slope: None,
            stairs: None,
            ground: None,
            footholds: None,
            population: None,
            manner: None,
            left: None,
            right: None,
            variability: None,
            seed: 0,
            style: BTreeMap::new(),
            left_first: None,
            cane_load: None,
            forefoot: false,
            give: None,
            from: RunEndOptions::Running,
            to: RunEndOptions::Running,
            repeats: None,
            rate: None,
        }
    }
}

/// With or without flight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum GaitKind {
    /// A walk.
    #[default]
    Walk,
    /// A run.
    Run,
}

/// Where a stride that repeats itself goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Repeats {
    /// On.
    Moving,
    /// Nowhere: the ground moves.
    InPlace,
}

/// What comes next: some `steps`, or standing still for `stand`, or after that a `distance`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct PartOptions {
    /// How many steps.
    pub steps: Option<usize>,
    /// How far (m).
    pub distance: Option<f64>,
    /// How long to stand (s).
    pub stand: Option<f64>,
    /// Steps a minute.
    pub step_frequency: Option<f64>,
    /// Length of a step (m).
    pub step_length: Option<f64>,
    /// Speed (m/s).
    pub speed: Option<f64>,
    /// By how much each step turns to the left (rad).
    pub turn: f64,
    /// Whether it goes backward, after standing.
    pub backward: bool,
}

/// How a run begins or ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum RunEndOptions {
    /// In full run.
    #[default]
    Running,
    /// In standing.
    Standing,
    /// In a walk.
    Walking(RunWalkOptions),
}

/// A walk beside a run; what is left out is as usual ([`crate::RunWalk::default`]).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct RunWalkOptions {
    /// How many steps.
    pub steps: Option<usize>,
    /// Speed (m/s).
    pub speed: Option<f64>,
}

/// Stairs; what is left out is as usual ([`crate::Stairs::default`]).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct StairOptions {
    /// How many.
    pub count: Option<usize>,
    /// Height of each (m), negative for the way down.
    pub rise: Option<f64>,
    /// Depth of each (m).
    pub tread: Option<f64>,
}
