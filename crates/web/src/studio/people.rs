//! People's curves over a stride.

use serde_json::json;
use solaris::gait::people::{curves, nearest_pace};
use wasm_bindgen::prelude::*;

/// People's curves at the pace that is nearest to a speed over √(g l), as JSON: the pace's name, and of each curve its name, unit, means and
/// standard deviations from one strike of a foot to its next, evenly.
#[wasm_bindgen(js_name = peopleCurves)]
pub fn people_curves(speed: f64) -> String {
    let pace = nearest_pace(speed);
    let curves = curves(pace);
    let curves: Vec<_> = curves
        .iter()
        .map(|curve| {
            json!({
                "name": curve.name,
                "unit": curve.unit,
                "mean": &curve.mean[..],
                "deviation": &curve.deviation[..],
            })
        })
        .collect();
    json!({ "pace": pace.name, "curves": curves }).to_string()
}
