//! Curves of one degree of freedom.

use serde_json::json;
use solaris::profiles::{Answers as _, Curve as _, Turn, text};
use wasm_bindgen::prelude::*;

/// What there is to know of a curve in the grammar of profiles, as JSON: `samples + 1` times with position, velocity and acceleration, where it
/// turns round, its greatest velocity; or its faults.
#[wasm_bindgen]
pub fn curve(source: &str, samples: usize) -> String {
    let profile = match text::read(source) {
        Ok(profile) => profile,
        Err(error) => return faulty(&error.to_string()),
    };
    let curve = match profile.curve::<f64>() {
        Ok(curve) => curve,
        Err(error) => return faulty(&error.to_string()),
    };
    let duration = curve.duration();
    let samples = samples.clamp(1, 10_000);
    let times: Vec<f64> = (0..=samples).map(|i| duration * i as f64 / samples as f64).collect();
    let sampled: Vec<_> = times.iter().map(|time| curve.at(*time)).collect();
    let stationary = curve.stationary();
    let turns: Vec<_> = stationary
        .points
        .iter()
        .map(|point| {
            json!({
                "time": point.time,
                "position": curve.at(point.time).position,
                "reverses": point.turn == Turn::Reversal,
            })
        })
        .collect();
    json!({
        "duration": duration,
        "times": times,
        "position": sampled.iter().map(|at| at.position).collect::<Vec<_>>(),
        "velocity": sampled.iter().map(|at| at.velocity).collect::<Vec<_>>(),
        "acceleration": sampled.iter().map(|at| at.acceleration).collect::<Vec<_>>(),
        "turns": turns,
    })
    .to_string()
}

fn faulty(message: &str) -> String {
    json!({ "fault": message }).to_string()
}
