//! Facts of a curve and its answers, for programs.

use super::feasible::Feasible;
use super::request::Request;
use super::summary::name;
use super::table::{NAMES, Times, rows};
use crate::print::write_json;
use serde_json::{Map, Value, json};
use solaris::profiles::{Answers, Curve, Peak, ProfileCurve, Range, Turn, text};
use solaris::view::profile::Labels;
use std::io::Write;
use std::ops::Bound;

/// Prints feasible values alone.
pub(super) fn write_feasible(out: &mut dyn Write, all: &[Feasible], as_json: bool) -> std::io::Result<()> {
    if as_json {
        return write_json(out, &json!({ "feasible": feasible(all) }));
    }
    all.iter().try_for_each(|one| writeln!(out, "{}: {}", one.parameter.symbol, one.short()))
}

fn feasible(all: &[Feasible]) -> Value {
    let bound = |bound: Bound<f64>| match bound {
        Bound::Included(x) => json!({ "value": x, "included": true }),
        Bound::Excluded(x) => json!({ "value": x, "included": false }),
        Bound::Unbounded => Value::Null,
    };
    let range = |range: &Range| json!({ "low": bound(range.low), "high": bound(range.high) });
    let one = |one: &Feasible| {
        let ranges: Vec<Value> = one.ranges.as_slice().iter().map(range).collect();
        json!({ "parameter": one.parameter.name, "symbol": one.parameter.symbol, "ranges": ranges })
    };
    all.iter().map(one).collect()
}

/// A curve, what it answers, and its table. Numbers that are not finite are null.
pub(super) struct Facts(Value);

impl Facts {
    pub(super) fn of(
        request: &Request<'_>,
        curve: &ProfileCurve,
        labels: &Labels,
        all: &[Feasible],
        times: Times,
    ) -> Self {
        let values = request.profile.values();
        let parameters: Map<String, Value> =
            values.iter().map(|(parameter, value)| (parameter.field(), json!(value))).collect();
        let (stationary, peaks) = (curve.stationary(), curve.peaks());
        let points: Vec<Value> = stationary
            .points
            .iter()
            .map(|point| {
                let turn = if point.turn == Turn::Reversal { "reversal" } else { "touch" };
                json!({ "time": point.time, "turn": turn })
            })
            .collect();
        let turns = stationary.points.iter().filter(|point| point.turn == Turn::Reversal).count();
        let peak = |peak: Peak| json!({ "time": peak.time, "value": peak.value });
        Self(json!({
            "kind": name(&request.profile),
            "text": text::line(&request.profile),
            "parameters": parameters,
            "keys": labels.keys,
            "times_count_from": labels.keys.first().map_or(0.0, |key| key.0),
            "unit": labels.unit,
            "duration": curve.duration(),
            "never_turns_round": turns == 0,
            "turns_round": turns,
            "stationary": points,
            "rests": stationary.rests,
            "peaks": {
                "velocity": peak(peaks.velocity),
                "acceleration": peak(peaks.acceleration),
                "jerk": peak(peaks.jerk),
            },
            "feasible": feasible(all),
            "columns": NAMES,
            "samples": rows(curve, times).collect::<Vec<_>>(),
        }))
    }

    pub(super) fn write(&self, out: &mut dyn Write) -> std::io::Result<()> {
        write_json(out, &self.0)
    }
}
