//! The report on a motion's metrics: for people, as JSON, as a table.

use super::evidence::Evidence;
use crate::given::GivenReport;
use crate::print::write_json;
use crate::words::{row, short, some};
use serde::Serialize;
use solaris::gait::metrics::Metric;
use solaris::io::IoError;
use solaris::io::csv::{number_text, write_row};
use std::io::{Result, Write};

/// Everything, as it is written to JSON.
#[derive(Serialize)]
pub(super) struct Report {
    version: &'static str,
    #[serde(flatten)]
    given: GivenReport,
    soles: Vec<String>,
    soles_from: String,
    level_m: Option<f64>,
    level_from: &'static str,
    belt_m_s: Option<[f64; 3]>,
    belt_from: &'static str,
    stances_from: Option<&'static str>,
    forces_from: &'static str,
    metrics: Vec<Metric>,
}

impl Report {
    pub(super) fn new(given: GivenReport, evidence: &Evidence<'_>, metrics: Vec<Metric>) -> Self {
        let stances = evidence.stances.as_ref();
        Self {
            version: env!("CARGO_PKG_VERSION"),
            given,
            soles: evidence.soles().iter().map(|sole| sole.name.clone()).collect(),
            soles_from: evidence.soles_from.clone(),
            level_m: stances.map(|stances| stances.level),
            level_from: evidence.level_from,
            belt_m_s: stances.map(|stances| stances.belt.into()),
            belt_from: evidence.belt_from,
            stances_from: stances.map(|stances| stances.method),
            forces_from: evidence.forces_from,
            metrics,
        }
    }

    pub(super) fn write_json(&self, out: &mut dyn Write) -> Result<()> {
        write_json(out, self)
    }

    /// A metric a row.
    pub(super) fn write_csv(&self, out: &mut impl Write) -> std::result::Result<(), IoError> {
        write_row(["metric", "value", "unit", "at_s", "why"], out)?;
        let text = |number: Option<f64>| number.map_or_else(String::new, number_text);
        self.metrics.iter().try_for_each(|Metric { key, unit, value, at, .. }| {
            let why = value.err().map_or_else(String::new, |why| why.to_string());
            write_row([*key, &text(value.ok()), *unit, &text(*at), &why], out)
        })
    }

    /// For people.
    pub(super) fn write(&self, out: &mut dyn Write) -> Result<()> {
        self.given.write(out)?;
        self.given.write_doubts(out)?;
        let soles = if self.soles.is_empty() { String::new() } else { format!("{}, ", some(&self.soles)) };
        row(out, "soles", &format!("{soles}{}", self.soles_from))?;
        if let (Some(level), Some(belt), Some(stances)) = (self.level_m, self.belt_m_s, self.stances_from) {
            row(
                out,
                "ground",
                &format!("{} m up, {}", short((level * 1e4).round() / 1e4 + 0.0), self.level_from),
            )?;
            let speed = belt.iter().fold(0.0_f64, |speed, v| speed.hypot(*v));
            let belt = if speed == 0.0 { "still".to_owned() } else { format!("{} m/s", short(speed)) };
            row(out, "belt", &format!("{belt}, {}", self.belt_from))?;
            row(out, "stances", &format!("by {stances}"))?;
        }
        row(out, "forces", self.forces_from)?;
        writeln!(out)?;
        for Metric { name, value, unit, at, .. } in &self.metrics {
            let note = match (value, at) {
                (Err(why), _) => why.to_string(),
                (Ok(_), Some(at)) => format!("at {} s", short(*at)),
                (Ok(_), None) => String::new(),
            };
            let value = value.map_or_else(|_| "–".to_owned(), |value| short(value + 0.0));
            let line = format!("  {name:<34}{value:>10} {unit:<10} {note}");
            writeln!(out, "{}", line.trim_end())?;
        }
        Ok(())
    }
}
