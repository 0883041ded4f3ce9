//! Walks and runs, by the fields of an object.

#[cfg(not(feature = "usual"))]
use {
    solaris::analysis::{ReactionError, SupportLaw, ground_reactions},
    solaris::gait::{self, FEET, StyledRequest, WalkSequence},
    solaris::model,
};

use crate::failed;
use crate::figure::Figure;
use crate::motion::Motion;
use crate::options::gait_options;
use solaris::gait::GaitOptions;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const OPTIONS: &str = r"
/** What is asked of a walk or a run. Angles are in rad, lengths in m. */
export interface WalkOptions {
  gait?: 'walk' | 'run';
  /** Through the thesis's key postures, of 3 or 5 determinants. */
  determinants?: 3 | 5;
  /** Steps a minute; of this, `stepLength` and `speed` (m/s) any one, or two. */
  stepFrequency?: number;
  stepLength?: number;
  speed?: number;
  /** How far: so many steps (10), or a distance. */
  steps?: number;
  distance?: number;
  /** By how much each step turns to the left. */
  turn?: number;
  /** Whether it goes backward. */
  backward?: boolean;
  /** Points (x left, z forward) to walk along. */
  path?: [number, number][];
  /** More steps, or standing still for so many seconds. */
  then?: {
    steps?: number; distance?: number; stand?: number;
    stepFrequency?: number; stepLength?: number; speed?: number; turn?: number; backward?: boolean;
  }[];
  slope?: number;
  stairs?: { count?: number; rise?: number; tread?: number };
  /** Points of the ground (z ahead, height). */
  ground?: [number, number][];
  /** A place for each foot: z ahead, height and, where known, pitch and heading. */
  footholds?: number[][];
  population?: 'adult' | 'treadmill' | 'child' | 'older';
  /** Such as 'sad:0.6,heavy:0.3'. */
  manner?: string;
  /** What is different of one side, such as 'limp'. */
  left?: string;
  right?: string;
  variability?: number;
  seed?: number;
  /** Numbers of the style by name, in their units: { armSwing: 10 }. */
  style?: Record<string, number>;
  leftFirst?: boolean;
  /** The part of the whole vertical force that the cane of somebody who holds one bears at most (0.15). */
  caneLoad?: number;
  /** Of a run: on the forefoot, by how much its soles give (m), how it begins and ends. */
  forefoot?: boolean;
  give?: number;
  fromStanding?: boolean;
  toStanding?: boolean;
  /** The walk out of which a run comes, and the one into which it goes over. */
  fromWalking?: { steps?: number; speed?: number };
  toWalking?: { steps?: number; speed?: number };
  /** One stride that repeats itself. */
  loop?: 'moving' | 'in_place';
  /** Samples a second (120). */
  rate?: number;
}
";

#[wasm_bindgen]
extern "C" {
    /// What is asked of a walk.
    #[wasm_bindgen(typescript_type = "WalkOptions")]
    pub type WalkOptions;
}

/// Plans a walk or a run of a figure with the segments of a human, and finds the forces of the ground and of every joint. Runs, canes, walks through
/// key postures and loops are in `solaris-motion`, not in `solaris-motion/lean`; so is to walk as much of a manner as holds, where not all does.
#[wasm_bindgen]
pub fn walk(figure: &Figure, options: Option<WalkOptions>) -> Result<Motion, JsError> {
    made(figure, &gait_options(options)?)
}

#[cfg(feature = "usual")]
fn made(figure: &Figure, options: &GaitOptions) -> Result<Motion, JsError> {
    let made = options.make(&figure.figure).map_err(failed)?;
    let report = serde_json::to_string(&made).map_err(failed)?;
    Ok(Motion { figure: figure.clone(), motion: made.motion, report, repeats: options.repeats.is_some() })
}

/// The same without what measures it, and without the code of what else can be planned.
#[cfg(not(feature = "usual"))]
fn made(figure: &Figure, options: &GaitOptions) -> Result<Motion, JsError> {
    let body = &figure.figure;
    let elsewhere = |what| failed(format!("{what} are in solaris-motion, not in solaris-motion/lean"));
    if options.repeats.is_some() {
        return Err(elsewhere("loops"));
    }
    let rate = options.rate.unwrap_or(solaris::gait::DEFAULT_RATE);
    match options.request(body).map_err(failed)?.request {
        StyledRequest::Smooth(request) => {
            let plan = gait::walk(body, &request).map_err(failed)?;
            loaded(figure, plan.motion(body, rate), &plan)
        }
        StyledRequest::Sequence(walks) => {
            let plan = WalkSequence::new(body, &walks).map_err(failed)?;
            loaded(figure, plan.motion(body, rate), &plan)
        }
        StyledRequest::Thesis(_) => Err(elsewhere("walks through key postures (determinants)")),
        StyledRequest::Run(_) => Err(elsewhere("runs")),
    }
}

#[cfg(not(feature = "usual"))]
fn loaded(
    figure: &Figure,
    motion: Result<model::Motion, ReactionError>,
    law: &impl SupportLaw,
) -> Result<Motion, JsError> {
    let mut motion = motion.map_err(failed)?;
    ground_reactions(&figure.figure, &mut motion, FEET, law).map_err(failed)?;
    Ok(Motion { figure: figure.clone(), motion })
}
