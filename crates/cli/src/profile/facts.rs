//! What a curve is and what it answers, for programs.

use super::request::Request;
use super::summary::name;
use super::table::{NAMES, Times, rows};
use serde::Serialize;
use serde_json::{Map, Value, json};
use solaris::profiles::{Answers, Curve, Parameter, Peak, ProfileCurve, Range, Ranges, Turn};
use solaris::view::profile::Labels;
use std::io::Write;
use std::ops::Bound;

/// Digits of the bounds that people read.
const DIGITS: usize = 7;

/// The values of a parameter with which the motion never turns round.
pub(super) struct Feasible {
    pub(super) parameter: &'static Parameter,
    pub(super) ranges: Ranges,
}

impl Feasible {
    pub(super) fn label(&self) -> String {
        format!("never turns round, {}", self.parameter.symbol)
    }

    /// The ranges with few digits, rounded inwards: what is read is in them.
    pub(super) fn short(&self) -> String {
        Ranges::new(
            self.ranges
                .as_slice()
                .iter()
                .map(|range| Range::new(range.low.map(|x| -inward(-x)), range.high.map(inward))),
        )
        .to_string()
    }
}

/// The nearest number of few digits that is not greater.
fn inward(x: f64) -> f64 {
    let parse = |text: String| text.parse::<f64>().unwrap_or(x);
    let near = parse(format!("{x:.*e}", DIGITS - 1));
    if near <= x || !x.is_finite() {
        return near;
    }
    let unit = 10f64.powf(x.abs().log10().floor() - (DIGITS as f64 - 1.0));
    parse(format!("{:.*e}", DIGITS - 1, x - unit))
}

/// Prints feasible values alone.
pub(super) fn write_feasible(out: &mut dyn Write, all: &[Feasible], as_json: bool) -> std::io::Result<()> {
    if as_json {
        return write(out, &json!({ "feasible": feasible(all) }));
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

fn write(out: &mut dyn Write, value: &impl Serialize) -> std::io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value).map_err(std::io::Error::from)?;
    writeln!(out)
}

/// A curve, what it answers, and its table. Numbers that are not finite are null.
pub(super) struct Facts(Value);

impl Facts {
    pub(super) fn of(
        request: &Request,
        curve: &ProfileCurve,
        labels: &Labels,
        all: &[Feasible],
        times: Times,
    ) -> Self {
        let values = request.profile.values();
        let parameters: Map<String, Value> = values
            .iter()
            .map(|(parameter, value)| (parameter.name.replace(' ', "_"), json!(value)))
            .collect();
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
            "text": super::written::short(&request.profile),
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
        write(out, &self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_rounded_inwards() {
        let ranges = Ranges::from(Range::new(Bound::Included(0.1), Bound::Excluded(9.330_127_018_922_193)));
        let feasible = |ranges| Feasible { parameter: &Parameter::START_VELOCITY, ranges };
        assert_eq!(feasible(ranges).short(), "at least 0.1 and less than 9.330127");
        let ranges = Ranges::outside(-2.0 / 3.0, 2.0 / 3.0);
        assert_eq!(feasible(ranges).short(), "at most -0.6666667, or at least 0.6666667");
        assert_eq!(feasible(Range::at_least(1.0 / 3.0).into()).short(), "at least 0.3333334");
    }
}
