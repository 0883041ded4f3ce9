//! What became of a figure on the way to a person's size.

use super::factors_of;
use crate::input::Body;
use crate::words::{counted, row, short, some};
use serde::Serialize;
use solaris::analysis::markers::{MarkerMotion, PairRatio, SubjectFit};
use solaris::io::opensim::ScaleSetup;
use solaris::model::Vector3;
use std::io::{Result, Write};

/// How many of the markers that moved most are shown.
const SHOWN: usize = 5;

/// What became of a figure on the way to a person's size.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct SubjectReport {
    mass_before_kg: f64,
    mass_kg: f64,
    /// Whether masses grew as volumes do, before the total was set; otherwise each segment keeps its share.
    by_volume: bool,
    pub(super) measured: Vec<Measured>,
    factors: Vec<BodyFactors>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) fitted: Option<Fitted>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) placed: Option<Placed>,
    pub(super) notes: Vec<String>,
}

/// A factor by pairs of markers.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Measured {
    pub(super) name: String,
    pub(super) factor: f64,
    pub(super) pairs: Vec<Pair>,
}

/// A pair of markers.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Pair {
    markers: [String; 2],
    seen_m: f64,
    model_m: f64,
}

impl Pair {
    pub(super) fn of(ratio: &PairRatio) -> Self {
        Self { markers: ratio.names.clone(), seen_m: ratio.seen, model_m: ratio.model }
    }
}

/// The factors of a body's axes.
#[derive(Clone, Debug, Serialize)]
pub(super) struct BodyFactors {
    pub(super) body: String,
    pub(super) factors: [f64; 3],
}

/// Lengths and markers that were fitted.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Fitted {
    trials: usize,
    frames: usize,
    rms_before_mm: f64,
    rms_mm: f64,
    lengths: Vec<Fit>,
    /// How far each marker moved on its link (mm), the farthest first.
    moved: Vec<Moved>,
}

/// A segment's length.
#[derive(Clone, Debug, Serialize)]
struct Fit {
    segment: String,
    before_m: f64,
    length_m: f64,
    standard_error_m: f64,
}

impl Fitted {
    pub(super) fn new(found: &SubjectFit, trials: usize) -> Self {
        let lengths = found.lengths.iter().map(|segment| Fit {
            segment: segment.link.clone(),
            before_m: segment.before,
            length_m: segment.length,
            standard_error_m: segment.error,
        });
        Self {
            trials,
            frames: found.frames,
            rms_before_mm: found.rms_before * 1e3,
            rms_mm: found.rms * 1e3,
            lengths: lengths.collect(),
            moved: farthest(found.moved.clone()),
        }
    }

    fn write(&self, out: &mut dyn Write) -> Result<()> {
        let frames = counted(self.frames, "frame", "frames");
        let trials = counted(self.trials, "trial", "trials");
        let words = format!(
            "{frames} of {trials}: {} mm rms, before {}",
            short(self.rms_mm),
            short(self.rms_before_mm)
        );
        row(out, "fitted", &words)?;
        for (i, length) in self.lengths.iter().enumerate() {
            let words = format!(
                "{}: {} ± {} mm, in the model {}",
                length.segment,
                short(length.length_m * 1e3),
                short(length.standard_error_m * 1e3),
                short(length.before_m * 1e3)
            );
            row(out, if i == 0 { "lengths" } else { "" }, &words)?;
        }
        row(out, "markers", &format!("farthest moved: {}", most(&self.moved)))
    }
}

/// The farthest moved first.
fn farthest(moved: Vec<(String, f64)>) -> Vec<Moved> {
    let mut moved: Vec<Moved> =
        moved.into_iter().map(|(marker, by)| Moved { marker, by_mm: by * 1e3 }).collect();
    moved.sort_by(|a, b| b.by_mm.total_cmp(&a.by_mm));
    moved
}

/// Those that moved most, in words.
fn most(moved: &[Moved]) -> String {
    let words: Vec<String> =
        moved.iter().take(SHOWN).map(|moved| format!("{} {} mm", moved.marker, short(moved.by_mm))).collect();
    words.join(", ")
}

/// What placing the markers did.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Placed {
    frames: usize,
    /// How well the static pose fits before (mm).
    rms_mm: f64,
    worst: Option<String>,
    worst_mm: Option<f64>,
    /// How far each marker moved (mm), the farthest first.
    moved: Vec<Moved>,
    /// Markers that the trial does not have, which the figure loses.
    lost: Vec<String>,
}

#[derive(Clone, Debug, Serialize)]
struct Moved {
    marker: String,
    by_mm: f64,
}

impl Placed {
    pub(super) fn new(
        found: &MarkerMotion,
        frames: usize,
        moved: Vec<(String, f64)>,
        lost: Vec<String>,
    ) -> Self {
        let worst = found.frames.first().and_then(|frame| frame.worst);
        Self {
            frames,
            rms_mm: found.rms() * 1e3,
            worst: worst.map(|(marker, _)| found.markers[marker].name.clone()),
            worst_mm: worst.map(|(_, distance)| distance * 1e3),
            moved: farthest(moved),
            lost,
        }
    }
}

impl SubjectReport {
    pub(super) fn new(body: &Body, setup: Option<&ScaleSetup>) -> Self {
        let notes = setup.iter().flat_map(|setup| setup.findings.iter().map(ToString::to_string)).collect();
        let by_volume = setup.is_some_and(|setup| !setup.keeps_mass_distribution);
        Self { mass_before_kg: body.figure.mass(), by_volume, notes, ..Self::default() }
    }

    /// The factors of bodies' axes.
    pub(crate) fn factors(&self) -> impl Iterator<Item = (&str, Vector3<f64>)> {
        self.factors.iter().map(|scaled| (scaled.body.as_str(), scaled.factors.into()))
    }

    /// Markers that the figure has lost.
    pub(crate) fn lost_markers(&self) -> impl Iterator<Item = &str> {
        self.placed.iter().flat_map(|placed| placed.lost.iter().map(String::as_str))
    }

    /// Whether masses grew as volumes do.
    pub(crate) fn grows_by_volume(&self) -> bool {
        self.by_volume
    }

    pub(super) fn finish(&mut self, body: &Body, factors: &[(String, Vector3<f64>)]) {
        self.mass_kg = body.figure.mass();
        self.factors = factors.iter().map(factors_of).collect();
    }

    pub(crate) fn write(&self, out: &mut dyn Write) -> Result<()> {
        row(out, "mass", &format!("{} kg, from {} kg", short(self.mass_kg), short(self.mass_before_kg)))?;
        for (i, measured) in self.measured.iter().enumerate() {
            let pairs: Vec<String> = measured
                .pairs
                .iter()
                .map(|pair| {
                    let [a, b] = &pair.markers;
                    format!("{a}–{b} {} mm for {}", short(pair.seen_m * 1e3), short(pair.model_m * 1e3))
                })
                .collect();
            let words = format!("{}: ×{:.4} ({})", measured.name, measured.factor, some(&pairs));
            row(out, if i == 0 { "measured" } else { "" }, &words)?;
        }
        if let Some(fitted) = &self.fitted {
            fitted.write(out)?;
        }
        if let Some(placed) = &self.placed {
            placed.write(out)?;
        }
        for (i, note) in self.notes.iter().enumerate() {
            row(out, if i == 0 { "look at" } else { "" }, note)?;
        }
        Ok(())
    }
}

impl Placed {
    fn write(&self, out: &mut dyn Write) -> Result<()> {
        let worst = match (&self.worst, self.worst_mm) {
            (Some(marker), Some(by)) => format!(", worst {marker} {} mm", short(by)),
            _ => String::new(),
        };
        let frames = counted(self.frames, "frame", "frames");
        row(out, "static pose", &format!("mean of {frames}: {} mm rms{worst}", short(self.rms_mm)))?;
        row(out, "markers", &format!("{} placed; farthest moved: {}", self.moved.len(), most(&self.moved)))?;
        if !self.lost.is_empty() {
            row(out, "", &format!("not in the trial, left away: {}", some(&self.lost)))?;
        }
        Ok(())
    }
}
