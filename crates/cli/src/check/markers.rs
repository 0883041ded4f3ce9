//! `solaris check` of recordings of markers.

use crate::args::CheckArgs;
use crate::error::{CliError, UsageError};
use crate::findings::{heading, list};
use crate::input::extension;
use crate::print::{print, write_json};
use crate::recording;
use crate::words::{counted, short};
use serde::Serialize;
use solaris::io::markers::{LoadOptions, Plate, Recording, find_axes};
use solaris::model::{Finding, Vector3};
use std::io::{Result, Write};

pub(super) fn run(args: &CheckArgs) -> std::result::Result<(), CliError> {
    if args.dh {
        return Err(UsageError::MarkersHaveNoFigure.into());
    }
    let recording = recording::read(&args.file, None)?;
    let (axes, found) = find_axes(&recording);
    // Along its own axes, but with plates that push up.
    let recording = recording.turned(&axes, &axes);
    let mut findings = recording.findings.clone();
    findings.extend(found);
    let up = axes.up().vector();
    let name = args.file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let facts = Facts {
        format: if extension(&args.file) == "c3d" { "C3D recording" } else { "TRC recording" },
        name,
        frames: recording.markers.len(),
        first_frame: recording.first_frame,
        rate_hz: recording.rate,
        unit: recording.unit.to_string(),
        up: axes.up().to_string(),
        forward: axes.forward().to_string(),
        markers: seen(&recording),
        plates: recording.plates.iter().map(|plate| Pressed::of(plate, &up)).collect(),
        channels: recording
            .analog
            .iter()
            .map(|channel| (channel.label.as_str(), channel.unit.as_str()))
            .collect(),
        events: recording
            .events
            .iter()
            .map(|event| (event.time, event.label.as_str(), event.context.as_str()))
            .collect(),
        findings: findings
            .iter()
            .map(|f| (heading(f.kind).0, f.subject.as_str(), f.message.as_str()))
            .collect(),
    };
    print(|out| if args.json { write_json(out, &facts) } else { facts.write(out, &findings) })?;
    match recording::doubts(&findings) {
        count if args.strict && count > 0 => Err(CliError::Strict { path: args.file.clone(), count }),
        _ => Ok(()),
    }
}

/// What a recording is, in numbers.
#[derive(Serialize)]
struct Facts<'a> {
    name: String,
    format: &'static str,
    frames: usize,
    first_frame: i64,
    rate_hz: Option<f64>,
    unit: String,
    up: String,
    forward: String,
    markers: Vec<Seen<'a>>,
    plates: Vec<Pressed>,
    /// Labels and units.
    channels: Vec<(&'a str, &'a str)>,
    /// Times (s), labels and contexts.
    events: Vec<(f64, &'a str, &'a str)>,
    findings: Vec<(&'static str, &'a str, &'a str)>,
}

/// How often a marker was seen.
#[derive(Serialize)]
struct Seen<'a> {
    name: &'a str,
    /// In how many frames.
    #[serde(rename = "seen_frames")]
    frames: usize,
    gaps: usize,
    longest_gap_frames: usize,
}

/// What a plate bore.
#[derive(Serialize)]
struct Pressed {
    number: usize,
    r#type: u8,
    rate_hz: f64,
    loaded_share: f64,
    /// Over the loaded samples.
    mean_vertical_n: f64,
    middle_m: [f64; 3],
}

/// The gaps of each marker.
fn seen(recording: &Recording) -> Vec<Seen<'_>> {
    let trial = &recording.markers;
    let one = |marker: usize| {
        let (mut gaps, mut longest, mut length) = (0, 0, 0);
        for frame in 0..trial.len() {
            if trial.point(frame, marker).is_some() {
                length = 0;
                continue;
            }
            gaps += usize::from(length == 0);
            length += 1;
            longest = longest.max(length);
        }
        let name = trial.names()[marker].as_str();
        Seen { name, frames: trial.seen(marker), gaps, longest_gap_frames: longest }
    };
    (0..trial.names().len()).map(one).collect()
}

impl Pressed {
    fn of(plate: &Plate, up: &Vector3<f64>) -> Self {
        let (force, loaded_share) = plate.mean_force(&LoadOptions::default());
        Self {
            number: plate.number,
            r#type: plate.kind.number(),
            rate_hz: plate.rate,
            loaded_share,
            mean_vertical_n: force.dot(up),
            middle_m: plate.middle().into(),
        }
    }
}

impl Facts<'_> {
    fn write(&self, out: &mut dyn Write, findings: &[Finding]) -> Result<()> {
        writeln!(out, "{} '{}'\n", self.format, self.name)?;
        let mut row = |what: &str, value: String| writeln!(out, "  {what:<24}{value}");
        row("markers", self.markers.len().to_string())?;
        let last = self.first_frame + self.frames as i64 - 1;
        row("frames", format!("{}, in the file {} to {last}", self.frames, self.first_frame))?;
        if let Some(rate) = self.rate_hz {
            row(
                "rate",
                format!("{} Hz, so {} s", short(rate), short(self.frames.saturating_sub(1) as f64 / rate)),
            )?;
        }
        row("unit of lengths", self.unit.clone())?;
        row(
            "axes",
            format!("{} is up, {} is forward (--axes {},{})", self.up, self.forward, self.up, self.forward),
        )?;
        if !self.channels.is_empty() {
            row("analog channels", self.channels.len().to_string())?;
        }
        self.gaps(out)?;
        self.plates(out)?;
        if !self.events.is_empty() {
            writeln!(out, "\nEvents")?;
        }
        for (time, label, context) in &self.events {
            writeln!(out, "  {time:>8.3} s  {}", format!("{context} {label}").trim())?;
        }
        list(out, findings)
    }

    /// The markers that were hidden at times.
    fn gaps(&self, out: &mut dyn Write) -> Result<()> {
        let hidden = || self.markers.iter().filter(|marker| marker.gaps > 0);
        let width = hidden().map(|marker| marker.name.chars().count()).max().unwrap_or(0).max(6);
        let always = self.markers.len() - hidden().count();
        writeln!(out, "\nMarkers hidden at times ({always} of {} never are)", self.markers.len())?;
        for Seen { name, frames, gaps, longest_gap_frames } in hidden() {
            let gaps = counted(*gaps, "gap", "gaps");
            writeln!(
                out,
                "  {name:<width$}  seen in {frames} of {} frames; {gaps}, the longest {longest_gap_frames}",
                self.frames
            )?;
        }
        Ok(())
    }

    fn plates(&self, out: &mut dyn Write) -> Result<()> {
        if !self.plates.is_empty() {
            writeln!(out, "\nForce plates")?;
        }
        for plate in &self.plates {
            let Pressed { number, r#type, rate_hz, loaded_share, mean_vertical_n, middle_m: [x, y, z] } =
                plate;
            let load = if *loaded_share > 0.0 {
                format!(
                    "loaded {:.0} % of the time, then {mean_vertical_n:.1} N upwards on average",
                    100.0 * loaded_share
                )
            } else {
                "never loaded".to_owned()
            };
            writeln!(
                out,
                "  {number}  type {type}, {} Hz, about ({x:.3}, {y:.3}, {z:.3}) m; {load}",
                short(*rate_hz)
            )?;
        }
        Ok(())
    }
}
