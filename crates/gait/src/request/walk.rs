//! The request for a smooth walk, with its ranges.

use super::ground::WalkGround;
use super::pace::tidy;
use super::path::WalkPath;
use super::population::Population;
use super::resolution::Resolution;
use super::sheet::StyleSheet;
use super::variability::Variability;
use crate::body::helped_side;
use crate::error::RequestError;
use solaris_model::{Figure, RootOrder};

/// Numbers of steps.
pub const STEPS: (usize, usize) = (1, 10_000);
/// Shortest distance (m).
pub const SHORTEST_DISTANCE: f64 = 0.1;
/// The most by which a step may turn (rad).
pub const TURN: f64 = 30.0 * std::f64::consts::PI / 180.0;
/// The most by which a walk may turn in all (rad) where the figure's root turns in the order Z-Y-X: where the pelvis faces across,
/// these angles are singular, and the pelvis turns by up to 12° of its own. With [`solaris_model::RootOrder::Yzx`] there is no bound.
pub const TURN_IN_ALL: f64 = 75.0 * std::f64::consts::PI / 180.0;
/// Steps of a walk that changes on the way: it is planned whole.
pub const CHANGING_STEPS: usize = 1000;

/// The part of the whole vertical force that a cane bears at most if it is not said.
pub const CANE_LOAD: f64 = 0.15;
/// What it may be: people bear 0.1 to 0.2 of their weight on a cane, and a quarter if they have to.
pub const CANE_LOADS: (f64, f64) = (0.0, 0.25);

/// Refuses a turn (rad) before which the angles of the body's root are singular.
pub(crate) fn check_turned(root: RootOrder, turned: f64) -> Result<(), RequestError> {
    let limit = TURN_IN_ALL;
    if root == RootOrder::Zyx && turned.abs() > limit + 1e-12 {
        let (turned, limit) = (turned.to_degrees(), tidy(limit.to_degrees()));
        return Err(RequestError::TurnInAll { turned, limit });
    }
    Ok(())
}

/// How far to walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// So many steps; the other foot then closes beside.
    Steps(usize),
    /// So far (m), in as few steps as people's step length allows: met exactly, but where feet have to find places on the ground.
    Distance(f64),
}

/// What is asked. Of step frequency, step length and speed any two decide the third; what is left open follows the law of a
/// population.
///
/// A fast walk begins and ends at 110 steps/min; a step gains 20 steps/min over the one before at most, above 110 only 5, and
/// loses 10 towards the end. A step that is slower for it is shorter by as much.
///
/// ```
/// use solaris_gait::{Extent, WalkPart, WalkRequest, walk};
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let request = WalkRequest { step_frequency: Some(100.0), extent: Extent::Distance(5.0), ..WalkRequest::default() };
/// let plan = walk(&ann, &request)?;
/// assert!((plan.prints().last().unwrap() - 5.0).abs() < 1e-12);
///
/// // Four steps, two slower ones round a corner, and on as before.
/// let corner = WalkPart { steps: 2, step_frequency: Some(90.0), turn: 0.5, ..WalkPart::default() };
/// let on = WalkPart { steps: 4, step_frequency: Some(100.0), ..WalkPart::default() };
/// let request = WalkRequest { extent: Extent::Steps(4), then: vec![corner, on], ..request };
/// let (_, heading) = walk(&ann, &request)?.destination();
/// assert!((heading - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "gait parameters")]
pub struct WalkRequest {
    /// Steps a minute.
    #[doc(alias = "cadence")]
    pub step_frequency: Option<f64>,
    /// Length of a step (m): the distance of the heel prints of one foot and then the other, which the thesis calls a
    /// stride. People's is 0.0037·height·frequency; on a slope `step_length_on_slope` times that, along the level, as speed and distance are.
    pub step_length: Option<f64>,
    /// Speed of the steady part (m/s).
    #[doc(alias = "velocity")]
    pub speed: Option<f64>,
    /// How far.
    pub extent: Extent,
    /// By how much each step turns to the left (rad).
    pub turn: f64,
    /// What is walked next, without standing in between.
    pub then: Vec<WalkPart>,
    /// What is walked on. Where it is not level a walk has one part, straight on.
    pub ground: WalkGround,
    /// A way to walk along instead: it says how far, and nothing else may turn or follow. Up to 110 steps/min.
    pub path: Option<WalkPath>,
    /// Whether it goes backward: straight on or in a bend of one pace, on level ground, a slope or stairs, which rise along the way that it
    /// goes. Where no length is given its steps are shorter than forward.
    pub backward: bool,
    /// Whether the left foot makes the first step; else the right one.
    pub left_first: bool,
    /// Parameters of the style by name (see [`crate::PARAMETERS`]), in their units.
    pub parameters: Vec<(&'static str, f64)>,
    /// Whose step length it has.
    pub population: Population,
    /// In which manner: what is changed of the style before its `parameters` are set.
    pub sheet: StyleSheet,
    /// What is different of the left and of the right side: the step length and the step frequency of the step that is taken while that
    /// foot stands, the arm swing of its arm, and the rest from the foot's landing to the other's. The mean pace stays as it is asked.
    pub sides: [StyleSheet; 2],
    /// The part of the whole vertical force that a cane bears at most, of a figure that holds one; [`CANE_LOAD`] if it is not said. It helps the foot of
    /// the other side, which best goes first ([`Self::helped_foot_first`]): before its first step it has no help.
    pub cane_load: Option<f64>,
    /// How steps differ; `None`: not at all.
    pub variability: Option<Variability>,
    /// How finely to plan.
    pub resolution: Resolution,
}

impl WalkRequest {
    /// The same with that foot first that the cane of a figure helps, if it holds one.
    #[must_use]
    pub fn helped_foot_first(self, figure: &Figure) -> Self {
        let left_first = helped_side(figure).map_or(self.left_first, |side| side == 0);
        Self { left_first, ..self }
    }

    /// Whether it is walked in a manner, unevenly, or otherwise left than right.
    pub(crate) fn deviates(&self) -> bool {
        !self.sheet.is_empty() || self.is_uneven()
    }

    /// Whether its steps differ.
    pub(crate) fn is_uneven(&self) -> bool {
        self.variability.is_some() || self.sides.iter().any(|sheet| !sheet.is_empty())
    }

    /// The same with a part of its manner and of its variability.
    #[must_use]
    pub fn in_part(&self, part: f64) -> Self {
        let variability = self.variability.map(|all| Variability { scale: part * all.scale, ..all });
        let sides = [0, 1].map(|side| self.sides[side].scaled(part));
        Self { sheet: self.sheet.scaled(part), sides, variability, ..self.clone() }
    }
}

impl Default for WalkRequest {
    fn default() -> Self {
        Self {
            step_frequency: None,
            step_length: None,
            speed: None,
            extent: Extent::Steps(10),
            turn: 0.0,
            then: Vec::new(),
            ground: WalkGround::Level,
            path: None,
            backward: false,
            left_first: false,
            parameters: Vec::new(),
            population: Population::default(),
            sheet: StyleSheet::default(),
            sides: Default::default(),
            cane_load: None,
            variability: None,
            resolution: Resolution::default(),
        }
    }
}

/// Some more steps of a walk. Of step frequency, step length and speed any two decide the third; where none is given, the pace is
/// that of the steps before. A pace changes within its first step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WalkPart {
    /// How many.
    pub steps: usize,
    /// Steps a minute.
    #[doc(alias = "cadence")]
    pub step_frequency: Option<f64>,
    /// Length of a step (m); a short one is a half step.
    pub step_length: Option<f64>,
    /// Speed (m/s).
    pub speed: Option<f64>,
    /// By how much each step turns to the left (rad).
    pub turn: f64,
    /// Whether it goes backward, which is begun in standing.
    pub backward: bool,
}
