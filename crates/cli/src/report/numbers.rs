//! All numbers of a report, for other programs.

use crate::print::write_json;
use serde_json::{Value, json};
use solaris::modes::Settings;
use solaris::modes::study::{Row, Study, method_name, setting};
use std::io::Write;

/// Writes the study as JSON.
pub(super) fn write(out: &mut dyn Write, study: &Study, settings: &Settings) -> std::io::Result<()> {
    let choices = study.choices();
    let choice = |choice: &solaris::modes::study::Choice<'_>| json!({ "error": choice.wanted, "setting": choice.row.map(ToString::to_string) });
    let value = json!({
        "wanted": study.wanted,
        "duration_s": settings.duration,
        "rate_per_s": settings.rate,
        "complete": study.is_complete,
        "recommended": study.cheapest(study.wanted).map(ToString::to_string),
        "reference": {
            "name": study.reference.name,
            "beside": study.reference.beside,
            "position": finite(study.reference.uncertainty.position),
            "velocity": finite(study.reference.uncertainty.velocity),
        },
        "sensitivity": {
            "growth": study.sensitivity.growth,
            "comparable_until_s": study.sensitivity.comparable_until,
            "chaotic": study.sensitivity.is_chaotic,
        },
        "savings": study.savings.as_ref().map(|savings| json!({
            "method": savings.method,
            "operations_everything": savings.operations.0,
            "operations_left": savings.operations.1,
            "seconds_everything": savings.seconds.map(|both| both.0),
            "seconds_left": savings.seconds.map(|both| both.1),
            "difference": finite(savings.difference),
        })),
        "choices": choices.iter().map(choice).collect::<Vec<_>>(),
        "rows": study.rows.iter().map(row).collect::<Vec<_>>(),
    });
    write_json(out, &value)
}

fn row(row: &Row) -> Value {
    let counts = &row.counts;
    let mut value = json!({
        "method": method_name(row.method),
        "setting": setting(row.method),
        "evaluations": counts.evaluations,
        "jacobians": counts.jacobians,
        "steps": counts.steps,
        "rejected": counts.rejected,
        "seconds": row.seconds,
    });
    match &row.result {
        Err(trouble) => value["trouble"] = json!(trouble),
        Ok(accuracy) => {
            value["position"] = finite(accuracy.position);
            value["velocity"] = finite(accuracy.velocity);
            value["energy"] = finite(accuracy.energy);
            if let Some(estimate) = accuracy.estimate {
                value["estimate"] = finite(estimate);
            }
            if let Some(drift) = accuracy.momentum {
                value["momentum"] = json!({ "linear": drift.linear, "angular": drift.angular });
            }
        }
    }
    if let Some(agreement) = row.agreement {
        let (frames, position, velocity) = (agreement.frames, agreement.position, agreement.velocity);
        value["one_frame"] = json!({ "frames": frames, "position": position, "velocity": velocity });
    }
    value
}

/// A number, or nothing where it is none.
fn finite(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { Value::Null }
}
