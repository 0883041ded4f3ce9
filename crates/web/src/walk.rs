//! Walks, by the fields of an object.

use crate::failed;
use crate::figure::Figure;
use crate::motion::Motion;
use js_sys::JSON;
use serde::Deserialize;
use solaris::gait::{
    Extent, GaitError, PlanError, Population, RequestError, Stairs, StyleSheet, StyledPlan, StyledRequest,
    Variability, WalkGround, WalkPart, WalkPath, WalkRequest, measure, sheet_of,
};
use wasm_bindgen::prelude::*;

/// Samples a second where nothing else is asked for (1/s).
const RATE: f64 = 120.0;

#[wasm_bindgen(typescript_custom_section)]
const OPTIONS: &str = r"
/** What is asked of a walk. Angles are in rad, lengths in m. */
export interface WalkOptions {
  /** Steps a minute; of this, `stepLength` and `speed` (m/s) any one, or two. */
  stepFrequency?: number;
  stepLength?: number;
  speed?: number;
  /** How far: so many steps (10), or at least a distance. */
  steps?: number;
  distance?: number;
  /** By how much each step turns to the left. */
  turn?: number;
  /** Points (x left, z forward) to walk along. */
  path?: [number, number][];
  /** More steps. */
  then?: { steps: number; stepFrequency?: number; stepLength?: number; speed?: number; turn?: number }[];
  slope?: number;
  stairs?: { count?: number; rise?: number; tread?: number };
  population?: 'adult' | 'treadmill' | 'child' | 'older';
  /** Such as 'sad:0.6,heavy:0.3'. */
  manner?: string;
  variability?: number;
  seed?: number;
  leftFirst?: boolean;
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

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
struct Asked {
    step_frequency: Option<f64>,
    step_length: Option<f64>,
    speed: Option<f64>,
    steps: Option<usize>,
    distance: Option<f64>,
    turn: f64,
    path: Option<Vec<[f64; 2]>>,
    then: Vec<Part>,
    slope: Option<f64>,
    stairs: Option<Flight>,
    population: Option<String>,
    manner: Option<String>,
    variability: Option<f64>,
    seed: u64,
    left_first: Option<bool>,
    rate: Option<f64>,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
struct Part {
    steps: usize,
    step_frequency: Option<f64>,
    step_length: Option<f64>,
    speed: Option<f64>,
    turn: f64,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Flight {
    count: Option<usize>,
    rise: Option<f64>,
    tread: Option<f64>,
}

impl Asked {
    fn request(self) -> Result<WalkRequest, JsError> {
        let open = self.step_frequency.or(self.step_length).or(self.speed).is_none();
        let ground = match (self.slope, &self.stairs) {
            (None, None) => WalkGround::Level,
            (Some(slope), None) => WalkGround::Slope(slope),
            (None, Some(Flight { count, rise, tread })) => {
                let usual = Stairs::default();
                WalkGround::Stairs(Stairs {
                    count: count.unwrap_or(usual.count),
                    rise: rise.unwrap_or(usual.rise),
                    tread: tread.unwrap_or(usual.tread),
                })
            }
            (Some(_), Some(_)) => return Err(failed("give slope or stairs, not both")),
        };
        let usual = ground.usual_step_frequency();
        let extent = match (self.steps, self.distance) {
            (Some(_), Some(_)) => return Err(failed("give steps or distance, not both")),
            (None, Some(distance)) => Extent::Distance(distance),
            (steps, None) => Extent::Steps(steps.unwrap_or(10)),
        };
        let population = match self.population.as_deref() {
            None => Population::default(),
            Some(name) => {
                Population::ALL.into_iter().find(|known| known.name() == name).ok_or_else(|| {
                    let known = "'adult', 'treadmill', 'child' or 'older'";
                    failed(format!("population is '{name}'; it must be {known}"))
                })?
            }
        };
        let refuse = |error: RequestError| failed(error);
        let path = self.path.map(|points| WalkPath::through(&points)).transpose().map_err(refuse)?;
        let inner = self.turn > 0.0 || path.as_ref().is_some_and(|path| path.begins() > 0.0);
        let sheet =
            self.manner.map_or(Ok(StyleSheet::default()), |blend| sheet_of(&blend)).map_err(refuse)?;
        let part = |part: &Part| WalkPart {
            steps: part.steps,
            step_frequency: part.step_frequency,
            step_length: part.step_length,
            speed: part.speed,
            turn: part.turn,
        };
        Ok(WalkRequest {
            step_frequency: self.step_frequency.or(usual.filter(|_| open)),
            step_length: self.step_length,
            speed: self.speed,
            extent,
            turn: self.turn,
            then: self.then.iter().map(part).collect(),
            ground,
            path,
            left_first: self.left_first.unwrap_or(inner),
            population,
            sheet,
            variability: self.variability.map(|scale| Variability { scale, seed: self.seed }),
            ..WalkRequest::default()
        })
    }
}

/// Plans a walk of a figure with the segments of a human, and finds the forces of the ground and of every joint.
#[wasm_bindgen]
pub fn walk(figure: &Figure, options: Option<WalkOptions>) -> Result<Motion, JsError> {
    let asked: Asked = match options {
        None => Asked::default(),
        Some(options) => {
            let text = JSON::stringify(&options).map_err(|_| failed("the options are no plain object"))?;
            serde_json::from_str(&String::from(text))
                .map_err(|error| failed(format!("the options: {error}")))?
        }
    };
    let rate = asked.rate.unwrap_or(RATE);
    let request = asked.request()?;
    let body = &figure.figure;
    let plan = match StyledPlan::of(body, &StyledRequest::Smooth(request.clone())) {
        Err(GaitError::Plan(PlanError::OnlyPart { part, .. })) => {
            StyledPlan::of(body, &StyledRequest::Smooth(request.in_part(part)))
        }
        found => found,
    };
    let plan = plan.map_err(failed)?;
    let (motion, _) = plan.loaded(body, rate).map_err(failed)?;
    let measures = measure(body, &motion).map_err(failed)?;
    let report = serde_json::to_string(&measures).map_err(failed)?;
    Ok(Motion { figure: figure.clone(), motion, report })
}
